// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/vocabulary.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "base/ascii.h"
#include "latex/token/tokens.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

const WordMap<RelationKind>& relations() {
  using enum RelationKind;
  static const WordMap<RelationKind> table{
      {"equiv", identical},
      {"coloneqq coloneq triangleq eqdef", defines},
      {"lt", less},
      {"gt", greater},
      {"ll", much_less},
      {"gg", much_greater},
      {"le leq leqslant", less_or_equal},
      {"ge geq geqslant", greater_or_equal},
      {"ne neq", unequal},
      {"approx simeq cong approxeq", nearly},
      {"eqcolon doteq sim propto in notin ni subset subseteq supset perp parallel to rightarrow mapsto "
       "longrightarrow leftrightarrow lesssim gtrsim prec succ asymp longmapsto leftarrow gets",
       other},
      {"Rightarrow implies Longrightarrow iff Leftrightarrow Longleftrightarrow impliedby Leftarrow "
       "Longleftarrow",
       implies}};
  return table;
}

const WordMap<RelationKind>& relations_by_name() {
  using enum RelationKind;
  static const WordMap<RelationKind> table{
      {"≡", identical},    {"≤ ⩽ ≦", less_or_equal}, {"≥ ⩾ ≧", greater_or_equal},
      {"≠", unequal},      {"≈ ≃ ≅ ≊", nearly},      {"≪", much_less},
      {"≫", much_greater}, {"⇒ ⇔", implies},         {"∝ ∼ ∈ → ⟂", other}};
  return table;
}

const WordMap<Style>& styles() {
  static const WordMap<Style> table{
      {"mathbf boldsymbol bm pmb vec overrightarrow vb va vectorbold vectorarrow mathbfit symbf symbfit bold "
       "bf vv underline",
       {.face = Face::vector}},
      {"hat widehat", {.accent = Accent::hat}},
      {"vu vectorunit", {.face = Face::vector, .accent = Accent::hat}},
      {"overleftrightarrow tensor mathsf mathbfsf", {.face = Face::tensor}},
      {"bar overline", {.accent = Accent::bar}},
      {"tilde widetilde", {.accent = Accent::tilde}},
      {"mathrm operatorname mathup rm", {.upright = true}},
      {"mathit mathnormal", {}},
      {"mathcal", {.alphabet = "mathcal"}},
      {"mathscr", {.alphabet = "mathscr"}},
      {"mathfrak", {.alphabet = "mathfrak"}},
      {"mathbb", {.alphabet = "mathbb"}}};
  return table;
}

/// From the names of the letters to the signs for them; ϵ, ϕ and ϑ are second signs for a name.
constexpr std::string_view greek_letters = R"(
    alpha α  beta β  gamma γ  delta δ  epsilon ε  zeta ζ  eta η  theta θ  iota ι  kappa κ  lambda λ  mu μ
    nu ν  xi ξ  pi π  rho ρ  sigma σ  tau τ  upsilon υ  phi φ  chi χ  psi ψ  omega ω  Gamma Γ  Delta Δ
    Theta Θ  Lambda Λ  Xi Ξ  Pi Π  Sigma Σ  Upsilon Υ  Phi Φ  Psi Ψ  Omega Ω  epsilon ϵ  varphi ϕ
    vartheta ϑ)";

/// "Total  energy" is `\text{Total energy}`, and "K.E." is "KE".
std::string letter_of_words(std::string_view words) {
  std::string letter = "\\text{";
  for (const char c : words) {
    if (is_white(c)) {
      letter += ' ';
    } else if (c != '.') {
      letter += c;
    }
  }
  return letter + "}";
}

}  // namespace

std::optional<RelationKind> relation_kind(const Token& token) {
  if (token.kind == TokenKind::other) {
    if (token.text == "=") return RelationKind::equal;
    if (token.text == "<") return RelationKind::less;
    if (token.text == ">") return RelationKind::greater;
    return std::nullopt;
  }
  if (token.kind == TokenKind::letter) return relations_by_name().find(token.text);
  return token.kind == TokenKind::control ? relations().find(token.text) : std::nullopt;
}

