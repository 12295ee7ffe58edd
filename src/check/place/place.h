// SPDX-License-Identifier: GPL-3.0-or-later
// A place of the notes at which a row is decided: what holds there, and what is around it. Deciding brings
// nothing into scope: the names are a copy, so that no decision depends on one before it. What a decision
// relied on is part of its answer (`found`).
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "check/doubt/borrowed.h"
#include "check/event/notes.h"
#include "check/law/page_law.h"
#include "check/ledger/ledger.h"
#include "check/place/check_options.h"
#include "check/prose/other_case.h"
#include "check/verdict/chain_reading.h"
#include "check/verdict/judge.h"

namespace rigor {

using Side = ChainReading::Side;

/// A law, or a row that follows from laws, with what its letters meant.
struct StatedLaw {
  PageLaw law;
  std::vector<std::string> labels = {};      // its tag and its label
  std::vector<std::string> beginnings = {};  // its left side, and the first term of that
  std::vector<std::string> conditions = {};  // `r < R` next to it, as they are written
  bool of_a_section = false;                 // its heading is about a special case: "Electrostatics"
  CaseSaid of_case = {};                     // "In incompressible flow"
  std::optional<SymbolId> letter = {};       // F of `F = -kx`: what it says that the letter is
  std::vector<std::pair<SymbolId, ExprId>> meanings = {};  // of its letters that are defined
  bool poses = false;  // a line says it of a function: "We solve $y'' = y$ with $y(0) = 1$"
  /// In which a line says what a letter of the display before it is, "with $\gamma = …$".
  std::optional<std::size_t> explained_in = {};
};

/// `c \approx 343\,\mathrm{m/s}` of a display: what its letter is worth, and no law.
struct RoundedValue {
  SymbolId letter{};
  ExprId number{};
  std::string name;       // as a verdict names it
  std::size_t place = 0;  // its section
};

/// `f(x) = x^2` of `f(x) = \begin{cases} x^2 & x > 0 \\ … \end{cases}`: what f is where its conditions hold.
struct CaseDefinition {
  Definition definition;
  std::vector<Equation> conditions = {};
  std::string name;       // as a verdict names it
  std::size_t place = 0;  // its section
  std::size_t event = 0;  // and its display
};

/// A row that is not read, or that its words may restrict.
struct RowBefore {
  std::size_t paragraph = 0;
  Span span = {};
};

/// What rows and directives leave for the rows below them.
struct SaidAbove {
  std::vector<UseDirective> uses = {};
  std::vector<Fact> laws = {};         // and definitions after their first use
  std::vector<StatedLaw> stated = {};  // what rows below can follow from
  std::vector<RoundedValue> rounded = {};
  std::vector<CaseDefinition> cases = {};
  std::optional<RowBefore> open_row = {};                      // the last one, if it is such
  std::vector<std::pair<std::size_t, Span>> unread_rows = {};  // where, and what: relations such as `\perp`
};

struct RowPlace {
  const SourceMap& sources;
  const Notes& notes;
  const CheckOptions& options;
  const SaidAbove& above;
  ExprTree& tree;  // grows by what is read and asked
  Names names;
  std::string section;      // its title
  std::size_t event = 0;    // of the notes
  bool heeds_words = true;  // what stands around a row bears on its verdict: not where its author expects one
  bool is_stated = false;   // a directive says so of the row: it is no conclusion, and not suspected

  struct Found {
    Directives used = {};  // by what was read and decided
    std::vector<Fact> laws = {};
    std::vector<StatedLaw> stated = {};
    std::vector<RoundedValue> rounded = {};
  } found = {};
};

/// One relation of a chain, as it was read.
struct StepReading {
  const ParsedChain& parsed;
  std::size_t which = 0;  // of its relations
  ChainReading& reading;
  Role role = Role::display;
  bool first_order = false;          // `=` means ≈
  bool unsettled = false;            // a place of it can be read in two ways
  ChainReading* other = nullptr;     // where a letter or a bracket is open: see settle_in_both()
  RecordedStep* recorded = nullptr;  // of an earlier report
  WrittenStep* asked = nullptr;      // where what the exact side was asked is kept, if that is wanted

  [[nodiscard]] const WrittenRelation& relation() const { return parsed.written.relations[which]; }
  [[nodiscard]] const Side& left() const { return reading.sides[which]; }
  [[nodiscard]] const Side& right() const { return reading.sides[which + 1]; }
};

/// The chain as it is read here; the directives that were looked up count as used.
[[nodiscard]] std::unique_ptr<ChainReading> read_here(RowPlace& place, const ParsedChain& parsed);
/// Judged under what holds here; the directives that were needed count as used.
[[nodiscard]] Judgement judge_here(RowPlace& place, const Claim& claim);
inline void add_used(RowPlace& place, const Directives& used) {
  place.found.used.insert(used.begin(), used.end());
}

[[nodiscard]] inline const ProseBeside& beside(const RowPlace& place) {
  return place.notes.prose.beside[place.event];
}
/// On one line, blanks folded.
[[nodiscard]] std::string written_at(const SourceMap& sources, Span span);
[[nodiscard]] inline std::string written_at(const RowPlace& place, Span span) {
  return written_at(place.sources, span);
}
/// Its tag, or its line.
[[nodiscard]] std::string name_of_place(const SourceMap& sources, const ParsedChain& parsed);

}  // namespace rigor
