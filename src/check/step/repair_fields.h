// SPDX-License-Identifier: GPL-3.0-or-later
// A repair as bytes (`base/archive.h`).
#pragma once

#include "base/archive.h"
#include "check/step/report.h"

namespace rigor {

/// All members, so that one that is added does not compile before it is packed.
template <class Archive>
void fields(Archive& archive, Repair& repair) {
  auto& [on_left, statement, change, replaced, replacement, adds_a_term, uses] = repair;
  archive(on_left, statement, change, replaced, replacement, adds_a_term, uses);
}

}  // namespace rigor
