// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/borrowed.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/among.h"
#include "base/ascii.h"
#include "check/doubt/one_direction.h"
#include "check/doubt/special_definitions.h"
#include "check/prose/restrictions.h"
#include "check/question/base_letters.h"
#include "check/question/decision_cache.h"
#include "check/question/granted.h"
#include "check/verdict/law_diagnostic.h"
#include "check/word/contrary_words.h"
#include "check/word/number_words.h"
#include "check/word/prose_words.h"
#include "elaborate/name/function_value.h"
#include "elaborate/symbol/named_symbol.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

bool is_open(const Judgement& judgement) {
  return judgement.verdict == Verdict::law || judgement.verdict == Verdict::refuted ||
         judgement.verdict == Verdict::undecided;
}

class Heeding {
 public:
  Heeding(ExprTree& tree, const Names& names, const Claim& claim, Judgement judgement, const Standpoint& at,
          DecisionCache* cache)
      : tree_(tree),
        names_(names),
        claim_(claim),
        judgement_(std::move(judgement)),
        at_(at),
        sentence_(at.beside().lead + " " + at.beside().tail),
        cache_(cache) {}

  Judgement heed() {
    if (!is_open(judgement_) || claim_.recorded != nullptr) return std::move(judgement_);
    const std::vector<const Fact*> bearing = facts_that_bear();
    if (proves_with(bearing) || judgement_.verdict != Verdict::refuted) return std::move(judgement_);
    if (is_of_numbers()) {
      restricted_as_numbers();
      return std::move(judgement_);
    }
    if (restricted_by_words() || holds_with(bearing) || rests_on_borrowed() ||
        restricted_by_what_stands_around() || restricted_to_one_direction())
      return std::move(judgement_);
    return std::move(judgement_);
  }

 private:
  std::set<SymbolId> letters_of(const Equation& equation) const {
    return base_letters(tree_, names_.scope, equation);
  }

  /// Does the fact integrate what the statement has nothing of? It can have any value there.
  bool integrates_something_else(const Fact& fact, const std::set<SymbolId>& of_claim) const {
    return std::ranges::any_of(letters_of(fact.equation), [&](SymbolId letter) {
      const auto& integral = tree_.symbols[letter].integral;
      return integral && !of_claim.contains(letter) &&
             std::ranges::any_of(letters_in(tree_, integral->integrand), [&](SymbolId inside) {
               return inside != integral->variable && !tree_.symbols[inside].is_fixed() &&
                      !of_claim.contains(inside);
             });
    });
  }

  /// Is it about one value of a letter that runs here? The energy up to R does not depend on where r is, be
  /// it a length or not.
  bool is_about_what_runs(const Fact& fact, const std::set<SymbolId>& of_claim) const {
    const auto letter_of = [&](SymbolId symbol) {
      const NameKey* key = key_of(names_.symbols, symbol);
      return key == nullptr ? std::string{} : key->base;
    };
    const std::set<SymbolId> letters = letters_of(fact.equation);
    return std::ranges::any_of(of_claim, [&](SymbolId claimed) {
      const auto& integral = tree_.symbols[claimed].integral;
      if (!integral || of_claim.contains(integral->variable)) return false;
      const std::string running = letter_of(integral->variable);
      return std::ranges::any_of(letters, [&](SymbolId letter) {
        return is_one_of(letter_of(letter), {running, bold(running)});
      });
    });
  }

  /// What facts restrict. `r = R` next to a statement without r restricts nothing, since some r is equal to
  /// R, if R is not negative where r is a length.
  std::vector<Fact> restrictions(std::vector<Fact> facts) const {
    const std::set<SymbolId> of_claim = letters_of(claim_.equation);
    std::erase_if(facts, [&](const Fact& fact) {
      return integrates_something_else(fact, of_claim) || is_about_what_runs(fact, of_claim);
    });
    for (std::size_t k = 0; k < facts.size();) {
      const Equation said = facts[k].equation;
      const bool names_left = is_met_only_in(facts, k, said.left, said.right);
      if (!names_left && !is_met_only_in(facts, k, said.right, said.left)) {
        ++k;
        continue;
      }
      const ExprId named = names_left ? said.left : said.right;
      if (tree_[named].op == Op::symbol) {
        facts.erase(facts.begin() + static_cast<std::ptrdiff_t>(k));
      } else {
        facts[k].equation = {.left = tree_.add_number(tree_[named].span, "0"),
                             .right = names_left ? said.right : said.left,
                             .relation = Relation::less_or_equal};
      }
      k = 0;  // now another letter may be met only once
    }
    return facts;
  }

