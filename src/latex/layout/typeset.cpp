// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/layout/typeset.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "latex/layout/layout_reader.h"
#include "latex/layout/typeset_signs.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

std::string_view face_command(Typeface face) {
  static constexpr std::array<std::string_view, 9> commands{
      // in the order of Typeface
      "",          "\\mathrm",   "\\mathbf", "\\boldsymbol", "\\mathsf",
      "\\mathcal", "\\mathfrak", "\\mathbb", "\\mathtt"};
  return commands.at(static_cast<std::size_t>(face));
}

bool is_capital(std::string_view text) { return text.size() == 1 && text[0] >= 'A' && text[0] <= 'Z'; }
bool is_ascii_word(std::string_view text) {
  return std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
  });
}

class TypesetWriter {
 public:
  std::string take() { return std::move(out_); }

  void write(const Box& box) {
    switch (box.kind) {
      case BoxKind::row:
        out_ += '{';
        for (const Box& part : box.parts) write(part);
        out_ += '}';
        return;
      case BoxKind::letter:
      case BoxKind::number:
        return letter(box);
      case BoxKind::sign:
        return sign(box);
      case BoxKind::words:
        out_ += "\\text{" + typeset_words(box.text) + "}";
        return;
      case BoxKind::space:
        out_ += fmt::format("\\mspace{{{}mu}}", static_cast<int>(box.width * 18));
        return;
      case BoxKind::fraction:
        return fraction(box);
      case BoxKind::root:
        out_ += "\\sqrt";
        if (box.parts.size() > 1) optional(box.parts[1]);
        return group(box.parts[0]);
      case BoxKind::scripts:
        return scripts(box);
      case BoxKind::accent:
        return accent(box);
      case BoxKind::fence:
        return fence(box);
      case BoxKind::table:
        return table(box);
      case BoxKind::framed:
        out_ += "\\boxed";
        return group(box.parts[0]);
      case BoxKind::struck:
        out_ += "\\overline";
        return group(box.parts[0]);
      case BoxKind::hidden:
        out_ += "\\phantom";
        return group(box.parts[0]);
    }
  }

  /// What is in the box without braces around it, so that its signs keep their spaces.
  void open(const Box& box) {
    if (box.kind != BoxKind::row) return write(box);
    for (const Box& part : box.parts) write(part);
  }

 private:
  void group(const Box& box) {
    out_ += '{';
    open(box);
    out_ += '}';
  }

  void optional(const Box& box) {
    out_ += "[{";
    open(box);
    out_ += "}]";
  }

  void letter(const Box& box) {
    if (is_ascii_word(box.text)) {
      Typeface face = box.face;
      const bool capitals_only = face == Typeface::script || face == Typeface::blackboard;
      if (capitals_only && !is_capital(box.text)) face = Typeface::italic;
      if (box.kind == BoxKind::number && face == Typeface::upright) face = Typeface::italic;
      const std::string_view command = face_command(face);
      out_ += command.empty() ? "{" + box.text + "}" : fmt::format("{}{{{}}}", command, box.text);
      return;
    }
    const std::string sign = typeset_sign(box.text);
    const bool bold = box.face == Typeface::bold || box.face == Typeface::bold_italic;
    if (sign.empty()) {
      out_ += "\\text{" + typeset_words(box.text) + "}";
    } else {
      out_ += bold ? fmt::format("\\boldsymbol{{{}}}", sign) : fmt::format("{{{}}}", sign);
    }
  }

  void sign(const Box& box) {
    std::string text = box.text;
    if (text.find("′") != std::string::npos) {
      for (std::size_t at = 0; at < text.size(); at += std::string_view("′").size()) out_ += "\\prime ";
      return;
    }
    std::string sign = typeset_sign(text);
    if (sign.empty()) sign = "\\text{" + typeset_words(text) + "}";
    switch (box.role) {
      case SignRole::relation:
        return set_as("\\mathrel", sign);
      case SignRole::binary:
        return set_as("\\mathbin", sign);
      case SignRole::prefix:
      case SignRole::ordinary:
      case SignRole::bar:
        return set_as("", sign);
      case SignRole::opening:
        return set_as("\\mathopen", sign);
      case SignRole::closing:
        return set_as("\\mathclose", sign);
      case SignRole::punctuation:
        return set_as("\\mathpunct", sign);
      case SignRole::big:
      case SignRole::integral:
        out_ += sign + " ";
        return;
      case SignRole::word:
        return set_as("\\operatorname*", sign_word(text));
    }
  }

  void set_as(std::string_view command, std::string_view sign) {
    out_ += fmt::format("{}{{{}}}", command, sign);
  }

  static std::string sign_word(std::string_view text) {
    std::string word;
    for (const char each : text) word += each == ' ' ? std::string("\\,") : std::string(1, each);
    return word;
  }

