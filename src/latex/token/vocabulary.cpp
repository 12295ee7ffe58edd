// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/vocabulary.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

namespace rigor {
namespace {

using Words = std::unordered_set<std::string_view>;

bool is_control(const Token& token, const Words& words) {
  return token.kind == TokenKind::control && words.contains(token.text);
}

const std::unordered_map<std::string_view, RelationKind>& relations() {
  static const std::unordered_map<std::string_view, RelationKind> table = [] {
    std::unordered_map<std::string_view, RelationKind> relation{
        {"equiv", RelationKind::identical}, {"coloneqq", RelationKind::defines},
        {"coloneq", RelationKind::defines}, {"triangleq", RelationKind::defines},
        {"eqdef", RelationKind::defines},   {"eqcolon", RelationKind::other},
        {"doteq", RelationKind::other},     {"lt", RelationKind::less},
        {"gt", RelationKind::greater},      {"ll", RelationKind::much_less},
        {"gg", RelationKind::much_greater}};
    for (const char* word : {"le", "leq", "leqslant"}) relation.emplace(word, RelationKind::less_or_equal);
    for (const char* word : {"ge", "geq", "geqslant"}) relation.emplace(word, RelationKind::greater_or_equal);
    for (const char* word : {"ne", "neq"}) relation.emplace(word, RelationKind::unequal);
    for (const char* word : {"approx", "simeq", "cong", "approxeq"})
      relation.emplace(word, RelationKind::nearly);
    for (const char* word : {"sim",        "propto",     "in",     "notin",          "ni",
                             "subset",     "subseteq",   "supset", "perp",           "parallel",
                             "to",         "rightarrow", "mapsto", "longrightarrow", "leftrightarrow",
                             "lesssim",    "gtrsim",     "prec",   "succ",           "asymp",
                             "longmapsto", "leftarrow",  "gets"}) {
      relation.emplace(word, RelationKind::other);
    }
    for (const char* word : {"Rightarrow", "implies", "Longrightarrow", "iff", "Leftrightarrow",
                             "Longleftrightarrow", "impliedby", "Leftarrow", "Longleftarrow"}) {
      relation.emplace(word, RelationKind::implies);
    }
    return relation;
  }();
  return table;
}

const std::unordered_map<std::string_view, RelationKind>& relations_by_name() {
  using enum RelationKind;
  static const std::unordered_map<std::string_view, RelationKind> table{{"≡", identical},
                                                                        {"≤", less_or_equal},
                                                                        {"⩽", less_or_equal},
                                                                        {"≦", less_or_equal},
                                                                        {"≥", greater_or_equal},
                                                                        {"⩾", greater_or_equal},
                                                                        {"≧", greater_or_equal},
                                                                        {"≠", unequal},
                                                                        {"≈", nearly},
                                                                        {"≃", nearly},
                                                                        {"≅", nearly},
                                                                        {"≊", nearly},
                                                                        {"≪", much_less},
                                                                        {"≫", much_greater},
                                                                        {"⇒", implies},
                                                                        {"⇔", implies},
                                                                        {"∝", other},
                                                                        {"∼", other},
                                                                        {"∈", other},
                                                                        {"→", other},
                                                                        {"⟂", other}};
  return table;
}

const std::unordered_map<std::string_view, Style>& styles() {
  static const std::unordered_map<std::string_view, Style> table = [] {
    std::unordered_map<std::string_view, Style> style;
    for (const char* word :
         {"mathbf", "boldsymbol", "bm", "pmb", "vec", "overrightarrow", "vb", "va", "vectorbold",
          "vectorarrow", "mathbfit", "symbf", "symbfit", "bold", "bf", "vv", "underline"}) {
      style.emplace(word, Style{.face = Face::vector});
    }
    for (const char* word : {"hat", "widehat"}) style.emplace(word, Style{.accent = Accent::hat});
    for (const char* word : {"vu", "vectorunit"})
      style.emplace(word, Style{.face = Face::vector, .accent = Accent::hat});
    for (const char* word : {"overleftrightarrow", "tensor", "mathsf", "mathbfsf"}) {
      style.emplace(word, Style{.face = Face::tensor});
    }
    for (const char* word : {"bar", "overline"}) style.emplace(word, Style{.accent = Accent::bar});
    for (const char* word : {"tilde", "widetilde"}) style.emplace(word, Style{.accent = Accent::tilde});
    for (const char* word : {"mathrm", "operatorname", "mathup", "rm"})
      style.emplace(word, Style{.upright = true});
    for (const char* word : {"mathit", "mathnormal"}) style.emplace(word, Style{});
    for (const char* word : {"mathcal", "mathscr", "mathfrak", "mathbb"})
      style.emplace(word, Style{.alphabet = word});
    return style;
  }();
  return table;
}

struct GreekLetter {
  std::string_view name;
  std::string_view sign;
};

constexpr std::array greek_letters{
    GreekLetter{"alpha", "α"},   GreekLetter{"beta", "β"},    GreekLetter{"gamma", "γ"},
    GreekLetter{"delta", "δ"},   GreekLetter{"epsilon", "ε"}, GreekLetter{"zeta", "ζ"},
    GreekLetter{"eta", "η"},     GreekLetter{"theta", "θ"},   GreekLetter{"iota", "ι"},
    GreekLetter{"kappa", "κ"},   GreekLetter{"lambda", "λ"},  GreekLetter{"mu", "μ"},
    GreekLetter{"nu", "ν"},      GreekLetter{"xi", "ξ"},      GreekLetter{"pi", "π"},
    GreekLetter{"rho", "ρ"},     GreekLetter{"sigma", "σ"},   GreekLetter{"tau", "τ"},
    GreekLetter{"upsilon", "υ"}, GreekLetter{"phi", "φ"},     GreekLetter{"chi", "χ"},
    GreekLetter{"psi", "ψ"},     GreekLetter{"omega", "ω"},   GreekLetter{"Gamma", "Γ"},
    GreekLetter{"Delta", "Δ"},   GreekLetter{"Theta", "Θ"},   GreekLetter{"Lambda", "Λ"},
    GreekLetter{"Xi", "Ξ"},      GreekLetter{"Pi", "Π"},      GreekLetter{"Sigma", "Σ"},
    GreekLetter{"Upsilon", "Υ"}, GreekLetter{"Phi", "Φ"},     GreekLetter{"Psi", "Ψ"},
    GreekLetter{"Omega", "Ω"},   GreekLetter{"epsilon", "ϵ"}, GreekLetter{"varphi", "ϕ"},
    GreekLetter{"vartheta", "ϑ"}};

constexpr std::string_view field_derivative = "this derivative is not read";
constexpr std::string_view transcendental = "functions such as this one are not decided yet";

}  // namespace

std::optional<RelationKind> relation_kind(const Token& token) {
  if (token.kind == TokenKind::other) {
    if (token.text == "=") return RelationKind::equal;
    if (token.text == "<") return RelationKind::less;
    if (token.text == ">") return RelationKind::greater;
    return std::nullopt;
  }
  if (token.kind == TokenKind::letter) {
    const auto found = relations_by_name().find(token.text);
    return found == relations_by_name().end() ? std::nullopt : std::optional(found->second);
  }
  if (token.kind != TokenKind::control) return std::nullopt;
  const auto found = relations().find(token.text);
  return found == relations().end() ? std::nullopt : std::optional(found->second);
}

bool is_spacing(const Token& token) {
  static const Words words{",",
                           ":",
                           ";",
                           "!",
                           " ",
                           ">",
                           "/",
                           "thinspace",
                           "medspace",
                           "thickspace",
                           "negthinspace",
                           "enspace",
                           "displaystyle",
                           "textstyle",
                           "scriptstyle",
                           "nonumber",
                           "notag",
                           "limits",
                           "nolimits",
                           "mathstrut",
                           "strut",
                           "hfill",
                           "allowbreak",
                           "nobreak",
                           "relax",
                           "mathopen",
                           "mathclose",
                           "null",
                           "noindent",
                           "displaybreak",
                           "centering",
                           "small",
                           "footnotesize",
                           "normalsize",
                           "large",
                           "protect",
                           "qedhere",
                           "-"};
  if (token.kind == TokenKind::space || token.kind == TokenKind::paragraph) return true;
  if (token.kind == TokenKind::other && token.text == "~") return true;
  if (token.kind == TokenKind::control && !token.text.empty()) {
    const char first = token.text.front();
    if (token.text.size() == 1 && (first == ' ' || first == '\n' || first == '\t' || first == '\r'))
      return true;
  }
  return is_control(token, words);
}

bool is_bracket_size(const Token& token) {
  static const Words words{"left", "right", "middle", "big",   "Big",   "bigg",  "Bigg", "bigl", "bigr",
                           "Bigl", "Bigr",  "biggl",  "biggr", "Biggl", "Biggr", "bigm", "Bigm"};
  return is_control(token, words);
}

bool is_wide_space(const Token& token) {
  static const Words words{"quad", "qquad", "hspace", "hphantom"};
  return is_control(token, words);
}

bool is_words(const Token& token) {
  static const Words words{"text",       "mbox",           "textrm", "textit", "textbf",
                           "textnormal", "hbox",           "textsf", "emph",   "fbox",
                           "intertext",  "shortintertext", "qq",     "texttt", "textsc"};
  return is_control(token, words);
}

bool is_transparent(const Token& token) {
  static const Words words{"boxed",   "ensuremath", "mathord", "mathinner", "Aboxed",
                           "mathrel", "mathbin",    "mathop",  "smash"};
  return is_control(token, words);
}

bool is_transparent_environment(std::string_view name) {
  static const Words words{"aligned",  "split",        "gathered",  "alignedat", "align",     "align*",
                           "gather",   "gather*",      "equation",  "equation*", "multline",  "multline*",
                           "eqnarray", "eqnarray*",    "alignat",   "alignat*",  "multlined", "flalign",
                           "flalign*", "subequations", "lgathered", "rgathered"};
  return words.contains(name);
}

std::string letter_of(const Token& token) {
  if (token.kind == TokenKind::control) {
    if (token.text == "varepsilon") return "\\epsilon";
    if (token.text == "square" || token.text == "Box") return std::string(hole_letter);
    if (token.text == "imath" || token.text == "jmath" || token.text == "ell" || token.text == "hbar" ||
        token.text == "varphi" || token.text == "vartheta" || token.text == "varrho" ||
        token.text == "varsigma" || token.text == "varkappa") {
      return "\\" + std::string(token.text);
    }
    for (const GreekLetter& letter : greek_letters) {
      if (token.text == letter.name) return "\\" + std::string(token.text);
    }
    return {};
  }
  if (token.kind != TokenKind::letter) return {};
  if (token.text.size() == 1) return std::string(token.text);
  for (const GreekLetter& letter : greek_letters) {
    if (token.text == letter.sign) return "\\" + std::string(letter.name);
  }
  return {};
}

bool is_greek(std::string_view letter) {
  return letter.size() > 1 && letter.front() == '\\' && letter != hole_letter && letter != "\\ell" &&
         letter != "\\imath" && letter != "\\jmath" && letter != "\\hbar";
}

bool is_asking_mark(std::span<const Token> tokens, std::size_t at) {
  const auto is_mark = [&](std::size_t k) {
    return k < tokens.size() && tokens[k].kind == TokenKind::other && tokens[k].text == "?";
  };
  const auto is_empty = [&](std::size_t k) {
    return tokens[k].kind == TokenKind::space || tokens[k].kind == TokenKind::align || is_spacing(tokens[k]);
  };
  if (!is_mark(at) || is_mark(at + 1) || (at > 0 && is_mark(at - 1))) return false;
  std::size_t before = at;
  while (before > 0 && is_empty(before - 1)) --before;
  if (before == 0) return true;
  static constexpr std::string_view openings = "+-/([{|";
  const Token& left = tokens[before - 1];
  if (factor_joint(left) != Joint::none || relation_kind(left)) return true;
  if (left.kind == TokenKind::other && openings.find(left.text) != std::string_view::npos) return true;
  std::size_t behind = at + 1;
  while (behind < tokens.size() && is_empty(behind)) ++behind;
  if (behind == tokens.size()) return false;
  const TokenKind right = tokens[behind].kind;  // a factor goes on behind it
  return right == TokenKind::letter || right == TokenKind::control || right == TokenKind::subscript;
}

std::optional<Style> style_of(const Token& token) {
  if (token.kind != TokenKind::control) return std::nullopt;
  const auto found = styles().find(token.text);
  return found == styles().end() ? std::nullopt : std::optional(found->second);
}

Joint factor_joint(const Token& token) {
  static const Words dots{"cdot", "cdotp", "vdot", "dotproduct", "bullet"};
  static const Words crosses{"times", "cross", "crossproduct", "cp"};
  if (is_control(token, dots)) return Joint::dot;
  if (is_control(token, crosses)) return Joint::cross;
  if (token.kind == TokenKind::letter && (token.text == "·" || token.text == "⋅")) return Joint::dot;
  if (token.kind == TokenKind::letter && token.text == "×") return Joint::cross;
  if (token.kind == TokenKind::other && token.text == "/") return Joint::slash;
  return Joint::none;
}

bool is_fraction(const Token& token) {
  static const Words words{"frac", "tfrac", "dfrac", "cfrac", "nicefrac", "sfrac"};
  return is_control(token, words);
}

std::uint8_t dots_of(const Token& token) {
  static constexpr std::array<std::string_view, 4> names{"dot", "ddot", "dddot", "ddddot"};
  if (token.kind != TokenKind::control) return 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (token.text == names[k]) return static_cast<std::uint8_t>(k + 1);
  }
  return 0;
}

