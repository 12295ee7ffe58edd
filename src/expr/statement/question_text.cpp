// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/statement/question_text.h"

#include <fmt/format.h>

#include <set>

namespace rigor {
namespace {

/// Ids in order, each with its number.
template <class Id>
class Numbering {
 public:
  void add(Id id) { ids_.insert(id); }
  [[nodiscard]] bool contains(Id id) const { return ids_.contains(id); }
  void finish() {
    for (const Id id : ids_) number_of_.emplace(id, number_of_.size());
  }
  [[nodiscard]] std::uint64_t operator[](Id id) const { return number_of_.at(id); }
  [[nodiscard]] const std::set<Id>& ids() const { return ids_; }
  [[nodiscard]] const std::map<Id, std::uint64_t>& numbers() const { return number_of_; }

 private:
  std::set<Id> ids_;
  std::map<Id, std::uint64_t> number_of_;
};

/// A name that cannot be taken for two: `3:\mu`.
std::string quoted(const std::string& text) { return fmt::format("{}:{}", text.size(), text); }

class QuestionWriter {
 public:
  QuestionWriter(const Question& question, std::span<const SymbolId> also) : question_(question) {
    add(question.claim);
    for (const Definition& definition : question.definitions) {
      add(definition.symbol);
      for (const IndexId index : definition.indices) indices_.add(index);
      if (definition.particle != no_particle) particles_.add(definition.particle);
      add_tree(definition.body);
    }
    for (const Equation& assumption : question.assumptions) add(assumption);
    for (const SymbolId symbol : question.zeroed) add(symbol);
    for (const SymbolId symbol : also) add(symbol);
    symbols_.finish();
    indices_.finish();
    particles_.finish();
    nodes_.finish();
  }

  QuestionText write() {
    for (const SymbolId symbol : symbols_.ids()) write_symbol(tree().symbols[symbol]);
    for (const IndexId index : indices_.ids()) text_ += "index " + quoted(tree().name(index)) + "\n";
    for (const ParticleId particle : particles_.ids())
      text_ += "particle " + quoted(tree().name(particle)) + "\n";
    for (const ExprId node : nodes_.ids()) write_node(node);
    write("claim", question_.claim);
    for (const Definition& definition : question_.definitions) {
      text_ += fmt::format("let {} = {} by-square {} at{}\n", symbols_[definition.symbol],
                           nodes_[definition.body], definition.by_square, particle(definition.particle));
      for (const IndexId index : definition.indices) text_ += fmt::format(" [{}]", indices_[index]);
    }
    for (const Equation& assumption : question_.assumptions) write("given", assumption);
    for (const SymbolId symbol : question_.zeroed) text_ += fmt::format("zero {}\n", symbols_[symbol]);
    return {std::move(text_), {symbols_.ids().begin(), symbols_.ids().end()}, symbols_.numbers()};
  }

 private:
  [[nodiscard]] const ExprTree& tree() const { return *question_.tree; }

  // --- what is reached

  void add(SymbolId symbol) {
    symbols_.add(symbol);
    const auto& derivation = tree().symbols[symbol].derivation;
    if (derivation) symbols_.add(derivation->base);
  }

  void add(const Equation& equation) {
    for (const IndexId index : equation.indices) indices_.add(index);
    for (const ParticleId particle : equation.particles) particles_.add(particle);
    add_tree(equation.left);
    add_tree(equation.right);
  }

  void add_tree(ExprId root) {
    std::vector<ExprId> pending{root};
    while (!pending.empty()) {
      const ExprId id = pending.back();
      pending.pop_back();
      if (nodes_.contains(id)) continue;
      nodes_.add(id);
      const ExprNode& node = tree()[id];
      if (node.op == Op::symbol) add(node.symbol);
      if (node.op == Op::index_sum) indices_.add(node.index);
      if (node.particle != no_particle) particles_.add(node.particle);
      for (const Slot& slot : tree().slots(id)) {
        if (slot.axis == 0) indices_.add(slot.variable);
      }
      const auto children = tree().children(id);
      pending.insert(pending.end(), children.begin(), children.end());
    }
  }

  // --- how it is written

  void write_symbol(const Symbol& symbol) {
    text_ +=
        fmt::format("symbol {} {} {:d}{:d}{:d}{:d}{:d}", quoted(symbol.name), symbol.rank,
                    symbol.per_particle, symbol.symmetric, symbol.unit, symbol.rotation, symbol.declared);
    if (symbol.unit_of_measure) text_ += " unit";
    if (symbol.derivation)
      text_ += fmt::format(" d {} {} {} {}", symbols_[symbol.derivation->base], symbol.derivation->time,
                           symbol.derivation->space, symbol.derivation->small);
    text_ += "\n";
  }

  [[nodiscard]] std::string particle(ParticleId id) const {
    return id == no_particle ? "" : fmt::format(" {{{}}}", particles_[id]);
  }

  void write_node(ExprId id) {
    const ExprNode& node = tree()[id];
    text_ += fmt::format("{} {}", static_cast<int>(node.op), node.rank);
    if (node.op == Op::number) text_ += " " + quoted(tree().digits(id));
    if (node.op == Op::symbol) text_ += fmt::format(" s{}", symbols_[node.symbol]);
    if (node.op == Op::index_sum) text_ += fmt::format(" i{}", indices_[node.index]);
    if (node.op == Op::power) text_ += fmt::format(" ^{}", node.exponent);
    if (node.op == Op::function) text_ += fmt::format(" f{}", static_cast<int>(node.function));
    text_ += particle(node.particle);
    for (const Slot& slot : tree().slots(id))
      text_ +=
          slot.axis != 0 ? fmt::format(" #{}", slot.axis) : fmt::format(" [{}]", indices_[slot.variable]);
    if (node.op == Op::table) {
      for (const std::uint8_t entry : tree().table(id).entry) text_ += fmt::format(" t{}", entry);
    }
    for (const ExprId child : tree().children(id)) text_ += fmt::format(" {}", nodes_[child]);
    text_ += "\n";
  }

  void write(const char* role, const Equation& equation) {
    text_ += fmt::format("{} {} {} {}", role, nodes_[equation.left], static_cast<int>(equation.relation),
                         nodes_[equation.right]);
    for (const IndexId index : equation.indices) text_ += fmt::format(" [{}]", indices_[index]);
    for (const ParticleId each : equation.particles) text_ += particle(each);
    text_ += "\n";
  }

  const Question& question_;
  Numbering<SymbolId> symbols_;
  Numbering<IndexId> indices_;
  Numbering<ParticleId> particles_;
  Numbering<ExprId> nodes_;
  std::string text_;
};

}  // namespace

QuestionText question_text(const Question& question, std::span<const SymbolId> also) {
  return QuestionWriter(question, also).write();
}

}  // namespace rigor
