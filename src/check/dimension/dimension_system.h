// SPDX-License-Identifier: GPL-3.0-or-later
// Linear equations between dimensions over the rational numbers, solved as they come: Gauss and Jordan, one
// row for each unknown that is expressed by others. Each row keeps how often each equation went into it, so
// that a contradiction names those it needs and no others.
#pragma once

#include <map>
#include <optional>

#include "check/dimension/dimension_form.h"

namespace rigor {

/// An equation that was given to `add`, by the number that came with it.
using Reason = std::uint32_t;
/// Equations, each with a factor that is not 0.
using Reasons = std::map<Reason, SmallRational>;

class DimensionSystem {
 public:
  /// Equations on top of `below`, which stays as it is and must outlive this.
  explicit DimensionSystem(const DimensionSystem* below = nullptr) : below_(below) {}

  /// A form in terms of what is not determined: the given one is this plus `reasons`.
  struct Reduced {
    DimensionForm form;
    Reasons reasons;
  };
  [[nodiscard]] Reduced reduce(const DimensionForm& form) const;

  struct Contradiction {
    Dimension ratio;  // of the two sides
    Reasons reasons;  // the earlier equations that it contradicts
  };
  /// Takes `left = right` in, unless it contradicts what is known.
  std::optional<Contradiction> add(const DimensionForm& left, const DimensionForm& right, Reason reason);

 private:
  struct Row {
    DimensionForm value;  // of the unknown, in terms of unknowns that have no row
    Reasons reasons;      // the unknown is the value plus these
  };
  void reduce_by_own(Reduced& reduced) const;

  const DimensionSystem* below_;
  std::map<Unknown, Row> rows_;
};

/// More rows than this are not made; equations beyond it are left out.
inline constexpr std::size_t most_dimension_rows = 1000;

}  // namespace rigor
