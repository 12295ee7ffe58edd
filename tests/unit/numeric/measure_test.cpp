// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/measure.h"

#include <cmath>
#include <limits>

#include "catch.h"
#include "numeric/on_sample.h"

using namespace rigor;
using namespace rigor::build;

namespace {

const MeasureOptions untimed{.milliseconds = 0.0};

[[nodiscard]] const ErrorMeasure& of(const FormMeasure& form, Arithmetic arithmetic) {
  return form.arithmetics[static_cast<std::size_t>(arithmetic)];
}

}  // namespace

TEST_CASE("two forms that are equal on paper are far apart for nearly parallel vectors", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  Samples samples(4, 0);
  samples.set_each(a.symbol, 0, {1.0, 0.7, 0.3, 1.1});
  samples.set_each(a.symbol, 1, {0.3, 0.2, 0.9, -0.4});
  samples.set_each(a.symbol, 2, {-0.2, 0.5, 0.4, 0.8});
  for (std::uint32_t i = 0; i < 3; ++i) {
    std::vector<double> values = samples.find(a.symbol, i)->values;
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] *= 1.0 + 1e-8 * static_cast<double>(i * (k + 1) + 1);
    samples.set_each(b.symbol, i, values);
  }
  const FormMeasure cross_form = measure(compiled(page, squared(cross(a, b))), samples, untimed);
  const FormMeasure dot_form =
      measure(compiled(page, squared(a) * squared(b) - pow(dot(a, b), 2)), samples, untimed);
  CHECK(of(cross_form, Arithmetic::plain).compared == 4);
  CHECK(of(cross_form, Arithmetic::plain).relative.worst < 1e-5);
  CHECK(of(dot_form, Arithmetic::plain).relative.worst > 0.1);
  CHECK(of(dot_form, Arithmetic::double_double).relative.worst < 1e-12);
  CHECK(of(dot_form, Arithmetic::plain).bits_kept.worst < 4.0);
  CHECK(of(dot_form, Arithmetic::extended).relative.worst < of(dot_form, Arithmetic::plain).relative.worst);
  CHECK(cross_form.condition.worst > 1e7);
  CHECK(cross_form.condition_known == 4);
}

TEST_CASE("a single rounding costs at most half a unit in the last place, in each arithmetic", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(5, 0);
  samples.set_each(x.symbol, 0, {3.0, 7.0, 1.0 / 3.0, 1e-300, 123456.789});
  const FormMeasure form = measure(compiled(page, 1 / x), samples, untimed);
  for (const ErrorMeasure& each : form.arithmetics) {
    CAPTURE(name_of(each.arithmetic));
    if (each.arithmetic == Arithmetic::double_double) {
      CHECK(each.ulps.worst < 4.0);  // its division is not rounded correctly
    } else if (each.arithmetic != Arithmetic::single) {
      CHECK(each.ulps.worst <= 0.5);
    }
    CHECK(each.bits_kept.median >= each.right_bits - 2.0);
    CHECK(each.nanoseconds == 0.0);
  }
  CHECK(of(form, Arithmetic::plain).ulps.median > 0.01);
  CHECK(of(form, Arithmetic::single).compared == 4);  // 1e-300 is 0 as a float
  CHECK(of(form, Arithmetic::single).overflows == 1);
}

TEST_CASE("overflow, NaN, wrong signs and exact zeros are counted", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  Samples samples(4, 0);
  samples.set_each(x.symbol, 0, {1e200, 1.0, 1.0 + 0x1p-30, 2.0});
  samples.set_each(y.symbol, 0, {1.0, 1.0, 1.0, std::numeric_limits<double>::quiet_NaN()});
  // (x² y) / x²: overflows at 1e200.
  const ErrorMeasure quotient =
      of(measure(compiled(page, pow(x, 2) * y / x), samples, untimed), Arithmetic::plain);
  CHECK(quotient.overflows == 1);
  CHECK(quotient.undefined == 1);
  CHECK(std::isinf(quotient.relative.worst));
  CHECK(quotient.relative.median < 1e-15);
  const ErrorMeasure nan =
      of(measure(compiled(page, pow(x, 2) / pow(x, 2) * y), samples, untimed), Arithmetic::plain);
  CHECK(nan.not_a_number == 1);
  // (x − y)² − tiny: 2^-60 − 2^-61 > 0 is computed well; x² − 2xy + y² gives 0.
  const Term square = pow(x, 2) - 2 * x * y + pow(y, 2);
  const ErrorMeasure sign = of(measure(compiled(page, square), samples, untimed), Arithmetic::plain);
  CHECK(sign.zeros == 1);
  CHECK(sign.worst_at_zero == 0.0);
  CHECK(sign.wrong_signs == 1);
}

TEST_CASE("for float the inputs are rounded before they are compared", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 0.1);
  const FormMeasure form = measure(compiled(page, x), samples, untimed);
  CHECK(of(form, Arithmetic::single).relative.worst == 0.0);
}

TEST_CASE("time is measured where it is asked for", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(2, 0);
  samples.set_each(x.symbol, 0, {0.1, 0.2});
  const FormMeasure form = measure(compiled(page, x * x + x), samples, {.milliseconds = 0.1});
  for (const ErrorMeasure& each : form.arithmetics) CHECK(each.nanoseconds > 0.0);
}

TEST_CASE("the work of sums within sums grows with the power of the particles", "[numeric]") {
  Page page;
  const Named m = page.scalars("m");
  const ParticleId alpha = page.particle("\\alpha");
  const ParticleId beta = page.particle("\\beta");
  const ParticleId gamma = page.particle("\\gamma");
  const Term one = over(alpha, m(alpha) * m(alpha));
  const Term two = over(alpha, over(beta, absolute(m(alpha) - m(beta))));
  const Term three = over(alpha, over(beta, over(gamma, root(m(alpha) + m(beta) + m(gamma)))));
  CHECK(work_of(compiled(page, one), 100) == 1 + 200);
  CHECK(work_of(compiled(page, two), 100) == 1 + 3 * 10'000 + 100);
  CHECK(work_of(compiled(page, three), std::size_t{1} << 22) == std::numeric_limits<std::size_t>::max());
  Samples samples(3, 100);
  samples.set_particles(m.symbol, 0, std::vector<double>(100, 1.5));
  MeasureOptions options = untimed;
  options.operations = work_of(compiled(page, two), samples) - 1;
  CHECK(measure(compiled(page, two), samples, options).measured == 0);
  ++options.operations;
  CHECK(measure(compiled(page, two), samples, options).measured == 1);
}

TEST_CASE("what is not finite where the exact value is 0 is the worst result there", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 1e200);
  // x²/x − x: infinite in double; x² − x²: NaN.
  for (const Term& term : {pow(x, 2) / x - x, pow(x, 2) - pow(2 * x, 2) / 4}) {
    const FormMeasure form = measure(compiled(page, term), samples, untimed);
    CHECK(of(form, Arithmetic::plain).zeros == 1);
    CHECK(std::isinf(of(form, Arithmetic::plain).worst_at_zero));
    CHECK(of(form, Arithmetic::extended).worst_at_zero == 0.0);
  }
}
