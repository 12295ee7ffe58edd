// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/engine/term_estimate.h"

#include <algorithm>
#include <map>
#include <vector>

#include "algebra/engine/terms.h"

namespace rigor {
namespace {

struct EstimatedDivisor {
  int exponent = 0;
  double terms = 1;  // of the base
};

/// The denominator, by base.
using Below = std::map<GiNaC::ex, EstimatedDivisor, GiNaC::ex_is_less>;

struct Estimate {
  double above = 1;
  Below below = {};
};

Estimate estimate_of(const GiNaC::ex& value);

/// The number of terms of a power of a sum: the number of monomials.
double terms_of_power(double terms, int exponent) {
  double count = 1;
  for (int k = 1; k <= exponent; ++k) count = count * (terms - 1 + k) / k;
  return count;
}

double terms_below(const Below& below) {
  double count = 1;
  for (const auto& [base, divisor] : below) count *= terms_of_power(divisor.terms, divisor.exponent);
  return count;
}

/// What a term gets above from the denominators that are not its own.
double terms_missing(const Below& own, const Below& common) {
  double count = 1;
  for (const auto& [base, divisor] : common) {
    const auto found = own.find(base);
    const int missing = divisor.exponent - (found == own.end() ? 0 : found->second.exponent);
    count *= terms_of_power(divisor.terms, missing);
  }
  return count;
}

Estimate estimate_of_sum(const GiNaC::ex& value) {
  std::vector<Estimate> terms;
  Estimate sum{.above = 0};
  for (const GiNaC::ex& each : terms_of(value)) {
    terms.push_back(estimate_of(each));
    for (const auto& [base, divisor] : terms.back().below) {
      EstimatedDivisor& common = sum.below[base];
      common = {std::max(common.exponent, divisor.exponent), divisor.terms};
    }
  }
  for (const Estimate& term : terms) sum.above += term.above * terms_missing(term.below, sum.below);
  return sum;
}

Estimate estimate_of_power(const GiNaC::ex& value) {
  const GiNaC::ex& base = value.op(0);
  if (!value.op(1).info(GiNaC::info_flags::integer)) return {};
  const int exponent = GiNaC::ex_to<GiNaC::numeric>(value.op(1)).to_int();
  Estimate inner = estimate_of(base);
  if (exponent >= 0) {
    inner.above = terms_of_power(inner.above, exponent);
    for (auto& [each, divisor] : inner.below) divisor.exponent *= exponent;
    return inner;
  }
  Estimate inverse{.above = terms_of_power(terms_below(inner.below), -exponent)};
  inverse.below[base] = {-exponent, inner.above};
  return inverse;
}

Estimate estimate_of(const GiNaC::ex& value) {
  if (GiNaC::is_a<GiNaC::add>(value)) return estimate_of_sum(value);
  if (GiNaC::is_a<GiNaC::power>(value)) return estimate_of_power(value);
  Estimate product;
  if (!GiNaC::is_a<GiNaC::mul>(value)) return product;
  for (const GiNaC::ex& each : factors_of(value)) {
    const Estimate factor = estimate_of(each);
    product.above *= factor.above;
    for (const auto& [base, divisor] : factor.below) {
      EstimatedDivisor& common = product.below[base];
      common = {common.exponent + divisor.exponent, divisor.terms};
    }
  }
  return product;
}

}  // namespace

double most_terms_over_one_denominator(const GiNaC::ex& value) {
  const Estimate estimate = estimate_of(value);
  return std::max(estimate.above, terms_below(estimate.below));
}

}  // namespace rigor
