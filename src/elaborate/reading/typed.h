// SPDX-License-Identifier: GPL-3.0-or-later
// An expression that was read, with the letters that are still open in it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

/// Where an index of space-time stands; of other spaces it makes no difference.
enum class Height : std::uint8_t { none, above, below };

/// An index letter that no sum has bound yet, and where it stands.
struct FreeIndex {
  std::string letter;
  IndexId id{};
  Span span;
  bool rides = false;  // on a principal value `I_i`, which is not counted as an occurrence
  Height height = Height::none;
};

struct FreeParticle {
  std::string letter;
  ParticleId id{};
  Span span;
};

/// Is it written in rows and columns? Side by side, such factors are multiplied as matrices are. A triple is
/// a vector of three matrices: rank 3, and its first axis is one of space.
enum class Layout : std::uint8_t { none, matrix, column, row, triple };

/// An expression with what its type says.
struct Typed {
  ExprId id{};
  int rank = 0;
  std::vector<FreeIndex> free = {};          // each letter once
  std::vector<FreeParticle> particles = {};  // each letter once
  std::vector<FreeIndex> bound = {};         // letters summed inside
  Layout layout = Layout::none;
  std::optional<ExprId> with_unit = {};  // what it is a multiple of the unit matrix by, if a matrix is meant
};

/// Nothing where there is a mistake, which a diagnostic reports.
using MaybeTyped = std::optional<Typed>;

/// The union of both lists by letter.
template <typename Free>
void merge_free(std::vector<Free>& into, const std::vector<Free>& from) {
  for (const Free& entry : from) {
    const auto same = [&](const Free& old) { return old.letter == entry.letter; };
    if (std::ranges::none_of(into, same)) into.push_back(entry);
  }
}
/// All letters of `part` are letters of `into` as well.
void merge_letters(Typed& into, const Typed& part);

/// One operation on its operands, with the letters of all.
[[nodiscard]] Typed apply_op(ExprTree& tree, Op op, Span span, int rank, const std::vector<Typed>& operands,
                             int exponent = 0);
/// The components of a vector, or of a tensor row by row, along the axes of the space.
[[nodiscard]] Typed tuple_of(ExprTree& tree, Space space, Span span, const std::vector<Typed>& entries);
[[nodiscard]] ExprId sum_of(ExprTree& tree, const std::vector<ExprId>& terms, int rank, Span span);
[[nodiscard]] bool is_literal_zero(const ExprTree& tree, const Typed& typed);

}  // namespace rigor
