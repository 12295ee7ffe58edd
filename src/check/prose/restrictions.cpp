// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/prose/restrictions.h"

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "base/among.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

using Found = std::optional<std::string>;
using List = std::initializer_list<std::string_view>;

struct ProseWord {
  std::string_view text;       // empty at a colon, a comma, a bracket or a display
  bool begins_clause = false;  // first, or after such a sign or "and", "then", "we"
};

/// A sentence, cut into words.
class Sentence {
 public:
  explicit Sentence(std::string_view text) {
    bool begins = true;
    for (std::size_t at = 0; at < text.size();) {
      const auto is_word = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '\'';
      };
      std::size_t end = at;
      while (end < text.size() && is_word(text[end])) ++end;
      if (end > at || text[at] == '$') {
        end = std::max(end, at + 1);
        words_.push_back({text.substr(at, end - at), begins});
        begins = is_one_of(words_.back().text, {"and", "then", "now", "but", "so", "also", "here", "that"});
      } else if (text[at] != ' ') {
        words_.push_back({{}, begins});
        begins = true;
      }
      at = std::max(end, at + 1);
    }
  }

  [[nodiscard]] std::size_t size() const { return words_.size(); }
  [[nodiscard]] std::string_view operator[](std::size_t at) const {
    return at < words_.size() ? words_[at].text : std::string_view{};
  }
  [[nodiscard]] std::string_view before(std::size_t at) const {
    return at > 0 ? (*this)[at - 1] : std::string_view{};
  }
  [[nodiscard]] bool begins_clause(std::size_t at) const { return words_[at].begins_clause; }
  /// One of these words among the next ones.
  [[nodiscard]] bool soon(std::size_t at, std::size_t within, List list) const {
    for (std::size_t k = at + 1; k <= at + within && k < words_.size(); ++k) {
      if (is_one_of(words_[k].text, list)) return true;
    }
    return false;
  }
  [[nodiscard]] Found two(std::size_t at) const {
    return std::string((*this)[at]) + " " + std::string((*this)[at + 1]);
  }
  [[nodiscard]] Found one(std::size_t at) const { return std::string((*this)[at]); }

 private:
  std::vector<ProseWord> words_;
};

bool is_article(std::string_view word) {
  return is_one_of(word, {"a",       "an",      "the",       "its",      "their",  "some",  "two",
                          "three",   "any",     "arbitrary", "our",      "this",   "that",  "total",
                          "kinetic", "angular", "linear",    "relative", "scalar", "vector"});
}

/// "massless", "divergence-free", "non-interacting", "antiperiodic", "isobaric", "linearised".
bool is_special_by_form(std::string_view word) {
  for (const std::string_view end :
       {"less", "-free", "-only", "-symmetric", "wise-constant", "-dimensional"}) {
    if (word.size() > end.size() + 1 && word.ends_with(end))
      return !is_one_of(word, {"unless", "nevertheless", "nonetheless", "regardless", "useless", "needless",
                               "dimensionless", "three-dimensional"});
  }
  for (const std::string_view begin : {"non-", "anti-", "quasi", "semi-", "incompress", "inextens", "irrot",
                                       "invisc", "isobar", "isochor", "isotherm", "isotrop", "homogen"}) {
    if (word.starts_with(begin)) return true;
  }
  for (const std::string_view stem : {"normali", "lineari", "diagonali", "symmetri", "polari", "speciali"}) {
    if (word.starts_with(stem) && (word.ends_with("ised") || word.ends_with("ized"))) return true;
  }
  return false;
}

