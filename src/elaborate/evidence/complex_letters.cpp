// SPDX-License-Identifier: GPL-3.0-or-later
// Most pages of physics have an `i` that is an index or a current, a bar that is a mean and a star that is a
// label. So a sign alone shows nothing: `i` is the imaginary unit where it stands above an e, beside \hbar,
// or where the words say so; a starred letter is conjugated where it stands beside itself without a star.
#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/evidence/complex_entries.h"
#include "elaborate/evidence/evidence.h"

namespace rigor {
namespace {

bool is_bare(const WrittenSymbol& symbol) {
  return symbol.lower.empty() && symbol.face == Face::plain && symbol.accent == Accent::none &&
         symbol.primes == 0 && symbol.dots == 0 && symbol.change.empty();
}

bool is_symbol(const SyntaxTree& syntax, SyntaxId id) { return syntax[id].kind == SyntaxKind::symbol; }

bool is_imaginary_letter(const SyntaxTree& syntax, SyntaxId id) {
  return is_symbol(syntax, id) && may_be_imaginary_unit(syntax.symbol(id));
}

bool is_named(const SyntaxTree& syntax, SyntaxId id, std::string_view name) {
  return syntax[id].kind == SyntaxKind::function && syntax.text(id) == name;
}

bool is_number(const SyntaxTree& syntax, SyntaxId id, std::string_view digits) {
  return syntax[id].kind == SyntaxKind::number && syntax.text(id) == digits;
}

/// `-1`
bool is_minus_one(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::sum && syntax[id].count == 1 &&
         syntax.children(id)[0].joint == Joint::minus && is_number(syntax, syntax.child(id, 0), "1");
}

SyntaxId without_groups(const SyntaxTree& syntax, SyntaxId id) {
  while (syntax[id].kind == SyntaxKind::group) id = syntax.child(id, 0);
  return id;
}

// --- the imaginary unit

/// The letters below that can be i. Of `e^{i(kja - \omega t)}` the first is, and j counts.
std::set<std::string> units_below(const SyntaxTree& syntax, SyntaxId root) {
  std::set<std::string> units;
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (is_imaginary_letter(syntax, id)) units.insert(syntax.symbol(id).letter);
  }
  if (units.contains("i")) units.erase("j");
  return units;
}

/// What `e^{i\omega t}` is of is real, but for the usual letters of complex numbers.
void see_exponent(const SyntaxTree& syntax, SyntaxId exponent, Evidence& evidence) {
  const std::set<std::string> units = units_below(syntax, exponent);
  if (units.empty()) return;
  evidence.imaginary_units.insert(units.begin(), units.end());
  for (const SyntaxId id : nodes_below(syntax, {exponent})) {
    if (!is_symbol(syntax, id)) continue;
    const std::string& letter = syntax.symbol(id).letter;
    if (letter != "z" && letter != "w") evidence.real.insert(letter_with_marks(syntax.symbol(id)));
  }
}

void see_units(const SyntaxTree& syntax, SyntaxId id, Evidence& evidence) {
  const SyntaxKind kind = syntax[id].kind;
  const auto is_euler = [&](SyntaxId base) {
    const bool e = is_symbol(syntax, base) &&
                   (syntax.symbol(base).letter == "e" || syntax.symbol(base).letter == "\\mathrm{e}");
    return e && is_bare(syntax.symbol(base));
  };
  if (kind == SyntaxKind::power && is_euler(syntax.child(id, 0)))
    see_exponent(syntax, syntax.child(id, 1), evidence);
  if (is_named(syntax, id, "exp")) see_exponent(syntax, syntax.child(id, 0), evidence);
  if (is_imaginary_letter(syntax, id) && syntax.symbol(id).letter == "\\mathrm{i}")
    evidence.imaginary_units.insert("\\mathrm{i}");
  if (kind != SyntaxKind::term) return;
  const std::span<const SyntaxChild> factors = syntax.children(id);
  for (std::size_t k = 0; k + 1 < factors.size(); ++k) {  // `i\hbar`
    const SyntaxId next = factors[k + 1].id;
    if (is_imaginary_letter(syntax, factors[k].id) && is_symbol(syntax, next) &&
        syntax.symbol(next).letter == "\\hbar")
      evidence.imaginary_units.insert(syntax.symbol(factors[k].id).letter);
  }
}

/// `i^2 = -1`, `i = \sqrt{-1}`; and `i = 5` (`defines`: the side comes first), which no unit is.
void see_equation_of_unit(const SyntaxTree& syntax, SyntaxId side, SyntaxId other, bool defines,
                          Evidence& evidence) {
  const bool squared =
      syntax[side].kind == SyntaxKind::power && is_number(syntax, syntax.child(side, 1), "2");
  const SyntaxId unit = squared ? syntax.child(side, 0) : side;
  if (!is_imaginary_letter(syntax, unit)) return;
  if (units_below(syntax, other).contains(syntax.symbol(unit).letter)) return;  // `\frac1i = -i`
  const bool root = syntax[other].kind == SyntaxKind::root && is_minus_one(syntax, syntax.child(other, 0));
  const std::string& letter = syntax.symbol(unit).letter;
  if (squared ? is_minus_one(syntax, other) : root) {
    evidence.imaginary_units.insert(letter);
  } else if (!squared && defines) {
    evidence.no_units.insert(letter);
  }
}

// --- complex letters

/// The symbol that is starred, or nothing: of `\psi^*`, `\frac{\partial\psi^*}{\partial t}`.
const WrittenSymbol* starred(const SyntaxTree& syntax, SyntaxId id) {
  while (syntax[id].kind == SyntaxKind::group || syntax[id].kind == SyntaxKind::derivative)
    id = syntax.child(id, 0);
  if (!is_named(syntax, id, "conjugate")) return nullptr;
  const SyntaxId of = without_derivatives(syntax, syntax.child(id, 0));
  return is_symbol(syntax, of) ? &syntax.symbol(of) : nullptr;
}

/// The names of the factors that stand beside their own conjugates, `\psi^*\psi`, `z\bar z`.
std::set<std::string> beside_conjugate(const SyntaxTree& syntax, SyntaxId term, bool with_bar) {
  std::set<std::string> plain;
  std::set<std::string> conjugated;
  for (const SyntaxChild& factor : syntax.children(term)) {
    if (const WrittenSymbol* symbol = starred(syntax, factor.id)) {
      if (!with_bar) conjugated.insert(complex_name(*symbol));
      continue;
    }
    const SyntaxId of = without_derivatives(syntax, factor.id);
    if (!is_symbol(syntax, of)) continue;
    WrittenSymbol symbol = syntax.symbol(of);
    const bool bar = std::exchange(symbol.accent, Accent::none) == Accent::bar;
    if (bar && with_bar) conjugated.insert(complex_name(symbol));
    if (!bar) plain.insert(complex_name(syntax.symbol(of)));
  }
  std::set<std::string> both;
  std::ranges::set_intersection(plain, conjugated, std::inserter(both, both.end()));
  return both;
}

void see_conjugates(const SyntaxTree& syntax, SyntaxId id, Evidence& evidence) {
  if (const WrittenSymbol* symbol = starred(syntax, id)) evidence.starred.insert(complex_name(*symbol));
  if (is_named(syntax, id, "Re") || is_named(syntax, id, "Im")) {
    const SyntaxId of = without_groups(syntax, syntax.child(id, 0));
    if (is_symbol(syntax, of)) evidence.overlined.insert(complex_name(syntax.symbol(of)));
    const std::set<std::string> units = units_below(syntax, of);
    evidence.imaginary_units.insert(units.begin(), units.end());
  }
  if (syntax[id].kind != SyntaxKind::term) return;
  for (const std::string& name : beside_conjugate(syntax, id, false)) {
    const bool vector = name.starts_with("\\mathbf");  // `\mathbf a^*` can be reciprocal to `\mathbf a`
    (vector ? evidence.overlined : evidence.complex_numbers).insert(name);
  }
  evidence.overlined.merge(beside_conjugate(syntax, id, true));
}

/// What a side is made of, but for what is real whatever it is made of: moduli, real parts, `\psi^*\psi`.
/// Recursion: as deep as the tree.
void collect(const SyntaxTree& syntax, SyntaxId id, const std::set<std::string>& left_out,
             std::set<std::string>& names) {
  const SyntaxKind kind = syntax[id].kind;
  if (kind == SyntaxKind::bars || kind == SyntaxKind::norm || is_named(syntax, id, "Re") ||
      is_named(syntax, id, "Im"))
    return;
  if (is_symbol(syntax, id)) {
    WrittenSymbol symbol = syntax.symbol(id);
    if (symbol.accent == Accent::bar) symbol.accent = Accent::none;
    const std::string name = complex_name(symbol);
    if (!left_out.contains(name)) names.insert(name);
    return;
  }
  std::set<std::string> real = left_out;
  if (kind == SyntaxKind::term) {
    real.merge(beside_conjugate(syntax, id, false));
    real.merge(beside_conjugate(syntax, id, true));
  }
  for (const SyntaxChild& child : syntax.children(id)) collect(syntax, child.id, real, names);
}

/// The letter that a side is about: z of `z`, `\dot z`, `z^2`, `z(t)`, `i\hbar\,\frac{dz}{dt}`.
SyntaxId letter_made(const SyntaxTree& syntax, SyntaxId side) {
  side = without_derivatives(syntax, side);
  if (syntax[side].kind == SyntaxKind::power) return without_derivatives(syntax, syntax.child(side, 0));
  if (syntax[side].kind != SyntaxKind::term) return side;
  SyntaxId found = side;
  for (const SyntaxChild& factor : syntax.children(side)) {
    if (syntax[factor.id].kind == SyntaxKind::derivative) found = without_derivatives(syntax, factor.id);
  }
  return found;
}

void see_makings(const SyntaxTree& syntax, SyntaxId side, SyntaxId other, Evidence& evidence) {
  const SyntaxId of = letter_made(syntax, side);
  if (!is_symbol(syntax, of)) return;
  std::set<std::string>& parts = evidence.made_of[complex_name(syntax.symbol(of))];
  collect(syntax, other, {}, parts);
  if (syntax[side].kind == SyntaxKind::term && side != of) {  // `i\hbar` before the derivative
    for (const SyntaxChild& factor : syntax.children(side)) {
      if (is_imaginary_letter(syntax, factor.id)) parts.insert(syntax.symbol(factor.id).letter);
    }
  }
}

/// `x + iy`: x and y are real.
void see_real_parts(const SyntaxTree& syntax, SyntaxId id, Evidence& evidence) {
  if (syntax[id].kind != SyntaxKind::sum || syntax[id].count != 2) return;
  const SyntaxId re = syntax.child(id, 0);
  const SyntaxId im = syntax.child(id, 1);
  if (!is_symbol(syntax, re) || syntax[im].kind != SyntaxKind::term || syntax[im].count != 2) return;
  const bool first = is_imaginary_letter(syntax, syntax.child(im, 0));
  const SyntaxId factor = syntax.child(im, first ? 1 : 0);
  if ((!first && !is_imaginary_letter(syntax, syntax.child(im, 1))) || !is_symbol(syntax, factor)) return;
  for (const SyntaxId each : {re, factor}) {
    evidence.real.insert(letter_with_marks(syntax.symbol(each)));
    evidence.real_parts.insert(complex_name(syntax.symbol(each)));
  }
}

// --- words

/// `z`, `\psi_0`, `c_{n}`, as `complex_name` has it; empty for anything else.
std::string name_in_prose(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.remove_suffix(1);
  std::size_t end = text.starts_with('\\') ? 1 : 0;
  if (end == text.size()) return {};
  do ++end;
  while (text.starts_with('\\') && end < text.size() && is_letter(text[end]));
  const std::string letter(text.substr(0, end));
  if (!is_letter(letter.back()) || letter == "\\mathbf" || letter == "\\vec") return {};
  std::string_view below = text.substr(end);
  if (below.empty()) return letter;
  if (!below.starts_with('_')) return {};
  below.remove_prefix(1);
  if (below.starts_with('{') && below.ends_with('}')) below = below.substr(1, below.size() - 2);
  const bool plain = std::ranges::all_of(below, [](char c) { return is_letter(c) || is_digit(c); });
  return plain && !below.empty() ? letter + "_{" + std::string(below) + "}" : std::string();
}

void see_names(std::string_view formula, Evidence& evidence) {
  while (!formula.empty()) {
    const std::size_t comma = std::min(formula.find(','), formula.size());
    const std::string name = name_in_prose(formula.substr(0, comma));
    if (!name.empty()) evidence.complex_numbers.insert(name);
    formula.remove_prefix(std::min(comma + 1, formula.size()));
  }
}

/// "complex refractive index $n$", "imaginary mass $m$"; not "the imaginary part $y$", "complex for $x < 0$".
bool is_complex_noun(std::string_view words) {
  constexpr std::size_t most_words = 3;
  static constexpr auto others = std::to_array<std::string_view>(
      {"part", "parts", "unit",  "axis", "axes", "time", "plane", "exponential", "exponentials",
       "of",   "for",   "in",    "on",   "at",   "with", "and",   "when",        "if",
       "by",   "to",    "where", "as",   "is",   "are",  "from",  "that",        "which"});
  std::size_t count = 0;
  for (std::size_t at = 0; at < words.size();) {
    if (words[at] == ' ' || words[at] == '\n' || words[at] == '-') {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < words.size() && is_letter(words[at])) ++at;
    if (at == begin || ++count > most_words || is_one_of(words.substr(begin, at - begin), others))
      return false;
  }
  return true;
}

/// "a complex amplitude $A$", "the complex numbers $z$ and $w$", "where $z$ is complex".
void see_named_complex(std::string_view text, std::string_view adjective, Evidence& evidence) {
  const std::string lower = lowered(text);
  for (std::size_t at = lower.find(adjective); at != std::string::npos; at = lower.find(adjective, at + 1)) {
    const std::string_view before = std::string_view(lower).substr(0, at);
    const std::size_t behind_it = at + adjective.size();
    if (at > 0 && is_letter(lower[at - 1])) continue;
    if (before.ends_with("not ") || before.ends_with("no ")) continue;
    std::size_t open = text.find('$', at);
    const std::string_view gap =
        std::string_view(lower).substr(behind_it, std::min(open, lower.size()) - behind_it);
    if (!is_complex_noun(gap)) open = std::string_view::npos;
    while (open != std::string_view::npos) {
      const std::size_t close = text.find('$', open + 1);
      if (close == std::string_view::npos) break;
      see_names(text.substr(open + 1, close - open - 1), evidence);
      const std::string_view behind = text.substr(close + 1);
      const bool more = behind.starts_with(" and $") || behind.starts_with(", $");
      open = more ? text.find('$', close + 1) : std::string_view::npos;
    }
    for (const std::string_view verb : {"$ is ", "$ are ", "$ be ", "$ is purely "}) {
      if (!before.ends_with(verb)) continue;
      const std::size_t close = at - verb.size();
      const std::size_t begin = text.rfind('$', close - 1);
      if (close > 0 && begin != std::string_view::npos && begin < close)
        see_names(text.substr(begin + 1, close - begin - 1), evidence);
    }
  }
}

constexpr std::array<std::string_view, 8> imaginary_words{
    "imaginary unit",      "imaginary part", "complex number",    "complex plane",
    "complex exponential", "complex-valued", "complex amplitude", "complex notation"};
/// Whose star is a label: the effective mass, a reduced temperature.
constexpr std::array<std::string_view, 8> usually_labelled{"m", "M", "T", "n", "N", "t", "x", "y"};
constexpr std::array<std::string_view, 8> usual_complex{"z",        "w",     "\\psi", "\\Psi",
                                                        "\\varphi", "\\phi", "\\Phi", "\\chi"};

}  // namespace

