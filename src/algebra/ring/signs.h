// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of signs at the generic point. A sign is a set: which of negative, zero and positive a value
// may be. All conclusions are sound for every value of the indeterminates that has the known signs.
#pragma once

#include <ginac/ex.h>

#include <map>
#include <utility>
#include <vector>

#include "algebra/point/indeterminates.h"
#include "algebra/ring/fraction.h"

namespace rigor {

enum class Sign : std::uint8_t {
  impossible = 0,
  negative = 1,
  zero = 2,
  not_positive = 3,
  positive = 4,
  not_zero = 5,
  not_negative = 6,
  any = 7
};

[[nodiscard]] constexpr Sign common(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<unsigned>(a) & static_cast<unsigned>(b));
}
[[nodiscard]] constexpr bool is_within(Sign sign, Sign allowed) { return common(sign, allowed) == sign; }
/// The same for a conclusion: a value that can have no sign at all proves nothing.
[[nodiscard]] constexpr bool is_surely(Sign sign, Sign allowed) {
  return sign != Sign::impossible && is_within(sign, allowed);
}
[[nodiscard]] Sign opposite(Sign sign);
[[nodiscard]] Sign sum(Sign a, Sign b);
[[nodiscard]] Sign product(Sign a, Sign b);
/// Of an integer power; where the exponent is negative, the base is not 0.
[[nodiscard]] Sign power(Sign base, int exponent);

class Signs {
 public:
  explicit Signs(Indeterminates& indeterminates) : indeterminates_(indeterminates) {}

  /// From now on an indeterminate has this sign. A sign of one particle's number is known for that particle
  /// only, one of the template's for all particles: that is where signs for each particle are entered.
  void know(const GiNaC::ex& indeterminate, Sign sign);
  /// p has this sign, for a polynomial p. It is expanded.
  void add_fact(const GiNaC::ex& value, Sign sign);
  /// Looks for indeterminates whose sign follows from the facts: 0 < a and a < b make b positive,
  /// 0 < ab and 0 < a as well.
  void conclude();

  /// A polynomial or a quotient as it is written, expanded or not: by the signs of its parts.
  [[nodiscard]] Sign of(const GiNaC::ex& value) const;
  [[nodiscard]] Sign of(const Fraction& value) const;

  struct Fact {
    GiNaC::ex value;
    Sign sign;
  };
  [[nodiscard]] const std::vector<Fact>& facts() const { return facts_; }

 private:
  [[nodiscard]] Sign of_indeterminate(const GiNaC::ex& indeterminate) const;
  [[nodiscard]] Sign of_known(const GiNaC::ex& value) const;  // what facts say of just this value, too
  [[nodiscard]] Sign of_factor(const Fact& fact, const GiNaC::ex& rest, int exponent) const;
  [[nodiscard]] bool conclude_from(const Fact& fact);

  Indeterminates& indeterminates_;
  std::map<GiNaC::ex, Sign, GiNaC::ex_is_less> known_;
  std::map<std::pair<SymbolId, std::uint32_t>, Sign> of_each_particle_;
  std::vector<Fact> facts_;
};

}  // namespace rigor