  /// Is the side a letter, or the length of a vector, of which nothing but this fact speaks?
  bool is_met_only_in(const std::vector<Fact>& facts, std::size_t k, ExprId side, ExprId other) const {
    const ExprId inside = tree_[side].op == Op::length ? tree_.children(side)[0] : side;
    if (facts[k].equation.relation != Relation::equal || tree_[inside].op != Op::symbol ||
        tree_[inside].slot_count > 0)
      return false;
    const SymbolId letter = tree_[inside].symbol;
    const Symbol& symbol = tree_.symbols[letter];
    const bool free = !symbol.derivation && !symbol.is_fixed() && !symbol.per_particle &&
                      !is_function_value(names_, tree_, letter) &&
                      definition_of(names_.scope, letter) == nullptr;
    if (!free || is_one_of(letter, symbols_in(tree_, other)) || letters_of(claim_.equation).contains(letter))
      return false;
    for (std::size_t each = 0; each < facts.size(); ++each) {
      if (each != k && letters_of(facts[each].equation).contains(letter)) return false;
    }
    return true;
  }

  std::vector<const Fact*> facts_that_bear() const {
    std::set<SymbolId> reached = letters_of(claim_.equation);
    std::vector<const Fact*> bearing;
    for (bool grew = true; grew;) {
      grew = false;
      for (const Fact& fact : at_.facts) {
        if (is_one_of(&fact, bearing)) continue;
        const std::set<SymbolId> letters = letters_of(fact.equation);
        const bool meets =
            std::ranges::any_of(letters, [&](SymbolId letter) { return reached.contains(letter); });
        if (!meets) continue;
        bearing.push_back(&fact);
        reached.insert(letters.begin(), letters.end());
        grew = true;
      }
    }
    return bearing;
  }

  Judgement ask(const Names& names, const Claim& claim) {
    Judgement judgement = judge(tree_, names, claim, {}, cache_);
    judgement_.used.insert(judgement.used.begin(), judgement.used.end());
    return judgement;
  }

  /// Letters that only the facts have: m of `m\mathbf v_1 + m\mathbf v_2 = 0`. Nobody who writes them means
  /// 0.
  std::set<SymbolId> factors_of(const std::vector<const Fact*>& facts) const {
    const std::set<SymbolId> own = base_letters(tree_, names_.scope, claim_.equation);
    std::set<SymbolId> factors;
    for (const Fact* fact : facts) {
      for (const SymbolId letter : base_letters(tree_, names_.scope, fact->equation)) {
        const Symbol& symbol = tree_.symbols[letter];
        const bool number =
            symbol.rank == 0 && !symbol.per_particle && !symbol.is_fixed() && !symbol.integral;
        if (number && !own.contains(letter) && definition_of(names_.scope, letter) == nullptr)
          factors.insert(letter);
      }
    }
    return factors;
  }

  /// `nonzero`: letters that do not vanish.
  Judgement judge_with(const std::vector<const Fact*>& facts, const std::set<SymbolId>& nonzero = {}) {
    Names names = names_;
    for (const SymbolId letter : nonzero) {
      const Span span = claim_.relation;
      const Equation condition{.left = tree_.add({.op = Op::symbol, .span = span, .symbol = letter}),
                               .right = tree_.add_number(span, "0"),
                               .relation = Relation::unequal};
      assume(names.scope,
             {condition, Origin{"convention: what is divided by is not 0", {}, std::nullopt}, 0});
    }
    for (const Fact* fact : facts) {
      Origin origin{fact->text, {}, std::nullopt};
      if (fact->proves) {
        take_for_granted(tree_, names, fact->equation, std::move(origin), fact->at_instant);
      } else {
        assume(names.scope, {fact->equation, std::move(origin), 0, fact->at_instant});
      }
    }
    Judgement judgement = ask(names, claim_);
    // From what cannot be, anything follows.
    if (judgement.verdict == Verdict::proved && !sample_of_assumptions(tree_, names, {}, {}, cache_))
      judgement.verdict = Verdict::undecided;
    return judgement;
  }

  bool proves_with(const std::vector<const Fact*>& bearing) {
    std::vector<const Fact*> proving;
    std::copy_if(bearing.begin(), bearing.end(), std::back_inserter(proving),
                 [](const Fact* fact) { return fact->proves; });
    if (proving.empty()) return false;
    Judgement other = judge_with(proving);
    if (other.verdict != Verdict::proved) return false;
    other.used = std::move(judgement_.used);
    judgement_ = std::move(other);
    return true;
  }

