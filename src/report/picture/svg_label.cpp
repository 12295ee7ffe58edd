// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/picture/svg_label.h"

#include <array>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "base/utf8.h"
#include "base/xml.h"
#include "report/picture/svg.h"

namespace rigor {
namespace {

struct LabelSign {
  std::string_view command;
  std::string_view text;
};

constexpr std::array signs{
    LabelSign{"alpha", "α"},    LabelSign{"beta", "β"},    LabelSign{"gamma", "γ"},
    LabelSign{"delta", "δ"},    LabelSign{"epsilon", "ϵ"}, LabelSign{"varepsilon", "ε"},
    LabelSign{"zeta", "ζ"},     LabelSign{"eta", "η"},     LabelSign{"theta", "θ"},
    LabelSign{"vartheta", "ϑ"}, LabelSign{"iota", "ι"},    LabelSign{"kappa", "κ"},
    LabelSign{"lambda", "λ"},   LabelSign{"mu", "μ"},      LabelSign{"nu", "ν"},
    LabelSign{"xi", "ξ"},       LabelSign{"pi", "π"},      LabelSign{"rho", "ρ"},
    LabelSign{"sigma", "σ"},    LabelSign{"tau", "τ"},     LabelSign{"upsilon", "υ"},
    LabelSign{"phi", "φ"},      LabelSign{"varphi", "φ"},  LabelSign{"chi", "χ"},
    LabelSign{"psi", "ψ"},      LabelSign{"omega", "ω"},   LabelSign{"Gamma", "Γ"},
    LabelSign{"Delta", "Δ"},    LabelSign{"Theta", "Θ"},   LabelSign{"Lambda", "Λ"},
    LabelSign{"Xi", "Ξ"},       LabelSign{"Pi", "Π"},      LabelSign{"Sigma", "Σ"},
    LabelSign{"Phi", "Φ"},      LabelSign{"Psi", "Ψ"},     LabelSign{"Omega", "Ω"},
    LabelSign{"ell", "ℓ"},      LabelSign{"cdot", "·"},    LabelSign{"times", "×"},
    LabelSign{"sum", "Σ"},      LabelSign{"infty", "∞"},   LabelSign{"sqrt", "√"},
    LabelSign{"approx", "≈"},   LabelSign{"le", "≤"},      LabelSign{"ge", "≥"},
    LabelSign{"pm", "±"},       LabelSign{"partial", "∂"}, LabelSign{"nabla", "∇"},
    LabelSign{"Vert", "‖"},     LabelSign{"|", "‖"},       LabelSign{"circ", "°"},
    LabelSign{"degree", "°"},   LabelSign{",", " "},       LabelSign{";", " "},
    LabelSign{"quad", "  "},    LabelSign{"prime", "′"},   LabelSign{"left", ""},
    LabelSign{"right", ""},     LabelSign{"{", "{"},       LabelSign{"}", "}"},
};
/// What is over the letter before it: combining marks.
constexpr std::array accents{
    LabelSign{"dot", "\u0307"},
    LabelSign{"ddot", "\u0308"},
    LabelSign{"hat", "\u0302"},
    LabelSign{"bar", "\u0304"},
    LabelSign{"vec", "\u20d7"},
    LabelSign{"tilde", "\u0303"},
    LabelSign{"overleftrightarrow", "\u20e1"},
};
constexpr std::array<std::string_view, 5> bold_faces{"mathbf", "boldsymbol", "bm", "vb", "mathsf"};
constexpr std::array<std::string_view, 4> upright_faces{"text", "mathrm", "textrm", "operatorname"};

template <class Table>
const LabelSign* find(const Table& table, std::string_view command) {
  for (const LabelSign& sign : table) {
    if (sign.command == command) return &sign;
  }
  return nullptr;
}

struct LabelStyle {
  bool bold = false;
  bool italic = true;
  int level = 0;  // 1: superscript, -1: subscript
};

/// Mathematics to pieces of one style each. What is nested deeper than the stack allows is shown as it is.
class LabelReader {
 public:
  explicit LabelReader(std::string_view text) : text_(text) {}

  std::vector<std::pair<LabelStyle, std::string>> read() {
    group(LabelStyle{}, 0, false);
    return std::move(pieces_);
  }

 private:
  static constexpr int deepest = 20;

  void put(const LabelStyle& style, std::string_view what) {
    if (what.empty()) return;
    pieces_.emplace_back(style, std::string(what));
  }

  [[nodiscard]] std::string_view command() {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    if (at_ == begin && at_ < text_.size()) ++at_;
    const std::string_view name = text_.substr(begin, at_ - begin);
    while (!name.empty() && is_letter(name[0]) && at_ < text_.size() && text_[at_] == ' ') {
      ++at_;
    }
    return name;
  }

