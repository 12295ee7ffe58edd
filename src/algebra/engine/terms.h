// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions of GiNaC taken apart. Its order of terms and factors differs from run to run.
#pragma once

#include <ginac/ginac.h>

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rigor {

[[nodiscard]] inline bool is_number(const GiNaC::ex& value) { return GiNaC::is_a<GiNaC::numeric>(value); }

/// The terms of a sum; anything else is one term.
[[nodiscard]] inline std::vector<GiNaC::ex> terms_of(const GiNaC::ex& value) {
  if (!GiNaC::is_a<GiNaC::add>(value)) return {value};
  return {value.begin(), value.end()};
}

/// The factors of a product as GiNaC holds it, unexpanded; anything else is one factor.
[[nodiscard]] inline std::vector<GiNaC::ex> factors_of(const GiNaC::ex& value) {
  if (!GiNaC::is_a<GiNaC::mul>(value)) return {value};
  return {value.begin(), value.end()};
}

/// Base and exponent of a factor; 1 where it is no integer power.
[[nodiscard]] inline std::pair<GiNaC::ex, int> split_power(const GiNaC::ex& factor) {
  const bool is_power = GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::integer);
  if (!is_power) return {factor, 1};
  return {factor.op(0), GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int()};
}

/// The highest exponent of each base in an expanded polynomial. One pass: GiNaC's `degree` is one for each
/// letter that is asked for.
using Degrees = std::unordered_map<GiNaC::ex, int>;
[[nodiscard]] inline Degrees degrees_of(const GiNaC::ex& expanded) {
  Degrees degrees;
  for (const GiNaC::ex& term : terms_of(expanded)) {
    for (const GiNaC::ex& factor : factors_of(term)) {
      if (is_number(factor)) continue;
      const auto [base, exponent] = split_power(factor);
      int& known = degrees[base];
      known = std::max(known, exponent);
    }
  }
  return degrees;
}
[[nodiscard]] inline int degree_in(const Degrees& degrees, const GiNaC::ex& letter) {
  const auto known = degrees.find(letter);
  return known == degrees.end() ? 0 : known->second;
}

/// The numeric factor of a term.
[[nodiscard]] inline GiNaC::numeric coefficient_of(const GiNaC::ex& term) {
  for (const GiNaC::ex& factor : factors_of(term)) {
    if (is_number(factor)) return GiNaC::ex_to<GiNaC::numeric>(factor);
  }
  return 1;
}

}  // namespace rigor
