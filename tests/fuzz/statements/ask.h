// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where the checker is asked.
#pragma once

#include <string>
#include <vector>

namespace fuzz {

enum class Said { proved, refuted, undecided, not_understood, other };
inline constexpr std::size_t said_count = 5;
[[nodiscard]] std::string name_of(Said said);

/// What a refutation's sample says of one letter: `\mathbf{A}` is (1, 0, -1/2).
struct Sampled {
  std::string symbol;
  int particle = 0;
  std::vector<double> components;
};

struct Answer {
  std::vector<Said> steps = {};  // but for what is given
  std::size_t given = 0;
  std::vector<std::string> notices = {};           // of each step: `ambiguous-reading: …`
  std::vector<std::vector<Sampled>> samples = {};  // of each step; empty: none, or not all are rational
  std::string error = {};                          // something in the notes is said to be malformed
  std::string failure = {};                        // of the checker itself, or of its report
};

/// `replay`: each refutation's sample is put in once more, and must show the difference again.
[[nodiscard]] Answer ask(const std::string& file_name, const std::string& notes, bool replay);

}  // namespace fuzz
