// SPDX-License-Identifier: GPL-3.0-or-later
// The points that an attack looks at.
#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/advice/attack.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

constexpr double all_exponents = 996;  // of 2: 1e±300
constexpr int bits_of_double = 52;
constexpr std::size_t probes = 24;  // along a line, for a zero
constexpr std::size_t bisections = 60;
constexpr std::array<double, 3> spans{1, 8, 60};  // of a line, in powers of 2
constexpr double nearly_overflows = 0x1p1023;

/// 2^exponent, times a number from 1 to 2. The same on every machine.
double of_size(double exponent, SplitMix& bits) {
  return std::ldexp(1 + uniform(bits), static_cast<int>(std::floor(exponent)));
}

double least_exponent(const Range& range) {
  if (range.least == 0 || range.beyond) return -all_exponents;
  return std::max(-all_exponents, std::ceil(std::log2(range.least)));
}
double most_exponent(const Range& range) {
  if (range.has_all_sizes() || range.beyond) return all_exponents;
  return std::min(all_exponents, std::floor(std::log2(range.most)) - 1);
}

}  // namespace

double Attacker::between(double a, double b) { return a + (b - a) * uniform(bits_); }

/// 1 ± ε, ε from 2^-52 to 1.
double Attacker::near_one() {
  const double small = of_size(-1 - static_cast<double>(bits_.below(bits_of_double)), bits_);
  return bits_.below(2) == 0 ? 1 + small / 2 : 1 - small / 2;
}

/// Any, until the conditions have been met; then one that has met them.
double Attacker::sign_for(std::size_t place) {
  const bool plus = positive_[place];
  const bool minus = negative_[place];
  if (plus != minus && bits_.below(16) != 0) return plus ? 1 : -1;
  return bits_.below(2) == 0 ? 1 : -1;
}

double Attacker::any_special() { return specials_[bits_.below(specials_.size())]; }

const SearchedLetter& Attacker::any_letter() { return *letters_[bits_.below(letters_.size())]; }

void Attacker::draw_letter(Point& point, const SearchedLetter& letter, double exponent) {
  const bool spread = bits_.below(4) == 0;  // each component of a size of its own
  for (std::size_t k = 0; k < letter.components.size(); ++k) {
    const double own = spread ? exponent - static_cast<double>(bits_.below(20)) : exponent;
    double size = of_size(own, bits_);
    if (letter.components.size() > 1 && !spread) size *= uniform(bits_) + 0x1p-20;
    point[letter.first + k] = sign_for(letter.first + k) * size;
  }
}

/// One letter is nearly another one, or a sum of two; of vectors, nearly parallel to it.
void Attacker::make_nearly_equal(Point& point) {
  const SearchedLetter& one = any_letter();
  const SearchedLetter& other = any_letter();
  const SearchedLetter& third = any_letter();
  const std::size_t count = one.components.size();
  if (other.components.size() != count || &one == &other) return;
  const bool sums = third.components.size() == count && &third != &one && bits_.below(3) == 0;
  const double sign = bits_.below(2) == 0 ? 1 : -1;
  const double scale = count > 1 && bits_.below(2) == 0 ? of_size(between(-3, 3), bits_) : 1;
  for (std::size_t k = 0; k < count; ++k) {
    double value = point[other.first + k];
    if (sums) value += sign * point[third.first + k];
    point[one.first + k] = value * scale * near_one();
  }
}

/// The exponent of a size outside a range.
double Attacker::just_beyond(const Range& range) {
  const double further = between(-4, 40);
  const bool below = range.least > 0 && bits_.below(2) == 0;
  return below ? std::ceil(std::log2(range.least)) - further : std::floor(std::log2(range.most)) + further;
}

Point Attacker::draw(const Range& range) {
  Point point = space_.drawn[bits_.below(space_.drawn.size())];
  const double least = least_exponent(range);
  const double most = std::max(least, most_exponent(range));
  const std::size_t kind = bits_.below(8);
  const bool at_edge = range.beyond && bits_.below(2) == 0;
  const double middle = at_edge ? just_beyond(range)
                                : std::clamp(kind == 2 ? between(-4, 4) : between(least, most), least, most);
  const double width = bits_.below(2) == 0 ? 1 : 12;
  const std::size_t long_one = bits_.below(letters_.size());
  const bool others_short = bits_.below(2) == 0;
  for (std::size_t k = 0; k < letters_.size(); ++k) {
    double exponent = std::clamp(middle + between(-width, width), least, most);
    if (kind < 2) exponent = between(least, most);
    if (kind == 3) {
      const bool at_top = (k == long_one) == others_short;
      exponent = at_top ? std::max(least, most - between(0, 30)) : std::min(most, least + between(0, 30));
    }
    draw_letter(point, *letters_[k], exponent);
  }
  if (kind == 4 && least <= 0 && most >= 0) {
    for (const SearchedLetter* letter : letters_) {
      for (std::size_t k = 0; k < letter->components.size(); ++k) {
        const auto whole = static_cast<double>(bits_.below(9) + 1);
        const bool zero = letter->components.size() > 1 && bits_.below(4) == 0;
        point[letter->first + k] = zero ? 0 : sign_for(letter->first + k) * whole;
      }
    }
  }
  if (kind >= 5 && bits_.below(3) == 0) {
    const SearchedLetter& letter = any_letter();
    const std::size_t place = letter.first + bits_.below(letter.components.size());
    point[place] = sign_for(place) * any_special() * near_one();
  }
  if (kind >= 5) make_nearly_equal(point);
  if (kind == 7) make_nearly_equal(point);
  return point;
}

