// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/program/run_fuse.h"

#include <utility>

namespace rigor {
namespace {

/// By instruction; what has no operands of its own is copied.
constexpr auto kernels_of = std::to_array<Kernel>({
    Kernel::copy,
    Kernel::copy,
    Kernel::add,
    Kernel::subtract,
    Kernel::multiply,
    Kernel::divide,
    Kernel::negate,
    Kernel::root,
    Kernel::absolute,
    Kernel::sin,
    Kernel::cos,
    Kernel::exp,
    Kernel::tan,
    Kernel::sinh,
    Kernel::cosh,
    Kernel::tanh,
    Kernel::copy,
});
static_assert(kernels_of.size() == static_cast<std::size_t>(Instruction::sum) + 1);

class Fusion {
 public:
  Fusion(const FusionScope& scope, ValueId value, std::span<std::uint8_t> taken_in)
      : scope_(scope), value_(value), here_(scope.code->values[value]), taken_in_(taken_in) {}

  [[nodiscard]] FusedStep step() {
    if (here_.op == Instruction::add || here_.op == Instruction::subtract) return sum();
    if (here_.op == Instruction::multiply) return product();
    return plain();
  }

 private:
  [[nodiscard]] const Value& at(ValueId id) const { return scope_.code->values[id]; }
  [[nodiscard]] bool is_private(ValueId id, Instruction op) const {
    return scope_.is_private(id, op, scope_.wide[value_] != 0);
  }
  [[nodiscard]] bool is_square(ValueId id) const { return at(id).a == at(id).b; }

  /// Of a product, the wide one first.
  [[nodiscard]] std::array<ValueId, 2> factors(ValueId product) const {
    const ValueId a = at(product).a;
    const ValueId b = at(product).b;
    if (scope_.wide[b] && !scope_.wide[a]) return {b, a};
    return {a, b};
  }
  void append_product(FusedStep& step, ValueId product) {
    taken_in_[product] = 1;
    for (const ValueId factor : factors(product)) step.in[step.operands++] = factor;
  }

  [[nodiscard]] FusedStep plain() const {
    FusedStep step{kernels_of[static_cast<std::size_t>(here_.op)], 1, {here_.a}};
    if (!has_second_operand(here_.op)) return step;
    step.operands = 2;
    step.in[1] = here_.b;
    const bool commutes = here_.op == Instruction::add || here_.op == Instruction::multiply;
    if (commutes && scope_.wide[here_.b] && !scope_.wide[here_.a]) std::swap(step.in[0], step.in[1]);
    return step;
  }

  [[nodiscard]] FusedStep product() {
    FusedStep step{Kernel::product_3, 0, {}};
    ValueId two = here_.a;
    ValueId third = here_.b;
    if (!is_private(two, Instruction::multiply)) std::swap(two, third);
    if (two == third || !is_private(two, Instruction::multiply)) return plain();
    append_product(step, two);
    step.in[step.operands++] = third;
    return step;
  }

  [[nodiscard]] FusedStep sum() {
    FusedStep triples;
    if (triple_chain(triples)) return triples;
    const bool minus = here_.op == Instruction::subtract;
    const bool first = is_private(here_.a, Instruction::multiply);
    const bool second = here_.a != here_.b && is_private(here_.b, Instruction::multiply);
    FusedStep step;
    if (first && second) {
      step.kernel = minus ? Kernel::product_difference : Kernel::product_sum;
      append_product(step, here_.a);
      append_product(step, here_.b);
      return step;
    }
    if (!minus && (first || second)) {
      const ValueId product = first ? here_.a : here_.b;
      const ValueId other = first ? here_.b : here_.a;
      if (three_products(step, other, product)) return step;
    }
    if (!first && !second) return plain();
    step.kernel = !minus  ? Kernel::multiply_add
                  : first ? Kernel::multiply_subtract
                          : Kernel::subtract_product;
    append_product(step, first ? here_.a : here_.b);
    step.in[step.operands++] = first ? here_.b : here_.a;
    return step;
  }

  /// Is it (a b) c, computed for nothing but its user, with a or b narrow if the user is wide?
  [[nodiscard]] bool is_triple(ValueId id) const {
    if (!is_private(id, Instruction::multiply) || at(id).a == at(id).b) return false;
    const ValueId two = inner_of(id);
    const ValueId third = at(id).a == two ? at(id).b : at(id).a;
    if (!is_private(two, Instruction::multiply)) return false;
    if (!scope_.wide[value_]) return true;
    return scope_.wide[third] && scope_.wide[at(two).a] != scope_.wide[at(two).b];
  }
  /// The factor of a product that may be a product itself: the later one, if it is.
  [[nodiscard]] ValueId inner_of(ValueId product) const {
    const ValueId b = at(product).b;
    return is_private(b, Instruction::multiply) ? b : at(product).a;
  }
  void append_triple(FusedStep& step, ValueId triple) {
    taken_in_[triple] = 1;
    const ValueId two = inner_of(triple);
    append_product(step, two);
    step.in[step.operands++] = at(triple).a == two ? at(triple).b : at(triple).a;
  }

