// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace fuzz {
namespace {

using Value = std::vector<Jet>;  // 3^rank components, row by row

std::size_t components(int rank) { return rank == 0 ? 1U : 3 * components(rank - 1); }

double epsilon_of(int i, int j, int k) { return (i - j) * (j - k) * (k - i) / 2.0; }

bool has_small(const JetSpace& space) {
  Exponents first{};
  first[small_variable] = 1;
  return space.find(first) < space.monomials.size();
}

class Evaluation {
 public:
  Evaluation(const JetSpace& space, const std::vector<Letter>& letters, Random& random, bool special)
      : space_(space),
        small_(has_small(space)),
        letters_(letters),
        random_(random),
        special_(special),
        particles_(random.between(1, 3)) {}

  Value of(const Term& term) {
    Value value = node(*term);
    for (const Jet& jet : value) largest_ = std::max(largest_, std::abs(jet.value()));
    return value;
  }
  void set(const Given& given) {
    Value value;
    for (const double component : given.components) value.push_back(constant(component));
    if (value.size() != components(letters_[given.letter].rank)) throw NoValue{};
    values_.emplace(std::pair(given.letter, given.particle), value);
    particles_ = std::max(particles_, given.particle);
  }
  void set_particles(int particles) { particles_ = particles; }
  void set_index(char slot, int axis) { axes_[slot] = axis; }
  [[nodiscard]] double largest() const { return largest_; }

 private:
  Jet constant(double value) const { return Jet(space_, value); }
  std::size_t axis(char slot) const {
    return static_cast<std::size_t>(slot <= '3' ? slot - '1' : axes_.at(slot) - 1);
  }
  std::size_t offset(const std::string& slots) const {
    std::size_t offset = 0;
    for (const char slot : slots) offset = 3 * offset + axis(slot);
    return offset;
  }

  double draw() {
    static const std::vector<double> special{0, 0, 0, 1, 1, -1, -1, 2, -2, 0.5, -0.5, 3};
    if (special_ && !random_.one_in(4)) return random_.of(special);
    const double size = random_.between(3, 160) / 64.0;
    return random_.one_in(2) ? size : -size;
  }

  bool varies(Nature nature, const Exponents& exponents) const {
    const bool place = exponents[1] + exponents[2] + exponents[3] > 0;
    const int small = exponents[small_variable];
    switch (nature) {
      case Nature::constant:
      case Nature::position:
        return exponents == Exponents{};
      case Nature::field:
        return small == 0;
      case Nature::small:
        return !place && small == (small_ ? 1 : 0);
      default:
        return !place && small == 0;
    }
  }