  /// One letter, one command, or what is in braces.
  void argument(const LabelStyle& style, int depth) {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (at_ >= text_.size()) return;
    if (text_[at_] == '{') {
      ++at_;
      group(style, depth + 1, true);
    } else {
      one(style, depth + 1);
    }
  }

  void letter(LabelStyle style) {
    const std::size_t begin = at_;
    (void)next_code_point(text_, at_);
    const char first = text_[begin];
    const bool slanted = (first & 0x80) != 0 || is_letter(first);
    style.italic = style.italic && slanted && !style.bold;
    put(style, first == '-' ? "−" : first == '\'' ? "′" : text_.substr(begin, at_ - begin));
  }

  void one(const LabelStyle& style, int depth) {
    if (depth > deepest) {
      letter(style);
      return;
    }
    const char next = text_[at_];
    if (next == '\\') {
      named(style, depth);
    } else if (next == '_' || next == '^') {
      ++at_;
      LabelStyle raised = style;
      raised.level = next == '^' ? 1 : -1;
      argument(raised, depth);
    } else {
      letter(style);
    }
  }

  void named(LabelStyle style, int depth) {
    const std::string_view name = command();
    if (const LabelSign* accent = find(accents, name)) {
      argument(style, depth);
      if (!pieces_.empty()) pieces_.back().second += accent->text;
    } else if (is_one_of(name, bold_faces)) {
      style.bold = true;
      argument(style, depth);
    } else if (is_one_of(name, upright_faces)) {
      style.italic = false;
      argument(style, depth);
    } else if (name == "frac") {
      argument(style, depth);
      put(style, "/");
      argument(style, depth);
    } else if (const LabelSign* sign = find(signs, name)) {
      style.italic = style.italic && !style.bold && !name.empty() && is_small_letter(name[0]);
      put(style, sign->text);
    } else {
      style.italic = false;
      put(style, name);
    }
  }

  void group(const LabelStyle& style, int depth, bool closes) {
    while (at_ < text_.size()) {
      if (text_[at_] == '}') {
        ++at_;
        if (closes) return;
      } else if (text_[at_] == '{') {
        ++at_;
        if (depth < deepest) group(style, depth + 1, true);
      } else {
        one(style, depth);
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<std::pair<LabelStyle, std::string>> pieces_;
};

/// Calls `plain` and `mathematics` with the parts of a text, in order.
template <class Plain, class Mathematics>
void split_at_dollars(std::string_view text, Plain plain, Mathematics mathematics) {
  while (!text.empty()) {
    const std::size_t open = text.find('$');
    const std::size_t close = open == text.npos ? text.npos : text.find('$', open + 1);
    if (close == text.npos) {
      plain(text);
      return;
    }
    plain(text.substr(0, open));
    mathematics(text.substr(open + 1, close - open - 1));
    text.remove_prefix(close + 1);
  }
}

std::string markup(const std::vector<std::pair<LabelStyle, std::string>>& pieces) {
  std::string all;
  int level = 0;
  for (const auto& [style, text] : pieces) {
    all += "<tspan";
    // Shifts are relative to the text before, and a viewer that knows no `baseline-shift` knows `dy`.
    const double shift = (level - style.level) * 4.0;
    if (shift != 0) all += " dy=\"" + svg_number(shift) + '"';
    if (style.level != 0) all += " font-size=\"75%\"";
    if (style.bold) all += " font-weight=\"bold\"";
    if (style.italic) all += " font-style=\"italic\"";
    all += '>' + xml_escaped(text) + "</tspan>";
    level = style.level;
  }
  // An empty piece moves nothing in some viewers; a zero-width blank does.
  if (level != 0) all += "<tspan dy=\"" + svg_number(level * 4.0) + "\">\u200b</tspan>";
  return all;
}

}  // namespace

std::string svg_label(std::string_view text) {
  std::string all;
  split_at_dollars(
      text, [&](std::string_view plain) { all += xml_escaped(plain); },
      [&](std::string_view formula) { all += markup(LabelReader(formula).read()); });
  return all;
}

double svg_label_letters(std::string_view text) {
  double letters = 0;
  split_at_dollars(
      text, [&](std::string_view plain) { letters += static_cast<double>(cells(plain)); },
      [&](std::string_view formula) {
        for (const auto& [style, piece] : LabelReader(formula).read()) {
          letters += static_cast<double>(cells(piece)) * (style.level == 0 ? 1.0 : 0.75);
        }
      });
  return letters;
}

}  // namespace rigor
