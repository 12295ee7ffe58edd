// SPDX-License-Identifier: GPL-3.0-or-later
// What a command line or a settings file can ask for at most.
#pragma once

#include <cstdint>

namespace rigor {

inline constexpr std::uint64_t most_jobs = 1024;
inline constexpr std::uint64_t most_effort = 1'000'000'000'000;

}  // namespace rigor
