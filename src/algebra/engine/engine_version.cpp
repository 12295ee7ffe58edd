// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/engine/engine_version.h"

#include <cln/version.h>
#include <fmt/format.h>
#include <ginac/version.h>

namespace rigor {

std::string engine_version() {
  return fmt::format("GiNaC {}.{}.{}, CLN {}.{}.{}", GINACLIB_MAJOR_VERSION, GINACLIB_MINOR_VERSION,
                     GINACLIB_MICRO_VERSION, CL_VERSION_MAJOR, CL_VERSION_MINOR, CL_VERSION_PATCHLEVEL);
}

}  // namespace rigor
