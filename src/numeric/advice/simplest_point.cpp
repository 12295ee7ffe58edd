// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/advice/simplest_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

namespace rigor {
namespace {

constexpr double kept_digits = 0.75;   // of those that are lost
constexpr int ordinary_exponent = 20;  // of 2
constexpr std::array<int, 6> digits_tried{1, 2, 4, 8, 11, 14};

/// The number with so many decimal digits.
double rounded(double x, int digits) {
  return std::strtod(fmt::format("{:.{}e}", x, digits - 1).c_str(), nullptr);
}

class Simplification {
 public:
  Simplification(Attacker& attacker, const SearchSpace& space, std::size_t form, const Range& range,
                 const LosingPoint& found)
      : attacker_(attacker),
        space_(space),
        form_(form),
        range_(range),
        best_(found),
        enough_(std::max(std::pow(found.loss, kept_digits), std::min(found.loss, no_loss))) {}

  [[nodiscard]] LosingPoint simplified() {
    scale_to_one();
    simplify_together();
    for (const SearchedLetter& letter : space_.letters) {
      for (std::size_t k = 0; k < letter.components.size() && !letter.drawn; ++k)
        simplify(letter, letter.first + k);
    }
    return best_;
  }

 private:
  bool take(Point point) {
    if (point == best_.point) return true;
    if (!contains(space_, range_, point)) return false;
    const auto errors = attacker_.errors_at(point);
    if (!errors || errors->loss(form_) < enough_) return false;
    best_ = {std::move(point), errors->loss(form_)};
    return true;
  }

  /// The same with numbers around 1, where only their ratios matter.
  void scale_to_one() {
    double size = 0;
    for (const SearchedLetter& letter : space_.letters) {
      for (std::size_t k = 0; k < letter.components.size() && !letter.drawn; ++k)
        size = std::max(size, std::abs(best_.point[letter.first + k]));
    }
    if (size == 0) return;
    Point point = best_.point;
    for (const SearchedLetter& letter : space_.letters) {
      for (std::size_t k = 0; k < letter.components.size() && !letter.drawn; ++k)
        point[letter.first + k] = std::ldexp(point[letter.first + k], -std::ilogb(size));
    }
    static_cast<void>(take(std::move(point)));
  }

  /// Numbers that nearly agree only show it together.
  void simplify_together() {
    for (const int digits : digits_tried) {
      Point point = best_.point;
      for (const SearchedLetter& letter : space_.letters) {
        for (std::size_t k = 0; k < letter.components.size() && !letter.drawn; ++k)
          point[letter.first + k] = rounded(point[letter.first + k], digits);
      }
      if (take(std::move(point))) return;
    }
  }

  void simplify(const SearchedLetter& letter, std::size_t place) {
    const auto with = [&](double x) {
      Point point = best_.point;
      point[place] = x;
      return take(std::move(point));
    };
    double now = best_.point[place];
    if (now == 0 || (letter.components.size() > 1 && with(0))) return;
    const double sign = std::copysign(1.0, now);
    if (with(1) || with(sign)) return;
    while (std::abs(std::ilogb(best_.point[place])) > ordinary_exponent &&
           with(sign * std::ldexp(1.0, std::ilogb(best_.point[place]) / 2))) {
    }
    now = best_.point[place];
    for (const int digits : digits_tried) {
      if (with(rounded(std::abs(now), digits)) || with(rounded(now, digits))) return;
    }
  }

  Attacker& attacker_;
  const SearchSpace& space_;
  std::size_t form_;
  const Range& range_;
  LosingPoint best_;
  double enough_;
};

}  // namespace

LosingPoint simplest_point(Attacker& attacker, const SearchSpace& space, std::size_t form, const Range& range,
                           const LosingPoint& found) {
  return Simplification(attacker, space, form, range, found).simplified();
}

}  // namespace rigor
