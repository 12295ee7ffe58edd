// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/advice/search_space.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "numeric/family/families.h"

namespace rigor {
namespace {

constexpr std::size_t drawn_points = 64;
constexpr std::size_t most_work = 8000;  // operations of the forms at a point

bool belongs_to_particles(const Program& program) {
  return program.sums_over_particles() || !program.free_particles().empty() ||
         std::ranges::any_of(program.inputs(), [](const ProgramInput& input) { return input.per_particle; });
}

/// Has it to be of a certain length or kind, so that it is no free choice of numbers?
bool is_bound(const Symbol& symbol) { return symbol.is_fixed() || symbol.unit || symbol.rotation; }

Result<Program> compiled_side(const WrittenForms& forms, const WrittenFormChain& chain, ExprId side,
                              const Equation& equation) {
  const ProgramRoot root{side, equation.indices};
  return Program::compile(forms.tree, chain.definitions, std::span(&root, 1));
}

/// All numbers that programs read, letter by letter.
void take_letters(const ExprTree& tree, SearchSpace& space) {
  std::vector<std::pair<SymbolId, std::uint32_t>> read;
  const auto take = [&](const Program& program) {
    for (const ProgramInput& input : program.inputs()) read.emplace_back(input.symbol, input.component);
  };
  for (const Program& form : space.forms) take(form);
  for (const SearchCondition& condition : space.conditions) {
    take(condition.left);
    take(condition.right);
  }
  std::ranges::sort(read);
  read.erase(std::unique(read.begin(), read.end()), read.end());
  for (const auto& [symbol, component] : read) {
    if (space.letters.empty() || space.letters.back().symbol != symbol)
      space.letters.push_back({symbol, {}, space.size, is_bound(tree.symbols[symbol])});
    space.letters.back().components.push_back(component);
    ++space.size;
  }
}

Result<std::vector<Point>> draw_bound_letters(const ExprTree& tree, const SearchSpace& space,
                                              std::uint64_t seed) {
  std::vector<SymbolId> symbols;
  for (const SearchedLetter& letter : space.letters) symbols.push_back(letter.symbol);
  const auto drawn = draw_samples(tree, symbols, {}, {.samples = drawn_points, .particles = 0, .seed = seed});
  if (!drawn) return tl::unexpected(drawn.error());
  std::vector<Point> points(drawn_points, Point(space.size));
  for (const SearchedLetter& letter : space.letters) {
    for (std::size_t k = 0; k < letter.components.size(); ++k) {
      const Column* column = drawn->find(letter.symbol, letter.components[k]);
      RIGOR_CHECK(column != nullptr, tree.symbols[letter.symbol].name);
      for (std::size_t n = 0; n < drawn_points; ++n)
        points[n][letter.first + k] = column->values[n * column->sample_stride];
    }
  }
  return points;
}

/// Told apart by more than the bounds.
bool holds_for_sure(Relation relation, const Bounded& left, const Bounded& right) {
  const double distance = right.value - left.value;
  const double bound = left.bound + right.bound;
  if (!std::isfinite(distance) || !std::isfinite(bound)) return false;
  switch (relation) {
    case Relation::equal:
      return false;
    case Relation::unequal:
      return std::abs(distance) > bound;
    case Relation::less:
      return distance > bound;
    case Relation::less_or_equal:
      return distance >= bound;
  }
  return false;
}

}  // namespace

std::size_t work_at_a_point(const SearchSpace& space) {
  std::size_t work = 0;
  for (const Program& form : space.forms) work += form.code().values.size() * (2 + 2 * form.outputs());
  return work;
}

Result<SearchSpace> search_space(const WrittenForms& forms, const WrittenFormChain& chain,
                                 std::vector<Program> programs, std::uint64_t seed) {
  SearchSpace space;
  space.forms = std::move(programs);
  for (const std::vector<Equation>* equations : {&chain.assumptions, &chain.conditions}) {
    for (const Equation& each : *equations) {
      auto left = compiled_side(forms, chain, each.left, each);
      if (!left) return tl::unexpected(left.error());
      auto right = compiled_side(forms, chain, each.right, each);
      if (!right) return tl::unexpected(right.error());
      space.conditions.push_back({std::move(*left), std::move(*right), each.relation});
    }
  }
  for (const Program& form : space.forms)
    if (belongs_to_particles(form)) return refuse("its forms belong to particles");
  for (const SearchCondition& condition : space.conditions) {
    if (belongs_to_particles(condition.left) || belongs_to_particles(condition.right))
      return refuse("its conditions belong to particles");
  }
  if (work_at_a_point(space) > most_work) return refuse("its forms are too large to be searched");
  take_letters(forms.tree, space);
  if (std::ranges::all_of(space.letters, &SearchedLetter::drawn)) return refuse("it has no free numbers");
  auto drawn = draw_bound_letters(forms.tree, space, seed);
  if (!drawn) return tl::unexpected(drawn.error());
  space.drawn = std::move(*drawn);
  return space;
}

std::vector<std::size_t> places_of_inputs(const SearchSpace& space, const Program& program) {
  std::vector<std::size_t> places;
  for (const ProgramInput& input : program.inputs()) {
    const auto letter = std::ranges::find(space.letters, input.symbol, &SearchedLetter::symbol);
    RIGOR_CHECK(letter != space.letters.end(), places.size());
    const auto component = std::ranges::find(letter->components, input.component);
    RIGOR_CHECK(component != letter->components.end(), places.size());
    places.push_back(letter->first + static_cast<std::size_t>(component - letter->components.begin()));
  }
  return places;
}

ConditionsAtPoint::Side::Side(const SearchSpace& space, const Program& program)
    : code(&program.code()),
      values(program.code()),
      places(places_of_inputs(space, program)),
      inputs(places.size()) {}

void ConditionsAtPoint::Side::run(const Point& point) {
  for (std::size_t k = 0; k < places.size(); ++k) inputs[k] = point[places[k]];
  values.run(inputs);
}

ConditionsAtPoint::ConditionsAtPoint(const SearchSpace& space) : space_(space) {
  for (const SearchCondition& condition : space.conditions)
    sides_.emplace_back(Side(space, condition.left), Side(space, condition.right));
}

bool ConditionsAtPoint::met(const Point& point) {
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    auto& [left, right] = sides_[k];
    left.run(point);
    right.run(point);
    const Relation relation = space_.conditions[k].relation;
    const std::size_t count = std::min(left.code->outputs.size(), right.code->outputs.size());
    std::size_t holding = 0;
    for (std::size_t n = 0; n < count; ++n) {
      if (holds_for_sure(relation, left.values[left.code->outputs[n]], right.values[right.code->outputs[n]]))
        ++holding;
    }
    // a ≠ of vectors holds where any component differs
    if (relation == Relation::unequal ? holding == 0 : holding < count) return false;
  }
  return true;
}

