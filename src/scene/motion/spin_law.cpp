// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/motion/spin_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/among.h"
#include "numeric/kernels/position.h"
#include "numeric/run/runner.h"

namespace rigor {
namespace {

/// c · rates + rest = 0.
struct LawRow {
  Vector3 coefficients{};
  double rest = 0;
};

double largest(const Vector3& vector) {
  return std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
}

/// Coefficients beneath this, of rows scaled to 1, count as 0: equations that are independent only by their
/// rounding errors do not pass for a law.
constexpr double smallest_pivot = 1e-9;

struct Elimination {
  Vector3 rates{};
  int undetermined = -1;  // an axis whose rate nothing determines
  double misfit = 0;      // of the rates in the equations, against their terms; not a number: they are not
                          // finite
};

/// Equations that the rates miss by more contradict each other, or are not affine in the rates there.
constexpr double most_misfit = 1e-6;

/// What is left of two sides that say the same, against their size.
constexpr double rounding = 1e-13;

/// The equations have terms of the size of the spin's square, which may have cancelled.
constexpr double cancelled = 1e-4;

bool is_finite_row(const LawRow& row) { return are_finite(row.coefficients) && std::isfinite(row.rest); }

/// Full pivoting: the best equation for the best rate first.
Elimination eliminate(std::vector<LawRow> rows) {
  if (!std::ranges::all_of(rows, is_finite_row)) {
    return {.rates = {}, .undetermined = -1, .misfit = std::numeric_limits<double>::quiet_NaN()};
  }
  std::erase_if(rows, [](const LawRow& row) { return largest(row.coefficients) == 0; });
  for (LawRow& row : rows) {
    const double scale = largest(row.coefficients);
    for (double& each : row.coefficients) each /= scale;
    row.rest /= scale;
  }
  Elimination result;
  std::array<std::size_t, 3> row_of{};
  std::array<bool, 3> done{};
  for (std::size_t count = 0; count < 3; ++count) {
    std::size_t best_row = count;
    std::size_t best_axis = 3;
    double best = smallest_pivot;
    for (std::size_t r = count; r < rows.size(); ++r) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (done[k] || std::abs(rows[r].coefficients[k]) <= best) continue;
        best = std::abs(rows[r].coefficients[k]);
        best_row = r;
        best_axis = k;
      }
    }
    if (best_axis == 3) {
      result.undetermined = static_cast<int>(std::ranges::find(done, false) - done.begin());
      return result;
    }
    std::swap(rows[count], rows[best_row]);
    done[best_axis] = true;
    row_of[best_axis] = count;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == count) continue;
      const double factor = rows[r].coefficients[best_axis] / rows[count].coefficients[best_axis];
      if (factor == 0) continue;
      for (std::size_t k = 0; k < 3; ++k) rows[r].coefficients[k] -= factor * rows[count].coefficients[k];
      rows[r].coefficients[best_axis] = 0;
      rows[r].rest -= factor * rows[count].rest;
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const LawRow& row = rows[row_of[k]];
    result.rates[k] = -row.rest / row.coefficients[k];
  }
  return result;
}

}  // namespace

/// The equations' programs; each has the left sides' components first and then the right sides'.
class SpinLaw::System {
 public:
  System(const ExprTree& tree, const std::vector<SymbolId>& spin, std::size_t particles)
      : tree_(tree), spin_(spin), particles_(particles) {
    for (const SymbolId symbol : spin) {
      if (const auto rate = tree.symbols.find({symbol, {By::time}})) rates_.push_back(*rate);
    }
    left_out_ = spin_;
    left_out_.insert(left_out_.end(), rates_.begin(), rates_.end());
  }

  /// Nothing, or why the equations cannot be evaluated at all.
  void add(const LawEquation& equation, const LetterValues& values) {
    const ProgramRoot roots[]{{equation.left, equation.indices}, {equation.right, equation.indices}};
    const auto program = Program::compile(tree_, equation.definitions, roots);
    if (!program) {
      remember(program.error().reason);
      return;
    }
    const bool has_rate = std::ranges::any_of(
        program->inputs(), [&](const ProgramInput& input) { return is_one_of(input.symbol, rates_); });
    if (!has_rate || !program->free_particles().empty()) return;
    Samples samples(1, particles_);
    if (const auto missing = values.fill(*program, samples, left_out_)) {
      remember(fmt::format("`{}` has no value", tree_.symbols[missing->symbol].name));
      return;
    }
    std::vector<ProgramInput> varying;
    for (const ProgramInput& input : program->inputs()) {
      if (is_one_of(input.symbol, left_out_)) varying.push_back(input);
    }
    Part part{Runner(*program, samples, varying), {}, {}, std::vector<double>(program->outputs())};
    for (const ProgramInput& input : varying) {
      const bool is_rate = is_one_of(input.symbol, rates_);
      part.varying.push_back({is_rate, input.component});
    }
    part.values.resize(varying.size());
    parts_.push_back(std::move(part));
  }

