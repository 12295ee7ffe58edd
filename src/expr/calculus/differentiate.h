// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives as trees. Sums, products, quotients, roots, lengths and functions differentiate by their rules;
// the derivative of a symbol is a further symbol, so that nothing above the exact side knows a derivative.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

/// How a symbol changes with what is differentiated by.
struct Dependence {
  enum class Kind : std::uint8_t {
    constant,
    varies,
    variable,  // is what is differentiated by: the time, the position, a coordinate
  };
  Kind kind = Kind::varies;
  std::uint8_t axis = 0;  // variable, a coordinate of space: which
  std::optional<ExprId> square =
      {};  // what defines the symbol by its square; its own derivative has a root below
};

/// What derivatives may cost, shared by those of one statement: each derivative of a product has as many
/// terms as factors, so that repeated ones grow without bound, and their axes make tensors of ever higher
/// rank.
struct DerivativeBudget {
  std::size_t nodes = 300'000;               // that may still be made, their children counted in
  std::optional<std::string> exceeded = {};  // why derivatives were given up: those at hand are not right
};

inline constexpr int most_rates = 32;                 // by the time, or by what is small
inline constexpr int most_axes = 6;                   // by coordinates
inline constexpr std::uint32_t most_terms = 100'000;  // weight of one derivative

/// d/dt, d/dε, or ∂/∂x_s with s the given slot (an axis, or an index variable that the caller binds). A
/// vector's or tensor's derivative has its rank; the axis of ∂ is not among its axes.
/// Recursion: as deep as the tree; that depth is bounded by the parser and by the budget.
class Differentiator {
 public:
  using DependenceOf = std::function<Dependence(SymbolId)>;
  /// Takes a symbol with its slots, gives its derivative, or nothing where that is zero.
  using SymbolRule = std::function<std::optional<ExprId>(ExprId)>;

  Differentiator(ExprTree& tree, const Variable& by, DependenceOf dependence_of, DerivativeBudget& budget,
                 Slot axis = {}, SymbolRule rule = {})
      : tree_(tree),
        by_(by),
        axis_(axis),
        dependence_of_(std::move(dependence_of)),
        rule_(std::move(rule)),
        budget_(budget) {}

  /// Nothing where it is zero, or where the budget is exceeded.
  [[nodiscard]] std::optional<ExprId> derivative(ExprId id);
  /// The same, with a written 0 of the right rank where it is zero.
  [[nodiscard]] ExprId derivative_or_zero(ExprId id);

 private:
  using Maybe = std::optional<ExprId>;

  Maybe compute(ExprId id);
  Maybe of_symbol(ExprId id);
  ExprId of_symbol_at(const ExprNode& node, SymbolId derivative, std::vector<Slot> slots);
  Maybe of_sum(ExprId id);
  Maybe of_product(ExprId id);
  Maybe of_quotient(ExprId id);
  Maybe of_power(ExprId id);
  Maybe of_power_of_operator(ExprId id);
  Maybe of_real_power(ExprId id);
  Maybe of_root(ExprId id);
  Maybe of_length(ExprId id);
  Maybe of_function(ExprId id);
  Maybe of_entries(ExprId id);      // tuple, table
  Maybe of_determinant(ExprId id);  // row by row
  Maybe of_linear(ExprId id);       // one child, linear
  Maybe of_part(ExprId id);         // conjugate, real_part, imaginary_part

  [[nodiscard]] ExprId child(ExprId id, std::size_t which = 0) const { return tree_.children(id)[which]; }
  void spend(std::size_t children);
  void give_up(std::string why) { budget_.exceeded = std::move(why); }
  bool refuses_complex_variable();
  [[nodiscard]] bool gave_up() const { return budget_.exceeded.has_value(); }
  ExprId copy(ExprId like, std::vector<ExprId> children);
  ExprId make(Op op, std::uint8_t rank, std::vector<ExprId> children, std::int32_t exponent = 0);
  ExprId number(const char* digits) { return tree_.add_number(span_, digits); }
  ExprId applied(Function function, ExprId argument);
  ExprId scaled(ExprId scalar, ExprId value);

  ExprTree& tree_;
  Variable by_;
  Slot axis_;
  DependenceOf dependence_of_;
  SymbolRule rule_;  // instead of what it depends on
  DerivativeBudget& budget_;
  Span span_ = {};  // of the node at hand, for what is made of it
  std::unordered_map<std::uint32_t, Maybe> known_;
};

/// The expression with some of its symbols (each with its slots and particle) replaced by what `by` gives for
/// the node; nothing leaves it. Recursion: as deep as the tree.
[[nodiscard]] ExprId replaced(ExprTree& tree, ExprId root,
                              const std::function<std::optional<ExprId>(ExprId symbol)>& by);

/// A component of a vector or tensor expression, taken from a tuple or a symbol where it stands open.
[[nodiscard]] ExprId component_of(ExprTree& tree, ExprId id, std::span<const Slot> slots);

/// The written 0 of a rank.
[[nodiscard]] ExprId zero_of_rank(ExprTree& tree, Span span, int rank, AxisSpaces axes = {});
/// A number at every place of a value.
[[nodiscard]] ExprId filled(ExprTree& tree, ExprId number, int rank, AxisSpaces axes);

}  // namespace rigor
