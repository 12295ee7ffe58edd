// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/running_letters.h"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/among.h"
#include "elaborate/name/function_value.h"

namespace rigor {
namespace {

/// t of `t'` and `t_1`.
std::string without_marks(const std::string& letter) { return letter.substr(0, letter.find_first_of("_^'")); }

bool is_made_of(const Names& names, SymbolId variable, SymbolId symbol) {
  const NameKey* own = key_of(names.symbols, symbol);
  const NameKey* of = key_of(names.symbols, variable);
  return own != nullptr && of != nullptr &&
         is_made_of(*names.symbols.evidence, changing_name(of->base), changing_name(own->base));
}

/// `\dot\theta` of which nothing says what it is.
bool has_free_rates(const ExprTree& tree, const NameScope& scope, const std::vector<SymbolId>& symbols) {
  return std::ranges::any_of(symbols, [&](SymbolId each) {
    return tree.symbols[each].order(By::time) > 0 && definition_of(scope, each) == nullptr;
  });
}

}  // namespace

bool is_independent(const Names& names, const ExprTree& tree, SymbolId symbol, const Integral& integral) {
  const NameKey* key = key_of(names.symbols, symbol);
  const NameKey* of = key_of(names.symbols, integral.variable);
  if (key == nullptr || of == nullptr || !is_one_of(integral.variable, symbols_in(tree, integral.integrand)))
    return false;
  const auto is_place = [](const NameKey& each) { return is_one_of(each.base, {"x", "y", "z"}); };
  const Evidence& evidence = *names.symbols.evidence;
  const bool usual = is_one_of(key->base, {"t", "x", "y", "z", "r"});
  const bool known = usual ? is_place(*of) && (is_place(*key) || key->base == "t")
                           : evidence.by.contains(key->base);  // \alpha of `d/d\alpha`
  if (!known) return false;
  const std::string name = changing_name(key->base);
  const auto tied = evidence.tied.find(name);
  return !is_changing(evidence, key->base) && (tied == evidence.tied.end() || tied->second.empty()) &&
         std::ranges::none_of(evidence.by, [&](const auto& entry) { return entry.second.contains(name); });
}

bool shows_change(const Names& names, SymbolId symbol, SymbolId variable) {
  const NameKey* own = key_of(names.symbols, symbol);
  const NameKey* of = key_of(names.symbols, variable);
  if (own == nullptr || of == nullptr) return own != nullptr && changes_in_section(names, symbol);
  const Evidence& evidence = *names.symbols.evidence;
  const std::set<std::string> usual{"t", "x", "y", "z", "r"};
  if (usual.contains(own->base) || is_changing(evidence, own->base)) return true;
  if (evidence.functions.contains(own->base)) return true;
  const std::string letter = without_marks(of->base);
  const auto stands_for = [&](const std::string& other) {
    return other == letter || (!usual.contains(letter) && usual.contains(other));
  };
  const auto others = evidence.tied.find(changing_name(own->base));
  return others != evidence.tied.end() && std::ranges::any_of(others->second | std::views::keys, stands_for);
}

bool is_tied_to(const Names& names, SymbolId symbol, SymbolId variable, std::optional<Span> but_by) {
  const NameKey* own = key_of(names.symbols, symbol);
  const NameKey* of = key_of(names.symbols, variable);
  if (own == nullptr || of == nullptr) return false;
  const auto& tied = names.symbols.evidence->tied;
  const std::string variable_letter = without_marks(of->base);
  std::vector<std::string> reached{changing_name(own->base)};
  for (std::size_t k = 0; k < reached.size(); ++k) {
    if (reached[k] == variable_letter) return true;
    const auto others = tied.find(reached[k]);
    if (others == tied.end()) continue;
    for (const auto& [other, rows] : others->second) {
      const bool by_this_alone = but_by && !rows.several && rows.first.file == but_by->file &&
                                 cover(rows.first, *but_by) == rows.first;
      if (!by_this_alone && !is_one_of(other, reached)) reached.push_back(other);
    }
  }
  return false;
}

bool counts_along(const Names& names, SymbolId symbol, SymbolId counter, std::optional<Span> but_by) {
  const NameKey* own = key_of(names.symbols, symbol);
  const NameKey* of = key_of(names.symbols, counter);
  return own == nullptr || of == nullptr || is_tied_to(names, symbol, counter, but_by) ||
         names.symbols.evidence->said_to_change.contains(own->base) ||  // "$q$ depends on $n$"
         is_function_of(*names.symbols.evidence, own->base, of->base);
}

bool is_function_of_only(const Names& names, const ExprTree& tree, SymbolId symbol, SymbolId variable) {
  const NameKey* own = key_of(names.symbols, base_of(tree.symbols, symbol));
  const NameKey* of = key_of(names.symbols, variable);
  if (own == nullptr || of == nullptr) return false;
  const Evidence& evidence = *names.symbols.evidence;
  const bool has_a_rate = has_rate(*names.symbols.sightings, *own);
  if (of->base != "t" && has_a_rate) return false;
  if (const auto variables = variables_of({.letter = own->base}, evidence))
    return *variables == std::vector{of->base};
  const auto applied = evidence.applied.find(own->base);
  const bool of_it = applied == evidence.applied.end() ||
                     std::ranges::all_of(applied->second, [&](const std::vector<std::string>& letters) {
                       return letters.size() == 1 && without_marks(letters[0]) == of->base;
                     });
  if (!of_it) return false;
  for (const auto& [by, functions] : evidence.by) {
    if (by != of->base && functions.contains(changing_name(own->base))) return false;
  }
  return has_a_rate || is_function_of(evidence, own->base, of->base);
}

std::vector<SymbolId> runs_along(const Names& names, const ExprTree& tree, const Definition& function) {
  const NameKey* own = key_of(names.symbols, function.symbol);
  if (own == nullptr) return {};
  const Evidence& evidence = *names.symbols.evidence;
  const std::string name = changing_name(own->base);
  std::set<std::string> variables;
  for (const auto& [function_name, written] : evidence.running) {
    if (changing_name(function_name) == name) variables.insert(written.begin(), written.end());
  }
  const bool held = is_declared_constant(names.scope, function.symbol);  // then its letters follow each other
  for (const auto& [by, functions] : evidence.by) {  // `dP/dR` beside `P = U^2R/(R + r)^2`
    if (by != "t" && functions.contains(name) && !held) variables.insert(by);
  }
  std::vector<SymbolId> along;
  for (const SymbolId letter : symbols_in(tree, function.body)) {
    const NameKey* key = key_of(names.symbols, letter);
    if (key != nullptr && key->rank == 0 && variables.contains(key->base)) along.push_back(letter);
  }
  return along;
}

std::vector<SymbolId> along_which(const Names& names, const std::vector<SymbolId>& along,
                                  const Variable& by) {
  std::vector<SymbolId> these;
  std::ranges::copy_if(along, std::back_inserter(these), [&](SymbolId letter) {
    const NameKey* key = key_of(names.symbols, letter);
    if (by.by == By::letter) return letter == by.letter;
    if (by == By::time) return key != nullptr && key->base == "t";
    return by == By::space && key != nullptr && is_one_of(key->base, {"x", "y", "z"});
  });
  return these;
}

bool is_parameter(const Names& names, const ExprTree& tree, SymbolId symbol, const Variable& by,
                  std::span<const SymbolId> along, Span row) {
  const Evidence& evidence = *names.symbols.evidence;
  const NameKey* own = key_of(names.symbols, symbol);
  if (own == nullptr || along.empty() || evidence.speaks_of_dependence) return false;
  if (by.held) return false;  // who names what is held holds nothing else
  if (tree.symbols[symbol].derivation || is_function_value(names, tree, symbol)) return false;
  if (const auto body = body_of_definition(names.scope, symbol))
    return by.by == By::letter && evidence.speaks_of_conservation &&
           has_free_rates(tree, names.scope, symbols_reached(tree, names.scope, {*body}));
  const bool changes_in_time =
      by == By::time && (evidence.speaks_of_change || is_changing(evidence, own->base));
  const auto functions = evidence.functions.find(own->base);  // "the Lorentz factor $\gamma(v)$"
  const bool is_function = functions != evidence.functions.end() && !functions->second.empty();
  return !changes_in_time && !is_function && !evidence.with_primes.contains(changing_name(own->base)) &&
         std::ranges::none_of(along, [&](SymbolId letter) {
           return symbol == letter || counts_along(names, symbol, letter, row) ||
                  is_made_of(names, letter, symbol);
         });
}

bool hides_variable(const Names& names, const ExprTree& tree, const Integral& integral, ExprId opened) {
  const NameKey* key = key_of(names.symbols, integral.variable);
  const std::vector<SymbolId> written = letters_in(tree, integral.integrand);
  return std::ranges::any_of(symbols_in(tree, opened), [&](SymbolId each) {
    const NameKey* other = key_of(names.symbols, each);
    if (key == nullptr || other == nullptr || each == integral.variable || is_one_of(each, written))
      return false;
    return without_marks(key->base) == without_marks(other->base) ||
           is_one_of(other->base, {"t", "x", "y", "z", "r", "s"});
  });
}

}  // namespace rigor