  [[nodiscard]] std::size_t used() const { return parts_.size(); }
  [[nodiscard]] const std::string& obstacle() const { return obstacle_; }

  /// Where the rates are determined, they have been put back into the equations.
  [[nodiscard]] Elimination solve(const Vector3& spin) {
    const std::vector<LawRow> all = rows(spin);
    Elimination solved = eliminate(all);
    if (solved.undetermined < 0 && !std::isnan(solved.misfit))
      solved.misfit = misfit(all, spin, solved.rates);
    return solved;
  }

  /// With the rates 0 and of a size to be expected.
  [[nodiscard]] bool is_finite_at(const Vector3& spin) {
    const double h = probe_size(spin);
    const std::array<Vector3, probes> batch{{{0, 0, 0}, {h, 0, 0}, {0, h, 0}, {0, 0, h}}};
    return std::ranges::all_of(parts_, [&](Part& part) { return are_finite(residuals(part, spin, batch)); });
  }

  /// With rates a, b of about the size h: is f(a + b) + f(0) = f(a) + f(b)? A law that is not affine is
  /// refused if it differs by more than 1e-9 of its terms.
  [[nodiscard]] bool is_affine(const Vector3& spin, double h) {
    const std::array<Vector3, probes> batch{{{0, 0, 0}, {h, 2 * h, -h}, {3 * h, -h, 2 * h}, {4 * h, h, h}}};
    for (Part& part : parts_) {
      const std::vector<double>& values = residuals(part, spin, batch);
      const std::size_t outputs = values.size() / probes;
      for (std::size_t o = 0; o < outputs; ++o) {
        const double* f = &values[o * probes];
        const double size = std::abs(f[0]) + std::abs(f[1]) + std::abs(f[2]) + std::abs(f[3]);
        const double allowed = 1e-9 * size + rounding * sizes_[o * probes + 3];
        if (!(std::abs(f[3] + f[0] - f[1] - f[2]) <= allowed)) return false;
      }
    }
    return true;
  }

  /// A power of two near the size of the rates that the spin alone makes.
  static double probe_size(const Vector3& spin) {
    const double size = largest(spin);
    if (!(size > 0) || !std::isfinite(size)) return 1;
    return std::clamp(std::exp2(2 * std::round(std::log2(size))), 0x1p-900, 0x1p900);
  }

  /// So large that nothing else in an equation rounds the coefficients: larger than any rate.
  static double large_probe(const Vector3& spin) { return std::max(0x1p200, probe_size(spin)); }

 private:
  static constexpr std::size_t probes = 4;

  /// Which component of the spin or of its rates a program reads.
  struct Varying {
    bool is_rate;
    std::uint32_t component;
  };
  struct Part {
    Runner run;
    std::vector<Varying> varying;
    std::vector<double> values;
    std::vector<double> results;
  };

  void remember(const std::string& reason) {
    if (obstacle_.empty()) obstacle_ = reason;
  }

  /// left − right of each component at each of the rates: [component · count of rates + which].
  [[nodiscard]] const std::vector<double>& residuals(Part& part, const Vector3& spin,
                                                     std::span<const Vector3> rates) {
    const std::size_t half = part.results.size() / 2;
    const std::size_t count = rates.size();
    residuals_.resize(half * count);
    sizes_.resize(half * count);
    for (std::size_t p = 0; p < count; ++p) {
      for (std::size_t i = 0; i < part.varying.size(); ++i) {
        part.values[i] = (part.varying[i].is_rate ? rates[p] : spin)[part.varying[i].component];
      }
      part.run(part.values.data(), part.results.data());
      for (std::size_t o = 0; o < half; ++o) {
        residuals_[o * count + p] = part.results[o] - part.results[half + o];
        sizes_[o * count + p] = std::abs(part.results[o]) + std::abs(part.results[half + o]);
      }
    }
    return residuals_;
  }

  /// A coefficient that is rounding of the two sides, which say the same of that rate, is 0.
  [[nodiscard]] std::vector<LawRow> rows(const Vector3& spin) {
    const double h = large_probe(spin);
    const std::array<Vector3, probes> batch{{{0, 0, 0}, {h, 0, 0}, {0, h, 0}, {0, 0, h}}};
    std::vector<LawRow> all;
    for (Part& part : parts_) {
      const std::vector<double>& values = residuals(part, spin, batch);
      for (std::size_t o = 0; o < values.size() / probes; ++o) {
        const double* f = &values[o * probes];
        LawRow row{.coefficients = {}, .rest = f[0]};
        for (std::size_t k = 0; k < 3; ++k) {
          const double change = f[k + 1] - f[0];
          const bool is_rounding = std::abs(change) <= rounding * sizes_[o * probes + k + 1];
          row.coefficients[k] = is_rounding && std::isfinite(f[k + 1]) ? 0 : change / h;
        }
        all.push_back(row);
      }
    }
    return all;
  }

