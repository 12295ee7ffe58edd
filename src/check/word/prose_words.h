// SPDX-License-Identifier: GPL-3.0-or-later
// What the words of its sentence do to the equations of a display. The lists are closed, and are in
// docs/notation.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// The words of a sentence in small letters, with `$` for mathematics in a line.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view text);
/// "perpendicular", "uniform", "negligible": an adjective of a special case.
[[nodiscard]] bool is_special(std::string_view word);
/// "vector", "field", "particle": what every identity is about, so that it restricts nothing.
[[nodiscard]] bool is_general_noun(std::string_view word);
/// "mass", "velocity", "product": what a letter can be without being restricted.
[[nodiscard]] bool is_quantity(std::string_view word);
/// "all", "any", "arbitrary".
[[nodiscard]] bool means_all(std::string_view word);

/// "if", "suppose", "let", "require", "solve" …: what follows is no claim. The first such word.
[[nodiscard]] std::optional<std::string> word_that_demands(std::string_view lead);
/// "wrong", "incorrect", "a common error", "often write", "contradicts": what is there is said not to
/// hold. Not "it is wrong to think", "no mistake". The first such word.
[[nodiscard]] std::optional<std::string> word_that_denies(std::string_view words);
/// "plane", "acute", "constant", "for a sphere": a case that even an equation without definitions may be
/// about.
[[nodiscard]] std::optional<std::string> word_of_a_special_case(std::string_view sentence);
/// "Incompressible flow", "Orthogonal vectors": a heading that names a case.
[[nodiscard]] std::optional<std::string> word_of_a_special_heading(std::string_view heading);
/// A special case, and "for", "at", "with", "since", "where": what was said elsewhere may not hold as it
/// stands.
[[nodiscard]] std::optional<std::string> word_of_a_case(std::string_view sentence);
/// "for two Hermitian operators"; not "anti-Hermitian", and not "is no longer Hermitian".
[[nodiscard]] bool speaks_of_self_adjoint_operators(std::string_view sentence);
/// "therefore", "hence", "we find", "gives", "i.e.": what follows is concluded.
[[nodiscard]] bool announces_a_conclusion(std::string_view lead);
/// "therefore", "hence", "so", "which gives": only words that claim that it follows. "Then" and "is equal to"
/// also bring in what is merely stated. The first such words.
[[nodiscard]] std::optional<std::string> word_that_concludes(std::string_view lead);
/// "Hence", "It follows that", "Taking the curl", and no other words: what begins so goes on with the case of
/// the paragraph before.
[[nodiscard]] bool goes_on_with_the_argument(std::string_view clause);
/// "For a diatomic gas", "In matter", "At the bottom": what begins so is about another case than what is
/// before.
[[nodiscard]] bool begins_a_case(std::string_view clause);
/// "while a thrown ball has", "and a gas of molecules has": the words since the last display speak of
/// something else than those before.
[[nodiscard]] bool names_another_thing(std::string_view lead);
[[nodiscard]] inline bool says_that_it_follows(std::string_view lead) {
  return word_that_concludes(lead).has_value();
}
/// Does it name anything of its own, as "going down, so" and "the plate then gives" do, and "this gives" and
/// "we therefore find" do not?
[[nodiscard]] bool has_own_words(std::string_view lead);

}  // namespace rigor