/// An adjective that restricts, by its neighbours.
bool restricts_as_adjective(const Sentence& words, std::size_t at) {
  const std::string_view word = words[at];
  const std::string_view next = words[at + 1];
  if (is_special_by_form(word)) return true;
  if (is_one_of(word,
                {"conserved",    "slow",      "hard",       "soft",       "rarefied",      "traceless",
                 "solenoidal",   "diagonal",  "coplanar",   "coaxial",    "concentric",    "right-angled",
                 "equilateral",  "isosceles", "harmonic",   "periodic",   "monochromatic", "unpolarised",
                 "lossless",     "ground",    "critical",   "maximal",    "minimal",       "transversal",
                 "proportional", "congruent", "sinusoidal", "rectangular"}))
    return true;
  if (word == "equal") return next != "to" && !is_one_of(words.before(at), {"are", "is", "be", "not"});
  if (word == "unit")
    return !is_one_of(words.before(at), {"per", "imaginary"}) && !is_one_of(next, {"of", "matrix"});
  if (is_one_of(word, {"positive", "negative"})) return !is_one_of(next, {"sign", "root", "of"});
  if (is_one_of(word, {"real", "imaginary"}))
    return !is_one_of(next, {"part", "parts", "axis"}) && !(word == "imaginary" && next == "unit") &&
           !(word == "real" && words.soon(at, 4, {"matrix", "matrices"}));
  if (is_one_of(word, {"integer", "integers", "nonzero", "odd", "normalized", "normalised"})) return true;
  if (word == "same")  // "of the same mass", and not "the same vector"
    return is_one_of(
        next, {"mass",   "masses",    "charge",    "charges",   "length",    "lengths",     "radius",
               "radii",  "size",      "magnitude", "direction", "sign",      "temperature", "pressure",
               "volume", "density",   "speed",     "velocity",  "frequency", "amplitude",   "phase",
               "energy", "dimension", "number",    "value",     "values",    "particle",    "particles",
               "point",  "time",      "instant",   "place",     "plane"});
  return false;
}

/// "to leading order", "of second order"; not "in order to", nor "the order of the factors".
Found order_of_smallness(const Sentence& words, std::size_t at) {
  const std::string_view word = words[at];
  if (words[at + 1] == "of" && words.soon(at, 3,
                                          {"factors", "factor", "multiplication", "matrices", "letters",
                                           "operators", "operations", "indices"}))
    return std::nullopt;
  if (is_one_of(word, {"order", "orders"}) &&
      (is_one_of(words.before(at),
                 {"first", "second", "third", "fourth", "zeroth", "leading", "lowest", "next", "higher",
                  "linear", "quadratic", "this", "that", "same", "of", "$", "each"}) ||
       is_one_of(words[at + 1], {"of", "$"})) &&
      !(word == "order" && words.before(at) == "in"))
    return words.one(at);
  if (is_one_of(word,
                {"accuracy", "precision", "leading", "lowest", "approximately", "approximate",
                 "approximation", "estimate", "estimation", "roughly", "nearly", "almost", "about-equal"}))
    return words.one(at);
  return std::nullopt;
}

bool behind_in_is_neutral(const Sentence& words, std::size_t at) {
  if (words.soon(at, 2, {"dimension", "dimensions"})) return words[at + 1] == "three" || words[at + 1] == "3";
  const std::string_view next = words[at + 1];
  if (is_one_of(next,
                {"",           "as",        "front",    "without", "by",      "for",       "with",  "to",
                 "and",        "from",      "place",    "one",     "two",     "steps",     "pairs", "terms",
                 "components", "component", "form",     "fact",    "general", "turn",      "other", "detail",
                 "full",       "order",     "addition", "index",   "vector",  "cartesian", "what",  "which",
                 "this",       "that",      "these",    "matrix",  "words",   "symbols",   "our",   "any",
                 "all",        "every",     "each",     "it",      "cyclic",  "suffix",    "both",  "three",
                 "section",    "chapter",   "equation", "eq",      "brackets"}))
    return true;
  const bool article = is_one_of(next, {"the", "a", "an", "its", "their", "another"});
  return article &&
         words.soon(at + 1, 3,
                    {"form",     "frame",      "frames",      "way",       "ways",      "same",
                     "first",    "last",       "next",        "previous",  "following", "usual",
                     "integral", "integrand",  "sum",         "bracket",   "brackets",  "right",
                     "left",     "exponent",   "denominator", "numerator", "term",      "terms",
                     "notation", "literature", "text",        "system",    "equation",  "second",
                     "third",    "standard",   "other",       "middle",    "product",   "definition"});
}

