// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "algebra/sample/screen.h"
#include "base/ascii.h"
#include "check/law/state_facts.h"
#include "check/question/base_letters.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "check/repair/trivial_statement.h"
#include "check/verdict/chain_reading.h"
#include "latex/parse/parse.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

constexpr std::size_t most_judged = 24;
constexpr std::size_t most_judged_unseen = 64;  // where no sample tells which of them are worth it
constexpr std::size_t most_judged_held = 200;   // in derivatives that hold other letters
constexpr std::size_t most_judged_unseen_of_open = 12;
constexpr std::size_t most_judged_rounded = 320;
constexpr std::uint64_t most_work_unseen = 1'000'000;
constexpr std::uint64_t most_work_on_one =
    45'000;                              // of these; a proof takes less, and most that fail take more
constexpr std::size_t most_in_vain = 8;  // of these, once one is found
constexpr std::size_t most_in_vain_of_many = 40;
constexpr std::size_t most_tokens = 400;          // of both sides; longer ones are not mended
constexpr std::size_t most_to_first_order = 150;  // candidates, since each is differentiated
/// For samples that candidates are compared on.
[[nodiscard]] Limits screening(DecisionCache* cache) {
  return {.steps = 200'000, .budget = cache == nullptr ? nullptr : &cache->budget()};
}
constexpr int widest_choice = 20;    // how much further than the nearest another one may be
constexpr long largest_number = 12;  // in a coefficient that is offered

std::optional<Coefficient> coefficient_from(const std::string& exact) {
  const std::size_t slash = exact.find('/');
  if (exact.size() > 8) return std::nullopt;
  const Coefficient value{std::stol(exact),
                          slash == std::string::npos ? 1 : std::stol(exact.substr(slash + 1))};
  if (std::abs(value.numerator) > largest_number || value.denominator > largest_number) return std::nullopt;
  return value;
}

/// The same places in the same order, so that components can be compared one by one.
bool have_same_places(const ExprTree& tree, const Equation& a, const Equation& b) {
  return a.indices.size() == b.indices.size() && a.particles.size() == b.particles.size() &&
         std::is_permutation(a.indices.begin(), a.indices.end(), b.indices.begin()) &&
         std::is_permutation(a.particles.begin(), a.particles.end(), b.particles.begin()) &&
         tree[a.left].rank == tree[b.left].rank;
}

class RepairSearch {
 public:
  RepairSearch(ExprTree& tree, Names& names, const WrongStep& wrong, const NeighbourProof& proof,
               const Asked& asked, DecisionCache* cache)
      : tree_(tree),
        names_(names),
        proof_(proof),
        asked_(asked),
        cache_(cache),
        wrong_(wrong),
        chain_(wrong.parsed),
        candidates_(wrong, sides_) {
    chain_.sides.clear();
    for (const WrittenSide& side : wrong.parsed.written.sides) {
      sides_.push_back(without_layout(side.tokens));
      chain_.sides.push_back(parse_side(sides_.back(), side.span, syntax_));
    }
    reading_ = read_chain(syntax_, tree_, names_, chain_, wrong.rules);
  }

  /// Of the first neighbour with most letters: it lacks no term.
  std::optional<Claim> nearest_claim() {
    if (is_too_long() || (!typed(0) && !typed(1))) return std::nullopt;
    std::vector<RepairCandidate> near = candidates_.rewritten_sides(true);
    read(near);
    return richest_claim_;
  }

  std::vector<TrueNeighbour> run(NotCompared others) {
    if (is_too_long()) return {};
    if (others == NotCompared::all_asked) return prove_the_nearest(all_near(), most_judged_rounded, true);
    const std::optional<Claim> original = claim_between(typed(0), typed(1));
    const bool by_terms =
        original && !original->nearly && original->equation.relation == Relation::equal && !asked_;
    std::vector<RepairCandidate> rewritten = candidates_.rewritten_sides(!by_terms);
    std::vector<Equation> equations = read(rewritten);
    if (rewritten.empty()) return {};
    claim_ = original ? *original : *richest_claim_;
    if (asked_) ask_instead(rewritten, equations);
    if (rewritten.empty()) return {};
    std::vector<RepairCandidate> holding;
    const bool in_coordinates = !coordinates_in(tree_, claim_.equation).empty();
    if (in_coordinates) {
      // On a sample, derivatives that hold other letters are numbers of their own: all that is near is asked.
      holding = others == NotCompared::few ? all_near() : candidates_.rewritten_sides(true);
    } else if (claim_.nearly) {
      holding = holding_to_first_order(rewritten, equations);
    } else {
      const std::vector<ComparedTerm> terms = by_terms ? candidates_.terms() : std::vector<ComparedTerm>{};
      holding = holding_on_samples(rewritten, equations, terms, false);
      const bool compares = claim_was_compared_ || not_compared_.size() < rewritten.size();
      if (lack_terms(holding) && compares && !asked_) add_insertions(holding);
      if (holding.empty() && compares && !asked_)
        holding = holding_on_samples(rewritten, equations, terms, true);
      if (holding.empty() && compares && !asked_ && others != NotCompared::left_out)
        add_letters_near(holding);
    }
    sort_and_reduce(holding, candidates_.side(0), candidates_.side(1));
    const std::size_t most = in_coordinates && others == NotCompared::few ? most_judged_held : most_judged;
    std::vector<TrueNeighbour> found = prove_the_nearest(holding, most, in_coordinates);
    if (says_only_zero(found) && others == NotCompared::asked) {
      std::vector<TrueNeighbour> unseen = prove_what_was_not_compared(most_judged_unseen);
      unseen.insert(unseen.end(), std::make_move_iterator(found.begin()),
                    std::make_move_iterator(found.end()));
      if (unseen.size() > most_repairs) unseen.erase(unseen.begin() + most_repairs, unseen.end());
      return unseen;
    }
    if (found.empty() && others == NotCompared::few)
      return prove_what_was_not_compared(most_judged_unseen_of_open);
    return found;
  }

 private:
  [[nodiscard]] bool is_too_long() const {
    return candidates_.side(0).size() + candidates_.side(1).size() > most_tokens;
  }

  /// Is none of the usual slips found? Then a term may be missing in a bracket.
  static bool lack_terms(const std::vector<RepairCandidate>& holding) {
    return std::ranges::none_of(holding, [](const RepairCandidate& each) {
      return each.slip == Slip::sign || each.slip == Slip::factor || each.slip == Slip::order ||
             each.slip == Slip::index || each.slip == Slip::indices_swapped;
    });
  }

  /// Nobody writes a calculation in place of a 0.
  static bool says_only_zero(const std::vector<TrueNeighbour>& found) {
    return std::ranges::all_of(found,
                               [](const TrueNeighbour& each) { return each.repair.replacement == "0"; });
  }

  std::vector<TrueNeighbour> prove_what_was_not_compared(std::size_t most) {
    if (not_compared_.empty() || cache_ == nullptr || cache_->budget().exhausted()) return {};
    if (!claim_was_compared_) {  // nor were its terms
      for (RepairCandidate& each : candidates_.rewritten_sides(true))
        not_compared_.push_back(std::move(each));
    }
    sort_and_reduce(not_compared_, candidates_.side(0), candidates_.side(1));
    const ShareOfWork share(*cache_, most_work_unseen);
    return prove_the_nearest(not_compared_, most, true);
  }

  void add_insertions(std::vector<RepairCandidate>& holding) {
    std::vector<RepairCandidate> insertions = candidates_.insertions();
    const std::vector<Equation> equations = read(insertions);
    for (RepairCandidate& each : holding_on_samples(insertions, equations, {}, false))
      holding.push_back(std::move(each));
  }

  /// Of a row that is known to be wrong, or is told only what is near it: other rows name other quantities.
  void add_letters_near(std::vector<RepairCandidate>& holding) {
    std::vector<RepairCandidate> others = candidates_.with_letters_near();
    const std::vector<Equation> equations = read(others);
    for (RepairCandidate& each : holding_on_samples(others, equations, {}, true))
      holding.push_back(std::move(each));
  }

  /// With letters of other rows, the nearest first.
  std::vector<RepairCandidate> all_near() const {
    std::vector<RepairCandidate> near = candidates_.rewritten_sides(true);
    for (RepairCandidate& each : candidates_.with_letters_near()) near.push_back(std::move(each));
    sort_and_reduce(near, candidates_.side(0), candidates_.side(1));
    return near;
  }

  // --- reading

  const std::optional<Typed>& typed(std::size_t side) const {
    return reading_->sides[wrong_.which + side].typed;
  }

  std::optional<Claim> claim_between(const std::optional<Typed>& left, const std::optional<Typed>& right) {
    if (!left || !right) return std::nullopt;
    return reading_->claim(chain_, wrong_.which, *left, *right, wrong_.first_order, ignored_);
  }

  std::optional<Typed> read(TokenView tokens) {
    const Span place = chain_.written.sides[wrong_.which].span;
    return reading_->read(parse_side(tokens, place, syntax_));
  }

  /// The equations of those that can be read; the others are taken out.
  std::vector<Equation> read(std::vector<RepairCandidate>& candidates) {
    std::vector<Equation> equations;
    std::erase_if(candidates, [&](const RepairCandidate& candidate) {
      const std::optional<Typed>& other = typed(1 - candidate.side);
      if (!other) return true;
      const auto own = read(candidate.tokens);
      const auto claim = candidate.side == 0 ? claim_between(own, other) : claim_between(other, own);
      if (!claim) return true;
      keep_if_richer(*claim);
      equations.push_back(claim->equation);
      return false;
    });
    return equations;
  }

  /// Where both sides can be read, their ranks or indices do not fit, and the nearest one that does will do.
  void keep_if_richer(const Claim& claim) {
    if (typed(0) && typed(1) && richest_claim_) return;
    const std::size_t letters = base_letters(tree_, names_.scope, claim.equation).size();
    if (richest_claim_ && letters <= most_letters_) return;
    richest_claim_ = claim;
    most_letters_ = letters;
  }

  /// Each equation becomes the one that is asked; what has none is taken out.
  void ask_instead(std::vector<RepairCandidate>& candidates, std::vector<Equation>& equations) {
    const auto own = asked_(tree_, names_, claim_.equation);
    std::vector<RepairCandidate> kept;
    std::vector<Equation> asked;
    for (std::size_t k = 0; own && k < candidates.size(); ++k) {
      const auto equation = asked_(tree_, names_, equations[k]);
      if (!equation) continue;
      kept.push_back(std::move(candidates[k]));
      asked.push_back(*equation);
    }
    if (own) claim_.equation = *own;
    candidates = std::move(kept);
    equations = std::move(asked);
  }

  /// The term = 0, at the places of the claim.
  std::optional<Equation> against_zero(TokenView term) {
    const auto claim = claim_between(read(term), typed(0));
    if (!claim || !have_same_places(tree_, claim->equation, claim_.equation)) return std::nullopt;
    Equation equation = claim_.equation;
    equation.left = claim->equation.left;
    equation.right =
        zero_of_rank(tree_, tree_[equation.left].span, tree_[equation.left].rank, tree_[equation.left].axes);
    return equation;
  }

  // --- what holds on samples

  std::set<SymbolId> bases_in(const Question& question) const {
    std::set<SymbolId> bases;
    const auto add_all = [&](ExprId side) {
      for (const SymbolId symbol : symbols_in(tree_, side)) bases.insert(base_of(tree_.symbols, symbol));
    };
    for (const ExprId side : {question.claim.left, question.claim.right}) add_all(side);
    for (const Definition& definition : question.definitions) add_all(definition.body);
    for (const Equation& assumption : question.assumptions) {
      add_all(assumption.left);
      add_all(assumption.right);
    }
    return bases;
  }

  /// Sides with symbols that the claim does not have, all of them defined.
  std::vector<ExprId> known_sides(const std::vector<Equation>& equations) {
    const std::set<SymbolId> reached = bases_in(prepare(tree_, names_, claim_.equation).question);
    std::vector<ExprId> sides;
    for (const Equation& equation : equations) {
      for (const ExprId side : {equation.left, equation.right}) {
        const std::vector<SymbolId> symbols = symbols_in(tree_, side);
        const bool known = std::ranges::all_of(symbols, [&](SymbolId symbol) {
          const SymbolId base = base_of(tree_.symbols, symbol);
          return reached.contains(base) || definition_of(names_.scope, base) != nullptr;
        });
        if (known) sides.push_back(side);
      }
    }
    return sides;
  }

  /// `term = 0` for each; of one that cannot be read, 0 = 0.
  std::vector<Equation> zeros_of(const std::vector<ComparedTerm>& terms) {
    std::vector<Equation> zeros;
    for (const ComparedTerm& term : terms) {
      auto zero = against_zero(term.tokens);
      if (!zero) {
        zero = claim_.equation;
        zero->left = zero->right = zero_of_rank(tree_, claim_.relation, tree_[claim_.equation.left].rank,
                                                tree_[claim_.equation.left].axes);
      }
      zeros.push_back(*zero);
    }
    return zeros;
  }

  void compare(SampleScreen& screen, const std::vector<ComparedTerm>& terms,
               const std::vector<Equation>& zeros, std::vector<RepairCandidate>& holding) const {
    const auto multiples = screen.multiples(claim_.equation, zeros);
    for (std::size_t k = 0; k < terms.size(); ++k) {
      const auto ratio = multiples[k] ? coefficient_from(*multiples[k]) : std::nullopt;
      if (ratio) holding.push_back(candidates_.with(terms[k], *ratio));
    }
  }

  /// `beyond`: compared are also those that speak of what is defined elsewhere.
  std::vector<RepairCandidate> holding_on_samples(const std::vector<RepairCandidate>& rewritten,
                                                  const std::vector<Equation>& equations,
                                                  const std::vector<ComparedTerm>& terms, bool beyond) {
    const std::vector<Equation> zeros = zeros_of(terms);
    std::vector<Equation> all = equations;
    all.insert(all.end(), zeros.begin(), zeros.end());
    const std::vector<ExprId> sides = beyond ? known_sides(all) : std::vector<ExprId>{};
    SampleScreen& screen = screen_with(sides);
    std::vector<RepairCandidate> holding;
    const std::vector<Screened> screened = screen.screened(equations);
    for (std::size_t k = 0; k < rewritten.size(); ++k) {
      if (screened[k] == Screened::holds) holding.push_back(rewritten[k]);
      if (screened[k] == Screened::not_compared && !beyond) not_compared_.push_back(rewritten[k]);
    }
    if (!beyond)
      claim_was_compared_ = screen.screened({&claim_.equation, 1}).front() != Screened::not_compared;
    compare(screen, terms, zeros, holding);
    if (!terms.empty() && holding.empty()) {
      const std::vector<ComparedTerm> longer = candidates_.longer_terms();
      const std::vector<Equation> longer_zeros = zeros_of(longer);
      compare(*screen.after_growth(), longer, longer_zeros, holding);
    }
    return holding;
  }

  /// Samples for the claim and these sides; for the claim alone always the same.
  SampleScreen& screen_with(const std::vector<ExprId>& sides) {
    std::unique_ptr<SampleScreen>& screen = sides.empty() ? screen_of_claim_ : screen_beyond_;
    if (sides.empty() && screen != nullptr) return *(screen = screen->after_growth());
    Prepared prepared = prepare(tree_, names_, claim_.equation, 0, Precision::exact, 0, sides);
    if (speaks_of_derivatives(prepared))
      prepared = prepare(tree_, names_, claim_.equation, 1, Precision::exact, 0, sides);
    screen = std::make_unique<SampleScreen>(prepared.question, sides, screening(cache_));
    return *screen;
  }

  /// Nearly equal: the parts of zeroth and of first order are equal.
  std::vector<RepairCandidate> holding_to_first_order(const std::vector<RepairCandidate>& rewritten,
                                                      std::vector<Equation> equations) {
    if (equations.size() > most_to_first_order)
      equations.erase(equations.begin() + most_to_first_order, equations.end());
    std::vector<bool> holds(equations.size(), true);
    for (const int order : {0, 1}) {
      const auto at_order = [&](const Equation& equation) {
        return prepare(tree_, names_, equation, 0, Precision::small_order, order).question;
      };
      std::vector<Equation> parts;
      for (const Equation& equation : equations) parts.push_back(at_order(equation).claim);
      const Question question = at_order(claim_.equation);
      const std::vector<bool> passing = SampleScreen(question, {}, screening(cache_)).passing(parts);
      for (std::size_t k = 0; k < holds.size(); ++k) holds[k] = holds[k] && passing[k];
    }
    std::vector<RepairCandidate> holding;
    for (std::size_t k = 0; k < holds.size(); ++k) {
      if (holds[k]) holding.push_back(rewritten[k]);
    }
    return holding;
  }

  // --- what is true

  /// `unseen`: no sample tells which of them are worth it.
  std::vector<TrueNeighbour> prove_the_nearest(const std::vector<RepairCandidate>& candidates,
                                               std::size_t most, bool unseen) {
    std::vector<TrueNeighbour> found;
    const std::size_t patience = most > most_judged_unseen ? most_in_vain_of_many : most_in_vain;
    std::size_t judged = 0;
    std::size_t in_vain = 0;
    int nearest = 0;
    std::array<bool, 2> mends_a_term{};  // on a side: then a term more says the same: it makes up for it
    for (const RepairCandidate& candidate : candidates) {
      const bool far = !found.empty() && candidate.distance > nearest + widest_choice;
      const bool says_the_same = candidate.slip == Slip::term_missing && mends_a_term[candidate.side];
      if (says_the_same || says_nothing(candidate) || (candidate.roundabout && !found.empty())) continue;
      if (far || found.size() == most_repairs || judged++ == most) break;
      if (unseen && !found.empty() && in_vain == patience) break;
      auto uses = unseen ? proved_soon(candidate) : proved(candidate);
      if (!uses) {
        ++in_vain;
        continue;
      }
      if (found.empty()) nearest = candidate.distance;
      const bool for_both =
          candidate.slip == Slip::sign || candidate.slip == Slip::factor || text_of(candidate.tokens) == "0";
      if (for_both) mends_a_term = {true, true};
      if (candidate.slip == Slip::term_missing) mends_a_term[candidate.side] = true;
      found.push_back({{candidate.side == 0, statement_of(candidate), candidate.change,
                        text_of(candidates_.side(candidate.side)), text_of(candidate.tokens),
                        candidate.slip == Slip::term_missing},
                       candidate.slip,
                       *std::move(uses)});
    }
    return found;
  }

  /// A term next to a 0 only repeats the other side, and so does one that is the other side: X = X + 0. What
  /// the calculation began with is not mended by a 0.
  bool says_nothing(const RepairCandidate& candidate) const {
    const std::string old = text_of(candidates_.side(candidate.side));
    const std::string now = text_of(candidate.tokens);
    const std::string other = text_of(candidates_.side(1 - candidate.side));
    if (candidate.slip != Slip::term_missing) return candidate.side == 0 && now == "0" && old != "0";
    return old == "0" || now == old + " + " + other || now == old + "+" + other || now == old + other;
  }

  std::optional<std::vector<std::string>> proved_soon(const RepairCandidate& candidate) {
    if (cache_ == nullptr) return proved(candidate);
    const ShareOfWork share(*cache_, most_work_on_one);
    return proved(candidate);
  }

  /// As it would be read in place of what was written: what its proof uses.
  std::optional<std::vector<std::string>> proved(const RepairCandidate& candidate) {
    if (trim(candidate.tokens).empty()) return std::nullopt;
    ParsedChain chain = chain_;
    const std::size_t place = wrong_.which + candidate.side;
    chain.written.sides[place].tokens = candidate.tokens;
    chain.sides[place] = parse_side(candidate.tokens, chain.written.sides[place].span, syntax_);
    Names names = wrong_.proved_with != nullptr ? *wrong_.proved_with : names_;
    const auto reading = read_chain(syntax_, tree_, names, chain, wrong_.rules);
    if (!reading->sides[wrong_.which].typed || !reading->sides[wrong_.which + 1].typed) return std::nullopt;
    if (leaves_open(*reading) && !leaves_open(*reading_)) return std::nullopt;
    Diagnostics mismatches;
    const auto claim = reading->claim(chain, wrong_.which, wrong_.first_order, mismatches);
    if (!claim || !mismatches.empty()) return std::nullopt;
    const bool trivial = is_trivial(tree_, claim->equation.left, claim->equation.right);
    if (trivial && !spells_out(candidate)) return std::nullopt;
    return proof_(tree_, names, *claim, candidate.slip);
  }

  /// A letter or a bracket can mean something else.
  static bool leaves_open(const ChainReading& reading) {
    return guess_of(reading.reading()).has_value() || reading.reading().found.applied.has_value();
  }

  /// `\cosh x = \frac{e^x + e^{-x}}{2}`, `[A, B] = AB - BA`: the same to us, not to the author.
  bool spells_out(const RepairCandidate& candidate) const {
    const auto words_of = [](TokenView side) {
      std::set<std::string_view> words;
      for (const Token& token : side) {
        const bool word = token.kind == TokenKind::control && !function_name(token.text).empty();
        if (word || is_sign(token, "[")) words.insert(token.text);
      }
      return words;
    };
    return words_of(candidate.tokens) != words_of(candidates_.side(1 - candidate.side));
  }

  std::string statement_of(const RepairCandidate& candidate) const {
    const std::string changed = text_of(candidate.tokens);
    const std::string other = text_of(candidates_.side(1 - candidate.side));
    return fmt::format("{} {} {}", candidate.side == 0 ? changed : other,
                       chain_.written.relations[wrong_.which].text, candidate.side == 0 ? other : changed);
  }

  ExprTree& tree_;
  Names& names_;
  const NeighbourProof& proof_;
  const Asked& asked_;
  DecisionCache* cache_;
  const WrongStep& wrong_;
  SyntaxTree syntax_;
  std::vector<Tokens> sides_;
  ParsedChain chain_;
  RepairCandidates candidates_;
  std::unique_ptr<ChainReading> reading_;
  Diagnostics ignored_;
  std::vector<RepairCandidate> not_compared_;  // on the samples
  std::unique_ptr<SampleScreen> screen_of_claim_;
  std::unique_ptr<SampleScreen> screen_beyond_;  // with sides that speak of what is defined elsewhere
  bool claim_was_compared_ = true;
  Claim claim_;                         // the original one; where it has no meaning, the nearest that has one
  std::optional<Claim> richest_claim_;  // of a candidate
  std::size_t most_letters_ = 0;        // of that
};

}  // namespace

