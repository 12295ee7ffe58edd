// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/motion/letter_values.h"

#include <algorithm>

#include "base/among.h"

namespace rigor {

const LetterValue* LetterValues::find(SymbolId symbol) const {
  const auto found = values_.find(symbol);
  return found == values_.end() ? nullptr : &found->second;
}

bool LetterValues::are_sharp(const Program& program) const {
  return std::ranges::any_of(program.inputs(), [this](const ProgramInput& input) {
    const LetterValue* value = find(input.symbol);
    return value != nullptr && !value->lows.empty();
  });
}

std::optional<ProgramInput> LetterValues::fill(const Program& program, Samples& samples,
                                               const std::vector<SymbolId>& left_out) const {
  for (const ProgramInput& input : program.inputs()) {
    if (is_one_of(input.symbol, left_out)) continue;
    const LetterValue* value = find(input.symbol);
    if (value == nullptr) return input;
    if (input.per_particle) {
      if (input.component >= value->particles.size()) return input;
      samples.borrow_particles(input.symbol, input.component, value->particles[input.component]);
      if (!value->particle_errors.empty())
        samples.set_errors(input.symbol, input.component, value->particle_errors[input.component]);
    } else {
      if (input.component >= value->components.size()) return input;
      const double low = value->lows.empty() ? 0 : value->lows[input.component];
      samples.set(input.symbol, input.component, HighLow{value->components[input.component], low});
      if (!value->digits.empty())
        samples.set_digits(input.symbol, input.component, value->digits[input.component]);
      if (!value->errors.empty())
        samples.set_errors(input.symbol, input.component, {value->errors[input.component]});
    }
  }
  return std::nullopt;
}

std::vector<Definition> without_definitions_of(const std::vector<SymbolId>& valued,
                                               const std::vector<Definition>& definitions) {
  std::vector<Definition> kept;
  for (const Definition& definition : definitions) {
    if (!is_one_of(definition.symbol, valued)) kept.push_back(definition);
  }
  return kept;
}

}  // namespace rigor
