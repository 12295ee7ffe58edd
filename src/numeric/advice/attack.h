// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the point of a range where a form loses most on the best form there. It begins with points
// of many kinds: all sizes, one letter long in turn, nearly equal letters, whole numbers. The worst of them
// climb: a letter gets longer or shorter, changes its sign, nearly equals another one, or goes to a zero of a
// sum that some form takes on its way. The same seed gives the same points.
#pragma once

#include <optional>
#include <vector>

#include "base/splitmix.h"
#include "numeric/advice/expected_error.h"
#include "numeric/advice/range.h"
#include "numeric/advice/search_space.h"

namespace rigor {

/// A form loses on another by the quotient of their errors, of which the least one is taken as 2 u at least.
/// Up to so much does not count.
inline constexpr double no_loss = 4;

/// An error counts as far as it is expected and double shows it: where numbers are exact by their nature, as
/// 1 − x next to 1, nothing is lost. The least one is an expected one, so that no luck goes into it.
struct PointErrors {
  std::vector<double> of_form;  // relative, from u to 1
  double least = 1;
  [[nodiscard]] double loss(std::size_t form) const { return of_form[form] / least; }
};

struct LosingPoint {
  Point point;
  double loss = 1;
};

/// How hard to look, and for what.
struct Aim {
  std::size_t effort = 1;
  bool refutes = false;  // ends where a loss is found that counts
  /// A loss that numbers of ordinary size show goes before one that takes extreme ones. The points at which
  /// the form is known to lose are looked at, too.
  bool ordinary = false;
};

class Attacker {
 public:
  Attacker(const SearchSpace& space, std::uint64_t seed);

  /// Nothing where a condition is not met for sure, a form has no real value, or a number or the value is
  /// beyond the normal range of double; nor where the value is 0.
  [[nodiscard]] std::optional<PointErrors> errors_at(const Point& point);
  /// The greatest loss of a form within a range that is found. Nothing where no point of the range was met.
  [[nodiscard]] std::optional<LosingPoint> worst(std::size_t form, const Range& range, const Aim& aim);

  /// Operations so far, but for those of conditions.
  [[nodiscard]] std::size_t work() const { return work_; }
  /// Points at which a form loses, of all that were looked at.
  [[nodiscard]] const std::vector<Point>& losing_points(std::size_t form) const { return losing_[form]; }

 private:
  struct Climber {
    LosingPoint at;
    double score = 0;  // what climbs
  };
  struct Form {
    const Code* code;
    ErrorTape tape;
    ValuesAtPoint<double> values;
    std::vector<std::size_t> places;
    std::vector<double> inputs;
    std::vector<ValueId> sums;  // where digits cancel
  };

  /// One number of a point changes, and a value of a form with it.
  struct Line {
    Form* form = nullptr;
    ValueId value = 0;
    std::size_t place = 0;  // of the point
    bool to_overflow = false;
  };

  [[nodiscard]] std::optional<Climber> climber_at(Point point, std::size_t form, const Range& range,
                                                  const Aim& aim);
  [[nodiscard]] std::vector<Climber> known_losing(std::size_t form, const Range& range, const Aim& aim);
  void note_losses(const Point& point, const PointErrors& errors);

  [[nodiscard]] Point draw(const Range& range);
  [[nodiscard]] double just_beyond(const Range& range);
  void draw_letter(Point& point, const SearchedLetter& letter, double exponent);
  void make_nearly_equal(Point& point);
  void mutate(Point& point, const Range& range);
  void go_to_edge(Point& point);
  [[nodiscard]] std::optional<Line> any_line();
  [[nodiscard]] double crossing(const Line& line, Point& point, double low, double high, bool rises);
  [[nodiscard]] double lowest(const Line& line, Point& point, double low, double high);
  [[nodiscard]] double value_along(const Line& line, Point& point, double x);
  [[nodiscard]] double sign_for(std::size_t place);
  [[nodiscard]] double near_one();
  [[nodiscard]] double between(double a, double b);
  [[nodiscard]] double any_special();
  [[nodiscard]] const SearchedLetter& any_letter();

  const SearchSpace& space_;
  SplitMix bits_;
  ConditionsAtPoint conditions_;
  std::vector<Form> forms_;
  std::vector<const SearchedLetter*> letters_;  // that are searched
  std::vector<double> specials_;  // numbers of the forms, quarter turns, and where exponentials overflow
  std::vector<bool> positive_;    // by place of a point: has met the conditions with this sign
  std::vector<bool> negative_;
  std::vector<std::vector<Point>> losing_;
  std::size_t work_ = 0;
};

}  // namespace rigor