std::vector<TrueNeighbour> true_neighbours(const ExprTree& tree, const Names& names, const WrongStep& wrong,
                                           const NeighbourProof& proof, DecisionCache* cache,
                                           const Asked& asked, NotCompared others) {
  ExprTree own_tree = tree;
  Names own_names = names;
  return RepairSearch(own_tree, own_names, wrong, proof, asked, cache).run(others);
}

std::vector<Repair> nearest_true_statements(const ExprTree& tree, const Names& names, const WrongStep& wrong,
                                            DecisionCache* cache) {
  const NeighbourProof proof = [cache](ExprTree& grown, const Names& read, const Claim& claim,
                                       Slip) -> std::optional<std::vector<std::string>> {
    Judgement judgement = judge(grown, read, claim, limits_of_candidates, cache);
    if (judgement.verdict != Verdict::proved || !judgement.diagnostics.empty()) return std::nullopt;
    return std::move(judgement.uses);
  };
  std::vector<Repair> repairs;
  for (TrueNeighbour& each : true_neighbours(tree, names, wrong, proof, cache, {}, NotCompared::asked))
    repairs.push_back(std::move(each.repair));
  return repairs;
}

std::optional<Claim> nearest_claim(ExprTree& tree, Names& names, const WrongStep& wrong) {
  auto claim = RepairSearch(tree, names, wrong, {}, {}, nullptr).nearest_claim();
  if (claim) claim->reading = nullptr, claim->doubt = nullptr;
  return claim;
}

