// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/advice/attack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "numeric/measure/measure.h"

namespace rigor {
namespace {

constexpr std::size_t climbers_at_once = 12;
constexpr std::size_t draws = 400;  // for an effort of 1
constexpr std::size_t most_draws = 8000;
constexpr std::size_t enough_drawn = 200;
constexpr std::size_t generations = 12;
constexpr std::size_t children = 3;
constexpr std::size_t most_losing_points = 400;
constexpr double largest = std::numeric_limits<double>::max();
constexpr std::array<double, 2> grown_too_far{709.8, 354.9};  // where eˣ and its square overflow
constexpr double exponents_for_a_bit = 15;  // of 2: a loss at 1e±300 counts as if 66 bits less were lost
constexpr double losing_first = 1000;       // more than extreme sizes take from a score
constexpr double shown_part = 0.2;          // of the expected error, at a point that shows it

/// A scalar that is exactly 0, or a vector, is a point of its own, where a form may have no value.
bool is_zero(const SearchedLetter& letter, const Point& point) {
  const auto first = point.begin() + static_cast<std::ptrdiff_t>(letter.first);
  return std::all_of(first, first + static_cast<std::ptrdiff_t>(letter.components.size()),
                     [](double x) { return x == 0; });
}

bool is_ordinary(double x) { return x == 0 || (std::abs(x) > 1e-300 && std::abs(x) < 1e300); }

/// Extreme sizes count against a loss, but no point without one goes before it.
double ordinary_score(const Point& point, double loss) {
  if (loss <= no_loss) return std::log2(loss);
  double extreme = 0;
  for (const double x : point)
    if (x != 0) extreme = std::max(extreme, std::abs(static_cast<double>(std::ilogb(x))));
  return losing_first + std::log2(loss) - extreme / exponents_for_a_bit;
}

}  // namespace

Attacker::Attacker(const SearchSpace& space, std::uint64_t seed)
    : space_(space), bits_(seed), conditions_(space), losing_(space.forms.size()) {
  bool turns = false;
  bool grows = false;
  for (const Program& program : space.forms) {
    const Code& code = program.code();
    Form form{&code, ErrorTape(code), ValuesAtPoint<double>(code), places_of_inputs(space, program), {}, {}};
    form.inputs.resize(form.places.size());
    for (ValueId id = 0; id < code.values.size(); ++id) {
      const Instruction op = code.values[id].op;
      if (op == Instruction::add || op == Instruction::subtract) form.sums.push_back(id);
      turns = turns || op == Instruction::sin || op == Instruction::cos || op == Instruction::tan;
      grows = grows || op == Instruction::exp || op == Instruction::sinh || op == Instruction::cosh;
    }
    for (const Constant& constant : code.constants)
      if (constant.value != 0) specials_.push_back(constant.value);
    forms_.push_back(std::move(form));
  }
  for (int k = 1; turns && k <= 8; ++k) specials_.push_back(k * 1.5707963267948966);
  if (grows) specials_.insert(specials_.end(), grown_too_far.begin(), grown_too_far.end());
  for (const SearchedLetter& letter : space.letters)
    if (!letter.drawn) letters_.push_back(&letter);
  positive_.resize(space.size);
  negative_.resize(space.size);
}

std::optional<PointErrors> Attacker::errors_at(const Point& point) {
  const bool ordinary =
      std::ranges::all_of(point, is_ordinary) &&
      std::ranges::none_of(letters_, [&](const SearchedLetter* each) { return is_zero(*each, point); });
  if (!ordinary || !conditions_.met(point)) return std::nullopt;
  work_ += work_at_a_point(space_);
  PointErrors errors;
  std::size_t best = 0;
  long double size = 0;
  for (Form& form : forms_) {
    for (std::size_t k = 0; k < form.places.size(); ++k) form.inputs[k] = point[form.places[k]];
    const ExpectedError error = form.tape.at(form.inputs);
    if (error.outside) return std::nullopt;
    errors.of_form.push_back(error.relative);
    if (error.relative >= errors.least && size != 0) continue;
    errors.least = error.relative;
    best = errors.of_form.size() - 1;
    size = error.has_value ? error.size : 0;
  }
  if (!(size >= least_normal) || size > largest) return std::nullopt;
  errors.least = std::max(errors.least, 2 * unit_roundoff);
  for (std::size_t k = 0; k < forms_.size(); ++k) {
    const double seen = forms_[k].tape.seen(forms_[best].tape) / shown_part;
    errors.of_form[k] = std::max(errors.least, std::min(errors.of_form[k], seen));
  }
  for (const SearchedLetter* letter : letters_) {
    for (std::size_t k = 0; k < letter->components.size(); ++k)
      (point[letter->first + k] > 0 ? positive_ : negative_)[letter->first + k] = true;
  }
  return errors;
}

void Attacker::note_losses(const Point& point, const PointErrors& errors) {
  for (std::size_t k = 0; k < losing_.size(); ++k) {
    if (errors.loss(k) <= no_loss) continue;
    if (losing_[k].size() < most_losing_points)
      losing_[k].push_back(point);
    else
      losing_[k][bits_.below(most_losing_points)] = point;
  }
}

std::optional<Attacker::Climber> Attacker::climber_at(Point point, std::size_t form, const Range& range,
                                                      const Aim& aim) {
  if (!contains(space_, range, point)) return std::nullopt;
  const auto errors = errors_at(point);
  if (!errors) return std::nullopt;
  note_losses(point, *errors);
  const double loss = errors->loss(form);
  const double score = aim.ordinary ? ordinary_score(point, loss) : std::log2(loss);
  return Climber{{std::move(point), loss}, score};
}

std::vector<Attacker::Climber> Attacker::known_losing(std::size_t form, const Range& range, const Aim& aim) {
  std::vector<Climber> climbers;
  const std::vector<Point> known = losing_[form];  // a copy: looking at a point again changes the list
  for (const Point& point : known) {
    auto climber = climber_at(point, form, range, aim);
    if (climber) climbers.push_back(std::move(*climber));
  }
  return climbers;
}

std::optional<LosingPoint> Attacker::worst(std::size_t form, const Range& range, const Aim& aim) {
  std::vector<Climber> climbers;
  // Where conditions are seldom met, more points are drawn.
  for (std::size_t k = 0; k < most_draws * aim.effort && climbers.size() < draws * aim.effort; ++k) {
    if (k > draws * aim.effort && climbers.size() > enough_drawn) break;
    auto drawn = climber_at(draw(range), form, range, aim);
    if (drawn) climbers.push_back(std::move(*drawn));
  }
  if (aim.ordinary) std::ranges::move(known_losing(form, range, aim), std::back_inserter(climbers));
  if (climbers.empty()) return std::nullopt;
  std::ranges::stable_sort(climbers, std::ranges::greater(), &Climber::score);
  if (climbers.size() > climbers_at_once) climbers.resize(climbers_at_once);
  const auto best = [&] { return std::ranges::max_element(climbers, {}, &Climber::score); };
  for (std::size_t k = 0; k < generations * aim.effort; ++k) {
    if (aim.refutes && best()->at.loss > no_loss) break;
    for (Climber& climber : climbers) {
      const Point parent = climber.at.point;
      for (std::size_t n = 0; n < children; ++n) {
        Point child = parent;
        mutate(child, range);
        if (bits_.below(3) == 0) mutate(child, range);
        auto found = climber_at(std::move(child), form, range, aim);
        if (found && found->score >= climber.score) climber = std::move(*found);
      }
    }
  }
  return best()->at;
}

}  // namespace rigor
