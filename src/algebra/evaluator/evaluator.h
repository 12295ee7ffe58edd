// SPDX-License-Identifier: GPL-3.0-or-later
// The value of an expression, in components: written once, for numbers of any kind. A value of rank r is an
// array of 3^r numbers, row by row. The kinds are exact rationals (`sample_evaluator.h`), rational
// functions at the generic point (`generic_evaluator.h`) and programs of doubles (`rough_program.h`). A kind
// is a class Domain with
//
//   Number                                        copyable; Number{} is 0
//   Number number(const std::string& digits)      Number integer(int)       bool is_zero(const Number&)
//   void add(Number& total, const Number&)        void negate(Number&)
//   Number multiply(const Number&, const Number&) Number divide(const Number&, const Number&)
//   Number power(const Number&, int exponent)     Number root(const Number&)       (non-negative square root)
//   Number function(Function, const Number&)
//   Number real_power(const Number& base, const Number& exponent)
//   Number circle_number()
//   Number value(SymbolId, std::uint32_t particle, std::size_t component)          (of a free symbol)
//   std::vector<Number> particle_sum(std::size_t count, body)   body(particle) gives `count` numbers
//   Number even_power_of_root(const Number& square, int exponent)
//   void check_root(const Number& square)         throws or rejects where `root` does because there is no
//                                                 real root
//   void settle(Number&)                          for a value that will be used again: brings it into its
//                                                 simplest form
//   void step()                                   counts the work; throws where it is too much
//   bool is_rejected() const                      optional: a value was missing, so that nothing more need be
//                                                 evaluated; what is returned then is not looked at
//
// Index and particle variables are bound in an environment of the evaluator: a definition that is unfolded
// sees only its own bindings, so that its dummies never meet the caller's. ε and δ are looked at before the
// other factors of a product, and before the inner sums: most terms of Σ_ijk ε_ijk … are never evaluated.
// They alone leave terms out: 0 · 1/0 has no value (`evaluator_undefined.h`).
// Recursion: the parser bounds a tree's depth at 256 levels; unfolded definitions add theirs, up to
// `largest_depth`.
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "algebra/engine/undecidable.h"
#include "algebra/point/scope.h"

namespace rigor {

/// ε_ijk for axes 1..3: the sign of the permutation, 0 where two are equal.
[[nodiscard]] constexpr int permutation_sign(int i, int j, int k) { return (i - j) * (j - k) * (k - i) / 2; }

template <class Domain>
class Evaluator {
 public:
  using Number = typename Domain::Number;
  using Array = std::vector<Number>;

  Evaluator(const Scope& scope, Domain& domain)
      : scope_(&scope),
        tree_(&scope.tree()),
        domain_(&domain),
        axis_(scope.tree().index_count(), 0),
        particle_(scope.tree().particle_count(), 0) {}

  void bind(IndexId index, std::uint8_t axis) { axis_[static_cast<std::size_t>(index)] = axis; }
  void bind(ParticleId id, std::uint32_t particle) { particle_[static_cast<std::size_t>(id)] = particle; }

  /// Forgets what unfolded symbols are worth: for when the values of free symbols have changed.
  void forget() { unfolded_.clear(); }

  [[nodiscard]] Number scalar(ExprId id);
  [[nodiscard]] Array array(ExprId id);
  /// All components of what is defined, for a particle (0: of no particle).
  [[nodiscard]] Array value_of(const Definition& definition, std::uint32_t particle);

 private:
  /// Counts a level of recursion for as long as it lives.
  class Level {
   public:
    explicit Level(std::uint32_t& depth) : depth_(depth) {
      if (++depth_ > largest_depth) throw Undecidable("it nests too deeply, or its definitions are circular");
    }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    std::uint32_t& depth_;
  };

  /// Unwinding as deep as the tree would take longer than evaluating it.
  [[nodiscard]] bool is_rejected() const {
    if constexpr (requires { domain_->is_rejected(); }) return domain_->is_rejected();
    return false;
  }
  [[nodiscard]] const ExprNode& node(ExprId id) const { return (*tree_)[id]; }
  [[nodiscard]] ExprId child(ExprId id, std::size_t i = 0) const { return tree_->children(id)[i]; }
  [[nodiscard]] std::uint8_t axis(const Slot& slot) const {
    return slot.axis != 0 ? slot.axis : axis_[static_cast<std::size_t>(slot.variable)];
  }
  [[nodiscard]] std::uint32_t bound(ParticleId id) const {
    return id == no_particle ? 0 : particle_[static_cast<std::size_t>(id)];
  }
  [[nodiscard]] std::size_t slot_position(ExprId id) const;
  [[nodiscard]] std::size_t dimension_at(ExprId id, std::size_t slot) const;
  [[nodiscard]] int index_sign(ExprId id) const;

  [[nodiscard]] bool is_left_out(ExprId id) const;
  [[nodiscard]] Number scalar_factors(ExprId id);
  void demand_value(ExprId id);
  [[nodiscard]] bool may_lack_value(ExprId id);
  [[nodiscard]] const Definition* plain_definition(ExprId id) const;
  [[nodiscard]] Number scalar_power(ExprId id);
  [[nodiscard]] Number square_of_vector(const Array& v);
  [[nodiscard]] Array contraction(ExprId id);
  [[nodiscard]] Array cross_product(const Array& a, const Array& b);
  [[nodiscard]] Array outer_product(ExprId id);
  [[nodiscard]] Array determinant(ExprId id);
  [[nodiscard]] Array sum_over_particles(ExprId id);

  /// Nested sums over components, taken together.
  struct IndexChain {
    std::vector<IndexId> variables;
    std::vector<ExprId> guards;  // the ε and δ among the factors of the body
    ExprId body{};
  };
  [[nodiscard]] IndexChain index_chain(ExprId id) const;
  /// Calls `term()` for all values of the chain's variables but those at which a guard is 0; then the
  /// variables are as before.
  template <class Term>
  void for_each_index(const IndexChain& chain, const Term& term);
  template <class Term>
  void for_each_value(const IndexChain& chain, std::size_t level, const Term& term);

  void add_to(Array& total, const Array& summand);
  [[nodiscard]] Number symbol_component(const ExprNode& symbol, std::size_t component);
  [[nodiscard]] Array whole_symbol(const ExprNode& symbol);
  [[nodiscard]] Number unfolded_component(const Definition& definition, std::uint32_t particle,
                                          std::size_t component);
  template <class Body>
  auto outside_sums(const Body& body);
  template <class Body>
  auto inside(const Definition& definition, std::uint32_t particle, std::size_t component, const Body& body);

  const Scope* scope_;
  const ExprTree* tree_;
  Domain* domain_;
  std::vector<std::uint8_t> axis_;       // by index variable; 0: not bound
  std::vector<std::uint32_t> particle_;  // by particle variable
  std::unordered_map<std::uint64_t, std::vector<std::optional<Number>>> unfolded_;  // by symbol and particle
  std::vector<std::optional<bool>> may_lack_value_;                                 // by node
  std::uint32_t depth_ = 0;
};

}  // namespace rigor

#include "algebra/evaluator/evaluator_operations.h"
#include "algebra/evaluator/evaluator_products.h"
#include "algebra/evaluator/evaluator_symbols.h"
#include "algebra/evaluator/evaluator_undefined.h"
