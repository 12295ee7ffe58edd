// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/prose_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "base/among.h"

namespace rigor {

using Words = std::vector<std::string_view>;

Words words_of(std::string_view text) {
  Words words;
  for (std::size_t at = 0; at < text.size();) {
    const auto is_word = [](char c) { return (c >= 'a' && c <= 'z') || c == '-' || c == '\''; };
    std::size_t end = at;
    while (end < text.size() && is_word(text[end])) ++end;
    if (end > at) {
      words.push_back(text.substr(at, end - at));
    } else if (text[at] == '$') {
      words.push_back(text.substr(at, 1));
    }
    at = std::max(end, at + 1);
  }
  return words;
}

namespace {

std::string_view word_at(const Words& words, std::size_t at) {
  return at < words.size() ? words[at] : std::string_view{};
}

}  // namespace

bool means_all(std::string_view word) {
  static constexpr std::array<std::string_view, 7> all{"all",       "any",     "every",  "each",
                                                       "arbitrary", "general", "generic"};
  return is_one_of(word, all);
}

bool is_general_noun(std::string_view word) {
  static constexpr std::array<std::string_view, 22> nouns{
      "vector",    "vectors", "tensor", "tensors", "scalar", "scalars", "matrix", "matrices",
      "particle",  "point",   "points", "body",    "bodies", "field",   "fields", "function",
      "functions", "numbers", "system", "rigid",   "pair",   "number"};
  return is_one_of(word, nouns);
}

bool is_quantity(std::string_view word) {
  static constexpr std::array<std::string_view, 90> quantities{
      "mass",          "masses",     "charge",      "charges",      "length",      "distance",
      "position",      "positions",  "velocity",    "velocities",   "speed",       "acceleration",
      "accelerations", "force",      "forces",      "torque",       "momentum",    "momenta",
      "energy",        "energies",   "work",        "power",        "time",        "rate",
      "rates",         "angle",      "radius",      "area",         "volume",      "density",
      "pressure",      "frequency",  "period",      "wavelength",   "potential",   "current",
      "voltage",       "resistance", "product",     "products",     "sum",         "difference",
      "square",        "derivative", "gradient",    "divergence",   "curl",        "magnitude",
      "component",     "components", "index",       "displacement", "coordinates", "coordinate",
      "frame",         "inertia",    "moment",      "moments",      "flux",        "variable",
      "variables",     "quantity",   "temperature", "entropy",      "heat",        "lagrangian",
      "hamiltonian",   "action",     "side",        "sides",        "equation",    "expression",
      "identity",      "height",     "depth",       "width",        "amplitude",   "phase",
      "impulse",       "stress",     "strain",      "trace",        "determinant", "inverse",
      "transpose",     "integral",   "field",       "fields",       "stiffness",   "viscosity"};
  return is_general_noun(word) || is_one_of(word, quantities);
}

namespace {

bool is_pointing(std::string_view word) {
  static constexpr std::array<std::string_view, 16> words{
      "the",         "this",       "that", "these", "those", "which", "example", "instance",
      "convenience", "simplicity", "us",   "it",    "its",   "our",   "later",   "brevity"};
  return is_one_of(word, words);
}

}  // namespace

bool is_special(std::string_view word) {
  static constexpr auto special = std::to_array<std::string_view>({"limit",
                                                                   "limiting",
                                                                   "special",
                                                                   "small",
                                                                   "large",
                                                                   "constant",
                                                                   "uniform",
                                                                   "steady",
                                                                   "static",
                                                                   "stationary",
                                                                   "neglect",
                                                                   "neglecting",
                                                                   "neglected",
                                                                   "negligible",
                                                                   "ignoring",
                                                                   "ideal",
                                                                   "plane",
                                                                   "planar",
                                                                   "acute",
                                                                   "obtuse",
                                                                   "symmetric",
                                                                   "antisymmetric",
                                                                   "isotropic",
                                                                   "homogeneous",
                                                                   "equilibrium",
                                                                   "vacuum",
                                                                   "orthogonal",
                                                                   "perpendicular",
                                                                   "parallel",
                                                                   "collinear",
                                                                   "approximately",
                                                                   "approximate",
                                                                   "approximation",
                                                                   "incompressible",
                                                                   "irrotational",
                                                                   "conservative",
                                                                   "commuting",
                                                                   "commute",
                                                                   "hermitian",
                                                                   "unitary",
                                                                   "dimensions",
                                                                   "dimension",
                                                                   "two-dimensional",
                                                                   "one-dimensional",
                                                                   "particular",
                                                                   "case",
                                                                   "circular",
                                                                   "spherical",
                                                                   "cylindrical",
                                                                   "axisymmetric",
                                                                   "degenerate",
                                                                   "identical",
                                                                   "plane-parallel",
                                                                   "cases",
                                                                   "only",
                                                                   "transverse",
                                                                   "longitudinal",
                                                                   "inviscid",
                                                                   "adiabatic",
                                                                   "isothermal",
                                                                   "isentropic",
                                                                   "massless",
                                                                   "fixed",
                                                                   "free",
                                                                   "non-relativistic",
                                                                   "nonrelativistic",
                                                                   "leading",
                                                                   "first-order",
                                                                   "second-order",
                                                                   "linearized",
                                                                   "linearised",
                                                                   "dropping",
                                                                   "dropped",
                                                                   "keeping",
                                                                   "angles",
                                                                   "close",
                                                                   "vanishing",
                                                                   "vanish",
                                                                   "vanishes",
                                                                   "modulo",
                                                                   "since",
                                                                   "because",
                                                                   "aligned",
                                                                   "antiparallel",
                                                                   "slowly",
                                                                   "weakly",
                                                                   "quasi-static",
                                                                   "nearly",
                                                                   "roughly",
                                                                   "binary",
                                                                   "hexadecimal",
                                                                   "octal",
                                                                   "mod",
                                                                   "boolean",
                                                                   "clock",
                                                                   "idempotent",
                                                                   "idempotents",
                                                                   "nilpotent",
                                                                   "indicator",
                                                                   "heaviside",
                                                                   "bernoulli",
                                                                   "grassmann",
                                                                   "clifford",
                                                                   "fermions",
                                                                   "dual",
                                                                   "infinitesimals",
                                                                   "spins",
                                                                   "ising",
                                                                   "surfaces",
                                                                   "run",
                                                                   "runs",
                                                                   "diagonal",
                                                                   "orthonormal",
                                                                   "summation",
                                                                   "estimation",
                                                                   "reflection",
                                                                   "uniaxial",
                                                                   "biaxial",
                                                                   "hydrostatic",
                                                                   "unidirectional",
                                                                   "one-sided",
                                                                   "isochoric",
                                                                   "isobaric",
                                                                   "polytropic",
                                                                   "barotropic",
                                                                   "hydrostatics",
                                                                   "coplanar",
                                                                   "inextensible",
                                                                   "unforced",
                                                                   "undamped",
                                                                   "overdamped",
                                                                   "underdamped",
                                                                   "unpolarised",
                                                                   "unpolarized",
                                                                   "monochromatic",
                                                                   "paraxial",
                                                                   "traceless"});
  return is_one_of(word, special);
}

namespace {

/// "for an acute angle", "for ideal gases"; not "for all", "for two vectors", "for the torque", "for $A$".
bool restricts_behind_for(const Words& words, std::size_t at) {
  std::string_view next = word_at(words, at + 1);
  if (next.empty() || means_all(next) || is_pointing(next) || next == "$") return false;
  if (next == "a" || next == "an" || next == "two" || next == "three") next = word_at(words, at + 2);
  if (next == "complex") return false;                                         // which letters are is read
  if (next == "other" && word_at(words, at + 2) == "variables") return false;  // it names no case
  return !is_general_noun(next) && !means_all(next) && next != "$";
}

}  // namespace

namespace {

constexpr std::array<std::string_view, 36> denying{
    "mistake",       "mistakes",     "mistaken",  "wrong",         "wrongly",     "incorrect",
    "incorrectly",   "false",        "falsely",   "untrue",        "believe",     "believes",
    "tempting",      "myth",         "beware",    "misconception", "fails",       "fail",
    "failed",        "disprove",     "disproves", "disproved",     "contradict",  "contradicts",
    "contradicting", "contradicted", "absurd",    "erroneous",     "erroneously", "invalid",
    "nonsense",      "naive",        "naively",   "misleading",    "refuted",     "refutes"};

/// "no longer true", "common error", "often write", "cannot hold", "not true".
std::optional<std::string> denial_of_two_words(const Words& words, std::size_t at) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 21> pairs{
      {{"not", "true"},       {"not", "correct"},    {"not", "right"},       {"not", "valid"},
       {"not", "hold"},       {"cannot", "hold"},    {"cannot", "be"},       {"never", "holds"},
       {"never", "true"},     {"longer", "true"},    {"longer", "holds"},    {"longer", "valid"},
       {"longer", "correct"}, {"longer", "hold"},    {"common", "error"},    {"often", "write"},
       {"often", "written"},  {"students", "write"}, {"beginners", "write"}, {"people", "write"},
       {"typical", "error"}}};
  const std::pair<std::string_view, std::string_view> here{words[at], word_at(words, at + 1)};
  if (!is_one_of(here, pairs)) return std::nullopt;
  return std::string(here.first) + " " + std::string(here.second);
}

/// "no mistake", "not wrong", "avoid mistakes"; "wrong to think", "a wrong sign".
bool denies_nothing(const Words& words, std::size_t at) {
  static constexpr std::array<std::string_view, 10> before{
      "no", "not", "nothing", "never", "avoid", "avoids", "avoiding", "without", "isn't", "hardly"};
  static constexpr std::array<std::string_view, 6> behind{"to",  "sign",      "signs",
                                                          "way", "direction", "answer"};
  return (at > 0 && is_one_of(words[at - 1], before)) ||
         (at > 1 && words[at - 1] == "a" && is_one_of(words[at - 2], before)) ||
         (words[at] != "tempting" && words[at] != "fails" && is_one_of(word_at(words, at + 1), behind));
}

}  // namespace