bool may_be_imaginary_unit(const WrittenSymbol& symbol) {
  static constexpr std::array<std::string_view, 6> letters{"i",           "j",       "\\mathrm{i}",
                                                           "\\mathrm{j}", "\\imath", "\\jmath"};
  return is_bare(symbol) && is_one_of(std::string_view(symbol.letter), letters);
}

std::string complex_name(const std::string& base, int rank) {
  return rank > 0 ? "\\mathbf{" + base + "}" : base;
}

std::string complex_name(const WrittenSymbol& symbol) {
  return complex_name(with_labels(letter_with_marks(symbol), symbol.lower),
                      symbol.face == Face::plain ? 0 : 1);
}

void see_complex(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Evidence& evidence) {
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    see_units(syntax, id, evidence);
    see_complex_entries(syntax, id, evidence);
    see_conjugates(syntax, id, evidence);
    see_real_parts(syntax, id, evidence);
  }
  for (const SyntaxId side : sides) {
    for (const SyntaxId other : sides) {
      if (side == other) continue;
      see_equation_of_unit(syntax, side, other, side == sides.front(), evidence);
      see_makings(syntax, side, other, evidence);
    }
  }
}

void see_said_complex(std::string_view text, Evidence& evidence) {
  const std::string lower = lowered(text);
  const auto says = [&](std::string_view word) { return lower.find(word) != std::string::npos; };
  evidence.says_imaginary |= std::ranges::any_of(imaginary_words, says);
  evidence.says_conjugate |= says("conjugat");
  for (const char* letter : {"i", "j"}) {
    const std::string unit = letter;
    for (const std::string& sign : {"e^{" + unit, "e^{-" + unit, "$" + unit + "^2 = -1", "$" + unit + "^2=-1",
                                    "$" + unit + " = \\sqrt{-1}", "$" + unit + "=\\sqrt{-1}"}) {
      if (text.find(sign) != std::string_view::npos) evidence.imaginary_units.insert(unit);
    }
  }
  for (const std::string_view adjective : {"complex", "imaginary"})
    see_named_complex(text, adjective, evidence);
}

