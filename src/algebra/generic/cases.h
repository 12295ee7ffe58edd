// SPDX-License-Identifier: GPL-3.0-or-later
// Equations that are linear in an indeterminate with a coefficient that is no number, by distinction of
// cases: a·x + b = 0 means either a ≠ 0 and x = −b/a, or a = 0 and b = 0. A polynomial vanishes on the
// solutions if it does in every case; substitution multiplies by powers of a, which is harmless where a ≠ 0.
// What is known to be nonzero opens no case. Sound: each case has consequences of its equations only.
// Incomplete over the real numbers (x² + y² = 0 is taken as it is), and by the bound on the number of cases.
#pragma once

#include <optional>
#include <vector>

#include "algebra/generic/generic_evaluator.h"

namespace rigor {

/// Equations f = 0 (expanded), and polynomials that are not 0 under them.
struct System {
  std::vector<Numerator> equations;
  std::vector<Numerator> nonzero;
};

class Cases {
 public:
  explicit Cases(GenericDomain& domain) : domain_(domain) {}

  enum class Verdict : std::uint8_t {
    vanishes,  // in every case, and there is one
    empty,     // no case is possible
    open,
  };
  [[nodiscard]] Verdict decide(const Numerator& value, System system);

 private:
  struct Linear {
    std::size_t x = 0;   // a letter's position
    Numerator factor;    // a
    Numerator constant;  // b
    std::size_t equation = 0;
  };
  [[nodiscard]] bool simplify(Numerator& value, System& system);
  [[nodiscard]] bool tidy(System& system);
  [[nodiscard]] bool substitute(Numerator& value, System& system, const Linear& by);
  [[nodiscard]] Numerator substituted(const Numerator& value, const Linear& by);
  [[nodiscard]] std::optional<Linear> simplest_linear(const System& system, bool known_factor) const;
  [[nodiscard]] Verdict split(const Numerator& value, const System& system, const Linear& by);

  [[nodiscard]] const PackedLetters& letters() const { return domain_.indeterminates().letters(); }
  [[nodiscard]] Numerator without_nonzero(const Numerator& value, const System& system) const;

  GenericDomain& domain_;
  int opened_ = 0;
  int substitutions_ = 0;
};

/// A polynomial without the factors that are known to be nonzero.
[[nodiscard]] Numerator without_factors(Numerator value, const std::vector<Numerator>& factors,
                                        const PackedLetters& letters, Budget* budget);

}  // namespace rigor
