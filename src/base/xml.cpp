// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/xml.h"

#include "base/utf8.h"

namespace rigor {

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char each : printable(text)) {
    switch (each) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += each;
    }
  }
  return escaped;
}

}  // namespace rigor