void see_declared_complex(const WrittenSymbol& symbol, bool complex, Evidence& evidence) {
  (complex ? evidence.complex_numbers : evidence.declared_real).insert(complex_name(symbol));
}

namespace {

constexpr std::string_view bold_start = "\\mathbf{";

/// `\boldsymbol\sigma` and `\sigma_i`: one of the three may be complex, whatever the others are.
void add_triples(Evidence& evidence) {
  std::set<std::string> found;
  for (const auto& [letter, parts] : evidence.made_of) {
    for (const std::string& part : parts) {
      const bool whole = part.starts_with(bold_start);
      const bool member = !whole && part.find("_{") != std::string::npos && !evidence.matrices.contains(part);
      if (whole && triple_of(evidence, part.substr(bold_start.size(), part.size() - bold_start.size() - 1)))
        found.insert(part);
      if (member && triple_of(evidence, part.substr(0, part.find("_{")))) found.insert(part);
    }
  }
  evidence.complex_numbers.merge(found);
}

}  // namespace

void settle_complex(Evidence& evidence) {
  add_triples(evidence);
  std::set<std::string>& units = evidence.imaginary_units;
  if (units.empty() && evidence.says_imaginary) units.insert("i");
  std::erase_if(units, [&](const std::string& letter) {
    return evidence.no_units.contains(letter) || evidence.changing.contains(letter);
  });
  std::set<std::string>& complex = evidence.complex_numbers;
  const bool about = !units.empty() || evidence.says_imaginary || evidence.says_conjugate;
  if (about) complex.insert(evidence.overlined.begin(), evidence.overlined.end());
  std::ranges::copy_if(evidence.starred, std::inserter(complex, complex.end()), [&](const std::string& name) {
    const std::string letter = name.substr(0, name.find_first_of("_^'"));
    if (evidence.says_conjugate && !is_one_of(std::string_view(letter), usually_labelled)) return true;
    return about && is_one_of(std::string_view(letter), usual_complex);
  });
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& [letter, parts] : evidence.made_of) {
      const bool vector =
          letter.starts_with(bold_start) &&
          evidence.real.contains(letter.substr(bold_start.size(), letter.size() - bold_start.size() - 1));
      const bool real =
          (evidence.real_parts.contains(letter) && !evidence.matrices.contains(letter)) || vector;
      if (real || units.contains(letter)) continue;
      const bool made = std::ranges::any_of(
          parts, [&](const std::string& part) { return units.contains(part) || complex.contains(part); });
      grew = (made && complex.insert(letter).second) || grew;
    }
  }
  for (const std::string& name : evidence.declared_real) complex.erase(name);
}

}  // namespace rigor