std::optional<std::string> word_that_denies(std::string_view text) {
  const Words words = words_of(text);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (is_one_of(words[k], denying) && !denies_nothing(words, k)) return std::string(words[k]);
    if (auto both = denial_of_two_words(words, k)) return both;
  }
  return std::nullopt;
}

std::optional<std::string> word_that_demands(std::string_view lead) {
  static constexpr std::array<std::string_view, 36> demanding{
      "if",        "when",      "whenever",   "suppose",  "supposing", "let",        "require",   "requires",
      "requiring", "condition", "conditions", "satisfy",  "satisfies", "satisfying", "satisfied", "solve",
      "solves",    "solving",   "solved",     "demand",   "demands",   "demanding",  "assume",    "assumes",
      "assuming",  "assumed",   "unless",     "provided", "impose",    "imposes",    "imposing",  "want",
      "wants",     "seek",      "seeks",      "seeking"};
  const Words words = words_of(lead);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] == "let" && word_at(words, k + 1) == "us") continue;
    if (is_one_of(words[k], demanding) || is_one_of(words[k], denying)) return std::string(words[k]);
    if (words[k] == "not" && word_at(words, k + 1) == "true") return "not true";
  }
  return std::nullopt;
}

namespace {

/// "The constant of a spring", "the free energy": what it is called, and no case.
bool is_part_of_a_name(const Words& words, std::size_t at) {
  static constexpr std::array<std::string_view, 9> free{"energy",     "energies",   "enthalpy",
                                                        "enthalpies", "index",      "indices",
                                                        "parameter",  "parameters", "variables"};
  const std::string_view next = word_at(words, at + 1);
  return (words[at] == "constant" && next == "of") || (words[at] == "free" && is_one_of(next, free));
}

}  // namespace

