// SPDX-License-Identifier: GPL-3.0-or-later
// Questions to the exact side and their answers, in a file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/engine/limits.h"
#include "base/result.h"

namespace rigor {

/// All that an answer depends on, apart from the program.
struct AskedQuestion {
  enum class Kind : std::uint8_t { decide, satisfy };
  Kind kind = Kind::decide;
  Limits limits = {};      // its budget is not kept: an answer says what it took
  std::string question;    // a closed question as bytes (`archived`)
  std::string known = {};  // satisfy: the sample that is tried first, as bytes
};

/// The same bytes for what gets the same answer.
[[nodiscard]] std::string archived(const AskedQuestion& asked);
[[nodiscard]] std::optional<AskedQuestion> asked_of_bytes(std::string_view bytes);

struct SavedAnswer {
  std::string asked;       // an `AskedQuestion` as bytes
  std::string answer;      // a decision as bytes, or a sample, or nothing where there is no sample
  std::uint64_t work = 0;  // that it took
  std::uint32_t age = 0;   // savings since it was last asked for
};

/// The answers in a file that this program wrote. A file of another program has none.
[[nodiscard]] Result<std::vector<SavedAnswer>> read_answers(const std::string& path,
                                                            const std::string& program);
/// Replaces the file, and makes its folder where there is none.
[[nodiscard]] Result<void> write_answers(const std::string& path, const std::string& program,
                                         std::vector<SavedAnswer> answers);

}  // namespace rigor
