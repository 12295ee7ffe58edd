// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/contrary_words.h"

#include <algorithm>
#include <array>

#include "base/among.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

struct KindWord {
  std::string_view word;
  int group;
  int kind;
  bool general = false;  // what is stated of it holds for the others of its group, too
};

constexpr auto kinds = std::to_array<KindWord>({
    {"monatomic", 1, 1},
    {"monoatomic", 1, 1},
    {"diatomic", 1, 2},
    {"triatomic", 1, 3},
    {"polyatomic", 1, 4},
    {"overdamped", 2, 1},
    {"underdamped", 2, 2},
    {"laminar", 3, 1},
    {"turbulent", 3, 2},
    {"fermions", 4, 1},
    {"fermionic", 4, 1},
    {"bosons", 4, 2},
    {"bosonic", 4, 2},
    {"massless", 5, 1},
    {"massive", 5, 2, true},
    {"electrostatics", 6, 1},
    {"electrodynamics", 6, 2, true},
    {"newtonian", 7, 1},
    {"relativistic", 7, 2, true},
    {"conducting", 8, 1},
    {"insulating", 8, 2},
    {"hollow", 9, 1},
    {"solid", 9, 2},
    {"ferromagnetic", 10, 1},
    {"antiferromagnetic", 10, 2},
    {"prolate", 11, 1},
    {"oblate", 11, 2},
    {"elliptic", 12, 1},
    {"elliptical", 12, 1},
    {"hyperbolic", 12, 2},
    {"parabolic", 12, 3},
    {"thin", 13, 1},
    {"thick", 13, 2},
});

const KindWord* kind_of(std::string_view word) {
  const auto found = std::ranges::find(kinds, word, &KindWord::word);
  return found == kinds.end() ? nullptr : &*found;
}

/// Adjectives that "in-", "non-" and "un-" deny.
bool has_ending_of_an_adjective(std::string_view word) {
  static constexpr std::array<std::string_view, 8> endings{"ible", "able", "ic", "ed",
                                                           "ing",  "ar",   "al", "tive"};
  return std::ranges::any_of(endings, [&](std::string_view ending) { return word.ends_with(ending); }) ||
         is_one_of(word, {"steady", "uniform", "viscid"});
}

/// "The known and the unknown function", "the homogeneous equation", whose solutions are put to one of the
/// inhomogeneous one: both are said of one problem.
bool goes_with_its_contrary(std::string_view word) {
  return is_one_of(
      word, {"changed", "determined", "altered", "affected", "primed", "limited", "specified", "defined",
             "variable", "equal", "trivial", "degenerate", "integral", "homogeneous", "rotating"});
}

/// The special case is the one without a prefix: a linear law says nothing of a nonlinear system.
bool is_special_itself(std::string_view word) {
  return is_special(word) || is_one_of(word, {"linear", "elastic", "reversible"});
}

constexpr std::array<std::string_view, 6> prefixes{"in", "im", "ir", "non-", "non", "un"};

/// "compressible" of "incompressible"; empty where the word denies nothing.
std::string_view denied_by(std::string_view word, std::string_view prefix) {
  constexpr std::size_t shortest = 5;
  if (!word.starts_with(prefix)) return {};
  word.remove_prefix(prefix.size());
  const bool counts =
      word.size() >= shortest && has_ending_of_an_adjective(word) && !goes_with_its_contrary(word);
  return counts ? word : std::string_view{};
}

bool is_shut_out(std::string_view said, std::string_view here, bool also_un) {
  const KindWord* first = kind_of(said);
  const KindWord* second = kind_of(here);
  if (first != nullptr && second != nullptr && first->group == second->group)
    return first->kind != second->kind && !first->general;
  return std::ranges::any_of(prefixes, [&](std::string_view prefix) {
    if (prefix == "un" && !also_un) return false;
    return (denied_by(said, prefix) == here && !is_special_itself(here)) ||
           (denied_by(here, prefix) == said && is_special_itself(said));
  });
}

/// "The spin of the electron": of what, and of whom.
struct Owned {
  std::string_view thing;
  std::string_view owner;
};

std::vector<Owned> owned_in(std::string_view text) {
  static constexpr std::array<std::string_view, 3> articles{"the", "a", "an"};
  const std::vector<std::string_view> words = words_of(text);
  std::vector<Owned> owned;
  for (std::size_t k = 1; k + 2 < words.size(); ++k) {
    if (words[k] == "of" && is_one_of(words[k + 1], articles)) owned.push_back({words[k - 1], words[k + 2]});
  }
  return owned;
}

}  // namespace

std::vector<std::string> case_words_of(std::string_view text) {
  std::vector<std::string> found;
  for (const std::string_view word : words_of(text)) {
    const bool counts = kind_of(word) != nullptr || has_ending_of_an_adjective(word);
    if (counts && !is_one_of(word, found)) found.emplace_back(word);
  }
  return found;
}

bool is_shut_out_by(std::string_view said, std::string_view here) { return is_shut_out(said, here, true); }

bool is_kind_shut_out_by(std::string_view said, std::string_view here) {
  return is_shut_out(said, here, false);
}

bool names_the_same_owner(std::string_view said, std::string_view here) {
  const std::vector<Owned> first = owned_in(said);
  return std::ranges::any_of(owned_in(here), [&](const Owned& each) {
    return std::ranges::any_of(
        first, [&](const Owned& other) { return other.thing == each.thing && other.owner == each.owner; });
  });
}

std::optional<std::string> other_owner(std::string_view said, std::string_view here) {
  const std::vector<Owned> first = owned_in(said);
  for (const Owned& each : owned_in(here)) {
    const auto same_thing = [&](const Owned& other) { return other.thing == each.thing; };
    const bool same = std::ranges::any_of(
        first, [&](const Owned& other) { return same_thing(other) && other.owner == each.owner; });
    if (!same && std::ranges::any_of(first, same_thing)) return std::string(each.owner);
  }
  return std::nullopt;
}

}  // namespace rigor
