// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/layout/mathml.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/among.h"
#include "base/utf8.h"
#include "base/xml.h"
#include "latex/layout/layout_reader.h"

namespace rigor {
namespace {

/// Blanks at the ends of <mtext> would be cut off.
std::string words_text(std::string_view words) {
  std::string text = xml_escaped(words);
  constexpr std::string_view hard_blank = "\u00A0";
  if (text.starts_with(' ')) text.replace(0, 1, hard_blank);
  if (text.ends_with(' ')) text.replace(text.size() - 1, 1, hard_blank);
  return text;
}

/// Signs that browsers set with the space that TeX gives them, wherever they stand (+ and − only between
/// operands).
bool has_usual_space(std::string_view sign) {
  static constexpr std::array<std::string_view, 14> signs{"=", "≈", "≡", "<", ">", "≤", "≥",
                                                          "≠", "≪", "≫", "∝", "×", "·", "±"};
  return is_one_of(sign, signs);
}

class MathmlWriter {
 public:
  std::string take() { return std::move(out_); }

  void write(const Box& box) {
    switch (box.kind) {
      case BoxKind::row:
        return row(box);
      case BoxKind::letter:
        return letter(box);
      case BoxKind::number:
        out_ += fmt::format("<mn>{}</mn>", xml_escaped(in_typeface(box.text, box.face)));
        return;
      case BoxKind::sign:
        return sign(box);
      case BoxKind::words:
        out_ += fmt::format("<mtext>{}</mtext>", words_text(box.text));
        return;
      case BoxKind::space:
        out_ += fmt::format("<mspace width=\"{:.4g}em\"></mspace>", box.width);
        return;
      case BoxKind::fraction:
        return fraction(box);
      case BoxKind::root:
        return wrapped(box.parts.size() > 1 ? "mroot" : "msqrt", "", box.parts);
      case BoxKind::scripts:
        return scripts(box);
      case BoxKind::accent:
        return accent(box);
      case BoxKind::fence:
        return fence(box);
      case BoxKind::table:
        return table(box);
      case BoxKind::framed:
        return wrapped("mrow", " class=\"framed\"", box.parts);
      case BoxKind::struck:
        return wrapped("mrow", " class=\"struck\"", box.parts);
      case BoxKind::hidden:
        return wrapped("mphantom", "", box.parts);
    }
  }

 private:
  void row(const Box& box) { wrapped("mrow", "", box.parts); }

  void wrapped(std::string_view element, std::string_view attributes, const std::vector<Box>& parts) {
    out_ += fmt::format("<{}{}>", element, attributes);
    for (const Box& part : parts) write(part);
    out_ += fmt::format("</{}>", element);
  }

  void letter(const Box& box) {
    // a single letter in <mi> is slanted unless it is said to be upright
    const bool upright = box.face == Typeface::upright && count_code_points(box.text) == 1;
    out_ += fmt::format("<mi{}>{}</mi>", upright ? " mathvariant=\"normal\"" : "",
                        xml_escaped(in_typeface(box.text, box.face)));
  }

  void sign(const Box& box) {
    std::string attributes;
    switch (box.role) {
      case SignRole::ordinary:
        attributes = " form=\"infix\" stretchy=\"false\" lspace=\"0\" rspace=\"0\"";
        break;
      case SignRole::prefix:
        attributes = " form=\"prefix\" lspace=\"0\" rspace=\"0\"";
        break;
      case SignRole::opening:
      case SignRole::closing:
        attributes = " stretchy=\"false\"";
        break;
      case SignRole::bar:
        attributes = fmt::format(" form=\"infix\" stretchy=\"{}\" lspace=\"0\" rspace=\"0\"", box.wide);
        break;
      case SignRole::binary:
        attributes =
            has_usual_space(box.text) ? "" : " form=\"infix\" lspace=\"0.2222em\" rspace=\"0.2222em\"";
        if (box.text == "+" || box.text == "−") attributes = " form=\"infix\"";
        break;
      case SignRole::relation:
        if (box.wide || !has_usual_space(box.text)) {
          attributes = fmt::format(" form=\"infix\" stretchy=\"{}\" lspace=\"0.2778em\" rspace=\"0.2778em\"",
                                   box.wide);
        }
        break;
      case SignRole::word:
        attributes = " form=\"prefix\" movablelimits=\"true\" lspace=\"0.1667em\" rspace=\"0.1667em\"";
        break;
      case SignRole::punctuation:
      case SignRole::big:
      case SignRole::integral:
        break;
    }
    if (box.size > 0) {
      static constexpr std::array<std::string_view, 5> heights{"1em", "1.2em", "1.8em", "2.4em", "3em"};
      const std::string_view height = heights.at(static_cast<std::size_t>(box.size));
      const std::string_view form = box.role == SignRole::closing   ? "postfix"
                                    : box.role == SignRole::opening ? "prefix"
                                                                    : "infix";
      attributes = fmt::format(
          " form=\"{}\" stretchy=\"true\" symmetric=\"true\" minsize=\"{}\" maxsize=\"{}\" lspace=\"0\" "
          "rspace=\"0\"",
          form, height, height);
    }
    out_ += fmt::format("<mo{}>{}</mo>", attributes, xml_escaped(box.text));
  }

