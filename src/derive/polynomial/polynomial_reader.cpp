// SPDX-License-Identifier: GPL-3.0-or-later
// From an expression to a sum of monomials.
#include <map>

#include "derive/polynomial/index_polynomial.h"

namespace rigor {
namespace {

/// Thrown where a polynomial becomes too large; caught by `polynomial_of`.
struct TooManyMonomials {};

IndexPolynomial constant(SmallRational value) {
  if (!value.is_valid()) throw TooManyMonomials{};
  if (value.is_zero()) return {};
  return {{IndexMonomial{.coefficient = value}}};
}

IndexPolynomial single(IndexFactor factor) { return {{IndexMonomial{.factors = {std::move(factor)}}}}; }

IndexPolynomial times(const IndexPolynomial& a, const IndexPolynomial& b) {
  auto result = product_of(a, b);
  if (!result) throw TooManyMonomials{};
  return *std::move(result);
}

IndexPolynomial plus(IndexPolynomial a, const IndexPolynomial& b) {
  a.terms.insert(a.terms.end(), b.terms.begin(), b.terms.end());
  if (a.terms.size() > most_monomials) throw TooManyMonomials{};
  return a;
}

/// `2.50` as 5/2.
SmallRational number(const std::string& digits) {
  SmallRational value = 0;
  SmallRational unit = 1;
  bool behind_point = false;
  for (const char c : digits) {
    if (c == '.') {
      behind_point = true;
      continue;
    }
    value = value * SmallRational(10) + SmallRational(c - '0');
    if (behind_point) unit = unit * SmallRational(10);
  }
  return value / unit;
}

class PolynomialReader {
 public:
  explicit PolynomialReader(ExprTree& tree) : tree_(tree) {}

  IndexPolynomial read(ExprId id, std::vector<Slot> slots) {
    const ExprNode node = tree_[id];
    switch (node.op) {
      case Op::number:
        return constant(number(tree_.digits(id)));
      case Op::symbol:
        if (tree_.symbols[node.symbol].noncommuting) throw TooManyMonomials{};  // products keep their order
        if (tree_.symbols[node.symbol].complex) throw TooManyMonomials{};       // v·v is not |v|²
        return symbol(id, std::move(slots));
      case Op::basis:
        return single({.kind = IndexFactor::Kind::delta, .slots = {bound(tree_.slots(id)[0]), slots[0]}});
      case Op::delta:
        return single({.kind = IndexFactor::Kind::delta, .slots = bound_slots(id)});
      case Op::epsilon:
        return single({.kind = IndexFactor::Kind::epsilon, .slots = bound_slots(id)});
      case Op::add:
        return sum(id, slots);
      case Op::negate:
        return times(constant(-1), read(child(id), slots));
      case Op::multiply:
        return product(id, slots);
      case Op::divide:
        return times(read(child(id), slots), inverse(child(id, 1)));
      case Op::power:
        return power(child(id), node.exponent);
      case Op::real_power:
        throw TooManyMonomials{};
      case Op::root:
        return single({.kind = IndexFactor::Kind::root, .argument = shared(read(child(id), {}))});
      case Op::imaginary_unit:
      case Op::conjugate:
      case Op::real_part:
      case Op::imaginary_part:
      case Op::transpose:
      case Op::trace:
      case Op::matrix_determinant:
        throw TooManyMonomials{};  // complex numbers and matrices of any size are not multiplied out
      case Op::length:
        if (has_complex_numbers(tree_, id)) throw TooManyMonomials{};
        return single({.kind = IndexFactor::Kind::root, .argument = shared(square_of_length(child(id)))});
      case Op::absolute:
        if (has_complex_numbers(tree_, id)) throw TooManyMonomials{};
        return single({.kind = IndexFactor::Kind::root, .argument = shared(power(child(id), 2))});
      case Op::dot:
        return dot(id, slots);
      case Op::cross:
        return cross(id, slots[0]);
      case Op::component:
        return read(child(id), bound_slots(id));
      case Op::tuple:
        return tuple(id, std::move(slots));
      case Op::determinant:
        return determinant(id, slots);
      case Op::index_sum:
        return index_sum(id, slots);
      case Op::particle_sum:
        return particle_sum(id, slots);
      case Op::function:
        return single({.kind = IndexFactor::Kind::function,
                       .function = node.function,
                       .argument = shared(read(child(id), {}))});
      case Op::table:
        if (node.rank > 0) throw TooManyMonomials{};
        return single({.kind = IndexFactor::Kind::table, .slots = bound_slots(id), .table = id});
    }
    throw TooManyMonomials{};
  }

