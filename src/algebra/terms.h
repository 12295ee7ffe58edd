// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions of GiNaC taken apart. Its order of terms and factors differs from run to run.
#pragma once

#include <ginac/ginac.h>

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

/// The numeric factor of a term.
[[nodiscard]] inline GiNaC::numeric coefficient_of(const GiNaC::ex& term) {
  for (const GiNaC::ex& factor : factors_of(term)) {
    if (is_number(factor)) return GiNaC::ex_to<GiNaC::numeric>(factor);
  }
  return 1;
}

}  // namespace rigor
