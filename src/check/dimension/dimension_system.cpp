// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/dimension/dimension_system.h"

#include <iterator>
#include <utility>

namespace rigor {
namespace {

void add_scaled(Reasons& to, const Reasons& reasons, const SmallRational& factor) {
  for (const auto& [reason, own] : reasons) {
    SmallRational& sum = to[reason];
    sum = sum + own * factor;
    if (sum.is_zero()) to.erase(reason);
  }
}

}  // namespace

/// Rows hold no unknown that has a row, so that each is looked up once.
void DimensionSystem::reduce_by_own(Reduced& reduced) const {
  const DimensionForm before = std::exchange(reduced.form, {});
  reduced.form.fixed = before.fixed;
  reduced.form.any = before.any;
  for (const auto& [unknown, factor] : before.unknowns) {
    const auto row = rows_.find(unknown);
    if (row == rows_.end()) {
      reduced.form.add(unknown, factor);
      continue;
    }
    reduced.form.add(row->second.value, factor);
    add_scaled(reduced.reasons, row->second.reasons, factor);
  }
}

DimensionSystem::Reduced DimensionSystem::reduce(const DimensionForm& form) const {
  Reduced reduced = below_ != nullptr ? below_->reduce(form) : Reduced{form, {}};
  reduce_by_own(reduced);
  return reduced;
}

std::optional<DimensionSystem::Contradiction> DimensionSystem::add(const DimensionForm& left,
                                                                   const DimensionForm& right,
                                                                   Reason reason) {
  DimensionForm difference = left;
  difference.add(right, -1);
  if (difference.any) return std::nullopt;
  Reduced reduced = reduce(difference);
  if (!reduced.form.is_valid()) return std::nullopt;
  if (reduced.form.unknowns.empty()) {
    if (reduced.form.fixed.is_none()) return std::nullopt;
    return Contradiction{reduced.form.fixed, std::move(reduced.reasons)};
  }
  if (rows_.size() >= most_dimension_rows) return std::nullopt;
  const auto last = std::prev(reduced.form.unknowns.end());
  const Unknown pivot = last->first;
  const SmallRational scale = SmallRational(-1) / last->second;
  reduced.form.unknowns.erase(last);
  Row made;
  made.value.add(reduced.form, scale);
  made.reasons[reason] = scale * SmallRational(-1);
  add_scaled(made.reasons, reduced.reasons, scale);
  if (!made.value.is_valid()) return std::nullopt;
  for (auto& [unknown, row] : rows_) {
    const auto found = row.value.unknowns.find(pivot);
    if (found == row.value.unknowns.end()) continue;
    const SmallRational factor = found->second;
    row.value.unknowns.erase(found);
    row.value.add(made.value, factor);
    add_scaled(row.reasons, made.reasons, factor);
  }
  rows_.emplace(pivot, std::move(made));
  return std::nullopt;
}

}  // namespace rigor
