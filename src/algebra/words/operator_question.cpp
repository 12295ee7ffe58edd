// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/words/operator_question.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "algebra/engine/budget.h"
#include "algebra/engine/undecidable.h"
#include "algebra/words/matrix_parts.h"
#include "algebra/words/state_words.h"
#include "algebra/words/word_reader.h"
#include "algebra/words/word_rules.h"
#include "expr/tree/state.h"

namespace rigor {
namespace {

[[nodiscard]] bool any_reaches_operators(const Question& question, const std::vector<ExprId>& roots) {
  const auto body_of = [&](SymbolId symbol) {
    const Definition* definition = definition_in(question, symbol);
    return definition == nullptr ? std::nullopt : std::optional(definition->body);
  };
  return std::ranges::any_of(symbols_reached(*question.tree, roots, body_of),
                             [&](SymbolId symbol) { return question.tree->symbols[symbol].noncommuting; });
}

[[nodiscard]] bool speaks_of_operators(const Question& question, const Equation& equation) {
  return any_reaches_operators(question, {equation.left, equation.right});
}

/// The same about a copy of its tree, which grows.
struct OwnQuestion {
  explicit OwnQuestion(const Question& asked)
      : tree(std::make_unique<ExprTree>(*asked.tree)), question(asked), parts(*tree) {
    question.tree = tree.get();
  }
  std::unique_ptr<ExprTree> tree;
  Question question;
  CommutingParts parts;
  LawsOfStates laws_of_states;
  LawsOfStates open_laws_of_states;  // that are no rules yet
};

/// Calls `visit` with left − right for all values of the free indices, component by component.
template <typename Visit>
void for_each_difference(OwnQuestion& own, WordReader& reader, const Equation& equation, const Visit& visit) {
  if (!equation.particles.empty()) throw Undecidable("operators of several particles are not decided");
  std::vector<AxesOfIndices> all{{}};
  for (const IndexId index : equation.indices) {
    std::vector<AxesOfIndices> more;
    for (const AxesOfIndices& axes : all) {
      for (std::uint8_t axis = 1; axis <= own.tree->space(index).dimension; ++axis) {
        more.push_back(axes);
        more.back()[index] = axis;
      }
    }
    all = std::move(more);
    if (all.size() > 81) throw Undecidable("so many free indices beside operators are not decided");
  }
  for (const AxesOfIndices& axes : all) {
    std::vector<WordSum> left = reader.read(equation.left, axes);
    const std::vector<WordSum> right = reader.read(equation.right, axes);
    if (left.size() != right.size()) throw Undecidable("its sides have different numbers of components");
    for (std::size_t k = 0; k < left.size(); ++k) {
      add_to(left[k], opposite(right[k]));
      visit(std::move(left[k]));
    }
  }
}

/// Laws of numbers that are made of matrices, `x^Tx = 1`: each vanishes, and by which assumption.
using NumberLaws = std::vector<std::pair<ExprId, std::size_t>>;

/// `xy = 1` of square matrices is `yx = 1` as well. Nothing: the law is another one.
[[nodiscard]] std::optional<WordSum> turned_inverse(const WordSum& zero, const WordReader& reader) {
  const Word& word = std::prev(zero.end())->first;
  const bool fits =
      zero.size() == 2 && zero.begin()->first.empty() && word.size() == 2 &&
      std::ranges::all_of(word, [&](const Letter& each) { return reader.is_square(each.symbol); });
  if (!fits) return std::nullopt;
  WordSum turned{{Word{word[1], word[0]}, std::prev(zero.end())->second}};
  add_to(turned, {*zero.begin()});
  return turned;
}

/// What is equal has equal adjoints and transposes, so each law gives more rules.
void add_law(WordSum zero, const Positions& by, const WordReader& reader, OwnQuestion& own,
             WordRules& rules) {
  std::vector<WordSum> laws{std::move(zero)};
  if (const auto turned = laws[0].empty() ? std::nullopt : turned_inverse(laws[0], reader))
    laws.push_back(*turned);
  const std::size_t count = laws.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (reader.has_adjoints()) laws.push_back(adjoint(laws[k], own.parts));
    if (reader.has_transposes()) laws.push_back(transpose(laws[k]));
  }
  for (WordSum& law : laws) rules.add(std::move(law), by);
}

/// `QP - PQ = i\hbar`: its words have no trace together, and 1 has one.
[[nodiscard]] bool is_beyond_matrices(const WordSum& zero, CommutingParts& parts) {
  if (zero.empty() || !zero.begin()->first.empty()) return false;
  WordSum words = zero;
  words.erase(Word{});
  try {
    return !words.empty() && trace_of(words, {}, parts).empty();
  } catch (const Undecidable&) {
    return false;
  }
}

/// Forbids traces where a law is beyond matrices.
void see_laws_of_traces(OwnQuestion& own, WordReader& reader, const Positions& laws) {
  reader.read_laws(true);
  for (const std::size_t which : laws) {
    try {
      for_each_difference(own, reader, own.question.assumptions[which], [&](const WordSum& zero) {
        if (is_beyond_matrices(zero, own.parts)) reader.forbid_traces();
      });
    } catch (const Undecidable&) {
      // what cannot be read says nothing
    }
  }
}

/// Of `Q^TQ = 1` of square matrices: det Q^TQ = 1.
void add_determinants(const WordSum& zero, std::size_t which, const WordReader& reader, OwnQuestion& own,
                      NumberLaws& numbers) {
  const Coefficient one = rational({1, 1});
  const Coefficient minus = rational({-1, 1});
  if (!reader.has_determinants() || zero.size() != 2) return;
  const auto& [first, before] = *zero.begin();
  const auto& [last, behind] = *std::prev(zero.end());
  const bool fits = (before == one && behind == minus) || (before == minus && behind == one);
  if (!fits) return;
  try {
    Coefficient difference = determinant_of({{first, one}}, reader.squares(), {}, own.parts);
    const Coefficient other = determinant_of({{last, one}}, reader.squares(), {}, own.parts);
    add_to(difference, times(minus, other));
    const Span span = (*own.tree)[own.question.claim.left].span;
    numbers.emplace_back(as_expression(difference, own.parts, span), which);
  } catch (const Undecidable&) {
    // a matrix of the law may not be square
  }
}

/// False: it is no rule yet.
[[nodiscard]] bool becomes_rule(OwnQuestion& own, const WordSum& zero, std::size_t which,
                                const WordReader& reader, WordRules& rules) {
  try {
    add_law(zero, {which}, reader, own, rules);
    return true;
  } catch (const Contradiction&) {
    throw;
  } catch (const Undecidable&) {
    return false;
  }
}

/// What could be no rule, when the others are there; else as a law of numbers.
void add_open_laws_of_states(OwnQuestion& own, const WordReader& reader, WordRules& rules,
                             NumberLaws* numbers) {
  for (const auto& [zero, which] : own.open_laws_of_states) {
    if (becomes_rule(own, zero, which, reader, rules)) continue;
    Positions used;
    const WordSum outside = with_brackets_out(zero, own.parts, nullptr, used);
    const bool number = outside.size() == 1 && outside.begin()->first.empty();
    if (!number && numbers == nullptr)
      throw Undecidable("a law for its states has a factor that may be zero");
    if (!number || numbers == nullptr) continue;
    const Span span = (*own.tree)[own.question.claim.left].span;
    numbers->emplace_back(as_expression(outside.begin()->second, own.parts, span), which);
  }
  own.open_laws_of_states.clear();
}

/// A law for `|n\rangle` is one for `|n + 1\rangle` and `|0\rangle`, where these are asked about.
void add_laws_of_other_states(OwnQuestion& own, WordReader& reader, WordRules& rules) {
  if (own.laws_of_states.empty()) return;
  const auto read = [&](ExprId id) { return reader.read(id, {}).front(); };
  const Question& asked = own.question;
  std::vector<ExprId> roots{asked.claim.left, asked.claim.right};
  for (const Definition& each : asked.definitions) roots.push_back(each.body);
  for (const auto& [zero, which] : laws_of_other_states(own.laws_of_states, roots, own.parts, read)) {
    try {
      add_law(zero, {which}, reader, own, rules);
    } catch (const Contradiction&) {
      throw;
    } catch (const Undecidable&) {
      return;
    }
  }
}

void add_rule(OwnQuestion& own, WordReader& reader, std::size_t which, WordRules& rules,
              NumberLaws* numbers) {
  reader.read_laws(true);
  for_each_difference(own, reader, own.question.assumptions[which], [&](const WordSum& difference) {
    WordSum zero = with_numbers_out(difference, own.parts);
    if (holds_kets(zero, *own.tree)) {
      own.laws_of_states.emplace_back(zero, which);
      rules.see_numbers(own.parts);
      if (!becomes_rule(own, zero, which, reader, rules)) own.open_laws_of_states.emplace_back(zero, which);
      return;
    }
    const bool number = zero.size() == 1 && zero.begin()->first.empty();
    if (number && numbers != nullptr) {
      const Span span = (*own.tree)[own.question.claim.left].span;
      numbers->emplace_back(as_expression(zero.begin()->second, own.parts, span), which);
      return;
    }
    if (reader.has_traces() && is_beyond_matrices(zero, own.parts)) reader.forbid_traces();
    if (numbers != nullptr) add_determinants(zero, which, reader, own, *numbers);
    add_law(std::move(zero), {which}, reader, own, rules);
  });
}

void add_rules(OwnQuestion& own, WordReader& reader, const Positions& assumptions, WordRules& rules) {
  for (const std::size_t which : assumptions) add_rule(own, reader, which, rules, nullptr);
  add_laws_of_other_states(own, reader, rules);
  add_open_laws_of_states(own, reader, rules, nullptr);
}

/// Without those that are no rules, such as `e^{i\hat p}\hat x = …`: fewer laws prove less.
void add_rules_that_can_be_read(OwnQuestion& own, WordReader& reader, const Positions& assumptions,
                                WordRules& rules, NumberLaws& numbers) {
  for (const std::size_t which : assumptions) {
    try {
      add_rule(own, reader, which, rules, &numbers);
    } catch (const Contradiction&) {
      throw;
    } catch (const Undecidable&) {
    }
  }
  add_laws_of_other_states(own, reader, rules);
  add_open_laws_of_states(own, reader, rules, &numbers);
}

/// What was added before it did not end follows from the laws all the same. Laws for many numbers of states
/// lead to ever more of them.
void complete_as_far_as_possible(const OwnQuestion& own, WordRules& rules) {
  constexpr std::size_t many = 24;
  if (!own.laws_of_states.empty() && rules.rules().size() > many) return;
  try {
    rules.complete();
  } catch (const Contradiction&) {
    throw;
  } catch (const Undecidable&) {
  }
}

/// So that nothing contradicts: to the end, or with letters of which nothing is said made to commute. Laws of
/// states lead to further ones for each n; that none of the first contradicts is all that is asked.
void complete_to_the_end(const OwnQuestion& own, WordRules& rules) {
  if (!own.laws_of_states.empty()) return complete_as_far_as_possible(own, rules);
  static_cast<void>(rules.commute_the_rest());
  rules.complete();
}

/// The differences of the sides in a normal form. Inverses that are read on the way add rules.
[[nodiscard]] std::vector<WordSum> normal_differences(OwnQuestion& own, WordReader& reader,
                                                      const Equation& equation, WordRules& rules,
                                                      Positions& used) {
  reader.read_laws(false);
  for_each_difference(own, reader, equation, [](const WordSum&) {});
  for (const WordSum& inverse : reader.inverses()) add_law(inverse, {}, reader, own, rules);
  if (!reader.inverses().empty()) complete_as_far_as_possible(own, rules);
  reader.reduce_by(&rules);
  std::vector<WordSum> all;
  for_each_difference(own, reader, equation, [&](WordSum difference) {
    WordSum normal = with_numbers_out(rules.reduce(std::move(difference), used), own.parts);
    if (holds_kets(normal, *own.tree)) {
      normal = with_brackets_out(normal, own.parts, &rules, used);
      normal = with_brackets_out(rules.reduce(std::move(normal), used), own.parts, &rules, used);
    }
    all.push_back(std::move(normal));
  });
  reader.reduce_by(nullptr);
  used.insert(reader.used().begin(), reader.used().end());
  return all;
}

/// The equations between operators, and all else that is assumed.
struct SortedAssumptions {
  Positions of_operators;
  std::vector<std::size_t> of_numbers;
  bool others = false;  // orders, and what is not 0, of operators
};

[[nodiscard]] SortedAssumptions sorted_assumptions(const Question& question) {
  SortedAssumptions sorted;
  for (std::size_t k = 0; k < question.assumptions.size(); ++k) {
    if (!speaks_of_operators(question, question.assumptions[k])) {
      sorted.of_numbers.push_back(k);
    } else if (question.assumptions[k].relation == Relation::equal) {
      sorted.of_operators.insert(k);
    } else {
      sorted.others = true;
    }
  }
  return sorted;
}

/// What is said of numbers only.
[[nodiscard]] Question about_numbers(const OwnQuestion& own, const SortedAssumptions& sorted) {
  Question numbers;
  numbers.tree = own.tree.get();
  for (const std::size_t which : sorted.of_numbers)
    numbers.assumptions.push_back(own.question.assumptions[which]);
  for (const Definition& each : own.question.definitions) {
    if (!own.tree->symbols[each.symbol].noncommuting && !any_reaches_operators(own.question, {each.body}))
      numbers.definitions.push_back(each);
  }
  for (const SymbolId symbol : own.question.zeroed) {
    if (!own.tree->symbols[symbol].noncommuting) numbers.zeroed.push_back(symbol);
  }
  return numbers;
}

struct WordProof {
  std::set<SymbolId> unfolded;
  Positions assumptions;
  bool vanishes = true;  // each side by itself
};

/// One way to look for a proof. Nothing: the sides differ, as far as it knows.
class WordAttempt {
 public:
  WordAttempt(OwnQuestion& own, const SortedAssumptions& sorted, const Limits& limits,
              const DecideNumbers& decide)
      : own_(own), sorted_(sorted), limits_(limits), decide_(decide) {}

