// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/program/run_fuse.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

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

/// What a step takes in, beside the value that it is for.
class TakenIn {
 public:
  void add(ValueId value) {
    RIGOR_CHECK(count_ < values_.size(), count_);
    values_[count_++] = value;
  }
  void set(std::span<std::uint8_t> taken_in) const {
    for (std::size_t k = 0; k < count_; ++k) taken_in[values_[k]] = 1;
  }

 private:
  std::array<ValueId, 32> values_{};
  std::size_t count_ = 0;
};

class Fusion {
 public:
  Fusion(const FusionScope& scope, ValueId value)
      : scope_(scope), value_(value), here_(scope.code->values[value]) {}

  [[nodiscard]] FusedStep step() {
    if (const auto ended = with_ending()) return *ended;
    if (here_.op == Instruction::add || here_.op == Instruction::subtract) return sum();
    if (here_.op == Instruction::multiply) return product();
    return plain();
  }
  [[nodiscard]] const TakenIn& taken_in() const { return taken_in_; }

 private:
  /// −v, v f or v / f with the step of v, where v is computed for nothing else and f is narrow.
  [[nodiscard]] std::optional<FusedStep> with_ending() {
    const bool wide = scope_.wide[value_] != 0;
    std::array<ValueId, 2> order{here_.a, here_.b};
    std::size_t tried = here_.op == Instruction::multiply ? 2 : 1;
    if (here_.op != Instruction::negate && here_.op != Instruction::divide && tried == 1) return std::nullopt;
    for (; tried-- > 0; std::swap(order[0], order[1])) {
      const auto [inner, factor] = order;
      const bool negates = here_.op == Instruction::negate;
      if (!scope_.is_private(inner, wide) || (!negates && (scope_.wide[factor] != 0 || factor == inner)))
        continue;
      Fusion of_inner(scope_, inner);
      FusedStep step = of_inner.step();
      if (negates) {
        step.negated = !step.negated;
      } else if (!step.factor) {
        step.factor = factor;
        if (here_.op == Instruction::divide) step.ending = Ending::divide;
      } else {
        continue;
      }
      taken_in_ = of_inner.taken_in();
      taken_in_.add(inner);
      return step;
    }
    return std::nullopt;
  }

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
    taken_in_.add(product);
    for (const ValueId factor : factors(product)) step.in[step.operands++] = factor;
  }

  [[nodiscard]] FusedStep plain() const {
    FusedStep step{.kernel = kernels_of[static_cast<std::size_t>(here_.op)], .operands = 1, .in = {here_.a}};
    if (!has_second_operand(here_.op)) return step;
    step.operands = 2;
    step.in[1] = here_.b;
    const bool commutes = here_.op == Instruction::add || here_.op == Instruction::multiply;
    if (commutes && scope_.wide[here_.b] && !scope_.wide[here_.a]) std::swap(step.in[0], step.in[1]);
    return step;
  }

  [[nodiscard]] FusedStep product() {
    FusedStep step{.kernel = Kernel::product_3};
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
    if (quadratic_form(triples) || triple_chain(triples)) return triples;
    const bool minus = here_.op == Instruction::subtract;
    const bool first = is_private(here_.a, Instruction::multiply);
    const bool second = here_.a != here_.b && is_private(here_.b, Instruction::multiply);
    FusedStep step;
    if (minus && less_square(step)) return step;
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
  /// (a b) c; of a and b the wide one first.
  [[nodiscard]] std::array<ValueId, 3> factors_of_triple(ValueId triple) const {
    const ValueId two = inner_of(triple);
    const auto [a, b] = factors(two);
    return {a, b, at(triple).a == two ? at(triple).b : at(triple).a};
  }
  void append_triple(FusedStep& step, ValueId triple) {
    taken_in_.add(triple);
    taken_in_.add(inner_of(triple));
    for (const ValueId factor : factors_of_triple(triple)) step.in[step.operands++] = factor;
  }

  [[nodiscard]] bool is_private_sum(ValueId id) const {
    return is_private(id, Instruction::add) || is_private(id, Instruction::subtract);
  }

  /// All nine terms of a quadratic form, x_i a_ij x_j row by row, the a_ij narrow.
  [[nodiscard]] bool quadratic_form(FusedStep& step) {
    std::array<ValueId, 9> triple{};
    std::array<ValueId, 8> sum{};
    ValueId rest = value_;
    for (std::size_t n = 8; n > 0; --n) {
      if ((rest != value_ && !is_private_sum(rest)) || at(rest).a == at(rest).b) return false;
      sum[n - 1] = rest;
      triple[n] = at(rest).b;
      rest = at(rest).a;
    }
    triple[0] = rest;
    FusedStep form{.kernel = Kernel::quadratic_form_3, .operands = 12};
    for (std::size_t n = 0; n < 9; ++n) {
      if (!is_triple(triple[n])) return false;
      const auto [x, entry, y] = factors_of_triple(triple[n]);
      if (n % 4 == 0) form.in[n / 4] = y;
      form.in[3 + n] = entry;
      if (n > 0 && at(sum[n - 1]).op == Instruction::subtract)
        form.minus = static_cast<std::uint16_t>(form.minus | 1u << n);
    }
    for (std::size_t n = 0; n < 9; ++n) {
      const auto [x, entry, y] = factors_of_triple(triple[n]);
      if (x != form.in[n / 3] || y != form.in[n % 3]) return false;
    }
    for (std::size_t n = 0; n < 9; ++n) {
      taken_in_.add(triple[n]);
      taken_in_.add(inner_of(triple[n]));
      if (n > 0 && sum[n - 1] != value_) taken_in_.add(sum[n - 1]);
    }
    step = form;
    return true;
  }

  /// The last three summands of a sum, if they are triples; `s` is what comes before them, if anything does.
  [[nodiscard]] bool triple_chain(FusedStep& step) {
    std::array<ValueId, 3> triple{};
    std::array<ValueId, 3> sum{};
    std::size_t found = 0;
    ValueId rest = value_;
    while (found < 3 && (rest == value_ || is_private_sum(rest)) && is_triple(at(rest).b) &&
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
      if (sum[i] != value_) taken_in_.add(sum[i]);
      const std::size_t place = begins ? 2 - i : found - 1 - i;
      if (at(sum[i]).op == Instruction::subtract)
        step.minus = static_cast<std::uint16_t>(step.minus | 1u << place);
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
    taken_in_.add(two);
    for (const ValueId each : product) append_product(step, each);
    step.kernel = Kernel::product_sum_3;
    if (squares != 3) return true;
    const std::array<ValueId, 3> squared{step.in[0], step.in[2], step.in[4]};
    if (!cross_square(step, squared))
      step = {.kernel = Kernel::square_sum_3, .operands = 3, .in = {squared[0], squared[1], squared[2]}};
    return true;
  }

  /// The three products of (a b + c d) + e f, where that is computed for nothing but its user, or for its
  /// square alone.
  [[nodiscard]] std::optional<std::array<ValueId, 3>> products_of(ValueId sum, bool for_square) const {
    const bool wide = scope_.wide[value_] != 0;
    const Value& outer = at(sum);
    const bool is_own = for_square ? scope_.is_private_to_square(sum, Instruction::add, wide)
                                   : scope_.is_private(sum, Instruction::add, wide);
    if (!is_own || outer.a == outer.b || !is_private(outer.a, Instruction::add)) return std::nullopt;
    const Value& inner = at(outer.a);
    const std::array<ValueId, 3> products{inner.a, inner.b, outer.b};
    for (const ValueId each : products)
      if (!is_private(each, Instruction::multiply)) return std::nullopt;
    if (inner.a == inner.b) return std::nullopt;
    return products;
  }

  /// a b − c² for a sum c of three products, each of a wide factor and a narrow one, or of wide ones.
  [[nodiscard]] bool less_square(FusedStep& step) {
    const auto [left, square] = std::pair(here_.a, here_.b);
    if (left == square || !is_private(left, Instruction::multiply) ||
        !is_private(square, Instruction::multiply) || !is_square(square) || is_square(left))
      return false;
    const ValueId sum = at(square).a;
    const auto products = products_of(sum, true);
    if (!products) return false;
    int both_wide = 0;
    const std::array<ValueId, 4> all{left, (*products)[0], (*products)[1], (*products)[2]};
    for (const ValueId each : all)
      both_wide += scope_.wide[at(each).a] != 0 && scope_.wide[at(each).b] != 0 ? 1 : 0;
    if (scope_.wide[value_] != 0 && both_wide != 0 && both_wide != 4) return false;
    taken_in_.add(square);
    taken_in_.add(sum);
    taken_in_.add(at(sum).a);
    for (const ValueId each : all) append_product(step, each);
    step.kernel = Kernel::less_square;
    if (gram(step)) step.kernel = Kernel::gram;
    return true;
  }

  /// The same where a and b are the sums of the squares of what c is made of.
  [[nodiscard]] bool gram(FusedStep& step) {
    std::array<ValueId, 6> x{};
    TakenIn taken = taken_in_;
    for (std::size_t v = 0; v < 2; ++v) {
      const ValueId sum = step.in[v];
      const auto squares = products_of(sum, false);
      if (!squares) return false;
      taken.add(sum);
      taken.add(at(sum).a);
      for (std::size_t k = 0; k < 3; ++k) {
        const ValueId square = (*squares)[k];
        if (!is_square(square)) return false;
        taken.add(square);
        x[3 * v + k] = at(square).a;
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::pair(step.in[2 + 2 * k], step.in[3 + 2 * k]);
      if (!(a == x[k] && b == x[3 + k]) && !(b == x[k] && a == x[3 + k])) return false;
      if (scope_.wide[value_] != 0 && (scope_.wide[a] == 0 || scope_.wide[b] == 0)) return false;
    }
    taken_in_ = taken;
    step.operands = 6;
    std::ranges::copy(x, step.in.begin());
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
        for (const ValueId each : {squared[k], products[k][0], products[k][1]}) taken_in_.add(each);
      step = {.kernel = Kernel::cross_square,
              .operands = 6,
              .in = {f[0][0], f[0][2], f[1][2], f[0][1], f[0][3], f[1][1]}};
      return true;
    }
    return false;
  }

  const FusionScope& scope_;
  ValueId value_;
  const Value& here_;
  TakenIn taken_in_;
};

}  // namespace