void Attacker::mutate(Point& point, const Range& range) {
  const SearchedLetter& letter = any_letter();
  const std::size_t place = letter.first + bits_.below(letter.components.size());
  const auto scale_letter = [&](const SearchedLetter& each, double factor) {
    for (std::size_t k = 0; k < each.components.size(); ++k) point[each.first + k] *= factor;
  };
  switch (bits_.below(12)) {
    case 0:
      return scale_letter(letter, std::ldexp(1.0, static_cast<int>(between(-40, 40))));
    case 1:
      return scale_letter(letter, of_size(between(-3, 3), bits_));
    case 2:
      point[place] = -point[place];
      return;
    case 3:
    case 4:
      return make_nearly_equal(point);
    case 5:
      point[place] *= near_one();
      return;
    case 6:
      point[place] = sign_for(place) * any_special() * near_one();
      return;
    case 7: {
      const double factor = of_size(between(-30, 30), bits_);
      for (const SearchedLetter* each : letters_) scale_letter(*each, factor);
      return;
    }
    case 8:
      return draw_letter(point, letter, between(least_exponent(range), most_exponent(range)));
    case 9: {
      const SearchedLetter& other = any_letter();
      if (&other != &letter) scale_letter(other, point[place] == 0 ? 2 : std::abs(near_one()) * 0.5);
      return;
    }
    default:
      return go_to_edge(point);
  }
}

double Attacker::value_along(const Line& line, Point& point, double x) {
  Form& form = *line.form;
  point[line.place] = x;
  for (std::size_t k = 0; k < form.places.size(); ++k) form.inputs[k] = point[form.places[k]];
  work_ += form.code->values.size();
  form.values.run(form.inputs);
  const double value = form.values[line.value];
  if (!line.to_overflow) return value;
  return std::abs(value) < nearly_overflows ? -1 : 1;
}

/// Along one number of a point, to where a value of some form is 0 or overflows.
std::optional<Attacker::Line> Attacker::any_line() {
  Form& form = forms_[bits_.below(forms_.size())];
  if (form.places.empty()) return std::nullopt;
  Line line{.form = &form, .value = 0, .place = form.places[bits_.below(form.places.size())]};
  line.to_overflow = form.sums.empty() || bits_.below(4) == 0;
  line.value = line.to_overflow ? static_cast<ValueId>(bits_.below(form.code->values.size()))
                                : form.sums[bits_.below(form.sums.size())];
  return line;
}

/// Between two neighbours of other signs.
double Attacker::crossing(const Line& line, Point& point, double low, double high, bool rises) {
  for (std::size_t n = 0; n < bisections; ++n) {
    const double middle = low + (high - low) / 2;
    ((value_along(line, point, middle) < 0) == rises ? low : high) = middle;
  }
  return low;
}

/// A zero that is touched, not crossed: 1 − cos x.
double Attacker::lowest(const Line& line, Point& point, double low, double high) {
  for (std::size_t n = 0; n < bisections; ++n) {
    const double third = (high - low) / 3;
    const double left = std::abs(value_along(line, point, low + third));
    const double right = std::abs(value_along(line, point, high - third));
    (left < right ? high : low) = left < right ? high - third : low + third;
  }
  return low + (high - low) / 2;
}

/// Moves one number to where a value of some form is 0, or least in size, or overflows, and a little away
/// from it.
void Attacker::go_to_edge(Point& point) {
  const auto line = any_line();
  if (!line || point[line->place] == 0) return;
  const double start = point[line->place];
  const double span = spans[bits_.below(spans.size())];
  std::array<double, probes> at{};
  std::array<double, probes> value{};
  std::size_t least = 0;
  for (std::size_t k = 0; k < probes; ++k) {
    const double step = span * (2 * static_cast<double>(k) / (probes - 1) - 1);
    const double whole = std::floor(step);
    at[k] = start * std::ldexp(1 + (step - whole) + 0.01 * uniform(bits_), static_cast<int>(whole));
    value[k] = value_along(*line, point, at[k]);
    if (std::abs(value[k]) < std::abs(value[least])) least = k;
  }
  for (std::size_t k = 0; k + 1 < probes; ++k) {
    if (!(value[k] * value[k + 1] < 0)) continue;
    const double edge = crossing(*line, point, at[k], at[k + 1], value[k] < 0);
    point[line->place] = edge * (bits_.below(4) == 0 ? 1 : near_one());
    return;
  }
  if (line->to_overflow)
    point[line->place] = start;
  else
    point[line->place] =
        near_one() * lowest(*line, point, at[least > 0 ? least - 1 : 0], at[std::min(least + 1, probes - 1)]);
}

}  // namespace rigor