bool is_usual_angle(std::string_view letter) {
  static const Words angles{"\\theta", "\\vartheta", "\\phi", "\\varphi",   "\\psi",   "\\alpha", "\\beta",
                            "\\gamma", "\\chi",      "\\eta", "\\vartheta", "\\Theta", "\\Phi"};
  return angles.contains(letter);
}

std::string_view function_name(std::string_view word) {
  static const Words functions{"sin",  "cos",  "tan", "cot", "sec", "csc", "sinh",
                               "cosh", "tanh", "exp", "ln",  "log", "det", "tr"};
  if (word == "Tr" || word == "trace" || word == "Trace") return "tr";
  if (word == "determinant") return "det";
  const auto found = functions.find(word);
  return found == functions.end() ? std::string_view{} : *found;
}

std::optional<FieldOperator> field_operator(std::string_view word) {
  static const std::unordered_map<std::string_view, FieldOperator> table{
      {"grad", FieldOperator::gradient},  {"gradient", FieldOperator::gradient},
      {"div", FieldOperator::divergence}, {"divergence", FieldOperator::divergence},
      {"curl", FieldOperator::curl},      {"laplacian", FieldOperator::laplacian}};
  const auto found = table.find(word);
  return found == table.end() ? std::nullopt : std::optional(found->second);
}