std::optional<std::string> word_of_a_special_case(std::string_view sentence) {
  const Words words = words_of(sentence);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (is_special(words[k]) && !is_part_of_a_name(words, k)) return std::string(words[k]);
    if (words[k] == "for" && restricts_behind_for(words, k))
      return "for " + std::string(word_at(words, k + 1));
    if (words[k] == "at" && word_at(words, k + 1) == "rest") return "at rest";
  }
  return std::nullopt;
}

std::optional<std::string> word_of_a_special_heading(std::string_view heading) {
  static constexpr std::array<std::string_view, 15> names_no_case{
      "constant", "free",  "dimensions", "dimension", "dropping", "dropped", "keeping", "only",
      "case",     "cases", "since",      "because",   "close",    "run",     "runs"};
  for (const std::string_view word : words_of(heading)) {
    if (is_special(word) && !is_one_of(word, names_no_case)) return std::string(word);
  }
  return std::nullopt;
}

std::optional<std::string> word_of_a_case(std::string_view sentence) {
  static constexpr std::array<std::string_view, 14> cases{"at",     "where", "with", "since",  "because",
                                                          "near",   "along", "slow", "fast",   "weak",
                                                          "strong", "thin",  "far",  "without"};
  if (auto word = word_of_a_special_case(sentence)) return word;
  const Words words = words_of(sentence);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (is_one_of(words[k], cases)) return std::string(words[k]);
    if (words[k] == "for" && !means_all(word_at(words, k + 1))) return "for";
  }
  return std::nullopt;
}

