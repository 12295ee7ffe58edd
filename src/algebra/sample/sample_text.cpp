// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/sample_text.h"

#include "algebra/sample/sample_rotation.h"

namespace rigor {
namespace {

/// The number that gives an angle or a logarithm; empty if the text is no such thing.
[[nodiscard]] std::optional<Rational> number_with(const std::string& text, const Meaning& meaning) {
  const auto read = read_number(text);
  if (!read) return std::nullopt;
  if (read->meaning == meaning) return read->number;
  if (read->meaning.kind != Meaning::Kind::itself || !cln::zerop(read->number)) return std::nullopt;
  return meaning.kind == Meaning::Kind::logarithm ? 1 : 0;
}

}  // namespace

Meaning meaning_in(const Sample& sample, SymbolId symbol) {
  for (const SampleValue& value : sample.values) {
    if (value.symbol != symbol) continue;
    for (const std::string& component : value.components) {
      const auto read = read_number(component);
      if (read && read->meaning.kind != Meaning::Kind::itself) return read->meaning;
    }
  }
  return {};
}

std::optional<std::vector<Rational>> to_components(const SampleValue& value, const Symbol& symbol,
                                                   const Meaning& meaning) {
  std::vector<Rational> components;
  for (const std::string& text : value.components) {
    const std::optional<Rational> number = number_with(text, meaning);
    if (!number) return std::nullopt;
    components.push_back(*number);
  }
  if (components.size() != component_count(symbol)) return std::nullopt;
  if (symbol.unit) {
    const Rational square =
        components[0] * components[0] + components[1] * components[1] + components[2] * components[2];
    if (square != 1) return std::nullopt;
  }
  if (symbol.rotation && !is_rotation(components)) return std::nullopt;
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (components[i] != components[canonical_component(symbol, i)]) return std::nullopt;
  }
  return components;
}

std::vector<SampleValue> values_of(const SamplePoint& point, const ExprTree& tree) {
  std::vector<SampleValue> values;
  for (const SymbolId symbol : point.symbols()) {
    const bool per_particle = tree.symbols[symbol].per_particle;
    for (std::uint32_t p = per_particle ? 1 : 0; p <= (per_particle ? point.particles() : 0); ++p) {
      SampleValue value{.symbol = symbol, .particle = p, .components = {}};
      for (const Rational& component : point.values(symbol, p)) {
        value.components.push_back(to_text(component, point.meaning(symbol)));
      }
      values.push_back(std::move(value));
    }
  }
  return values;
}

}  // namespace rigor
