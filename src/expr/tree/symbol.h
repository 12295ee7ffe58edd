// SPDX-License-Identifier: GPL-3.0-or-later
// The names that a file's statements are about. A symbol is what a letter with its face, accent, primes and
// labels means: `\mathbf{r}_\alpha`, `r_{\alpha i}` and the length `r_\alpha` are one symbol (rank 1, one for
// each particle).
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "base/shared.h"
#include "base/span.h"
#include "expr/tree/dimension.h"
#include "expr/tree/space.h"

namespace rigor {

enum class SymbolId : std::uint32_t {};
enum class ExprId : std::uint32_t;

/// What is differentiated by.
enum class By : std::uint8_t {
  small,  // the parameter that all small quantities are proportional to
  space,  // a coordinate; one more axis of the derivative, after the others, says which
  time,
  letter,  // any other symbol
};

/// The variable of a derivative. That by a letter says which, and what does not change with it: nothing is
/// known of the others in `df/dx`; they are held in `\partial f/\partial x`, one of them by name in
/// `(\partial f/\partial x)_y`.
struct Variable {
  By by = By::time;
  SymbolId letter{};
  bool partial = false;
  std::optional<SymbolId> held = {};
  constexpr Variable() = default;
  constexpr Variable(By kind, SymbolId symbol = {}, bool holds = false, std::optional<SymbolId> which = {})
      : by(kind), letter(symbol), partial(holds), held(which) {}
  friend auto operator<=>(const Variable&, const Variable&) = default;
};

/// What is differentiated by, each as often as it is: a multiset in falling order.
class VariablesOfDerivation {
 public:
  using value_type = Variable;
  using const_iterator = std::vector<Variable>::const_iterator;

  VariablesOfDerivation() = default;
  VariablesOfDerivation(std::initializer_list<Variable> all) {
    for (const Variable& each : all) insert(each);
  }

  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] const_iterator begin() const { return all_.begin(); }
  [[nodiscard]] const_iterator end() const { return all_.end(); }
  [[nodiscard]] auto rbegin() const { return all_.rbegin(); }
  [[nodiscard]] auto rend() const { return all_.rend(); }
  [[nodiscard]] std::size_t count(const Variable& variable) const {
    return static_cast<std::size_t>(std::ranges::count(all_, variable));
  }
  void insert(const Variable& variable) {
    all_.insert(std::ranges::upper_bound(all_, variable, std::greater<>()), variable);
  }
  /// Once, where it is there.
  void erase(const Variable& variable) {
    if (const auto found = std::ranges::find(all_, variable); found != all_.end()) all_.erase(found);
  }
  friend auto operator<=>(const VariablesOfDerivation&, const VariablesOfDerivation&) = default;

 private:
  std::vector<Variable> all_;
};

/// A derivative is a symbol of its own, so that it is one more free quantity to the exact side. Derivatives
/// by letters are taken before those by the time; otherwise the order does not matter.
struct Derivation {
  using Variables = VariablesOfDerivation;
  SymbolId base{};
  Variables by = {};
  friend auto operator<=>(const Derivation&, const Derivation&) = default;
};

/// An end of an interval: an expression, or an infinity with its sign.
struct Limit {
  std::optional<ExprId> at = {};
  int infinity = 0;
};

/// `\int_a^b f\,dx`, or without limits a function whose derivative is f; or `\sum_{k=a}^b f` over whole
/// numbers; or `\langle f\rangle`, over all outcomes with weights of sum 1. It is a symbol of its own, and
/// its integrand stands in the same tree: what it is follows from these, so that a row about it defines
/// nothing.
struct Integral {
  ExprId integrand{};
  SymbolId variable{};
  Variable by = {};       // how the notes differentiate by the variable
  std::uint8_t axis = 0;  // by space: along which
  std::optional<Limit> lower = {};
  std::optional<Limit> upper = {};
  bool primitive = false;  // `[F]_a^b`: the integrand is F itself
  bool sum = false;      // over whole numbers, both limits among them; nothing is added where there are none
  bool average = false;  // over outcomes, or in a state; it has no limits, and its variable is not written
};

/// What is integrated, and the limits.
[[nodiscard]] inline std::vector<ExprId> parts_of(const Integral& integral) {
  std::vector<ExprId> parts{integral.integrand};
  for (const auto& limit : {integral.lower, integral.upper}) {
    if (limit && limit->at) parts.push_back(*limit->at);
  }
  return parts;
}

