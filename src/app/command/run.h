// SPDX-License-Identifier: GPL-3.0-or-later
// The program as a function: the report goes to `out`; errors, progress and `--debug` go to `err`. `-` is
// read from `in`.
#pragma once

#include <functional>
#include <iostream>

namespace rigor {

/// The exit code. Never throws: an exception is an error of our own, printed to `err`.
[[nodiscard]] int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err,
                      std::istream& in = std::cin);

/// What `work` returns; if it throws, the text of the exception goes to `err` and the code is 70.
[[nodiscard]] int run_guarded(std::ostream& err, const std::function<int()>& work);

}  // namespace rigor