  [[nodiscard]] std::optional<WordProof> run(Unfolding unfolding, bool by_laws) {
    WordReader reader(own_.question, own_.parts, unfolding, *limits_.budget);
    WordRules rules(*limits_.budget);
    numbers_.clear();
    if (by_laws) {
      add_rules_that_can_be_read(own_, reader, sorted_.of_operators, rules, numbers_);
      complete_as_far_as_possible(own_, rules);
    }
    if (!by_laws && reader.has_traces()) see_laws_of_traces(own_, reader, sorted_.of_operators);
    WordProof proof;
    for (const WordSum& difference :
         normal_differences(own_, reader, own_.question.claim, rules, proof.assumptions)) {
      for (const auto& [word, coefficient] : difference) {
        if (!vanishes(coefficient, proof)) return std::nullopt;
      }
    }
    Equation left_only = own_.question.claim;
    left_only.right = own_.tree->add_number((*own_.tree)[left_only.left].span, "0");
    proof.vanishes = (*own_.tree)[left_only.left].rank == 0;
    if (proof.vanishes) {
      for_each_difference(own_, reader, left_only,
                          [&](const WordSum& left) { proof.vanishes = proof.vanishes && left.empty(); });
    }
    proof.unfolded.insert(reader.unfolded().begin(), reader.unfolded().end());
    return proof;
  }

