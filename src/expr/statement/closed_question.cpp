// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/statement/closed_question.h"

#include <algorithm>
#include <functional>
#include <unordered_map>
#include <utility>

namespace rigor {
namespace {

/// Ids in order; their positions are the new ids.
template <class Id>
class Numbering {
 public:
  /// True if it was not there.
  bool add(Id id) { return number_of_.try_emplace(id, id).second; }
  template <class Before = std::less<Id>>
  void finish(Before before = {}) {
    for (const auto& [id, number] : number_of_) ids_.push_back(id);
    std::ranges::sort(ids_, before);
    for (std::size_t k = 0; k < ids_.size(); ++k) number_of_[ids_[k]] = static_cast<Id>(k);
  }
  [[nodiscard]] Id operator[](Id id) const { return number_of_.at(id); }
  [[nodiscard]] const std::vector<Id>& ids() const { return ids_; }

 private:
  std::unordered_map<Id, Id> number_of_;
  std::vector<Id> ids_;
};

/// Derivatives come after what they are derivatives of: when they were first asked for does not count.
bool stands_before(const SymbolTable& symbols, SymbolId a, SymbolId b) {
  const SymbolId first = base_of(symbols, a);
  const SymbolId second = base_of(symbols, b);
  return first != second ? first < second : symbols[a].derivation < symbols[b].derivation;
}

class Closing {
 public:
  Closing(const Question& question, std::span<const SymbolId> also)
      : question_(question), from_(*question.tree) {
    reach(question.claim);
    for (const Definition& definition : question.definitions) {
      reach(definition.symbol);
      for (const IndexId index : definition.indices) indices_.add(index);
      if (definition.particle != no_particle) particles_.add(definition.particle);
      reach(definition.body);
    }
    for (const Equation& assumption : question.assumptions) reach(assumption);
    for (const SymbolId symbol : question.zeroed) reach(symbol);
    for (const SymbolId symbol : also) reach(symbol);
    symbols_.finish([this](SymbolId a, SymbolId b) { return stands_before(from_.symbols, a, b); });
    indices_.finish();
    particles_.finish();
    nodes_.finish();
  }

  ClosedQuestion close() {
    ClosedQuestion result{std::make_unique<ExprTree>(), {}, symbols_.ids()};
    ExprTree& tree = *result.tree;
    for (const SymbolId symbol : symbols_.ids()) tree.symbols.add(copy_of(from_.symbols[symbol]));
    for (const IndexId index : indices_.ids()) tree.add_index(from_.name(index), from_.space(index));
    for (const ParticleId particle : particles_.ids()) tree.add_particle(from_.name(particle));
    for (const ExprId node : nodes_.ids()) copy(node, tree);
    result.question.tree = &tree;
    result.question.claim = copy_of(question_.claim);
    for (const Definition& definition : question_.definitions)
      result.question.definitions.push_back(copy_of(definition));
    for (const Equation& assumption : question_.assumptions)
      result.question.assumptions.push_back(copy_of(assumption));
    for (const SymbolId symbol : question_.zeroed) result.question.zeroed.push_back(symbols_[symbol]);
    return result;
  }

 private:
  // --- what is reached

  void reach(SymbolId symbol) {
    if (!symbols_.add(symbol)) return;
    const auto& derivation = from_.symbols[symbol].derivation;
    if (!derivation) return;
    reach(derivation->base);
    for (const Variable& each : derivation->by) {
      if (each.by == By::letter) reach(each.letter);
      if (each.held) reach(*each.held);
    }
  }

  void reach(const Equation& equation) {
    for (const IndexId index : equation.indices) indices_.add(index);
    for (const ParticleId particle : equation.particles) particles_.add(particle);
    reach(equation.left);
    reach(equation.right);
  }

  void reach(ExprId root) {
    std::vector<ExprId> pending{root};
    while (!pending.empty()) {
      const ExprId id = pending.back();
      pending.pop_back();
      if (!nodes_.add(id)) continue;
      const ExprNode& node = from_[id];
      if (node.op == Op::symbol) reach(node.symbol);
      if (node.op == Op::index_sum) indices_.add(node.index);
      if (node.particle != no_particle) particles_.add(node.particle);
      for (const Slot& slot : from_.slots(id)) {
        if (slot.axis == 0) indices_.add(slot.variable);
      }
      const auto children = from_.children(id);
      pending.insert(pending.end(), children.begin(), children.end());
    }
  }

