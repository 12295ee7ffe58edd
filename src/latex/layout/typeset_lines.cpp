// SPDX-License-Identifier: GPL-3.0-or-later
// How wide boxes are, and where an equation is cut into lines; words and source for a paragraph.
#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"
#include "latex/layout/layout_reader.h"
#include "latex/layout/typeset.h"
#include "latex/layout/typeset_signs.h"

namespace rigor {
namespace {

double sign_width(const Box& box) {
  switch (box.role) {
    case SignRole::relation:
      return 1.35;
    case SignRole::binary:
      return box.text == "·" ? 0.75 : 1.25;
    case SignRole::prefix:
      return 0.8;
    case SignRole::big:
      return 1.5;
    case SignRole::integral:
      return 0.9;
    case SignRole::word:
      return 0.55 * static_cast<double>(count_code_points(box.text));
    default:
      return 0.4;
  }
}

double sum_of_widths(const std::vector<Box>& parts) {
  double width = 0;
  for (const Box& part : parts) width += typeset_width(part);
  return width;
}

double table_width(const Box& box) {
  std::vector<double> columns;
  std::size_t cell = 0;
  for (const std::size_t end : box.row_ends) {
    for (std::size_t column = 0; cell < end; ++cell, ++column) {
      if (column == columns.size()) columns.push_back(0);
      columns[column] = std::max(columns[column], typeset_width(box.parts[cell]));
    }
  }
  double width = 0;
  for (const double each : columns) width += each + 1;
  return width;
}

/// Cuts before every part whose role is asked for, but not before the first; pieces are joined as long as
/// they fit.
std::vector<std::vector<Box>> cut_before(const std::vector<Box>& parts, SignRole role, double width) {
  std::vector<std::vector<Box>> lines(1);
  std::vector<Box> piece;
  double line_width = 0;
  const auto flush = [&] {
    const double own = sum_of_widths(piece);
    if (!lines.back().empty() && line_width + own > width) {
      lines.emplace_back();
      line_width = 0;
    }
    for (Box& part : piece) lines.back().push_back(std::move(part));
    line_width += own;
    piece.clear();
  };
  for (const Box& part : parts) {
    const bool may_cut =
        role_of(part) == role && !piece.empty() &&
        (role == SignRole::relation || part.text == "+" || part.text == "−" || part.text == "±");
    if (may_cut) flush();
    piece.push_back(part);
  }
  flush();
  return lines;
}

Box line_box(std::vector<Box> parts) {
  Box box;
  box.parts = std::move(parts);
  return box;
}

/// One character of words, as LaTeX sets it in a paragraph.
std::string typeset_character(std::string_view one) {
  if (one.size() == 1) {
    switch (one[0]) {
      case '\\':
        return "\\textbackslash{}";
      case '{':
      case '}':
      case '$':
      case '&':
      case '#':
      case '_':
      case '%':
        return "\\" + std::string(one);
      case '^':
        return "\\textasciicircum{}";
      case '~':
        return "\\textasciitilde{}";
      case '<':
        return "\\textless{}";
      case '>':
        return "\\textgreater{}";
      case '|':
        return "\\textbar{}";
      case '"':
        return "\\textquotedbl{}";
      case '`':
        return "\\textasciigrave{}";
      case '-':
        return "-{}";
      default:
        return std::string(one);
    }
  }
  std::size_t at = 0;
  const char32_t code = next_code_point(one, at);
  const bool is_latin = code >= 0xC0 && code <= 0xFF && code != 0xD7 && code != 0xF7;
  if (is_latin) return std::string(one);
  if (code == 0xA0) return "~";
  if (code == 0x2019) return "'";
  if (code == 0x2013) return "--";
  if (code == 0x2014) return "---";
  if (const std::string sign = typeset_sign(one); !sign.empty()) return "\\ensuremath{" + sign + "}";
  return fmt::format("[U+{:04X}]", static_cast<std::uint32_t>(code));
}

std::string typeset_all(std::string_view text, std::size_t longest_run, bool keep_blanks) {
  std::string result;
  std::size_t run = 0;  // characters since the last place where a line may end
  const std::string clean = printable(text);
  const std::string_view view = clean;
  for (std::size_t at = 0; at < view.size();) {
    std::size_t next = at;
    static_cast<void>(next_code_point(view, next));
    const std::string_view one = view.substr(at, next - at);
    at = next;
    if (one == " ") {
      result += keep_blanks ? "\\ " : " ";
      run = 0;
      continue;
    }
    result += typeset_character(one);
    const bool may_end = one == "/" || one == "_" || one == "." || ++run >= longest_run;
    if (may_end && at < view.size()) {
      result += "\\allowbreak{}";
      run = 0;
    }
  }
  return result;
}

}  // namespace

double typeset_width(const Box& box) {
  switch (box.kind) {
    case BoxKind::row:
    case BoxKind::root:
    case BoxKind::framed:
    case BoxKind::struck:
    case BoxKind::hidden:
      return sum_of_widths(box.parts) + (box.kind == BoxKind::root ? 0.9 : 0.0);
    case BoxKind::letter:
      return 0.58 * static_cast<double>(count_code_points(box.text));
    case BoxKind::number:
    case BoxKind::words:
      return 0.5 * static_cast<double>(count_code_points(box.text));
    case BoxKind::sign:
      return sign_width(box);
    case BoxKind::space:
      return std::max(0.0, box.width);
    case BoxKind::fraction:
      return (box.size < 0 ? 0.75 : 1.0) *
                 std::max(typeset_width(box.parts[0]), typeset_width(box.parts[1])) +
             0.25;
    case BoxKind::scripts: {
      const double scripts = 0.72 * std::max(typeset_width(box.parts[1]), typeset_width(box.parts[2]));
      const double base = typeset_width(box.parts[0]);
      return box.limits ? std::max(base, scripts) : base + scripts;
    }
    case BoxKind::accent:
      return typeset_width(box.parts[0]);
    case BoxKind::fence:
      return typeset_width(box.parts[0]) + 1;
    case BoxKind::table:
      return table_width(box);
  }
  return 0;
}

std::vector<Box> broken_lines(const Box& box, double width) {
  if (box.kind != BoxKind::row || typeset_width(box) <= width) return {box};
  std::vector<Box> lines;
  for (std::vector<Box>& statement : cut_before(box.parts, SignRole::relation, width)) {
    if (sum_of_widths(statement) <= width) {
      lines.push_back(line_box(std::move(statement)));
      continue;
    }
    for (std::vector<Box>& terms : cut_before(statement, SignRole::binary, width))
      lines.push_back(line_box(std::move(terms)));
  }
  return lines;
}

std::string typeset_words(std::string_view words) { return typeset_all(words, 24, false); }
std::string typeset_source(std::string_view source) { return typeset_all(source, 8, true); }

}  // namespace rigor