 private:
  [[nodiscard]] bool vanishes(const Coefficient& coefficient, WordProof& proof) {
    Question question = about_numbers(own_, sorted_);
    const Span span = (*own_.tree)[own_.question.claim.left].span;
    question.claim.left = as_expression(coefficient, own_.parts, span);
    question.claim.right = own_.tree->add_number(span, "0");
    for (const auto& [zero, which] : numbers_)
      question.assumptions.push_back({.left = zero, .right = question.claim.right});
    const Decision decision = decide_(question, limits_);
    if (decision.outcome != Outcome::proved) return false;
    proof.unfolded.insert(decision.unfolded.begin(), decision.unfolded.end());
    const std::size_t count = sorted_.of_numbers.size();
    for (const std::size_t which : decision.assumptions)
      proof.assumptions.insert(which < count ? sorted_.of_numbers[which] : numbers_[which - count].second);
    return true;
  }

  OwnQuestion& own_;
  const SortedAssumptions& sorted_;
  const Limits& limits_;
  const DecideNumbers& decide_;
  NumberLaws numbers_;
};

[[nodiscard]] Decision proved_in_words(const WordProof& found) {
  Proof proof;
  proof.words = true;
  proof.vanishes = found.vanishes;
  proof.unfolded = {found.unfolded.begin(), found.unfolded.end()};
  proof.in_force = {found.assumptions.begin(), found.assumptions.end()};
  Decision decision = proved_by(std::move(proof));
  decision.assumptions = {found.assumptions.begin(), found.assumptions.end()};
  return decision;
}

}  // namespace