Samples samples_at(const SearchSpace& space, std::span<const Point> points) {
  Samples samples(points.size(), 0);
  for (const SearchedLetter& letter : space.letters) {
    for (std::size_t k = 0; k < letter.components.size(); ++k) {
      std::vector<double> column;
      for (const Point& point : points) column.push_back(point[letter.first + k]);
      samples.set_each(letter.symbol, letter.components[k], std::move(column));
    }
  }
  return samples;
}

std::vector<double> values_of(const ExprTree& tree, const SearchedLetter& letter, const Point& point) {
  std::vector<double> values(component_count(tree.symbols[letter.symbol]));
  for (std::size_t k = 0; k < letter.components.size(); ++k)
    values[letter.components[k]] = point[letter.first + k];
  return values;
}

std::string text_of(const ExprTree& tree, const SearchSpace& space, const Point& point) {
  std::vector<std::string> parts;
  for (const SearchedLetter& letter : space.letters) {
    const Symbol& symbol = tree.symbols[letter.symbol];
    if (symbol.is_fixed()) continue;
    std::vector<std::string> numbers;
    for (const double x : values_of(tree, letter, point)) numbers.push_back(fmt::format("{}", x));
    const bool alone = symbol.rank == 0;
    parts.push_back(alone ? fmt::format("{} = {}", symbol.name, numbers[0])
                          : fmt::format("{} = ({})", symbol.name, fmt::join(numbers, ", ")));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace rigor