  /// The last three summands of a sum, if they are triples; `s` is what comes before them, if anything does.
  [[nodiscard]] bool triple_chain(FusedStep& step) {
    std::array<ValueId, 3> triple{};
    std::array<ValueId, 3> sum{};
    std::size_t found = 0;
    ValueId rest = value_;
    const auto is_sum = [this](ValueId id) {
      return is_private(id, Instruction::add) || is_private(id, Instruction::subtract);
    };
    while (found < 3 && (rest == value_ || is_sum(rest)) && is_triple(at(rest).b) &&
           at(rest).a != at(rest).b) {
      sum[found] = rest;
      triple[found++] = at(rest).b;
      rest = at(rest).a;
    }
    const bool begins = found == 2 && is_triple(rest);
    if (!begins && (found < 3 || scope_.wide[rest] != scope_.wide[value_])) return false;
    step.kernel = begins ? Kernel::triple_sum_3 : Kernel::add_triple_sum_3;
    if (begins) {
      append_triple(step, rest);
    } else {
      step.in[step.operands++] = rest;
    }
    for (std::size_t i = found; i-- > 0;) {
      if (sum[i] != value_) taken_in_[sum[i]] = 1;
      const std::size_t place = begins ? 2 - i : found - 1 - i;
      if (at(sum[i]).op == Instruction::subtract)
        step.minus = static_cast<std::uint8_t>(step.minus | 1u << place);
      append_triple(step, triple[i]);
    }
    return true;
  }

  /// (a b + c d) + e f, if all factors are wide, or the first of each product only.
  [[nodiscard]] bool three_products(FusedStep& step, ValueId two, ValueId third) {
    if (!is_private(two, Instruction::add) || at(two).a == at(two).b) return false;
    const std::array<ValueId, 3> product{at(two).a, at(two).b, third};
    int both_wide = 0;
    int squares = 0;
    for (const ValueId each : product) {
      if (each != third && !is_private(each, Instruction::multiply)) return false;
      both_wide += scope_.wide[at(each).a] && scope_.wide[at(each).b] ? 1 : 0;
      squares += is_square(each) ? 1 : 0;
    }
    if (scope_.wide[value_] && both_wide != 0 && both_wide != 3) return false;
    taken_in_[two] = 1;
    for (const ValueId each : product) append_product(step, each);
    step.kernel = Kernel::product_sum_3;
    if (squares != 3) return true;
    const std::array<ValueId, 3> squared{step.in[0], step.in[2], step.in[4]};
    if (!cross_square(step, squared)) step = {Kernel::square_sum_3, 3, {squared[0], squared[1], squared[2]}};
    return true;
  }

  /// The squared components of a cross product, each computed for its square only, if all factors are wide,
  /// or those of one vector. (a b − c d)² = (c d − a b)², exactly: so the vectors may stand in either order.
  [[nodiscard]] bool cross_square(FusedStep& step, const std::array<ValueId, 3>& squared) {
    const bool wide = scope_.wide[value_] != 0;
    std::array<std::array<ValueId, 2>, 3> products{};
    int both_wide = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Value& difference = at(squared[k]);
      if (!scope_.is_private_to_square(squared[k], Instruction::subtract, wide)) return false;
      products[k] = {difference.a, difference.b};
      if (difference.a == difference.b) return false;
      for (const ValueId product : products[k]) {
        if (!is_private(product, Instruction::multiply)) return false;
        both_wide += scope_.wide[at(product).a] && scope_.wide[at(product).b] ? 1 : 0;
      }
    }
    if (wide && both_wide != 0 && both_wide != 6) return false;
    for (const std::size_t first : {0U, 1U}) {
      // Of x y − z w the four factors.
      std::array<std::array<ValueId, 4>, 3> f{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto left = factors(products[k][first]);
        const auto right = factors(products[k][1 - first]);
        f[k] = {left[0], left[1], right[0], right[1]};
      }
      if (f[0][2] != f[1][0] || f[1][2] != f[2][0] || f[2][2] != f[0][0] || f[0][1] != f[1][3] ||
          f[0][3] != f[2][1] || f[1][1] != f[2][3])
        continue;
      for (std::size_t k = 0; k < 3; ++k)
        taken_in_[squared[k]] = taken_in_[products[k][0]] = taken_in_[products[k][1]] = 1;
      step = {Kernel::cross_square, 6, {f[0][0], f[0][2], f[1][2], f[0][1], f[0][3], f[1][1]}};
      return true;
    }
    return false;
  }

  const FusionScope& scope_;
  ValueId value_;
  const Value& here_;
  std::span<std::uint8_t> taken_in_;
};

}  // namespace

FusedStep fuse(const FusionScope& scope, ValueId value, std::span<std::uint8_t> taken_in) {
  return Fusion(scope, value, taken_in).step();
}

}  // namespace rigor