bool is_about_operators(const Question& question) {
  std::vector<ExprId> roots{question.claim.left, question.claim.right};
  for (const Equation& each : question.assumptions) roots.insert(roots.end(), {each.left, each.right});
  return any_reaches_operators(question, roots);
}

Decision decide_operators(const Question& question, const Limits& limits, const DecideNumbers& decide) {
  if (question.claim.relation != Relation::equal) throw Undecidable("an order of operators is not decided");
  OwnQuestion own(question);
  const SortedAssumptions sorted = sorted_assumptions(own.question);
  const bool defines = !own.question.definitions.empty();
  const bool laws = !sorted.of_operators.empty();
  std::string reason = laws ? "its sides are not equal by the commutators and laws that were assumed"
                            : "its sides are not equal for all operators";
  WordAttempt attempt(own, sorted, limits, decide);
  for (const bool by_laws : {false, true}) {
    for (const Unfolding unfolding : {Unfolding::none, Unfolding::unspoken, Unfolding::all}) {
      const bool idle = unfolding == Unfolding::unspoken && !by_laws;
      if ((by_laws && !laws) || (unfolding != Unfolding::none && !defines) || idle) continue;
      try {
        if (const auto found = attempt.run(unfolding, by_laws)) return proved_in_words(*found);
      } catch (const Undecidable& gave_up) {
        reason = gave_up.what();
      }
    }
  }
  throw Undecidable(reason);
}