  Value drawn(const Letter& letter) {
    Value value(components(letter.rank), constant(0.0));
    for (std::size_t c = 0; c < value.size(); ++c) {
      for (std::size_t k = 0; k < space_.monomials.size(); ++k)
        if (varies(letter.nature, space_.monomials[k])) value[c].coefficients[k] = draw();
      if (letter.nature != Nature::position) continue;
      Exponents linear{};
      linear[c + 1] = 1;
      const std::size_t k = space_.find(linear);
      if (k < space_.monomials.size()) value[c].coefficients[k] = 1.0;
    }
    if (letter.symmetric) {
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < i; ++j) value[3 * i + j] = value[3 * j + i];
    }
    if (letter.antisymmetric) {
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j <= i; ++j)
          value[3 * i + j] = i == j ? constant(0.0) : scaled(value[3 * j + i], -1.0);
    }
    if (letter.nature == Nature::unit) {
      const Jet length = root(dot(value, value));
      for (Jet& jet : value) jet = jet / length;
    }
    return value;
  }

  const Value& value_of(std::size_t letter, int particle) {
    const auto key = std::pair(letter, particle);
    if (const auto known = values_.find(key); known != values_.end()) return known->second;
    std::optional<Value> value;
    if (special_ && random_.one_in(4)) value = equal_to_another(letters_[letter]);
    if (!value) value = drawn(letters_[letter]);
    values_.emplace(key, *value);
    if (letters_[letter].value != nullptr) values_.at(key) = of(letters_[letter].value);
    return values_.at(key);
  }

  std::optional<Value> equal_to_another(const Letter& wanted) {
    for (const auto& [key, value] : values_) {
      const Letter& letter = letters_[key.first];
      if (letter.rank == wanted.rank && letter.nature == wanted.nature &&
          letter.symmetric == wanted.symmetric && letter.antisymmetric == wanted.antisymmetric)
        return value;
    }
    return std::nullopt;
  }

  Jet dot(const Value& a, const Value& b) const {
    Jet sum = constant(0.0);
    for (std::size_t i = 0; i < 3; ++i) sum = sum + a[i] * b[i];
    return sum;
  }
  Value cross(const Value& a, const Value& b) const {
    Value result;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      result.push_back(a[j] * b[k] - a[k] * b[j]);
    }
    return result;
  }
  template <typename Change>
  Value each(Value value, const Change& change) {
    for (Jet& jet : value) jet = change(jet);
    return value;
  }

  Value sum_over_indices(const Node& node, std::size_t position) {
    if (position == node.slots.size()) return of(node.parts[0]);
    const char slot = node.slots[position];
    const auto saved = axes_.find(slot) == axes_.end() ? 0 : axes_[slot];
    Value sum(components(node.rank), constant(0.0));
    for (int value = 1; value <= 3; ++value) {
      axes_[slot] = value;
      const Value part = sum_over_indices(node, position + 1);
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] = sum[c] + part[c];
    }
    axes_[slot] = saved;
    return sum;
  }

  Value sum_over_particles(const Node& node) {
    Value sum(components(node.rank), constant(0.0));
    for (int particle = 1; particle <= particles_; ++particle) {
      chosen_[node.particle] = particle;
      const Value part = of(node.parts[0]);
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] = sum[c] + part[c];
    }
    return sum;
  }

  Value product_of(const Node& node) {
    Jet factor = constant(1.0);
    std::optional<Value> tensor;
    for (const Term& part : node.parts) {
      Value value = of(part);
      if (part->rank == 0) {
        factor = factor * value[0];
      } else {
        tensor = std::move(value);
      }
    }
    if (!tensor) return {factor};
    return each(*std::move(tensor), [&](const Jet& jet) { return factor * jet; });
  }

  Value symbol_of(const Node& node) {
    Value value = value_of(node.letter, node.particle == 0 ? 0 : chosen_.at(node.particle));
    for (int k = 0; k < node.dots; ++k)
      value = each(std::move(value), [](const Jet& jet) { return derivative(jet, time_variable); });
    if (node.slots.empty()) return value;
    return {value[offset(node.slots)]};
  }

  Value with_spin(const Term& vector) {
    Value result = each(of(vector), [](const Jet& jet) { return derivative(jet, time_variable); });
    const auto spin = std::find_if(letters_.begin(), letters_.end(),
                                   [](const Letter& letter) { return letter.nature == Nature::spin; });
    const Value turned = cross(value_of(static_cast<std::size_t>(spin - letters_.begin()), 0), of(vector));
    for (std::size_t c = 0; c < 3; ++c) result[c] = result[c] + turned[c];
    return result;
  }

  Value of_place(const Node& node) {
    const auto by = [](const Jet& jet, std::size_t axis) {
      return derivative(jet, static_cast<int>(axis) + 1);
    };
    const Value inner = of(node.parts.back());
    switch (node.op) {
      case Op::partial:
        return each(inner, [&](const Jet& jet) { return by(jet, axis(node.slots[0])); });
      case Op::gradient:
        return {by(inner[0], 0), by(inner[0], 1), by(inner[0], 2)};
      case Op::divergence:
        return {by(inner[0], 0) + by(inner[1], 1) + by(inner[2], 2)};
      case Op::curl: {
        Value result;
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3;
          const std::size_t k = (i + 2) % 3;
          result.push_back(by(inner[k], j) - by(inner[j], k));
        }
        return result;
      }
      case Op::laplacian:
        return each(
            inner, [&](const Jet& jet) { return by(by(jet, 0), 0) + by(by(jet, 1), 1) + by(by(jet, 2), 2); });
      default: {  // (A·∇)B
        const Value direction = of(node.parts[0]);
        return each(inner, [&](const Jet& jet) {
          return direction[0] * by(jet, 0) + direction[1] * by(jet, 1) + direction[2] * by(jet, 2);
        });
      }
    }
  }

  Value node(const Node& node) {
    const auto part = [&](std::size_t k) { return of(node.parts[k]); };
    switch (node.op) {
      case Op::number:
        return Value(components(node.rank),
                     constant(static_cast<double>(node.p) / static_cast<double>(node.q)));
      case Op::symbol:
        return symbol_of(node);
      case Op::delta:
        return {constant(axis(node.slots[0]) == axis(node.slots[1]) ? 1.0 : 0.0)};
      case Op::epsilon:
        return {
            constant(epsilon_of(static_cast<int>(axis(node.slots[0])), static_cast<int>(axis(node.slots[1])),
                                static_cast<int>(axis(node.slots[2]))))};
      case Op::sum: {
        Value result = part(0);
        for (std::size_t k = 1; k < node.parts.size(); ++k) {
          const Value next = part(k);
          for (std::size_t c = 0; c < result.size(); ++c) result[c] = result[c] + next[c];
        }
        return result;
      }
      case Op::negative:
        return each(part(0), [](const Jet& jet) { return scaled(jet, -1.0); });
      case Op::product:
        return product_of(node);
      case Op::quotient: {
        const Jet below = part(1)[0];
        return each(part(0), [&](const Jet& jet) { return jet / below; });
      }
      case Op::power:
        return {power(part(0)[0], static_cast<int>(node.p))};
      case Op::root:
        return {root(part(0)[0])};
      case Op::absolute:
        return {absolute(part(0)[0])};
      case Op::length: {
        const Value vector = part(0);
        return {root(dot(vector, vector))};
      }
      case Op::dot:
        return {dot(part(0), part(1))};
      case Op::cross:
        return cross(part(0), part(1));
      case Op::act: {
        const Value tensor = part(0);
        const Value vector = part(1);
        Value result(3, constant(0.0));
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) result[i] = result[i] + tensor[3 * i + j] * vector[j];
        return result;
      }
      case Op::trace: {
        const Value tensor = part(0);
        return {tensor[0] + tensor[4] + tensor[8]};
      }
      case Op::function:
        return {apply(node.function, part(0)[0])};
      case Op::component:
        return {part(0)[axis(node.slots[0])]};
      case Op::contract:
        return sum_over_indices(node, 0);
      case Op::particle_sum:
        return sum_over_particles(node);
      case Op::rate:
      case Op::rate_rot:
        return each(part(0), [](const Jet& jet) { return derivative(jet, time_variable); });
      case Op::rate_in:
        return with_spin(node.parts[0]);
      default:
        return of_place(node);
    }
  }

  const JetSpace& space_;
  bool small_;  // what is small is a variable of the series; else a number like others
  const std::vector<Letter>& letters_;
  Random& random_;
  bool special_;
  int particles_;
  double largest_ = 1.0;
  std::map<char, int> axes_;
  std::map<char, int> chosen_;
  std::map<std::pair<std::size_t, int>, Value> values_;
};

