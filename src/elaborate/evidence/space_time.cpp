// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>

#include "base/among.h"
#include "base/ascii.h"
#include "elaborate/evidence/evidence.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// Letters that are indices of space-time first of all.
bool is_usual_index(std::string_view letter) {
  static constexpr std::array<std::string_view, 6> letters{"\\mu",    "\\nu",     "\\rho",
                                                           "\\sigma", "\\lambda", "\\kappa"};
  return is_one_of(letter, letters);
}

/// Letters that are indices where others show it.
bool may_be_index(std::string_view letter) {
  static constexpr std::array<std::string_view, 7> letters{"\\alpha", "\\beta",  "\\gamma",  "\\delta",
                                                           "\\tau",   "\\omega", "\\epsilon"};
  return is_usual_index(letter) || is_one_of(letter, letters);
}

bool stands_plain(const WrittenSymbol& symbol) {
  return symbol.face == Face::plain && symbol.accent == Accent::none && symbol.lower.empty() &&
         symbol.primes == 0 && symbol.dots == 0 && symbol.change.empty();
}

/// A letter with its indices of one place, above or below.
struct Carried {
  std::string letter;  // empty: ∂
  std::vector<std::string> above;
  std::vector<std::string> below;
};

std::vector<std::string> greek_of(const std::vector<WrittenIndex>& indices) {
  std::vector<std::string> greek;
  for (const WrittenIndex& index : indices) {
    if (index.form == IndexForm::greek && may_be_index(index.text)) greek.push_back(index.text);
  }
  return greek;
}

std::vector<Carried> carried_in(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  std::vector<Carried> all;
  std::set<SyntaxId> bases;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::power) {
      const SyntaxId base = syntax.child(id, 0);
      if (syntax[base].kind != SyntaxKind::symbol) continue;
      const WrittenSymbol& symbol = syntax.symbol(base);
      const auto above = greek_of(indices_above(syntax, syntax.child(id, 1)));
      if (above.empty() || symbol.face != Face::plain) continue;
      bases.insert(base);
      all.push_back({letter_with_marks(symbol), above, greek_of(symbol.lower)});
    }
    if (syntax[id].kind == SyntaxKind::derivative) {
      for (const WrittenVariable& by : syntax.derivative(id).by) {
        const std::vector<std::string> greek = greek_of(by.symbol.lower);
        if (greek.empty() || by.symbol.letter != "x") continue;
        const bool raised = by.symbol.lower.front().raised;
        all.push_back(
            {"", raised ? greek : std::vector<std::string>{}, raised ? std::vector<std::string>{} : greek});
      }
    }
  }
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind != SyntaxKind::symbol || bases.contains(id)) continue;
    const WrittenSymbol& symbol = syntax.symbol(id);
    const std::vector<std::string> below = greek_of(symbol.lower);
    if (!below.empty() && symbol.face == Face::plain) all.push_back({letter_with_marks(symbol), {}, below});
  }
  return all;
}

/// What stands above something below `sides`.
std::set<SyntaxId> raised_below(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  std::vector<SyntaxId> exponents;
  std::set<SyntaxId> found;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind != SyntaxKind::power) continue;
    exponents.push_back(syntax.child(id, 1));
    found.insert(syntax.child(id, 0));
  }
  for (const SyntaxId id : nodes_below(syntax, exponents)) found.insert(id);
  return found;
}

/// The text without blanks, spacing, brackets that only group, and signs of layout.
std::string packed_formula(std::string_view text) {
  std::string all;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (text.substr(at, 2) == "\\\\") {
      all += text.substr(at++, 2);
      continue;
    }
    if (c == '\\' && at + 1 < text.size() &&
        (text[at + 1] == ',' || text[at + 1] == ';' || text[at + 1] == ' ')) {
      ++at;
      continue;
    }
    if (c != ' ' && c != '\n' && c != '\t' && c != '{' && c != '}' && c != '$' && c != '~') all += c;
  }
  for (const std::string_view word :
       {"\\left", "\\right", "\\operatorname", "\\mathrm", "\\text", "\\mathbf"}) {
    for (std::size_t at = all.find(word); at != std::string::npos; at = all.find(word, at)) {
      if (word == "\\left" && all.compare(at, 6, "\\leftr") == 0) {
        ++at;
        continue;
      }
      all.erase(at, word.size());
    }
  }
  return all;
}

