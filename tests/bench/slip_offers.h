// SPDX-License-Identifier: GPL-3.0-or-later
// For each slip of the pen in each proved row of a file of notes: is the original among the statements that
// are offered? The search is asked at the place of the row, whatever the verdict there would be, so slips
// that make a law or a row that cannot be read count as well.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mutate.h"

namespace rigor::twins {

/// What becomes of the row with the slip in it.
enum class Answer : std::uint8_t { proved, refuted, law, open, unread };

struct Offer {
  Slip slip = Slip::sign;
  Answer answer = Answer::open;
  std::string place = {};  // of the original: `rigid-bodies.md:44`
  std::string original = {};
  std::string twin = {};
  std::vector<std::string> offered = {};
  std::size_t equal = 0;  // the first that changes the side which was spoilt, from 1; 0: none does
  std::size_t same = 0;   // the first that is the original, up to the order of terms and factors
  double milliseconds = 0.0;
};

struct Offers {
  std::vector<Offer> offers;  // without slips that change nothing
  std::size_t rows = 0;
  std::size_t not_alone = 0;  // proved rows that rest on more than definitions, or on words beside them
};

/// Of a file relative to the working directory, with its sidecar.
[[nodiscard]] Offers offers_of(const std::string& path);

}  // namespace rigor::twins
