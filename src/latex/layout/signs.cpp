// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/layout/signs.h"

#include <array>
#include <map>

namespace rigor {
namespace {

struct NamedSign {
  std::string_view name;
  std::string_view text;
};

constexpr auto letters = std::to_array<NamedSign>(
    {{"alpha", "α"},      {"beta", "β"},   {"gamma", "γ"},    {"delta", "δ"},    {"epsilon", "ϵ"},
     {"varepsilon", "ε"}, {"zeta", "ζ"},   {"eta", "η"},      {"theta", "θ"},    {"vartheta", "ϑ"},
     {"iota", "ι"},       {"kappa", "κ"},  {"varkappa", "ϰ"}, {"lambda", "λ"},   {"mu", "μ"},
     {"nu", "ν"},         {"xi", "ξ"},     {"omicron", "ο"},  {"pi", "π"},       {"varpi", "ϖ"},
     {"rho", "ρ"},        {"varrho", "ϱ"}, {"sigma", "σ"},    {"varsigma", "ς"}, {"tau", "τ"},
     {"upsilon", "υ"},    {"phi", "ϕ"},    {"varphi", "φ"},   {"chi", "χ"},      {"psi", "ψ"},
     {"omega", "ω"},      {"ell", "ℓ"},    {"imath", "ı"},    {"jmath", "ȷ"}});

/// Set upright, or as they are.
constexpr auto symbols = std::to_array<NamedSign>(
    {{"Gamma", "Γ"},   {"Delta", "Δ"},     {"Theta", "Θ"},       {"Lambda", "Λ"},    {"Xi", "Ξ"},
     {"Pi", "Π"},      {"Sigma", "Σ"},     {"Upsilon", "Υ"},     {"Phi", "Φ"},       {"Psi", "Ψ"},
     {"Omega", "Ω"},   {"hbar", "ℏ"},      {"infty", "∞"},       {"partial", "∂"},   {"nabla", "∇"},
     {"grad", "∇"},    {"gradient", "∇"},  {"laplacian", "∇²"},  {"Re", "ℜ"},        {"Im", "ℑ"},
     {"aleph", "ℵ"},   {"emptyset", "∅"},  {"varnothing", "∅"},  {"forall", "∀"},    {"exists", "∃"},
     {"nexists", "∄"}, {"prime", "′"},     {"dagger", "†"},      {"ddagger", "‡"},   {"square", "□"},
     {"Box", "□"},     {"angle", "∠"},     {"degree", "°"},      {"dots", "…"},      {"ldots", "…"},
     {"cdots", "⋯"},   {"dotsb", "⋯"},     {"dotsc", "…"},       {"vdots", "⋮"},     {"ddots", "⋱"},
     {"top", "⊤"},     {"bot", "⊥"},       {"neg", "¬"},         {"lnot", "¬"},      {"triangle", "△"},
     {"diamond", "⋄"}, {"clubsuit", "♣"},  {"%", "%"},           {"$", "$"},         {"#", "#"},
     {"&", "&"},       {"_", "_"},         {"textdegree", "°"},  {"checkmark", "✓"}, {"S", "§"},
     {"pounds", "£"},  {"copyright", "©"}, {"blacksquare", "■"}, {"qed", "∎"},       {"Angstrom", "Å"}});

constexpr auto binaries = std::to_array<NamedSign>(
    {{"times", "×"},    {"cross", "×"},      {"crossproduct", "×"}, {"cp", "×"},     {"cdot", "·"},
     {"vdot", "·"},     {"dotproduct", "·"}, {"cdotp", "·"},        {"bullet", "•"}, {"pm", "±"},
     {"mp", "∓"},       {"div", "÷"},        {"wedge", "∧"},        {"land", "∧"},   {"vee", "∨"},
     {"lor", "∨"},      {"otimes", "⊗"},     {"oplus", "⊕"},        {"ominus", "⊖"}, {"odot", "⊙"},
     {"circ", "∘"},     {"star", "⋆"},       {"ast", "∗"},          {"cup", "∪"},    {"cap", "∩"},
     {"setminus", "∖"}, {"backslash", "∖"},  {"ltimes", "⋉"},       {"rtimes", "⋊"}});

constexpr auto relation_signs = std::to_array<NamedSign>({{"equiv", "≡"},
                                                          {"coloneqq", "≔"},
                                                          {"coloneq", "≔"},
                                                          {"eqqcolon", "≕"},
                                                          {"eqcolon", "≕"},
                                                          {"triangleq", "≜"},
                                                          {"eqdef", "≝"},
                                                          {"doteq", "≐"},
                                                          {"lt", "<"},
                                                          {"gt", ">"},
                                                          {"ll", "≪"},
                                                          {"gg", "≫"},
                                                          {"le", "≤"},
                                                          {"leq", "≤"},
                                                          {"leqslant", "⩽"},
                                                          {"ge", "≥"},
                                                          {"geq", "≥"},
                                                          {"geqslant", "⩾"},
                                                          {"ne", "≠"},
                                                          {"neq", "≠"},
                                                          {"approx", "≈"},
                                                          {"simeq", "≃"},
                                                          {"cong", "≅"},
                                                          {"approxeq", "≊"},
                                                          {"sim", "∼"},
                                                          {"propto", "∝"},
                                                          {"in", "∈"},
                                                          {"notin", "∉"},
                                                          {"ni", "∋"},
                                                          {"subset", "⊂"},
                                                          {"subseteq", "⊆"},
                                                          {"supset", "⊃"},
                                                          {"supseteq", "⊇"},
                                                          {"perp", "⟂"},
                                                          {"parallel", "∥"},
                                                          {"to", "→"},
                                                          {"rightarrow", "→"},
                                                          {"mapsto", "↦"},
                                                          {"longrightarrow", "⟶"},
                                                          {"leftrightarrow", "↔"},
                                                          {"lesssim", "≲"},
                                                          {"gtrsim", "≳"},
                                                          {"prec", "≺"},
                                                          {"succ", "≻"},
                                                          {"asymp", "≍"},
                                                          {"longmapsto", "⟼"},
                                                          {"leftarrow", "←"},
                                                          {"gets", "←"},
                                                          {"longleftarrow", "⟵"},
                                                          {"uparrow", "↑"},
                                                          {"downarrow", "↓"},
                                                          {"Rightarrow", "⇒"},
                                                          {"implies", "⟹"},
                                                          {"Longrightarrow", "⟹"},
                                                          {"iff", "⟺"},
                                                          {"Leftrightarrow", "⇔"},
                                                          {"Longleftrightarrow", "⟺"},
                                                          {"impliedby", "⟸"},
                                                          {"Leftarrow", "⇐"},
                                                          {"Longleftarrow", "⟸"},
                                                          {"mid", "∣"},
                                                          {"nmid", "∤"},
                                                          {"vdash", "⊢"},
                                                          {"models", "⊨"},
                                                          {"therefore", "∴"},
                                                          {"because", "∵"},
                                                          {"hookrightarrow", "↪"},
                                                          {"rightleftharpoons", "⇌"},
                                                          {"leadsto", "⇝"},
                                                          {"colon", ":"},
                                                          {"not", "̸"}});

constexpr auto openings = std::to_array<NamedSign>({{"{", "{"},
                                                    {"lbrace", "{"},
                                                    {"lbrack", "["},
                                                    {"langle", "⟨"},
                                                    {"lfloor", "⌊"},
                                                    {"lceil", "⌈"},
                                                    {"lvert", "|"},
                                                    {"lVert", "‖"},
                                                    {"lgroup", "("},
                                                    {"llbracket", "⟦"}});
constexpr auto closings = std::to_array<NamedSign>({{"}", "}"},
                                                    {"rbrace", "}"},
                                                    {"rbrack", "]"},
                                                    {"rangle", "⟩"},
                                                    {"rfloor", "⌋"},
                                                    {"rceil", "⌉"},
                                                    {"rvert", "|"},
                                                    {"rVert", "‖"},
                                                    {"rgroup", ")"},
                                                    {"rrbracket", "⟧"}});
constexpr auto bars = std::to_array<NamedSign>({{"vert", "|"}, {"|", "‖"}, {"Vert", "‖"}});

constexpr auto big_signs = std::to_array<NamedSign>({{"sum", "∑"},
                                                     {"prod", "∏"},
                                                     {"coprod", "∐"},
                                                     {"bigcup", "⋃"},
                                                     {"bigcap", "⋂"},
                                                     {"bigoplus", "⨁"},
                                                     {"bigotimes", "⨂"},
                                                     {"bigvee", "⋁"},
                                                     {"bigwedge", "⋀"}});
constexpr auto integrals = std::to_array<NamedSign>(
    {{"int", "∫"}, {"iint", "∬"}, {"iiint", "∭"}, {"oint", "∮"}, {"oiint", "∯"}, {"smallint", "∫"}});
constexpr auto limit_words = std::to_array<NamedSign>({{"lim", "lim"},
                                                       {"max", "max"},
                                                       {"min", "min"},
                                                       {"sup", "sup"},
                                                       {"inf", "inf"},
                                                       {"limsup", "lim sup"},
                                                       {"liminf", "lim inf"},
                                                       {"argmax", "arg max"},
                                                       {"argmin", "arg min"},
                                                       {"det", "det"}});

using Signs = std::map<std::string_view, PrintedSign>;

template <std::size_t N>
void put(Signs& signs, const std::array<NamedSign, N>& from, SignRole role, bool letter = false) {
  for (const NamedSign& each : from) signs.emplace(each.name, PrintedSign{each.text, role, letter});
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
    return signs;
  }();
  return table;
}

/// ASCII, and what other characters mean that some control writes, too.
const Signs& characters() {
  static const Signs table = [] {
    Signs signs{{"+", {"+", SignRole::binary}},      {"-", {"−", SignRole::binary}},
                {"−", {"−", SignRole::binary}},      {"*", {"∗", SignRole::binary}},
                {"⋅", {"·", SignRole::binary}},      {"=", {"=", SignRole::relation}},
                {"<", {"<", SignRole::relation}},    {">", {">", SignRole::relation}},
                {":", {":", SignRole::relation}},    {"(", {"(", SignRole::opening}},
                {"[", {"[", SignRole::opening}},     {")", {")", SignRole::closing}},
                {"]", {"]", SignRole::closing}},     {"|", {"|", SignRole::bar}},
                {",", {",", SignRole::punctuation}}, {";", {";", SignRole::punctuation}}};
    for (const auto& [name, sign] : controls()) {
      const bool ascii = static_cast<unsigned char>(sign.text.front()) < 0x80;
      if (!ascii && !sign.letter && name != "laplacian") signs.emplace(sign.text, sign);
    }
    return signs;
  }();
  return table;
}

template <class T>
std::optional<T> found_in(const std::map<std::string_view, T>& table, std::string_view name) {
  const auto found = table.find(name);
  return found == table.end() ? std::nullopt : std::optional<T>(found->second);
}

}  // namespace

