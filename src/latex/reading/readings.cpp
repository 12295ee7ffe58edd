// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/reading/readings.h"

#include <utility>

#include "latex/parse/parse.h"

namespace rigor {
namespace {

std::vector<SyntaxId> parse_sides(const WrittenChain& chain, SyntaxTree& syntax, Choices& choices) {
  std::vector<SyntaxId> sides;
  for (const WrittenSide& side : chain.sides) {
    const bool left_elsewhere = sides.empty() && side.tokens.empty();
    sides.push_back(
        left_elsewhere
            ? syntax.add_opaque(
                  side.span, {DiagnosticKind::unsupported, "the left side of this equation is elsewhere", {}})
            : parse_side(side.tokens, side.span, syntax, &choices));
  }
  return sides;
}

}  // namespace

Readings parse_readings(const WrittenChain& chain, SyntaxTree& syntax) {
  Choices first;
  Readings readings{.sides = parse_sides(chain, syntax, first), .choices = {}, .others = {}};
  readings.choices = std::move(first.met);
  const auto read_with = [&](Choices choices) {
    readings.others.push_back(parse_sides(chain, syntax, choices));
  };
  if (readings.choices.empty()) return readings;
  read_with({.rest = true});
  if (readings.choices.size() == 2) {
    read_with({.seconds = {false, true}});
    read_with({.seconds = {true, false}});
  }
  return readings;
}

}  // namespace rigor
