// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "algebra/screen.h"
#include "check/chain_reading.h"
#include "check/question.h"
#include "latex/parse.h"
#include "latex/rewritings.h"

namespace rigor {
namespace {

constexpr std::size_t most_candidates = 800;
constexpr std::size_t most_judged = 8;
/// A neighbour of a typical step is proved with a hundredth of this.
constexpr Limits brief{.expanded_terms = 10'000,
                       .steps = 60'000,
                       .quick_points = 2,
                       .quick_steps = 4'000,
                       .sample_attempts = 12,
                       .fewest_assumptions = false};
constexpr Limits screening{.steps = 200'000};
constexpr int widest_choice = 12;    // how much further than the nearest another one may be
constexpr long largest_number = 12;  // in a coefficient that is offered

/// How far a rewriting is from what was written: the likelier the slip, the nearer. Tokens count one each.
int distance_of(Slip slip) {
  switch (slip) {
    case Slip::sign:
    case Slip::order:
      return 20;
    case Slip::indices_swapped:
      return 21;
    case Slip::factor:
    case Slip::index:
      return 23;
    case Slip::power:
    case Slip::product:
    case Slip::bars:
      return 25;
    case Slip::term_extra:
    case Slip::term_missing:
      return 26;
    case Slip::rate:
    case Slip::prime:
    case Slip::letter:
      return 30;
  }
  return 40;
}

struct Candidate {
  std::size_t side = 0;  // 0 left, 1 right
  Tokens tokens;         // of the side
  std::string change;
  int distance = 0;
  std::optional<Equation> equation = {};  // none: not read
  bool holds = false;                     // on all samples
};

std::optional<Coefficient> coefficient_from(const std::string& exact) {
  const std::size_t slash = exact.find('/');
  if (exact.size() > 8) return std::nullopt;
  const Coefficient value{std::stol(exact),
                          slash == std::string::npos ? 1 : std::stol(exact.substr(slash + 1))};
  if (std::abs(value.numerator) > largest_number || value.denominator > largest_number) return std::nullopt;
  return value;
}

class Repairing {
 public:
  Repairing(ExprTree& tree, Names& names, const WrongStep& wrong)
      : tree_(tree), names_(names), wrong_(wrong) {
    for (const WrittenSide& side : wrong.parsed.written.sides) {
      sides_.push_back(without_layout(side.tokens));
      syntax_of_.push_back(parse_side(sides_.back(), side.span, syntax_));
    }
    chain_ = wrong.parsed;
    chain_.sides = syntax_of_;
  }

  std::vector<Repair> search() {
    const Names before = names_;
    std::vector<Repair> repairs;
    if (read_original()) {
      rewrite_sides();
      if (can_compare_terms()) offered_ = terms_to_compare();
      read_candidates();
      if (claim_.nearly) {
        look_at_orders();
      } else {
        look_at_samples({});
        const bool any = std::any_of(candidates_.begin(), candidates_.end(),
                                     [](const Candidate& candidate) { return candidate.holds; });
        if (!any) look_at_samples(known_sides());
      }
      repairs = prove_the_nearest();
    }
    names_ = before;
    return repairs;
  }

 private:
  static constexpr std::array<const char*, 2> side_names{"left", "right"};

  TokenView side(std::size_t which) const { return sides_[wrong_.which + which]; }

  bool read_original() {
    reading_ = read_chain(syntax_, tree_, names_, chain_);
    if (!reading_->sides[wrong_.which].typed || !reading_->sides[wrong_.which + 1].typed) return false;
    const auto claim = reading_->claim(chain_, wrong_.which, wrong_.first_order, ignored_);
    if (!claim) return false;
    claim_ = *claim;
    return true;
  }

  // --- candidates

  void add(std::size_t which, Slip slip, Tokens tokens, std::string change, int further = 0) {
    const auto longer = static_cast<int>(tokens.size()) - static_cast<int>(side(which).size());
    const int distance = distance_of(slip) + std::clamp(longer, -4, 12) + further + suspicion(which);
    candidates_.push_back({which, std::move(tokens), std::move(change), distance});
  }

  /// How unlikely it is that the slip is on this side.
  int suspicion(std::size_t which) const {
    const Trust trust = which == 0 ? wrong_.left : wrong_.right;
    const bool name = which == 0 && letters_of({side(0)}).size() == 1 && side(0).size() <= 12 &&
                      terms_of_side(side(0)).size() == 1;
    return (which == 0 ? 1 : 0) + (trust == Trust::supported ? 12 : 0) - (trust == Trust::doubted ? 4 : 0) +
           (name ? 6 : 0);
  }

  struct Offered {
    std::size_t side = 0;
    std::optional<std::size_t> which = {};  // a term of the side; none: a term more
    Tokens tokens = {};
    int further = 0;
    std::optional<Equation> equation = {};  // the term = 0; none: not read
  };

  bool can_compare_terms() const { return !claim_.nearly && claim_.equation.relation == Relation::equal; }

  /// The terms of both sides, then those that may be missing: terms of the chain, images of its terms, terms
  /// of lines near it, simple products.
  std::vector<Offered> terms_to_compare() const {
    constexpr std::size_t most = 240;
    std::vector<Offered> offered;
    std::array<std::set<std::string>, 2> known;
    for (const std::size_t which : {0u, 1u}) {
      const std::vector<SideTerm> terms = terms_of_side(side(which));
      for (std::size_t k = 0; k < terms.size(); ++k) {
        offered.push_back({which, k, Tokens(terms[k].with_sign.begin(), terms[k].with_sign.end())});
        known[which].insert(text_of(without_layout(terms[k].tokens)));
      }
    }
    const auto offer_more = [&](TokenView term, int further) {
      Tokens tokens = without_layout(term);
      for (const std::size_t which : {1u, 0u}) {
        if (offered.size() < most && known[which].insert(text_of(tokens)).second)
          offered.push_back({which, std::nullopt, tokens, further});
      }
    };
    const std::vector<TokenView> chain = chain_sides();
    for (const TokenView other : chain) {
      for (const SideTerm& term : terms_of_side(other)) offer_more(term.tokens, 0);
    }
    for (const TokenView other : wrong_.near) {
      for (const SideTerm& term : terms_of_side(other)) offer_more(term.tokens, 2);
    }
    for (const std::size_t which : {1u, 0u}) {
      for (const SideTerm& term : terms_of_side(side(which))) {
        for (const Tokens& image : images_of_term(term.tokens, chain)) offer_more(image, 1);
      }
    }
    std::vector<TokenView> nearby = chain;
    nearby.insert(nearby.end(), wrong_.near.begin(), wrong_.near.end());
    for (const Tokens& product : products_of(letters_of(nearby))) offer_more(product, 2);
    return offered;
  }

  std::vector<TokenView> chain_sides() const { return {sides_.begin(), sides_.end()}; }

  void offer(std::size_t which, std::optional<std::size_t> term, const Tokens& tokens, Coefficient ratio,
             int further) {
    const long turned = which == 0 ? -ratio.numerator : ratio.numerator;
    if (!term) {
      const Rewriting more = with_term(side(which), tokens, {turned, ratio.denominator});
      add(which, Slip::term_missing, rewritten(side(which), more),
          fmt::format("`{}` is missing on the {} side", text_of(more.text), side_names[which]), further);
      candidates_.back().holds = true;
      return;
    }
    const Coefficient times{ratio.denominator + turned, ratio.denominator};
    const Rewriting change = with_coefficient(side(which), *term, times);
    const bool usual = std::abs(times.numerator) <= 2 && times.denominator <= 2;
    add(which, change.slip, rewritten(side(which), change), words_for(which, *term, times), usual ? 0 : 2);
    candidates_.back().holds = true;
  }

  std::string words_for(std::size_t which, std::size_t term, Coefficient times) const {
    const std::vector<SideTerm> terms = terms_of_side(side(which));
    const std::string what = terms.size() == 1
                                 ? fmt::format("the {} side", side_names[which])
                                 : fmt::format("term {} on the {}", term + 1, side_names[which]);
    if (times.numerator == 0)
      return terms.size() == 1 ? fmt::format("{} is 0", what) : fmt::format("{} is one too many", what);
    if (times.numerator == -times.denominator) return fmt::format("{} has the opposite sign", what);
    const std::string number = times.denominator == 1
                                   ? std::to_string(times.numerator)
                                   : fmt::format("{}/{}", times.numerator, times.denominator);
    return fmt::format("{} must be {} times as large", what, number);
  }

  void rewrite_sides() {
    const std::vector<TokenView> chain = chain_sides();
    for (const std::size_t which : {1u, 0u}) {
      for (const Rewriting& change : rewritings_of(side(which), chain, !can_compare_terms()))
        add_rewriting(which, change);
      for (const Rewriting& change : insertions_of(side(which), chain)) add_rewriting(which, change);
    }
  }

  void add_rewriting(std::size_t which, const Rewriting& change) {
    const std::string from =
        text_of(side(which).subspan(change.shown_begin, change.shown_end - change.shown_begin));
    const std::string to = text_of(shown_after(side(which), change));
    const bool inside = change.slip == Slip::sign || change.slip == Slip::factor;
    const int further = change.slip == Slip::order && to < from ? -1 : (inside ? 2 : 0);
    add(which, change.slip, rewritten(side(which), change),
        fmt::format("`{}` for `{}` on the {} side", to, from, side_names[which]), further);
  }

  // --- what holds

  std::optional<Typed> read(TokenView tokens) {
    const Span place = chain_.written.sides[wrong_.which].span;
    return reading_->elaborator().expression(parse_side(tokens, place, syntax_));
  }

  std::optional<Equation> against_zero(TokenView term) {
    const auto typed = read(term);
    if (!typed) return std::nullopt;
    const auto claim = reading_->claim(chain_, wrong_.which, *typed, *reading_->sides[wrong_.which].typed,
                                       wrong_.first_order, ignored_);
    if (!claim) return std::nullopt;
    Equation equation = claim->equation;
    const bool same_places =
        std::is_permutation(equation.indices.begin(), equation.indices.end(), claim_.equation.indices.begin(),
                            claim_.equation.indices.end()) &&
        std::is_permutation(equation.particles.begin(), equation.particles.end(),
                            claim_.equation.particles.begin(), claim_.equation.particles.end());
    if (!same_places || tree_[equation.left].rank != tree_[claim_.equation.left].rank) return std::nullopt;
    equation.indices = claim_.equation.indices;  // in the claim's order
    equation.particles = claim_.equation.particles;
    equation.right = zero_of_rank(tree_, tree_[equation.left].span, tree_[equation.left].rank);
    return equation;
  }

  void read_candidates() {
    sort_candidates();
    remove_trivial();
    if (candidates_.size() > most_candidates)
      candidates_.erase(candidates_.begin() + most_candidates, candidates_.end());
    for (Candidate& candidate : candidates_) candidate.equation = equation_of(candidate);
    for (Offered& term : offered_) term.equation = against_zero(term.tokens);
  }

  /// Symbols that nothing is known of are not what was meant.
  bool is_known(ExprId side, const std::set<SymbolId>& reached) const {
    const std::vector<SymbolId> symbols = symbols_in(tree_, side);
    return std::all_of(symbols.begin(), symbols.end(), [&](SymbolId symbol) {
      const SymbolId base = base_of(tree_.symbols, symbol);
      return reached.contains(base) || names_.definition_of(base) != nullptr;
    });
  }

  std::set<SymbolId> symbols_of(const Question& question) const {
    std::set<SymbolId> symbols;
    const auto add_all = [&](ExprId side) {
      for (const SymbolId symbol : symbols_in(tree_, side)) symbols.insert(base_of(tree_.symbols, symbol));
    };
    for (const ExprId side : {question.claim.left, question.claim.right}) add_all(side);
    for (const Definition& definition : question.definitions) add_all(definition.body);
    for (const Equation& assumption : question.assumptions) {
      add_all(assumption.left);
      add_all(assumption.right);
    }
    return symbols;
  }

  std::vector<ExprId> known_sides() {
    const std::set<SymbolId> reached = symbols_of(prepare(tree_, names_, claim_.equation).question);
    std::vector<ExprId> sides;
    const auto add_known = [&](const std::optional<Equation>& equation) {
      if (!equation || !is_known(equation->left, reached) || !is_known(equation->right, reached)) return;
      sides.insert(sides.end(), {equation->left, equation->right});
    };
    for (const Candidate& candidate : candidates_) add_known(candidate.equation);
    for (const Offered& term : offered_) add_known(term.equation);
    return sides;
  }

  /// `sides`: what is to be compared beyond what the claim speaks of.
  void look_at_samples(const std::vector<ExprId>& sides) {
    Prepared prepared = prepare(tree_, names_, claim_.equation, 0, Precision::exact, 0, sides);
    if (speaks_of_derivatives(prepared))
      prepared = prepare(tree_, names_, claim_.equation, 1, Precision::exact, 0, sides);
    Screen screen(prepared.question, sides, screening);
    std::vector<Equation> equations;
    for (const Candidate& candidate : candidates_)
      equations.push_back(candidate.equation.value_or(claim_.equation));
    const std::vector<bool> passing = passing_of(equations, screen);
    for (std::size_t k = 0; k < passing.size(); ++k)
      candidates_[k].holds = passing[k] && candidates_[k].equation.has_value();
    compare_terms(screen);
  }

  /// left − right = c · term says what becomes of each term, and which terms are missing.
  void compare_terms(Screen& screen) {
    std::vector<Equation> terms;
    std::vector<const Offered*> compared;
    for (const Offered& term : offered_) {
      if (!term.equation || !screen.can_compare(*term.equation)) continue;
      terms.push_back(*term.equation);
      compared.push_back(&term);
    }
    const auto multiples = screen.multiples(claim_.equation, terms);
    for (std::size_t k = 0; k < multiples.size(); ++k) {
      const auto ratio = multiples[k] ? coefficient_from(*multiples[k]) : std::nullopt;
      if (ratio)
        offer(compared[k]->side, compared[k]->which, compared[k]->tokens, *ratio, compared[k]->further);
    }
  }

  /// Nearly equal: both the zeroth and the first order hold on samples.
  void look_at_orders() {
    for (Candidate& candidate : candidates_) candidate.holds = candidate.equation.has_value();
    for (const int order : {0, 1}) {
      const auto at_order = [&](const Equation& equation) {
        return prepare(tree_, names_, equation, 0, Precision::small_order, order).question;
      };
      std::vector<Equation> parts;
      for (const Candidate& candidate : candidates_)
        parts.push_back(at_order(candidate.equation.value_or(claim_.equation)).claim);
      const Question original = at_order(claim_.equation);
      Screen screen(original, {}, screening);
      const std::vector<bool> passing = passing_of(parts, screen);
      for (std::size_t k = 0; k < passing.size(); ++k)
        candidates_[k].holds = candidates_[k].holds && passing[k];
    }
  }

  std::optional<Equation> equation_of(const Candidate& candidate) {
    const auto typed = read(candidate.tokens);
    if (!typed) return std::nullopt;
    const Typed& other = *reading_->sides[wrong_.which + 1 - candidate.side].typed;
    const auto claim = reading_->claim(chain_, wrong_.which, candidate.side == 0 ? *typed : other,
                                       candidate.side == 0 ? other : *typed, wrong_.first_order, ignored_);
    return claim ? std::optional(claim->equation) : std::nullopt;
  }

  std::vector<Repair> prove_the_nearest() {
    std::erase_if(candidates_, [](const Candidate& candidate) { return !candidate.holds; });
    sort_candidates();
    remove_trivial();
    std::vector<Repair> repairs;
    std::size_t judged = 0;
    int nearest = 0;
    for (const Candidate& candidate : candidates_) {
      const bool far = !repairs.empty() && candidate.distance > nearest + widest_choice;
      if (far || repairs.size() == most_repairs || judged++ == most_judged) break;
      if (!is_proved(candidate)) continue;
      if (repairs.empty()) nearest = candidate.distance;
      repairs.push_back({candidate.side == 0, statement_of(candidate), candidate.change});
    }
    return repairs;
  }

  static std::vector<bool> passing_of(const std::vector<Equation>& equations, Screen& screen) {
    std::vector<Equation> comparable;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < equations.size(); ++k) {
      if (!screen.can_compare(equations[k])) continue;
      comparable.push_back(equations[k]);
      places.push_back(k);
    }
    const std::vector<bool> passing = screen.passing(comparable);
    std::vector<bool> all(equations.size(), false);
    for (std::size_t k = 0; k < places.size(); ++k) all[places[k]] = passing[k];
    return all;
  }

  void sort_candidates() {
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  }

  /// Twice the same, or `a = a`.
  void remove_trivial() {
    std::set<std::string> known;
    std::erase_if(candidates_, [&](const Candidate& candidate) {
      const std::string text = bare_text(candidate.tokens);
      const std::string other = bare_text(side(1 - candidate.side));
      return text == other || text == bare_text(side(candidate.side)) ||
             !known.insert(fmt::format("{} {}", candidate.side, text)).second;
    });
  }

  static std::string bare_text(TokenView tokens) {
    Tokens bare(tokens.begin(), tokens.end());
    std::erase_if(bare, [](const Token& token) { return is_blank(token) || is_spacing(token); });
    return text_of(bare);
  }

  /// As it would be read in the place of what was written.
  bool is_proved(const Candidate& candidate) {
    ParsedChain chain = chain_;
    const std::size_t place = wrong_.which + candidate.side;
    chain.written.sides[place].tokens = candidate.tokens;
    chain.sides[place] = parse_side(candidate.tokens, chain.written.sides[place].span, syntax_);
    const auto reading = read_chain(syntax_, tree_, names_, chain);
    if (!reading->sides[wrong_.which].typed || !reading->sides[wrong_.which + 1].typed) return false;
    Diagnostics mismatches;
    const auto claim = reading->claim(chain, wrong_.which, wrong_.first_order, mismatches);
    if (!claim || !mismatches.empty()) return false;
    const Judgement judgement = judge(tree_, names_, *claim, brief);
    return judgement.verdict == Verdict::proved && judgement.diagnostics.empty();
  }

  std::string statement_of(const Candidate& candidate) const {
    const std::string changed = text_of(candidate.tokens);
    const std::string other = text_of(side(1 - candidate.side));
    return fmt::format("{} {} {}", candidate.side == 0 ? changed : other,
                       chain_.written.relations[wrong_.which].text, candidate.side == 0 ? other : changed);
  }

  ExprTree& tree_;
  Names& names_;
  const WrongStep& wrong_;
  SyntaxTree syntax_;
  std::vector<Tokens> sides_;
  std::vector<SyntaxId> syntax_of_;
  ParsedChain chain_;
  std::unique_ptr<ChainReading> reading_;
  Claim claim_;
  Diagnostics ignored_;
  std::vector<Offered> offered_;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<Repair> nearest_true_statements(ExprTree& tree, Names& names, const WrongStep& wrong) {
  return Repairing(tree, names, wrong).search();
}

}  // namespace rigor