std::optional<FusedStep> cross_of(const std::array<FusedStep, 3>& steps, std::array<std::size_t, 3>& order) {
  for (const FusedStep& step : steps) {
    if (step.kernel != Kernel::product_difference || step.ending != steps[0].ending ||
        step.factor != steps[0].factor || step.negated != steps[0].negated)
      return std::nullopt;
  }
  for (const std::array<std::size_t, 3>& tried : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 1}}) {
    const auto& x = steps[tried[0]].in;  // b f − c e
    const auto& y = steps[tried[1]].in;  // c d − a f
    const auto& z = steps[tried[2]].in;  // a e − b d
    if (x[2] != y[0] || y[2] != z[0] || z[2] != x[0] || x[1] != y[3] || y[1] != z[3] || z[1] != x[3])
      continue;
    order = tried;
    FusedStep step = steps[0];
    step.kernel = Kernel::cross;
    step.operands = 6;
    step.in = {y[2], x[0], x[2], y[1], x[3], x[1]};
    return step;
  }
  return std::nullopt;
}

FusedStep fuse(const FusionScope& scope, ValueId value, std::span<std::uint8_t> taken_in) {
  Fusion fusion(scope, value);
  const FusedStep step = fusion.step();
  fusion.taken_in().set(taken_in);
  return step;
}

}  // namespace rigor