Found by_preposition(const Sentence& words, std::size_t at) {
  const std::string_view word = words[at];
  const std::string_view next = words[at + 1];
  const bool begins = words.begins_clause(at);
  if (is_one_of(word, {"near",       "among",   "amongst",  "beyond",     "inside",   "outside",  "within",
                       "throughout", "during",  "along",    "whilst",     "iff",      "until",    "till",
                       "except",     "unless",  "if",       "when",       "whenever", "provided", "providing",
                       "whether",    "insofar", "wherever", "everywhere", "far"}))
    return words.one(at);
  if (word == "without") {  // "without friction", and not "without loss of generality"
    const bool of_the_writing =
        is_one_of(next, {"", "them", "it", "loss", "further", "proof", "calculation", "indices", "components",
                         "coordinates", "brackets", "words", "using", "writing"});
    return of_the_writing ? Found{} : words.two(at);
  }
  if (word == "far" && next == "as") return std::nullopt;
  if (word == "while") return begins && next != "the" ? words.one(at) : Found{};
  if (word == "where" &&
      (words[at + 1].empty() || !is_one_of(next, {"$", "the", "we", "a", "an", "in", "now"})))
    return words.one(at);
  if (word == "on" && begins && !is_one_of(next, {"the", "both", "this"})) return words.two(at);
  if (word == "on" && begins && next == "the" && !is_one_of(words[at + 2], {"left", "right", "other", "one"}))
    return words.two(at);
  if (word == "under" && !words.soon(at, 2, {"integral", "root", "sum", "sign", "brace"}))
    return words.one(at);
  if (word == "in" && !behind_in_is_neutral(words, at)) return words.two(at);
  if (word == "at") {
    if (words.before(at) == "arrive" || words.before(at) == "look" || words.before(at) == "arrives")
      return {};
    if (is_one_of(next, {"once", "last", "least", "time", "position", "each", "every", "any", "all", "$",
                         "hand", "most"}))
      return std::nullopt;
    const bool article = is_one_of(next, {"a", "an", "the", "this", "that"});
    if (article && is_one_of(words[at + 2], {"point", "end", "time", "position", "moment"}))
      return std::nullopt;
    return words.two(at);
  }
  if (word == "as") {
    if (is_one_of(words.before(at), {"long", "soon", "insofar"}) || (next == "$" && begins))
      return words.one(at);
    return std::nullopt;
  }
  if (word == "with" &&
      !is_one_of(next, {"respect", "the", "this", "that", "these", "it", "a", "an", "", "$", "our"})) {
    if (is_one_of(words.before(at),
                  {"begin", "start", "starting", "agrees", "agree", "together", "compared"}))
      return std::nullopt;
    return is_quantity(next) ? Found{} : words.two(at);
  }
  if (word == "given" && !is_one_of(next, {"by", "in", "above", "as", "below", "here", "earlier"}) &&
      !is_one_of(words.before(at), {"is", "are", "was", "be", "been", "as"}))
    return words.one(at);
  if (word == "for" && begins && next == "the") {
    for (std::size_t k = at + 2; k < at + 5 && k < words.size(); ++k) {
      if (is_quantity(words[k])) return std::nullopt;
    }
    return words.two(at);
  }
  if (word == "by" && next == "symmetry") return words.two(at);
  return std::nullopt;
}

/// "neglect", "choose", "we assume": the author chooses what holds from here.
Found by_choosing(const Sentence& words, std::size_t at) {
  const std::string_view word = words[at];
  const std::string_view before = words.before(at);
  if (is_one_of(word,
                {"neglecting",  "ignoring",  "omitting",     "discarding",   "disregarding", "dropping",
                 "keeping",     "retaining", "imposing",     "requiring",    "restricting",  "assuming",
                 "supposing",   "presuming", "specialising", "specializing", "truncating",   "linearising",
                 "linearizing", "neglected", "neglects",     "ignored",      "ignores",      "negligible",
                 "choosing",    "picking",   "negligibly",   "equating",     "approximating"}))
    return words.one(at);
  const bool chosen =
      words.begins_clause(at) || is_one_of(before, {"we", "us", "i", "can", "may", "will", "shall", "now"});
  if (chosen && is_one_of(word, {"neglect",  "ignore",    "omit",      "discard",     "disregard",
                                 "drop",     "keep",      "retain",    "impose",      "require",
                                 "restrict", "assume",    "suppose",   "specialise",  "specialize",
                                 "truncate", "linearise", "linearize", "choose",      "pick",
                                 "fix",      "orient",    "align",     "approximate", "equate"}))
    return words.one(at);
  return std::nullopt;
}

