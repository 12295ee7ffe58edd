// SPDX-License-Identifier: GPL-3.0-or-later
// What the statements of one file say of dimensions, collected on the walk through the notes. `dimensions.h`
// solves it when all verdicts are known.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "check/dimension/dimension_form.h"
#include "elaborate/name/names.h"

namespace rigor {

/// How a statement entered.
enum class DimensionSource : std::uint8_t {
  law,    // a display, or by `let` or `given`: what it says of dimensions holds for the whole file
  local,  // by `where` or `claim`: its letters can mean something else elsewhere
};

struct DimensionStatement {
  std::size_t step = 0;  // in the report
  DimensionSource source = DimensionSource::law;
  Span span;                                 // of both sides, where they are written
  std::vector<DimensionEquation> equations;  // the last one compares the sides, if they are compared
  std::vector<std::size_t> assumed = {};     // the statements of the `where`s in force
};

/// One line of `units`, for one symbol.
struct DeclaredUnit {
  DimensionForm symbol;
  Dimension dimension;
  Span span;
  std::size_t directive = 0;
};

/// Whose dimension an unknown is.
struct UnknownName {
  std::string text;     // LaTeX; empty: of no symbol
  bool listed = false;  // in the table of dimensions
};

struct DimensionRecord {
  std::vector<UnknownName> unknowns;
  std::vector<DeclaredUnit> units;
  std::vector<DimensionEquation> facts;  // that belong to no statement
  std::vector<DimensionStatement> statements;
};

inline constexpr Unknown time_unknown = 0;
inline constexpr Unknown space_unknown = 1;

class DimensionRecorder {
 public:
  DimensionRecorder(const ExprTree& tree, Names& names);

  /// One relation between two sides; without `compared`, what stands inside the sides only. `inner_left`:
  /// what stands inside the left side, too.
  struct Statement {
    std::size_t step = 0;
    ExprId left{};
    ExprId right{};
    Span left_span;
    Span right_span;
    bool compared = true;
    bool inner_left = true;
    DimensionSource source = DimensionSource::law;
  };
  void add(const Statement& statement);
  /// The next statements hold under what this one says, until `forget_assumed`.
  void assume_last() { assumed_.push_back(record_.statements.size() - 1); }
  void forget_assumed() { assumed_.clear(); }

  /// `units`: in another section than an earlier one, the symbol is taken for another quantity.
  void declare(ExprId symbol, const Dimension& dimension, Span span, std::size_t directive);
  /// `frame`: an angular velocity turns by so much a time.
  void declare_angular_velocity(ExprId symbol);
  /// Without `units` above it, letters of earlier sections are taken for other quantities.
  void enter_section();
  /// The symbol is now the name of another quantity.
  void renew(SymbolId symbol);

  [[nodiscard]] const DimensionRecord& record() const { return record_; }
  /// Is a declared symbol in a statement?
  [[nodiscard]] bool is_used(const DeclaredUnit& unit) const;

 private:
  struct Declared {
    Dimension dimension;
    std::size_t section = 0;
  };
  DimensionForm form_of(ExprId symbol, std::vector<DimensionEquation>& equations);
  Unknown unknown_of(SymbolId symbol);
  Unknown fresh(UnknownName name = {});
  DimensionReader reader(std::vector<DimensionEquation>& equations);
  void in_body(const ExprNode& node, std::vector<DimensionEquation>& equations);
  void relate_positions(const Statement& statement, std::vector<DimensionEquation>& equations);
  [[nodiscard]] bool is_pure_number(SymbolId base) const;
  bool is(SymbolId symbol, const NameKey& key) const { return names_.find(key) == symbol; }

  const ExprTree& tree_;
  Names& names_;
  DimensionRecord record_;
  std::map<SymbolId, Unknown> unknowns_;
  std::map<SymbolId, Declared> declared_;
  std::map<SymbolId, bool> body_definitions_;  // read already
  std::vector<std::size_t> assumed_;           // statements
  std::vector<bool> used_;                     // unknowns, in statements
  std::size_t section_ = 0;
};

}  // namespace rigor
