// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/family/families.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "base/check.h"
#include "numeric/family/family_letters.h"

namespace rigor {
namespace {

using enum FamilyKind;

struct FamilyInfo {
  FamilyKind kind;
  std::string_view name;
  bool has_size;
  std::string_view description;
};

constexpr auto family_infos = std::to_array<FamilyInfo>({
    {FamilyKind::random, "random", false, "vectors in the cube |x| < 1, positive scalars from 1/8 to 8"},
    {angle, "angle", true, "all vectors at this angle to the first, in radians"},
    {orthogonal, "orthogonal", false, "vectors exactly at right angles"},
    {integers, "integers", false, "small whole numbers"},
    {lengths, "lengths", true, "the first vector longer by this factor, the others shorter by it"},
    {gap, "gap", true, "moments, or other letters with digits, this relative distance apart"},
    {thin_axis, "thin axis", false, "all vectors along the body's axis of least moment"},
});

constexpr bool families_follow_enum() {
  for (std::size_t i = 0; i < family_infos.size(); ++i)
    if (static_cast<std::size_t>(family_infos[i].kind) != i) return false;
  return static_cast<std::size_t>(thin_axis) + 1 == family_infos.size();
}
static_assert(families_follow_enum(), "one entry for each kind, in the order of the enumeration");

constexpr auto families = std::to_array<InputFamily>({
    {FamilyKind::random, 0},
    {angle, 1e-4},
    {angle, 1e-8},
    {angle, 1e-15},
    {orthogonal, 0},
    {integers, 0},
    {lengths, 1e160},
    {gap, 1e-4},
    {gap, 1e-8},
    {gap, 1e-12},
    {thin_axis, 0},
});

const FamilyInfo& info(FamilyKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  RIGOR_CHECK(index < family_infos.size(), index);
  return family_infos[index];
}

bool has_letters_with_a_gap(const ExprTree& tree, std::span<const SymbolId> symbols) {
  std::map<std::string, int> numbered;
  for (const SymbolId id : symbols) {
    const Symbol& symbol = tree.symbols[id];
    if (has_gap_between_components(symbol)) return true;
    if (const auto letter = numbered_letter(symbol); letter && ++numbered[letter->base] > 1) return true;
  }
  return false;
}

}  // namespace

std::string name_of(const InputFamily& family) {
  const FamilyInfo& kind = info(family.kind);
  return kind.has_size ? fmt::format("{} {:g}", kind.name, family.size) : std::string(kind.name);
}

std::string_view description_of(FamilyKind kind) { return info(kind).description; }

std::span<const InputFamily> input_families() { return families; }

std::vector<SymbolId> symbols_read(std::span<const Program* const> programs) {
  std::vector<SymbolId> symbols;
  for (const Program* program : programs) {
    for (const ProgramInput& input : program->inputs()) symbols.push_back(input.symbol);
  }
  std::ranges::sort(symbols);
  symbols.erase(std::unique(symbols.begin(), symbols.end()), symbols.end());
  return symbols;
}

bool applies(const InputFamily& family, const ExprTree& tree, std::span<const SymbolId> symbols,
             const Body* body) {
  const auto vectors =
      std::ranges::count_if(symbols, [&](SymbolId id) { return is_free_vector(tree.symbols[id]); });
  const bool turns = std::ranges::any_of(symbols, [&](SymbolId id) { return tree.symbols[id].rotation; });
  switch (family.kind) {
    case FamilyKind::random:
    case integers:
      return true;
    case angle:
      return vectors > 1 || turns;
    case orthogonal:
    case lengths:
      return vectors > 1;
    case gap:
      return has_letters_with_a_gap(tree, symbols);
    case thin_axis:
      return vectors > 0 && body != nullptr;
  }
  return false;
}

}  // namespace rigor
