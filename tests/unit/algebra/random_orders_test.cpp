// SPDX-License-Identifier: GPL-3.0-or-later
// Random orders and equations with roots against plain doubles: what is proved may fail at no point. The
// doubles are computed beside the trees, by nothing of ours.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "algebra/verdict.h"
#include "base/splitmix.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

namespace {

constexpr std::size_t scalar_count = 3;
constexpr std::size_t particle_count = 3;

/// Three scalars, two vectors, and a number for each of three particles; which of these the free ones are.
struct Point {
  std::array<double, scalar_count> scalars;
  std::array<std::array<double, 3>, 2> vectors;
  std::array<double, particle_count> numbers;
  std::array<std::size_t, 2> free;
};

/// An expression and what it is worth; not a number where it has no value.
struct Drawn {
  Term term;
  std::function<double(const Point&)> at;
  std::string text;
};

[[nodiscard]] Point draw_point(SplitMix& random);

enum class Finding : std::uint8_t { holds, fails, open };
[[nodiscard]] Finding related(double left, Relation relation, double right);

class Statements {
 public:
  /// `products`: the sides share a factor, so that the difference is a product.
  explicit Statements(std::uint64_t seed, bool products) : random_(seed), products_(products) {}

  struct Assumed {
    Drawn left;
    Relation relation;
    Drawn right;
  };

  void draw() {
    static const std::vector<std::string> letters{"a", "b", "c"};
    for (const std::string& letter : letters) scalars_.push_back(page.scalar(letter));
    for (const char* letter : {"A", "B"}) vectors_.push_back(page.vector(letter));
    numbers_ = page.scalars("x");
    free_ = {page.particle("\\alpha"), page.particle("\\beta")};
    summed_ = page.particle("\\gamma");
    particles_ = random_.below(4) == 0;
    for (std::size_t count = random_.below(3); count-- > 0;) {
      Assumed order{atom(), relation(false), random_.below(2) == 0 ? number(random_.below(2)) : atom()};
      const bool named = has_particle(order.left) || has_particle(order.right);
      if (named) continue;
      page.given(order.left.term, order.relation, order.right.term);
      assumed.push_back(order);
    }
    // Most random orders are false at once; one that holds at a few points is worth a question.
    for (int attempt = 0; attempt < 60; ++attempt) {
      left = expression(random_.below(2) == 0 ? 2 : 3);
      right = random_.below(3) == 0 ? number(0) : expression(2);
      if (products_) share_a_factor();
      claimed = relation(true);
      if (holds_at_a_few_points()) break;
    }
    const std::vector<ParticleId> named =
        particles_ ? std::vector<ParticleId>{free_[0], free_[1]} : std::vector<ParticleId>{};
    page.claim(left.term, claimed, right.term, named);
  }

  Page page;
  Drawn left;
  Drawn right;
  Relation claimed = Relation::equal;
  std::vector<Assumed> assumed;

 private:
  void share_a_factor() {
    const Drawn factor = expression(1);
    for (Drawn* side : {&left, &right}) {
      const Drawn other = expression(1);
      *side = {factor.term * other.term,
               [factor, other](const Point& p) { return factor.at(p) * other.at(p); },
               "(" + factor.text + ")(" + other.text + ")"};
    }
  }

  bool holds_at_a_few_points() {
    SplitMix points(random_.next());
    int held = 0;
    for (int k = 0; k < 24; ++k) {
      const Point point = draw_point(points);
      const bool met = std::all_of(assumed.begin(), assumed.end(), [&](const Assumed& each) {
        return related(each.left.at(point), each.relation, each.right.at(point)) == Finding::holds;
      });
      const Finding found = met ? related(left.at(point), claimed, right.at(point)) : Finding::open;
      if (found == Finding::fails) return false;
      held += found == Finding::holds ? 1 : 0;
    }
    return held > 3;
  }

  static bool has_particle(const Drawn& each) { return each.text.find('x') != std::string::npos; }

  Relation relation(bool equations) {
    constexpr std::array all{Relation::less, Relation::less_or_equal, Relation::less_or_equal,
                             Relation::unequal, Relation::equal};
    return all[random_.below(equations ? 5 : 4)];
  }

