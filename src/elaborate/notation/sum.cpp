// SPDX-License-Identifier: GPL-3.0-or-later
// Sums: of terms, which must agree in rank and free indices, and over an index or over particles.
#include <fmt/format.h>

#include <algorithm>

#include "elaborate/notation/notations.h"
#include "elaborate/reading/equation.h"
#include "elaborate/reading/matrix_product.h"
#include "expr/tree/state.h"

namespace rigor {
namespace {

[[nodiscard]] bool has_no_limits(const WrittenSum& sum) { return sum.from.empty() && sum.to.empty(); }

[[nodiscard]] bool runs_over_axes(const WrittenSum& sum, Space space) {
  return has_no_limits(sum) || (sum.from == "1" && sum.to == std::to_string(space.dimension));
}

/// A sum of the notes that runs the letter between other limits than those of the axes.
[[nodiscard]] const WrittenSum* sum_with_limits(const SyntaxTree& syntax, const std::string& letter,
                                                Space space) {
  for (std::size_t i = 0; i < syntax.size(); ++i) {
    const auto id = static_cast<SyntaxId>(i);
    if (syntax[id].kind != SyntaxKind::big_sum) continue;
    const WrittenSum& sum = syntax.big_sum(id);
    const bool same =
        std::ranges::any_of(sum.indices, [&](const WrittenIndex& index) { return index.text == letter; });
    if (same && !runs_over_axes(sum, space)) return &sum;
  }
  return nullptr;
}

/// Why the sum does not run over the axes, or over all particles.
[[nodiscard]] std::optional<Obstacle> obstacle_to(const SyntaxTree& syntax, const WrittenSum& sum,
                                                  const WrittenIndex& index, bool particle, Space space) {
  if (index.primes > 0 || index.form == IndexForm::digit || index.form == IndexForm::word)
    return unread(fmt::format("a sum over `{}` is not read", index.text));
  if (particle && (has_no_limits(sum) || (sum.from == "1" && sum.to == "N"))) return std::nullopt;
  if (particle)
    return unread("a sum over some of the particles is not decided",
                  {"a sum over all has no limits, or `1` and `N`"});
  const WrittenSum* const other = has_no_limits(sum) ? sum_with_limits(syntax, index.text, space) : nullptr;
  if (other != nullptr)
    return unread(
        fmt::format("the sum over `{}` can run over the axes, or from {} to {} as elsewhere in the notes",
                    index.text, other->from, other->to),
        {"write the limits at the sum"});
  if (runs_over_axes(sum, space)) return std::nullopt;
  return unread(
      fmt::format("the sum over `{}` does not run over the axes 1 to {}", index.text, space.dimension),
      {fmt::format("if `{0}` labels particles, say `rigor: particles {0}`", index.text)});
}

/// The variable that the innermost sum over the letter has bound, which it binds no longer.
template <typename Id>
Id unbind(Reading::Variables<Id>& variables, const std::string& letter) {
  const auto at = variables.summed.find(letter);
  const Id id = at->second.back();
  at->second.pop_back();
  if (at->second.empty()) variables.summed.erase(at);
  return id;
}

/// Of a multiple of the unit matrix, too.
Typed opposite(ExprTree& tree, const Typed& typed) {
  const Span span = tree[typed.id].span;
  Typed negative = apply_op(tree, Op::negate, span, typed.rank, {typed});
  if (typed.with_unit)
    negative.with_unit = tree.add({.op = Op::negate, .span = span}, std::span(&*typed.with_unit, 1));
  return negative;
}

}  // namespace

MaybeTyped elaborate_sum(Reading& reading, SyntaxId id, const Around& around) {
  ExprTree& tree = reading.tree;
  const Span span = reading.syntax[id].span;
  std::vector<Typed> addends;
  bool failed = false;
  for (const SyntaxChild& child : reading.syntax.children(id)) {
    auto addend = elaborate(reading, child.id, around);
    if (!addend) {
      failed = true;
      continue;
    }
    if (child.joint == Joint::minus) *addend = opposite(tree, *addend);
    addends.push_back(std::move(*addend));
  }
  if (failed || addends.empty()) return std::nullopt;
  std::erase_if(addends,
                [&](const Typed& addend) { return addends.size() > 1 && is_literal_zero(tree, addend); });
  if (addends.empty()) return Typed{.id = tree.add_number(span, "0")};
  if (addends.size() == 1) return addends[0];
  const auto matrix = std::ranges::find(addends, Layout::matrix, &Typed::layout);
  if (matrix != addends.end()) {
    const Typed like = *matrix;
    for (Typed& addend : addends) addend = beside_matrix(reading, addend, like);
  }
  for (const Typed& addend : addends) {
    const Mismatch place{tree[addend.id].span, reading.diagnostics};
    failed = !same_type(reading, addends[0], addend, "term", place) || failed;
  }
  if (failed) return std::nullopt;
  return apply_op(tree, Op::add, span, addends[0].rank, addends);
}

MaybeTyped elaborate_big_sum(Reading& reading, SyntaxId id, const Around& around) {
  if (runs_over_numbers(reading.syntax, id, reading.names)) return elaborate_counted_sum(reading, id, around);
  const WrittenSum& written = reading.syntax.big_sum(id);
  for (const WrittenIndex& index : written.indices) {
    const bool particle = labels_particles(reading.names.symbols, index.text);
    if (const auto directive = particles_declared_by(reading.names.symbols, index.text))
      reading.found.used.insert(*directive);
    const Space space = space_of(reading.names.symbols);
    if (const auto obstacle = obstacle_to(reading.syntax, written, index, particle, space))
      return fail(reading, index.span, *obstacle);
    if (particle && !written.to.empty() && reading.letters.bare.contains("N"))
      reading.found.guess = unread("`N` was not taken for the number of particles");
    if (particle) {
      reading.particles.summed[index.text].push_back(reading.tree.add_particle(index.text));
    } else {
      reading.indices.summed[index.text].push_back(reading.tree.add_index(index.text, use_space(reading)));
    }
  }
  auto body = elaborate(reading, reading.syntax.child(id, 0), around);
  for (auto index = written.indices.rbegin(); index != written.indices.rend(); ++index) {
    const bool particle = reading.particles.summed.contains(index->text);
    ExprNode node{.op = particle ? Op::particle_sum : Op::index_sum, .span = reading.syntax[id].span};
    if (particle) {
      node.particle = unbind(reading.particles, index->text);
    } else {
      node.index = unbind(reading.indices, index->text);
      if (body) body->bound.push_back({index->text, node.index, index->span});
    }
    if (!body) continue;
    node.rank = static_cast<std::uint8_t>(body->rank);
    body->id = reading.tree.add(node, std::span(&body->id, 1));
  }
  if (body && holds_states(reading.tree, body->id))
    return unsupported(reading, reading.syntax[id].span, "sums over states are not decided");
  return body;
}

}  // namespace rigor