std::string_view unread_reason(std::string_view control) {
  static const std::unordered_map<std::string_view, std::string_view> table = [] {
    std::unordered_map<std::string_view, std::string_view> reason;
    for (const char* word : {"fdv", "functionalderivative"}) reason.emplace(word, field_derivative);
    for (const char* word : {"arcsin", "arccos", "arctan", "max", "min", "arg", "sgn", "coth", "lg"})
      reason.emplace(word, transcendental);
    for (const char* word : {"iint", "oint", "oiint"})
      reason.emplace(word, "only integrals over a body (`dm`, `dV`, `d^3r`) are read");
    for (const char* word : {"dd", "differential"})
      reason.emplace(word, "a differential by itself is not read");
    for (const char* word : {"prod", "bigcup", "bigcap", "bigoplus"})
      reason.emplace(word, "this operator is not read");
    for (const char* word : {"lim", "sup", "inf", "limsup"})
      reason.emplace(word, "limits are not decided yet");
    for (const char* word : {"pm", "mp"})
      reason.emplace(word, "`\\pm` and `\\mp` stand for two statements, which are not read yet");
    for (const char* word : {"dots", "ldots", "cdots", "dotsb", "dotsc", "vdots", "ddots"}) {
      reason.emplace(word, "an ellipsis does not say what is left out");
    }
    for (const char* word : {"wedge", "otimes", "oplus", "circ", "star", "ast"}) {
      reason.emplace(word, "this product is not read; write `\\times` or `\\cdot`");
    }
    for (const char* word : {"cancel", "bcancel", "xcancel", "cancelto"})
      reason.emplace(word, "a cancelled term is not read");
    for (const char* word : {"langle", "rangle", "bra", "ket", "braket", "expval"})
      reason.emplace(word, "brackets of states or averages are not read");
    for (const char* word : {"infty"}) reason.emplace(word, "infinity is not a number");
    return reason;
  }();
  const auto found = table.find(control);
  return found == table.end() ? std::string_view{} : found->second;
}

bool is_subscript_word(std::string_view letters) {
  static const Words words{"rot", "trans", "tot",  "cm",   "com",     "out",   "ext", "int",  "kin",
                           "pot", "max",   "min",  "eff",  "spin",    "orb",   "lab", "rel",  "net",
                           "avg", "rms",   "body", "sys",  "orbital", "total", "ref", "grav", "elec",
                           "mag", "new",   "old",  "crit", "init",    "final", "stat"};
  if (letters.size() < 2) return false;
  const bool capitals =
      std::all_of(letters.begin(), letters.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
  return capitals || words.contains(letters);
}

}  // namespace rigor
