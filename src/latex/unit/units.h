// SPDX-License-Identifier: GPL-3.0-or-later
// Units of measure as they are written, in text (`kg.m^2`, `m/s^2`, `\mathrm{kg}\,\mathrm{m}^2`) and in the
// words of siunitx (`\kilo\gram\metre\squared`, `\metre\per\second`).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/small_rational.h"

namespace rigor {

/// Powers of kg, m, s, A, K, mol, cd, in this order; what is measured is `factor` · 10^`ten` of their
/// product.
struct WrittenUnit {
  std::array<SmallRational, 7> exponents{};
  SmallRational factor = 1;
  int ten = 0;
};

inline constexpr std::array<std::string_view, 7> base_units{"kg", "m", "s", "A", "K", "mol", "cd"};

/// Which names stand for what.
enum class UnitNames : std::uint8_t {
  units,       // kg, m, s, N, km…
  dimensions,  // M, L, T before these
};

/// Nothing where a name is unknown or the text is no product of powers. `problem`, if given, says what is
/// wrong. Spaces, `.`, `\,`, `\cdot`, `~` multiply; after `/` stands one factor or bracket, and nothing
/// follows it.
[[nodiscard]] std::optional<WrittenUnit> read_unit(std::string_view text, UnitNames names,
                                                   std::string* problem = nullptr);

/// Is a roman word after a number a unit? A single letter needs a space before it, since `2\mathrm{V}` can
/// be twice a volume; `\mathrm{d}` is a differential.
[[nodiscard]] bool is_unit_word(std::string_view text, bool spaced);

}  // namespace rigor
