// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions, rules for derivatives, and assumptions: what a row brings into scope.
#pragma once

#include "check/walk/state.h"

namespace rigor {

bool defines(Walk& walk, const ParsedChain& parsed, const Side& left, const Side& right,
             const Context& context, Step& step);
Diagnostic changing_constant(Span span, const std::string& name);
/// Did another display say what the symbol on the left is?
bool may_redefine(Walk& walk, const Typed& left, const Typed& right);
/// An equation that disagrees with an earlier meaning gives a new one, with a warning. It stays a claim if it
/// is announced as a conclusion, if a `use` says that the earlier meaning holds, or if words may limit it to
/// a case. If its symbols differ from the earlier ones, it is a new meaning only in another section, else a
/// law.
bool redefines(Walk& walk, const Judgement& judgement, const ParsedChain& parsed, const Typed& left,
               const Typed& right, const Context& context, Step& step);
/// A part of a sum that is defined above follows from the whole.
bool takes_apart(Walk& walk, const ParsedChain& parsed, const Typed& left, const Typed& right,
                 const Context& context, Step& step);
void add_assumption(Walk& walk, const Typed& left, const Typed& right, const Equation& equation,
                    const ParsedChain& parsed, std::size_t which, const Context& context, Step& step);
/// Marks all assumptions as used: that they contradict each other is why nothing is decided.
void mark_all_given(Walk& walk);
bool is_in_doubt(const Walk& walk);
bool find_sample(Walk& walk);
Diagnostic no_sample(Span span);

}  // namespace rigor