bool has_any_part(std::string_view text, std::initializer_list<std::string_view> parts) {
  return std::ranges::any_of(
      parts, [&](std::string_view part) { return text.find(part) != std::string_view::npos; });
}

void see_signs(const std::string& text, SpaceTime& seen) {
  const bool plus =
      has_any_part(text, {"diag(1,-1,-1,-1", "diag(+1,-1,-1,-1", "diag(+,-,-,-", "(+,-,-,-)", "(+---)",
                          "(1,-1,-1,-1)", "(+1,-1,-1,-1)", "mostlyminus", "mostly-minus", "eta_00=1",
                          "eta_00=+1", "g_00=1", "g_00=+1", "1&0&0&0\\\\0&-1&0&0\\\\0&0&-1&0",
                          "ds^2=c^2dt^2-", "ds^2=dt^2-", "ds^2=c^2\\dt^2-", "x_\\mu=(ct,-", "x_\\mu=(t,-"});
  const bool minus = has_any_part(text, {"diag(-1,1,1,1", "diag(-1,+1,+1,+1", "diag(-,+,+,+", "(-,+,+,+)",
                                         "(-+++)", "(-1,1,1,1)", "(-1,+1,+1,+1)", "mostlyplus", "mostly-plus",
                                         "eta_00=-1", "g_00=-1", "-1&0&0&0\\\\0&1&0&0\\\\0&0&1&0",
                                         "ds^2=-c^2dt^2+", "ds^2=-dt^2+", "x_\\mu=(-ct,", "x_\\mu=(-t,"});
  if (plus) seen.signs.insert(1);
  if (minus) seen.signs.insert(-1);
}

}  // namespace

std::vector<WrittenIndex> indices_above(const SyntaxTree& syntax, SyntaxId exponent) {
  std::vector<WrittenIndex> found;
  const auto add = [&](SyntaxId id) {
    const Span span = syntax[id].span;
    if (syntax[id].kind == SyntaxKind::number) {
      for (const char digit : syntax.text(id)) {
        if (digit < '0' || digit > '3') return false;
        found.push_back({std::string(1, digit), IndexForm::digit, 0, span, true});
      }
      return true;
    }
    if (syntax[id].kind != SyntaxKind::symbol || !stands_plain(syntax.symbol(id))) return false;
    const std::string& letter = syntax.symbol(id).letter;
    static constexpr std::array<std::string_view, 6> latin{"i", "j", "k", "l", "m", "n"};
    const bool greek = may_be_index(letter);
    if (!greek && !is_one_of(letter, latin)) return false;
    found.push_back({letter, greek ? IndexForm::greek : IndexForm::letter, 0, span, true});
    return true;
  };
  if (syntax[exponent].kind != SyntaxKind::term) return add(exponent) ? found : std::vector<WrittenIndex>{};
  for (const SyntaxChild& child : syntax.children(exponent)) {
    const bool beside = found.empty() || child.joint == Joint::juxtaposed;
    if (!beside || !add(child.id)) return {};
  }
  return found;
}

void see_space_time(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, SpaceTime& seen) {
  const std::vector<Carried> all = carried_in(syntax, sides);
  std::map<std::string, int> times;
  std::set<std::string> above;
  std::set<std::string> below;
  bool sure = false;  // a tensor, or ∂, is among them
  for (const Carried& each : all) {
    for (const std::string& letter : each.above) above.insert(letter);
    for (const std::string& letter : each.below) below.insert(letter);
    for (const std::string& letter : each.above) ++times[letter];
    for (const std::string& letter : each.below) ++times[letter];
    const std::size_t count = each.above.size() + each.below.size();
    const bool usual = std::ranges::all_of(each.above, is_usual_index);
    if ((each.above.size() > 1 && usual) || (each.letter.empty() && !each.above.empty() && usual))
      seen.formulas = true;
    sure = sure || count > 1 || each.letter.empty() || !each.above.empty();
  }
  for (const std::string& letter : above) {
    if (is_usual_index(letter) && below.contains(letter)) seen.formulas = true;
  }
  for (const Carried& each : all) {
    const std::size_t count = each.above.size() + each.below.size();
    const auto repeats = [&](const std::string& letter) { return times[letter] > 1; };
    const bool tensor =
        !each.above.empty() || count > 1 || (sure && std::ranges::any_of(each.below, repeats));
    if (!tensor && !each.letter.empty()) continue;
    seen.indices.insert(each.above.begin(), each.above.end());
    seen.indices.insert(each.below.begin(), each.below.end());
    if (!each.letter.empty()) seen.tensors[each.letter].insert(count);
  }
  const std::set<SyntaxId> raised = raised_below(syntax, sides);
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::symbol && !raised.contains(id) && syntax.symbol(id).lower.empty())
      seen.on_line.insert(syntax.symbol(id).letter);
  }
}

