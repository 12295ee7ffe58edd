// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair/missing_condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "base/among.h"
#include "check/meaning/identity_reading.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "check/verdict/chain_reading.h"
#include "expr/calculus/differentiate.h"
#include "latex/parse/parse.h"

namespace rigor {
namespace {

constexpr std::size_t most_tried = 40;

/// A condition as LaTeX; small: the step is to hold to first order in it.
struct Condition {
  std::string latex;
  bool small = false;
};

/// What the symbols behind a claim allow to be said.
class Conditions {
 public:
  Conditions(const ExprTree& tree, std::vector<SymbolId> symbols, std::string particle, bool order)
      : tree_(tree), symbols_(std::move(symbols)), particle_(std::move(particle)), order_(order) {}

  std::vector<Condition> all() {
    centres_of_mass();
    if (order_) bounds();
    tensors();
    matrices();
    for (const Symbol* vector : of_rank(1, false)) given("|{}| = 1", vector->name);
    rates();
    numbers();
    vectors();
    weights();
    for (const Symbol* scalar : of_rank(0, false)) add(scalar->name, true);
    return std::move(conditions_);
  }

 private:
  void add(std::string latex, bool small = false) {
    const bool known =
        std::ranges::any_of(conditions_, [&](const Condition& each) { return each.latex == latex; });
    if (!known && conditions_.size() < most_tried) conditions_.push_back({std::move(latex), small});
  }
  template <class... Names>
  void given(const char* form, const Names&... names) {
    add(fmt::format(fmt::runtime(form), names...));
  }

  /// Symbols that are no derivatives.
  std::vector<const Symbol*> of_rank(int rank, bool per_particle) const {
    std::vector<const Symbol*> found;
    for (const SymbolId id : symbols_) {
      const Symbol& symbol = tree_.symbols[id];
      const bool plain = !symbol.derivation && !symbol.rotation && !symbol.unit && !symbol.is_fixed() &&
                         symbol.unsized == Unsized::none;
      if (plain && symbol.rank == rank && symbol.per_particle == per_particle) found.push_back(&symbol);
    }
    return found;
  }

  static bool is_vector_name(const Symbol& symbol) { return symbol.name.starts_with('\\'); }

  void centres_of_mass() {
    for (const Symbol* mass : of_rank(0, true)) {
      for (const Symbol* place : of_rank(1, true)) {
        if (is_vector_name(*place))
          add(fmt::format("\\sum_{0} {1}_{0} {2}_{0} = 0", particle_, mass->name, place->name));
      }
    }
  }

  void bounds() {
    for (const Symbol* scalar : of_rank(0, false)) given("{} > 0", scalar->name);
    const std::vector<const Symbol*> scalars = of_rank(0, false);
    for (const Symbol* a : scalars) {
      for (const Symbol* b : scalars) {
        if (a != b && are_of_one_family(*a, *b)) given("{} < {}", a->name, b->name);
      }
    }
    for (const Symbol* scalar : scalars) given("{} \\ne 0", scalar->name);
    for (const Symbol* vector : of_rank(1, false)) {
      if (is_vector_name(*vector)) given("{} \\ne 0", vector->name);
    }
  }

  void tensors() {
    for (const Symbol* tensor : of_rank(2, false)) {
      const std::string& name = tensor->name;
      if (name.find_first_of("_^") != std::string::npos) continue;
      if (!tensor->symmetric) {
        given("{0}_{{ij}} = {0}_{{ji}}", name);
        given("{0}_{{ij}} = -{0}_{{ji}}", name);
        given("{0}_{{ki}}{0}_{{kj}} = \\delta_{{ij}}", name);
      } else {
        given("{0}_{{12}} = {0}_{{23}} = {0}_{{31}} = 0", name);
      }
    }
  }

  /// Of any size.
  void matrices() {
    std::vector<std::string> names;
    for (const SymbolId id : symbols_) {
      const Unsized kind = tree_.symbols[id].unsized;
      if (kind != Unsized::none && kind != Unsized::column) names.push_back(tree_.symbols[id].name);
    }
    for (const std::string& name : names) {
      given("{0}^T = {0}", name);
      given("{0}^T = -{0}", name);
      given("{0}^T{0} = 1", name);
    }
    for (std::size_t a = 0; a < names.size() && names.size() <= 3; ++a) {
      for (std::size_t b = a + 1; b < names.size(); ++b) given("{0}{1} = {1}{0}", names[a], names[b]);
    }
  }

  /// I_1 and I_2: one letter with different labels.
  static bool are_of_one_family(const Symbol& a, const Symbol& b) {
    const std::size_t at = a.name.find_first_of("_^");
    return at != std::string::npos && a.name.substr(0, at) == b.name.substr(0, b.name.find_first_of("_^"));
  }

  void rates() {
    for (const SymbolId id : symbols_) {
      const Symbol& rate = tree_.symbols[id];
      if (rate.order(By::time) == 0 || rate.order(By::space) > 0) continue;
      const Symbol& base = tree_.symbols[rate.derivation->base];
      if (base.rank > 1 || base.rotation || (base.rank == 1 && !is_vector_name(base))) continue;
      const std::string label = base.per_particle ? "_" + particle_ : "";
      add(fmt::format("\\dot{{{}}}{} = 0", base.name, label));
    }
  }

