// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/dimension/dimension_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/among.h"

namespace rigor {
namespace {

constexpr std::size_t most_places = 3;

bool is_alone(const DimensionForm& form, Unknown unknown) {
  return form.fixed.is_none() && form.unknowns.size() == 1 && form.unknowns.begin()->first == unknown &&
         form.unknowns.begin()->second == SmallRational(1);
}

}  // namespace

/// In order, each once.
std::vector<Span> DimensionWords::places_of(const Reasons& reasons, DimensionReason::Kind kind) const {
  std::vector<Span> places;
  for (const auto& [reason, factor] : reasons) {
    const DimensionReason& entry = reasons_[reason];
    const bool is_new = !is_one_of(entry.span, places);
    if (entry.kind == kind && is_new) places.push_back(entry.span);
  }
  return places;
}

/// `M L^2`; what is not known is in brackets, `[v] T`.
std::string DimensionWords::text_of(const DimensionForm& form) const {
  const DimensionForm known = known_.reduce(form).form;
  std::string text = known.fixed.is_none() ? "" : known.fixed.text();
  for (const auto& [unknown, factor] : known.unknowns) {
    const std::string& name = record_.unknowns[unknown].text;
    text += (text.empty() ? "" : " ") + power_text(fmt::format("[{}]", name.empty() ? "?" : name), factor);
  }
  return text.empty() ? "1" : text;
}

/// A symbol that stands alone, as a side or a term, and whose dimension an earlier statement gave. A line of
/// `units` is compared with others of its kind.
std::optional<DimensionWords::Blamed> DimensionWords::blamed(
    const DimensionEquation& equation, const DimensionSystem::Contradiction& contradiction) const {
  DimensionForm difference = equation.left;
  difference.add(equation.right, -1);
  using Kind = DimensionReason::Kind;
  const Kind kind = equation.alike == Alike::known ? Kind::units : Kind::statement;
  for (const auto& [unknown, factor] : difference.unknowns) {
    DimensionForm own;
    own.add(unknown, 1);
    const DimensionSystem::Reduced known = known_.reduce(own);
    const std::vector<Span> places = places_of(known.reasons, kind);
    const bool by_time = std::ranges::any_of(known.reasons, [&](const auto& entry) {
      return reasons_[entry.first].kind == DimensionReason::Kind::time;
    });
    const bool alone = is_alone(equation.left, unknown) || is_alone(equation.right, unknown);
    const bool named = !record_.unknowns[unknown].text.empty();
    if (!alone || !named || !known.form.unknowns.empty() || places.empty() || by_time) continue;
    return Blamed{unknown, known.form.fixed,
                  known.form.fixed - contradiction.ratio * (SmallRational(1) / factor), places.back()};
  }
  return std::nullopt;
}

std::string DimensionWords::compared(const DimensionEquation& equation) const {
  const std::string left = text_of(equation.left);
  const std::string right = text_of(equation.right);
  switch (equation.alike) {
    case Alike::terms:
      return fmt::format("terms of a sum have different dimensions: {} and {}", left, right);
    case Alike::components:
      return fmt::format("components have different dimensions: {} and {}", left, right);
    case Alike::argument:
      return fmt::format("the argument of a function has the dimension {}", left);
    case Alike::number:
      return fmt::format("a number is where a quantity of dimension {} is expected",
                         equation.left.is_none() ? right : left);
    case Alike::known:
      return fmt::format("one quantity has two dimensions: {} and {}", left, right);
    case Alike::sides:
      break;
  }
  return fmt::format("the sides have different dimensions: left is {}, right is {}", left, right);
}

Diagnostic DimensionWords::describe(const DimensionEquation& equation,
                                    const DimensionSystem::Contradiction& contradiction, Span place) const {
  const bool by_time = std::ranges::any_of(contradiction.reasons, [&](const auto& entry) {
    return reasons_[entry.first].kind == DimensionReason::Kind::time;
  });
  const std::vector<Span> places = places_of(contradiction.reasons, DimensionReason::Kind::statement);
  const bool sides = equation.alike == Alike::sides || equation.alike == Alike::number;
  const auto blame =
      by_time || equation.alike == Alike::number ? std::nullopt : blamed(equation, contradiction);
  Diagnostic diagnostic{DiagnosticKind::dimension_mismatch, sides ? place : equation.right_span,
                        compared(equation)};
  if (equation.left_span != equation.right_span) {
    diagnostic.labels.push_back({equation.left_span, text_of(equation.left)});
    if (sides) diagnostic.labels.push_back({equation.right_span, text_of(equation.right)});
  }
  if (blame) {
    diagnostic.kind = DiagnosticKind::dimension_clash;
    diagnostic.message =
        fmt::format("`{}` has the dimension {} by line {}, and {} here", record_.unknowns[blame->symbol].text,
                    blame->before.text(), line_of(blame->earlier), blame->here.text());
    diagnostic.labels.push_back({blame->earlier, blame->before.text()});
    return diagnostic;
  }
  if (equation.alike == Alike::number) {
    diagnostic.kind = DiagnosticKind::dimension_doubt;
    diagnostic.help = {"its unit may have been left out; with a unit, write it like `3\\,\\mathrm{m}`"};
  } else if (by_time) {
    diagnostic.kind = DiagnosticKind::dimension_doubt;
    diagnostic.message += ", unless the time is a number";
    diagnostic.help = {
        "`rigor: units …` says which dimension is meant; `units t: 1` makes the time a number"};
  }
  for (std::size_t k = 0; k < places.size() && k < most_places; ++k)
    diagnostic.labels.push_back({places[k], "together with this"});
  return diagnostic;
}

}  // namespace rigor