void see_said_space_time(std::string_view text, SpaceTime& seen) {
  const std::string lower = lowered_line(text);
  seen.words =
      seen.words || has_any_part(lower, {"four-vector", "4-vector", "four vector", "minkowski", "spacetime",
                                         "space-time", "four-moment", "four-velocit", "four-potential",
                                         "four-current", "lorentz", "4-moment", "4-velocit",
                                         "special relativity", "relativistic notation", "covariant"});
  seen.curved = seen.curved ||
                has_any_part(lower, {"curved", "curvature", "christoffel", "general relativity", "riemann",
                                     "ricci", "geodesic", "covariant derivative", "schwarzschild",
                                     "einstein's field", "einstein equation", "einstein tensor"});
  if (!has_any_part(
          text, {"\\mu", "\\eta", "diag", "metric", "signature", "units", "c = 1", "c=1", "s^2", "mostly"}))
    return;
  const std::string pack = packed_formula(text);
  see_signs(pack, seen);
  see_signs(packed_formula(lower), seen);
  for (const std::string_view said :
       {"c=1", "naturalunits", "x^\\mu=(t,", "x^0=t", "c=\\hbar=1", "\\hbar=c=1"}) {
    const auto at = pack.find(said);
    if (at == std::string::npos) continue;
    const char behind = at + said.size() < pack.size() ? pack[at + said.size()] : ' ';
    const char before = at > 0 ? pack[at - 1] : ' ';
    const bool goes_on = is_letter_or_digit(behind) || behind == '.' || behind == '/' || is_letter(before);
    if (!goes_on || said.back() == ',' || said == "naturalunits") seen.unit_speed = true;
  }
}

void settle_space_time(const SpaceTime& file, Evidence& evidence) {
  SpaceTime& seen = evidence.space_time;
  seen.curved = seen.curved || (file.curved && !seen.words && !file.words);
  if (seen.signs.empty()) seen.signs = file.signs;
  const auto has = [&](const char* letter, std::size_t count) {
    const auto found = seen.tensors.find(letter);
    return found != seen.tensors.end() && found->second.contains(count);
  };
  // Γ^λ_μν, R^ρ_σμν, and a metric g whose signs nobody says, belong to any metric.
  seen.curved = seen.curved || has("\\Gamma", 3) || has("R", 4) || (has("g", 2) && seen.signs.size() != 1);
  seen.unit_speed = seen.unit_speed || file.unit_speed;
  const std::string& space = evidence.other_space;
  const bool four = space.empty() || has_any_part(space, {"four", "4", "minkowski", "space"}) ||
                    (space.starts_with("ind") && has_any_part(space, {"0"}));
  bool greek_pair = false;
  for (const auto& [letter, counts] : seen.tensors)
    greek_pair = greek_pair || counts.upper_bound(1) != counts.end();
  const bool usual = std::ranges::any_of(seen.indices, is_usual_index);
  seen.shown = four && (seen.formulas || (seen.words && greek_pair) || ((seen.words || file.words) && usual));
  for (const char* letter : {"i", "j"}) {  // of `F^{i0}` and `j^\mu`: no imaginary unit
    if (seen.shown && !seen.on_line.contains(letter)) evidence.letters.erase(letter);
  }
  const bool flat_g = seen.tensors.contains("g") && !seen.tensors.contains("\\eta");
  if (flat_g) seen.metric = "g";
}

bool is_space_time_index(const Evidence& evidence, const WrittenIndex& index) {
  const SpaceTime& seen = evidence.space_time;
  if (!seen.shown || index.form != IndexForm::greek || index.primes > 0) return false;
  if (is_usual_index(index.text)) return true;
  return seen.indices.contains(index.text) && !seen.on_line.contains(index.text);
}

}  // namespace rigor
