// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/question_names.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "base/among.h"

namespace rigor {
namespace {

/// `definition I_{ij} (8)` ends in the tag of its equation; a line `12` is none.
std::optional<std::string> tag_at_end(const std::string& text) {
  if (!text.starts_with("definition ") || !text.ends_with(')')) return std::nullopt;
  const auto open = text.rfind(" (");
  if (open == std::string::npos) return std::nullopt;
  return text.substr(open + 1);
}

/// `M` or `\mathbf{v}_\alpha`: the name and the particle's letter.
std::string name_with_particle(const ExprTree& tree, const Definition& definition) {
  std::string name = tree.symbols[definition.symbol].name;
  if (definition.particle != no_particle) name += "_" + tree.name(definition.particle);
  return name;
}

std::string name_of(const ExprTree& tree, const Definition& definition, const Origin& origin) {
  const bool rate = tree.symbols[definition.symbol].derivation.has_value();
  if (!origin.expanded.empty()) return origin.expanded;
  const auto tag = tag_at_end(origin.text);
  if (rate) return tag ? fmt::format("derivative of Eq. {}", *tag) : "derivative of a definition";
  if (tag) return "Eq. " + *tag;
  return fmt::format("definition of {}", name_with_particle(tree, definition));
}

std::string name_of(const ExprTree& tree, const Equation& equation, const NamedAssumption* assumption) {
  if (assumption != nullptr)
    return assumption->origin.expanded.empty() ? assumption->origin.text : assumption->origin.expanded;
  if (equation.relation == Relation::equal) return "unit vector";
  return fmt::format("{} is not 0", tree.symbols[tree[equation.left].symbol].name);
}

}  // namespace

QuestionNames names_of(const Prepared& prepared) {
  const ExprTree& tree = *prepared.question.tree;
  QuestionNames names;
  for (std::size_t k = 0; k < prepared.definitions.size(); ++k)
    names.definitions.push_back(name_of(tree, prepared.question.definitions[k], *prepared.definitions[k]));
  for (std::size_t k = 0; k < prepared.assumptions.size(); ++k)
    names.assumptions.push_back(name_of(tree, prepared.question.assumptions[k], prepared.assumptions[k]));
  return names;
}

std::vector<const Origin*> origins_of(const Prepared& prepared, const std::vector<SymbolId>& unfolded) {
  std::vector<const Origin*> origins;
  for (std::size_t k = 0; k < prepared.definitions.size(); ++k) {
    if (!is_one_of(prepared.question.definitions[k].symbol, unfolded)) continue;
    origins.push_back(prepared.definitions[k]);
    origins.insert(origins.end(), prepared.put_in[k].begin(), prepared.put_in[k].end());
  }
  return origins;
}

std::string name_of_zero(const ExprTree& tree, SymbolId symbol) {
  const auto& derivation = tree.symbols[symbol].derivation;
  const std::string& name = tree.symbols[derivation ? derivation->base : symbol].name;
  return derivation ? fmt::format("{} does not change", name) : fmt::format("{} is 0", name);
}

}  // namespace rigor