  Drawn number(std::size_t value) {
    return {page.number(std::to_string(value)), [value](const Point&) { return static_cast<double>(value); },
            std::to_string(value)};
  }

  Drawn atom() {
    const std::size_t choice = random_.below(particles_ ? 7 : 5);
    if (choice < scalar_count)
      return {scalars_[choice], [choice](const Point& p) { return p.scalars[choice]; },
              std::string(1, static_cast<char>('a' + choice))};
    if (choice == 3)
      return {dot(vectors_[0], vectors_[1]),
              [](const Point& p) {
                double sum = 0;
                for (std::size_t i = 0; i < 3; ++i) sum += p.vectors[0][i] * p.vectors[1][i];
                return sum;
              },
              "A.B"};
    if (choice == 4) {
      const std::size_t which = random_.below(2);
      return {length(vectors_[which]),
              [which](const Point& p) {
                double sum = 0;
                for (const double each : p.vectors[which]) sum += each * each;
                return std::sqrt(sum);
              },
              which == 0 ? "|A|" : "|B|"};
    }
    const std::size_t which = random_.below(2);
    return {numbers_(free_[which]), [which](const Point& p) { return p.numbers[p.free[which]]; },
            which == 0 ? "x_1" : "x_2"};
  }

  Drawn sum_over_particles() {
    const bool squared = random_.below(2) == 0;
    Term body = numbers_(summed_);
    if (squared) body = pow(body, 2);
    return {over(summed_, body),
            [squared](const Point& p) {
              double sum = 0;
              for (const double each : p.numbers) sum += squared ? each * each : each;
              return sum;
            },
            squared ? "Sum x^2" : "Sum x"};
  }

  Drawn expression(int depth) {
    if (depth == 0) return random_.below(5) == 0 ? number(1 + random_.below(2)) : atom();
    switch (random_.below(particles_ ? 10 : 9)) {
      case 0:
      case 1: {
        const Drawn a = expression(depth - 1);
        const Drawn b = expression(depth - 1);
        return {a.term + b.term, [a, b](const Point& p) { return a.at(p) + b.at(p); },
                "(" + a.text + " + " + b.text + ")"};
      }
      case 2: {
        const Drawn a = expression(depth - 1);
        const Drawn b = expression(depth - 1);
        return {a.term - b.term, [a, b](const Point& p) { return a.at(p) - b.at(p); },
                "(" + a.text + " - " + b.text + ")"};
      }
      case 3:
      case 4: {
        const Drawn a = expression(depth - 1);
        const Drawn b = expression(depth - 1);
        return {a.term * b.term, [a, b](const Point& p) { return a.at(p) * b.at(p); }, a.text + "*" + b.text};
      }
      case 5: {
        const Drawn a = expression(depth - 1);
        return {absolute(a.term), [a](const Point& p) { return std::abs(a.at(p)); }, "|" + a.text + "|"};
      }
      case 6: {
        const Drawn a = expression(depth - 1);
        const int exponent = 2 + static_cast<int>(random_.below(2));
        return {pow(a.term, exponent), [a, exponent](const Point& p) { return std::pow(a.at(p), exponent); },
                "(" + a.text + ")^" + std::to_string(exponent)};
      }
      case 7: {
        const Drawn a = expression(depth - 1);
        return {root(a.term), [a](const Point& p) { return std::sqrt(a.at(p)); }, "root(" + a.text + ")"};
      }
      case 8: {
        const Drawn a = expression(depth - 1);
        const Drawn b = expression(depth - 1);
        return {a.term / b.term,
                [a, b](const Point& p) {
                  const double divisor = b.at(p);
                  return std::abs(divisor) < 1e-9 ? std::nan("") : a.at(p) / divisor;
                },
                "(" + a.text + ")/(" + b.text + ")"};
      }
      default:
        return sum_over_particles();
    }
  }