/// "let $\mathbf n$ be the normal", "$S$ is a symmetric matrix"; not "let $m$ be the mass of the body".
Found by_kind(const Sentence& words, std::size_t at) {
  if (!is_one_of(words[at], {"be", "is", "are", "denotes", "denote"})) return std::nullopt;
  if (words.before(at) != "$") return std::nullopt;
  std::size_t k = at + 1;
  const bool article = is_one_of(words[k], {"a", "an", "the", "its", "their"});
  if (!article) return std::nullopt;
  std::string_view head;
  for (; k < words.size() && !words[k].empty() && words[k] != "$"; ++k) {
    if (is_one_of(words[k], {"of", "in", "on", "at", "and", "with", "for", "that", "which", "to", "per",
                             "between", "from", "by", "about"}))
      break;
    head = words[k];
  }
  if (head.empty() || is_quantity(head) || is_article(head)) return std::nullopt;
  return std::string(head);
}

/// "no sum", "the sum is not implied", "indices run over 1, 2".
Found by_indices(const Sentence& words, std::size_t at) {
  const std::string_view word = words[at];
  const bool sums = is_one_of(word, {"sum", "summation", "summed", "summing"});
  if (sums && (is_one_of(words.before(at), {"no", "not", "without"}) || words.soon(at, 4, {"not", "no"})))
    return words.one(at);
  if (is_one_of(word, {"index", "indices", "subscripts", "subscript", "labels"}) &&
      words.soon(at, 4, {"run", "runs", "range", "ranges", "take", "takes", "goes", "go"}) &&
      !words.soon(at, 10, {"3", "three"}))
    return words.one(at);
  if (is_one_of(word, {"take", "takes", "taking", "has", "have", "with", "assume", "assumes", "only"}) &&
      words.soon(at, 4, {"value", "values"}) &&
      !words.soon(at, 4, {"all", "any", "every", "absolute", "mean"}))
    return words.two(at);
  return std::nullopt;
}

/// "is not the same as", "no two", "a common mistake".
Found by_denial(const Sentence& words, std::size_t at) {
  const std::string_view word = words[at];
  if (is_one_of(word, {"cannot", "never", "neither", "nor", "wrongly"})) return words.one(at);
  if (word == "not" && !is_one_of(words[at + 1], {"only", "surprising", "surprisingly", "difficult", "hard"}))
    return words.one(at);
  return std::nullopt;
}

/// "the fluid is incompressible", "the vectors are at right angles".
Found by_predicate(const Sentence& words, std::size_t at) {
  if (words.soon(at, 2, {"never", "not"})) return std::nullopt;
  if (!is_one_of(words[at], {"is", "are", "be", "remain", "remains", "stay", "stays", "was", "were"}))
    return {};
  for (std::size_t k = at + 1; k < words.size() && k <= at + 5; ++k) {
    if (words[k].empty() || is_one_of(words[k], {"of", "that", "which", "by"})) break;
    const bool noun_of_it =
        is_one_of(words[k], {"constant", "free", "case", "cases", "since", "because", "run"});
    if (noun_of_it && k > at + 1 && is_one_of(words[k - 1], {"a", "the", "in"})) break;
    if (is_special(words[k]) || restricts_as_adjective(words, k) || words[k] == "perpendicular")
      return words.one(k);
  }
  return std::nullopt;
}

Found by_direction(const Sentence& words, std::size_t at) {
  if (is_one_of(words[at], {"point", "points", "lie", "lies", "directed"}) &&
      words.soon(at, 2, {"along", "in", "on", "upwards", "downwards", "parallel", "to"}))
    return words.two(at);
  if (is_one_of(words[at], {"has", "have"}) && words.soon(at, 3, {"only", "no", "one"})) return words.two(at);
  return std::nullopt;
}

template <class... Rules>
Found first_of(const Sentence& words, Rules... rules) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    Found found;
    ((found = found ? found : rules(words, k)), ...);
    if (found) return found;
  }
  return std::nullopt;
}

