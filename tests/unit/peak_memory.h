// SPDX-License-Identifier: GPL-3.0-or-later
// How much memory something takes at its peak.
#pragma once

#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "catch.h"

namespace rigor {

/// Sanitizers keep freed memory and much of their own.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool memory_is_our_own = false;
#else
inline constexpr bool memory_is_our_own = true;
#endif

/// MiB beyond what the process held before, mapped files included, of a call in a process of its own; it
/// fails where the call returns false.
inline double peak_memory_of(const std::function<bool()>& call) {
  ::malloc_trim(0);  // what the process held before and is given back is counted, too
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const auto peak = [] {
      rusage usage{};
      ::getrusage(RUSAGE_SELF, &usage);
      return static_cast<double>(usage.ru_maxrss) / 1024;
    };
    const double before = peak();
    const bool done = call();
    const double more = peak() - before;
    const bool told = ::write(ends[1], &more, sizeof more) == sizeof more;
    ::_exit(done && told ? 0 : 1);
  }
  ::close(ends[1]);
  double more = 0;
  const bool heard = ::read(ends[0], &more, sizeof more) == sizeof more;
  ::close(ends[0]);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE((heard && WIFEXITED(status) && WEXITSTATUS(status) == 0));
  return more;
}

}  // namespace rigor