 private:
  [[nodiscard]] ExprId child(ExprId id, std::size_t which = 0) const { return tree_.children(id)[which]; }
  static std::shared_ptr<const IndexPolynomial> shared(IndexPolynomial polynomial) {
    return std::make_shared<const IndexPolynomial>(std::move(polynomial));
  }

  [[nodiscard]] Slot bound(const Slot& slot) const {
    if (slot.axis != 0) return slot;
    const auto known = indices_.find(slot.variable);
    return known == indices_.end() ? slot : known->second;
  }
  [[nodiscard]] std::vector<Slot> bound_slots(ExprId id) const {
    std::vector<Slot> slots;
    for (const Slot& slot : tree_.slots(id)) slots.push_back(bound(slot));
    return slots;
  }

  IndexPolynomial symbol(ExprId id, std::vector<Slot> slots) {
    const ExprNode node = tree_[id];
    IndexFactor factor{.symbol = node.symbol};
    factor.slots = node.slot_count > 0 ? bound_slots(id) : std::move(slots);
    if (node.particle != no_particle) {
      const auto known = particles_.find(node.particle);
      factor.particle = known == particles_.end() ? node.particle : known->second;
    }
    return single(std::move(factor));
  }

  IndexPolynomial sum(ExprId id, const std::vector<Slot>& slots) {
    IndexPolynomial total;
    for (std::size_t k = 0; k < tree_[id].count; ++k)
      total = plus(std::move(total), read(child(id, k), slots));
    return total;
  }

  IndexPolynomial product(ExprId id, const std::vector<Slot>& slots) {
    IndexPolynomial total = constant(1);
    std::size_t used = 0;
    for (std::size_t k = 0; k < tree_[id].count; ++k) {
      const std::size_t rank = tree_[child(id, k)].rank;
      const auto from = slots.begin() + static_cast<std::ptrdiff_t>(used);
      used += rank;
      total = times(total, read(child(id, k), {from, from + static_cast<std::ptrdiff_t>(rank)}));
    }
    return total;
  }

  /// Every term under one more sum.
  template <class Letter>
  static IndexPolynomial summed(IndexPolynomial body, std::vector<Letter> IndexMonomial::*sums,
                                Letter letter) {
    for (IndexMonomial& term : body.terms) (term.*sums).insert((term.*sums).begin(), letter);
    return body;
  }

  IndexPolynomial square_of_length(ExprId vector) {
    const IndexId index = tree_.add_index("");
    return summed(times(read(vector, {{0, index}}), read(vector, {{0, index}})), &IndexMonomial::indices,
                  index);
  }

  IndexPolynomial power(ExprId base, int exponent) {
    if (exponent < 0) return inverse_power(base, -exponent);
    if (tree_[base].op == Op::length && exponent >= 2) {
      const IndexPolynomial square = square_of_length(child(base));
      return times(square, power(base, exponent - 2));
    }
    if (exponent > 1 && is_plain(base)) {
      IndexPolynomial plain = read(base, {});
      plain.terms[0].factors[0].exponent *= exponent;
      return plain;
    }
    IndexPolynomial result = constant(1);
    for (int k = 0; k < exponent; ++k) result = times(result, read(base, {}));
    return result;
  }

  /// One factor without sums, so that its power is one factor.
  [[nodiscard]] bool is_plain(ExprId id) const {
    const Op op = tree_[id].op;
    return op == Op::symbol || op == Op::length || op == Op::root || op == Op::function || op == Op::absolute;
  }

  IndexPolynomial inverse(ExprId id) { return inverse_power(id, 1); }

  /// 1/x^n; products and powers in a denominator stay products and powers.
  IndexPolynomial inverse_power(ExprId id, int exponent) {
    const ExprNode node = tree_[id];
    IndexPolynomial result = constant(1);
    switch (node.op) {
      case Op::number: {
        const SmallRational value = number(tree_.digits(id));
        if (value.is_zero()) throw TooManyMonomials{};
        for (int k = 0; k < exponent; ++k) result = times(result, constant(SmallRational(1) / value));
        return result;
      }
      case Op::negate:
        return times(constant(exponent % 2 == 0 ? 1 : -1), inverse_power(child(id), exponent));
      case Op::multiply:
        for (std::size_t k = 0; k < node.count; ++k)
          result = times(result, inverse_power(child(id, k), exponent));
        return result;
      case Op::divide:
        return times(power(child(id, 1), exponent), inverse_power(child(id), exponent));
      case Op::power:
        if (node.exponent >= 0) return inverse_power(child(id), exponent * node.exponent);
        return power(child(id), -exponent * node.exponent);
      case Op::dot:
        if (is_square(id)) return root_of_square(child(id), -2 * exponent);
        break;
      default:
        break;
    }
    if (!is_plain(id))
      return single(
          {.kind = IndexFactor::Kind::sum, .exponent = -exponent, .argument = shared(read(id, {}))});
    result = read(id, {});
    result.terms[0].factors[0].exponent *= -exponent;
    return result;
  }

