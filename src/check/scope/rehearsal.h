// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "elaborate/name/names.h"

namespace rigor {

/// Puts the names back as they were.
class Rehearsal {
 public:
  explicit Rehearsal(Names& names) : names_(names), before_(names.scene()) {}
  ~Rehearsal() { names_.replace(std::move(before_)); }
  Rehearsal(const Rehearsal&) = delete;
  Rehearsal& operator=(const Rehearsal&) = delete;

 private:
  Names& names_;
  Names::Scene before_;
};

}  // namespace rigor