  void fraction(const Box& box) {
    if (!box.ruled) {
      out_ += "\\genfrac{}{}{0pt}{}";
    } else {
      out_ += box.size < 0 ? "\\tfrac" : box.size > 0 ? "\\dfrac" : "\\frac";
    }
    group(box.parts[0]);
    group(box.parts[1]);
  }

  void scripts(const Box& box) {
    const Box& base = box.parts[0];
    const bool native =
        base.kind == BoxKind::sign && (base.role == SignRole::big || base.role == SignRole::word);
    const bool braced = base.kind == BoxKind::accent && base.wide;
    if (box.limits && !native && !braced) {
      // anything may be stacked, and keeps its role
      const bool lower = !is_empty(box.parts[1]);
      const bool upper = !is_empty(box.parts[2]);
      if (upper) {
        out_ += "\\overset";
        group(box.parts[2]);
        out_ += '{';
      }
      if (lower) {
        out_ += "\\underset";
        group(box.parts[1]);
        out_ += '{';
      }
      write(base);
      if (lower) out_ += '}';
      if (upper) out_ += '}';
      return;
    }
    if (native || braced) {
      write(base);
    } else {
      group(base);
    }
    for (const std::size_t k : {1U, 2U}) {
      if (is_empty(box.parts[k])) continue;
      out_ += k == 1 ? '_' : '^';
      group(box.parts[k]);
    }
  }

  void accent(const Box& box) {
    static const WordTable narrow(R"(
        ˙ \dot  ¨ \ddot  ⃛ \dddot  ⃜ \ddddot  ^ \hat  ~ \tilde  ‾ \bar  → \vec  ← \overleftarrow
        ↔ \overleftrightarrow  ˇ \check  ˘ \breve  ´ \acute  ` \grave  ˚ \mathring  _ \underline
        ⏞ \overbrace  ⏟ \underbrace)");
    static const WordTable wide(R"(
        ^ \widehat  ~ \widetilde  ‾ \overline  → \overrightarrow)");
    const std::string_view own = narrow.find(box.text);
    const std::string_view wider = box.wide ? wide.find(box.text) : "";
    const bool is_arrow_below = box.below && box.text == "→";
    if (is_arrow_below) {
      out_ += "\\underrightarrow";
    } else if (own.empty()) {
      out_ += box.below ? "\\underline" : "\\overline";
    } else {
      out_ += wider.empty() ? own : wider;
    }
    group(box.parts[0]);
  }

  static std::string delimiter(std::string_view text) {
    static const WordSet known("( ) [ ] { } | ‖ ⟨ ⟩ ⌊ ⌋ ⌈ ⌉ / ↑ ↓");
    if (text == "∖") return "\\backslash ";
    return known.contains(text) ? typeset_sign(text) : std::string();
  }

  void fence(const Box& box) {
    const std::string open_sign = delimiter(box.text);
    const std::string close_sign = delimiter(box.closing);
    if (open_sign.empty() && !box.text.empty()) out_ += "\\text{" + typeset_words(box.text) + "}";
    out_ += "\\left" + (open_sign.empty() ? "." : open_sign);
    open(box.parts[0]);
    out_ += "\\right" + (close_sign.empty() ? "." : close_sign);
    if (close_sign.empty() && !box.closing.empty()) out_ += "\\text{" + typeset_words(box.closing) + "}";
  }

  void table(const Box& box) {
    std::size_t columns = 1;
    for (std::size_t row = 0; row < box.row_ends.size(); ++row)
      columns = std::max(columns, box.row_ends[row] - (row == 0 ? 0 : box.row_ends[row - 1]));
    std::string format;
    for (std::size_t k = 0; k < columns; ++k) {
      const bool pairs = box.alignment == TableAlignment::pairs || box.alignment == TableAlignment::equations;
      format += pairs ? (k % 2 == 0 ? "r@{}" : "l") : box.alignment == TableAlignment::left ? "l" : "c";
    }
    if (box.alignment == TableAlignment::staggered) format = "l";
    out_ += "\\begin{array}{" + format + "}";
    const bool display = box.alignment != TableAlignment::centre;
    std::size_t cell = 0;
    for (std::size_t row = 0; row < box.row_ends.size(); ++row) {
      for (bool first = true; cell < box.row_ends[row]; ++cell, first = false) {
        out_ += first ? "{" : "&{}{";
        if (display) out_ += "\\displaystyle ";
        open(box.parts[cell]);
        out_ += '}';
      }
      if (!box.tags[row].empty()) out_ += "\\quad\\text{" + typeset_words(box.tags[row]) + "}";
      if (row + 1 < box.row_ends.size()) out_ += "\\\\";
    }
    out_ += "\\end{array}";
  }

  std::string out_;
};

}  // namespace

std::string to_typeset(const Box& box) {
  TypesetWriter writer;
  writer.open(box);
  return writer.take();
}

}  // namespace rigor