  [[nodiscard]] bool is_square(ExprId dot) const {
    const ExprNode& a = tree_[child(dot)];
    const ExprNode& b = tree_[child(dot, 1)];
    return a.op == Op::symbol && b.op == Op::symbol && a.rank == 1 && a.symbol == b.symbol &&
           a.particle == b.particle;
  }

  IndexPolynomial root_of_square(ExprId vector, int exponent) {
    return single({.kind = IndexFactor::Kind::root,
                   .exponent = exponent,
                   .argument = shared(square_of_length(vector))});
  }

  IndexPolynomial dot(ExprId id, const std::vector<Slot>& slots) {
    const IndexId index = tree_.add_index("");
    const auto split = slots.begin() + (tree_[child(id)].rank - 1);
    std::vector<Slot> left(slots.begin(), split);
    std::vector<Slot> right{{0, index}};
    left.push_back({0, index});
    right.insert(right.end(), split, slots.end());
    return summed(times(read(child(id), left), read(child(id, 1), right)), &IndexMonomial::indices, index);
  }

  IndexPolynomial cross(ExprId id, const Slot& slot) {
    const Slot j{0, tree_.add_index("")};
    const Slot k{0, tree_.add_index("")};
    IndexPolynomial result = single({.kind = IndexFactor::Kind::epsilon, .slots = {slot, j, k}});
    result.terms[0].indices = {j.variable, k.variable};
    return times(times(result, read(child(id), {j})), read(child(id, 1), {k}));
  }

  IndexPolynomial tuple(ExprId id, std::vector<Slot> slots) {
    const Slot first = slots[0];
    slots.erase(slots.begin());
    if (first.axis != 0) return read(child(id, first.axis - 1u), slots);
    IndexPolynomial total;
    for (std::uint8_t axis = 1; axis <= 3; ++axis) {
      const IndexPolynomial along =
          single({.kind = IndexFactor::Kind::delta, .slots = {first, Slot{.axis = axis}}});
      total = plus(std::move(total), times(along, read(child(id, axis - 1u), slots)));
    }
    return total;
  }

  IndexPolynomial determinant(ExprId id, const std::vector<Slot>& slots) {
    IndexPolynomial total;
    for (std::size_t shift = 0; shift < 3; ++shift) {
      for (const std::size_t step : {1u, 2u}) {
        IndexPolynomial term = constant(step == 1 ? 1 : -1);
        for (std::size_t row = 0; row < 3; ++row) {
          const ExprId entry = child(id, 3 * row + (shift + row * step) % 3);
          term = times(term, read(entry, tree_[entry].rank == 1 ? slots : std::vector<Slot>{}));
        }
        total = plus(std::move(total), term);
      }
    }
    return total;
  }

  IndexPolynomial index_sum(ExprId id, const std::vector<Slot>& slots) {
    const IndexId written = tree_[id].index;
    const IndexId fresh = tree_.add_index(std::string(tree_.name(written)));
    const auto outer = indices_;
    indices_[written] = {0, fresh};
    IndexPolynomial body = read(child(id), slots);
    indices_ = outer;
    return summed(std::move(body), &IndexMonomial::indices, fresh);
  }

  IndexPolynomial particle_sum(ExprId id, const std::vector<Slot>& slots) {
    const ParticleId written = tree_[id].particle;
    const ParticleId fresh = tree_.add_particle(std::string(tree_.name(written)));
    const auto outer = particles_;
    particles_[written] = fresh;
    IndexPolynomial body = read(child(id), slots);
    particles_ = outer;
    return summed(std::move(body), &IndexMonomial::particles, fresh);
  }

  ExprTree& tree_;
  std::map<IndexId, Slot> indices_;
  std::map<ParticleId, ParticleId> particles_;
};

}  // namespace

std::optional<IndexPolynomial> polynomial_of(ExprTree& tree, ExprId id, std::span<const Slot> slots) {
  try {
    return PolynomialReader(tree).read(id, {slots.begin(), slots.end()});
  } catch (const TooManyMonomials&) {
    return std::nullopt;
  }
}

}  // namespace rigor
