// SPDX-License-Identifier: GPL-3.0-or-later
// RIGOR_CHECK(condition, values...): an invariant of our own. A failure is our bug, never the notes': it
// throws InternalError with the condition, the place and the values, printed before the exit with 70.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace rigor {

class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] void fail_check(const char* condition, const char* file, int line, const std::string& values);

template <class... Values>
[[nodiscard]] std::string check_values(const Values&... values) {
  std::string joined;
  ((joined += fmt::format(" {}", values)), ...);
  return joined;
}

}  // namespace rigor

#define RIGOR_CHECK(condition, ...)                                                            \
  do {                                                                                         \
    if (!(condition))                                                                          \
      ::rigor::fail_check(#condition, __FILE__, __LINE__, ::rigor::check_values(__VA_ARGS__)); \
  } while (false)
