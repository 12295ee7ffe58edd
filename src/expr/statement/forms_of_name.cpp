// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/statement/forms_of_name.h"

#include <algorithm>
#include <map>

namespace rigor {
namespace {

/// The name that a chain begins with.
std::optional<SymbolId> symbol_named(const WrittenForms& forms, const WrittenFormChain& chain) {
  if (chain.forms.size() < 2 || !chain.forms[0].expr) return std::nullopt;
  const ExprNode& first = forms.tree[*chain.forms[0].expr];
  const bool whole = first.op == Op::symbol && first.slot_count == 0 && first.particle == no_particle;
  return whole ? std::optional(first.symbol) : std::nullopt;
}

bool is_certain(const WrittenFormChain& chain) {
  const bool bare = chain.indices.empty() && chain.particles.empty() && !chain.assumed;
  return bare && std::ranges::all_of(chain.steps, [](const WrittenStep& step) {
           const bool equal = !step.question || step.question->claim.relation == Relation::equal;
           return equal && !step.nearly && (step.defines || step.outcome == Outcome::proved);
         });
}

bool defines_alike(const WrittenFormChain& a, const WrittenFormChain& b) {
  return std::ranges::all_of(a.definitions, [&](const Definition& one) {
    return std::ranges::all_of(b.definitions, [&](const Definition& other) {
      return one.symbol != other.symbol || one.body == other.body;
    });
  });
}

void add(WrittenFormChain& all, const WrittenFormChain& chain) {
  for (const Definition& definition : chain.definitions) {
    const bool known = std::ranges::any_of(
        all.definitions, [&](const Definition& each) { return each.symbol == definition.symbol; });
    if (!known) all.definitions.push_back(definition);
  }
  for (const WrittenForm& form : chain.forms) {
    const bool known =
        std::ranges::any_of(all.forms, [&](const WrittenForm& each) { return each.source == form.source; });
    if (known) continue;
    all.steps.push_back({.kind = "=", .outcome = Outcome::proved});
    all.forms.push_back(form);
  }
}

}  // namespace

std::vector<WrittenFormChain> forms_of_one_name(const WrittenForms& forms) {
  std::vector<WrittenFormChain> result;
  std::map<SymbolId, std::size_t> known;  // positions in `result`
  std::vector<std::size_t> counts;
  for (const WrittenFormChain& chain : forms.chains) {
    const auto name = symbol_named(forms, chain);
    if (!name || !is_certain(chain)) continue;
    const auto [entry, fresh] = known.try_emplace(*name, result.size());
    if (fresh) {
      result.push_back(chain);
      counts.push_back(1);
    } else if (defines_alike(result[entry->second], chain)) {
      add(result[entry->second], chain);
      ++counts[entry->second];
    }
  }
  std::vector<WrittenFormChain> several;
  for (std::size_t k = 0; k < result.size(); ++k) {
    if (counts[k] > 1) several.push_back(std::move(result[k]));
  }
  return several;
}

}  // namespace rigor
