// SPDX-License-Identifier: GPL-3.0-or-later
// Where a chain a = b = c = d goes wrong: the first wrong step is the error; a later one takes its slip back,
// or is a slip of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "check/step/report.h"

namespace rigor {

/// What is known of one step, or of two sides that are further apart.
enum class Link : std::uint8_t {
  holds,
  fails,
  open,         // neither proved nor refuted
  no_equality,  // another relation: a slip is not followed across it
};

/// For each step that fails, its place in the chain. `across(i, k)` decides whether side i equals side k, for
/// i + 1 < k; it is asked only where the steps between do not tell. A slip that is taken back is over; the
/// next step that fails is the first wrong one again.
[[nodiscard]] std::vector<std::optional<ChainPlace>> places_in_chain(
    const std::vector<Link>& steps, const std::function<Link(std::size_t, std::size_t)>& across);

}  // namespace rigor