namespace {

constexpr std::array<std::string_view, 34> announcing{
    "therefore", "hence",  "so",       "thus",      "follows",   "find",       "finds",
    "gives",     "give",   "giving",   "yields",    "yield",     "obtain",     "obtains",
    "get",       "gets",   "becomes",  "become",    "implies",   "imply",      "consequently",
    "then",      "equals", "equal",    "conclude",  "rewritten", "simplifies", "reduces",
    "shows",     "means",  "expanded", "expanding", "ie",        "accordingly"};

/// "A population with the rate $r$ follows": the display is what it obeys. "From this the motion follows" and
/// "the current follows" conclude.
bool obeys(const Words& words, std::size_t k) {
  static constexpr auto things = std::to_array<std::string_view>(
      {"population", "populations", "system", "particle", "particles", "body", "motion", "oscillator",
       "dynamics", "evolution", "process", "planet", "nuclei", "growth", "decay"});
  if (words[k] != "follows" && words[k] != "follow") return false;
  const auto before = std::span(words).first(k);
  return std::ranges::any_of(before, [](std::string_view word) { return is_one_of(word, things); }) &&
         std::ranges::none_of(before, [](std::string_view word) {
           return is_one_of(word, {"from", "it", "this", "which", "what", "now", "then", "as"});
         });
}

/// "The first law becomes", "Newton's second law gives": what is written down is the law.
bool states_a_law(const Words& words, std::size_t k) {
  return obeys(words, k) ||
         (k > 0 && words[k - 1] == "law" && is_one_of(words[k], {"becomes", "gives", "yields"}));
}

}  // namespace

bool announces_a_conclusion(std::string_view lead) {
  const Words words = words_of(lead);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (states_a_law(words, k)) continue;
    if (is_one_of(words[k], announcing)) return true;
    if (words[k] == "that" && word_at(words, k + 1) == "is") return true;
    if (words[k] == "i" && word_at(words, k + 1) == "e") return true;
  }
  return false;
}

std::optional<std::string> word_that_concludes(std::string_view lead) {
  static constexpr std::array<std::string_view, 12> concluding{
      "therefore", "hence",    "thus",   "follows", "consequently", "accordingly",
      "implies",   "conclude", "obtain", "obtains", "becomes",      "reduces"};
  static constexpr std::array<std::string_view, 6> of_degree{"far",   "called", "small",
                                                             "large", "long",   "much"};
  static constexpr std::array<std::string_view, 4> pointing{"which", "this", "that", "it"};
  const Words words = words_of(lead);
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (states_a_law(words, k)) continue;
    if (is_one_of(words[k], concluding)) return std::string(words[k]);
    if (words[k] == "so" && !is_one_of(word_at(words, k + 1), of_degree)) return "so";
    if (words[k] == "we" && word_at(words, k + 1) == "find") return "we find";
    const std::string_view next = word_at(words, k + 1);
    if ((next == "gives" || next == "yields") && is_one_of(words[k], pointing))
      return fmt::format("{} {}", words[k], next);
  }
  return std::nullopt;
}

bool goes_on_with_the_argument(std::string_view clause) {
  static constexpr auto first = std::to_array<std::string_view>(
      {"hence", "thus", "therefore", "consequently", "accordingly", "so", "then", "it", "taking",
       "differentiating", "integrating", "squaring", "multiplying", "dividing"});
  static constexpr auto more = std::to_array<std::string_view>(
      {"follows",    "that",     "we",         "find", "get",  "obtain", "have", "the",   "a",     "curl",
       "divergence", "gradient", "derivative", "rate", "time", "trace",  "both", "sides", "twice", "again",
       "this",       "gives",    "yields",     "of",   "by",   "and",    "once", "more",  "also"});
  const Words words = words_of(clause);
  return is_one_of(word_at(words, 0), first) &&
         std::ranges::all_of(words.begin() + 1, words.end(),
                             [](auto word) { return is_one_of(word, first) || is_one_of(word, more); });
}

