// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/quantity/scene_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numeric/body/body_errors.h"
#include "scene/file/quantity_text.h"

namespace rigor {
namespace {

/// Of components turned to axes that are off by so much: for each index that and 4 u of the size of all.
std::vector<double> turning_errors_of(const std::vector<double>& components, const Position& axes) {
  double size = 0;
  for (const double each : components) size = std::hypot(size, each);
  double of_index = std::max({axes[0], axes[1], axes[2]}) + 4 * 0x1p-53;
  double all = 0;
  for (std::size_t stride = components.size(); stride > 1; stride /= 3)
    all = all * (1 + 2 * of_index) + of_index;
  const double error = size == 0 ? 0 : size * all * (1 + 0x1p-20) + 0x1p-1060;
  return std::vector<double>(components.size(), error);
}

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
        "principal moments are needed, but the body's axes are not its principal axes",
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
    if (value && scene_.errors) add_particle_errors(*value, letter->role);
    if (!value) {
      const bool no_spin = letter->role == SceneRole::spin && !scene_.spin;
      return MissingValue{value.error().reason, no_spin ? "add `spin = [\"1 rad/s\", 0, 0]`, say" : ""};
    }
    values_.set(input.symbol, std::move(*value));
  }
  return std::nullopt;
}

Result<LetterValue> SceneValues::spin_value() {
  if (!scene_.spin) {
    return tl::unexpected(
        Error{fmt::format("`{}` is needed, but the scene has no spin", scene_.symbols.spin.text)});
  }
  return turned_value({scene_.spin->begin(), scene_.spin->end()});
}

Result<Vector3> SceneValues::spin() {
  return spin_value().map([](const LetterValue& value) {
    return Vector3{value.components[0], value.components[1], value.components[2]};
  });
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
    case SceneRole::position:
      if (turn_places_) {
        if (const auto& turned = body_.turn_places(); !turned) return tl::unexpected(turned.error());
      }
      return LetterValue{{}, {body_.body().positions.begin(), body_.body().positions.end()}};
    case SceneRole::spin:
      return spin_value();
    case SceneRole::moment:
      return moment(letter.which);
    case SceneRole::tensor:
      return tensor();
    case SceneRole::value:
      return turned_value(scene_.values[letter.which].components);
    case SceneRole::spin_rate:
      break;
  }
  return refuse("the rates of the spin follow from its law of motion");
}

/// Of the body's particles, for whoever bounds errors.
void SceneValues::add_particle_errors(LetterValue& value, SceneRole role) {
  if (role == SceneRole::mass) {
    value.particle_errors = {{.relative = body_.body().errors.mass * (1 + 0x1p-20)}};
  } else if (role == SceneRole::position) {
    for (std::size_t k = 0; k < 3; ++k)
      value.particle_errors.push_back(turn_places_ ? body_.place_errors_along(k)
                                                   : place_errors(body_.body(), k));
  }
}

Result<LetterValue> SceneValues::moment(std::size_t which) {
  if (turn_) {  // the axes are needed anyway, and their order is the moments'
    const auto& axes = body_.axes();
    if (!axes) return tl::unexpected(axes.error());
  }
  const auto& moments = body_.moments();
  if (!moments) return tl::unexpected(moments.error());
  LetterValue value{{(*moments)[which].high}, {}, {(*moments)[which].low}};
  if (scene_.errors) value.errors = {body_.moment_errors()[which]};
  if (const LongNumber* digits = body_.digits_of_moment(which)) value.digits = {*digits};
  return value;
}

Result<LetterValue> SceneValues::tensor() {
  if (turn_places_) {
    const auto& moments = body_.moments();
    if (!moments) return tl::unexpected(moments.error());
    const Position errors = scene_.errors ? body_.moment_errors() : Position{};
    LetterValue value{std::vector<double>(9), {}, std::vector<double>(9), std::vector<double>(9)};
    for (std::size_t k = 0; k < 3; ++k) {
      value.components[4 * k] = (*moments)[k].high;
      value.lows[4 * k] = (*moments)[k].low;
      value.errors[4 * k] = errors[k];
      const LongNumber* digits = body_.digits_of_moment(k);
      if (digits == nullptr) continue;
      value.digits.resize(9);
      value.digits[4 * k] = *digits;
    }
    return value;
  }
  const auto& inertia = body_.tensor();
  if (!inertia) return tl::unexpected(inertia.error());
  LetterValue value;
  for (const Position& row : *inertia)
    value.components.insert(value.components.end(), row.begin(), row.end());
  if (scene_.errors) value.errors.assign(9, body_.tensor_error());
  return value;
}

/// A vector's or tensor's components, turned to the principal axes if they are given along others.
Result<LetterValue> SceneValues::turned_value(std::vector<double> components) {
  if (!turn_ || components.size() == 1) return LetterValue{std::move(components), {}};
  const auto& axes = body_.axes();
  if (!axes) return tl::unexpected(axes.error());
  std::vector<double> errors;
  if (scene_.errors) errors = turning_errors_of(components, body_.turning_errors());
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
  return LetterValue{std::move(components), {}, {}, errors};
}

MissingValue SceneValues::missing(SymbolId symbol) const {
  const std::string& name = tree_.symbols[symbol].name;
  return {fmt::format("`{}` is needed, but has no value", name),
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
      return inertia_dimension();
    case SceneRole::tensor:
      return std::nullopt;  // by its definition, if the notes have one
    case SceneRole::value:
      return scene_.values[letter->which].dimension;
  }
  return std::nullopt;
}

}  // namespace rigor
