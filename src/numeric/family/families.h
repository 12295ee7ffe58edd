// SPDX-License-Identifier: GPL-3.0-or-later
// Families of inputs: values for the free letters of programs, harmless ones and such that strain a formula.
// The same for the same seed on every machine: no function of <cmath> is used but the square root and ldexp.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "expr/tree/tree.h"
#include "numeric/body/body.h"
#include "numeric/body/body_letters.h"
#include "numeric/program/samples.h"

namespace rigor {

enum class FamilyKind : std::uint8_t {
  random,      // vectors in the cube |x| < 1, positive scalars from 1/8 to 8
  angle,       // all vectors at an angle of the tangent `size` to the first; rotations by about `size`
  orthogonal,  // vectors along three axes that are exactly at right angles, a fourth along the first again
  integers,    // small whole numbers
  lengths,     // the first vector longer by `size`, the others shorter by it
  gap,  // I_1, I_2, I_3 a relative distance of `size` apart; so are the eigenvalues of symmetric tensors
  thin_axis,  // all vectors along the body's axis of least moment
};

struct InputFamily {
  FamilyKind kind = FamilyKind::random;
  double size = 0;
};

/// `random`, `angle 1e-08`, `lengths 1e+160`, `thin axis`.
[[nodiscard]] std::string name_of(const InputFamily& family);
/// One line.
[[nodiscard]] std::string_view description_of(FamilyKind kind);
/// All that reports show, `random` first.
[[nodiscard]] std::span<const InputFamily> input_families();

/// What programs read, each once, in the order of the table.
[[nodiscard]] std::vector<SymbolId> symbols_read(std::span<const Program* const> programs);

/// Is there something that the family is about: two vectors, a rotation, letters with a gap, a body?
[[nodiscard]] bool applies(const InputFamily& family, const ExprTree& tree, std::span<const SymbolId> symbols,
                           const Body* body);

struct DrawOptions {
  std::size_t samples = 256;
  std::size_t particles = 4;  // without a body
  std::uint64_t seed = 1;
  const Body* body = nullptr;
  BodyLetters letters = {};  // of the body's masses and positions
};

/// Values for all components of the symbols: unit vectors have length 1 and rotations are orthogonal to
/// rounding, symmetric tensors are positive definite and obey the triangle inequality of moments of inertia,
/// units of measure are 1. What is drawn for a symbol depends on the seed and its id, not on the others (but
/// for which vector is the first, and the axes of `orthogonal`). The letters that the body does not give are
/// drawn for each of its particles; where that would be more than 2^20 numbers, they are the same for all
/// samples. Fails where a thin axis is asked for without a body.
[[nodiscard]] Result<Samples> draw_samples(const ExprTree& tree, std::span<const SymbolId> symbols,
                                           const InputFamily& family, const DrawOptions& options);

}  // namespace rigor