constexpr double equal_within = 4e-15;  // of the largest number that occurred: cosh 16 is not e^16/2
constexpr double apart_beyond = 1e-7;

/// One value of left - right, in units of the largest number.
Truth related(Relation relation, double difference) {
  const bool zero = std::abs(difference) <= equal_within;
  const bool apart = std::abs(difference) >= apart_beyond;
  const bool exact = difference == 0.0;
  switch (relation) {
    case Relation::equal:
    case Relation::nearly:
      return zero ? Truth::holds : apart ? Truth::fails : Truth::unclear;
    case Relation::unequal:
      return apart ? Truth::holds : exact ? Truth::fails : Truth::unclear;
    case Relation::less_or_equal:
    case Relation::greater_or_equal: {
      const double over = relation == Relation::less_or_equal ? difference : -difference;
      return over <= equal_within ? Truth::holds : apart ? Truth::fails : Truth::unclear;
    }
    case Relation::less:
    case Relation::greater: {
      const double over = relation == Relation::less ? difference : -difference;
      if (exact || (apart && over > 0)) return Truth::fails;
      return apart ? Truth::holds : Truth::unclear;
    }
  }
  return Truth::unclear;
}

/// Half of the last digit of the only decimal in a claim; 0: it has none.
double last_digit(const Claim& claim) {
  double unit = 0.0;
  for (const Term& side : {claim.left, claim.right})
    visit(side,
          [&](const Node& node) { unit = node.decimals > 0 ? 1.0 / static_cast<double>(node.q) : unit; });
  return unit;
}

