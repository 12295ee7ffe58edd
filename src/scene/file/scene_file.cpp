// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/file/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

#include "base/among.h"
#include "scene/file/quantity_text.h"
#include "scene/file/toml_reader.h"

namespace rigor {
namespace {

constexpr std::size_t most_asked = 200;
constexpr std::size_t most_values = 200;
constexpr std::int64_t most_rows = 100'000;
constexpr std::int64_t most_split = 1'000;

SceneText placed_text(TomlReader& reader, std::string_view key, std::string usual) {
  if (const auto text = reader.text(key)) return {*text, reader.span_of(key)};
  return {std::move(usual), reader.span_of(key), false};
}

std::vector<SceneText> texts(TomlReader& reader, std::string_view key) {
  std::vector<SceneText> all;
  const std::vector<TomlValue>* items = reader.array(key);
  if (items == nullptr) return all;
  for (const TomlValue& item : *items) {
    if (const auto text = text_of(item, key, reader.diagnostics())) all.push_back({*text, item.span});
  }
  return all;
}

SceneSymbols read_symbols(const TomlValue* table, Diagnostics& diagnostics) {
  const TomlValue none;
  TomlReader reader(table == nullptr ? none : *table, "[symbols]", diagnostics);
  SceneSymbols symbols;
  symbols.mass = placed_text(reader, "mass", "m_\\alpha");
  symbols.position = placed_text(reader, "position", "\\mathbf{r}_\\alpha");
  symbols.spin = placed_text(reader, "spin", "\\boldsymbol{\\omega}");
  symbols.tensor = placed_text(reader, "tensor", "I_{ij}");
  symbols.principal_moments = texts(reader, "principal_moments");
  if (reader.has("principal_moments") && symbols.principal_moments.size() != 3) {
    report(
        diagnostics, DiagnosticKind::bad_toml, reader.span_of("principal_moments"),
        fmt::format("`principal_moments` has {} letters, but must have 3", symbols.principal_moments.size()));
  }
  if (symbols.principal_moments.size() != 3) {
    symbols.principal_moments = {{"I_1", {}, false}, {"I_2", {}, false}, {"I_3", {}, false}};
  }
  reader.report_unknown();
  return symbols;
}

/// The numbers of a value in the order of its components, and one dimension for all that have a unit.
class ValueReader {
 public:
  ValueReader(SceneValue& value, Diagnostics& diagnostics) : value_(value), diagnostics_(diagnostics) {}

  bool read(const TomlValue& toml) {
    if (toml.kind != TomlKind::array) return number(toml);
    if (toml.items.size() != 3) {
      return refuse(toml.span, fmt::format("`{}` has {} components, but must have 3", value_.name.text,
                                           toml.items.size()));
    }
    const bool rows = toml.items[0].kind == TomlKind::array;
    for (const TomlValue& item : toml.items) {
      if ((item.kind == TomlKind::array) != rows) {
        return refuse(item.span, fmt::format("`{}` mixes numbers and rows", value_.name.text));
      }
      if (!rows && !number(item)) return false;
      if (rows && !row(item)) return false;
    }
    return true;
  }

 private:
  bool row(const TomlValue& toml) {
    if (toml.items.size() != 3) {
      return refuse(toml.span, fmt::format("a row of `{}` has {} values, but must have 3", value_.name.text,
                                           toml.items.size()));
    }
    return std::ranges::all_of(toml.items, [&](const TomlValue& item) { return number(item); });
  }

