// SPDX-License-Identifier: GPL-3.0-or-later
// What words do after a relation in a line, by closed lists.
#pragma once

#include <string_view>

namespace rigor {

/// "always", "immediately", "constant": they do not change what is said.
[[nodiscard]] bool is_filler_behind(std::string_view word);

/// The main clause begins: "so", "we find", "this becomes".
[[nodiscard]] bool opens_main_clause(std::string_view word);

/// "gives", "leads": the relation itself does so.
[[nodiscard]] bool is_consequence(std::string_view word);

/// The verbs of main clauses: "the square root is", "both terms vanish".
[[nodiscard]] bool is_main_verb(std::string_view word);

/// What a noun phrase begins with; a clause, if a verb comes up to the next sign.
[[nodiscard]] bool opens_noun_phrase(std::string_view word);

/// "in (3)", "into the equation": where the relation is put.
[[nodiscard]] bool is_place_in_text(std::string_view word);

/// "the", "this", "previous": which equation.
[[nodiscard]] bool points_into_text(std::string_view word);

/// After a comma they belong to what comes before it.
[[nodiscard]] bool restricts_behind_comma(std::string_view word);

/// Directly before the relation they make a beginning, an end or a bound of it.
[[nodiscard]] bool restricts_from_before(std::string_view word);

/// What a letter that is brought in can be, for all that is said. No position, angle or state: those name one
/// value among many.
[[nodiscard]] bool is_named_quantity(std::string_view word);
/// "the radius", "the inertia", which many things of one page have.
[[nodiscard]] bool is_measure(std::string_view word);

/// "or", "iff", "only": they choose, bound or doubt.
[[nodiscard]] bool is_doubt(std::string_view word);

}  // namespace rigor
