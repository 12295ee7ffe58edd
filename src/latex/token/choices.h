// SPDX-License-Identifier: GPL-3.0-or-later
// Places where one side can be read in two ways that no rule of notation tells apart: `\cos\omega(t - t_0)`
// is the cosine of all of it, or a product. A parser asks at each such place which way to go.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/span.h"

namespace rigor {

/// One place, and how each reading would be written without doubt.
struct Choice {
  Span span;
  std::string first;
  std::string second;
};

struct Choices {
  std::vector<bool> seconds = {};  // at the places in the order in which they are met: the second reading?
  bool rest = false;               // at all later places
  std::vector<Choice> met = {};

  bool takes_second(Choice choice) {
    const std::size_t place = met.size();
    met.push_back(std::move(choice));
    return place < seconds.size() ? seconds[place] : rest;
  }
};

}  // namespace rigor
