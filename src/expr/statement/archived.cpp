// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/statement/archived.h"

#include <algorithm>
#include <utility>

#include "base/archive.h"

namespace rigor {
namespace {

constexpr std::size_t op_count = static_cast<std::size_t>(Op::table) + 1;
constexpr std::size_t function_count = static_cast<std::size_t>(Function::arctan) + 1;
constexpr std::size_t relation_count = static_cast<std::size_t>(Relation::unequal) + 1;
constexpr std::size_t outcome_count = static_cast<std::size_t>(Outcome::undecided) + 1;

/// A node as it is added to a tree.
struct ArchivedNode {
  ExprNode node{.op = Op::number};
  std::string digits;
  Table table;
  std::vector<ExprId> children;
  std::vector<Slot> slots;
};

struct ArchivedQuestion {
  std::vector<Symbol> symbols;
  std::vector<std::string> indices;
  std::vector<Space> spaces;  // of the indices
  std::vector<std::string> particles;
  std::vector<ArchivedNode> nodes;
  Question question;
};

}  // namespace

template <class Archive>
void fields(Archive& archive, Space& space) {
  archive(space.dimension, space.id);
}

/// The spaces of so many axes.
template <class Archive>
void spaces_of(Archive& archive, AxisSpaces& axes, int rank) {
  for (int axis = 0; axis < rank; ++axis) {
    Space space = axes[axis];
    archive(space);
    axes.set(axis, space);
  }
}

template <class Archive>
void fields(Archive& archive, Variable& variable) {
  archive.bounded(variable.by, static_cast<std::size_t>(By::letter) + 1);
  if (variable.by == By::letter) archive(variable.letter, variable.partial, variable.held);
}

template <class Archive>
void fields(Archive& archive, Derivation& derivation) {
  std::vector<Variable> by(derivation.by.begin(), derivation.by.end());
  archive(derivation.base, by);
  derivation.by = {};
  for (const Variable& each : by) derivation.by.insert(each);
}

template <class Archive>
void fields(Archive& archive, LabelPart& part) {
  archive(part.letter, part.mark, part.number);
}

template <class Archive>
void fields(Archive& archive, Symbol& symbol) {
  bool measures = symbol.unit_of_measure.has_value();
  archive(symbol.name, symbol.rank, symbol.per_particle, symbol.symmetric, symbol.unit, symbol.rotation,
          symbol.complex, symbol.noncommuting, symbol.unsized, symbol.declared, symbol.circle_number,
          measures, symbol.derivation, symbol.ket, symbol.label);
  if (measures) symbol.unit_of_measure.emplace();
  spaces_of(archive, symbol.axes, std::min(symbol.rank, most_axes_apart));
}

template <class Archive>
void fields(Archive& archive, Slot& slot) {
  archive(slot.axis);
  if (slot.axis == 0) archive(slot.variable);
}

template <class Archive>
void fields(Archive& archive, ArchivedNode& each) {
  ExprNode& node = each.node;
  archive.bounded(node.op, op_count);
  archive(node.rank);
  if (node.op == Op::number) archive(each.digits);
  if (node.op == Op::symbol) archive(node.symbol);
  if (node.op == Op::index_sum) archive(node.index);
  if (node.op == Op::power) archive(node.exponent);
  if (node.op == Op::function) archive.bounded(node.function, function_count);
  if (node.op == Op::symbol || node.op == Op::particle_sum) archive(node.particle);
  if (node.op == Op::table) archive(each.table.entry);
  if (node.op == Op::basis || node.op == Op::tuple) spaces_of(archive, node.axes, 1);
  archive(each.slots, each.children);
}

template <class Archive>
void fields(Archive& archive, Equation& equation) {
  auto& [left, right, indices, particles, relation] = equation;
  archive(left, right, indices, particles);
  archive.bounded(relation, relation_count);
}

template <class Archive>
void fields(Archive& archive, Definition& definition) {
  auto& [symbol, indices, particle, body, by_square] = definition;
  archive(symbol, indices, particle, body, by_square);
}

template <class Archive>
void fields(Archive& archive, Question& question) {
  auto& [tree, claim, definitions, assumptions, zeroed] = question;
  static_cast<void>(tree);
  archive(claim, definitions, assumptions, zeroed);
}

template <class Archive>
void fields(Archive& archive, ArchivedQuestion& all) {
  auto& [symbols, indices, spaces, particles, nodes, question] = all;
  archive(symbols, indices, spaces, particles, nodes, question);
}

template <class Archive>
void fields(Archive& archive, SampleValue& value) {
  auto& [symbol, particle, components] = value;
  archive(symbol, particle, components);
}

template <class Archive>
void fields(Archive& archive, Sample& sample) {
  auto& [particles, values, axes, free_particles, left, right] = sample;
  archive(particles, values, axes, free_particles, left, right);
}

template <class Archive>
void fields(Archive& archive, Decision& decision) {
  auto& [outcome, vanishes, route, reason, no_real_value, unfolded, assumptions, sample, proof] = decision;
  archive.bounded(outcome, outcome_count);
  archive(vanishes, route, reason, no_real_value, unfolded, assumptions, sample, proof);
}

namespace {

template <class Id>
bool is_below(Id id, std::size_t count) {
  return static_cast<std::size_t>(id) < count;
}

/// Do all ids name something that is there? Children are before their parents.
bool fits(const ArchivedQuestion& all) {
  if (all.spaces.size() != all.indices.size()) return false;
  const auto particle = [&](ParticleId id) {
    return id == no_particle || is_below(id, all.particles.size());
  };
  const auto all_below = [](const auto& ids, std::size_t count) {
    return std::ranges::all_of(ids, [&](auto id) { return is_below(id, count); });
  };
  const auto variable = [&](const Variable& each) { return is_below(each.letter, all.symbols.size()); };
  for (const Symbol& symbol : all.symbols) {
    const auto& derivation = symbol.derivation;
    if (!derivation) continue;
    const bool known = std::all_of(derivation->by.begin(), derivation->by.end(), variable);
    if (!known || !is_below(derivation->base, all.symbols.size())) return false;
  }
  for (std::size_t k = 0; k < all.nodes.size(); ++k) {
    const ArchivedNode& each = all.nodes[k];
    if (!all_below(each.children, k) || !particle(each.node.particle)) return false;
    if (each.node.op == Op::symbol && !is_below(each.node.symbol, all.symbols.size())) return false;
    if (each.node.op == Op::index_sum && !is_below(each.node.index, all.indices.size())) return false;
    for (const Slot& slot : each.slots) {
      if (slot.axis == 0 ? !is_below(slot.variable, all.indices.size()) : slot.axis > most_dimensions)
        return false;
    }
  }
  const auto equation = [&](const Equation& each) {
    return is_below(each.left, all.nodes.size()) && is_below(each.right, all.nodes.size()) &&
           all_below(each.indices, all.indices.size()) && all_below(each.particles, all.particles.size());
  };
  const auto definition = [&](const Definition& each) {
    return is_below(each.symbol, all.symbols.size()) && is_below(each.body, all.nodes.size()) &&
           all_below(each.indices, all.indices.size()) && particle(each.particle);
  };
  const Question& question = all.question;
  return equation(question.claim) && std::ranges::all_of(question.assumptions, equation) &&
         std::ranges::all_of(question.definitions, definition) &&
         all_below(question.zeroed, all.symbols.size());
}

template <class Value>
std::string as_bytes(Value value) {
  ArchiveWriter writer;
  writer(value);
  return writer.take();
}

template <class Value>
std::optional<Value> from_bytes(std::string_view bytes) {
  Value value;
  ArchiveReader reader(bytes);
  reader(value);
  return reader.finished() ? std::optional(std::move(value)) : std::nullopt;
}

}  // namespace

std::string archived(const ClosedQuestion& question) {
  const ExprTree& tree = *question.tree;
  ArchivedQuestion all;
  for (std::size_t k = 0; k < tree.symbols.size(); ++k)
    all.symbols.push_back(tree.symbols[static_cast<SymbolId>(k)]);
  for (std::size_t k = 0; k < tree.index_count(); ++k) {
    all.indices.push_back(tree.name(static_cast<IndexId>(k)));
    all.spaces.push_back(tree.space(static_cast<IndexId>(k)));
  }
  for (std::size_t k = 0; k < tree.particle_count(); ++k)
    all.particles.push_back(tree.name(static_cast<ParticleId>(k)));
  for (std::size_t k = 0; k < tree.size(); ++k) {
    const auto id = static_cast<ExprId>(k);
    ArchivedNode each{tree[id], {}, {}, {}, {tree.slots(id).begin(), tree.slots(id).end()}};
    if (each.node.op == Op::number) each.digits = tree.digits(id);
    if (each.node.op == Op::table) each.table = tree.table(id);
    each.children.assign(tree.children(id).begin(), tree.children(id).end());
    all.nodes.push_back(std::move(each));
  }
  all.question = question.question;
  return as_bytes(std::move(all));
}

std::string archived(const Decision& decision) { return as_bytes(decision); }

std::string archived(const Sample& sample) { return as_bytes(sample); }

std::optional<Decision> decision_of_bytes(std::string_view bytes) { return from_bytes<Decision>(bytes); }

std::optional<Sample> sample_of_bytes(std::string_view bytes) { return from_bytes<Sample>(bytes); }

std::optional<ClosedQuestion> question_of_bytes(std::string_view bytes) {
  std::optional<ArchivedQuestion> read = from_bytes<ArchivedQuestion>(bytes);
  if (!read || !fits(*read)) return std::nullopt;
  ArchivedQuestion& all = *read;
  ClosedQuestion result{std::make_unique<ExprTree>(), std::move(all.question), {}};
  ExprTree& tree = *result.tree;
  for (Symbol& symbol : all.symbols) result.symbols.push_back(tree.symbols.add(std::move(symbol)));
  for (std::size_t k = 0; k < all.indices.size(); ++k)
    tree.add_index(std::move(all.indices[k]), all.spaces[k]);
  for (std::string& name : all.particles) tree.add_particle(std::move(name));
  for (ArchivedNode& each : all.nodes) {
    if (each.node.op == Op::number) {
      tree.add_number({}, std::move(each.digits));
    } else if (each.node.op == Op::table) {
      tree.add_table({}, each.children, each.slots, std::move(each.table));
    } else {
      tree.add(each.node, each.children, each.slots);
    }
  }
  result.question.tree = &tree;
  return result;
}

}  // namespace rigor
