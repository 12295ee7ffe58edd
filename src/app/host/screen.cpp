// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/screen.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string_view>

namespace rigor {
namespace {

bool wants_color() {
  const char* const no_color = std::getenv("NO_COLOR");
  if (no_color != nullptr && *no_color != '\0') return false;
  const char* const term = std::getenv("TERM");
  return term != nullptr && std::string_view(term) != "dumb";
}

}  // namespace

Screen screen_of(const std::ostream& stream) {
  int descriptor = -1;
  if (&stream == &std::cout) descriptor = STDOUT_FILENO;
  if (&stream == &std::cerr) descriptor = STDERR_FILENO;
  if (descriptor < 0 || isatty(descriptor) == 0) return {};
  Screen screen{true, wants_color(), 0};
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) == 0) screen.width = size.ws_col;
  return screen;
}

TerminalOptions terminal_options(ColorWhen color, const std::ostream& stream) {
  const Screen screen = screen_of(stream);
  TerminalOptions options;
  options.color = color == ColorWhen::always || (color == ColorWhen::automatic && screen.takes_color);
  if (screen.width > 0) options.width = screen.width;
  return options;
}

}  // namespace rigor
