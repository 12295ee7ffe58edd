// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/advice/range.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {
namespace {

struct SizesInTens {
  double least = 0;  // decimal exponents
  double most = 0;
};

/// Products of n letters leave the range of double at 10^(308/n).
constexpr auto symmetric_sizes = std::to_array<double>({150, 100, 75, 50, 30, 20, 12});
/// An argument of a sine is seldom more than some turns, and one of an exponential less than 700.
constexpr auto upper_sizes = std::to_array<double>({500, 100, 10, 8, 4, 2, 1});
constexpr auto bounds_of_size =
    std::to_array<double>({1, 2, 4, 10, 100, 500, 0.5, 0.1, 1e-2, 1e-4, 1e4, 1e8});

double size_of_letter(const SearchedLetter& letter, const Point& point) {
  double size = 0;
  for (std::size_t k = 0; k < letter.components.size(); ++k)
    size = std::max(size, std::abs(point[letter.first + k]));
  return size;
}

bool has_sizes(const SearchSpace& space, const Range& range, const Point& point) {
  for (const SearchedLetter& letter : space.letters) {
    if (letter.drawn) continue;
    for (std::size_t k = 0; k < letter.components.size(); ++k) {
      const double size = std::abs(point[letter.first + k]);
      if (size != 0 && (size < range.least || size > range.most)) return false;
    }
  }
  return true;
}

bool is_in_first(const SearchSpace& space, const Half& half, const Point& point) {
  const SearchedLetter& letter = space.letters[half.letter];
  switch (half.by) {
    case Half::By::sign:
      return point[letter.first] > 0;
    case Half::By::size:
      return size_of_letter(letter, point) < half.bound;
    case Half::By::larger:
      return size_of_letter(letter, point) < size_of_letter(space.letters[half.other], point);
  }
  return false;
}

std::string text_of_half(const ExprTree& tree, const SearchSpace& space, const Half& half) {
  const std::string& name = tree.symbols[space.letters[half.letter].symbol].name;
  switch (half.by) {
    case Half::By::sign:
      return fmt::format("where {} {} 0", name, half.first ? ">" : "<");
    case Half::By::size:
      return fmt::format("where |{}| {} {:g}", name, half.first ? "<" : "≥", half.bound);
    case Half::By::larger:
      return fmt::format("where |{}| {} |{}|", name, half.first ? "<" : "≥",
                         tree.symbols[space.letters[half.other].symbol].name);
  }
  return {};
}

}  // namespace

bool contains(const SearchSpace& space, const Range& range, const Point& point) {
  if (range.half && is_in_first(space, *range.half, point) != range.half->first) return false;
  return has_sizes(space, range, point) != range.beyond;
}

std::vector<Range> ranges_of_sizes() {
  std::vector<Range> ranges{Range{}};
  const auto both = [&](double tens) {
    ranges.push_back({.least = std::pow(10.0, -tens), .most = std::pow(10.0, tens)});
  };
  for (const double tens : symmetric_sizes) both(tens);
  for (const double most : upper_sizes) {
    for (const double tens : {300.0, 75.0, 30.0})
      ranges.push_back({.least = tens > 200 ? 0 : std::pow(10.0, -tens), .most = most});
  }
  for (const double tens : {6.0, 3.0}) both(tens);
  return ranges;
}

std::vector<Half> halves_of(const SearchSpace& space, const ExprTree& tree) {
  std::vector<Half> halves;
  std::vector<std::size_t> searched;
  for (std::size_t k = 0; k < space.letters.size(); ++k) {
    if (space.letters[k].drawn) continue;
    searched.push_back(k);
    if (tree.symbols[space.letters[k].symbol].rank == 0) halves.push_back({Half::By::sign, k});
  }
  for (const double bound : bounds_of_size) {
    for (const std::size_t k : searched) halves.push_back({Half::By::size, k, k, bound});
  }
  for (const std::size_t k : searched) {
    for (const std::size_t other : searched)
      if (k < other) halves.push_back({Half::By::larger, k, other});
  }
  return halves;
}

std::string text_of(const ExprTree& tree, const SearchSpace& space, const Range& range) {
  std::string text;
  if (!range.has_all_sizes()) {
    if (range.beyond)
      text = " beyond that";
    else if (range.least == 0)
      text = fmt::format(" for numbers up to {:g}", range.most);
    else
      text = fmt::format(" for numbers from {:g} to {:g}", range.least, range.most);
  }
  if (range.half) text += " " + text_of_half(tree, space, *range.half);
  return text;
}

}  // namespace rigor