  /// The worst equation's: what is left of it at the rates, or of its affine form at other ones, over its
  /// terms.
  [[nodiscard]] double misfit(const std::vector<LawRow>& all, const Vector3& spin, const Vector3& rates) {
    const double h = large_probe(spin);
    const std::array<Vector3, 2> batch{rates, {2 * h, 2 * h, 2 * h}};
    double worst = 0;
    auto row = all.begin();
    for (Part& part : parts_) {
      const std::vector<double>& values = residuals(part, spin, batch);
      for (std::size_t o = 0; o < values.size() / 2; ++o, ++row) {
        for (std::size_t p = 0; p < 2; ++p) {
          const std::size_t at = 2 * o + p;
          const bool must_vanish = p == 0 && largest(row->coefficients) != 0;
          const double each = misfit(*row, spin, batch[p], values[at], sizes_[at], must_vanish);
          if (!(each <= worst)) worst = each;
          if (std::isnan(worst)) return worst;
        }
      }
    }
    return worst;
  }

  /// `size`: of the equation's two sides, whose difference is `value`. What solves a row satisfies its affine
  /// form, unless equations contradict each other: then `value` is not 0.
  static double misfit(const LawRow& row, const Vector3& spin, const Vector3& rates, double value,
                       double size, bool must_vanish) {
    const double scale = largest(row.coefficients);
    double expected = row.rest;
    double terms = std::abs(row.rest) + scale * largest(spin) * largest(spin) * cancelled;
    for (std::size_t k = 0; k < 3; ++k) {
      expected += row.coefficients[k] * rates[k];
      terms += std::abs(row.coefficients[k] * rates[k]);
    }
    if (scale == 0) terms += size;  // what is left of two sides that say the same is rounding
    double left = std::abs(value - expected);
    if (must_vanish && std::abs(value) > left) left = std::abs(value);
    return left == 0 ? 0 : left / terms;
  }

  const ExprTree& tree_;
  std::vector<SymbolId> spin_;
  std::vector<SymbolId> rates_;
  std::vector<SymbolId> left_out_;
  std::size_t particles_;
  std::vector<Part> parts_;
  std::vector<double> residuals_;
  std::vector<double> sizes_;  // of the two sides, in the order of the residuals
  std::string obstacle_;       // the first one
};

Result<SpinLaw> SpinLaw::make(const ExprTree& tree, std::span<const LawEquation> equations,
                              const std::vector<SymbolId>& spin, const LetterValues& values,
                              std::size_t particles, const Vector3& at) {
  SpinLaw law;
  law.system_ = std::make_shared<System>(tree, spin, particles);
  for (const LawEquation& equation : equations) law.system_->add(equation, values);
  const std::string& obstacle = law.system_->obstacle();
  const std::string because = obstacle.empty() ? "" : " (" + obstacle + ")";
  if (law.system_->used() == 0) {
    return tl::unexpected(
        Error{"no equation there has a rate of the spin and otherwise only known letters" + because});
  }
  if (!law.system_->is_finite_at(at)) {
    return refuse("the equations are not finite at the initial spin");
  }
  const auto not_affine = [] { return refuse("the equations are not affine in the rates of the spin"); };
  if (!law.system_->is_affine(at, System::large_probe(at))) return not_affine();
  const Elimination tried = law.system_->solve(at);
  if (tried.undetermined >= 0) {
    return tl::unexpected(
        Error{fmt::format("the equations do not determine the rate of the spin's component {}{}",
                          tried.undetermined + 1, because)});
  }
  const double size = std::max(System::probe_size(at), largest(tried.rates));
  if (!law.system_->is_affine(at, size)) return not_affine();
  if (!(tried.misfit <= most_misfit)) return refuse("the equations contradict each other");
  return law;
}

Vector3 SpinLaw::rates(const Vector3& spin) const {
  const Elimination solved = system_->solve(spin);
  if (solved.undetermined < 0 && solved.misfit <= most_misfit) return solved.rates;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {none, none, none};
}

std::string SpinLaw::fault_at(const Vector3& spin) const {
  const Elimination solved = system_->solve(spin);
  if (solved.undetermined >= 0) {
    return fmt::format("the equations do not determine the rate of the spin's component {} there",
                       solved.undetermined + 1);
  }
  if (std::isnan(solved.misfit)) return "the equations are not finite there";
  return solved.misfit <= most_misfit ? "" : "the equations contradict each other there";
}

}  // namespace rigor
