// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers behind a scene's letters, made when a compiled expression reads them and not before.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scene/motion/letter_values.h"
#include "scene/quantity/scene_body.h"
#include "scene/quantity/scene_letters.h"

namespace rigor {

/// Why a letter has no value, and what may help.
struct MissingValue {
  std::string message;
  std::string help;
};

class SceneValues {
 public:
  /// All are kept by reference.
  SceneValues(const SceneFile& scene, const ExprTree& tree, const SceneLetters& letters, SceneBody& body)
      : scene_(scene), tree_(tree), letters_(letters), body_(body) {}

  /// Along which axes components are, once it is known what with components will be read. Principal axes are
  /// taken where they are asked for or a principal moment is read. A reason where the scene leaves open along
  /// which axes it means its components.
  [[nodiscard]] std::optional<MissingValue> settle_axes(const std::set<SceneRole>& read);
  [[nodiscard]] bool along_principal_axes() const { return principal_; }

  /// Makes what the program reads, but for rates of the spin.
  [[nodiscard]] std::optional<MissingValue> provide(const Program& program);
  /// The spin along the axes that were settled, with bounds of its errors if they are asked for; it alone.
  [[nodiscard]] Result<LetterValue> spin_value();
  [[nodiscard]] Result<Vector3> spin();
  /// At the time 0, of the axes that were settled.
  [[nodiscard]] Result<Quaternion> orientation();

  [[nodiscard]] const LetterValues& values() const { return values_; }
  [[nodiscard]] std::optional<Dimension> dimension_of(SymbolId symbol) const;

 private:
  [[nodiscard]] Result<LetterValue> value_of(const SceneLetter& letter);
  void add_particle_errors(LetterValue& value, SceneRole role);
  [[nodiscard]] Result<LetterValue> moment(std::size_t which);
  [[nodiscard]] Result<LetterValue> tensor();
  [[nodiscard]] Result<LetterValue> turned_value(std::vector<double> components);
  [[nodiscard]] MissingValue missing(SymbolId symbol) const;

  const SceneFile& scene_;
  const ExprTree& tree_;
  const SceneLetters& letters_;
  SceneBody& body_;
  LetterValues values_;
  bool principal_ = false;  // components are along principal axes
  bool turn_ = false;       // and the scene gives them along the body's, which are others
  bool turn_places_ = false;
};

}  // namespace rigor
