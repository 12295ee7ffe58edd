// SPDX-License-Identifier: GPL-3.0-or-later
// Units of measure: `3\,\mathrm{kg}`.
#include "elaborate/name/measure_unit.h"
#include "elaborate/notation/notations.h"
#include "latex/unit/units.h"

namespace rigor {

MaybeTyped elaborate_unit(Reading& reading, SyntaxId id, const Around&) {
  const Span span = reading.syntax[id].span;
  std::string problem;
  const auto written = read_unit(reading.syntax.text(id), UnitNames::units, &problem);
  if (!written) return unsupported(reading, span, std::move(problem));
  const auto unit = unit_expression(reading.tree, reading.names, *written, span, &problem);
  if (!unit) return unsupported(reading, span, std::move(problem));
  return Typed{.id = *unit};
}

}  // namespace rigor