  bool number(const TomlValue& toml) {
    if (toml.kind == TomlKind::number) {
      const auto plain = number_of(toml, value_.name.text, diagnostics_);
      if (plain) value_.components.push_back(*plain);
      return plain.has_value();
    }
    const auto text = text_of(toml, value_.name.text, diagnostics_);
    if (!text) return false;
    const auto quantity = read_quantity(*text);
    if (!quantity) {
      report(diagnostics_, DiagnosticKind::wrong_unit, toml.span, quantity.error().reason);
      return false;
    }
    if (value_.dimension && *value_.dimension != quantity->dimension) {
      report(diagnostics_, DiagnosticKind::wrong_unit, toml.span,
             fmt::format("`{}` is {}, but another component of `{}` is {}", *text,
                         name_of(quantity->dimension), value_.name.text, name_of(*value_.dimension)));
      return false;
    }
    value_.dimension = quantity->dimension;
    value_.components.push_back(quantity->value);
    return true;
  }

  bool refuse(Span span, std::string message) {
    report(diagnostics_, DiagnosticKind::bad_toml, span, std::move(message));
    return false;
  }

  SceneValue& value_;
  Diagnostics& diagnostics_;
};

std::vector<SceneValue> read_values(const TomlValue* table, Diagnostics& diagnostics) {
  std::vector<SceneValue> values;
  if (table == nullptr) return values;
  if (table->entries.size() > most_values) {
    report(diagnostics, DiagnosticKind::bad_scene, table->span,
           fmt::format("{} values are too many: at most {}", table->entries.size(), most_values));
    return values;
  }
  for (const TomlEntry& entry : table->entries) {
    SceneValue value{{entry.key, entry.key_span}, {}, {}};
    if (ValueReader(value, diagnostics).read(entry.value)) values.push_back(std::move(value));
  }
  return values;
}

std::optional<SceneMotion> read_motion(const TomlValue& table, Diagnostics& diagnostics) {
  TomlReader reader(table, "[motion]", diagnostics);
  SceneMotion motion;
  motion.span = table.span;
  if (reader.require("equations") != nullptr) motion.equations = placed_text(reader, "equations", "");
  if (reader.require("duration") != nullptr) {
    motion.duration = reader.quantity("duration", time_dimension()).value_or(0);
    if (motion.duration == 0) {
      report(diagnostics, DiagnosticKind::bad_scene, reader.span_of("duration"),
             "the motion has no duration");
    }
  }
  if (const auto rows = reader.whole("rows")) {
    motion.rows = static_cast<std::size_t>(std::clamp<std::int64_t>(*rows, 0, most_rows));
    if (*rows < 2 || *rows > most_rows) {
      report(diagnostics, DiagnosticKind::bad_scene, reader.span_of("rows"),
             fmt::format("`rows` is {}, but must be between 2 and {}", *rows, most_rows));
    }
  }
  if (const auto tolerance = reader.number("tolerance")) {
    motion.tolerance = *tolerance;
    if (!(*tolerance >= 1e-15 && *tolerance <= 1e-2)) {
      report(diagnostics, DiagnosticKind::bad_scene, reader.span_of("tolerance"),
             fmt::format("`tolerance` is {:g}, but must be between 1e-15 and 0.01", *tolerance));
    }
  }
  if (const auto split = reader.whole("split")) {
    if (reader.number("tolerance")) {
      report(diagnostics, DiagnosticKind::bad_scene, reader.span_of("tolerance"),
             "`tolerance` says nothing of split steps: give one of the two");
    }
    motion.split = static_cast<std::size_t>(std::clamp<std::int64_t>(*split, 1, most_split));
    if (*split < 1 || *split > most_split) {
      report(diagnostics, DiagnosticKind::bad_scene, reader.span_of("split"),
             fmt::format("`split` is {}, but must be between 1 and {}", *split, most_split));
    }
  }
  reader.report_unknown();
  return motion;
}

/// To length 1; false: it is 0. The largest is made 1 first, since squares overflow and underflow.
bool normalise(std::span<double> vector) {
  double largest = 0;
  for (const double each : vector) largest = std::max(largest, std::abs(each));
  if (!(largest > 0) || !std::isfinite(largest)) return false;
  double square = 0;
  for (double& each : vector) {
    each /= largest;
    square += each * each;
  }
  for (double& each : vector) each /= std::sqrt(square);
  return true;
}

/// `[w, x, y, z]`, of any length but 0, or `{ axis = [0, 0, 1], angle = "30 deg" }`.
std::optional<Quaternion> read_orientation(const TomlValue& toml, Diagnostics& diagnostics) {
  Quaternion turn{};
  if (toml.kind == TomlKind::table) {
    TomlReader reader(toml, "`orientation`", diagnostics);
    (void)reader.require("axis");
    (void)reader.require("angle");
    auto axis = reader.quantities("axis", Dimension(), 3);
    const auto angle = reader.quantity("angle", Dimension());
    reader.report_unknown();
    if (!axis || !angle) return std::nullopt;
    if (normalise(*axis)) {
      turn[0] = std::cos(*angle / 2);
      for (std::size_t i = 0; i < 3; ++i) turn[i + 1] = std::sin(*angle / 2) * (*axis)[i];
    }
  } else {
    const auto numbers = quantities_of(toml, "orientation", Dimension(), 4, diagnostics);
    if (!numbers) return std::nullopt;
    std::copy(numbers->begin(), numbers->end(), turn.begin());
  }
  if (!normalise(turn)) {
    report(diagnostics, DiagnosticKind::bad_scene, toml.span, "the orientation has no axis");
    return std::nullopt;
  }
  return turn;
}

SceneAsk asked_as(const SceneText& name) {
  constexpr std::string_view over_time = "(t)";
  if (name.text == "principal moments") return {SceneAskKind::principal_moments, name, {}};
  if (name.text == "principal axes") return {SceneAskKind::principal_axes, name, {}};
  std::string_view latex = name.text;
  while (latex.ends_with(' ')) latex.remove_suffix(1);
  if (!latex.ends_with(over_time)) return {SceneAskKind::quantity, name, std::string(latex)};
  latex.remove_suffix(over_time.size());
  return {SceneAskKind::over_time, name, std::string(latex)};
}

void read_asked(const TomlValue& table, SceneFile& scene, Diagnostics& diagnostics) {
  TomlReader reader(table, "[ask]", diagnostics);
  for (const SceneText& name : texts(reader, "quantities")) {
    scene.asked.push_back(asked_as(name));
    const SceneAsk& ask = scene.asked.back();
    const bool of_notes = ask.kind == SceneAskKind::quantity || ask.kind == SceneAskKind::over_time;
    if (of_notes && ask.latex.empty())
      report(diagnostics, DiagnosticKind::bad_scene, name.span, "a quantity without a name is asked for");
  }
  scene.errors = reader.truth("errors").value_or(false);
  scene.plot = reader.text("plot").value_or("");
  if (scene.asked.empty()) {
    report(diagnostics, DiagnosticKind::bad_scene, reader.span_of("quantities"), "the scene asks for nothing",
           {"list quantities of the notes, as `quantities = ['T_{rot}']` under [ask]"});
  } else if (scene.asked.size() > most_asked) {
    report(diagnostics, DiagnosticKind::bad_scene, reader.span_of("quantities"),
           fmt::format("{} quantities are too many: at most {}", scene.asked.size(), most_asked));
  }
  reader.report_unknown();
}

SceneAxes read_axes(TomlReader& reader) {
  const auto text = reader.text("axes");
  if (!text) return SceneAxes::not_said;
  if (*text == "body") return SceneAxes::body;
  if (*text == "principal") return SceneAxes::principal;
  report(reader.diagnostics(), DiagnosticKind::bad_scene, reader.span_of("axes"),
         fmt::format("`axes` is `{}`, but must be `body` or `principal`", *text));
  return SceneAxes::not_said;
}

const TomlValue* table_of(TomlReader& reader, std::string_view key) {
  const TomlValue* table = reader.find(key);
  return table != nullptr && is_table(*table, key, reader.diagnostics()) ? table : nullptr;
}

/// A hertz counts periods, and a spin is an angle by the time: `1 Hz` can be meant as 1 rad/s and as 2π
/// rad/s.
bool counts_periods(const TomlValue& spin, Diagnostics& diagnostics) {
  bool any = false;
  for (const TomlValue& each : spin.items) {
    if (!each.text.ends_with("Hz")) continue;
    any = true;
    report(diagnostics, DiagnosticKind::wrong_unit, each.span,
           fmt::format("`{}` counts turns or radians: a spin needs an angle", each.text),
           {"write `60 rpm` for one turn a second, or `1 rad/s`"});
  }
  return any;
}

std::optional<Vector3> read_spin(TomlReader& reader) {
  const TomlValue* written = reader.find("spin");
  if (written == nullptr || counts_periods(*written, reader.diagnostics())) return std::nullopt;
  const auto spin = reader.quantities("spin", rate_dimension(), 3);
  if (!spin) return std::nullopt;
  return Vector3{(*spin)[0], (*spin)[1], (*spin)[2]};
}

void read_top(TomlReader& reader, SceneFile& scene) {
  Diagnostics& diagnostics = reader.diagnostics();
  scene.title = reader.text("title").value_or(std::filesystem::path(scene.path).stem().string());
  (void)reader.require("notes");
  scene.notes = placed_text(reader, "notes", "");
  scene.at = reader.text("at").value_or("");
  (void)reader.require("body");
  scene.body = placed_text(reader, "body", "");
  scene.axes = read_axes(reader);
  scene.spin = read_spin(reader);
  if (const TomlValue* turn = reader.find("orientation"))
    scene.orientation = read_orientation(*turn, diagnostics);
  scene.symbols = read_symbols(table_of(reader, "symbols"), diagnostics);
  scene.values = read_values(table_of(reader, "values"), diagnostics);
  if (const TomlValue* motion = table_of(reader, "motion")) scene.motion = read_motion(*motion, diagnostics);
  if (reader.require("ask") != nullptr) {
    if (const TomlValue* ask = table_of(reader, "ask")) read_asked(*ask, scene, diagnostics);
  }
  const auto timed = std::ranges::find(scene.asked, SceneAskKind::over_time, &SceneAsk::kind);
  if (timed != scene.asked.end() && !scene.motion) {
    report(diagnostics, DiagnosticKind::bad_scene, timed->name.span,
           fmt::format("`{}` needs a motion, but the scene has none", timed->name.text),
           {"add [motion] with `equations` and `duration`"});
  }
  reader.report_unknown();
}

}  // namespace

std::string SceneFile::notes_path() const {
  return (std::filesystem::path(path).parent_path() / notes.text).lexically_normal().string();
}

std::optional<SceneFile> read_scene(const SourceMap& sources, FileId file, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.size();
  const auto toml = parse_toml(sources, file, diagnostics);
  if (!toml) return std::nullopt;
  SceneFile scene;
  scene.path = sources.path(file);
  scene.span = toml->span;
  TomlReader reader(*toml, "the scene", diagnostics);
  read_top(reader, scene);
  if (diagnostics.size() > before) return std::nullopt;
  return scene;
}

std::vector<std::string> asked_of_notes(const SceneFile& scene) {
  std::vector<std::string> all;
  const auto add = [&](const std::string& latex) {
    if (!latex.empty() && !is_one_of(latex, all)) all.push_back(latex);
  };
  for (const SceneAsk& ask : scene.asked) add(ask.latex);
  for (const SceneValue& value : scene.values) add(value.name.text);
  const SceneSymbols& symbols = scene.symbols;
  for (const SceneText* text : {&symbols.mass, &symbols.position, &symbols.spin, &symbols.tensor}) {
    if (text->given) add(text->text);
  }
  for (const SceneText& text : symbols.principal_moments) {
    if (text.given) add(text.text);
  }
  return all;
}

}  // namespace rigor