  void fraction(const Box& box) {
    const std::string ruled = box.ruled ? "" : " linethickness=\"0\"";
    const std::string size = box.size == 0  ? ""
                             : box.size < 0 ? " displaystyle=\"false\" scriptlevel=\"+1\""
                                            : " displaystyle=\"true\" scriptlevel=\"0\"";
    if (box.size >= 0) return wrapped("mfrac", ruled + size, box.parts);
    out_ += "<mstyle displaystyle=\"false\">";
    wrapped("mfrac", ruled, box.parts);
    out_ += "</mstyle>";
  }

  void scripts(const Box& box) {
    const bool lower = !is_empty(box.parts[1]);
    const bool upper = !is_empty(box.parts[2]);
    const std::string_view element = box.limits ? (lower && upper ? "munderover"
                                                   : lower        ? "munder"
                                                                  : "mover")
                                                : (lower && upper ? "msubsup"
                                                   : lower        ? "msub"
                                                                  : "msup");
    out_ += fmt::format("<{}>", element);
    write(box.parts[0]);
    if (lower) write(box.parts[1]);
    if (upper) write(box.parts[2]);
    out_ += fmt::format("</{}>", element);
  }

  void accent(const Box& box) {
    const std::string_view element = box.below ? "munder" : "mover";
    out_ += fmt::format("<{} accent{}=\"true\">", element, box.below ? "under" : "");
    write(box.parts.front());
    out_ += fmt::format("<mo stretchy=\"{}\">{}</mo></{}>", box.wide, xml_escaped(box.text), element);
  }

  void fence(const Box& box) {
    out_ += "<mrow>";
    if (!box.text.empty())
      out_ +=
          fmt::format("<mo form=\"prefix\" stretchy=\"true\" fence=\"true\">{}</mo>", xml_escaped(box.text));
    write(box.parts.front());
    if (!box.closing.empty())
      out_ += fmt::format("<mo form=\"postfix\" stretchy=\"true\" fence=\"true\">{}</mo>",
                          xml_escaped(box.closing));
    out_ += "</mrow>";
  }

  static std::string_view cell_style(const Box& table, std::size_t row, std::size_t column) {
    constexpr std::string_view right = "text-align:right;padding-left:0;padding-right:0";
    constexpr std::string_view left = "text-align:left;padding-left:0;padding-right:0";
    switch (table.alignment) {
      case TableAlignment::centre:
        return {};
      case TableAlignment::left:
        return "text-align:left";
      case TableAlignment::pairs:
        if (column % 2 == 1) return left;
        return column == 0 ? right : "text-align:right;padding-left:2em;padding-right:0";
      case TableAlignment::equations:
        return column == 0 ? right : column == 1 ? "padding-left:0;padding-right:0" : left;
      case TableAlignment::staggered:
        return row == 0                           ? "text-align:left"
               : row + 1 == table.row_ends.size() ? "text-align:right"
                                                  : std::string_view{};
    }
    return {};
  }

  void table(const Box& box) {
    const bool is_displayed =
        box.alignment != TableAlignment::centre && box.alignment != TableAlignment::left;
    out_ += is_displayed ? "<mtable displaystyle=\"true\">" : "<mtable>";
    bool tagged = false;
    std::size_t columns = 0;
    for (std::size_t row = 0; row < box.row_ends.size(); ++row) {
      tagged = tagged || !box.tags[row].empty();
      columns = std::max(columns, box.row_ends[row] - (row == 0 ? 0 : box.row_ends[row - 1]));
    }
    std::size_t cell = 0;
    for (std::size_t row = 0; row < box.row_ends.size(); ++row) {
      out_ += "<mtr>";
      std::size_t column = 0;
      for (; cell < box.row_ends[row]; ++cell, ++column) {
        const std::string_view style = cell_style(box, row, column);
        out_ += style.empty() ? "<mtd>" : fmt::format("<mtd style=\"{}\">", style);
        continued(box, column, cell);
        out_ += "</mtd>";
      }
      if (tagged) {
        for (; column < columns; ++column) out_ += "<mtd></mtd>";
        out_ += fmt::format("<mtd style=\"text-align:right;padding-left:2em\"><mtext>{}</mtext></mtd>",
                            words_text(box.tags[row]));
      }
      out_ += "</mtr>";
    }
    out_ += "</mtable>";
  }

  /// A relation at the start of a cell keeps its space before it, as after an empty left side.
  void continued(const Box& table, std::size_t column, std::size_t cell) {
    const Box& box = table.parts[cell];
    const bool behind_align = table.alignment == TableAlignment::pairs && column % 2 == 1;
    if (behind_align && box.kind != BoxKind::row) {
      out_ += "<mrow><mi></mi>";
      write(box);
      out_ += "</mrow>";
      return;
    }
    if (!behind_align) return write(box);
    out_ += "<mrow><mi></mi>";
    for (const Box& part : box.parts) write(part);
    out_ += "</mrow>";
  }

  std::string out_;
};

}  // namespace

std::string to_mathml(const Box& box, MathStyle style) {
  MathmlWriter writer;
  writer.write(box);
  return fmt::format("<math{}>{}</math>", style == MathStyle::display ? " display=\"block\"" : "",
                     writer.take());
}

std::string to_mathml(TokenView tokens, MathStyle style) { return to_mathml(layout_of(tokens), style); }

}  // namespace rigor