/// No order of a derivative goes beyond this; what notes may ask for is bounded in `Differentiator`.
inline constexpr int largest_derivation = 1000;

/// What has as many rows as a section likes: a matrix, one that the words say to be square or to have n×m
/// entries, or a column. `Ax` is a product in this order.
enum class Unsized : std::uint8_t { none, matrix, square, oblong, column };

/// One part of what is written in a ket: `n + 1`, `0`, `\uparrow`, `n^{(0)}`.
struct LabelPart {
  std::string letter;  // `n`; nothing for a number
  std::string mark;    // `^{(0)}`
  int number = 0;
  friend auto operator<=>(const LabelPart&, const LabelPart&) = default;
};

struct Symbol {
  std::string name;            // LaTeX without indices and particle label: `\mathbf{r}`, `T_{\text{rot}}`
  int rank = 0;                // 0 scalar, 1 vector, 2 and more tensor
  bool per_particle = false;   // has a value for each particle
  bool symmetric = false;      // rank 2: equal to its transpose
  bool unit = false;           // rank 1: length 1
  bool rotation = false;       // rank 2: orthogonal with determinant 1; the first axis is the rotated one
  bool complex = false;        // each component is a complex number; all others are real
  bool noncommuting = false;   // an operator, or a matrix of any size: products keep their order
  bool declared = false;       // a directive says what it is
  bool circle_number = false;  // π, unless it is defined
  std::optional<Dimension> unit_of_measure = {};  // of a unit such as the metre: positive, never changes
  Span first_seen = {};
  std::size_t made_at = 0;  // the size of the tree: no node before it is this symbol, or has it below
  std::optional<Derivation> derivation = {};  // of a derivative; the last axes, by space, can be exchanged
  AxisSpaces axes = {};                       // orthonormal
  Unsized unsized = Unsized::none;            // of rank 0 and noncommuting
  std::optional<Integral> integral = {};
  bool ket = false;                   // `|n\rangle`, or a derivative of one; noncommuting, and of rank 0
  std::vector<LabelPart> label = {};  // of a ket; m and n of `\delta_{mn}` where these number states

  /// A unit of measure or π: it has the one value that it has.
  [[nodiscard]] bool is_fixed() const { return unit_of_measure.has_value() || circle_number; }
  /// How often it is differentiated, by this or by anything.
  [[nodiscard]] int order(const Variable& by) const {
    return derivation ? static_cast<int>(derivation->by.count(by)) : 0;
  }
  [[nodiscard]] int order() const { return derivation ? static_cast<int>(derivation->by.size()) : 0; }
};

[[nodiscard]] inline std::size_t component_count(const Symbol& symbol) {
  return component_count(symbol.rank, symbol.axes);
}

/// Symmetric tensors and repeated derivatives have equal components: the first of those that equal this one,
/// row by row.
[[nodiscard]] std::size_t canonical_component(const Symbol& symbol, std::size_t component);

/// A reference to a symbol stays valid while others are added: preparing a question adds derivatives.
class SymbolTable {
 public:
  SymbolId add(Symbol symbol);
  [[nodiscard]] const Symbol& operator[](SymbolId id) const { return symbols_[static_cast<std::size_t>(id)]; }
  /// To be changed, which no copy of the table sees.
  [[nodiscard]] Symbol& write(SymbolId id) { return symbols_.write(static_cast<std::size_t>(id)); }
  [[nodiscard]] std::size_t size() const { return symbols_.size(); }

  /// The derivative of a symbol (which may be a derivative itself), always the same one. Symmetric if the
  /// symbol is; never a unit vector or a rotation.
  SymbolId derivative(SymbolId of, const Variable& by);
  SymbolId derivative(const Derivation& derivation);
  /// The derivative if it was made before.
  [[nodiscard]] std::optional<SymbolId> find(const Derivation& derivation) const;
  [[nodiscard]] bool has_derivatives(SymbolId base) const;

 private:
  SharedArray<Symbol> symbols_;
  SharedArray<std::vector<SymbolId>> derivatives_;  // of each symbol
};

/// The symbol that a derivative is of; any other symbol itself.
[[nodiscard]] inline SymbolId base_of(const SymbolTable& symbols, SymbolId symbol) {
  const auto& derivation = symbols[symbol].derivation;
  return derivation ? derivation->base : symbol;
}

}  // namespace rigor
