// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/ascii.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// The place after the first of the words that begins a word of the text; `npos` where none does.
template <std::size_t n>
std::size_t behind_any(std::string_view text, const std::array<std::string_view, n>& words) {
  for (const std::string_view word : words) {
    for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
      if (at == 0 || !is_letter(word[0]) || !is_letter(text[at - 1])) return at + word.size();
    }
  }
  return std::string_view::npos;
}

template <std::size_t n>
bool has_any(std::string_view text, const std::array<std::string_view, n>& words) {
  return behind_any(text, words) != std::string_view::npos;
}

// -- what does not commute --

/// "Position and momentum do not commute", "the order matters"; not "rotations do not commute", which says
/// nothing about letters that are not rotations.
bool denies_commuting(std::string_view sentence) {
  static constexpr std::array<std::string_view, 5> outright{"noncommut", "non-commut", "anticommut",
                                                            "anti-commut", "order matters"};
  static constexpr std::array<std::string_view, 8> about_others{
      "cross product", "vector product", "rotation", "derivative", "limit", "diagram", "partial", "\\times"};
  static constexpr std::array<std::string_view, 9> negations{
      "not ", "n't ", "never", "no longer", "fail", "cannot", "neither", "nor ", "no two"};
  if (has_any(sentence, about_others)) return false;
  if (has_any(sentence, outright)) return true;
  const auto verb = sentence.find("commut");
  return verb != std::string_view::npos && has_any(sentence.substr(0, verb), negations);
}

/// "Let $G$ be a group", "in the symmetric group"; not "the group velocity", "we group the terms", "the group
/// of waves".
bool speaks_of_group(std::string_view sentence) {
  static constexpr std::array<std::string_view, 16> before{
      "a ",   "the ",       "any ",      "this ",  "every ", "finite ", "abstract ", "symmetry ",
      "lie ", "symmetric ", "dihedral ", "braid ", "free ",  "matrix ", "quotient ", "infinite "};
  static constexpr std::array<std::string_view, 6> of_elements{" of matri",  " of rotation", " of permut",
                                                               " of transf", " of autom",    " of order"};
  static constexpr std::array<std::string_view, 8> others{" velocit", " delay",  " speed", " dispers",
                                                          " index",   " refrac", " of ",   "ing"};
  for (auto at = sentence.find("group"); at != std::string_view::npos; at = sentence.find("group", at + 1)) {
    const std::string_view rest = sentence.substr(at + 5);
    const auto starts = [&](std::string_view word) { return rest.starts_with(word); };
    const std::string_view left = sentence.substr(0, at);
    const bool named =
        std::ranges::any_of(before, [&](std::string_view word) { return left.ends_with(word); });
    const bool commutes = left.ends_with("abelian ") || left.ends_with("commutative ");
    const bool plural = starts("s ") && (at == 0 || left.ends_with(". ") || left.ends_with("in "));
    const bool elements = std::ranges::any_of(of_elements, starts);
    if (elements || starts(" element")) return true;
    if (commutes || std::ranges::any_of(others, starts)) continue;
    if (named || plural) return true;
  }
  static constexpr std::array<std::string_view, 9> words{"subgroup",   "semigroup",     "monoid",
                                                         "be a ring",  "division ring", "ring of ",
                                                         "quaternion", "concatenat",    "matrix algebra"};
  return has_any(sentence, words);
}

/// Words for sums and products that are not those of numbers.
constexpr std::array<std::string_view, 29> other_arithmetics{"\\z/",
                                                             "\\f_p",
                                                             "\\f_q",
                                                             "\\mathbb{z}_",
                                                             "\\mathbb z_",
                                                             "\\mathbb{f}_",
                                                             "\\mathbb f_",
                                                             "gf(",
                                                             "\\pmod",
                                                             "\\bmod",
                                                             "octonion",
                                                             "sedenion",
                                                             "not associative",
                                                             "nonassociative",
                                                             "non-associative",
                                                             "tropical algebra",
                                                             "tropical semiring",
                                                             "tropical sum",
                                                             "tropical arithmetic",
                                                             "max-plus",
                                                             "boolean algebra",
                                                             "boolean ring",
                                                             "boolean variab",
                                                             "finite field",
                                                             "characteristic two",
                                                             "grassmann number",
                                                             "integer arithmetic",
                                                             "jordan algebra",
                                                             "interval arithmetic"};

/// "Modulo 2", "mod $p$"; not "modulo $2\\pi$" or "modulo a constant".
std::string_view modulus_in(std::string_view sentence) {
  for (const std::string_view word : {"modulo ", "mod "}) {
    const auto at = sentence.find(word);
    if (at == std::string_view::npos || (at > 0 && is_letter(sentence[at - 1]))) continue;
    std::string_view rest = sentence.substr(at + word.size());
    const bool formula = rest.starts_with("$");
    if (formula) rest.remove_prefix(1);
    std::size_t end = rest.find_first_not_of("0123456789");
    if (end == 0 && formula) end = 1;
    const bool number = end != 0 && (!formula || end >= rest.size() || rest[end] == '$');
    if (number || rest.starts_with("a prime")) return word.substr(0, word.size() - 1);
  }
  return {};
}

