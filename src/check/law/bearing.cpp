// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/bearing.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

#include "base/among.h"
#include "check/question/base_letters.h"
#include "expr/tree/state.h"

namespace rigor {

namespace {

std::size_t foreign_among(const std::set<SymbolId>& letters, const std::set<SymbolId>& known) {
  return static_cast<std::size_t>(
      std::ranges::count_if(letters, [&](SymbolId each) { return !known.contains(each); }));
}

/// A law for `|n\rangle` is one for `|0\rangle`: where a row has this ket, it shares that letter.
void add_numbered_kets(const ExprTree& tree, std::set<SymbolId>& letters) {
  std::set<std::size_t> sizes;
  for (const SymbolId each : letters) {
    const std::vector<LabelPart>& label = tree.symbols[each].label;
    const bool numbered = std::ranges::any_of(
        label, [](const LabelPart& part) { return part.letter.empty() || numbers_states(part); });
    if (tree.symbols[each].ket && numbered) sizes.insert(label.size());
  }
  for (std::uint32_t k = 0; !sizes.empty() && k < tree.symbols.size(); ++k) {
    const Symbol& symbol = tree.symbols[SymbolId{k}];
    if (symbol.ket && sizes.contains(symbol.label.size()) &&
        std::ranges::any_of(symbol.label, numbers_states))
      letters.insert(SymbolId{k});
  }
}

}  // namespace

Laws laws_that_bear(const ExprTree& tree, const NameScope& scope, const Equation& row,
                    const Laws& available) {
  struct Bearing {
    const PageLaw* law;
    std::pair<std::size_t, std::size_t> foreign;  // letters in all, and written ones
  };
  std::set<SymbolId> reached = base_letters(tree, scope, row);
  add_numbered_kets(tree, reached);
  const std::set<SymbolId> own = written_letters(tree, row);
  std::vector<std::set<SymbolId>> letters_of;  // of the laws, in their order
  for (const PageLaw* law : available) letters_of.push_back(base_letters(tree, scope, law->equation));
  Laws bearing;
  for (bool grew = true; grew;) {
    std::vector<Bearing> round;
    std::set<SymbolId> more;
    for (std::size_t k = available.size(); k-- > 0;) {
      if (is_one_of(available[k], bearing)) continue;
      const std::size_t foreign = foreign_among(letters_of[k], reached);
      if (foreign == letters_of[k].size()) continue;
      const std::size_t written = foreign_among(written_letters(tree, available[k]->equation), own);
      round.push_back({available[k], {foreign, written}});
      more.insert(letters_of[k].begin(), letters_of[k].end());
    }
    std::ranges::stable_sort(round, {}, &Bearing::foreign);
    for (const Bearing& each : round) bearing.push_back(each.law);
    reached.merge(more);
    grew = !round.empty();
  }
  return bearing;
}

std::vector<Laws> sets_of(const ExprTree& tree, const Laws& bearing) {
  constexpr std::size_t most_alone = 3;
  constexpr std::array<std::size_t, 4> counts{2, 3, 5, 8};
  std::vector<Laws> sets{{}};
  for (std::size_t k = 0; k < std::min(most_alone, bearing.size()); ++k) sets.push_back({bearing[k]});
  Laws together;
  std::set<std::string> sides;
  for (const PageLaw* law : bearing) {
    const bool stated = law->standing == Standing::law;  // results do not say it of another thing
    const bool known = stated && !sides.insert(dump(tree, law->equation.left)).second;
    if (!known || !law->of_its_own) together.push_back(law);
  }
  for (const std::size_t count : counts) {
    const std::size_t taken = std::min(count, together.size());
    if (taken > 1 && sets.back().size() < taken)
      sets.emplace_back(together.begin(), together.begin() + taken);
  }
  return sets;
}

std::vector<Laws> sets_of_states(const Laws& bearing) {
  constexpr std::array<std::size_t, 5> counts{1, 2, 3, 4, 6};
  Laws nearest;
  std::ranges::copy_if(bearing, std::back_inserter(nearest),
                       [](const PageLaw* law) { return law->standing == Standing::law; });
  std::ranges::stable_sort(nearest, std::ranges::greater{},
                           [](const PageLaw* law) { return std::pair(law->span.file, law->span.begin); });
  std::vector<Laws> sets;
  for (const std::size_t count : counts) {
    const std::size_t taken = std::min(count, nearest.size());
    if (taken > 0 && (sets.empty() || sets.back().size() < taken))
      sets.emplace_back(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(taken));
  }
  return sets;
}

}  // namespace rigor
