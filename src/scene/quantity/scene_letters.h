// SPDX-License-Identifier: GPL-3.0-or-later
// Which symbols of the notes a scene's letters are. A letter that the notes declare anew in another section
// is another symbol with the same name: all of them get the value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "expr/statement/written_forms.h"
#include "scene/file/scene_file.h"

namespace rigor {

enum class SceneRole : std::uint8_t { mass, position, spin, spin_rate, moment, tensor, value };

struct SceneLetter {
  SymbolId symbol{};
  SceneRole role = SceneRole::value;
  std::size_t which = 0;  // moment: 0..2; value: its position in SceneFile::values
};

class SceneLetters {
 public:
  /// Letters that were given and are no symbol by themselves (`2\omega`, or of the wrong kind) are
  /// diagnostics.
  SceneLetters(const SceneFile& scene, const WrittenForms& forms, Diagnostics& diagnostics);

  [[nodiscard]] const SceneLetter* find(SymbolId symbol) const;
  [[nodiscard]] std::vector<SymbolId> with_role(SceneRole role) const;
  /// Whose value wins over any definition in the notes: all but the tensor.
  [[nodiscard]] std::vector<SymbolId> overriding() const;

 private:
  struct Kind {
    int rank = 0;
    bool per_particle = false;
  };
  void bind(const SceneText& letter, const Kind& kind, SceneRole role, std::size_t which);
  [[nodiscard]] std::optional<std::string> name_of(const SceneText& letter, const Kind& kind);

  const SceneFile& scene_;
  const WrittenForms& forms_;
  Diagnostics& diagnostics_;
  std::vector<SceneLetter> letters_;
};

}  // namespace rigor
