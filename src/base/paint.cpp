// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/paint.h"

#include <fmt/format.h>

namespace rigor {
namespace {

std::string_view code(Paint style) {
  switch (style) {
    case Paint::plain:
      return "";
    case Paint::strong:
      return "1";
    case Paint::good:
      return "32";
    case Paint::bad:
      return "1;31";
    case Paint::open:
      return "33";
    case Paint::faint:
      return "2";
    case Paint::mark:
      return "1;36";
  }
  return "";
}

}  // namespace

std::string paint(std::string_view text, Paint style, bool color) {
  if (!color || style == Paint::plain || text.empty()) return std::string(text);
  return fmt::format("\x1b[{}m{}\x1b[0m", code(style), text);
}

}  // namespace rigor