std::vector<Repair> repairs_of(std::vector<TrueNeighbour> neighbours) {
  std::vector<Repair> repairs;
  for (TrueNeighbour& each : neighbours) {
    each.repair.uses = std::move(each.uses);
    repairs.push_back(std::move(each.repair));
  }
  return repairs;
}

std::string bare_formula(std::string latex) {
  for (const std::string_view sign : {"\\left", "\\right", "\\,", "\\;", "\\!"}) {
    for (auto at = latex.find(sign); at != std::string::npos; at = latex.find(sign, at))
      latex.erase(at, sign.size());
  }
  std::erase_if(latex, [](char c) { return c == ' ' || c == '\n' || c == '{' || c == '}'; });
  return latex;
}

bool adds_an_unusual_term(const Repair& repair) {
  if (!repair.adds_a_term || !repair.replacement.starts_with(repair.replaced)) return false;
  const std::string_view added = std::string_view(repair.replacement).substr(repair.replaced.size());
  const auto first = added.find_first_not_of("+- ");
  if (first == std::string_view::npos || !is_digit(added[first])) return false;
  const auto end = added.find_first_not_of("0123456789", first);
  const std::string_view number = added.substr(first, end - first);
  return number.size() > 1 || number[0] >= '3';
}

}  // namespace rigor