Found as_adjective(const Sentence& words, std::size_t at) {
  return restricts_as_adjective(words, at) ? words.one(at) : Found{};
}

Found as_order(const Sentence& words, std::size_t at) {
  if (is_one_of(words[at], {"accuracy", "precision"})) return words.one(at);
  return order_of_smallness(words, at);
}

/// A choice that holds for what comes, whoever's letters it is about.
Found by_letters(const Sentence& words, std::size_t at) {
  if (auto found = by_kind(words, at)) return found;
  if (auto found = by_direction(words, at)) return found;
  if (words[at] == "denote" && words[at + 1] == "by") {
    for (std::size_t k = at + 2; k < words.size(); ++k) {
      if (is_special(words[k]) || restricts_as_adjective(words, k)) return words.one(k);
    }
  }
  const bool sets =
      words.begins_clause(at) && is_one_of(words[at], {"take", "set", "put"}) && words[at + 1] == "$";
  return sets ? words.one(at) : Found{};
}

}  // namespace

std::optional<std::string> restriction_in_sentence(std::string_view sentence) {
  return first_of(Sentence(sentence), by_preposition, by_choosing, by_kind, by_indices, by_denial,
                  as_adjective, as_order);
}

std::optional<std::string> restriction_above(std::string_view text, bool has_letters, bool shares) {
  const Sentence words(text);
  const bool of_a_display = text.find('\n') != std::string_view::npos;
  const bool from_here = text.find("throughout") != std::string_view::npos ||
                         text.find("henceforth") != std::string_view::npos ||
                         text.find("from now on") != std::string_view::npos ||
                         text.find("what follows") != std::string_view::npos ||
                         text.find("this section") != std::string_view::npos ||
                         text.find("this chapter") != std::string_view::npos;
  if (shares) {
    if (auto found = first_of(words, by_letters)) return found;
  }
  if (of_a_display && !from_here) return std::nullopt;
  if (auto found = first_of(words, by_choosing, by_indices, as_order)) return found;
  if (has_letters && !shares) return std::nullopt;
  return first_of(words, by_predicate, by_direction);
}

std::optional<std::string> restriction_behind(std::string_view text, bool has_letters, bool shares) {
  const Sentence words(text);
  if (auto found = restriction_above(text, has_letters, shares)) return found;
  const bool goes_on = is_one_of(words[0], {"this", "it", "here", "these", "both", "which", "that", "valid",
                                            "holds", "true", "only", "where", "of", "strictly", "note"}) ||
                       (words[0] == "the" && is_one_of(words[1], {"equation", "identity", "formula",
                                                                  "relation", "result", "last", "equality"}));
  if (!goes_on) return std::nullopt;
  return first_of(words, by_preposition, by_denial, as_adjective);
}

std::optional<std::string> restriction_in_heading(std::string_view heading) {
  const Sentence words(heading);
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string_view word = words[k];
    const std::string_view next = words[k + 1];
    const bool names_a_topic = is_one_of(word, {"positive", "negative"}) ||
                               (word == "unit" && is_one_of(next, {"vector", "vectors"}));
    if (!names_a_topic && restricts_as_adjective(words, k)) return words.one(k);
    if (is_one_of(word, {"near", "under", "within", "inside", "outside", "modulo", "weak", "weakly",
                         "negligible", "neglecting", "ignoring"}))
      return words.one(k);
    if (word == "along" && words.soon(k, 4, {"axis", "line", "wire", "direction", "$"})) return words.one(k);
    if (word == "without" && !is_one_of(next, {"the", "it", "them", ""})) return words.two(k);
    if (word == "at" && is_one_of(next, {"low", "high", "large", "small", "equilibrium", "rest"}))
      return words.two(k);
    if (word == "on" && words.begins_clause(k) && is_one_of(next, {"a", "the"})) return words.two(k);
    if (is_one_of(word, {"one", "two", "four", "1", "2", "4"}) &&
        is_one_of(next, {"dimension", "dimensions", "d"}))
      return words.two(k);
    if (auto found = order_of_smallness(words, k)) return found;
  }
  return std::nullopt;
}

}  // namespace rigor
