// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <ostream>

#include "app/grammar/command_line.h"
#include "report/text/terminal.h"

namespace rigor {

/// What is known of the terminal behind a stream.
struct Screen {
  bool is_terminal = false;
  bool takes_color = false;  // a terminal, NO_COLOR is not set, TERM is not `dumb`
  std::uint32_t width = 0;   // in cells; 0: not known
};

/// Only std::cout and std::cerr can be terminals.
[[nodiscard]] Screen screen_of(const std::ostream& stream);

/// How a report is printed there.
[[nodiscard]] TerminalOptions terminal_options(ColorWhen color, const std::ostream& stream);

}  // namespace rigor
