// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/division.h"

#include "algebra/fraction.h"
#include "algebra/line_image.h"

namespace rigor {

using GiNaC::ex;

bool divides(const ex& divisor, const ex& value, ex& quotient, Budget* budget) {
  const std::size_t of_value = term_count(value);
  const std::size_t of_divisor = term_count(divisor);
  if (budget != nullptr) budget->count(price::looked_at_term * (of_value + of_divisor));
  if (!may_divide(divisor, value)) return false;
  if (budget != nullptr) budget->count(price::divided_pair * of_value * of_divisor);
  return GiNaC::divide(value, divisor, quotient);
}

ex with_repeated_factors(const ex& value, Budget* budget) {
  const std::size_t terms = term_count(value);
  if (budget != nullptr) budget->count(price::looked_at_term * terms);
  if (!may_repeat_a_factor(value)) return value;
  if (budget != nullptr) budget->count(price::factored_term * terms);
  return GiNaC::sqrfree(value);
}

}  // namespace rigor
