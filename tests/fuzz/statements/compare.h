// SPDX-License-Identifier: GPL-3.0-or-later
// What the checker says of a statement against what its numbers say.
#pragma once

#include <optional>

#include "ask.h"
#include "evaluate.h"
#include "write.h"

namespace fuzz {

struct Disagreement {
  std::string what;  // `proved, but it is false`
  std::string notes;
  std::string file_name;
};

/// A statement with its answer, and the truth of each step.
struct Compared {
  Answer answer;
  std::vector<Truth> truths;
  std::optional<std::string> wrong;
};

[[nodiscard]] Compared compare(const Statement& statement, const Style& style, std::uint64_t seed,
                               bool replay);

/// Several statements on one page, each below its own heading: none may change another one's verdict for the
/// worse. What is wrong, with the page reduced to the statements that it needs.
[[nodiscard]] std::optional<Disagreement> compare_page(const std::vector<Statement>& page, const Style& style,
                                                       std::uint64_t seed);

/// The smallest statement found by leaving parts out with which something of the same kind stays wrong.
[[nodiscard]] Disagreement shrunk(Statement statement, const Style& style, std::uint64_t seed,
                                  const std::string& wrong);

}  // namespace fuzz
