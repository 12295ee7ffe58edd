// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/usual_letters.h"

#include <algorithm>
#include <iterator>

namespace rigor {
namespace {

constexpr std::string_view coefficients[] = {"a",      "b",       "c",        "d",   "k", "m",
                                             "M",      "n",       "N",        "p",   "q", "\\alpha",
                                             "\\beta", "\\gamma", "\\lambda", "\\mu"};
constexpr std::string_view coordinates[] = {"t", "x", "y", "z", "r", "s", "u", "\\theta", "\\phi", "\\tau"};

}  // namespace

bool is_usual_coefficient(std::string_view letter) {
  return std::find(std::begin(coefficients), std::end(coefficients), letter) != std::end(coefficients);
}

bool is_usual_coordinate(std::string_view letter) {
  return std::find(std::begin(coordinates), std::end(coordinates), letter) != std::end(coordinates);
}

}  // namespace rigor
