// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/screen.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "algebra/parts/real_parts.h"
#include "algebra/sample/refute.h"
#include "algebra/words/operator_question.h"
#include "base/among.h"
#include "base/check.h"

namespace rigor {
namespace {

constexpr std::size_t wanted_points = 3;
constexpr std::uint32_t most_attempts = 24;
constexpr std::uint32_t degenerate_attempts = 2;  // zeros and ones, on which much holds by chance
constexpr std::uint64_t most_steps_enclosed = 400'000;
constexpr int largest_divisor = 12;  // of a multiple that is only enclosed

Limits with_steps(Limits limits, std::uint64_t steps) {
  limits.steps = steps;
  return limits;
}

bool may_be_zero(const Enclosure& value) { return !cln::plusp(value.low) && !cln::minusp(value.high); }

/// The number with the smallest divisor between the bounds, if that is small.
std::optional<Rational> simplest_in(const Enclosure& value) {
  for (int divisor = 1; divisor <= largest_divisor; ++divisor) {
    const Rational nearest = cln::round1((value.low + value.high) * divisor / 2) / Rational(divisor);
    if (value.low <= nearest && nearest <= value.high) return nearest;
  }
  return std::nullopt;
}

}  // namespace

class SampleScreen::Samples {
 public:
  Samples(const Question& question, std::span<const ExprId> also, const Limits& limits)
      : question_(question),
        limits_(limits),
        scope_(question_, Scope::Definitions::unfolded),
        solver_(scope_, all_of(question_.assumptions)),
        reach_(reach(scope_, roots_of(question_, also))),
        evaluator_(scope_, limits_),
        enclosing_(scope_, with_steps(limits_, most_steps_enclosed)),
        tree_size_(question.tree->size()) {
    if (reach_.too_large) return;
    evaluator_.take_circle_number_as_rational();  // what passes is proved afterwards
    enclosing_.enclose();
    const std::uint64_t before = work();
    SampleSequence sequence(scope_.tree(), reach_, solver_.has_particle_sums());
    try {
      while (points_.size() < wanted_points && sequence.drawn() < most_attempts) draw(sequence);
    } catch (const Undecidable&) {
      // with the points that there are
    }
    for (std::vector<SamplePoint>* more : {&enclosed_, &others_}) {
      for (SamplePoint& point : *more) {
        if (points_.size() < wanted_points) points_.push_back(std::move(point));
      }
    }
    work_of_drawing_ = work() - before;
    steps_of_drawing_ = {evaluator_.steps(), enclosing_.steps()};
  }

  /// What others drew, for the tree as it has grown since.
  explicit Samples(const Samples& drawn)
      : question_(drawn.question_),
        limits_(drawn.limits_),
        scope_(question_, Scope::Definitions::unfolded),
        solver_(scope_, {}),
        reach_(drawn.reach_),
        evaluator_(scope_, limits_),
        enclosing_(scope_, with_steps(limits_, most_steps_enclosed)),
        tree_size_(question_.tree->size()),
        points_(drawn.points_),
        work_of_drawing_(drawn.work_of_drawing_),
        steps_of_drawing_(drawn.steps_of_drawing_) {
    evaluator_.take_circle_number_as_rational();
    enclosing_.enclose();
    evaluator_.go_on_from(steps_of_drawing_.first);
    enclosing_.go_on_from(steps_of_drawing_.second);
    for (SamplePoint& point : points_) point.make_room();
    if (limits_.budget != nullptr && !limits_.budget->takes(work_of_drawing_)) points_.clear();
  }
  Samples& operator=(const Samples&) = delete;

  [[nodiscard]] bool can_compare(const Equation& claim) const {
    if (points_.empty()) return false;
    for (const ExprId side : {claim.left, claim.right}) {
      for (const SymbolId symbol : symbols_in(scope_.tree(), side)) {
        if (!is_reached(symbol) && !scope_.is_circle_number(symbol)) return false;
      }
    }
    return true;
  }

