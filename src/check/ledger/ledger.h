// SPDX-License-Identifier: GPL-3.0-or-later
// The notes as they were read and decided, in their order. It separates the walk, which writes it, from
// lints, dimensions, repairs and forms, which read it when the walk is over. Each entry keeps the scope after
// it, so that nothing later in the notes changes what they find; scopes are shared and cost a few pointers.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "check/event/notes.h"
#include "elaborate/name/names.h"
#include "elaborate/reading/reading.h"
#include "elaborate/reading/typed.h"
#include "expr/statement/written_forms.h"
#include "expr/tree/tree.h"

namespace rigor {

/// How a statement comes into the notes: as a claim of theirs, or by a directive.
enum class Role : std::uint8_t { display, claim, given, let };

[[nodiscard]] inline bool is_claimed(Role role) { return role == Role::display || role == Role::claim; }

/// What the reading of a chain needed besides its signs.
struct HowRead {
  std::vector<std::string> conventions = {};            // "`A` is the length of `\mathbf{A}`"
  std::set<std::string> summed = {};                    // letters that stand twice in a term
  std::optional<Obstacle> open = {};                    // what can be read in another way
  bool is_stated = false;                               // `law next`
  std::vector<std::optional<Equation>> equations = {};  // of each relation, if it is wanted
};

/// One chain, and the steps that were made of it.
struct Statement {
  const ParsedChain* chain = nullptr;  // as it is read: of the notes, or of the ledger
  std::size_t event = 0;               // of the notes
  Role role = Role::display;
  bool first_order = false;  // `=` means ≈
  bool for_now = false;      // said by a `where`: for the next statement only
  bool guessed = false;      // how its letters are read is only a guess
  ReadingRules rules = {};   // by which it was read
  HowRead how = {};          // if that is wanted
  std::vector<std::optional<Typed>> sides = {};
  std::size_t first_step = 0;  // in the report
  std::size_t step_count = 0;
  std::vector<WrittenStep> asked = {};  // of each relation, if it is wanted: what the exact side was asked

  /// Has it one reading?
  [[nodiscard]] bool is_settled() const { return chain->others.empty(); }
};

/// `units`, of one symbol.
struct UnitLine {
  ExprId symbol{};
  Dimension dimension;
  Span span;
  std::size_t directive = 0;
};

/// `frame … rotates with …`
struct FrameLine {
  ExprId angular_velocity{};
};

struct SectionBegins {};

/// What was said for one statement ends here.
struct StatementEnds {};

struct LedgerEntry {
  std::shared_ptr<const Names> scope;  // after it
  std::variant<Statement, UnitLine, FrameLine, SectionBegins, StatementEnds> what;
};

struct Ledger {
  ExprTree tree;
  std::vector<LedgerEntry> entries;
  std::vector<std::shared_ptr<const Names>> behind_events;  // the scope after each event, if that is wanted
  std::shared_ptr<const Names> end;                         // and where the notes end
  std::deque<ParsedChain> chains;           // those that are not of the notes: with fewer readings
  Directives used;                          // by what was read and decided
  std::map<SymbolId, bool> mirrored;        // declared polar (true) or axial
  std::vector<const Directive*> unmatched;  // no statement came before the end of their section
  std::size_t passed_over = 0;              // chains that are not needed
};

}  // namespace rigor
