// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_values.h"

#include <fmt/format.h>

#include "scene/quantity_text.h"

namespace rigor {
namespace {

Dimension moment_dimension() { return mass_dimension() + length_dimension() + length_dimension(); }

}  // namespace

std::optional<MissingValue> SceneValues::settle_axes(const std::set<SceneRole>& read) {
  const bool moments = read.contains(SceneRole::moment);
  const bool oriented = read.contains(SceneRole::spin) || read.contains(SceneRole::position) ||
                        read.contains(SceneRole::tensor) || read.contains(SceneRole::value);
  if (!moments && scene_.axes != SceneAxes::principal) return std::nullopt;
  if (!moments && !oriented) return std::nullopt;
  const auto along = body_.is_along_principal_axes();
  if (!along) return MissingValue{along.error().reason, {}};
  principal_ = true;
  if (*along) return std::nullopt;
  if (oriented && scene_.axes == SceneAxes::not_said) {
    return MissingValue{
        "principal moments are needed, and the body does not lie along its principal axes",
        "say with `axes = \"principal\"` or `axes = \"body\"` along which the components are given"};
  }
  turn_places_ = true;
  turn_ = scene_.axes == SceneAxes::body;
  return std::nullopt;
}

std::optional<MissingValue> SceneValues::provide(const Program& program) {
  for (const ProgramInput& input : program.inputs()) {
    if (values_.find(input.symbol) != nullptr) continue;
    const SceneLetter* letter = letters_.find(input.symbol);
    if (letter == nullptr) return missing(input.symbol);
    if (letter->role == SceneRole::spin_rate) continue;
    auto value = value_of(*letter);
    if (!value) {
      const bool no_spin = letter->role == SceneRole::spin && !scene_.spin;
      return MissingValue{value.error().reason, no_spin ? "add `spin = [\"1 rad/s\", 0, 0]`, say" : ""};
    }
    values_.set(input.symbol, std::move(*value));
  }
  return std::nullopt;
}

Result<Vector3> SceneValues::spin() {
  if (!scene_.spin) {
    return tl::unexpected(
        Error{fmt::format("`{}` is needed, and the scene has no spin", scene_.symbols.spin.text)});
  }
  auto along = turned_value({scene_.spin->begin(), scene_.spin->end()});
  if (!along) return tl::unexpected(along.error());
  return Vector3{along->components[0], along->components[1], along->components[2]};
}

Result<Quaternion> SceneValues::orientation() {
  const Quaternion given = scene_.orientation.value_or(Quaternion{1, 0, 0, 0});
  if (!turn_) return given;
  const auto& axes = body_.axes();
  if (!axes) return tl::unexpected(axes.error());
  return composed(given, turn_to(*axes));
}

Result<LetterValue> SceneValues::value_of(const SceneLetter& letter) {
  switch (letter.role) {
    case SceneRole::mass:
      return LetterValue{{}, {body_.body().masses}};
    case SceneRole::position: {
      if (!turn_places_)
        return LetterValue{{}, {body_.body().positions.begin(), body_.body().positions.end()}};
      const auto& places = body_.places_along_axes();
      if (!places) return tl::unexpected(places.error());
      return LetterValue{{}, {places->begin(), places->end()}};
    }
    case SceneRole::spin: {
      const auto along = spin();
      if (!along) return tl::unexpected(along.error());
      return LetterValue{{along->begin(), along->end()}, {}};
    }
    case SceneRole::moment:
      return moment(letter.which);
    case SceneRole::tensor:
      return tensor();
    case SceneRole::value:
      return turned_value(scene_.values[letter.which].components);
    case SceneRole::spin_rate:
      break;
  }
  return tl::unexpected(Error{"the rates of the spin follow from its law of motion"});
}

Result<LetterValue> SceneValues::moment(std::size_t which) {
  if (turn_) {  // the axes are needed anyway, and their order is the moments'
    const auto& axes = body_.axes();
    if (!axes) return tl::unexpected(axes.error());
  }
  const auto& moments = body_.moments();
  if (!moments) return tl::unexpected(moments.error());
  return LetterValue{{(*moments)[which].high}, {}, {(*moments)[which].low}};
}

Result<LetterValue> SceneValues::tensor() {
  if (turn_places_) {
    const auto& moments = body_.moments();
    if (!moments) return tl::unexpected(moments.error());
    LetterValue value{std::vector<double>(9), {}, std::vector<double>(9)};
    for (std::size_t k = 0; k < 3; ++k) {
      value.components[4 * k] = (*moments)[k].high;
      value.lows[4 * k] = (*moments)[k].low;
    }
    return value;
  }
  const auto& inertia = body_.tensor();
  if (!inertia) return tl::unexpected(inertia.error());
  LetterValue value;
  for (const Position& row : *inertia)
    value.components.insert(value.components.end(), row.begin(), row.end());
  return value;
}

/// A vector's or tensor's components, turned to the principal axes if they are given along others.
Result<LetterValue> SceneValues::turned_value(std::vector<double> components) {
  if (!turn_ || components.size() == 1) return LetterValue{std::move(components), {}};
  const auto& axes = body_.axes();
  if (!axes) return tl::unexpected(axes.error());
  // Each axis of the value in turn: new_k.. = Σ axes[k][i] old_i..
  for (std::size_t stride = components.size() / 3; stride > 0; stride /= 3) {
    std::vector<double> turned(components.size(), 0.0);
    for (std::size_t at = 0; at < components.size(); ++at) {
      const std::size_t k = at / stride % 3;
      for (std::size_t i = 0; i < 3; ++i) {
        turned[at] += (*axes)[k][i] * components[at - k * stride + i * stride];
      }
    }
    components = std::move(turned);
  }
  return LetterValue{std::move(components), {}};
}

MissingValue SceneValues::missing(SymbolId symbol) const {
  const std::string& name = tree_.symbols[symbol].name;
  return {fmt::format("`{}` is needed, and has no value", name),
          fmt::format(
              "give it one under [values], or say under [symbols] that `{}` is the mass, the position, the "
              "spin or a principal moment",
              name)};
}

std::optional<Dimension> SceneValues::dimension_of(SymbolId symbol) const {
  const SceneLetter* letter = letters_.find(symbol);
  if (letter == nullptr) return std::nullopt;
  switch (letter->role) {
    case SceneRole::mass:
      return mass_dimension();
    case SceneRole::position:
      return length_dimension();
    case SceneRole::spin:
      return rate_dimension();
    case SceneRole::spin_rate:
      return rate_dimension() + rate_dimension();
    case SceneRole::moment:
      return moment_dimension();
    case SceneRole::tensor:
      return std::nullopt;  // by its definition, if the notes have one
    case SceneRole::value:
      return scene_.values[letter->which].dimension;
  }
  return std::nullopt;
}

}  // namespace rigor
