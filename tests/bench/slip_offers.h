// SPDX-License-Identifier: GPL-3.0-or-later
// For each slip of the pen in each proved row of a file of notes: is the original among the statements that
// are offered? The search is asked at the place of the row, whatever the verdict there would be, so slips
// that make a law or a row that cannot be read count as well. What rests on laws of the page is asked as its
// author would ask it: the whole page is checked with the slip in it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algebra/engine/budget.h"
#include "mutate.h"

namespace rigor::twins {

/// What becomes of the row with the slip in it.
enum class Answer : std::uint8_t { proved, refuted, law, open, unread, suspect };
inline constexpr std::size_t answer_count = 6;

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
  bool on_page = false;    // it rests on laws, or on words beside it: the page was asked
  std::string said = {};   // of the page: what the proof uses, or the first words
  std::size_t others = 0;  // rows of other chains that are found wrong now: one slip is one finding
};

struct Offers {
  std::vector<Offer> offers;  // without slips that change nothing
  std::vector<Offer> proved;  // twins of what rests on definitions or laws that are proved on the page
  std::size_t rows = 0;
  std::size_t results = 0;  // proved rows that rest on definitions or laws of the page
  std::size_t twins = 0;    // of them
  std::size_t on_page = 0;  // proved rows that rest on more than definitions, or on words beside them
  std::vector<std::string> lost = {};  // of which the page says something else when they are typed anew
};

struct Asked {
  bool offers = true;     // what is offered
  bool twins = true;      // what of the twins is proved
  bool pages = true;      // of what rests on laws, for which the page is checked
  std::size_t every = 1;  // slips of them all
  std::uint64_t effort = default_effort;
};

/// Of a file relative to the working directory, with its sidecar.
[[nodiscard]] Offers offers_of(const std::string& path, Asked asked = {});

}  // namespace rigor::twins
