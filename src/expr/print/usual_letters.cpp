// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/print/usual_letters.h"

#include "base/among.h"

namespace rigor {
namespace {

constexpr std::string_view coefficients[] = {"a",      "b",       "c",        "d",   "k", "m",
                                             "M",      "n",       "N",        "p",   "q", "\\alpha",
                                             "\\beta", "\\gamma", "\\lambda", "\\mu"};
constexpr std::string_view coordinates[] = {"t", "x", "y", "z", "r", "s", "u", "\\theta", "\\phi", "\\tau"};

}  // namespace

bool is_usual_coefficient(std::string_view letter) { return is_one_of(letter, coefficients); }

bool is_usual_coordinate(std::string_view letter) { return is_one_of(letter, coordinates); }

}  // namespace rigor
