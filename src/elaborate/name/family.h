// SPDX-License-Identifier: GPL-3.0-or-later
// `E_n = n^2\epsilon` says what E_1, E_{n+1} and E_{2n} are: the members of a family, by the index in their
// names. Only a definition by value makes one, and it ends with its section. A name may be a member and mean
// something else all the same (E_0, the amplitude of a field), so that what follows helps proofs only.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "elaborate/name/names.h"

namespace rigor {

/// `E_{2n+1}`: the member 2n + 1 of E.
struct MemberName {
  std::string sequence;                // `E`, `\hat{E}`
  std::map<std::string, int> letters;  // n, with 2
  int number = 0;                      // 1
};
/// Nothing for labels that are no such index. An index without letters is one digit.
[[nodiscard]] std::optional<MemberName> member_name(const NameKey& key);

/// `E_n`: does the section say that n is any whole number from some first one on?
[[nodiscard]] bool counts_with(const Names& names, SymbolId symbol);

/// The symbol was defined here: its members are known by it, but for those that rows above speak of.
void note_family(Names& names, SymbolId defined);

struct Membership {
  Family family;
  MemberName name;
};
/// By its name alone; the general member, and what was set apart, are none.
[[nodiscard]] std::optional<Membership> membership_of(const Names& names, SymbolId symbol);

}  // namespace rigor