namespace {

/// "Taking the flow to be compressible", "Let the gas be diatomic", "If instead"; not "Let the flow also be
/// steady".
bool supposes_something_else(const Words& words) {
  static constexpr std::array<std::string_view, 9> supposing{
      "taking", "assuming", "supposing", "treating", "suppose", "assume", "imagine", "let", "letting"};
  static constexpr std::array<std::string_view, 5> being{"be", "is", "are", "were", "being"};
  static constexpr std::array<std::string_view, 6> more{"also",    "further", "moreover",
                                                        "besides", "again",   "still"};
  static constexpr std::array<std::string_view, 6> turning{"instead",  "conversely", "otherwise",
                                                           "contrast", "contrary",   "unlike"};
  const auto has = [&](const auto& list) {
    return std::ranges::any_of(words, [&](std::string_view word) { return is_one_of(word, list); });
  };
  if (has(turning)) return true;
  return !words.empty() && is_one_of(words[0], supposing) && has(being) && !has(more);
}

}  // namespace

bool begins_a_case(std::string_view clause) {
  static constexpr auto first =
      std::to_array<std::string_view>({"for", "in", "at", "on", "inside", "outside", "within", "between",
                                       "above", "below", "near", "far", "off", "without", "before", "after"});
  static constexpr auto pointing = std::to_array<std::string_view>(
      {"particular", "components", "simplicity",  "squaring", "general",  "this", "that",
       "these",      "those",      "terms",       "other",    "addition", "fact", "order",
       "what",       "which",      "convenience", "brevity",  "words",    "we"});
  const Words words = words_of(clause);
  return supposes_something_else(words) || (words.size() > 1 && is_one_of(words[0], first) &&
                                            !is_one_of(words[1], pointing) && !means_all(words[1]));
}

bool names_another_thing(std::string_view lead) {
  const auto display = lead.rfind('\n');
  const auto comma = lead.rfind(',');
  const std::size_t begin = std::max(display == std::string_view::npos ? 0 : display + 1,
                                     comma == std::string_view::npos ? 0 : comma + 1);
  const Words words = words_of(lead.substr(begin));
  if (words.size() < 3) return false;
  return is_one_of(words[0], {"while", "whereas", "but"}) ||
         (words[0] == "and" && is_one_of(words[1], {"a", "an", "another"}));
}

bool has_own_words(std::string_view lead) {
  static constexpr std::array<std::string_view, 66> pointing{"we",
                                                             "this",
                                                             "it",
                                                             "which",
                                                             "that",
                                                             "now",
                                                             "finally",
                                                             "and",
                                                             "is",
                                                             "are",
                                                             "be",
                                                             "can",
                                                             "to",
                                                             "the",
                                                             "from",
                                                             "by",
                                                             "of",
                                                             "in",
                                                             "as",
                                                             "result",
                                                             "results",
                                                             "equation",
                                                             "equations",
                                                             "expression",
                                                             "these",
                                                             "those",
                                                             "two",
                                                             "both",
                                                             "us",
                                                             "one",
                                                             "have",
                                                             "has",
                                                             "e",
                                                             "i",
                                                             "$",
                                                             "combining",
                                                             "inserting",
                                                             "substituting",
                                                             "substitution",
                                                             "using",
                                                             "simplifying",
                                                             "rearranging",
                                                             "rearranged",
                                                             "solving",
                                                             "dividing",
                                                             "multiplying",
                                                             "integrating",
                                                             "differentiating",
                                                             "adding",
                                                             "subtracting",
                                                             "putting",
                                                             "together",
                                                             "above",
                                                             "at",
                                                             "once",
                                                             "immediately",
                                                             "also",
                                                             "just",
                                                             "written",
                                                             "write",
                                                             "into",
                                                             "because",
                                                             "since",
                                                             "must",
                                                             "directly",
                                                             "definition"};
  return std::ranges::any_of(words_of(lead), [&](std::string_view word) {
    return !is_one_of(word, announcing) && !is_one_of(word, pointing);
  });
}

bool speaks_of_self_adjoint_operators(std::string_view sentence) {
  const std::string text = lowered(sentence);
  const std::vector<std::string_view> words = words_of(text);
  const bool doubts = std::ranges::any_of(words, [](std::string_view word) {
    return is_one_of(word, {"not", "no", "non-hermitian", "if", "unless", "whether", "or", "one"});
  });
  if (doubts) return false;
  for (std::size_t k = 0; k + 1 < words.size(); ++k) {
    const bool adjective = words[k] == "hermitian" || words[k] == "self-adjoint";
    if (adjective && is_one_of(words[k + 1], {"operators", "matrices", "observables"})) return true;
  }
  return false;
}

}  // namespace rigor