  [[nodiscard]] std::vector<Screened> screened(std::span<const Equation> claims) {
    RIGOR_CHECK(scope_.tree().size() == tree_size_, scope_.tree().size(), tree_size_);
    std::vector<std::size_t> compared(claims.size(), 0);
    std::vector<bool> failed(claims.size(), false);
    for (const SamplePoint& point : points_) {
      look_at(point);
      for (std::size_t k = 0; k < claims.size(); ++k) {
        if (failed[k] || !can_compare(claims[k])) continue;
        const auto holds = holds_here(claims[k]);
        if (holds) ++compared[k];
        failed[k] = holds && !*holds;
      }
    }
    std::vector<Screened> found(claims.size(), Screened::not_compared);
    for (std::size_t k = 0; k < claims.size(); ++k) {
      if (compared[k] > 0) found[k] = failed[k] ? Screened::fails : Screened::holds;
    }
    return found;
  }

  [[nodiscard]] std::vector<std::optional<std::string>> multiples(const Equation& claim,
                                                                  std::span<const Equation> terms) {
    RIGOR_CHECK(scope_.tree().size() == tree_size_, scope_.tree().size(), tree_size_);
    std::vector<Multiple> found(terms.size());
    for (const SamplePoint& point : points_) {
      look_at(point);
      const auto difference = residuals(claim);
      if (!difference) continue;
      for (std::size_t k = 0; k < terms.size(); ++k) {
        if (found[k].none || !can_compare(terms[k])) continue;
        const auto values = residuals(terms[k]);
        if (values) compare(*difference, *values, found[k]);
      }
    }
    std::vector<std::optional<std::string>> result(terms.size());
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (!found[k].none && found[k].ratio && !cln::zerop(*found[k].ratio))
        result[k] = to_text(*found[k].ratio);
    }
    return result;
  }

