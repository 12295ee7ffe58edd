// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/statement/proof.h"

#include <algorithm>
#include <set>
#include <string_view>

namespace rigor {
namespace {

constexpr std::uint64_t check_prime = 4'294'967'291;  // 2³² − 5: products fit in 64 bits
constexpr int check_points = 4;

[[nodiscard]] std::uint64_t power_mod_prime(std::uint64_t base, std::uint64_t exponent) {
  std::uint64_t result = 1;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 != 0) result = result * base % check_prime;
    base = base * base % check_prime;
  }
  return result;
}

/// Of `-3/2`; empty if it is no such number, or one whose denominator the prime divides.
[[nodiscard]] std::optional<std::uint64_t> number_mod_prime(std::string_view text) {
  const auto natural = [](std::string_view digits) -> std::optional<std::uint64_t> {
    if (digits.empty()) return std::nullopt;
    std::uint64_t value = 0;
    for (const char digit : digits) {
      if (digit < '0' || digit > '9') return std::nullopt;
      value = (value * 10 + static_cast<std::uint64_t>(digit - '0')) % check_prime;
    }
    return value;
  };
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::size_t slash = text.find('/');
  const auto numerator = natural(text.substr(0, slash));
  const auto denominator =
      slash == std::string_view::npos ? std::optional<std::uint64_t>(1) : natural(text.substr(slash + 1));
  if (!numerator || denominator.value_or(0) == 0) return std::nullopt;
  const std::uint64_t value = *numerator * power_mod_prime(*denominator, check_prime - 2) % check_prime;
  return negative ? (check_prime - value) % check_prime : value;
}

/// Polynomials at one point; for good without an answer after one that cannot be read.
class ProofPoint {
 public:
  ProofPoint(std::size_t letters, std::uint64_t seed) {
    for (std::size_t i = 0; i < letters; ++i) {  // SplitMix64 (G. L. Steele and others, 2014)
      std::uint64_t bits = (seed * (letters + 1) + i + 1) * 0x9E3779B97F4A7C15U;
      bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9U;
      bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBU;
      values_.push_back((bits ^ (bits >> 31)) % check_prime);
    }
  }
  [[nodiscard]] bool fits() const { return fits_; }
  [[nodiscard]] std::uint64_t value(const ProofPolynomial& polynomial) {
    std::uint64_t total = 0;
    for (const ProofTerm& term : polynomial) {
      const auto coefficient = number_mod_prime(term.coefficient);
      fits_ = fits_ && coefficient.has_value();
      std::uint64_t product = coefficient.value_or(0);
      for (const ProofPower& power : term.powers) {
        fits_ = fits_ && power.letter < values_.size();
        if (!fits_) return 0;
        product = product * power_mod_prime(values_[power.letter], power.exponent) % check_prime;
      }
      total = (total + product) % check_prime;
    }
    return total;
  }

 private:
  std::vector<std::uint64_t> values_;
  bool fits_ = true;
};

[[nodiscard]] bool combination_holds(const Proof& proof, const ProofStep& step, ProofPoint& point) {
  std::uint64_t left = point.value(step.numerator);
  for (const ProofFactor& factor : step.factors) {
    if (factor.nonzero >= proof.nonzero.size()) return false;
    const std::uint64_t base = point.value(proof.nonzero[factor.nonzero].polynomial);
    if (base == 0) return false;
    left = left * power_mod_prime(base, factor.exponent) % check_prime;
  }
  std::uint64_t right = 0;
  for (const ProofCofactor& each : step.cofactors) {
    if (each.equation >= proof.equations.size()) return false;
    right +=
        point.value(each.cofactor) * point.value(proof.equations[each.equation].polynomial) % check_prime;
  }
  return point.fits() && left == right % check_prime;
}

}  // namespace

std::vector<std::size_t> assumptions_of(const Proof& proof) {
  std::set<std::size_t> all(proof.in_force.begin(), proof.in_force.end());
  for (const ProofSolution& solution : proof.solutions) all.insert(solution.assumption);
  for (const ProofEquation& equation : proof.equations) {
    if (equation.source == ProofEquation::Source::assumption) all.insert(equation.assumption);
  }
  for (const ProofNonzero& nonzero : proof.nonzero) {
    if (nonzero.assumption) all.insert(*nonzero.assumption);
  }
  for (const ProofStep& step : proof.steps) all.insert(step.assumptions.begin(), step.assumptions.end());
  return {all.begin(), all.end()};
}

std::string route_of(const Proof& proof) {
  if (proof.words) return "products of operators in their order";
  std::string route =
      proof.method == Proof::Method::sign ? "sign of the difference" : "component normal form";
  if (proof.moments) route += ", moments of any number of particles";
  if (proof.unit_vectors) route += ", unit vectors at the generic point";
  if (proof.rotations) route += ", rotations at the generic point";
  if (proof.functions) route += ", addition formulas";
  if (proof.radicals) route += ", radicals";
  return route;
}

bool cofactors_hold(const Proof& proof) {
  for (std::uint64_t seed = 1; seed <= check_points; ++seed) {
    ProofPoint point(proof.letters.size(), seed);
    const bool all = std::ranges::all_of(proof.steps, [&](const ProofStep& step) {
      return step.kind != ProofStep::Kind::combination || combination_holds(proof, step, point);
    });
    if (!all) return false;
  }
  return true;
}

}  // namespace rigor
