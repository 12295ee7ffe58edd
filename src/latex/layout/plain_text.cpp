// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/layout/plain_text.h"

#include <optional>

#include "base/among.h"
#include "base/utf8.h"
#include "latex/layout/layout_reader.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

const WordTable& superscripts() {
  static const WordTable table(R"(
      0 ⁰  1 ¹  2 ²  3 ³  4 ⁴  5 ⁵  6 ⁶  7 ⁷  8 ⁸  9 ⁹  + ⁺  − ⁻  = ⁼  ( ⁽  ) ⁾  a ᵃ  b ᵇ  c ᶜ  d ᵈ  e ᵉ
      f ᶠ  g ᵍ  h ʰ  i ⁱ  j ʲ  k ᵏ  l ˡ  m ᵐ  n ⁿ  o ᵒ  p ᵖ  r ʳ  s ˢ  t ᵗ  u ᵘ  v ᵛ  w ʷ  x ˣ  y ʸ  z ᶻ
      N ᴺ  T ᵀ  ′ ′)");
  return table;
}

const WordTable& subscripts() {
  static const WordTable table(R"(
      0 ₀  1 ₁  2 ₂  3 ₃  4 ₄  5 ₅  6 ₆  7 ₇  8 ₈  9 ₉  + ₊  − ₋  = ₌  ( ₍  ) ₎  a ₐ  e ₑ  h ₕ  i ᵢ  j ⱼ
      k ₖ  l ₗ  m ₘ  n ₙ  o ₒ  p ₚ  r ᵣ  s ₛ  t ₜ  u ᵤ  v ᵥ  x ₓ  ′ ′)");
  return table;
}

/// The text with each character raised or lowered; nothing where one has no such form.
std::optional<std::string> shifted(std::string_view text, const WordTable& table) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t next = at;
    static_cast<void>(next_code_point(text, next));
    const std::string_view one = text.substr(at, next - at);
    at = next;
    if (one == " ") continue;
    const std::string_view found = table.find(one);
    if (found.empty()) return std::nullopt;
    result += found;
  }
  return result;
}

std::string_view combining_mark(std::string_view accent) {
  static const WordTable marks(
      "˙ \u0307  ¨ \u0308  ⃛ \u20DB  ⃜ \u20DC  ^ \u0302  ~ \u0303  ‾ \u0304  → \u20D7  ↔ \u20E1  ← \u20D6  "
      "ˇ \u030C  ˘ \u0306  ´ \u0301  ` \u0300  ˚ \u030A  _ \u0332");
  return marks.find(accent);
}

std::string_view common_fraction(std::string_view written) {
  static const WordTable table("1/2 ½  1/3 ⅓  2/3 ⅔  1/4 ¼  3/4 ¾  1/6 ⅙  1/8 ⅛");
  return table.find(written);
}

/// One letter, number or bracket, with its scripts: needs no brackets around it.
bool is_atomic(const Box& box) {
  switch (box.kind) {
    case BoxKind::letter:
    case BoxKind::number:
    case BoxKind::sign:
    case BoxKind::accent:
    case BoxKind::fence:
    case BoxKind::root:
    case BoxKind::framed:
      return true;
    case BoxKind::scripts:
      return is_atomic(box.parts.front());
    default:
      return false;
  }
}

class PlainWriter {
 public:
  std::string take() {
    while (out_.ends_with(' ')) out_.pop_back();
    return std::move(out_);
  }

  void write(const Box& box) {
    switch (box.kind) {
      case BoxKind::row:
        return row(box);
      case BoxKind::letter:
      case BoxKind::number:
        out_ += printable(box.text);
        return;
      case BoxKind::sign:
        return sign(box, box.text);
      case BoxKind::words:
        out_ += printable(box.text);
        return;
      case BoxKind::space:
        if (box.width > 0) blank();
        if (box.width >= 1) out_ += ' ';
        return;
      case BoxKind::fraction:
        return fraction(box);
      case BoxKind::root:
        return root(box);
      case BoxKind::scripts:
        return scripts(box);
      case BoxKind::accent:
        return accent(box);
      case BoxKind::fence:
        return fence(box);
      case BoxKind::table:
        return table(box);
      case BoxKind::framed:
      case BoxKind::struck:
        return write(box.parts.front());
      case BoxKind::hidden:
        return blank();
    }
  }

 private:
  static std::string text_of_box(const Box& box) {
    PlainWriter writer;
    writer.write(box);
    return writer.take();
  }

  /// In brackets unless it is one piece.
  static std::string operand(const Box& box) {
    const std::string text = text_of_box(box);
    return is_atomic(box) ? text : "(" + text + ")";
  }

  void blank() {
    if (!out_.empty() && !out_.ends_with(' ')) out_ += ' ';
  }

