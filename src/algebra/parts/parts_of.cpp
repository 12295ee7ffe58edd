// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/parts/parts_of.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "algebra/engine/undecidable.h"
#include "expr/calculus/differentiate.h"
#include "expr/tree/same_expression.h"

namespace rigor {

ComplexParts PartsReader::of(ExprId id) {
  const auto key = static_cast<std::uint32_t>(id);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const Span before = std::exchange(span_, tree_[id].span);
  const ComplexParts parts = compute(id);
  span_ = before;
  known_.emplace(key, parts);
  return parts;
}

ComplexParts PartsReader::compute(ExprId id) {
  const ExprNode here = tree_[id];
  const std::vector<ExprId> below = children(id);
  bool real = here.op != Op::imaginary_unit && here.op != Op::conjugate && here.op != Op::real_part &&
              here.op != Op::imaginary_part && here.op != Op::symbol;
  for (const ExprId each : below) {
    const ComplexParts parts = of(each);
    real = real && parts.re == each && !parts.im;
  }
  if (here.op == Op::root && tree_[below[0]].op == Op::negate &&
      tree_[tree_.children(below[0])[0]].op == Op::number)  // √−4 is 2i
    return {{}, copied(id, children(below[0]))};
  if (real) return {id, {}};
  const auto first = [&] { return of(below[0]); };
  const auto each_part = [&](const ComplexParts& of_child) {
    const auto part = [&](Maybe at) { return at ? Maybe(copied(id, {*at})) : std::nullopt; };
    return ComplexParts{part(of_child.re), part(of_child.im)};
  };
  switch (here.op) {
    case Op::symbol:
      return of_symbol(id);
    case Op::imaginary_unit:
      return {{}, number("1")};
    case Op::conjugate:
      return conjugate(first());
    case Op::real_part:
      return {first().re ? *first().re : make(Op::multiply, {number("0"), *first().im}), {}};
    case Op::imaginary_part:
      return {first().im ? *first().im : make(Op::multiply, {number("0"), *first().re}), {}};
    case Op::add:
      return of_sum(id);
    case Op::negate:
    case Op::component:
    case Op::index_sum:
    case Op::particle_sum:
      return each_part(first());
    case Op::multiply:
      return of_product(id);
    case Op::divide:
      return quotient(first(), of(below[1]));
    case Op::power:
      return of_power(id);
    case Op::dot:
      return of_dot(id);
    case Op::cross:
      return times(Op::cross, first(), of(below[1]));
    case Op::length:
    case Op::absolute:
      return of_modulus(id);
    case Op::root:
      if (first().im) throw Undecidable("a root is taken of a number that may not be real");
      return {copied(id, {*first().re}), {}};
    case Op::function:
      return of_function(id);
    case Op::tuple:
    case Op::table:
      return of_entries(id);
    case Op::determinant:
      return of_determinant(id);
    default:
      throw Undecidable("an operation on complex numbers is not decided");
  }
}

/// The parts of a whole vector are its rows: e_1·Z and e_2·Z.
ComplexParts PartsReader::of_symbol(ExprId id) {
  const ExprNode here = tree_[id];
  if (!in_parts_[static_cast<std::size_t>(here.symbol)]) return {id, {}};
  const Symbol& symbol = tree_.symbols[here.symbol];
  const auto part = [&](std::uint8_t which) {
    std::vector<Slot> slots{{which, {}}};
    slots.insert(slots.end(), tree_.slots(id).begin(), tree_.slots(id).end());
    ExprNode node = here;
    node.rank = 0;
    if (static_cast<int>(slots.size()) == symbol.rank) return tree_.add(node, {}, slots);
    node.rank = static_cast<std::uint8_t>(symbol.rank);
    const ExprId whole = tree_.add(node);
    const ExprId row =
        tree_.add({.op = Op::basis, .rank = 1, .span = span_, .axes = AxisSpaces::of(space_of_parts, 1)}, {},
                  std::span(slots).first(1));
    return make(Op::dot, {row, whole});
  };
  const ExprId re = part(1);
  return {re, part(2)};
}

ComplexParts PartsReader::of_sum(ExprId id) {
  std::vector<ExprId> re;
  std::vector<ExprId> im;
  for (const ExprId each : children(id)) {
    const ComplexParts parts = of(each);
    if (parts.re) re.push_back(*parts.re);
    if (parts.im) im.push_back(*parts.im);
  }
  const auto joined = [&](const std::vector<ExprId>& terms) {
    return terms.size() > 1 ? Maybe(make(Op::add, terms)) : terms.empty() ? std::nullopt : Maybe(terms[0]);
  };
  return {joined(re), joined(im)};
}

/// Real scalars stay factors of both parts, side by side with the ε and δ among them. A factor and its
/// conjugate make a real number.
ComplexParts PartsReader::of_product(ExprId id) {
  std::vector<ExprId> real;
  std::vector<ComplexParts> scalars;
  std::vector<ComplexParts> others;  // whose order counts
  for (const ExprId each : children(id)) {
    const ComplexParts parts = of(each);
    if (tree_[each].rank > 0) {
      others.push_back(parts);
    } else if (!parts.im) {
      real.push_back(*parts.re);
    } else {
      scalars.push_back(parts);
    }
  }
  for (std::size_t k = 0; k < scalars.size(); ++k) {
    for (std::size_t j = k + 1; j < scalars.size(); ++j) {
      if (!are_conjugates(scalars[k], scalars[j])) continue;
      real.push_back(norm(scalars[k]));
      scalars.erase(scalars.begin() + static_cast<std::ptrdiff_t>(j));
      scalars.erase(scalars.begin() + static_cast<std::ptrdiff_t>(k--));
      break;
    }
  }
  scalars.insert(scalars.end(), others.begin(), others.end());
  if (scalars.empty()) return {make(Op::multiply, real), {}};
  const ComplexParts rest = product(scalars);
  if (real.empty()) return rest;
  const auto with_real = [&](Maybe part) {
    if (!part) return part;
    std::vector<ExprId> factors = real;
    const bool is_one = tree_[*part].op == Op::number && tree_.digits(*part) == "1";
    if (!is_one) factors.push_back(*part);
    if (factors.size() == 1) return Maybe(factors[0]);
    return Maybe(make(Op::multiply, std::move(factors)));
  };
  return {with_real(rest.re), with_real(rest.im)};
}

ComplexParts PartsReader::of_dot(ExprId id) {
  const ComplexParts a = of(children(id)[0]);
  const ComplexParts b = of(children(id)[1]);
  const bool vectors = tree_[children(id)[0]].rank == 1 && tree_[children(id)[1]].rank == 1;
  if (vectors && are_conjugates(a, b)) return {norm(a), {}};
  return times(Op::dot, a, b);
}

/// An even power of a modulus needs no root: |z|^4 = (z*z)².
ComplexParts PartsReader::of_power(ExprId id) {
  const ExprId base = children(id)[0];
  const int exponent = tree_[id].exponent;
  if (exponent % 2 == 0 && (tree_[base].op == Op::absolute || tree_[base].op == Op::length)) {
    const ComplexParts inside = of(children(base)[0]);
    if (inside.im) return power({norm(inside), {}}, exponent / 2);
  }
  return power(of(base), exponent);
}

/// Σ over cyclic (i, j, k) of a_1i (a_2j a_3k − a_2k a_3j).
ComplexParts PartsReader::of_determinant(ExprId id) {
  std::array<ComplexParts, 9> entry;
  for (std::size_t i = 0; i < 9; ++i) entry[i] = of(children(id)[i]);
  std::optional<ComplexParts> total;
  const auto add_term = [&](std::size_t i, std::size_t j, std::size_t k, bool odd) {
    const ComplexParts term = product(std::array{entry[i], entry[3 + j], entry[6 + k]});
    const ComplexParts signed_term = odd ? ComplexParts{negated(term.re), negated(term.im)} : term;
    total = total ? sum(*total, signed_term) : signed_term;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    add_term(i, (i + 1) % 3, (i + 2) % 3, false);
    add_term(i, (i + 2) % 3, (i + 1) % 3, true);
  }
  return *total;
}

/// exp(a + ib) = e^a (cos b + i sin b), sin(a + ib) = sin a cosh b + i cos a sinh b,
/// cos(a + ib) = cos a cosh b − i sin a sinh b.
ComplexParts PartsReader::of_function(ExprId id) {
  const Function function = tree_[id].function;
  const ComplexParts argument = of(children(id)[0]);
  if (!argument.im) return {copied(id, {*argument.re}), {}};
  const ExprId b = *argument.im;
  if (function == Function::exp) {
    const ExprId cosine = applied(Function::cos, b);
    const ExprId sine = applied(Function::sin, b);
    if (!argument.re) return {cosine, sine};
    const ExprId modulus = applied(Function::exp, *argument.re);
    return {make(Op::multiply, {modulus, cosine}), make(Op::multiply, {modulus, sine})};
  }
  const bool sine = function == Function::sin;
  if (!sine && function != Function::cos)
    throw Undecidable("of complex numbers only exp, sin and cos are decided");
  if (!argument.re)
    return sine ? ComplexParts{{}, hyperbolic(b, true)} : ComplexParts{hyperbolic(b, false), {}};
  const ExprId even = applied(function, *argument.re);
  const ExprId odd = applied(sine ? Function::cos : Function::sin, *argument.re);
  const ExprId im = make(Op::multiply, {odd, hyperbolic(b, true)});
  return {make(Op::multiply, {even, hyperbolic(b, false)}), sine ? Maybe(im) : negated(im)};
}

ComplexParts PartsReader::of_modulus(ExprId id) {
  const ExprId inside = children(id)[0];
  const ComplexParts parts = of(inside);
  if (!parts.im) return {copied(id, {*parts.re}), {}};
  return {modulus(inside), {}};
}

/// |ab| = |a||b|, |e^{a + ib}| = e^a, and so on, so that few roots are taken. Recursion: as deep as the tree.
ExprId PartsReader::modulus(ExprId id) {
  const ExprNode here = tree_[id];
  const ComplexParts parts = of(id);
  const Op bars = here.rank > 0 ? Op::length : Op::absolute;
  if (!parts.im) return make(bars, {*parts.re});
  if (here.op == Op::imaginary_unit) return number("1");
  if (here.op == Op::negate || here.op == Op::conjugate) return modulus(children(id)[0]);
  const bool scalar = here.rank == 0;
  if (scalar && here.op == Op::power) return make(Op::power, {modulus(children(id)[0])}, here.exponent);
  if (scalar && (here.op == Op::multiply || here.op == Op::divide)) {
    std::vector<ExprId> moduli;
    for (const ExprId each : children(id)) moduli.push_back(modulus(each));
    return make(here.op, moduli);
  }
  if (here.op == Op::function && here.function == Function::exp) {
    const ComplexParts argument = of(children(id)[0]);
    return argument.re ? applied(Function::exp, *argument.re) : number("1");
  }
  if (!parts.re) return make(bars, {*parts.im});
  return make(Op::root, {norm(parts)});
}

ComplexParts PartsReader::of_entries(ExprId id) {
  const ExprNode here = tree_[id];
  const std::vector<ExprId> entries = children(id);
  bool any[2] = {false, false};
  for (const ExprId each : entries) {
    any[0] = any[0] || of(each).re.has_value();
    any[1] = any[1] || of(each).im.has_value();
  }
  const auto part = [&](bool imaginary) -> Maybe {
    if (!any[imaginary ? 1 : 0]) return std::nullopt;
    std::vector<ExprId> own;
    for (const ExprId each : entries) {
      const Maybe at = imaginary ? of(each).im : of(each).re;
      own.push_back(at ? *at : zero_of_rank(tree_, span_, tree_[each].rank, tree_[each].axes));
    }
    if (here.op == Op::tuple) return copied(id, own);
    const std::vector<Slot> slots(tree_.slots(id).begin(), tree_.slots(id).end());
    return tree_.add_table(span_, own, slots, Table(tree_.table(id)));
  };
  const Maybe re = part(false);
  return {re, part(true)};
}

// --- arithmetic

ComplexParts PartsReader::sum(const ComplexParts& a, const ComplexParts& b) {
  return {added(a.re, b.re), added(a.im, b.im)};
}

ComplexParts PartsReader::turned(const ComplexParts& a) { return {negated(a.im), a.re}; }

ComplexParts PartsReader::times(Op op, const ComplexParts& a, const ComplexParts& b) {
  const auto is_i = [&](const ComplexParts& parts) {
    return op == Op::multiply && !parts.re && tree_[*parts.im].op == Op::number &&
           tree_.digits(*parts.im) == "1";
  };
  if (is_i(a)) return turned(b);
  if (is_i(b)) return turned(a);
  const Maybe minus = negated(joined(op, a.im, b.im));
  return {added(joined(op, a.re, b.re), minus), added(joined(op, a.re, b.im), joined(op, a.im, b.re))};
}

ComplexParts PartsReader::product(std::span<const ComplexParts> factors) {
  if (factors.size() == 1) return factors[0];
  const std::size_t half = factors.size() / 2;
  return times(Op::multiply, product(factors.first(half)), product(factors.subspan(half)));
}

ComplexParts PartsReader::power(const ComplexParts& base, int exponent) {
  if (std::abs(static_cast<long>(exponent)) > largest_exponent)
    throw Undecidable(fmt::format("the exponent {} is beyond ±{}", exponent, largest_exponent));
  if (!base.im) return {make(Op::power, {*base.re}, exponent), {}};
  if (exponent < 0) return quotient({number("1"), {}}, power(base, -exponent));
  if (exponent == 0) return {make(Op::power, {norm(base)}, 0), {}};
  if (exponent == 1) return base;
  if (!base.re) {  // (ib)^n = i^n b^n
    const ExprId raised = make(Op::power, {*base.im}, exponent);
    const Maybe part = exponent % 4 < 2 ? Maybe(raised) : negated(raised);
    return exponent % 2 == 0 ? ComplexParts{part, {}} : ComplexParts{{}, part};
  }
  if (exponent % 2 != 0) return times(Op::multiply, power(base, exponent - 1), base);
  const ComplexParts root = power(base, exponent / 2);
  if (!root.re || !root.im) return times(Op::multiply, root, root);
  const Maybe minus = negated(make(Op::power, {*root.im}, 2));
  return {added(make(Op::power, {*root.re}, 2), minus),
          make(Op::multiply, {number("2"), *root.re, *root.im})};
}

/// a/b = a b*/(b*b)
ComplexParts PartsReader::quotient(const ComplexParts& a, const ComplexParts& b) {
  const auto over = [&](const ComplexParts& above, ExprId below) {
    const auto part = [&](Maybe at) { return at ? Maybe(make(Op::divide, {*at, below})) : std::nullopt; };
    const Maybe re = part(above.re);
    return ComplexParts{re, part(above.im)};
  };
  if (!b.im) return over(a, *b.re);
  if (!b.re) return over({a.im, negated(a.re)}, *b.im);
  // The scalar comes first, as in `times` of a scalar and a vector.
  return over(times(Op::multiply, conjugate(b), a), norm(b));
}

bool PartsReader::are_conjugates(const ComplexParts& a, const ComplexParts& b) const {
  if (!a.re || !b.re || !a.im || !b.im || !same_expression(tree_, *a.re, tree_, *b.re)) return false;
  const auto is_minus = [&](ExprId x, ExprId y) {
    return tree_[x].op == Op::negate && same_expression(tree_, tree_.children(x)[0], tree_, y);
  };
  return is_minus(*a.im, *b.im) || is_minus(*b.im, *a.im);
}

ExprId PartsReader::norm(const ComplexParts& a) {
  const auto square = [&](Maybe part) {
    if (!part) return part;
    return Maybe(tree_[*part].rank > 0 ? make(Op::dot, {*part, *part}) : make(Op::power, {*part}, 2));
  };
  const Maybe first = square(a.re);
  return *added(first, square(a.im));
}

ExprId PartsReader::pair(const ComplexParts& parts) {
  const ExprNode like = tree_[parts.re ? *parts.re : *parts.im];
  const auto or_zero = [&](Maybe part) {
    return part ? *part : zero_of_rank(tree_, like.span, like.rank, like.axes);
  };
  const std::array entries{or_zero(parts.re), or_zero(parts.im)};
  return tree_.add({.op = Op::tuple,
                    .rank = static_cast<std::uint8_t>(like.rank + 1),
                    .span = like.span,
                    .axes = AxisSpaces::of(space_of_parts, 1)},
                   entries);
}

ExprId PartsReader::distance_squared(const ComplexParts& a, const ComplexParts& b) {
  return norm(sum(a, {negated(b.re), negated(b.im)}));
}

// --- nodes

PartsReader::Maybe PartsReader::added(Maybe a, Maybe b) {
  if (!a || !b) return a ? a : b;
  return make(Op::add, {*a, *b});
}

PartsReader::Maybe PartsReader::negated(Maybe a) {
  if (!a) return a;
  if (tree_[*a].op == Op::negate) return children(*a)[0];
  return make(Op::negate, {*a});
}

PartsReader::Maybe PartsReader::joined(Op op, Maybe a, Maybe b) {
  if (!a || !b) return std::nullopt;
  return make(op, {*a, *b});
}

ExprId PartsReader::make(Op op, std::vector<ExprId> children, std::int32_t exponent) {
  int rank = tree_[children[0]].rank;
  if (op == Op::length) rank = 0;
  if (op == Op::multiply || op == Op::dot) {
    for (std::size_t k = 1; k < children.size(); ++k) rank += tree_[children[k]].rank;
    if (op == Op::dot) rank -= 2;
  }
  return tree_.add({.op = op, .rank = static_cast<std::uint8_t>(rank), .span = span_, .exponent = exponent},
                   children);
}

ExprId PartsReader::applied(Function function, ExprId to) {
  return tree_.add({.op = Op::function, .span = span_, .function = function}, std::span(&to, 1));
}

/// (e^x ∓ e^−x)/2
ExprId PartsReader::hyperbolic(ExprId x, bool odd) {
  const ExprId back = applied(Function::exp, *negated(x));
  const ExprId both = make(Op::add, {applied(Function::exp, x), odd ? *negated(back) : back});
  return make(Op::divide, {both, number("2")});
}

/// The node with other children; one with slots keeps them.
ExprId PartsReader::copied(ExprId like, std::vector<ExprId> children) {
  const ExprNode node = tree_[like];
  const std::vector<Slot> slots(tree_.slots(like).begin(), tree_.slots(like).end());
  return tree_.add(node, children, slots);
}

}  // namespace rigor
