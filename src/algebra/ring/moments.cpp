// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/moments.h"

#include <ginac/ginac.h>

#include <string>

#include "algebra/engine/terms.h"
#include "algebra/engine/undecidable.h"
#include "algebra/ring/division.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr std::size_t largest_numerator = 200;  // terms of a numerator that is tried to be divided

}  // namespace

Frame Moments::open() {
  ++depth_;
  if (innermost() >= frame_limit) throw Undecidable("sums over particles nest too deeply");
  return innermost();
}

ex Moments::take_own_divisor(Fraction& body) const {
  ex own = 1;
  std::vector<Divisor> others;
  for (const Divisor& each : body.divisors) {
    if ((indeterminates_.frames_of(each.base) & only(innermost())) == 0) {
      others.push_back(each);
      continue;
    }
    int exponent = each.exponent;
    ex quotient;
    const bool try_division =
        !GiNaC::is_a<GiNaC::symbol>(each.base) && term_count(body.numerator) <= largest_numerator;
    while (try_division && exponent > 0 &&
           divides(each.base, body.numerator, quotient, arithmetic_.budget())) {
      body.numerator = quotient;
      --exponent;
    }
    own *= GiNaC::pow(each.base, exponent);
  }
  body.divisors = std::move(others);
  return own;
}

Moments::Term Moments::split(const ex& term, const ex& divisor) const {
  Term parts;
  const auto take = [&](const ex& factor) {
    const bool own = (indeterminates_.frames_of(factor) & only(innermost())) != 0;
    (own ? parts.key : parts.coefficient) *= factor;
  };
  if (GiNaC::is_a<GiNaC::mul>(term)) {
    for (std::size_t i = 0; i < term.nops(); ++i) take(term.op(i));
  } else {
    take(term);
  }
  parts.key /= divisor;
  return parts;
}

Fraction Moments::sum(Fraction body) {
  if (body.numerator.is_zero()) return {};
  radicals_.rationalize(body);
  arithmetic_.expand(body);
  body.numerator = radicals_.reduced(body.numerator);
  const ex divisor = take_own_divisor(body);
  body.numerator = body.numerator.written().expand();
  arithmetic_.count(price::summed_term * static_cast<double>(term_count(body.numerator)));
  std::map<ex, GiNaC::exvector, GiNaC::ex_is_less> by_key;
  const auto add_term = [&](const ex& term) {
    const Term parts = split(term, divisor);
    by_key[parts.key].push_back(parts.coefficient);
  };
  for (const ex& term : terms_of(body.numerator)) add_term(term);
  std::map<std::string, ex> in_order;  // moments are created in the same order in every run
  for (const auto& [key, coefficients] : by_key) in_order.emplace(indeterminates_.fingerprint(key), key);
  GiNaC::exvector summands;
  for (const auto& [fingerprint, key] : in_order) {
    const GiNaC::exvector& coefficients = by_key[key];
    const ex factor = moment(key);
    for (const ex& coefficient : coefficients) summands.push_back(coefficient * factor);
  }
  body.numerator = ex(GiNaC::add(summands));
  body.terms = static_cast<double>(summands.size());
  return body;
}

ex Moments::moment(const ex& key) {
  const FrameSet frames = indeterminates_.frames_of(key);
  const FrameSet sums = ~FrameSet{0} << outermost_;
  if ((frames & sums & ~only(innermost())) != 0) {
    throw Undecidable(
        "a sum over particles inside another has a quotient or a root of both particles' quantities");
  }
  const ex canonical = radicals_.moved(key, innermost(), outermost_);
  const auto known = moments_.find(canonical);
  if (known != moments_.end()) return known->second;
  // A key with a free particle's quantities stays that particle's: only the summed particle is gone.
  const ex created = indeterminates_.fresh(Indeterminates::Kind::moment, frames & ~only(innermost()));
  moments_.emplace(canonical, created);
  const Sign sign = signs_.of(key);  // there is one particle at least
  if (sign != Sign::not_zero) signs_.know(created, sign);
  return created;
}

}  // namespace rigor