  void withdraw(DiagnosticKind kind, std::string message, std::vector<Label> labels,
                std::vector<std::string> help) {
    judgement_.verdict = Verdict::undecided;
    judgement_.counterexample.reset();
    judgement_.sample.reset();
    judgement_.diagnostics = {
        {kind, claim_.relation, std::move(message), std::move(labels), std::move(help)}};
  }

  bool is_meant_for_all() const { return rigor::is_meant_for_all(tree_, names_, claim_); }

  bool restricted_by_words() {
    auto word = word_that_demands(at_.beside().lead);
    if (!word) word = word_of_a_special_case(sentence_);
    if (!word) word = at_.denied;
    if (word) return restricted_by(*word, "its sentence");
    if (!is_meant_for_all()) {
      word = word_of_a_special_heading(at_.heading);  // "Incompressible flow"
      if (!word) word = restriction_in_heading(at_.heading);
      if (word) return restricted_by(*word, "its heading");
    }
    if (at_.unread.empty()) return false;
    withdraw(DiagnosticKind::restricted,
             fmt::format("it does not hold for all values, and `{}` next to it is not read", at_.unread), {},
             {"`rigor: claim …` asks whether it holds for all values"});
    return true;
  }

  /// Numbers, or matrices of numbers, which the page may have given letters.
  bool is_of_numbers() const {
    const std::vector<ExprId> nodes = nodes_below(tree_, {claim_.equation.left, claim_.equation.right});
    const bool matrices = std::ranges::any_of(nodes, [this](ExprId id) { return tree_[id].op == Op::tuple; });
    const bool plain = std::ranges::all_of(
        nodes, [&](ExprId id) { return tree_[id].slot_count == 0 && (matrices || tree_[id].rank == 0); });
    return plain &&
           std::ranges::all_of(base_letters(tree_, names_.scope, claim_.equation), [&](SymbolId letter) {
             const Symbol& symbol = tree_.symbols[letter];
             return symbol.is_fixed() || symbol.integral ||
                    (matrices && definition_of(names_.scope, letter) != nullptr);
           });
  }

  /// `70/24 = 36/12`, `\mathrm{1\,h} = \mathrm{100\,min}`, `\int_0^1x\,dx = 1`.
  void restricted_as_numbers() {
    auto word = word_that_demands(at_.beside().lead);
    if (!word) word = at_.denied;
    if (!word) word = word_on_numbers(sentence_);
    if (word) {
      restricted_by(*word, "its sentence");
      return;
    }
    const bool integrates =
        std::ranges::any_of(base_letters(tree_, names_.scope, claim_.equation),
                            [&](SymbolId each) { return tree_.symbols[each].integral.has_value(); });
    if (integrates) return;  // digits can be of another base, and bytes logical
    if (const std::string& arithmetic = names_.symbols.evidence->other_arithmetic; !arithmetic.empty()) {
      restricted_by(arithmetic, "its section");
    } else if (auto heading = word_on_numbers(at_.heading)) {
      restricted_by(*heading, "its heading");
    } else if (at_.around) {
      if (const auto around = word_on_numbers(at_.around->word)) restricted_by(*around, at_.around->where);
    }
  }

  /// Restricted by words outside the closed lists: asked last, since the others say more.
  bool restricted_by_what_stands_around() {
    if (auto word = restriction_in_sentence(sentence_)) return restricted_by(*word, "its sentence");
    if (at_.around && !is_meant_for_all()) return restricted_by(at_.around->word, at_.around->where);
    return false;
  }

  /// Restricted by no words, but by how vectors are written where there is no figure.
  bool restricted_to_one_direction() {
    if (is_meant_for_all()) return false;
    const std::vector<SymbolId> vectors = lengths_or_components(tree_, claim_.equation);
    if (!vectors.empty() && !fails_for_numbers()) {
      withdraw(DiagnosticKind::restricted,
               fmt::format("it does not hold for all directions of {}; the plain letters can be lengths, or "
                           "components along one direction",
                           quoted_names(tree_, vectors)),
               {}, {meant_for_all()});
      return true;
    }
    if (!may_be_in_the_plane(tree_, *names_.symbols.evidence, claim_.equation)) return false;
    withdraw(
        DiagnosticKind::restricted,
        "it does not hold in space, and nothing in this section has a third component: it may be meant in "
        "the plane",
        {}, {meant_for_all()});
    return true;
  }