namespace {

/// Makes `ratio` the number that `sum` is of `term`; false: it is none, or another one.
[[nodiscard]] bool is_multiple(const WordSum& sum, const WordSum& term, std::optional<WordFraction>& ratio) {
  if (sum.size() != term.size()) return false;
  if (sum.empty()) return true;
  if (!ratio) {
    const auto first = term.begin()->second.begin();
    const auto own = sum.find(term.begin()->first);
    const auto same = own == sum.end() ? Coefficient::const_iterator() : own->second.find(first->first);
    if (own == sum.end() || same == own->second.end()) return false;
    const bool negative = first->second.above < 0;
    const WordFraction inverted{negative ? -first->second.below : first->second.below,
                                std::abs(first->second.above)};
    ratio = same->second * inverted;
  }
  WordSum rest = times(scalar(rational({-ratio->above, ratio->below})), term);
  add_to(rest, sum);
  return rest.empty();
}

/// Where the parts of coefficients depend on each other, as roots do: one of the numbers that slips make.
[[nodiscard]] std::optional<WordFraction> near_multiple(const std::vector<WordSum>& sums,
                                                        const std::vector<WordSum>& terms,
                                                        const CommutingParts& parts) {
  for (const WordFraction ratio : {WordFraction{2, 1}, {-2, 1}, {1, 1}, {-1, 1}, {1, 2}, {-1, 2}}) {
    bool is_it = true;
    for (std::size_t k = 0; k < terms.size() && is_it; ++k) {
      WordSum rest = times(scalar(rational({-ratio.above, ratio.below})), terms[k]);
      add_to(rest, sums[k]);
      is_it = std::ranges::all_of(rest, [&](const auto& each) { return is_nearly_zero(each.second, parts); });
    }
    if (is_it) return ratio;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> multiple_in_words(const Question& question, const Equation& term,
                                             const Limits& limits) {
  if (question.claim.relation != Relation::equal) return std::nullopt;
  try {
    OwnQuestion own(question);
    const SortedAssumptions sorted = sorted_assumptions(own.question);
    WordReader reader(own.question, own.parts, Unfolding::all, *limits.budget);
    WordRules rules(*limits.budget);
    NumberLaws numbers;
    add_rules_that_can_be_read(own, reader, sorted.of_operators, rules, numbers);
    complete_as_far_as_possible(own, rules);
    Positions used;
    const std::vector<WordSum> differences = normal_differences(own, reader, own.question.claim, rules, used);
    const std::vector<WordSum> terms = normal_differences(own, reader, term, rules, used);
    if (differences.size() != terms.size()) return std::nullopt;
    std::optional<WordFraction> ratio;
    bool multiple = true;
    for (std::size_t k = 0; k < terms.size(); ++k)
      multiple = multiple && is_multiple(differences[k], terms[k], ratio);
    if (!multiple) ratio = near_multiple(differences, terms, own.parts);
    if (!ratio || ratio->above == 0) return std::nullopt;
    return ratio->below == 1 ? std::to_string(ratio->above)
                             : std::to_string(ratio->above) + "/" + std::to_string(ratio->below);
  } catch (const Undecidable&) {
    return std::nullopt;
  }
}

bool holds_in_words(const Question& question, const Limits& limits) {
  if (question.claim.relation != Relation::equal) return false;
  try {
    OwnQuestion own(question);
    const SortedAssumptions sorted = sorted_assumptions(own.question);
    WordReader reader(own.question, own.parts, Unfolding::all, *limits.budget);
    WordRules rules(*limits.budget);
    NumberLaws numbers;
    add_rules_that_can_be_read(own, reader, sorted.of_operators, rules, numbers);
    complete_as_far_as_possible(own, rules);
    Positions used;
    const std::vector<WordSum> left = normal_differences(own, reader, own.question.claim, rules, used);
    return std::ranges::all_of(left, [&](const WordSum& sum) {
      return std::ranges::all_of(sum,
                                 [&](const auto& each) { return is_nearly_zero(each.second, own.parts); });
    });
  } catch (const Undecidable&) {
    return false;
  }
}

bool operators_can_satisfy(const Question& question, const Limits& limits, Question& numbers) {
  OwnQuestion own(question);
  const SortedAssumptions sorted = sorted_assumptions(own.question);
  for (const Unfolding unfolding : {Unfolding::none, Unfolding::unspoken, Unfolding::all}) {
    try {
      WordReader reader(own.question, own.parts, unfolding, *limits.budget);
      WordRules rules(*limits.budget);
      add_rules(own, reader, sorted.of_operators, rules);
      complete_to_the_end(own, rules);
      bool can = true;
      for (const Equation& each : own.question.assumptions) {
        if (each.relation == Relation::equal || !speaks_of_operators(own.question, each)) continue;
        if (each.relation != Relation::unequal) return false;
        bool differs = false;
        for_each_difference(own, reader, each, [&](const WordSum& difference) {
          Positions used;
          differs = differs || !rules.reduce(difference, used).empty();
        });
        can = can && differs;
      }
      if (!can) continue;
      numbers = question;
      numbers.assumptions.clear();
      for (const std::size_t which : sorted.of_numbers)
        numbers.assumptions.push_back(question.assumptions[which]);
      std::erase_if(numbers.definitions, [&](const Definition& each) {
        return any_reaches_operators(question, {each.body}) ||
               question.tree->symbols[each.symbol].noncommuting;
      });
      if (!numbers.assumptions.empty()) numbers.claim = numbers.assumptions[0];  // which has no operators
      return true;
    } catch (const Contradiction&) {
      return false;
    } catch (const Undecidable&) {
      // with definitions unfolded it may be known
    }
  }
  return false;
}

bool differs_in_several_degrees(const Question& question) {
  try {
    Budget budget;
    OwnQuestion own(question);
    WordReader reader(own.question, own.parts, Unfolding::all, budget);
    std::set<std::size_t> lengths;
    for_each_difference(own, reader, own.question.claim, [&](const WordSum& difference) {
      for (const auto& [word, coefficient] : difference) lengths.insert(word.size());
    });
    return lengths.size() > 1;
  } catch (const Undecidable&) {
    return true;
  }
}

namespace {

/// One state with one term before it that is not 0: `|n\rangle`, or a number that is none of states. Kets are
/// taken not to be 0.
bool is_plainly_not_zero(const WordSum& sum, const CommutingParts& parts) {
  if (sum.size() != 1 || sum.begin()->first.size() > 1 || sum.begin()->second.size() != 1) return false;
  const auto& [word, coefficient] = *sum.begin();
  const SymbolTable& symbols = parts.tree().symbols;
  if (!word.empty() && !symbols[word[0].symbol].ket) return false;
  return std::ranges::none_of(coefficient.begin()->first, [&](const auto& each) {
    const auto letters = symbols_in(parts.tree(), parts.part(each.first));
    return std::ranges::any_of(letters, [&](SymbolId letter) {
      return symbols[letter].name.starts_with('#') || !symbols[letter].label.empty();
    });
  });
}

}  // namespace

bool operators_deny(const Question& question, const Limits& limits) {
  if (question.claim.relation != Relation::equal || !is_about_operators(question)) return false;
  try {
    OwnQuestion own(question);
    const SortedAssumptions sorted = sorted_assumptions(own.question);
    if (sorted.of_operators.empty()) return false;
    WordReader reader(own.question, own.parts, Unfolding::all, *limits.budget);
    WordRules rules(*limits.budget);
    add_rules(own, reader, sorted.of_operators, rules);
    const Equation& claim = own.question.claim;
    if (holds_states(*own.tree, claim.left) || holds_states(*own.tree, claim.right)) {
      complete_as_far_as_possible(own, rules);
      Positions used;
      const std::vector<WordSum> left = normal_differences(own, reader, own.question.claim, rules, used);
      return left.size() == 1 && is_plainly_not_zero(left[0], own.parts);
    }
    rules.complete();
    bool denies = false;
    for_each_difference(own, reader, own.question.claim, [&](const WordSum& difference) {
      Positions used;
      const WordSum left = rules.reduce(difference, used);
      denies = denies || (!left.empty() && !left.contains(std::prev(difference.end())->first));
    });
    return denies;
  } catch (const Undecidable&) {
    return false;
  }
}

}  // namespace rigor
