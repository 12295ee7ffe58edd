// SPDX-License-Identifier: GPL-3.0-or-later
// A value, or the reason why the environment could not give it (a missing file, say). What is wrong in the
// notes is a diagnostic, never an Error.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace rigor {

struct Error {
  std::string reason;  // lower case, no full stop
};

template <class T>
using Result = tl::expected<T, Error>;

[[nodiscard]] inline tl::unexpected<Error> refuse(std::string reason) {
  return tl::unexpected(Error{std::move(reason)});
}

}  // namespace rigor