 private:
  [[nodiscard]] static std::vector<std::size_t> all_of(const std::vector<Equation>& assumptions) {
    std::vector<std::size_t> all(assumptions.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }

  [[nodiscard]] static std::vector<ExprId> roots_of(const Question& question, std::span<const ExprId> also) {
    std::vector<ExprId> roots{question.claim.left, question.claim.right};
    for (const Equation& each : question.assumptions) roots.insert(roots.end(), {each.left, each.right});
    roots.insert(roots.end(), also.begin(), also.end());
    return roots;
  }

  struct Multiple {
    bool none = false;
    std::optional<Rational> ratio;
  };

  [[nodiscard]] std::uint64_t work() const { return limits_.budget == nullptr ? 0 : limits_.budget->used(); }

  void draw(SampleSequence& sequence) {
    const std::uint32_t attempt = sequence.drawn();
    const SamplePoint point = sequence.next();
    if (attempt < degenerate_attempts && !reach_.symbols.empty()) return;
    if (reach_.particles && point.particles() < 2) return;
    const bool has_values = keep(point, attempt);
    if (!has_values && enclosed_.size() < wanted_points) keep(made_small(point), attempt);
  }

  /// Has the claim values there? The point is kept if the assumptions can be met.
  bool keep(SamplePoint point, std::uint32_t attempt) {
    try {
      if (!solver_.none() && !solver_.solve(evaluator_, point, attempt)) return false;
    } catch (const PointRejected&) {
      return false;
    }
    evaluator_.look_at(point);
    std::vector<SamplePoint>* kept = &points_;
    try {
      // Where the claim holds by chance, so do its neighbours: ln a = 2 ln a at a = 1.
      if (evaluator_.holds(question_.claim)) kept = &others_;
    } catch (const PointRejected&) {
      kept = has_enclosed_values(point) ? &enclosed_ : &others_;
    }
    if (kept->size() < wanted_points) kept->push_back(std::move(point));
    return kept != &others_;
  }

  /// Do the sides have real values there?
  [[nodiscard]] bool has_enclosed_values(const SamplePoint& point) {
    if (enclosed_.size() == wanted_points) return false;
    enclosing_.look_at(point);
    try {
      static_cast<void>(enclosing_.difference(question_.claim));
      return true;
    } catch (const ValuesTooNear&) {
      return true;
    } catch (const PointRejected&) {
      return false;
    } catch (const Undecidable&) {
      return false;
    }
  }

  void look_at(const SamplePoint& point) {
    evaluator_.look_at(point);
    enclosing_.look_at(point);
  }

  /// Nothing where a side has no value. Values that are not rational are enclosed, and hold where they cannot
  /// be told apart.
  [[nodiscard]] std::optional<bool> holds_here(const Equation& claim) {
    try {
      return evaluator_.holds(claim);
    } catch (const PointRejected&) {
      // enclosed, perhaps
    } catch (const Undecidable&) {
      return std::nullopt;
    }
    try {
      for (const Place& place : enclosing_.places(claim)) {
        if (!may_hold_at(claim, place)) return false;
      }
      return true;
    } catch (const PointRejected&) {
      return std::nullopt;
    } catch (const Undecidable&) {
      return std::nullopt;
    }
  }

  [[nodiscard]] bool may_hold_at(const Equation& claim, const Place& place) {
    const Difference at = enclosing_.at(claim, place);
    try {
      return is_related(at.left, claim.relation, at.right);
    } catch (const ValuesTooNear&) {
      return true;
    }
  }

  [[nodiscard]] bool is_reached(SymbolId symbol) const {
    const auto contains = [symbol](const std::vector<SymbolId>& symbols) {
      return is_one_of(symbol, symbols);
    };
    return contains(reach_.symbols) || contains(reach_.unfolded) || contains(question_.zeroed);
  }

  /// left − right at all places, as rational numbers or enclosed.
  [[nodiscard]] std::optional<std::vector<PointValue>> residuals(const Equation& equation) {
    try {
      std::vector<PointValue> all;
      for (Rational& each : evaluator_.residuals(equation)) all.emplace_back(std::move(each));
      return all;
    } catch (const PointRejected&) {
      // enclosed, perhaps
    } catch (const Undecidable&) {
      return std::nullopt;
    }
    try {
      std::vector<PointValue> all;
      for (const Place& place : enclosing_.places(equation)) {
        const Difference at = enclosing_.at(equation, place);
        PointValue difference = at.left;
        add(difference, scaled(at.right, -1));
        all.push_back(is_rational(difference) ? std::move(difference) : PointValue(enclosure_of(difference)));
      }
      return all;
    } catch (const PointRejected&) {
      return std::nullopt;
    } catch (const Undecidable&) {
      return std::nullopt;
    }
  }

  static void compare(const std::vector<PointValue>& difference, const std::vector<PointValue>& values,
                      Multiple& known) {
    known.none = difference.size() != values.size();
    for (std::size_t at = 0; at < values.size() && !known.none; ++at) {
      if (may_be_zero(enclosure_of(values[at]))) {
        known.none = !may_be_zero(enclosure_of(difference[at]));
        continue;
      }
      const auto ratio = ratio_of(difference[at], values[at]);
      known.none = !ratio || (known.ratio && *known.ratio != *ratio);
      known.ratio = ratio;
    }
  }

  [[nodiscard]] static std::optional<Rational> ratio_of(const PointValue& a, const PointValue& b) {
    if (is_rational(a) && is_rational(b)) return a.rational / b.rational;
    return simplest_in(quotient(enclosure_of(a), enclosure_of(b)));
  }

  Question question_;
  Limits limits_;
  Scope scope_;
  AssumptionSolver solver_;
  Reach reach_;
  SampleEvaluator evaluator_;
  SampleEvaluator enclosing_;
  std::size_t tree_size_;  // the evaluators have room for no more nodes
  std::vector<SamplePoint> points_;
  std::vector<SamplePoint> enclosed_;  // on which the claim itself has real values, not rational ones
  std::vector<SamplePoint> others_;    // on which it has none, or holds
  std::uint64_t work_of_drawing_ = 0;
  std::pair<std::uint64_t, std::uint64_t> steps_of_drawing_;  // of the evaluators
};

/// A screen of complex claims is one of their parts, made anew for each list of claims.
class SampleScreen::InParts {
 public:
  InParts(const Question& question, std::span<const Equation> claims, const Limits& limits)
      : real_(in_real_parts(question, claims)), screen_(real_.question, sides(), limits) {}

  [[nodiscard]] Samples& screen() { return screen_; }
  [[nodiscard]] const Equation& claim() const { return real_.sides; }
  /// The claims that could be taken apart; the others are `never`, which fails.
  [[nodiscard]] std::vector<Equation> claims(const Equation& never) const {
    std::vector<Equation> all;
    for (const std::optional<Equation>& each : real_.more) all.push_back(each.value_or(never));
    return all;
  }
  [[nodiscard]] bool is_known(std::size_t k) const { return real_.more[k].has_value(); }

