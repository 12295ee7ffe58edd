// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/moments.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <string>
#include <utility>

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
  const PackedLetters& letters = indeterminates_.letters();
  ex own = 1;
  std::vector<Divisor> others;
  for (const Divisor& each : body.divisors) {
    if ((indeterminates_.frames_of(each.base) & only(innermost())) == 0) {
      others.push_back(each);
      continue;
    }
    int exponent = each.exponent;
    const bool try_division = !GiNaC::is_a<GiNaC::symbol>(each.base.written()) &&
                              arithmetic_.term_count(body.numerator) <= largest_numerator;
    while (try_division && exponent > 0 &&
           divides(each.base, body.numerator, body.numerator, letters, arithmetic_.budget())) {
      --exponent;
    }
    own *= GiNaC::pow(each.base, exponent);
  }
  body.divisors = std::move(others);
  return own;
}

Moments::Terms Moments::by_own_part(const PackedPolynomial& body) const {
  std::map<Monomial, PackedPolynomial::Terms> parts;
  Monomial own;
  Monomial other;
  for (std::size_t i = 0; i < body.size(); ++i) {
    own.clear();
    other.clear();
    body.for_each_power(i, [&](std::size_t letter, int exponent) {
      const bool is_own = (indeterminates_.frames_at(letter) & only(innermost())) != 0;
      (is_own ? own : other).emplace_back(letter, exponent);
    });
    PackedPolynomial::Terms& terms = parts[own];
    terms.numbers.push_back(body.coefficient(i));
    terms.powers.insert(terms.powers.end(), other.begin(), other.end());
    terms.ends.push_back(terms.powers.size());
  }
  return parts;
}

Fraction Moments::sum(Fraction body) {
  if (body.numerator.is_zero()) return {};
  radicals_.rationalize(body);
  arithmetic_.expand(body);
  body.numerator = radicals_.reduced(body.numerator);
  const ex divisor = take_own_divisor(body);
  const PackedLetters& letters = indeterminates_.letters();
  const PackedPolynomial* const expanded = body.numerator.packed(letters);
  if (expanded == nullptr) throw Undecidable("the degree of what is summed over particles is too high");
  const auto terms = static_cast<double>(std::max<std::size_t>(expanded->size(), 1));
  arithmetic_.count(price::summed_term * static_cast<double>(expanded->size()));
  Terms parts = by_own_part(*expanded);
  if (parts.empty()) parts[{}];  // the sum of zeros: so many as there are particles
  std::map<std::string, std::pair<ex, Terms::value_type*>> in_order;  // moments are created in the same order
  for (auto& part : parts) {
    const ex key = to_ex(PackedPolynomial(1, part.first), letters) / divisor;
    in_order.emplace(indeterminates_.fingerprint(key), std::pair(key, &part));
  }
  Numerator total;
  for (auto& [fingerprint, part] : in_order) {
    const Numerator coefficient(PackedPolynomial(std::move(part.second->second)), letters);
    const PackedPolynomial factor = *Numerator(moment(part.first)).packed(letters);
    total.add({*coefficient.packed(letters) * factor, letters}, letters);
  }
  body.numerator = total;
  body.terms = terms;
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
