// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/layout/signs.h"

#include <map>
#include <utility>

#include "latex/token/words.h"

namespace rigor {
namespace {

constexpr std::string_view letters = R"(
    alpha α  beta β  gamma γ  delta δ  epsilon ϵ  varepsilon ε  zeta ζ  eta η  theta θ  vartheta ϑ  iota ι
    kappa κ  varkappa ϰ  lambda λ  mu μ  nu ν  xi ξ  omicron ο  pi π  varpi ϖ  rho ρ  varrho ϱ  sigma σ
    varsigma ς  tau τ  upsilon υ  phi ϕ  varphi φ  chi χ  psi ψ  omega ω  ell ℓ  imath ı  jmath ȷ)";

/// Set upright, or as they are.
constexpr std::string_view symbols = R"(
    Gamma Γ  Delta Δ  Theta Θ  Lambda Λ  Xi Ξ  Pi Π  Sigma Σ  Upsilon Υ  Phi Φ  Psi Ψ  Omega Ω  hbar ℏ
    infty ∞  partial ∂  nabla ∇  grad ∇  gradient ∇  laplacian ∇²  Re ℜ  Im ℑ  aleph ℵ  emptyset ∅
    varnothing ∅  forall ∀  exists ∃  nexists ∄  prime ′  dagger †  ddagger ‡  square □  Box □  angle ∠
    degree °  dots …  ldots …  cdots ⋯  dotsb ⋯  dotsc …  vdots ⋮  ddots ⋱  top ⊤  bot ⊥  neg ¬  lnot ¬
    triangle △  diamond ⋄  clubsuit ♣  % %  $ $  # #  & &  _ _  textdegree °  checkmark ✓  S §  pounds £
    copyright ©  blacksquare ■  qed ∎  Angstrom Å)";

constexpr std::string_view binaries = R"(
    times ×  cross ×  crossproduct ×  cp ×  cdot ·  vdot ·  dotproduct ·  cdotp ·  bullet •  pm ±  mp ∓
    div ÷  wedge ∧  land ∧  vee ∨  lor ∨  otimes ⊗  oplus ⊕  ominus ⊖  odot ⊙  circ ∘  star ⋆  ast ∗  cup ∪
    cap ∩  setminus ∖  backslash ∖  ltimes ⋉  rtimes ⋊)";

constexpr std::string_view relation_signs = R"(
    equiv ≡  coloneqq ≔  coloneq ≔  eqqcolon ≕  eqcolon ≕  triangleq ≜  eqdef ≝  doteq ≐  lt <  gt >  ll ≪
    gg ≫  le ≤  leq ≤  leqslant ⩽  ge ≥  geq ≥  geqslant ⩾  ne ≠  neq ≠  approx ≈  simeq ≃  cong ≅
    approxeq ≊  sim ∼  propto ∝  in ∈  notin ∉  ni ∋  subset ⊂  subseteq ⊆  supset ⊃  supseteq ⊇  perp ⟂
    parallel ∥  to →  rightarrow →  mapsto ↦  longrightarrow ⟶  leftrightarrow ↔  lesssim ≲  gtrsim ≳
    prec ≺  succ ≻  asymp ≍  longmapsto ⟼  leftarrow ←  gets ←  longleftarrow ⟵  uparrow ↑  downarrow ↓
    Rightarrow ⇒  implies ⟹  Longrightarrow ⟹  iff ⟺  Leftrightarrow ⇔  Longleftrightarrow ⟺  impliedby ⟸
    Leftarrow ⇐  Longleftarrow ⟸  mid ∣  nmid ∤  vdash ⊢  models ⊨  therefore ∴  because ∵  hookrightarrow ↪
    rightleftharpoons ⇌  leadsto ⇝  colon :  not ̸)";

constexpr std::string_view openings = R"(
    { {  lbrace {  lbrack [  langle ⟨  lfloor ⌊  lceil ⌈  lvert |  lVert ‖  lgroup (  llbracket ⟦)";
constexpr std::string_view closings = R"(
    } }  rbrace }  rbrack ]  rangle ⟩  rfloor ⌋  rceil ⌉  rvert |  rVert ‖  rgroup )  rrbracket ⟧)";
constexpr std::string_view bars = "vert | | ‖ Vert ‖";

constexpr std::string_view big_signs = R"(
    sum ∑  prod ∏  coprod ∐  bigcup ⋃  bigcap ⋂  bigoplus ⨁  bigotimes ⨂  bigvee ⋁  bigwedge ⋀)";
constexpr std::string_view integrals = "int ∫ iint ∬ iiint ∭ oint ∮ oiint ∯ smallint ∫";
constexpr std::string_view limit_words = "lim lim max max min min sup sup inf inf det det";

using Signs = std::map<std::string_view, PrintedSign>;

void put(Signs& signs, std::string_view pairs, SignRole role, bool letter = false) {
  for (const auto& [name, text] : word_pairs(pairs)) signs.emplace(name, PrintedSign{text, role, letter});
}

