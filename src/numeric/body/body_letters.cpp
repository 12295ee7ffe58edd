// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/body_letters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {
namespace {

/// `\mathbf{r}` as `r`.
std::string_view letter_of(std::string_view name) {
  const auto open = name.find('{');
  if (!name.starts_with('\\') || open == std::string_view::npos || !name.ends_with('}')) return name;
  return name.substr(open + 1, name.size() - open - 2);
}

Result<std::optional<SymbolId>> choose(const ExprTree& tree, const std::vector<SymbolId>& candidates,
                                       const char* what, std::initializer_list<std::string_view> usual) {
  if (candidates.empty()) return std::optional<SymbolId>();
  if (candidates.size() == 1) return std::optional(candidates[0]);
  for (const std::string_view letter : usual) {
    for (const SymbolId symbol : candidates) {
      if (letter_of(tree.symbols[symbol].name) == letter) return std::optional(symbol);
    }
  }
  std::vector<std::string> names;
  for (const SymbolId symbol : candidates) names.push_back(fmt::format("`{}`", tree.symbols[symbol].name));
  return tl::unexpected(
      Error{fmt::format("each of {} can be the {} of the particles", fmt::join(names, ", "), what)});
}

}  // namespace

Result<BodyLetters> body_letters(const ExprTree& tree, std::span<const Program* const> programs) {
  std::set<SymbolId> read;
  for (const Program* program : programs) {
    for (const ProgramInput& input : program->inputs()) {
      if (input.per_particle && !tree.symbols[input.symbol].derivation) read.insert(input.symbol);
    }
  }
  std::vector<SymbolId> scalars;
  std::vector<SymbolId> vectors;
  for (const SymbolId symbol : read) {
    if (tree.symbols[symbol].rank == 0) scalars.push_back(symbol);
    if (tree.symbols[symbol].rank == 1) vectors.push_back(symbol);
  }
  const auto mass = choose(tree, scalars, "mass", {"m"});
  if (!mass) return tl::unexpected(mass.error());
  const auto position = choose(tree, vectors, "position", {"r", "x"});
  if (!position) return tl::unexpected(position.error());
  return BodyLetters{*mass, *position};
}

}  // namespace rigor
