// SPDX-License-Identifier: GPL-3.0-or-later
// Where a chain's forms are looked at: a number for each component of each free letter, within the conditions
// of the notes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "expr/statement/written_forms.h"
#include "numeric/advice/run_values.h"
#include "numeric/program/program.h"
#include "numeric/program/samples.h"
#include "numeric/run/run_bounded.h"

namespace rigor {

using Point = std::vector<double>;

/// A free letter and its numbers in a point. Rotations, unit vectors and units of measure are not searched:
/// their numbers are drawn as `families.h` does.
struct SearchedLetter {
  SymbolId symbol{};
  std::vector<std::uint32_t> components;
  std::size_t first = 0;  // of a point
  bool drawn = false;     // not searched
};

/// An assumption in force, both sides in double with bounds.
struct SearchCondition {
  Program left;
  Program right;
  Relation relation = Relation::equal;
};

struct SearchSpace {
  std::vector<Program> forms;
  std::vector<SearchCondition> conditions;
  std::vector<SearchedLetter> letters;
  std::size_t size = 0;      // of a point
  std::vector<Point> drawn;  // points of ordinary size, for the letters that are not searched
};

/// Fails where forms or conditions belong to particles or are too large, where a condition cannot be
/// compiled, and without a letter that is searched.
[[nodiscard]] Result<SearchSpace> search_space(const WrittenForms& forms, const WrittenFormChain& chain,
                                               std::vector<Program> programs, std::uint64_t seed);

/// Operations of the forms: each twice, and once back for each component.
[[nodiscard]] std::size_t work_at_a_point(const SearchSpace& space);

/// The point's numbers in the order of a program's inputs.
[[nodiscard]] std::vector<std::size_t> places_of_inputs(const SearchSpace& space, const Program& program);

/// Whether points meet the conditions for sure, one after the other. An equation is never met.
class ConditionsAtPoint {
 public:
  explicit ConditionsAtPoint(const SearchSpace& space);
  [[nodiscard]] bool met(const Point& point);

 private:
  struct Side {
    Side(const SearchSpace& space, const Program& program);
    void run(const Point& point);
    const Code* code;
    ValuesAtPoint<Bounded> values;
    std::vector<std::size_t> places;
    std::vector<double> inputs;
  };
  const SearchSpace& space_;
  std::vector<std::pair<Side, Side>> sides_;
};

/// Points as samples for the programs.
[[nodiscard]] Samples samples_at(const SearchSpace& space, std::span<const Point> points);

/// All components of a letter; 0 for those that no form reads.
[[nodiscard]] std::vector<double> values_of(const ExprTree& tree, const SearchedLetter& letter,
                                            const Point& point);

/// `x = 1e-09, \mathbf{A} = (1, 0, 2)`, each number with all of its digits.
[[nodiscard]] std::string text_of(const ExprTree& tree, const SearchSpace& space, const Point& point);

}  // namespace rigor