  void row(const Box& box) {
    for (std::size_t k = 0; k < box.parts.size(); ++k) {
      const Box& part = box.parts[k];
      const bool more = k + 1 < box.parts.size() && role_of(box.parts[k + 1]) == SignRole::ordinary;
      if (part.kind != BoxKind::fraction || !more) {
        write(part);
        continue;
      }
      const std::string text = text_of_box(part);
      out_ += text.find('/') == std::string::npos ? text : "(" + text + ")";
    }
  }

  void sign(const Box& box, std::string_view text) {
    const bool tight = is_one_of(text, {"×", "·", "∗", "∘"});
    if (box.role == SignRole::relation || (box.role == SignRole::binary && !tight)) {
      blank();
      out_ += printable(text);
      out_ += ' ';
      return;
    }
    out_ += printable(text);
    if (box.role == SignRole::punctuation || box.role == SignRole::word) out_ += ' ';
  }

  void fraction(const Box& box) {
    const std::string text = operand(box.parts[0]) + (box.ruled ? "/" : " above ") + operand(box.parts[1]);
    const std::string_view common = common_fraction(text);
    out_ += common.empty() ? text : common;
  }

  void root(const Box& box) {
    const std::string degree = box.parts.size() > 1 ? text_of_box(box.parts[1]) : "";
    if (!degree.empty()) out_ += shifted(degree, superscripts()).value_or("(" + degree + ")");
    out_ += "√" + operand(box.parts[0]);
  }

  void scripts(const Box& box) {
    const Box& base = box.parts[0];
    const std::string lower = text_of_box(box.parts[1]);
    const std::string upper = text_of_box(box.parts[2]);
    if (base.kind == BoxKind::sign && base.role == SignRole::relation) {
      sign(base,
           base.text + (upper.empty() ? "" : "[" + upper + "]") + (lower.empty() ? "" : "[" + lower + "]"));
      return;
    }
    if (base.kind == BoxKind::accent && box.limits) {
      write(base);
      out_ += " [" + lower + upper + "]";
      return;
    }
    if (base.kind == BoxKind::fraction) {
      out_ += "(" + text_of_box(base) + ")";
    } else {
      write(base);
      while (out_.ends_with(' ')) out_.pop_back();
    }
    script(box.parts[1], lower, "_", subscripts());
    script(box.parts[2], upper, "^", superscripts());
    const SignRole role = role_of(base);
    if (role == SignRole::big || role == SignRole::integral || role == SignRole::word) out_ += ' ';
  }

  void script(const Box& box, const std::string& text, std::string_view mark, const WordTable& table) {
    if (text.empty()) return;
    const bool is_word = box.kind == BoxKind::letter && count_code_points(text) > 1;
    if (const auto small = shifted(text, table); small && !is_word) {
      out_ += *small;
      return;
    }
    out_ += mark;
    out_ += is_atomic(box) ? text : "(" + text + ")";
  }

  void accent(const Box& box) {
    const std::string text = text_of_box(box.parts.front());
    const std::string_view mark = combining_mark(box.text);
    if (mark.empty() || count_code_points(text) == 1) {
      out_ += text;
      out_ += mark;
    } else {
      out_ += "(" + text + ")";
      out_ += mark;
    }
  }

  void fence(const Box& box) {
    out_ += printable(box.text);
    const std::string inside = text_of_box(box.parts.front());
    out_ += inside + printable(box.closing);
  }

  void table(const Box& box) {
    const bool joined = box.alignment == TableAlignment::pairs ||
                        box.alignment == TableAlignment::equations ||
                        box.alignment == TableAlignment::staggered;
    std::size_t cell = 0;
    for (std::size_t row = 0; row < box.row_ends.size(); ++row) {
      std::string text;
      for (bool first = true; cell < box.row_ends[row]; ++cell, first = false) {
        const std::string one = text_of_box(box.parts[cell]);
        if (!first) text += joined ? (text.empty() || one.empty() ? "" : " ") : ", ";
        text += one;
      }
      if (row > 0) out_ += joined && goes_on(box, row) ? " " : "; ";
      out_ += text;
    }
  }

  /// Does the row begin with a relation or a sign, so that it belongs to the row above?
  static bool goes_on(const Box& table, std::size_t row) {
    for (std::size_t cell = table.row_ends[row - 1]; cell < table.row_ends[row]; ++cell) {
      const Box& box = table.parts[cell];
      if (is_empty(box)) continue;
      const Box& first = box.kind == BoxKind::row ? box.parts.front() : box;
      const SignRole role = role_of(first);
      return role == SignRole::relation || role == SignRole::prefix || role == SignRole::binary;
    }
    return true;
  }

  std::string out_;
};

}  // namespace

std::string to_plain_text(const Box& box) {
  PlainWriter writer;
  writer.write(box);
  return writer.take();
}

std::string to_plain_text(TokenView tokens) { return to_plain_text(layout_of(tokens)); }

}  // namespace rigor
