// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/system_error.h"

#include "base/ascii.h"

namespace rigor {

Error error_of(std::error_code code) {
  std::string reason = code.message();
  if (!reason.empty()) reason[0] = lowered(reason[0]);
  return {reason};
}

}  // namespace rigor
