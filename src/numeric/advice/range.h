// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a search space that advice can name: by the sizes of all numbers, and by one question about a
// letter.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "numeric/advice/search_space.h"

namespace rigor {

/// One half of all points. Of vectors, the largest component counts.
struct Half {
  enum class By : std::uint8_t {
    sign,    // x > 0, or x < 0
    size,    // |x| < bound, or at least it
    larger,  // |x| < |y|, or at least it
  };
  By by = By::sign;
  std::size_t letter = 0;
  std::size_t other = 0;
  double bound = 0;
  bool first = true;
  bool operator==(const Half&) const = default;
};

/// Every number that is not 0 has a size from `least` to `most`; or, `beyond`, one has not.
struct Range {
  double least = 0;
  double most = std::numeric_limits<double>::infinity();
  bool beyond = false;
  std::optional<Half> half = {};
  bool operator==(const Range&) const = default;
  [[nodiscard]] bool has_all_sizes() const { return least == 0 && most > 1e308; }
};

[[nodiscard]] bool contains(const SearchSpace& space, const Range& range, const Point& point);

/// By sizes alone, the wide ones first, but for those that angles need.
[[nodiscard]] std::vector<Range> ranges_of_sizes();
/// First halves: by signs, then by sizes.
[[nodiscard]] std::vector<Half> halves_of(const SearchSpace& space, const ExprTree& tree);

/// ` for sizes from 1e-150 to 1e+150, where b > 0`; empty for all points.
[[nodiscard]] std::string text_of(const ExprTree& tree, const SearchSpace& space, const Range& range);

}  // namespace rigor
