// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/words_behind.h"

#include <array>

#include "base/among.h"

namespace rigor {
namespace {}  // namespace

bool is_filler_behind(std::string_view word) {
  static constexpr std::array<std::string_view, 29> fillers{
      "always", "everywhere",     "identically", "throughout", "here",    "also",
      "again",  "immediately",    "finally",     "directly",   "clearly", "simply",
      "indeed", "trivially",      "too",         "now",        "easily",  "above",
      "below",  "simultaneously", "constant",    "constants",  "fixed",   "real",
      "finite", "given",          "numbers",     "integers",   "scalars"};
  return is_one_of(word, fillers);
}

bool opens_main_clause(std::string_view word) {
  static constexpr std::array<std::string_view, 15> opening{
      "so",   "then",  "thus", "hence", "therefore",   "consequently", "we", "it",
      "this", "these", "you",  "i",     "accordingly", "there",        "let"};
  return is_one_of(word, opening);
}

bool is_consequence(std::string_view word) {
  static constexpr std::array<std::string_view, 14> verbs{
      "gives", "give",    "yields",     "yield",    "leads",   "lead",  "follows",
      "turns", "reduces", "simplifies", "produces", "results", "shows", "brings"};
  return is_one_of(word, verbs);
}

bool is_main_verb(std::string_view word) {
  static constexpr std::array<std::string_view, 44> verbs{
      "is",        "are",     "was",     "were",     "be",     "reads",    "read",   "becomes", "become",
      "has",       "have",    "had",     "takes",    "take",   "vanishes", "vanish", "equals",  "equal",
      "satisfies", "satisfy", "obeys",   "obey",     "holds",  "hold",     "must",   "will",    "agree",
      "agrees",    "cancel",  "cancels", "simplify", "reduce", "remains",  "remain", "states",  "says",
      "implies",   "follow",  "assumes", "goes",     "drops",  "drop",     "means",  "finds"};
  return is_consequence(word) || is_one_of(word, verbs);
}

bool opens_noun_phrase(std::string_view word) {
  static constexpr std::array<std::string_view, 22> opening{
      "the",      "a",  "an",  "our",       "its",  "their",  "both", "all", "each", "every",      "one",
      "equation", "eq", "eqs", "equations", "that", "either", "any",  "two", "no",   "everything", "nothing"};
  return is_one_of(word, opening);
}

bool is_place_in_text(std::string_view word) {
  static constexpr std::array<std::string_view, 17> nouns{
      "equation",   "equations", "eq",          "eqs",       "expression", "formula",
      "result",     "relation",  "identity",    "sum",       "integral",   "integrand",
      "definition", "equality",  "expressions", "relations", "formulas"};
  return is_one_of(word, nouns);
}

bool points_into_text(std::string_view word) {
  static constexpr std::array<std::string_view, 13> pointing{"the",   "this",    "that",  "these",    "last",
                                                             "first", "second",  "above", "previous", "our",
                                                             "both",  "general", "last"};
  return is_one_of(word, pointing);
}

bool restricts_behind_comma(std::string_view word) {
  static constexpr std::array<std::string_view, 36> words{
      "at",        "on",          "inside",          "outside",   "within", "when",      "whenever", "while",
      "during",    "near",        "along",           "initially", "but",    "if",        "some",     "far",
      "until",     "till",        "after",           "before",    "up",     "down",      "locally",  "later",
      "elsewhere", "beyond",      "between",         "above",     "below",  "sometimes", "as",       "across",
      "around",    "momentarily", "instantaneously", "namely"};
  return is_one_of(word, words);
}

bool restricts_from_before(std::string_view word) {
  static constexpr std::array<std::string_view, 20> words{
      "from",   "until", "till",  "to",     "through", "starting", "beginning",
      "before", "after", "past",  "across", "between", "inside",   "outside",
      "some",   "most",  "start", "starts", "begins",  "ending"};
  return is_one_of(word, words);
}

bool is_named_quantity(std::string_view word) {
  static constexpr std::array<std::string_view, 68> nouns{
      "constants",   "numbers",      "parameters",   "coefficients", "integer",     "integers",
      "frequency",   "frequencies",  "period",       "wavelength",   "wavenumber",  "mass",
      "masses",      "energy",       "momentum",     "ratio",        "factor",      "parameter",
      "coefficient", "constant",     "speed",        "velocity",     "density",     "acceleration",
      "force",       "torque",       "charge",       "field",        "potential",   "current",
      "resistance",  "impedance",    "power",        "temperature",  "pressure",    "moment",
      "tensor",      "vector",       "operator",     "function",     "lagrangian",  "hamiltonian",
      "rate",        "viscosity",    "capacitance",  "inductance",   "modulus",     "stiffness",
      "flux",        "entropy",      "conductivity", "number",       "difference",  "sum",
      "product",     "mean",         "average",      "amplitude",    "lifetime",    "mobility",
      "diffusivity", "permittivity", "action",       "efficiency",   "combination", "combinations",
      "quantity",    "abbreviation"};
  return is_one_of(word, nouns);
}

bool is_measure(std::string_view word) {
  static constexpr std::array<std::string_view, 12> nouns{
      "distance", "radius",  "length", "angle",     "height",   "area",
      "volume",   "inertia", "work",   "intensity", "variable", "displacement"};
  return is_one_of(word, nouns);
}

bool is_doubt(std::string_view word) {
  static constexpr std::array<std::string_view, 23> doubts{
      "or",      "nor",       "either",    "neither",  "unless",        "iff",
      "except",  "excluding", "whereas",   "else",     "otherwise",     "possibly",
      "perhaps", "maybe",     "whether",   "only",     "alternatively", "respectively",
      "resp",    "vice",      "sometimes", "excluded", "whichever"};
  return is_one_of(word, doubts);
}

}  // namespace rigor
