// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/check.h"

namespace rigor {

void fail_check(const char* condition, const char* file, int line, const std::string& values) {
  throw InternalError(fmt::format("check failed at {}:{}: {}; values:{}", file, line, condition, values));
}

}  // namespace rigor
