// SPDX-License-Identifier: GPL-3.0-or-later
// What the letters of the notes stand for in a scene: numbers in SI units, one for each component, or one for
// each component and particle.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "numeric/program/program.h"
#include "numeric/program/samples.h"

namespace rigor {

struct LetterValue {
  std::vector<double> components;                  // 3^rank, row by row; unless per particle
  std::vector<std::span<const double>> particles;  // of each component, one for each particle; not owned
  std::vector<double> lows = {};                   // of the components, where they are known to 106 bits
  /// Bounds of the errors of the components, or of the values of each for all particles; empty: they are
  /// exact.
  std::vector<double> errors = {};
  std::vector<ErrorBounds> particle_errors = {};
  std::vector<LongNumber> digits = {};  // of each component; empty: there are no more
};

class LetterValues {
 public:
  void set(SymbolId symbol, LetterValue value) { values_[symbol] = std::move(value); }
  [[nodiscard]] const LetterValue* find(SymbolId symbol) const;
  /// Does the program read a value that is known to more than 53 bits?
  [[nodiscard]] bool are_sharp(const Program& program) const;

  /// Puts what the program reads into the samples, with its errors, the same for all of them. `left_out` are
  /// put in by the caller. Particles' values are borrowed, not copied. Returns the first input that has no
  /// value.
  [[nodiscard]] std::optional<ProgramInput> fill(const Program& program, Samples& samples,
                                                 const std::vector<SymbolId>& left_out = {}) const;

 private:
  std::map<SymbolId, LetterValue> values_;
};

/// Definitions without those of the symbols that have a value of their own: a value wins.
[[nodiscard]] std::vector<Definition> without_definitions_of(const std::vector<SymbolId>& valued,
                                                             const std::vector<Definition>& definitions);

}  // namespace rigor