  // --- how it is copied

  /// What the exact side sees of a symbol: no place, and of a unit only that it is one.
  Symbol copy_of(const Symbol& symbol) const {
    Symbol copy = symbol;
    copy.first_seen = {};
    if (copy.unit_of_measure) copy.unit_of_measure = Dimension();
    if (symbol.derivation) {
      copy.derivation = Derivation{symbols_[symbol.derivation->base]};
      for (Variable each : symbol.derivation->by) {
        if (each.by == By::letter) each.letter = symbols_[each.letter];
        if (each.held) each.held = symbols_[*each.held];
        copy.derivation->by.insert(each);
      }
    }
    return copy;
  }

  void copy(ExprId id, ExprTree& tree) const {
    ExprNode node = from_[id];
    std::vector<ExprId> children;
    for (const ExprId child : from_.children(id)) children.push_back(nodes_[child]);
    std::vector<Slot> slots;
    for (const Slot& slot : from_.slots(id))
      slots.push_back(slot.axis != 0 ? slot : Slot{0, indices_[slot.variable]});
    node.span = {};
    if (node.op == Op::number) {
      tree.add_number({}, from_.digits(id));
    } else if (node.op == Op::table) {
      tree.add_table({}, children, slots, from_.table(id));
    } else {
      if (node.op == Op::symbol) node.symbol = symbols_[node.symbol];
      if (node.op == Op::index_sum) node.index = indices_[node.index];
      node.particle = copy_of(node.particle);
      tree.add(node, children, slots);
    }
  }

  [[nodiscard]] ParticleId copy_of(ParticleId particle) const {
    return particle == no_particle ? no_particle : particles_[particle];
  }

  [[nodiscard]] Equation copy_of(const Equation& equation) const {
    Equation copy{nodes_[equation.left], nodes_[equation.right], {}, {}, equation.relation};
    for (const IndexId index : equation.indices) copy.indices.push_back(indices_[index]);
    for (const ParticleId particle : equation.particles) copy.particles.push_back(particles_[particle]);
    return copy;
  }

  [[nodiscard]] Definition copy_of(const Definition& definition) const {
    Definition copy{symbols_[definition.symbol],
                    {},
                    copy_of(definition.particle),
                    nodes_[definition.body],
                    definition.by_square};
    for (const IndexId index : definition.indices) copy.indices.push_back(indices_[index]);
    return copy;
  }

  const Question& question_;
  const ExprTree& from_;
  Numbering<SymbolId> symbols_;
  Numbering<IndexId> indices_;
  Numbering<ParticleId> particles_;
  Numbering<ExprId> nodes_;
};

}  // namespace

ClosedQuestion closed(const Question& question, std::span<const SymbolId> also) {
  return Closing(question, also).close();
}

std::optional<SymbolId> number_of(const ClosedQuestion& question, SymbolId symbol) {
  const auto place = std::ranges::find(question.symbols, symbol);
  if (place == question.symbols.end()) return std::nullopt;
  return static_cast<SymbolId>(place - question.symbols.begin());
}

Decision in_notes(Decision decision, const ClosedQuestion& question) {
  const auto put_in = [&](SymbolId& symbol) { symbol = question.symbols[static_cast<std::size_t>(symbol)]; };
  for (SymbolId& symbol : decision.unfolded) put_in(symbol);
  if (decision.proof) for_each_symbol(*decision.proof, put_in);
  if (decision.sample) decision.sample = in_notes(*std::move(decision.sample), question);
  return decision;
}

Sample in_notes(Sample sample, const ClosedQuestion& question) {
  for (SampleValue& value : sample.values)
    value.symbol = question.symbols[static_cast<std::size_t>(value.symbol)];
  return sample;
}

Sample in_question(Sample sample, const ClosedQuestion& question) {
  std::erase_if(sample.values,
                [&](const SampleValue& value) { return !number_of(question, value.symbol).has_value(); });
  for (SampleValue& value : sample.values) value.symbol = *number_of(question, value.symbol);
  return sample;
}

}  // namespace rigor