/// A sentence of a statement: "In floating-point arithmetic, …"
std::string_view machine_numbers_in(std::string_view sentence) {
  sentence.remove_prefix(std::min(sentence.find_first_not_of(" >*"), sentence.size()));
  const bool said = sentence.starts_with("in floating") || sentence.starts_with("with floating") ||
                    sentence.starts_with("for floating") || sentence.starts_with("in machine arithmetic");
  return said ? "floating point" : std::string_view{};
}

std::string_view arithmetic_in(std::string_view sentence) {
  for (const std::string_view words : other_arithmetics) {
    if (sentence.find(words) != std::string_view::npos) return words;
  }
  const std::string_view modulus = modulus_in(sentence);
  return modulus.empty() ? machine_numbers_in(sentence) : modulus;
}

// -- letters that are said to be matrices --

constexpr std::array<std::string_view, 22> ordered_nouns{
    "matrices",           "matrix",         "operators",
    "operator",           "observables",    "observable",
    "quaternions",        "quaternion",     "permutations",
    "permutation",        "transpositions", "automorphisms",
    "endomorphisms",      "automorphism",   "endomorphism",
    "reflections",        "generators",     "projectors",
    "projections",        "homomorphisms",  "elements of the group",
    "elements of a group"};

/// A formula of a line, and the words after it up to the next one.
struct Phrase {
  std::string_view formula;
  std::string words;
};

/// The letters of `$a, b \in G$` before a relation, with whether a subscript is there; nothing where it
/// is more than a list.
std::vector<std::pair<std::string, bool>> listed(std::string_view formula) {
  std::vector<std::pair<std::string, bool>> letters;
  for (std::size_t at = 0; at < formula.size();) {
    const char c = formula[at];
    if (c == ' ' || c == ',') {
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    if (c == '\\') {
      while (end < formula.size() && is_letter(formula[end])) ++end;
    }
    const std::string name(formula.substr(at, end - at));
    if (name == "\\in" || name == "\\colon" || c == ':' || c == '=') return letters;
    if (!is_letter(c) && !is_greek(name)) return {};
    const bool labelled = end < formula.size() && formula[end] == '_';
    if (labelled) {
      const bool braced = end + 1 < formula.size() && formula[end + 1] == '{';
      end = braced ? formula.find('}', end) : end + 1;
      if (end == std::string_view::npos) return {};
      ++end;
    }
    letters.emplace_back(name, labelled);
    at = end;
  }
  return letters;
}

void add(std::string_view formula, Evidence& evidence) {
  for (const auto& [letter, labelled] : listed(formula)) {
    evidence.ordered.insert(letter);
    if (labelled) evidence.labelled.insert(letter);
  }
}

bool joins(std::string_view words) {
  return words.size() <= 6 && words.find_first_not_of(" ,and") == std::string_view::npos;
}

/// "are two square matrices", "be observables", "being transpositions".
bool says_what_they_are(std::string_view words) {
  static constexpr std::array<std::string_view, 6> verbs{" are ",   " be ",     " is ",
                                                         " being ", " denote ", " as "};
  const auto noun = behind_any(words, ordered_nouns);
  if (noun == std::string_view::npos) return false;
  return std::ranges::any_of(verbs, [&](std::string_view verb) {
    const auto at = words.find(verb);
    return at < noun && at <= 6 && noun - at < 48;
  });
}

void see_named(std::string_view sentence, Evidence& evidence) {
  std::vector<Phrase> pieces{{{}, {}}};
  std::size_t from = 0;
  for (std::size_t open = sentence.find('$'); open != std::string_view::npos;) {
    const std::size_t close = sentence.find('$', open + 1);
    if (close == std::string_view::npos) break;
    pieces.back().words = lowered_line(sentence.substr(from, open - from));
    pieces.push_back({sentence.substr(open + 1, close - open - 1), {}});
    from = close + 1;
    open = sentence.find('$', from);
  }
  pieces.back().words = lowered_line(sentence.substr(from));
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    std::string_view words = pieces[k].words;
    while (!words.empty() && words.back() == ' ') words.remove_suffix(1);
    const bool leads =
        std::ranges::any_of(ordered_nouns, [&](std::string_view noun) { return words.ends_with(noun); });
    for (std::size_t next = k + 1; leads && next < pieces.size(); ++next) {
      add(pieces[next].formula, evidence);
      if (!joins(pieces[next].words)) break;
    }
    if (k == 0 || !says_what_they_are(pieces[k].words)) continue;
    for (std::size_t last = k;; --last) {
      add(pieces[last].formula, evidence);
      if (last < 2 || !joins(pieces[last - 1].words)) break;
    }
  }
}

}  // namespace

void see_said_order(std::string_view text, Evidence& evidence) {
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find(". ", begin);
    end = std::min({end, text.find(".\n", begin), text.find("\n\n", begin), text.size()});
    const std::string_view sentence = text.substr(begin, end - begin);
    const std::string lower = lowered_line(sentence);
    if (denies_commuting(lower) || speaks_of_group(lower)) evidence.order_in_heading = true;
    if (has_any(lower, std::array<std::string_view, 2>{"observable", "quantum mechanic"}))
      evidence.speaks_of_order = true;
    if (evidence.other_arithmetic.empty()) evidence.other_arithmetic = arithmetic_in(lower);
    see_named(sentence, evidence);
    begin = end + 2;
  }
}

}  // namespace rigor