const Signs& controls() {
  static const Signs table = [] {
    Signs signs;
    put(signs, letters, SignRole::ordinary, true);
    put(signs, symbols, SignRole::ordinary);
    put(signs, binaries, SignRole::binary);
    put(signs, relation_signs, SignRole::relation);
    put(signs, openings, SignRole::opening);
    put(signs, closings, SignRole::closing);
    put(signs, bars, SignRole::bar);
    put(signs, big_signs, SignRole::big);
    put(signs, integrals, SignRole::integral);
    put(signs, limit_words, SignRole::word);
    for (const auto& [name, text] : {std::pair{"limsup", "lim sup"},
                                     {"liminf", "lim inf"},
                                     {"argmax", "arg max"},
                                     {"argmin", "arg min"}})
      signs.emplace(name, PrintedSign{text, SignRole::word, false});
    return signs;
  }();
  return table;
}

/// ASCII, and what other characters mean that some control writes, too.
const Signs& characters() {
  static const Signs table = [] {
    Signs signs;
    put(signs, "+ +  - −  − −  * ∗  ⋅ ·", SignRole::binary);
    put(signs, "= =  < <  > >  : :", SignRole::relation);
    put(signs, "( (  [ [", SignRole::opening);
    put(signs, ") )  ] ]", SignRole::closing);
    put(signs, "| |", SignRole::bar);
    put(signs, ", ,  ; ;", SignRole::punctuation);
    for (const auto& [name, sign] : controls()) {
      const bool ascii = static_cast<unsigned char>(sign.text.front()) < 0x80;
      if (!ascii && !sign.letter && name != "laplacian") signs.emplace(sign.text, sign);
    }
    return signs;
  }();
  return table;
}

std::optional<PrintedSign> found_in(const Signs& table, std::string_view name) {
  const auto found = table.find(name);
  return found == table.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::optional<PrintedSign> sign_of_control(std::string_view control) { return found_in(controls(), control); }
std::optional<PrintedSign> sign_of_character(std::string_view character) {
  return found_in(characters(), character);
}

std::optional<PrintedAccent> accent_of(std::string_view control) {
  static const WordTable narrow(
      R"(dot ˙  ddot ¨  dddot ⃛  ddddot ⃜  hat ^  tilde ~  bar ‾  vec →  check ˇ  breve ˘
      acute ´  grave `  mathring ˚)");
  static const WordTable wide(R"(widehat ^  widetilde ~  overline ‾  overrightarrow →  vv →  overleftarrow ←
      overleftrightarrow ↔  tensor ↔  overbrace ⏞  overbracket ⎴)");
  static const WordTable below(R"(underline _  underbar _  underbrace ⏟  underbracket ⎵  underrightarrow →
      undertilde ~)");
  if (const auto text = narrow.find(control); !text.empty()) return PrintedAccent{text};
  if (const auto text = wide.find(control); !text.empty()) return PrintedAccent{text, true};
  if (const auto text = below.find(control); !text.empty()) return PrintedAccent{text, true, true};
  return std::nullopt;
}

std::optional<double> space_of(std::string_view control) {
  if (control == " ") return 0.3333;
  static const WordMap<double> table{
      {", thinspace", 0.1667},
      {": > medspace", 0.2222},
      {"; thickspace", 0.2778},
      {"! negthinspace", -0.1667},
      {"~", 0.3333},
      {"enspace", 0.5},
      {"quad hfill", 1},
      {"qquad", 2},
      {"/ - displaystyle textstyle scriptstyle nonumber notag limits nolimits mathstrut strut allowbreak "
       "nobreak relax mathopen mathclose null noindent displaybreak centering small footnotesize normalsize "
       "large protect qedhere hline mathrel mathbin mathord mathinner mathop ensuremath smash "
       "scriptscriptstyle Aboxed bigskip medskip smallskip",
       0}};
  return table.find(control);
}

std::optional<Typeface> typeface_of(std::string_view control) {
  using enum Typeface;
  static const WordMap<Typeface> table{{"mathbf bf bold vb vectorbold symbf", bold},
                                       {"boldsymbol bm pmb mathbfit symbfit", bold_italic},
                                       {"mathsf sf mathbfsf", sans},
                                       {"mathcal mathscr cal", script},
                                       {"mathfrak", fraktur},
                                       {"mathbb", blackboard},
                                       {"mathtt tt", mono},
                                       {"mathrm mathup rm", upright},
                                       {"mathit mathnormal it", italic}};
  return table.find(control);
}

std::string_view printed_function(std::string_view control) {
  static const WordTable table(
      "sin sin cos cos tan tan cot cot sec sec csc csc sinh sinh cosh cosh tanh tanh coth coth exp exp "
      "ln ln log log lg lg arcsin arcsin arccos arccos arctan arctan arg arg dim dim ker ker deg deg "
      "sgn sgn tr tr Tr Tr trace tr Trace Tr rank rank erf erf determinant det");
  return table.find(control);
}

}  // namespace rigor
