// SPDX-License-Identifier: GPL-3.0-or-later
// The dimension of an expression as a linear form in the unknown dimensions of its symbols, and the equations
// between dimensions that its sums, functions and tuples demand.
#pragma once

#include <functional>
#include <map>
#include <unordered_map>
#include <vector>

#include "expr/tree/dimension.h"
#include "expr/tree/tree.h"

namespace rigor {

/// The dimension of one symbol: a position in a list that the caller keeps.
using Unknown = std::uint32_t;

/// fixed + Σ factor · unknown. A written 0 has any dimension.
struct DimensionForm {
  std::map<Unknown, SmallRational> unknowns;  // no factor is 0
  Dimension fixed;
  bool any = false;

  [[nodiscard]] bool is_none() const { return unknowns.empty() && fixed.is_none(); }
  [[nodiscard]] bool is_valid() const;  // every exponent fits into its type
  void add(Unknown unknown, const SmallRational& factor);
  void add(const DimensionForm& other, const SmallRational& factor);
};

/// What has to have one dimension.
enum class Alike : std::uint8_t {
  sides,
  number,  // sides, one with numbers only: its unit can be left out
  terms,
  components,
  argument,
  known,
};

struct DimensionEquation {
  DimensionForm left;
  DimensionForm right;
  Span left_span;
  Span right_span;
  Alike alike = Alike::sides;
};

/// Adds `left = right`, unless it says nothing.
void demand(std::vector<DimensionEquation>& equations, DimensionEquation equation);

/// Reads expressions of one statement; each node once, however often it is reached. Recursion: as deep as the
/// tree, which the parser and the budget of derivatives bound.
class DimensionReader {
 public:
  using FormOf = std::function<DimensionForm(ExprId symbol)>;

  DimensionReader(const ExprTree& tree, FormOf form_of_symbol, std::vector<DimensionEquation>& equations)
      : tree_(tree), form_of_symbol_(std::move(form_of_symbol)), equations_(equations) {}

  DimensionForm read(ExprId id);
  /// A number for each row and each column of a determinant is an unknown of its own.
  using Fresh = std::function<Unknown()>;
  void set_fresh(Fresh fresh) { fresh_ = std::move(fresh); }

 private:
  DimensionForm compute(ExprId id);
  DimensionForm product(ExprId id);
  DimensionForm common(ExprId id, Alike alike);
  DimensionForm determinant(ExprId id);
  DimensionForm function(ExprId id);

  const ExprTree& tree_;
  FormOf form_of_symbol_;
  Fresh fresh_;
  std::vector<DimensionEquation>& equations_;
  std::unordered_map<std::uint32_t, DimensionForm> known_;
};

}  // namespace rigor