  bool fails_for_numbers() {
    const auto equation = with_numbers_for_lengths(tree_, claim_.equation);
    if (!equation) return false;
    Claim numbers = claim_;
    numbers.equation = *equation;
    return judge(tree_, names_, numbers, {}, cache_).verdict == Verdict::refuted;
  }

  /// The directive that says so of all letters that stand open.
  std::string meant_for_all() const {
    std::vector<std::string> open;
    for (const SymbolId letter : letters_of(claim_.equation)) {
      if (!is_for_all(names_.scope, letter) && definition_of(names_.scope, letter) == nullptr)
        open.push_back(tree_.symbols[letter].name);
    }
    return fmt::format("if all values are meant, `rigor: for all {}` says so", fmt::join(open, ", "));
  }

  /// "To first order", "for small x" next to `\approx` restrict nothing where something is declared small:
  /// they only say what the sign means.
  bool says_what_is_asked(std::string_view word) const {
    return claim_.nearly && !names_.scope.small.empty() &&
           (word.find("small") != std::string_view::npos || word.find("order") != std::string_view::npos);
  }

  bool restricted_by(const std::string& word, std::string_view where) {
    if (says_what_is_asked(word)) return false;
    withdraw(DiagnosticKind::restricted,
             fmt::format("it does not hold for all values, and `{}` in {} may restrict it", word, where), {},
             {"`rigor: claim …` asks whether it holds for all values"});
    return true;
  }

  /// A sample that meets what is stated, of the letters of the statement alone: it refutes that for itself.
  void keep_what_is_asked(Counterexample& example) const {
    using Values = std::vector<Counterexample::Value>;
    const auto is_one_of = [](const Values& values, const Counterexample::Value& value) {
      return std::ranges::any_of(values, [&](const Counterexample::Value& each) {
        return each.symbol == value.symbol && each.rank == value.rank &&
               (each.particle > 0) == (value.particle > 0);
      });
    };
    const Counterexample& asked = *judgement_.counterexample;
    std::copy_if(example.follows.begin(), example.follows.end(), std::back_inserter(example.values),
                 [&](const Counterexample::Value& value) { return is_one_of(asked.values, value); });
    std::erase_if(example.values, [&](const auto& value) { return !is_one_of(asked.values, value); });
    std::erase_if(example.follows, [&](const auto& value) { return !is_one_of(asked.follows, value); });
    if (asked.particles == 0) example.particles = 0;
  }

  /// A directive says it already.
  bool is_in_force(const Fact& fact) {
    Claim said = claim_;
    said.equation = fact.equation;
    return ask(names_, said).verdict == Verdict::proved;
  }

  /// What is stated nearby, as a law or in a line, would make it true, or leave it open.
  bool holds_with(const std::vector<const Fact*>& bearing) {
    std::vector<Fact> said_here;
    for (const Fact* fact : bearing) {
      if (!fact->elsewhere && !is_in_force(*fact)) said_here.push_back(*fact);
    }
    said_here = restrictions(std::move(said_here));
    std::vector<const Fact*> here;
    for (const Fact& each : said_here) here.push_back(&each);
    if (!here.empty() && holds_with_what_is_said_here(here)) return true;
    if (is_meant_for_all()) return false;
    // One at a time: two special cases together prove anything.
    for (const Fact* fact : bearing) {
      if (fact->elsewhere && judge_with({fact}).verdict == Verdict::proved) return may_hold_with({fact});
    }
    return false;
  }

  bool holds_with_what_is_said_here(const std::vector<const Fact*>& bearing) {
    Judgement other = judge_with(bearing);
    const std::set<SymbolId> factors = factors_of(bearing);
    if (other.verdict == Verdict::refuted && !factors.empty()) other = judge_with(bearing, factors);
    if (other.verdict == Verdict::refuted) {
      if (other.counterexample && judgement_.counterexample) keep_what_is_asked(*other.counterexample);
      other.used = std::move(judgement_.used);
      judgement_ = std::move(other);  // on a sample that meets what is stated
      return false;
    }
    return may_hold_with(bearing);
  }

  bool may_hold_with(const std::vector<const Fact*>& bearing) {
    std::vector<Label> labels;
    for (const Fact* fact : bearing) labels.push_back({fact->span, "stated here"});
    withdraw(DiagnosticKind::borrowed,
             fmt::format("it does not hold for all values, but may hold with `{}`", bearing.front()->text),
             std::move(labels), {"`rigor: given …` makes that an assumption"});
    return true;
  }

