// SPDX-License-Identifier: GPL-3.0-or-later
// The constants that notes use without giving their values, in units of the SI. What the SI defines is exact;
// all else is from the CODATA adjustment of 2022 (Mohr, Newell, Taylor, Tiesinga, Rev. Mod. Phys. 97, 025002
// (2025)), with an uncertainty that covers the adjustment of 2018 as well. Of the sun and the earth there are
// the nominal values of the IAU (resolution B3 of 2015).
#pragma once

#include <span>
#include <string_view>

namespace rigor {

struct PhysicalConstant {
  std::string_view name;        // "the speed of light"
  std::string_view digits;      // `6.62607015`; a minus may stand before it
  int ten = 0;                  // times this power of ten
  std::string_view unit;        // as `read_unit` reads it; empty: a pure number
  double uncertainty = 0;       // relative; 0: exact, or rounded beyond 15 digits
  std::string_view own = {};    // names that stand for hardly anything else, apart by blanks: `k_B k_{\rm B}`
  std::string_view usual = {};  // names that also stand for other things: `c`, `R`
  std::string_view spoken = {};  // names that need the words: `m` in "an electron of mass $m$"
  std::string_view words = {};   // apart by `|`; each of them is enough
};

/// Constants of one name are values that notes take for one and the same thing: 9.81 and 9.8 m/s².
[[nodiscard]] std::span<const PhysicalConstant> physical_constants();

}  // namespace rigor
