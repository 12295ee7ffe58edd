// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing borrowed refutes. A step that fails is refuted only by what it says itself and by what was said for
// its place. Where a definition of another section, a word of its sentence ("if", "for an acute angle") or a
// relation in a line is in between, it is undecided, and what it rests on is named.
//
// What is said elsewhere may help a proof: a relation that a line of prose brings in (`with $\beta = v/c$`)
// proves what it makes true.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/prose/prose.h"
#include "check/prose/said_around.h"
#include "check/verdict/judge.h"

namespace rigor {

/// A relation that the notes state, though nothing takes it for granted: in a line of prose, as a law, as a
/// condition next to an equation.
struct Fact {
  Equation equation;
  std::string text;     // as a verdict names it: `\beta = v/c (line 3)`
  bool proves = false;  // may a proof rest on it?
  std::size_t place = 0;
  Span span = {};
  bool elsewhere = false;   // in another section: it makes a refutation undecided if it proves the row
  bool at_instant = false;  // a condition: it may hold now only, so that it says nothing about its rates
};

/// `use (2.1), \mathbf{p}`: these definitions hold from there to the end of the section.
struct UseDirective {
  std::size_t directive = 0;
  std::size_t place = 0;
  std::vector<std::string> letters = {};  // bases of symbols
  std::vector<std::string> places = {};   // as an `Origin` ends: `(2.1)`, `in line 12`
};

/// Where a step stands, and what is said around it.
struct Standpoint {
  const Prose& prose;
  std::size_t event = 0;
  const std::vector<UseDirective>& uses;
  std::vector<Fact> facts;                 // that may bear on it
  std::string heading;                     // of its section, in small letters
  std::string unread;                      // a relation of its sentence that shares a letter and was not read
  std::optional<SaidAround> around = {};   // what sentences around it, or its tag, may restrict it by
  std::optional<std::string> denied = {};  // the word by which the page says that it does not hold
  std::vector<SymbolId> said_anew = {};    // defined, and given another meaning in a line since
  [[nodiscard]] const ProseBeside& beside() const { return prose.beside[event]; }
};

/// Does a `use` name this definition, or its symbol? Marks the directive as used.
[[nodiscard]] bool is_used_here(const Standpoint& at, const Names& names, const Origin& origin,
                                SymbolId symbol, std::set<std::size_t>& used);

/// Is an earlier definition said for this place, or is it borrowed from elsewhere?
[[nodiscard]] bool is_said_for(const Standpoint& at, const Origin& origin);

/// Is it meant for all values by its author's own words: `for all`, `claim`?
[[nodiscard]] bool is_meant_for_all(const ExprTree& tree, const Names& names, const Claim& claim);

/// The judgement of a step that is there: a proof with the help of what was said, or a refutation taken
/// back.
[[nodiscard]] Judgement heed_place(ExprTree& tree, const Names& names, const Claim& claim,
                                   Judgement judgement, const Standpoint& at, DecisionCache* cache);

/// The letter or the tag as `use` names it.
[[nodiscard]] std::string use_of(const Names& names, const ExprTree& tree, SymbolId symbol);

}  // namespace rigor
