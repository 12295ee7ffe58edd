// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/diagnostic.h"

#include <array>

#include "base/check.h"

namespace rigor {
namespace {

using enum DiagnosticKind;
constexpr auto error = Severity::error;
constexpr auto not_understood = Severity::not_understood;
constexpr auto warning = Severity::warning;

constexpr auto table = std::to_array<DiagnosticInfo>({
    {unreadable_file, "unreadable-file", error, "a file is missing or cannot be read"},
    {invalid_utf8, "invalid-utf8", error, "the text is not UTF-8"},
    {read_as_latin1, "read-as-latin1", warning, "the text is not UTF-8, and is read as Latin-1"},
    {nul_byte, "nul-byte", error, "the text has a NUL byte"},
    {no_equations, "no-equations", warning, "the file has no displayed equation"},
    {no_relation, "no-relation", warning,
     "a displayed expression relates nothing, so there is nothing to decide"},

    {unbalanced, "unbalanced", error,
     "a brace, a bracket, an environment or a display is not closed or not opened"},
    {macro_recursion, "macro-recursion", error, "a macro expands for ever, or to more than is allowed"},
    {bad_macro, "bad-macro", warning, "a macro definition or call cannot be read"},
    {missing_input, "missing-input", error, "a file named by \\input is missing or cannot be read"},
    {input_outside, "input-outside", error, "a file named by \\input is outside the notes' folder"},
    {display_too_long, "display-too-long", not_understood, "a display is longer than is allowed"},
    {nesting_too_deep, "nesting-too-deep", not_understood, "groups are nested deeper than is allowed"},
    {bad_syntax, "bad-syntax", error,
     "an expression breaks off or has a sign in a place where it cannot stand"},
    {unsupported, "unsupported", not_understood, "a notation that is not read yet"},
    {passed_over, "passed-over", not_understood, "a word or sign that is not part of what was read"},

    {unknown_directive, "unknown-directive", error, "a directive starts with an unknown word"},
    {bad_directive, "bad-directive", error, "a directive's text cannot be read"},
    {unused_directive, "unused-directive", error, "nothing uses a directive"},
    {unknown_anchor, "unknown-anchor", error, "a sidecar names a place that the notes do not have"},
    {unknown_quantity, "unknown-quantity", error, "a quantity is asked for that the notes do not have"},

    {follows_from_nothing, "follows-from-nothing", Severity::undecided,
     "an equation is announced as a conclusion, and follows from nothing that stands above it"},
    {suspect, "suspect", Severity::suspect,
     "an equation does not follow, but one slip of the pen away stands one that does"},
    {ambiguous_reading, "ambiguous-reading", not_understood, "the notation allows two readings"},
    {free_index_mismatch, "free-index-mismatch", error, "the free indices of two sides or two terms differ"},
    {index_repeats, "index-repeats", error, "an index occurs more than twice in one term"},
    {index_clash, "index-clash", error, "an index is bound twice"},
    {rank_mismatch, "rank-mismatch", error, "a scalar, a vector or a tensor stands where another is needed"},
    {dimension_mismatch, "dimension-mismatch", error, "two sides or two terms have different dimensions"},
    {dimension_clash, "dimension-clash", error,
     "a symbol has another dimension than an earlier line gives it"},
    {dimension_doubt, "dimension-doubt", warning,
     "dimensions disagree, unless a unit is left out or the time is a number"},
    {bold_index, "bold-index", warning, "a bold symbol carries an index; it is read as the component"},
    {dotted_length, "dotted-length", warning,
     "a dot is on a length; it is read as the length of the vector's derivative"},
    {unsummed_index, "unsummed-index", warning, "an index occurs twice in a term and is read as not summed"},
    {index_rides, "index-rides", warning,
     "an index occurs three times in a term, once on a principal value; it is summed over the other two"},
    {unknown_change, "unknown-change", not_understood,
     "a quantity is differentiated, and nothing says whether it changes"},
    {no_real_value, "no-real-value", not_understood,
     "a root of what is negative for all values has no real value"},
    {circular_definition, "circular-definition", error, "a definition uses what it defines"},
    {redefinition, "redefinition", warning, "a symbol is defined a second time"},

    {two_meanings, "two-meanings", warning, "the same signs stand for two symbols"},
    {shared_letter, "shared-letter", warning,
     "one equation uses one letter for a number and, with indices, for a tensor"},
    {mixed_spelling, "mixed-spelling", warning, "one symbol is written with two different signs"},
    {plain_vector, "plain-vector", warning, "a vector is not set bold, unlike others"},
    {hidden_index, "hidden-index", warning, "a subscript that is read as a word ends in an index"},
    {idle_sum, "idle-sum", warning, "a sum is over an index that does not occur in it"},
    {near_name, "near-name", warning,
     "a name stands in one equation only, and differs by a slip from another one"},
    {repeated_side, "repeated-side", warning, "a step of a chain repeats its left side"},
    {mixed_frames, "mixed-frames", warning,
     "components along two sets of axes, or rates in two frames, are added"},
    {scalar_zero, "scalar-zero", warning, "a vector is set equal to the number 0", true},
    {mixed_parity, "mixed-parity", warning, "an axial quantity is set equal to a polar one", true},
    {unused_definition, "unused-definition", warning, "nothing uses a definition", true},

    {bad_toml, "bad-toml", error, "a body or scene file is not TOML, or a value in it is missing or wrong"},
    {unknown_key, "unknown-key", error, "a body or scene file has a key that is not known"},
    {wrong_unit, "wrong-unit", error, "a quantity's unit is not read, or measures something else"},
    {bad_body, "bad-body", error, "a sample body cannot exist"},
    {bad_mesh, "bad-mesh", error, "a mesh cannot be read, or encloses no body"},
    {bad_cloud, "bad-cloud", error, "a cloud of points cannot be read, or is not a body"},
    {bad_scene, "bad-scene", error, "a scene asks for what does not follow from it"},

    {refuted, "refuted", Severity::refuted, "the sides differ on an exact sample"},
    {undecided, "undecided", Severity::undecided, "neither a proof nor a counterexample was found"},
    {borrowed, "borrowed", Severity::undecided,
     "an equation fails only with what is said elsewhere, or may hold with it"},
    {restricted, "restricted", Severity::undecided, "words of its sentence may restrict an equation"},
    {hole, "hole", Severity::undecided, "a square stands for what is to be derived"},
    {zero_equals_zero, "zero-equals-zero", warning,
     "both sides vanish identically, so the step says nothing"},
    {no_sample, "no-sample", error, "no sample satisfies the assumptions"},
    {unexpected_verdict, "unexpected-verdict", error, "a step has another verdict than a directive expects"},
    {not_confirmed, "not-confirmed", error, "a refutation in a report is not confirmed by its sample"},
});

constexpr bool follows_enum() {
  for (std::size_t i = 0; i < table.size(); ++i)
    if (static_cast<std::size_t>(table[i].kind) != i) return false;
  return static_cast<std::size_t>(not_confirmed) + 1 == table.size();
}
static_assert(follows_enum(), "one entry for each kind, in the order of the enumeration");

}  // namespace

std::span<const DiagnosticInfo> diagnostic_table() { return table; }

const DiagnosticInfo& info(DiagnosticKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  RIGOR_CHECK(index < table.size(), index);
  return table[index];
}

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::refuted:
      return "refuted";
    case Severity::undecided:
      return "undecided";
    case Severity::not_understood:
      return "not understood";
    case Severity::warning:
      return "warning";
    case Severity::suspect:
      return "suspect";
  }
  return "error";
}

}  // namespace rigor