  SplitMix random_;
  bool products_;
  bool particles_ = false;
  std::vector<Named> scalars_;
  std::vector<Named> vectors_;
  Named numbers_;
  std::array<ParticleId, 2> free_{};
  ParticleId summed_{};
};

/// Small whole numbers as a rule, so that equal is equal; many of them 0, 1 and -1.
Point draw_point(SplitMix& random) {
  const bool tiny = random.below(3) == 0;
  const auto number = [&] {
    const double whole = static_cast<double>(random.below(tiny ? 3 : 9)) - (tiny ? 1 : 4);
    return random.below(4) == 0 ? whole / 2 : whole;
  };
  Point point{};
  for (double& each : point.scalars) each = number();
  for (auto& vector : point.vectors) {
    for (double& each : vector) each = random.below(2) == 0 ? 0 : number();
  }
  for (double& each : point.numbers) each = number();
  point.free = {random.below(particle_count), random.below(particle_count)};
  return point;
}

Finding related(double left, Relation relation, double right) {
  const double error = 1e-9 * (1 + std::abs(left) + std::abs(right));
  if (!std::isfinite(left) || !std::isfinite(right)) return Finding::open;
  const bool near = std::abs(left - right) <= error;
  if (near && left != right && relation != Relation::equal) return Finding::open;
  const auto found = [](bool holds) { return holds ? Finding::holds : Finding::fails; };
  switch (relation) {
    case Relation::equal:
      return found(near);
    case Relation::unequal:
      return found(left != right);
    case Relation::less:
      return found(left < right);
    case Relation::less_or_equal:
      return found(left <= right);
  }
  return Finding::open;
}

struct Tally {
  std::size_t proved = 0;
  std::size_t refuted = 0;
  std::size_t wrong = 0;
};

void look_at(std::uint64_t seed, Tally& tally, bool products = false) {
  Statements drawn(seed, products);
  drawn.draw();
  const Decision decision = decide(drawn.page.question, {.simplest_sample = false});
  if (decision.outcome == Outcome::refuted) ++tally.refuted;
  if (decision.outcome != Outcome::proved) return;
  ++tally.proved;
  SplitMix random(seed ^ 0x706f696e74);
  for (int k = 0; k < 300; ++k) {
    const Point point = draw_point(random);
    bool met = true;
    for (const Statements::Assumed& each : drawn.assumed)
      met = met && related(each.left.at(point), each.relation, each.right.at(point)) == Finding::holds;
    if (!met || related(drawn.left.at(point), drawn.claimed, drawn.right.at(point)) != Finding::fails)
      continue;
    ++tally.wrong;
    std::string given;
    constexpr std::array signs{"=", "<", "<=", "!="};
    for (const Statements::Assumed& each : drawn.assumed)
      given += each.left.text + " " + signs[static_cast<std::size_t>(each.relation)] + " " + each.right.text +
               "; ";
    UNSCOPED_INFO("seed " << seed << ": given " << given << drawn.left.text << " "
                          << signs[static_cast<std::size_t>(drawn.claimed)] << " " << drawn.right.text
                          << " at a = " << point.scalars[0] << ", b = " << point.scalars[1]
                          << ", c = " << point.scalars[2]);
    FAIL_CHECK("a statement is proved that fails");
    return;
  }
}

}  // namespace

TEST_CASE("no random order that is proved fails at a point", "[algebra]") {
  const char* wanted = std::getenv("RIGOR_RANDOM_ORDERS");
  const std::uint64_t count = wanted == nullptr ? 250 : std::strtoull(wanted, nullptr, 10);
  Tally tally;
  for (std::uint64_t seed = 1; seed <= count; ++seed) look_at(seed, tally);
  std::printf("%llu random orders: %zu proved, %zu refuted, %zu wrong\n",
              static_cast<unsigned long long>(count), tally.proved, tally.refuted, tally.wrong);
  CHECK(tally.proved > count / 20);
}

TEST_CASE("no random order of products with a common factor that is proved fails at a point", "[algebra]") {
  const char* wanted = std::getenv("RIGOR_RANDOM_ORDERS");
  const std::uint64_t count = wanted == nullptr ? 150 : std::strtoull(wanted, nullptr, 10);
  Tally tally;
  for (std::uint64_t seed = 1; seed <= count; ++seed) look_at(seed, tally, true);
  std::printf("%llu random orders of products: %zu proved, %zu refuted, %zu wrong\n",
              static_cast<unsigned long long>(count), tally.proved, tally.refuted, tally.wrong);
  CHECK(tally.proved > count / 20);
}
