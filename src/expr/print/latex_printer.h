// SPDX-License-Identifier: GPL-3.0-or-later
// The walk behind print_latex: each node becomes a piece of LaTeX that knows how tightly it holds together.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "expr/print/notation.h"
#include "expr/tree/latex_name.h"
#include "expr/tree/tree.h"

namespace rigor {

class LatexPrinter {
 public:
  /// Both are kept by reference.
  LatexPrinter(const ExprTree& tree, const Notation& notation) : tree_(tree), notation_(notation) {}

  [[nodiscard]] std::string print(ExprId root);

 private:
  /// What the text is: a + b or −a, a product, a factor, or what scripts may be on.
  enum class Level : std::uint8_t { sum, term, factor, base };
  struct Piece {
    std::string text;
    Level level = Level::base;
    bool open = false;       // takes in the factors that follow
    bool bracketed = false;  // is in round brackets
    bool headed = false;     // a sum or integral sign stands first, so that it may be a last factor
  };
  enum class Sign : std::uint8_t { side_by_side, dot, cross };
  struct Operand {
    ExprId id{};
    Sign sign = Sign::side_by_side;  // before it
  };

  // latex_printer.cpp
  Piece piece(ExprId id);
  Piece sum(ExprId id);
  bool is_metric_sign(ExprId id) const;
  Piece quotient(ExprId id);
  Piece power(ExprId id);
  Piece real_power(ExprId id);
  Piece function(ExprId id, int exponent);
  Piece raised(ExprId id, const char* mark);
  bool has_letter_e() const;
  Piece bars(ExprId id);
  Piece component(ExprId id);
  Piece entries(ExprId id);
  Piece determinant(ExprId id);
  Piece table(ExprId id);
  std::string condition(ExprId id, std::size_t value, const std::vector<std::string>& letters) const;
  std::string text(ExprId id) { return piece(id).text; }
  Piece in_brackets(const Piece& inside) const;
  /// In brackets, unless it holds together as tightly as asked.
  Piece at_least(Level level, ExprId id);

  // latex_printer_terms.cpp
  std::vector<Operand> operands_of(ExprId id) const;
  Piece term(ExprId id);
  void join(std::string& text, const Operand& before, const Operand& next, const Piece& before_piece,
            const Piece& next_piece) const;
  bool reads_as_argument(ExprId before, ExprId next, const Piece& next_piece) const;
  bool is_plain_letter(ExprId id) const;
  [[nodiscard]] bool is_ket(ExprId id) const;
  bool is_unit(ExprId id) const;
  Piece unit(ExprId id, bool behind_number);
  Piece index_sum(ExprId id);
  Piece particle_sum(ExprId id);
  std::optional<Piece> integral(ExprId id);

  // latex_printer_indices.cpp
  const std::set<IndexId>& free_in(ExprId id);
  const std::set<ParticleId>& particles_in(ExprId id);
  void name_free(ExprId root);
  std::string free_letter(const std::string& wanted, bool particle) const;
  bool rides(ExprId id, IndexId index);
  bool reads_once(ExprId id, IndexId index);
  bool is_implied(ExprId body, IndexId index);
  std::string slot_text(const Slot& slot, bool lettered) const;

  // latex_printer_symbols.cpp
  Piece symbol(ExprId id);
  Piece derivative(ExprId id, const Symbol& symbol);
  static Piece differentiated(Piece of, std::string above, const std::string& below);
  Piece by_letters(Piece result, const Derivation& derivation) const;
  Piece plain_symbol(SymbolId base, const ExprNode& node, std::span<const Slot> slots, int dots) const;
  LatexName name_of(SymbolId base) const;
  std::string whole_letter(SymbolId base, const LatexName& name) const;
  bool names_another(SymbolId base, const LatexName& name, std::span<const Slot> slots) const;
  bool is_lettered(SymbolId base) const;
  bool is_any_lettered(ExprId id) const;
  bool length_is_plain(ExprId id) const;
  Piece basis(const Slot& slot) const;

  // latex_printer_fields.cpp
  std::optional<Piece> field(ExprId id);
  std::optional<Piece> nabla(ExprId id);
  std::optional<Piece> turned(ExprId id);
  std::optional<Piece> primed_component(ExprId id);
  std::optional<Piece> primed_basis(ExprId id) const;
  std::optional<std::string> whole_tensor(ExprId id);
  const ExprNode* derivative_symbol(ExprId id, int orders) const;
  bool has_axes(ExprId id, SymbolId symbol, const std::vector<std::uint8_t>& axes) const;
  bool is_whole_at(ExprId id, SymbolId symbol, int missing, std::vector<std::uint8_t>& axes,
                   const std::vector<std::uint8_t>& behind) const;
  bool is_rate(ExprId rate, ExprId of) const;
  ExprId child(ExprId id, std::size_t which = 0) const { return tree_.children(id)[which]; }

  // latex_printer_events.cpp
  /// A symbol with its indices, signs and derivatives: `\partial_\mu A^\nu`.
  struct EventPart {
    ExprId thing{};
    SymbolId symbol{};
    std::vector<Slot> own = {};
    std::vector<Slot> by = {};      // of ∂, from the outside
    std::vector<Slot> turned = {};  // lowered, and of ∂ raised
  };
  std::optional<EventPart> event_part(ExprId id) const;
  static std::size_t times_on(const EventPart& part, IndexId index);
  std::string event_slot_text(const Slot& slot) const;
  static std::string staggered(const std::string& labels,
                               const std::vector<std::pair<std::string, bool>>& indices);
  std::string event_indices(const std::string& labels, std::span<const Slot> slots, std::vector<Slot>& turned,
                            SymbolId symbol) const;
  std::optional<Piece> event(ExprId id);

  const ExprTree& tree_;
  const Notation& notation_;
  std::unordered_map<std::uint32_t, std::set<IndexId>> free_;
  std::unordered_map<std::uint32_t, std::set<ParticleId>> particles_;
  std::unordered_map<std::uint32_t, std::string> letters_;           // of index variables in scope
  std::unordered_map<std::uint32_t, std::string> particle_letters_;  // of particles in scope
  int bars_ = 0;                                                     // that are open
};

}  // namespace rigor
