// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/suggest.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rigor {
namespace {

constexpr std::size_t longest_word = 128;

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
  const std::size_t too_far = limit + 1;
  if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) > limit) return too_far;
  std::vector<std::size_t> before(b.size() + 1);  // the row for i - 2
  std::vector<std::size_t> above(b.size() + 1);   // the row for i - 1
  std::vector<std::size_t> row(b.size() + 1);     // row[j]: from the first i letters of a to the first j of b
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, above);
    std::swap(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    // An exchange can skip one row, but starts from a value that this row already exceeds by one at most.
    if (std::ranges::min(row) > limit) return too_far;
  }
  return std::min(row[b.size()], too_far);
}

std::optional<std::string> suggest(std::string_view word, std::span<const std::string> known) {
  if (word.empty() || word.size() > longest_word) return std::nullopt;
  std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
  const std::string* best = nullptr;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate, limit);
    if (distance > limit || distance >= std::max(word.size(), candidate.size())) continue;
    best = &candidate;
    if (distance == 0) break;
    limit = distance - 1;
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

}  // namespace rigor
