// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/engine/budget.h"

#include <fmt/format.h>

#include "algebra/engine/undecidable.h"

namespace rigor {

void Budget::give_up() const {
  throw Undecidable(
      fmt::format("it takes more than {} units of work, the limit that `--effort` sets", most_));
}

}  // namespace rigor
