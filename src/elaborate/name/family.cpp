// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/family.h"

#include <algorithm>
#include <string_view>

#include "base/ascii.h"

namespace rigor {
namespace {

/// The next term of `2n+1`, with its sign; false: it is none.
bool take_term(std::string_view& index, bool is_first, MemberName& name) {
  const bool sign = index[0] == '+' || index[0] == '-';
  if (!sign && !is_first) return false;
  const int factor = index[0] == '-' ? -1 : 1;
  if (sign) index.remove_prefix(1);
  int number = 0;
  std::size_t digits = 0;
  while (digits < index.size() && is_digit(index[digits])) number = 10 * number + (index[digits++] - '0');
  if (digits > 3) return false;
  index.remove_prefix(digits);
  const std::string_view ell = "\\ell";
  const std::size_t length = index.starts_with(ell) ? ell.size() : 1;
  const std::string letter(index.substr(0, std::min(length, index.size())));
  if (!may_count_members(letter)) {
    name.number += factor * number;
    return digits > 0;
  }
  name.letters[letter] += factor * (digits > 0 ? number : 1);
  index.remove_prefix(length);
  return true;
}

bool is_letter_alone(const MemberName& name) {
  return name.letters.size() == 1 && name.letters.begin()->second == 1 && name.number == 0;
}

}  // namespace

std::optional<MemberName> member_name(const NameKey& key) {
  const auto bar = key.base.find("_{");
  if (key.rank > 0 || key.per_particle || key.complex || key.noncommuting || bar == std::string::npos ||
      bar == 0 || !key.base.ends_with('}') || key.base.find('^') != std::string::npos)
    return std::nullopt;
  MemberName name{key.base.substr(0, bar), {}, 0};
  std::string index = key.base.substr(bar + 2, key.base.size() - bar - 3);
  const std::string_view text = "\\text{";
  if (index.starts_with(text) && index.ends_with('}'))
    index = index.substr(text.size(), index.size() - text.size() - 1);
  std::erase_if(index, [](char c) { return is_white(c); });
  if (index.empty()) return std::nullopt;
  std::string_view rest = index;
  for (bool is_first = true; !rest.empty(); is_first = false) {
    if (!take_term(rest, is_first, name)) return std::nullopt;
  }
  std::erase_if(name.letters, [](const auto& each) { return each.second == 0; });
  const bool number = name.letters.empty();
  return number && index.size() != 1 ? std::nullopt : std::optional(std::move(name));
}

bool counts_with(const Names& names, SymbolId symbol) {
  const NameKey* key = key_of(names.symbols, symbol);
  const auto name = key == nullptr ? std::nullopt : member_name(*key);
  if (!name || !is_letter_alone(*name)) return false;
  const auto& counting = names.symbols.evidence->counting;
  const auto found = counting.find(name->letters.begin()->first);
  return found != counting.end() && found->second.said && !found->second.some_only;
}

void note_family(Names& names, SymbolId defined) {
  NameScope& scope = names.scope;
  const NameKey* key = key_of(names.symbols, defined);
  const auto name = key == nullptr ? std::nullopt : member_name(*key);
  std::vector<SymbolId> others;
  bool has_components = false;  // E_1 may be one of \mathbf E
  for (const auto& [symbol, depth] : scope.seen) {
    const NameKey* own = key_of(names.symbols, symbol);
    has_components =
        has_components || (name && own != nullptr && own->rank > 0 && own->base == name->sequence);
    const auto other = own == nullptr || symbol == defined ? std::nullopt : member_name(*own);
    if (name && other && other->sequence == name->sequence && !membership_of(names, symbol))
      others.push_back(symbol);
  }
  end_family(scope, defined);
  if (!name || !is_letter_alone(*name)) return;
  const std::string& letter = name->letters.begin()->first;
  const Evidence& evidence = *names.symbols.evidence;
  const auto found = evidence.counting.find(letter);
  const CountingLetter counting = found == evidence.counting.end() ? CountingLetter{} : found->second;
  if (counting.some_only) return;
  const bool usual = letter == "n" && evidence.speaks_of_levels && !evidence.numbered.contains(letter);
  scope.families.push_back({.general = defined,
                            .sequence = name->sequence,
                            .letter = letter,
                            .by_number = (counting.said || usual) && !has_components,
                            .first = counting.first.value_or(0),
                            .depth = scope.depth});
  for (const SymbolId each : others) {
    if (!member_name(*key_of(names.symbols, each))->letters.contains(letter)) set_apart(scope, each);
  }
}

std::optional<Membership> membership_of(const Names& names, SymbolId symbol) {
  const NameScope& scope = names.scope;
  if (scope.families.empty() || scope.apart.contains(symbol)) return std::nullopt;
  const NameKey* key = key_of(names.symbols, symbol);
  const auto name = key == nullptr ? std::nullopt : member_name(*key);
  if (!name || names.symbols.evidence->quantities_apart.contains(key->base)) return std::nullopt;
  const Family* found = nullptr;
  int of_sequence = 0;
  for (const Family& each : scope.families) {
    if (each.sequence != name->sequence) continue;
    ++of_sequence;
    if (each.general == symbol) return std::nullopt;
    if (found == nullptr || name->letters.contains(each.letter)) found = &each;
  }
  if (found == nullptr || (of_sequence > 1 && !name->letters.contains(found->letter))) return std::nullopt;
  const bool number = name->letters.empty();
  if (number && (!found->by_number || name->number < found->first)) return std::nullopt;
  return Membership{*found, *name};
}

}  // namespace rigor
