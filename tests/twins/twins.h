// SPDX-License-Identifier: GPL-3.0-or-later
// False twins: every true statement of a file of notes, with one slip of the pen each, and what Rigor says to
// it.
//
// A twin is checked where its original stands, in a short form of the notes that says the same: all headings,
// directives and macro definitions, the displays before it that define something, and its own display with
// the slip in it. Where that gives no answer, the whole file with the slip in it is asked.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "check/entry/check.h"
#include "mutate.h"

namespace rigor::twins {

enum class Outcome : std::uint8_t {
  refuted,           // with a sample
  refuted_declared,  // once its symbols are declared to be meant for all values; before that it reads as a
                     // law
  refuted_used,      // once a `use` says that a definition of another section holds here, too
  proved_equal,      // the slip changes nothing: see reviewed/
  malformed,         // a diagnostic for an index, a rank or a reading
  undecided,         // with a reason: see reviewed/
  law_like,          // reads as a law even so
  failed,            // anything else: Rigor does not see the slip
};
inline constexpr std::size_t outcome_count = 8;

[[nodiscard]] std::string_view name_of(Outcome outcome);

struct Twin {
  Slip slip;
  std::string place;  // of the original: `rigid-bodies.md:44`
  std::string original;
  std::string twin;
  Outcome outcome = Outcome::failed;
  std::string said;            // the verdict and the kinds of its diagnostics
  std::string broken_by = {};  // proved: a random sample on which it fails
};

struct Twins {
  std::vector<Twin> twins;
  std::size_t statements = 0;  // proved steps
  std::vector<std::string>
      lost;  // proved steps of which the short form says something else than the whole file
};

/// Of a file relative to the working directory.
[[nodiscard]] Twins twins_of(const std::string& path);

}  // namespace rigor::twins
