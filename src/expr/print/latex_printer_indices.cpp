// SPDX-License-Identifier: GPL-3.0-or-later
// Which letter an index variable is written with, and which sums the summation convention gives back.
#include <algorithm>

#include "expr/print/latex_printer.h"

namespace rigor {

const std::set<IndexId>& LatexPrinter::free_in(ExprId id) {
  const auto key = static_cast<std::uint32_t>(id);
  if (const auto known = free_.find(key); known != free_.end()) return known->second;
  std::set<IndexId> found;
  for (const Slot& slot : tree_.slots(id)) {
    if (slot.axis == 0) found.insert(slot.variable);
  }
  for (const ExprId each : tree_.children(id)) {
    const std::set<IndexId>& below = free_in(each);
    found.insert(below.begin(), below.end());
  }
  if (tree_[id].op == Op::index_sum) found.erase(tree_[id].index);
  return free_[key] = std::move(found);
}

const std::set<ParticleId>& LatexPrinter::particles_in(ExprId id) {
  const auto key = static_cast<std::uint32_t>(id);
  if (const auto known = particles_.find(key); known != particles_.end()) return known->second;
  std::set<ParticleId> found;
  if (tree_[id].op == Op::symbol && tree_[id].particle != no_particle) found.insert(tree_[id].particle);
  for (const ExprId each : tree_.children(id)) {
    const std::set<ParticleId>& below = particles_in(each);
    found.insert(below.begin(), below.end());
  }
  if (tree_[id].op == Op::particle_sum) found.erase(tree_[id].particle);
  return particles_[key] = std::move(found);
}

/// Letters that nothing binds keep their names.
void LatexPrinter::name_free(ExprId root) {
  for (const IndexId index : free_in(root))
    letters_[static_cast<std::uint32_t>(index)] = free_letter(tree_.name(index), false);
  for (const ParticleId particle : particles_in(root))
    particle_letters_[static_cast<std::uint32_t>(particle)] = free_letter(tree_.name(particle), true);
}

/// The letter that is wanted, or the first usual one that nothing in scope has.
std::string LatexPrinter::free_letter(const std::string& wanted, bool particle) const {
  const auto taken = [&](const std::string& letter) {
    const auto is_it = [&](const auto& entry) { return entry.second == letter; };
    return std::ranges::any_of(letters_, is_it) || std::ranges::any_of(particle_letters_, is_it);
  };
  if (!taken(wanted)) return wanted;
  static constexpr std::string_view indices[] = {"i", "j", "k", "l", "m", "n", "p",
                                                 "q", "a", "b", "c", "f", "g", "h"};
  static constexpr std::string_view particles[] = {"\\alpha", "\\beta",  "\\gamma", "\\mu",
                                                   "\\nu",    "\\sigma", "\\kappa"};
  const std::span<const std::string_view> usual =
      particle ? std::span<const std::string_view>(particles) : std::span<const std::string_view>(indices);
  for (const std::string_view letter : usual) {
    if (!taken(std::string(letter))) return std::string(letter);
  }
  return wanted;
}

std::string LatexPrinter::slot_text(const Slot& slot, bool lettered) const {
  if (slot.axis > 3) return std::to_string(slot.axis);
  if (slot.axis != 0) return std::string(1, lettered ? "xyz"[slot.axis - 1] : "123"[slot.axis - 1]);
  const auto known = letters_.find(static_cast<std::uint32_t>(slot.variable));
  return known == letters_.end() ? tree_.name(slot.variable) : known->second;
}

/// An index on a principal value goes along with that of another factor; a sum shows what its first term
/// does.
bool LatexPrinter::rides(ExprId id, IndexId index) {
  const ExprNode& node = tree_[id];
  if (node.op == Op::symbol) return notation_.principal.contains(base_of(tree_.symbols, node.symbol));
  for (const Slot& slot : tree_.slots(id)) {
    if (slot.axis == 0 && slot.variable == index) return false;
  }
  for (const ExprId each : tree_.children(id)) {
    if (!free_in(each).contains(index)) continue;
    if (!rides(each, index)) return false;
    if (node.op == Op::add) return true;
  }
  return true;
}

/// Is the letter free in what is printed, where a free letter may stand?
bool LatexPrinter::reads_once(ExprId id, IndexId index) {
  if (const auto part = event_part(id)) return times_on(*part, index) == 1;
  const auto in_slots = [&] {
    return std::ranges::count_if(tree_.slots(id),
                                 [&](const Slot& slot) { return slot.axis == 0 && slot.variable == index; });
  };
  std::size_t holding = 0;
  for (const ExprId each : tree_.children(id)) {
    if (!free_in(each).contains(index)) continue;
    ++holding;
    if (!reads_once(each, index)) return false;
  }
  switch (tree_[id].op) {
    case Op::symbol:
    case Op::basis:
    case Op::delta:
    case Op::epsilon:
      return in_slots() == 1;
    case Op::component:
      return in_slots() + static_cast<std::ptrdiff_t>(holding) == 1;
    case Op::multiply:
    case Op::dot:
    case Op::cross: {
      if (holding <= 1) return true;
      std::size_t own = 0;
      for (const ExprId each : tree_.children(id))
        own += free_in(each).contains(index) && !rides(each, index) ? 1 : 0;
      return own == 1;
    }
    case Op::divide:
      return free_in(child(id, 0)).contains(index) && holding == 1;
    case Op::add:
      return holding == tree_.children(id).size();
    case Op::negate:
    case Op::conjugate:
    case Op::real_part:
    case Op::imaginary_part:
    case Op::index_sum:
    case Op::particle_sum:
    case Op::length:
    case Op::absolute:
    case Op::determinant:
      return true;
    default:
      return false;
  }
}

/// Does the summation convention sum the letter right around the body?
bool LatexPrinter::is_implied(ExprId body, IndexId index) {
  if (const auto part = event_part(body)) return times_on(*part, index) == 2;
  const ExprNode& node = tree_[body];
  const auto in_slots = std::ranges::count_if(
      tree_.slots(body), [&](const Slot& slot) { return slot.axis == 0 && slot.variable == index; });
  if (node.op == Op::component) {
    const bool inside = free_in(child(body)).contains(index);
    if (inside && !reads_once(child(body), index)) return false;
    return in_slots + (inside ? 1 : 0) == 2;
  }
  if (node.op != Op::multiply && node.op != Op::dot && node.op != Op::cross) return in_slots == 2;
  std::size_t own = 0;
  std::size_t riding = 0;
  for (const Operand& operand : operands_of(body)) {
    if (!free_in(operand.id).contains(index)) continue;
    if (!reads_once(operand.id, index)) return false;
    ++(rides(operand.id, index) ? riding : own);
  }
  if (riding > 0 && (own == 1 || own == 2)) return own == 2;
  return own + riding == 2;
}

}  // namespace rigor