std::optional<PrintedSign> sign_of_control(std::string_view control) { return found_in(controls(), control); }
std::optional<PrintedSign> sign_of_character(std::string_view character) {
  return found_in(characters(), character);
}

std::optional<PrintedAccent> accent_of(std::string_view control) {
  static const std::map<std::string_view, PrintedAccent> table{{"dot", {"˙"}},
                                                               {"ddot", {"¨"}},
                                                               {"dddot", {"⃛"}},
                                                               {"ddddot", {"⃜"}},
                                                               {"hat", {"^"}},
                                                               {"widehat", {"^", true}},
                                                               {"tilde", {"~"}},
                                                               {"widetilde", {"~", true}},
                                                               {"bar", {"‾"}},
                                                               {"overline", {"‾", true}},
                                                               {"vec", {"→"}},
                                                               {"overrightarrow", {"→", true}},
                                                               {"vv", {"→", true}},
                                                               {"overleftarrow", {"←", true}},
                                                               {"overleftrightarrow", {"↔", true}},
                                                               {"tensor", {"↔", true}},
                                                               {"check", {"ˇ"}},
                                                               {"breve", {"˘"}},
                                                               {"acute", {"´"}},
                                                               {"grave", {"`"}},
                                                               {"mathring", {"˚"}},
                                                               {"underline", {"_", true, true}},
                                                               {"underbar", {"_", true, true}},
                                                               {"overbrace", {"⏞", true}},
                                                               {"underbrace", {"⏟", true, true}},
                                                               {"overbracket", {"⎴", true}},
                                                               {"underbracket", {"⎵", true, true}},
                                                               {"underrightarrow", {"→", true, true}},
                                                               {"undertilde", {"~", true, true}}};
  return found_in(table, control);
}

