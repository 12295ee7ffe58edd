// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/division.h"

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <tuple>

#include "algebra/expansion.h"
#include "algebra/fraction.h"
#include "algebra/line_image.h"
#include "algebra/terms.h"

namespace rigor {

using GiNaC::ex;

namespace {

/// By degree, as GiNaC has them, and then by their creation, which their names' numbers count: what sqrfree
/// takes apart depends on the order, and GiNaC's own differs from run to run.
[[nodiscard]] GiNaC::lst letters_in_order(const ex& value) {
  std::map<std::tuple<int, std::size_t, std::string>, ex> in_order;
  for (const ex& term : terms_of(value)) {
    for (const ex& factor : factors_of(term)) {
      const ex base = GiNaC::is_a<GiNaC::power>(factor) ? factor.op(0) : factor;
      if (!GiNaC::is_a<GiNaC::symbol>(base)) continue;
      const std::string name = GiNaC::ex_to<GiNaC::symbol>(base).get_name();
      in_order.emplace(std::tuple(value.degree(base), name.size(), name), base);
    }
  }
  GiNaC::lst letters;
  for (const auto& [place, letter] : in_order) letters.append(letter);
  return letters;
}

}  // namespace

bool divides(const ex& divisor, const ex& value, ex& quotient, Budget* budget) {
  const std::size_t of_value = term_count(value);
  const std::size_t of_divisor = term_count(divisor);
  if (budget != nullptr) budget->count(price::looked_at_term * (of_value + of_divisor));
  if (!may_divide(divisor, value)) return false;
  if (budget != nullptr) budget->count(price::divided_pair * of_value * of_divisor);
  if (!GiNaC::divide(value, divisor, quotient)) return false;
  quotient = expanded_polynomial(quotient);  // GiNaC leaves it by powers of some variable
  return true;
}

ex with_repeated_factors(const ex& value, Budget* budget) {
  const std::size_t terms = term_count(value);
  if (budget != nullptr) budget->count(price::looked_at_term * terms);
  if (!may_repeat_a_factor(value)) return value;
  if (budget != nullptr) budget->count(price::factored_term * terms);
  return GiNaC::sqrfree(value, letters_in_order(value));
}

}  // namespace rigor
