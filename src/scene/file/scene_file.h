// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as its TOML file says it: a body, its spin, the notes whose definitions are used, what their
// letters stand for, and the quantities asked for. Values are in SI units; components are along axes fixed in
// the body.
//
//   notes = "../rigid-bodies.md"
//   body = "book"                         # a name in derivations/bodies, or a file
//   spin = ["0.01 rad/s", "5 rad/s", 0]
//   [ask]
//   quantities = ['T_{rot}', 'I_{ij}', '(\Omega_2)^2', '\boldsymbol{\omega}(t)', 'principal moments']
//   [motion]                              # needed where something is asked over the time
//   equations = "(22)"                    # tag or heading in the notes
//   duration = "20 s"
//   split = 20                            # steps a row, if it is to go in split steps: split_motion.h
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "expr/tree/dimension.h"
#include "scene/motion/motion.h"
#include "source/diagnostic.h"
#include "source/source_map.h"

namespace rigor {

/// A string of the file with its place; for LaTeX and for names. Not given: what is usual.
struct SceneText {
  std::string text;
  Span span = {};
  bool given = true;
};

/// Along which axes the spin and all other components are meant: those of the body's file, or its principal
/// axes (in the order of the moments). For a body whose file has it along principal axes they are the same.
enum class SceneAxes : std::uint8_t { not_said, body, principal };

/// What letters of the notes stand for. Those that are not given are `m_\alpha`, `\mathbf{r}_\alpha`,
/// `\boldsymbol{\omega}`, `I_1`, `I_2`, `I_3` and `I_{ij}`, where the notes have them.
struct SceneSymbols {
  SceneText mass;
  SceneText position;
  SceneText spin;
  std::vector<SceneText> principal_moments;  // three
  SceneText tensor;
};

struct SceneValue {
  SceneText name;
  std::vector<double> components;      // 1, 3, or 9 row by row
  std::optional<Dimension> dimension;  // nothing: written without a unit
};

struct SceneMotion {
  Span span = {};
  SceneText equations;
  double duration = 0;
  std::size_t rows = 501;
  double tolerance = 1e-10;
  std::size_t split = 0;  // so many split steps from row to row; 0: steps are chosen by the tolerance
};

enum class SceneAskKind : std::uint8_t { quantity, over_time, principal_moments, principal_axes };

struct SceneAsk {
  SceneAskKind kind = SceneAskKind::quantity;
  SceneText name;     // as written, `\mathbf{L}(t)`
  std::string latex;  // what the notes are asked for, `\mathbf{L}`; empty: nothing
};

struct SceneFile {
  std::string path;
  std::string title;
  SceneText notes;  // relative to the scene's file, or absolute
  std::string at;   // a tag or heading of the notes after which letters are meant; empty: their end
  SceneText body;
  SceneAxes axes = SceneAxes::not_said;
  std::optional<Vector3> spin;
  std::optional<Quaternion> orientation;
  SceneSymbols symbols;
  std::vector<SceneValue> values;
  std::optional<SceneMotion> motion;
  std::vector<SceneAsk> asked;
  bool errors = false;  // are bounds of rounding errors wanted?
  std::string plot;     // the picture's file; empty: none
  Span span = {};       // of the file

  /// `notes` as a path from where the program runs.
  [[nodiscard]] std::string notes_path() const;
};

/// Nothing where the file cannot be used; every mistake in it is a diagnostic.
[[nodiscard]] std::optional<SceneFile> read_scene(const SourceMap& sources, FileId file,
                                                  Diagnostics& diagnostics);

/// What the notes are asked for: each LaTeX string once. Letters that are the usual ones are not among them,
/// since notes need not have them.
[[nodiscard]] std::vector<std::string> asked_of_notes(const SceneFile& scene);

}  // namespace rigor
