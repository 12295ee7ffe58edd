// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/quantity/scene_letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rigor {
namespace {

/// The names of the usual letters as symbols: without indices and particle labels.
struct Usual {
  std::string_view latex;
  std::string_view name;
};
constexpr std::array usual_names{
    Usual{"m_\\alpha", "m"}, Usual{"\\mathbf{r}_\\alpha", "\\mathbf{r}"},
    Usual{"I_{ij}", "I"},    Usual{"I_1", "I_{1}"},
    Usual{"I_2", "I_{2}"},   Usual{"I_3", "I_{3}"},
};

std::string usual_name(const std::string& latex) {
  for (const Usual& usual : usual_names) {
    if (usual.latex == latex) return std::string(usual.name);
  }
  return latex;
}

const AskedForm* asked_form(const WrittenForms& forms, const std::string& latex) {
  const auto found = std::ranges::find(forms.asked, latex, &AskedForm::source);
  return found == forms.asked.end() ? nullptr : &*found;
}

std::string_view word_for(int rank) {
  constexpr std::array<std::string_view, 3> words{"a scalar", "a vector", "a tensor"};
  return words[static_cast<std::size_t>(std::clamp(rank, 0, 2))];
}

}  // namespace

SceneLetters::SceneLetters(const SceneFile& scene, const WrittenForms& forms, Diagnostics& diagnostics)
    : scene_(scene), forms_(forms), diagnostics_(diagnostics) {
  const SceneSymbols& symbols = scene.symbols;
  for (std::size_t i = 0; i < scene.values.size(); ++i) {
    const std::size_t count = scene.values[i].components.size();
    bind(scene.values[i].name, {count == 9 ? 2 : count == 3 ? 1 : 0, false}, SceneRole::value, i);
  }
  bind(symbols.mass, {0, true}, SceneRole::mass, 0);
  bind(symbols.position, {1, true}, SceneRole::position, 0);
  bind(symbols.spin, {1, false}, SceneRole::spin, 0);
  bind(symbols.tensor, {2, false}, SceneRole::tensor, 0);
  for (std::size_t i = 0; i < symbols.principal_moments.size(); ++i) {
    bind(symbols.principal_moments[i], {0, false}, SceneRole::moment, i);
  }
  for (const SymbolId spin : with_role(SceneRole::spin)) {
    if (const auto rate = forms.tree.symbols.find({spin, {By::time}})) {
      letters_.push_back({*rate, SceneRole::spin_rate, 0});
    }
  }
}

/// The symbol's name for a letter that was given: what the notes made of it.
std::optional<std::string> SceneLetters::name_of(const SceneText& letter, const Kind& kind) {
  if (!letter.given) return usual_name(letter.text);
  const AskedForm* form = asked_form(forms_, letter.text);
  if (form == nullptr) return std::nullopt;
  const ExprNode& node = forms_.tree[form->expr];
  if (node.op != Op::symbol) {
    diagnostics_.push_back(
        {DiagnosticKind::bad_scene, letter.span,
         fmt::format("`{}` is not a letter of the notes, but an expression", letter.text)});
    return std::nullopt;
  }
  const Symbol& symbol = forms_.tree.symbols[node.symbol];
  if (symbol.rank == kind.rank && symbol.per_particle == kind.per_particle) return symbol.name;
  diagnostics_.push_back({DiagnosticKind::bad_scene, letter.span,
                          fmt::format("`{}` is {}{} in the notes, but stands for {}{} here", letter.text,
                                      word_for(symbol.rank), symbol.per_particle ? " of each particle" : "",
                                      word_for(kind.rank), kind.per_particle ? " of each particle" : "")});
  return std::nullopt;
}

void SceneLetters::bind(const SceneText& letter, const Kind& kind, SceneRole role, std::size_t which) {
  const auto name = name_of(letter, kind);
  if (!name) return;
  for (std::size_t i = 0; i < forms_.tree.symbols.size(); ++i) {
    const auto id = static_cast<SymbolId>(i);
    const Symbol& symbol = forms_.tree.symbols[id];
    const bool same = symbol.name == *name && symbol.rank == kind.rank &&
                      symbol.per_particle == kind.per_particle && !symbol.derivation;
    if (same && find(id) == nullptr) letters_.push_back({id, role, which});
  }
}

const SceneLetter* SceneLetters::find(SymbolId symbol) const {
  const auto found = std::ranges::find(letters_, symbol, &SceneLetter::symbol);
  return found == letters_.end() ? nullptr : &*found;
}

std::vector<SymbolId> SceneLetters::with_role(SceneRole role) const {
  std::vector<SymbolId> symbols;
  for (const SceneLetter& letter : letters_) {
    if (letter.role == role) symbols.push_back(letter.symbol);
  }
  return symbols;
}

std::vector<SymbolId> SceneLetters::overriding() const {
  std::vector<SymbolId> symbols;
  for (const SceneLetter& letter : letters_) {
    if (letter.role != SceneRole::tensor) symbols.push_back(letter.symbol);
  }
  return symbols;
}

}  // namespace rigor