/// A rounded number: ≈ to its digits; = may be meant so, but not further off.
Truth rounded(const Claim& claim, double difference, double unit) {
  const auto is_whole = [](const Term& side) { return side->op == Op::number && side->q == 1; };
  const bool nearly = claim.relation == Relation::nearly;
  const bool to_whole = nearly && (is_whole(claim.left) || is_whole(claim.right));  // 15.14 ≈ 15
  if (std::abs(difference) > 1.001 * unit)
    return to_whole && std::abs(difference) < 1.001 ? Truth::unclear : Truth::fails;
  if (nearly) return std::abs(difference) < 0.499 * unit ? Truth::holds : Truth::unclear;
  return std::abs(difference) < 1e-14 ? Truth::holds : Truth::unclear;
}

Truth worse(Truth a, Truth b) {
  if (a == Truth::fails || b == Truth::fails) return Truth::fails;
  return a == Truth::unclear || b == Truth::unclear ? Truth::unclear : Truth::holds;
}

Truth on_components(const Claim& claim, Evaluation& evaluation, const JetSpace& space) {
  const Value left = evaluation.of(claim.left);
  const Value right = evaluation.of(claim.right);
  const double largest = evaluation.largest();
  if (!std::isfinite(largest) || largest > 1e7) throw NoValue{};
  Truth all = claim.relation == Relation::unequal ? Truth::fails : Truth::holds;
  for (std::size_t c = 0; c < left.size(); ++c) {
    const Jet difference = left[c] - right[c];
    if (const double unit = last_digit(claim); unit > 0.0) return rounded(claim, difference.value(), unit);
    Truth here = related(claim.relation, difference.value() / largest);
    if (claim.relation == Relation::nearly && has_small(space)) {
      Exponents first{};
      first[small_variable] = 1;
      here = worse(here, related(Relation::equal, difference.coefficients[space.find(first)] / largest));
    }
    if (claim.relation == Relation::unequal) {
      if (here == Truth::holds || all == Truth::fails) all = here;
    } else {
      all = worse(all, here);
    }
  }
  return all;
}

/// For all values of the free indices.
Truth on_sample(const Claim& claim, const std::string& free, Evaluation& evaluation, const JetSpace& space) {
  Truth all = Truth::holds;
  std::size_t places = 1;
  for (std::size_t k = 0; k < free.size(); ++k) places *= 3;
  for (std::size_t place = 0; place < places; ++place) {
    std::size_t rest = place;
    for (const char slot : free) {
      evaluation.set_index(slot, static_cast<int>(rest % 3) + 1);
      rest /= 3;
    }
    all = worse(all, on_components(claim, evaluation, space));
  }
  return all;
}