std::optional<double> space_of(std::string_view control) {
  static const std::map<std::string_view, double> table{{",", 0.1667},
                                                        {"thinspace", 0.1667},
                                                        {":", 0.2222},
                                                        {">", 0.2222},
                                                        {"medspace", 0.2222},
                                                        {";", 0.2778},
                                                        {"thickspace", 0.2778},
                                                        {"!", -0.1667},
                                                        {"negthinspace", -0.1667},
                                                        {" ", 0.3333},
                                                        {"~", 0.3333},
                                                        {"enspace", 0.5},
                                                        {"quad", 1},
                                                        {"qquad", 2},
                                                        {"/", 0},
                                                        {"-", 0},
                                                        {"displaystyle", 0},
                                                        {"textstyle", 0},
                                                        {"scriptstyle", 0},
                                                        {"nonumber", 0},
                                                        {"notag", 0},
                                                        {"limits", 0},
                                                        {"nolimits", 0},
                                                        {"mathstrut", 0},
                                                        {"strut", 0},
                                                        {"hfill", 1},
                                                        {"allowbreak", 0},
                                                        {"nobreak", 0},
                                                        {"relax", 0},
                                                        {"mathopen", 0},
                                                        {"mathclose", 0},
                                                        {"null", 0},
                                                        {"noindent", 0},
                                                        {"displaybreak", 0},
                                                        {"centering", 0},
                                                        {"small", 0},
                                                        {"footnotesize", 0},
                                                        {"normalsize", 0},
                                                        {"large", 0},
                                                        {"protect", 0},
                                                        {"qedhere", 0},
                                                        {"hline", 0},
                                                        {"mathrel", 0},
                                                        {"mathbin", 0},
                                                        {"mathord", 0},
                                                        {"mathinner", 0},
                                                        {"mathop", 0},
                                                        {"ensuremath", 0},
                                                        {"smash", 0},
                                                        {"scriptscriptstyle", 0},
                                                        {"Aboxed", 0},
                                                        {"bigskip", 0},
                                                        {"medskip", 0},
                                                        {"smallskip", 0}};
  return found_in(table, control);
}

