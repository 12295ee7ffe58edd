// SPDX-License-Identifier: GPL-3.0-or-later
// From expressions to values: the meaning of every Op, in components. An array of rank r is 3^r operands, row
// by row, on top of a stack. Index variables are spelled out; ε and δ are looked at before the other factors
// of a product and before inner sums. Directly nested sums over indices are one sum, in the order of their
// values. Definitions are unfolded where their symbols stand, once for each component and particle.
// Recursion: the parser bounds a tree's depth, `deepest` the depth with unfolded definitions.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "numeric/program/compile_values.h"

namespace rigor {

class ExpressionCompiler {
 public:
  ExpressionCompiler(const ExprTree& tree, std::span<const Definition> definitions, Code& code);

  /// Appends the root's components to the outputs.
  void add(const ProgramRoot& root);
  /// Why there is no program; empty: there is one.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  static constexpr std::uint32_t deepest = 1500;
  static constexpr std::uint32_t most_steps = 2'000'000;
  static constexpr std::size_t most_values = 200'000;
  static constexpr std::size_t largest_array = 729;
  static constexpr std::uint32_t unbound = 0xffffffffu;

  /// What a symbol's components are, for one particle.
  struct SymbolComponents {
    SymbolId symbol{};
    std::uint32_t particle = 0;
    std::uint32_t first = 0;  // into known_components_
    std::uint32_t next = 0;   // of the same symbol, plus 1; 0: none
  };
  struct SymbolState {
    std::int32_t definition = -1;
    std::uint32_t known = 0;        // into known_, plus 1
    std::uint32_t first_input = 0;  // into input_of_, plus 1
  };
  struct SumParticles {
    ExprId sum{};
    std::vector<ParticleId> others;  // that occur in it besides its own
  };
  struct IndexChain {
    std::uint32_t first_variable = 0;  // of chain_variables_
    std::uint32_t variables = 0;
    ExprId body{};
    std::span<const ExprId> factors;  // where its guards are
  };

  [[nodiscard]] const ExprNode& node(ExprId id) const { return (*tree_)[id]; }
  [[nodiscard]] ExprId child(ExprId id, std::size_t i = 0) const { return tree_->children(id)[i]; }
  [[nodiscard]] std::uint8_t axis(const Slot& slot) const {
    return slot.axis != 0 ? slot.axis : axis_[static_cast<std::size_t>(slot.variable)];
  }
  [[nodiscard]] std::size_t slot_position(ExprId id);
  [[nodiscard]] int index_sign(ExprId id) const;
  [[nodiscard]] bool is_left_out(std::span<const ExprId> factors) const;
  [[nodiscard]] bool enter();
  void fail(std::string reason);

  [[nodiscard]] Operand scalar(ExprId id);
  [[nodiscard]] Operand scalar_of(ExprId id);
  /// Pushes the components; returns where they begin.
  std::size_t array(ExprId id);
  void array_of(ExprId id);

  [[nodiscard]] Operand scalar_factors(ExprId id);
  [[nodiscard]] Operand scalar_power(ExprId id);
  [[nodiscard]] Operand square_of_vector(ExprId id);
  [[nodiscard]] Operand table_entry(ExprId id);
  void outer_product(ExprId id);
  void add_arrays(ExprId id);
  void contraction(ExprId id);
  void cross_product(ExprId id);
  void determinant(ExprId id);
  void particle_sum(ExprId id);
  void index_sum(ExprId id);
  void sum_chain(const IndexChain& chain, std::uint32_t level, std::size_t total, std::size_t count);
  [[nodiscard]] const Definition* plain_definition(ExprId id) const;

  [[nodiscard]] std::uint32_t bound(ParticleId id);
  [[nodiscard]] const std::vector<ParticleId>& others_in(ExprId sum);
  [[nodiscard]] Operand symbol_component(const ExprNode& symbol, std::size_t component);
  [[nodiscard]] Operand unfolded(const Definition& definition, std::uint32_t particle, std::size_t component);
  [[nodiscard]] Operand free_component(const ExprNode& symbol, std::uint32_t particle, std::size_t component);
  [[nodiscard]] std::uint32_t components_of(SymbolId symbol, std::uint32_t particle, std::size_t count);
  template <class Body>
  void inside(const Definition& definition, std::uint32_t particle, std::size_t component, const Body& body);

  const ExprTree* tree_;
  std::span<const Definition> definitions_;
  Code* code_;
  ValueTable values_;
  std::vector<std::uint8_t> axis_;       // by index variable; 0: not bound
  std::vector<std::uint32_t> particle_;  // by particle variable, as InputParticle says; `unbound`
  std::vector<SymbolState> symbols_;
  std::vector<SymbolComponents> known_;
  std::vector<Operand> known_components_;  // two marks among operands: not asked for yet, being unfolded
  std::vector<std::uint32_t> input_of_;    // by symbol and component: input plus 1
  std::vector<SumParticles> sums_;
  std::vector<Operand> stack_;
  std::vector<IndexId> chain_variables_;
  std::uint32_t depth_ = 0;
  std::uint32_t steps_ = 0;
  std::string failure_;
};

}  // namespace rigor
