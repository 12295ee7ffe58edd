// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/frame.h"

#include <fmt/format.h>

#include <array>
#include <vector>

namespace rigor {
namespace {

/// Builds the definitions behind a frame.
class FrameBuilder {
 public:
  FrameBuilder(ExprTree& tree, Names& names, std::string rotating, std::size_t directive, Span span)
      : tree_(tree), names_(names), rotating_(std::move(rotating)), directive_(directive), span_(span) {}

  SymbolId rotation(ExprId angular_velocity) {
    for (std::size_t k = 0; k < 4; ++k) {
      q_[k] = tree_.symbols.add({.name = fmt::format("q_{}", k), .declared = true});
      define(q_[k], tree_.add_number(span_, k == 0 ? "1" : "0"));
    }
    for (std::size_t k = 0; k < 4; ++k)
      define(tree_.symbols.derivative(q_[k], By::time), rate(k, angular_velocity));
    Symbol symbol{.name = fmt::format("R_{{\\text{{{}}}}}", rotating_), .rank = 2, .declared = true};
    const SymbolId rotation = tree_.symbols.add(std::move(symbol));
    define(rotation, matrix());
    return rotation;
  }

 private:
  void define(SymbolId symbol, ExprId body) {
    names_.define({{symbol, {}, no_particle, body}, {fmt::format("frame {}", rotating_), "", directive_}, 0});
  }

  ExprId q(std::size_t k) { return tree_.add({.op = Op::symbol, .span = span_, .symbol = q_[k]}); }
  ExprId product(std::vector<ExprId> factors) {
    return tree_.add({.op = Op::multiply, .span = span_}, factors);
  }
  ExprId sum(std::vector<ExprId> terms) { return tree_.add({.op = Op::add, .span = span_}, terms); }
  ExprId minus(ExprId term) { return tree_.add({.op = Op::negate, .span = span_}, std::span(&term, 1)); }
  ExprId number(const char* digits) { return tree_.add_number(span_, digits); }
  ExprId over(ExprId above, ExprId below) {
    const std::array parts{above, below};
    return tree_.add({.op = Op::divide, .span = span_}, parts);
  }
  ExprId velocity(ExprId vector, std::size_t axis) {
    const Slot slot{static_cast<std::uint8_t>(axis), {}};
    return component_of(tree_, vector, std::span(&slot, 1));
  }

  /// q' = q ω/2: q_0' = −q·ω/2 and q_i' = (q_0 ω_i + q_j ω_k − q_k ω_j)/2 for cyclic (i, j, k).
  ExprId rate(std::size_t i, ExprId w) {
    if (i == 0) {
      std::vector<ExprId> terms;
      for (std::size_t k = 1; k <= 3; ++k) terms.push_back(product({q(k), velocity(w, k)}));
      return minus(over(sum(terms), number("2")));
    }
    const std::size_t j = i % 3 + 1;
    const std::size_t k = j % 3 + 1;
    const ExprId twice = sum({product({q(0), velocity(w, i)}), product({q(j), velocity(w, k)}),
                              minus(product({q(k), velocity(w, j)}))});
    return over(twice, number("2"));
  }

  ExprId matrix() {
    std::vector<ExprId> rows;
    for (std::size_t i = 1; i <= 3; ++i) {
      std::vector<ExprId> row;
      for (std::size_t j = 1; j <= 3; ++j) row.push_back(over(entry(i, j), squares(1)));
      rows.push_back(tree_.add({.op = Op::tuple, .rank = 1, .span = span_}, row));
    }
    return tree_.add({.op = Op::tuple, .rank = 2, .span = span_}, rows);
  }

  /// q_0² ± q·q
  ExprId squares(int sign) {
    std::vector<ExprId> terms;
    for (std::size_t k = 0; k < 4; ++k) {
      const ExprId square = product({q(k), q(k)});
      terms.push_back(k > 0 && sign < 0 ? minus(square) : square);
    }
    return sum(terms);
  }

  ExprId entry(std::size_t i, std::size_t j) {
    const ExprId symmetric = product({number("2"), q(i), q(j)});
    if (i == j) return sum({squares(-1), symmetric});
    const std::size_t k = 6 - i - j;
    const ExprId skew = product({number("2"), q(0), q(k)});
    const bool cyclic = i % 3 + 1 == j;  // ε_ijk = 1
    return sum({symmetric, cyclic ? minus(skew) : skew});
  }

  ExprTree& tree_;
  Names& names_;
  std::string rotating_;
  std::size_t directive_;
  Span span_;
  std::array<SymbolId, 4> q_{};
};

}  // namespace

void declare_frame(ExprTree& tree, Names& names, const std::string& rotating, const std::string& fixed,
                   ExprId angular_velocity, std::size_t directive) {
  FrameBuilder builder(tree, names, rotating, directive, tree[angular_velocity].span);
  names.declare_frame({rotating, fixed, builder.rotation(angular_velocity), directive, 0});
}

}  // namespace rigor