bool is_spacing(const Token& token) {
  static const WordSet words(
      ", : ; ! > / thinspace medspace thickspace negthinspace enspace displaystyle textstyle scriptstyle "
      "nonumber notag limits nolimits mathstrut strut hfill allowbreak nobreak relax mathopen mathclose "
      "null noindent displaybreak centering small footnotesize normalsize large protect qedhere -");
  if (token.kind == TokenKind::space || token.kind == TokenKind::paragraph) return true;
  if (token.kind == TokenKind::other && token.text == "~") return true;
  if (token.kind == TokenKind::control && !token.text.empty()) {
    const char first = token.text.front();
    if (token.text.size() == 1 && (first == ' ' || first == '\n' || first == '\t' || first == '\r'))
      return true;
  }
  return is_control_of(token, words);
}

bool is_bracket_size(const Token& token) {
  static const WordSet words(
      "left right middle big Big bigg Bigg bigl bigr Bigl Bigr biggl biggr Biggl Biggr bigm Bigm");
  return is_control_of(token, words);
}

bool is_wide_space(const Token& token) {
  static const WordSet words("quad qquad hspace hphantom");
  return is_control_of(token, words);
}

bool is_words(const Token& token) {
  static const WordSet words(
      "text mbox textrm textit textbf textnormal hbox textsf emph fbox intertext shortintertext qq texttt "
      "textsc");
  return is_control_of(token, words);
}

bool is_transparent(const Token& token) {
  static const WordSet words("boxed ensuremath mathord mathinner Aboxed mathrel mathbin mathop smash");
  return is_control_of(token, words);
}

bool is_transparent_environment(std::string_view name) {
  static const WordSet words(
      "aligned split gathered alignedat align align* gather gather* equation equation* multline multline* "
      "eqnarray eqnarray* alignat alignat* multlined flalign flalign* subequations lgathered rgathered");
  return words.contains(name);
}

std::string letter_of(const Token& token) {
  static const WordTable signs(greek_letters);
  static const std::unordered_map<std::string_view, std::string_view> names = [] {
    std::unordered_map<std::string_view, std::string_view> names_of_signs;
    for (const auto& [name, sign] : word_pairs(greek_letters)) names_of_signs.emplace(sign, name);
    return names_of_signs;
  }();
  static const WordSet other_letters("imath jmath ell hbar varphi vartheta varrho varsigma varkappa");
  if (token.kind == TokenKind::control) {
    if (token.text == "varepsilon") return "\\epsilon";
    if (token.text == "hslash") return "\\hbar";
    if (token.text == "square" || token.text == "Box") return std::string(hole_letter);
    const bool is_letter = other_letters.contains(token.text) || !signs.find(token.text).empty();
    return is_letter ? "\\" + std::string(token.text) : std::string();
  }
  if (token.kind != TokenKind::letter) return {};
  if (token.text.size() == 1) return std::string(token.text);
  if (is_letter(token.text.front())) return letter_of_words(token.text);
  const auto name = names.find(token.text);
  return name == names.end() ? std::string() : "\\" + std::string(name->second);
}

bool is_greek(std::string_view letter) {
  return letter.size() > 1 && letter.front() == '\\' && letter != hole_letter && letter != "\\ell" &&
         letter != "\\imath" && letter != "\\jmath" && letter != "\\hbar" && !letter.starts_with("\\text{");
}

