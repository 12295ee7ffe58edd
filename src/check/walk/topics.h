// SPDX-License-Identifier: GPL-3.0-or-later
// What the walk does with its state, a file for each topic.
#pragma once

#include "check/walk/state.h"

namespace rigor {

// --- declare.cpp: Directives about symbols, axes and frames.

void take_declaration(Walk& walk, const Directive& directive);
/// A plain letter that would be the length of a vector is a number of its own where it is given a meaning.
void declare_for_now(Walk& walk, const Directive& directive, SyntaxId id);

// --- define.cpp: Definitions, rules for derivatives, and assumptions: what a row brings into scope.

bool defines(Walk& walk, const ParsedChain& parsed, const Side& left, const Side& right,
             const Context& context, Step& step);
Diagnostic changing_constant(Span span, const std::string& name);
/// Did another display say what the symbol on the left is, or another line for another case?
bool may_redefine(Walk& walk, const ParsedChain& parsed, const Typed& left, const Typed& right);
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

// --- cases.cpp: Which case holds at a row, and what is defined there.

/// What a row brought into scope for itself alone.
struct CaseInForce {
  std::vector<Equation> known = {};       // next to the row and in its sentence
  std::vector<Equation> conditions = {};  // of the case that it is
  std::vector<std::string> assumed = {};
  std::vector<SymbolId> defined = {};
  std::vector<SymbolId> at_border = {};  // of these, what is known without a neighbourhood
  SaidOfSymbols for_all = {};            // before it
  Sample sample = {};                    // the same
};

/// Before the row is read.
[[nodiscard]] CaseInForce enter_case(Walk& walk, const ParsedChain& parsed, const Context& context);
/// Behind that: what the row writes at values or differentiates is not defined after all.
void heed_other_places(Walk& walk, CaseInForce& in_force);
void leave_case(Walk& walk, CaseInForce in_force);
/// What the symbol is where the row holds. `name`: as a verdict names a definition.
void define_case(Walk& walk, const Definition& definition, const ParsedChain& parsed, std::string name);
/// What does not follow from the cases of a symbol above gives it new ones, or leaves it without.
bool renames_cases(Walk& walk, const Judgement& judgement, const ParsedChain& parsed, const Typed& left,
                   const Typed& right, Step& step);
/// Does the display say what the symbol is in another case?
[[nodiscard]] bool is_next_case(const Walk& walk, const ParsedChain& parsed, SymbolId symbol);

// --- chain.cpp: Reads the sides of a chain, then takes its steps one after the other. Sides are read
// together because they share their index letters.

void follow_chain(Walk& walk, const ParsedChain& parsed, const Context& context);
void report_unmet(Walk& walk, const Directive& expectation, Span statement);

// --- step.cpp: One relation of a chain, from what is written to its step in the report. First it is read:
// it brings something into scope, claims something, or cannot be decided. A claim is put to the exact side,
// whose answer may show that a name has another meaning here. Only then do the words around it bear on the
// verdict.

[[nodiscard]] Step new_step(const Walk& walk, const ParsedChain& parsed, std::size_t which,
                            const Context& context);
void add_step(Walk& walk, Step step);
/// `other`: its other reading, where a letter or a bracket is open. `asked` gets what the exact side was
/// asked; null where that is not wanted.
void take_step(Walk& walk, const ParsedChain& parsed, std::size_t which, ChainReading& reading,
               ChainReading* other, const Context& context, WrittenStep* asked);

}  // namespace rigor