std::optional<Typeface> typeface_of(std::string_view control) {
  using enum Typeface;
  static const std::map<std::string_view, Typeface> table{{"mathbf", bold},
                                                          {"bf", bold},
                                                          {"bold", bold},
                                                          {"vb", bold},
                                                          {"vectorbold", bold},
                                                          {"symbf", bold},
                                                          {"boldsymbol", bold_italic},
                                                          {"bm", bold_italic},
                                                          {"pmb", bold_italic},
                                                          {"mathbfit", bold_italic},
                                                          {"symbfit", bold_italic},
                                                          {"mathsf", sans},
                                                          {"sf", sans},
                                                          {"mathbfsf", sans},
                                                          {"mathcal", script},
                                                          {"mathscr", script},
                                                          {"cal", script},
                                                          {"mathfrak", fraktur},
                                                          {"mathbb", blackboard},
                                                          {"mathtt", mono},
                                                          {"tt", mono},
                                                          {"mathrm", upright},
                                                          {"mathup", upright},
                                                          {"rm", upright},
                                                          {"mathit", italic},
                                                          {"mathnormal", italic},
                                                          {"it", italic}};
  return found_in(table, control);
}

std::string_view printed_function(std::string_view control) {
  static const std::map<std::string_view, std::string_view> table{
      {"sin", "sin"},        {"cos", "cos"},   {"tan", "tan"},       {"cot", "cot"},
      {"sec", "sec"},        {"csc", "csc"},   {"sinh", "sinh"},     {"cosh", "cosh"},
      {"tanh", "tanh"},      {"coth", "coth"}, {"exp", "exp"},       {"ln", "ln"},
      {"log", "log"},        {"lg", "lg"},     {"arcsin", "arcsin"}, {"arccos", "arccos"},
      {"arctan", "arctan"},  {"arg", "arg"},   {"dim", "dim"},       {"ker", "ker"},
      {"deg", "deg"},        {"sgn", "sgn"},   {"tr", "tr"},         {"Tr", "Tr"},
      {"trace", "tr"},       {"Trace", "Tr"},  {"rank", "rank"},     {"erf", "erf"},
      {"determinant", "det"}};
  const auto found = table.find(control);
  return found == table.end() ? std::string_view{} : found->second;
}

}  // namespace rigor