  void numbers() {
    const std::vector<const Symbol*> scalars = of_rank(0, false);
    for (std::size_t a = 0; a < scalars.size(); ++a) {
      for (std::size_t b = a + 1; b < scalars.size(); ++b) {
        if (are_of_one_family(*scalars[a], *scalars[b])) given("{} = {}", scalars[a]->name, scalars[b]->name);
      }
    }
  }

  /// Probabilities and fractions: all of them, or two that are each other's rest.
  void weights() {
    for (const Symbol* weight : of_rank(0, true))
      add(fmt::format("\\sum_{0} {1}_{0} = 1", particle_, weight->name));
    const bool latin = particle_.size() == 1;
    for (const Symbol* weight : of_rank(1, false)) {
      if (latin && !is_vector_name(*weight))
        add(fmt::format("\\sum_{0} {1}_{0} = 1", particle_, weight->name));
    }
    const std::vector<const Symbol*> scalars = of_rank(0, false);
    if (scalars.size() > 4) return;
    for (std::size_t a = 0; a < scalars.size(); ++a) {
      for (std::size_t b = a + 1; b < scalars.size(); ++b)
        given("{} + {} = 1", scalars[a]->name, scalars[b]->name);
    }
  }

  void vectors() {
    std::vector<const Symbol*> vectors = of_rank(1, false);
    std::erase_if(vectors, [](const Symbol* vector) { return !is_vector_name(*vector); });
    if (vectors.size() > 4) vectors.resize(4);
    for (std::size_t a = 0; a < vectors.size(); ++a) {
      for (std::size_t b = a + 1; b < vectors.size(); ++b) {
        given("{}\\cdot{} = 0", vectors[a]->name, vectors[b]->name);
        given("{}\\times{} = 0", vectors[a]->name, vectors[b]->name);
      }
    }
  }

  const ExprTree& tree_;
  std::vector<SymbolId> symbols_;
  std::string particle_;
  bool order_;
  std::vector<Condition> conditions_;
};

class ConditionSearch {
 public:
  ConditionSearch(ExprTree& tree, Names& names, const WrongStep& wrong, DecisionCache* cache,
                  bool with_all_terms)
      : tree_(tree), names_(names), cache_(cache), with_all_terms_(with_all_terms), chain_(wrong.parsed) {
    for (std::size_t k = 0; k < chain_.sides.size(); ++k)
      chain_.sides[k] = parse_side(chain_.written.sides[k].tokens, chain_.written.sides[k].span, syntax_);
    reading_ = read_chain(syntax_, tree, names, chain_, wrong.rules);
    const auto text = [&](std::size_t side) { return text_of(chain_.written.sides[side].tokens); };
    written_ = fmt::format("{} {} {}", text(wrong.which), chain_.written.relations[wrong.which].text,
                           text(wrong.which + 1));
    if (reading_->sides[wrong.which].typed && reading_->sides[wrong.which + 1].typed)
      claim_ = reading_->claim(chain_, wrong.which, wrong.first_order, ignored_);
  }

  std::vector<std::string> run() {
    std::vector<std::string> found;
    if (!claim_) return found;
    const Names before = names_;
    const bool order = claim_->equation.relation != Relation::equal;
    for (const Condition& condition : Conditions(tree_, symbols(), particle_letter(), order).all()) {
      if (condition.latex == written_) continue;
      const bool holds =
          condition.small ? holds_to_first_order(condition.latex) : holds_given(condition.latex);
      if (holds)
        found.push_back(condition.small ? fmt::format("{} is small, to first order", condition.latex)
                                        : condition.latex);
      names_ = before;
      if (found.size() == most_conditions) break;
    }
    return found;
  }

 private:
  std::vector<SymbolId> symbols() {
    const Question question = prepare(tree_, names_, claim_->equation).question;
    std::vector<SymbolId> all;
    const auto add = [&](SymbolId symbol) {
      if (!is_one_of(symbol, all)) all.push_back(symbol);
    };
    for (const ExprId side : {claim_->equation.left, claim_->equation.right}) {
      for (const SymbolId symbol : symbols_in(tree_, side)) {
        if (definition_of(names_.scope, symbol) == nullptr) add(symbol);
      }
      for (const SymbolId symbol : primitive_symbols(question, side)) {
        add(symbol);
        add(base_of(tree_.symbols, symbol));
      }
    }
    return all;
  }

  std::string particle_letter() const {
    if (const auto at = written_.find("\\sum_"); at != std::string::npos && at + 5 < written_.size()) {
      const std::string_view behind = std::string_view(written_).substr(at + 5);
      if (behind[0] >= 'a' && behind[0] <= 'z') return std::string(behind.substr(0, 1));
      if (behind.size() > 2 && behind[0] == '{' && behind[2] == '}') return std::string(behind.substr(1, 1));
    }
    const auto& summed = names_.symbols.sightings->summed_greek;
    return summed.empty() ? "\\alpha" : *summed.begin();
  }