std::string free_indices(const Claim& claim, const std::vector<Letter>& letters) {
  std::string free;
  static_cast<void>(well_formed(claim.left, letters, free));
  if (free.empty()) static_cast<void>(well_formed(claim.right, letters, free));
  return free;
}

JetSpace space_for(const Claim& claim, const std::vector<Letter>& letters) {
  std::array<bool, variable_count> varies{};
  const auto look = [&](const Term& term) {
    visit(term, [&](const Node& node) {
      const bool in_time =
          node.op == Op::rate || node.op == Op::rate_in || node.op == Op::rate_rot || node.dots > 0;
      const bool in_place = node.op >= Op::partial;
      varies[time_variable] = varies[time_variable] || in_time;
      for (std::size_t axis = 1; axis <= 3; ++axis) varies[axis] = varies[axis] || in_place;
    });
  };
  look(claim.left);
  look(claim.right);
  int inside = 0;
  for (const Letter& letter : letters) {
    if (letter.value == nullptr) continue;
    inside = std::max(inside, derivative_order(letter.value));
    look(letter.value);
  }
  int degree = std::max(derivative_order(claim.left), derivative_order(claim.right));
  degree += inside;
  varies[small_variable] = claim.relation == Relation::nearly &&
                           std::any_of(letters.begin(), letters.end(),
                                       [](const Letter& letter) { return letter.nature == Nature::small; });
  if (varies[small_variable]) ++degree;
  return {varies, degree};
}

}  // namespace

Truth truth_of(const Claim& claim, const std::vector<Letter>& letters, const std::vector<Claim>& given,
               Random& random) {
  const bool order = claim.relation != Relation::equal && claim.relation != Relation::nearly;
  const JetSpace space = space_for(claim, letters);
  const std::string free = free_indices(claim, letters);
  const int wanted = order ? 240 : 24;
  int held = 0;
  bool unclear = false;
  for (int tried = 0; tried < 2 * wanted && held < wanted; ++tried) {
    Evaluation evaluation(space, letters, random, tried % 2 == 1);
    try {
      Truth met = Truth::holds;
      for (const Claim& each : given)
        met = worse(met, on_sample(each, free_indices(each, letters), evaluation, space));
      if (met != Truth::holds) continue;
      const Truth truth = on_sample(claim, free, evaluation, space);
      if (truth == Truth::fails) return Truth::fails;
      unclear = unclear || truth == Truth::unclear;
      ++held;
    } catch (const NoValue&) {
      continue;
    }
  }
  if (claim.relation ==
      Relation::unequal) {  // no sample may show that the sides meet; but if they cross, they do
    Claim sided = claim;
    for (const Relation side : {Relation::less, Relation::greater}) {
      sided.relation = side;
      if (claim.left->rank == 0 && truth_of(sided, letters, given, random) == Truth::holds)
        return Truth::holds;
    }
    return Truth::unclear;
  }
  return unclear || held < wanted / 4 ? Truth::unclear : Truth::holds;
}

Truth truth_at(const Claim& claim, const std::vector<Letter>& letters, const std::vector<Claim>& given,
               const std::vector<Given>& sample, Random& random, bool& meets) {
  meets = true;
  const JetSpace space = space_for(claim, letters);
  if (space.degree > 0) return Truth::unclear;
  Evaluation evaluation(space, letters, random, false);
  try {
    evaluation.set_particles(1);
    for (const Given& each : sample) evaluation.set(each);
    for (const Claim& each : given)
      meets = meets && on_sample(each, free_indices(each, letters), evaluation, space) != Truth::fails;
    return on_sample(claim, free_indices(claim, letters), evaluation, space);
  } catch (const NoValue&) {
    return Truth::unclear;
  }
}

}  // namespace fuzz
