// SPDX-License-Identifier: GPL-3.0-or-later
// Advice against numbers that it has not seen.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>

#include <fmt/format.h>

#include "catch.h"
#include "check/entry/read_forms.h"
#include "numeric/advice/advise_forms.h"
#include "numeric/measure/evaluate.h"
#include "numeric/measure/measure.h"
#include "numeric/measure/reference.h"

namespace rigor {
namespace {

constexpr std::size_t wanted_points = 20'000;
constexpr std::size_t most_tries = 6'000'000;
constexpr double three_bits = 8;

std::string text_of_file(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The chain with a tag, and what is advised.
struct AdvisedChain {
  SourceMap sources;
  FormsReading reading;
  const WrittenFormChain* chain = nullptr;
  std::optional<SearchSpace> space;
  std::optional<RangeAdvice> advice;

  AdvisedChain(const std::string& notes, const std::string& tag) {
    reading = read_forms_of_text(sources, "notes.md", notes, {});
    for (const WrittenFormChain& each : reading.forms.chains)
      if (tag.empty() || stands_at(each, tag)) chain = &each;
    REQUIRE(chain != nullptr);
    std::vector<Program> programs;
    std::vector<double> costs;
    for (const WrittenForm& form : chain->forms) {
      REQUIRE(form.expr);
      const ProgramRoot root{*form.expr, chain->indices};
      auto program = Program::compile(reading.forms.tree, chain->definitions, std::span(&root, 1));
      REQUIRE(program);
      costs.push_back(static_cast<double>(program->counts().once));
      programs.push_back(std::move(*program));
    }
    auto found = search_space(reading.forms, *chain, std::move(programs), 1);
    REQUIRE(found);
    space = std::move(*found);
    advice = advise_forms(*space, reading.forms.tree, costs, 1);
  }
  /// The form that is advised at a point.
  [[nodiscard]] std::optional<std::size_t> form_at(const Point& point) const {
    for (const AdvisedForm& part : advice->parts)
      if (contains(*space, part.range, point)) return part.form;
    return std::nullopt;
  }
};

/// Points with sizes of all orders, both signs, and letters that nearly agree.
class UnseenPoints {
 public:
  UnseenPoints(const SearchSpace& space, std::uint64_t seed) : space_(space), bits_(seed) {}

  Point draw() {
    Point point(space_.size);
    constexpr double widths[] = {1, 3, 30, 290};
    const double width = widths[bits_() % 4];
    for (const SearchedLetter& letter : space_.letters) {
      const double size = log_uniform(width);
      for (std::size_t k = 0; k < letter.components.size(); ++k) {
        const double spread = letter.components.size() == 1 ? 1 : log_uniform(bits_() % 2 == 0 ? 0.5 : 3);
        point[letter.first + k] = sign() * size * spread;
      }
    }
    if (bits_() % 2 == 0) make_near(point);
    if (bits_() % 8 == 0) make_near(point);
    return point;
  }

  Point neighbour(const Point& point, bool together) {
    Point near = point;
    const double common = 1 + uniform(-0.06, 0.06);
    for (double& x : near) x *= together ? common : 1 + std::pow(10.0, uniform(-16, -9)) * sign();
    return near;
  }

 private:
  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(bits_); }
  double log_uniform(double width) { return std::pow(10.0, uniform(-width, width)); }
  double sign() { return bits_() % 2 == 0 ? 1 : -1; }

  void make_near(Point& point) {
    const SearchedLetter& one = space_.letters[bits_() % space_.letters.size()];
    const SearchedLetter& other = space_.letters[bits_() % space_.letters.size()];
    if (one.components.size() != other.components.size()) return;
    for (std::size_t k = 0; k < one.components.size(); ++k) {
      const double near = 1 + sign() * std::pow(10.0, uniform(-15, -1));
      point[one.first + k] = (&one == &other ? sign() : point[other.first + k]) * near;
    }
  }

  const SearchSpace& space_;
  std::mt19937_64 bits_;
};

/// The values of all forms, which are one value, from the first of them that is known.
ReferenceDigits values_at(const SearchSpace& space, const std::vector<Point>& points) {
  const std::size_t outputs = space.forms[0].outputs();
  ReferenceDigits values{std::vector<ReferenceNumber>(outputs * points.size()),
                         std::vector<Known>(outputs * points.size(), Known::unknown)};
  std::vector<std::size_t> open(points.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  for (std::size_t form = space.forms.size(); form-- > 0 && !open.empty();) {
    std::vector<Point> there;
    for (const std::size_t n : open) there.push_back(points[n]);
    const ReferenceDigits found = reference_digits(space.forms[form], samples_at(space, there));
    std::vector<std::size_t> still;
    for (std::size_t i = 0; i < open.size(); ++i) {
      bool known = true;
      for (std::size_t k = 0; k < outputs; ++k) {
        values.values[k * points.size() + open[i]] = found.values[k * open.size() + i];
        values.known[k * points.size() + open[i]] = found.known[k * open.size() + i];
        const Known here = found.known[k * open.size() + i];
        known = known && (here == Known::value || here == Known::zero);
      }
      if (!known) still.push_back(open[i]);
    }
    open = still;
  }
  return values;
}

/// errors[form][point], relative; negative where the value is not known, or not normal.
std::vector<std::vector<double>> errors_at(const SearchSpace& space, const std::vector<Point>& points) {
  const Samples samples = samples_at(space, points);
  const ReferenceDigits exact = values_at(space, points);
  const std::size_t outputs = space.forms[0].outputs();
  std::vector<std::vector<double>> errors(space.forms.size(), std::vector<double>(points.size(), -1));
  for (std::size_t form = 0; form < space.forms.size(); ++form) {
    const std::vector<double> computed = evaluate(space.forms[form], samples);
    for (std::size_t n = 0; n < points.size(); ++n) {
      ReferenceNumber size = 0;
      ReferenceNumber apart = 0;
      bool known = true;
      bool finite = true;
      for (std::size_t k = n; k < outputs * points.size(); k += points.size()) {
        known = known && (exact.known[k] == Known::value || exact.known[k] == Known::zero);
        size = std::max(size, ReferenceNumber(abs(exact.values[k])));
        finite = finite && std::isfinite(computed[k]);
        if (finite)
          apart = std::max(apart, ReferenceNumber(abs(ReferenceNumber(computed[k]) - exact.values[k])));
      }
      if (!known || size < std::numeric_limits<double>::min() || size > std::numeric_limits<double>::max())
        continue;
      const double error = finite ? static_cast<double>(ReferenceNumber(apart / size)) : 1;
      errors[form][n] = std::clamp(error, unit_roundoff, 1.0);
    }
  }
  return errors;
}

/// The advised form's error over the least one there.
double loss_at(const std::vector<std::vector<double>>& errors, std::size_t form, std::size_t n) {
  double least = 1;
  for (const std::vector<double>& each : errors) least = std::min(least, each[n]);
  return errors[form][n] / least;
}

/// Not by the luck of one rounding: the middle one of neighbours, near and scaled, loses as well.
bool loses_around(const AdvisedChain& advised, UnseenPoints& source, const Point& point, std::size_t form) {
  for (const bool together : {false, true}) {
    std::vector<Point> around;
    for (int k = 0; k < 15; ++k) around.push_back(source.neighbour(point, together));
    const auto errors = errors_at(*advised.space, around);
    std::vector<double> losses;
    for (std::size_t n = 0; n < around.size(); ++n)
      if (errors[form][n] > 0) losses.push_back(loss_at(errors, form, n));
    if (losses.empty()) return false;
    std::ranges::nth_element(losses, losses.begin() + static_cast<std::ptrdiff_t>(losses.size() / 2));
    if (losses[losses.size() / 2] <= three_bits) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("advised forms keep their digits on 20,000 points that were not searched", "[numeric]") {
  const std::string notes = text_of_file("tests/notes/pass/equal-on-paper.md");
  const int tag = GENERATE(range(1, 23));
  const AdvisedChain advised(notes, fmt::format("({})", tag));
  INFO(advised.chain->forms[0].source);
  REQUIRE(advised.advice);
  REQUIRE(advised.advice->parts.size() >= 1);
  REQUIRE(advised.advice->parts.size() <= 2);
  UnseenPoints source(*advised.space, 20261126);
  ConditionsAtPoint conditions(*advised.space);
  std::vector<Point> points;
  for (std::size_t k = 0; k < most_tries && points.size() < wanted_points; ++k) {
    Point point = source.draw();
    if (conditions.met(point)) points.push_back(std::move(point));
  }
  CHECK(points.size() == wanted_points);
  const auto errors = errors_at(*advised.space, points);
  std::size_t known = 0;
  std::size_t in_range = 0;
  std::size_t losing = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (errors[0][n] < 0) continue;
    ++known;
    const auto form = advised.form_at(points[n]);
    if (!form) continue;
    ++in_range;
    if (loss_at(errors, *form, n) <= three_bits || !loses_around(advised, source, points[n], *form)) continue;
    ++losing;
    UNSCOPED_INFO("form " << *form << " errs by " << errors[*form][n] << " at "
                          << text_of(advised.reading.forms.tree, *advised.space, points[n]));
  }
  CHECK(losing == 0);
  CHECK(3 * known > points.size());
  CHECK(5 * in_range > known);
}

TEST_CASE("points at which a form is known to lose are not forgotten", "[numeric]") {
  const AdvisedChain advised("$$\\frac{a^2 - b^2}{a - b} = a + b$$", "");
  Attacker attacker(*advised.space, 1);
  const auto found = attacker.worst(0, {}, {});
  REQUIRE(found);
  REQUIRE(found->loss > no_loss);
  const auto again = attacker.worst(0, {}, {.effort = 0, .ordinary = true});
  REQUIRE(again);
  CHECK(again->loss > no_loss);
}

TEST_CASE("a form is not advised for a range in which no point was met", "[numeric]") {
  // Numbers up to 500 do not meet the conditions, and beyond that no single form is safe.
  const AdvisedChain advised(
      "For $x > 1000$ and $y > 1000$,\n$$\\frac{\\sqrt{x+1}-\\sqrt{x}}{\\sqrt{y+1}+\\sqrt{y}} = "
      "\\frac{\\sqrt{y+1}-\\sqrt{y}}{\\sqrt{x+1}+\\sqrt{x}}$$",
      "");
  REQUIRE(advised.advice);
  for (const AdvisedForm& part : advised.advice->parts) {
    Attacker attacker(*advised.space, 1);
    CHECK(attacker.worst(part.form, part.range, {.effort = 6}));
  }
}

TEST_CASE("a search that would take too long says nothing", "[numeric]") {
  const AdvisedChain advised("$$\\frac{a^2 - b^2}{a - b} = a + b$$", "");
  const ExprTree& tree = advised.reading.forms.tree;
  const std::vector<double> costs{5, 1};
  CHECK(advise_forms(*advised.space, tree, costs, 1));
  CHECK_FALSE(advise_forms(*advised.space, tree, costs, 1, 1));
}

}  // namespace rigor