  std::optional<ParsedChain> parsed(const std::string& latex) {
    const FileId file = sources_.add("condition", latex);
    texts_.push_back(lex(sources_, {file, 0, static_cast<std::uint32_t>(latex.size())}));
    std::vector<ParsedChain> chains = parse_chains(texts_.back(), "", syntax_, ignored_);
    return chains.size() == 1 ? std::optional(std::move(chains[0])) : std::nullopt;
  }

  bool assume(const std::string& latex) {
    const auto chain = parsed(latex);
    if (!chain) return false;
    const auto reading = read_chain(syntax_, tree_, names_, *chain);
    for (std::size_t k = 0; k < chain->written.relations.size(); ++k) {
      if (!reading->sides[k].typed || !reading->sides[k + 1].typed) return false;
      Diagnostics mismatches;
      const auto given = reading->claim(*chain, k, false, mismatches);
      if (!given || !mismatches.empty()) return false;
      rigor::assume(names_.scope, {given->equation, {latex, {}, std::nullopt}, 0});
    }
    return true;
  }

  bool holds_given(const std::string& latex) {
    if (!assume(latex)) return false;
    const Judgement judgement = judge(tree_, names_, *claim_, limits_of_guesses, cache_);
    return says_something(judgement) && !(with_all_terms_ && makes_a_term_vanish()) &&
           sample_of_assumptions(tree_, names_, {}, limits_of_guesses, cache_).has_value();
  }

  /// Who means `\mathbf{A}\cdot\mathbf{B} = 0` does not write `\mathbf{C}(\mathbf{A}\cdot\mathbf{B})`.
  bool makes_a_term_vanish() {
    const auto vanishes = [&](ExprId term) {
      if (tree_.is_zero_literal(term)) return false;
      Claim claim = *claim_;
      claim.equation.left = term;
      claim.equation.right = zero_of_rank(tree_, tree_[term].span, tree_[term].rank, tree_[term].axes);
      return judge(tree_, names_, claim, limits_of_guesses, cache_).verdict == Verdict::proved;
    };
    return std::ranges::any_of(std::array{claim_->equation.left, claim_->equation.right}, [&](ExprId side) {
      if (tree_[side].op != Op::add) return false;
      const std::vector<ExprId> terms(tree_.children(side).begin(), tree_.children(side).end());
      return std::ranges::any_of(terms, vanishes);
    });
  }

  bool holds_to_first_order(const std::string& latex) {
    if (claim_->nearly || claim_->equation.relation != Relation::equal) return false;
    const auto chain = parsed(latex);
    if (!chain || chain->sides.size() != 1) return false;
    const auto reading = read_chain(syntax_, tree_, names_, *chain);
    if (!reading->sides[0].typed || !reading->sides[0].typed->free.empty()) return false;
    const ExprNode& quantity = tree_[reading->sides[0].typed->id];
    if (quantity.op != Op::symbol || vanishes_without(quantity.symbol)) return false;
    declare_small(names_.scope, {.quantity = reading->sides[0].typed->id});
    Claim nearly = *claim_;
    nearly.nearly = true;
    return says_something(judge(tree_, names_, nearly, limits_of_guesses, cache_));
  }

  /// Where both sides are proportional to what is small, it says nothing.
  bool vanishes_without(SymbolId symbol) {
    Question question = prepare(tree_, names_, claim_->equation).question;
    question.zeroed.push_back(symbol);
    const Decision decision = decide(cache_, question, limits_of_guesses);
    return decision.outcome != Outcome::proved || decision.vanishes;
  }

  static bool says_something(const Judgement& judgement) {
    return judgement.verdict == Verdict::proved && judgement.diagnostics.empty();
  }

  ExprTree& tree_;
  Names& names_;
  DecisionCache* cache_;
  bool with_all_terms_;
  ParsedChain chain_;
  SyntaxTree syntax_;
  SourceMap sources_;
  std::vector<Tokens> texts_;
  std::unique_ptr<ChainReading> reading_;
  Diagnostics ignored_;
  std::optional<Claim> claim_;
  std::string written_;  // the step itself
};

}  // namespace

bool is_sum_of_weights(const std::string& condition) {
  if (!condition.starts_with("\\sum") || !condition.ends_with("= 1")) return false;
  for (const std::string_view letter :
       {" p_", " P_", " w_", " W_", " f_", " c_", " x_", " \\pi_", " \\lambda_", " \\rho_"}) {
    if (condition.find(letter) != std::string::npos) return true;
  }
  return false;
}

std::vector<std::string> missing_conditions(const ExprTree& tree, const Names& names, const WrongStep& wrong,
                                            DecisionCache* cache, bool with_all_terms) {
  ExprTree own_tree = tree;
  Names own_names = names;
  return ConditionSearch(own_tree, own_names, wrong, cache, with_all_terms).run();
}

}  // namespace rigor