  /// A definition that is not said for this place, and without which it would not fail.
  bool rests_on_borrowed() {
    const auto case_word = word_of_a_case(sentence_);
    const std::string here = lowered(at_.beside().lead);
    std::optional<std::string> owner;  // another one than that of the definition
    std::vector<NamedDefinition> borrowed;
    for (const NamedDefinition& named : names_.scope.definitions) {
      const bool asked = std::ranges::any_of(judgement_.question.definitions, [&](const Definition& each) {
        return base_of(tree_.symbols, each.symbol) == base_of(tree_.symbols, named.definition.symbol);
      });
      if (!asked || named.origin.directive) continue;
      const bool above = named.origin.event != at_.event;
      const auto another =
          above ? other_owner(lowered(at_.prose.beside[named.origin.event].lead), here) : std::nullopt;
      if (!owner) owner = another;
      const bool in_between = above && (case_word || another);
      const bool of_another = is_case_of_another_paragraph(tree_, at_, named);
      if (is_said_for(at_, named.origin) && !in_between && !of_another) continue;
      if (!is_used_here(at_, names_, named.origin, named.definition.symbol, judgement_.used))
        borrowed.push_back(named);
    }
    if (borrowed.empty()) return false;
    Names without = names_;
    forget_definitions(without.scope, symbols_of(borrowed));
    if (ask(without, claim_).verdict == Verdict::refuted) return false;
    std::vector<Label> labels;
    std::vector<std::string> help;
    for (const NamedDefinition& named : borrowed) {
      labels.push_back({tree_[named.definition.body].span, "borrowed from here"});
      help.push_back(fmt::format("`rigor: use {}` says that it holds here, too",
                                 use_of(names_, tree_, named.definition.symbol)));
    }
    const bool elsewhere = !is_said_for(at_, borrowed.front().origin);
    const bool of_another = !elsewhere && is_case_of_another_paragraph(tree_, at_, borrowed.front());
    withdraw(DiagnosticKind::borrowed,
             of_another ? fmt::format("it fails only with `{}`, which may be meant for another case",
                                      borrowed.front().origin.text)
             : elsewhere
                 ? fmt::format("it fails only with `{}`, which {}", borrowed.front().origin.text,
                               borrowed.front().origin.conditional || borrowed.front().origin.on_its_line
                                   ? "its own sentence may limit to a case"
                                   : "is not said for this section")
                 : fmt::format("it fails only with `{}`, and `{}` in its sentence may mean another case",
                               borrowed.front().origin.text, case_word ? *case_word : *owner),
             std::move(labels), std::move(help));
    return true;
  }

  ExprTree& tree_;
  const Names& names_;
  const Claim& claim_;
  Judgement judgement_;
  const Standpoint& at_;
  std::string sentence_;
  DecisionCache* cache_;
};

}  // namespace

bool is_meant_for_all(const ExprTree& tree, const Names& names, const Claim& claim) {
  if (claim.for_all) return true;
  const std::set<SymbolId> letters = base_letters(tree, names.scope, claim.equation);
  return !letters.empty() && std::ranges::all_of(letters, [&](SymbolId each) {
    return is_for_all(names.scope, each) || definition_of(names.scope, each) != nullptr;
  });
}

bool is_said_for(const Standpoint& at, const Origin& origin) {
  const bool restricted = origin.on_its_line && !origin.only_counts;
  if (restricted || (origin.conditional && origin.event != at.event)) return false;
  return at.prose.sections.reaches(origin.place, at.beside().place);
}

bool is_used_here(const Standpoint& at, const Names& names, const Origin& origin, SymbolId symbol,
                  std::set<std::size_t>& used) {
  const NameKey* key = key_of(names.symbols, symbol);
  for (const UseDirective& use : at.uses) {
    if (!at.prose.sections.reaches(use.place, at.beside().place)) continue;
    const bool by_letter = key != nullptr && is_one_of(key->base, use.letters);
    const bool by_place = std::ranges::any_of(
        use.places, [&](const std::string& place) { return origin.text.ends_with(" " + place); });
    if (!by_letter && !by_place) continue;
    used.insert(use.directive);
    return true;
  }
  return false;
}

std::string use_of(const Names& names, const ExprTree& tree, SymbolId symbol) {
  const SymbolId base = base_of(tree.symbols, symbol);
  const NameKey* key = key_of(names.symbols, base);
  return key == nullptr ? tree.symbols[base].name : key->base;
}

Judgement heed_place(ExprTree& tree, const Names& names, const Claim& claim, Judgement judgement,
                     const Standpoint& at, DecisionCache* cache) {
  return Heeding(tree, names, claim, std::move(judgement), at, cache).heed();
}

}  // namespace rigor
