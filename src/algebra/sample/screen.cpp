// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/screen.h"

#include <algorithm>
#include <numeric>

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
        tree_size_(question.tree->size()) {
    if (reach_.too_large) return;
    evaluator_.take_circle_number_as_rational();  // what passes is proved afterwards
    SampleSequence sequence(scope_.tree(), reach_, solver_.has_particle_sums());
    try {
      while (points_.size() < wanted_points && sequence.drawn() < most_attempts) draw(sequence);
      for (SamplePoint& point : others_) {
        if (points_.size() < wanted_points) points_.push_back(std::move(point));
      }
    } catch (const Undecidable&) {
      // with the points that there are
    }
  }

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
      evaluator_.look_at(point);
      for (std::size_t k = 0; k < claims.size(); ++k) {
        if (failed[k] || !can_compare(claims[k])) continue;
        try {
          failed[k] = !evaluator_.holds(claims[k]);
          ++compared[k];
        } catch (const PointRejected&) {
          // on another point, perhaps
        } catch (const Undecidable&) {
          // not here
        }
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
      evaluator_.look_at(point);
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

  void draw(SampleSequence& sequence) {
    const std::uint32_t attempt = sequence.drawn();
    SamplePoint point = sequence.next();
    if (attempt < degenerate_attempts && !reach_.symbols.empty()) return;
    if (reach_.particles && point.particles() < 2) return;
    try {
      if (!solver_.none() && !solver_.solve(evaluator_, point, attempt)) return;
    } catch (const PointRejected&) {
      return;
    }
    try {
      evaluator_.look_at(point);
      static_cast<void>(evaluator_.difference(question_.claim));
      points_.push_back(std::move(point));
    } catch (const PointRejected&) {
      if (others_.size() < wanted_points) others_.push_back(std::move(point));
    }
  }

  [[nodiscard]] bool is_reached(SymbolId symbol) const {
    const auto contains = [symbol](const std::vector<SymbolId>& symbols) {
      return is_one_of(symbol, symbols);
    };
    return contains(reach_.symbols) || contains(reach_.unfolded) || contains(question_.zeroed);
  }

  [[nodiscard]] std::optional<std::vector<Rational>> residuals(const Equation& equation) {
    try {
      return evaluator_.residuals(equation);
    } catch (const PointRejected&) {
      return std::nullopt;
    } catch (const Undecidable&) {
      return std::nullopt;
    }
  }

  static void compare(const std::vector<Rational>& difference, const std::vector<Rational>& values,
                      Multiple& known) {
    known.none = difference.size() != values.size();
    for (std::size_t at = 0; at < values.size() && !known.none; ++at) {
      if (cln::zerop(values[at])) {
        known.none = !cln::zerop(difference[at]);
        continue;
      }
      const Rational ratio = difference[at] / values[at];
      known.none = known.ratio.has_value() && *known.ratio != ratio;
      known.ratio = ratio;
    }
  }

  Question question_;
  Limits limits_;
  Scope scope_;
  AssumptionSolver solver_;
  Reach reach_;
  SampleEvaluator evaluator_;
  std::size_t tree_size_;  // the evaluator has room for no more nodes
  std::vector<SamplePoint> points_;
  std::vector<SamplePoint> others_;  // on which the claim itself has no rational value
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

SampleScreen::~SampleScreen() = default;

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
