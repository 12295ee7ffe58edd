// SPDX-License-Identifier: GPL-3.0-or-later
// What a statement's sides are on a sample, and whether it holds: by numbers drawn at random, in plain
// doubles.
#pragma once

#include "random.h"
#include "statement.h"

namespace fuzz {

enum class Truth { holds, fails, unclear, twofold };  // twofold: true in one reading, false in the other

/// `fails` where one sample breaks the claim by far more than rounding; `holds` where all of at least some
/// samples meet it up to 1e-11 of the largest number that occurred. Among the samples are those of 0, ±1 and
/// equal values; those that break an assumption, or on which a side has no value, do not count.
[[nodiscard]] Truth truth_of(const Claim& claim, const std::vector<Letter>& letters,
                             const std::vector<Claim>& given, Random& random);

/// One letter's given value.
struct Given {
  std::size_t letter = 0;
  int particle = 0;
  std::vector<double> components;
};

/// Whether the claim holds on that sample; what it leaves open is drawn. `unclear` also where the claim is
/// not about plain numbers (derivatives, ≈). `meets`: whether the assumptions hold there.
[[nodiscard]] Truth truth_at(const Claim& claim, const std::vector<Letter>& letters,
                             const std::vector<Claim>& given, const std::vector<Given>& sample,
                             Random& random, bool& meets);

}  // namespace fuzz
