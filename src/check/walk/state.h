// SPDX-License-Identifier: GPL-3.0-or-later
// What the walk through one file's notes knows at a place. This file only stores state; each topic (chains,
// declarations, definitions, steps) is a file of free functions.
#pragma once

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/among.h"
#include "check/event/notes.h"
#include "check/ledger/ledger.h"
#include "check/place/place.h"

namespace rigor {

/// What the walk is asked to do.
struct WalkRequest {
  bool explains = false;  // what the exact side was asked is kept in the ledger
  bool reads = false;     // all chains are read, and nothing is decided but as with `only`
  /// Only these chains are read, and nothing is decided but whether a name gets a second meaning. Nothing:
  /// all chains are decided.
  std::optional<std::set<const ParsedChain*>> only = {};
};

/// How a chain is followed.
struct Context {
  Role role = Role::display;
  bool first_order = false;        // `=` means ≈
  std::optional<Span> place = {};  // where steps are reported, if not where they stand
  std::size_t directive = 0;
};

/// Said for the next statement; forgotten when it is over, whatever became of it.
struct SaidForNext {
  std::vector<const Directive*> expectations;
  const Directive* skip = nullptr;
  const Directive* first_order = nullptr;
  std::vector<std::size_t> wheres;         // directives
  std::vector<const Directive*> in_force;  // expectations of the chain at hand
};

struct Walk {
  const SourceMap& sources;
  const Notes& notes;
  FileReport& report;
  const CheckOptions& options;
  WalkRequest request;

  Ledger ledger = {};
  ExprTree& tree = ledger.tree;
  Names names = {};
  Directives used = {};  // by what was read and decided so far
  std::string section = {};
  std::size_t event = 0;                                         // that is followed
  std::vector<std::pair<std::size_t, SymbolId>> constants = {};  // directive, symbol: constant, or a variable
  std::vector<std::pair<std::size_t, SymbolId>> for_all = {};    // the same
  Sample sample = {};  // the last one that met the assumptions in force
  SaidAbove above = {};
  std::size_t lines_taken = 0;  // of the relations in lines of prose
  SaidForNext next = {};
  std::optional<Diagnostic> unread_case = {};  // why the row at hand, one of several cases, is not decided
};

[[nodiscard]] inline bool decides(const Walk& walk) { return !walk.request.only && !walk.request.reads; }

inline void add_used(Walk& walk, const Directives& used) { walk.used.insert(used.begin(), used.end()); }

/// What holds here, for those that look at it later.
[[nodiscard]] inline std::shared_ptr<const Names> scope_here(const Walk& walk) {
  return std::make_shared<const Names>(walk.names);
}

/// Is the chain, or the one that it is a cyclic image of, expected to be refuted?
[[nodiscard]] inline bool expects_refuted(const Walk& walk, const ParsedChain& parsed) {
  const auto refuted = [](const Directive* each) { return each->expected == Verdict::refuted; };
  return std::ranges::any_of(walk.next.expectations, refuted) ||
         (parsed.image > 0 && std::ranges::any_of(walk.next.in_force, refuted));
}

/// Does a directive say that the chain is stated, and not concluded?
[[nodiscard]] inline bool expects_law(const Walk& walk) {
  return std::ranges::any_of(walk.next.expectations,
                             [](const Directive* each) { return each->expected == Verdict::law; });
}

/// What a decision found.
inline void take_over(Walk& walk, RowPlace::Found found) {
  add_used(walk, found.used);
  std::move(found.laws.begin(), found.laws.end(), std::back_inserter(walk.above.laws));
  std::move(found.stated.begin(), found.stated.end(), std::back_inserter(walk.above.stated));
  std::move(found.rounded.begin(), found.rounded.end(), std::back_inserter(walk.above.rounded));
}

/// Where the walk is, for a decision.
[[nodiscard]] inline RowPlace place_here(Walk& walk) {
  return {walk.sources, walk.notes, walk.options, walk.above,
          walk.tree,    walk.names, walk.section, walk.event};
}

/// Is this said by a `where`?
[[nodiscard]] inline bool is_for_now(const Walk& walk, const Context& context) {
  const bool directed = context.role == Role::let || context.role == Role::given;
  return directed && is_one_of(context.directive, walk.next.wheres);
}

}  // namespace rigor