bool is_asking_mark(std::span<const Token> tokens, std::size_t at) {
  const auto is_mark = [&](std::size_t k) {
    return is_kind_at(tokens, k, TokenKind::other) && tokens[k].text == "?";
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
  const TokenKind right = tokens[behind].kind;  // a factor goes on after it
  return right == TokenKind::letter || right == TokenKind::control || right == TokenKind::subscript;
}

std::optional<Style> style_of(const Token& token) {
  return token.kind == TokenKind::control ? styles().find(token.text) : std::nullopt;
}

Joint factor_joint(const Token& token) {
  static const WordSet dots("cdot cdotp vdot dotproduct bullet");
  static const WordSet crosses("times cross crossproduct cp");
  if (is_control_of(token, dots)) return Joint::dot;
  if (is_control_of(token, crosses)) return Joint::cross;
  if (token.kind == TokenKind::letter && (token.text == "·" || token.text == "⋅")) return Joint::dot;
  if (token.kind == TokenKind::letter && token.text == "×") return Joint::cross;
  if (token.kind == TokenKind::other && token.text == "/") return Joint::slash;
  return Joint::none;
}

bool is_fraction(const Token& token) {
  static const WordSet words("frac tfrac dfrac cfrac nicefrac sfrac");
  return is_control_of(token, words);
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
  static const WordSet angles(
      "\\theta \\vartheta \\phi \\varphi \\psi \\alpha \\beta \\gamma \\chi \\eta \\Theta \\Phi");
  return angles.contains(letter);
}

std::string_view function_name(std::string_view word) {
  static const WordTable functions(R"(sin sin  cos cos  tan tan  cot cot  sec sec  csc csc  sinh sinh
      cosh cosh  tanh tanh  coth coth  sech sech  csch csch  exp exp  ln ln  log log  lg lg
      arcsin arcsin  arccos arccos  arctan arctan  arsinh arsinh  arcosh arcosh  artanh artanh
      arcsinh arsinh  arccosh arcosh  arctanh artanh  det det  determinant det
      tr tr  Tr tr  trace tr  Trace tr  diag diag  Re Re  Im Im)");
  return functions.find(word);
}

std::optional<FieldOperator> field_operator(std::string_view word) {
  static const WordMap<FieldOperator> table{{"grad gradient", FieldOperator::gradient},
                                            {"div divergence", FieldOperator::divergence},
                                            {"curl", FieldOperator::curl},
                                            {"laplacian", FieldOperator::laplacian}};
  return table.find(word);
}

bool is_state_bracket(const Token& token) {
  static const WordSet names(
      "ket bra braket Ket Bra Braket ev expval expectationvalue mel matrixel matrixelement ip innerproduct "
      "ketbra dyad op outerproduct");
  return is_control_of(token, names);
}

std::string_view unread_reason(std::string_view control) {
  static const WordMap<std::string_view> reasons{
      {"fdv functionalderivative", "this derivative is not read"},
      {"max min arg sgn", "functions such as this one are not decided yet"},
      {"iint oint oiint", "only integrals over a body (`dm`, `dV`, `d^3r`) are read"},
      {"dd differential", "a differential by itself is not read"},
      {"prod bigcup bigcap bigoplus", "this operator is not read"},
      {"lim sup inf limsup", "limits are not decided yet"},
      {"pm mp", "`\\pm` and `\\mp` stand for two statements, which are not read yet"},
      {"dots ldots cdots dotsb dotsc vdots ddots", "an ellipsis does not say what is left out"},
      {"wedge otimes oplus circ star ast", "this product is not read; write `\\times` or `\\cdot`"},
      {"rangle", "brackets of states are not read"},
      {"real imaginary", "real and imaginary parts are written `\\Re` and `\\Im`"},
      {"rank erf erfc Res Pr", "functions such as this one are not decided yet"},
      {"pv PV principalvalue", "a principal value is not read"},
      {"qtyrange qtylist SIrange SIlist numrange numlist", "a range or list of numbers is not read"},
      {"imat dmat xmat zmat admat identitymatrix zeromatrix paulimatrix",
       "this matrix is not read; write its entries"},
      {"slashed", "a contraction with Dirac's matrices is not read"},
      {"prescript", "a subscript or superscript before its symbol is not read"},
      {"infty", "infinity is not a number"}};
  return reasons.find(control).value_or("");
}

bool is_subscript_word(std::string_view letters) {
  static const WordSet words(
      "rot trans tot cm com out ext int kin pot max min eff spin orb lab rel net avg rms body sys orbital "
      "total ref grav elec mag new old crit init final stat ind rad inc loc vib osc vac obs src sat diss");
  if (letters.size() < 2) return false;
  const bool capitals = std::ranges::all_of(letters, [](char c) { return c >= 'A' && c <= 'Z'; });
  return capitals || words.contains(letters);
}

}  // namespace rigor
