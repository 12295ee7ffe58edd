// SPDX-License-Identifier: GPL-3.0-or-later
// Words in displays. Only what is in the lists of remarks.cpp is a remark; docs/notation.md shows them.
#pragma once

#include <cstdint>
#include <set>
#include <string>

namespace rigor {

/// What words next to an equation do to it.
enum class Remark : std::uint8_t {
  connective,  // "and", "therefore": another equation follows
  no_sum,      // "no sum over i": repeated indices in it are not summed
  cyclic,      // "and cyclic permutations", "etc.": it is said for the other axes, too
  quantifier,  // "for all vectors": says what is taken for granted
  remark,      // names it, its parts or its source: nothing
  unread,      // any other words: what they do is not known, and the equation is not judged
};

/// English words. A letter among them stands for the symbol of that name.
[[nodiscard]] Remark remark_of(const std::string& words);

/// Words that claim that what follows them is concluded: "hence", "so that", "which gives".
[[nodiscard]] bool concludes(const std::string& words);

/// "if", "for", "where", "in the limit": the words begin to say when an equation holds.
[[nodiscard]] bool opens_a_condition(const std::string& words);

/// Words that are in no list and can at most say when an equation holds, or how its parts are called: "in the
/// bulk". Not "false", "is not zero", "times", "mod", "lb", which change what it says.
[[nodiscard]] bool can_only_restrict(const std::string& words);

/// Words that tell at once that they are not part of the equation: "by Jacobi", "(definition)", ", as above".
[[nodiscard]] bool stands_apart(const std::string& words);

/// The symbols that are named among words: `i` of "no sum over $i$", `alpha` of "for all $\alpha$".
[[nodiscard]] std::set<std::string> symbols_in_words(const std::string& words);

}  // namespace rigor