 private:
  [[nodiscard]] std::vector<ExprId> sides() const {
    std::vector<ExprId> all;
    for (const std::optional<Equation>& each : real_.more) {
      if (each) all.insert(all.end(), {each->left, each->right});
    }
    return all;
  }

  RealQuestion real_;
  Samples screen_;
};

namespace {

constexpr std::uint64_t most_work_on_operators = 400'000;

std::vector<SymbolId> symbols_of(const ExprTree& tree, const Equation& claim) {
  std::vector<SymbolId> symbols = symbols_in(tree, claim.left);
  const std::vector<SymbolId> right = symbols_in(tree, claim.right);
  symbols.insert(symbols.end(), right.begin(), right.end());
  return symbols;
}

/// Operators have no samples, so each claim is decided. What is known of the claim's symbols says nothing of
/// others.
std::vector<Screened> proved_of_operators(Question question, std::span<const Equation> claims,
                                          Limits limits) {
  Budget own(most_work_on_operators);
  limits.budget = &own;
  const std::vector<SymbolId> known = symbols_of(*question.tree, question.claim);
  std::vector<Screened> found;
  for (const Equation& claim : claims) {
    question.claim = claim;
    const bool asked =
        !own.exhausted() && std::ranges::all_of(symbols_of(*question.tree, claim),
                                                [&](SymbolId each) { return is_one_of(each, known); });
    const bool holds = asked && holds_in_words(question, limits);
    found.push_back(holds ? Screened::holds : asked ? Screened::fails : Screened::not_compared);
  }
  return found;
}

std::vector<std::optional<std::string>> multiples_of_operators(const Question& question,
                                                               std::span<const Equation> terms,
                                                               Limits limits) {
  Budget own(most_work_on_operators);
  limits.budget = &own;
  std::vector<std::optional<std::string>> found;
  for (const Equation& term : terms)
    found.push_back(own.exhausted() ? std::nullopt : multiple_in_words(question, term, limits));
  return found;
}

}  // namespace

SampleScreen::SampleScreen(const Question& question, std::span<const ExprId> also, const Limits& limits)
    : question_(question), limits_(limits) {
  if (!is_about_complex(question) && !is_about_operators(question))
    samples_ = std::make_unique<Samples>(question, also, limits);
}

SampleScreen::SampleScreen(const Question& question, const Limits& limits)
    : question_(question), limits_(limits) {}

SampleScreen::~SampleScreen() = default;

std::unique_ptr<SampleScreen> SampleScreen::after_growth() const {
  std::unique_ptr<SampleScreen> grown(new SampleScreen(question_, limits_));
  if (samples_) grown->samples_ = std::make_unique<Samples>(*samples_);
  return grown;
}

std::vector<Screened> SampleScreen::screened(std::span<const Equation> claims) {
  if (samples_) return samples_->screened(claims);
  if (is_about_operators(question_)) return proved_of_operators(question_, claims, limits_);
  try {
    InParts parts(question_, claims, limits_);
    std::vector<Screened> found = parts.screen().screened(parts.claims(parts.claim()));
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (!parts.is_known(k)) found[k] = Screened::not_compared;
    }
    return found;
  } catch (const Undecidable&) {
    return std::vector<Screened>(claims.size(), Screened::not_compared);
  }
}

std::vector<bool> SampleScreen::passing(std::span<const Equation> claims) {
  std::vector<bool> passing;
  for (const Screened each : screened(claims)) passing.push_back(each == Screened::holds);
  return passing;
}

std::vector<std::optional<std::string>> SampleScreen::multiples(const Equation& claim,
                                                                std::span<const Equation> terms) {
  if (samples_) return samples_->multiples(claim, terms);
  if (is_about_operators(question_)) {
    Question question = question_;
    question.claim = claim;
    return multiples_of_operators(question, terms, limits_);
  }
  try {
    Question question = question_;
    question.claim = claim;
    InParts parts(question, terms, limits_);
    auto found = parts.screen().multiples(parts.claim(), parts.claims(parts.claim()));
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (!parts.is_known(k)) found[k].reset();
    }
    return found;
  } catch (const Undecidable&) {
    return std::vector<std::optional<std::string>>(terms.size());
  }
}

}  // namespace rigor
