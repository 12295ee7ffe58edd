// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include "app/host/sample_bodies.h"
#include "base/among.h"
#include "base/utf8.h"
#include "check/entry/read_forms.h"
#include "report/data/scene_json.h"
#include "report/picture/scene_plot.h"
#include "report/text/scene_text.h"
#include "scene/file/body_file.h"
#include "scene/quantity/scene.h"
#include "source/read_file.h"
#include "source/render.h"

namespace rigor {
namespace {

/// True if one of them is an error.
bool print(const Diagnostics& diagnostics, const SourceMap& sources, std::ostream& err) {
  for (const Diagnostic& diagnostic : diagnostics) err << render(diagnostic, sources);
  return std::ranges::any_of(diagnostics,
                             [](const Diagnostic& each) { return each.severity() == Severity::error; });
}

/// Where the scene says what it asks of the notes.
Span place_in_scene(const SceneFile& scene, const std::string& latex) {
  for (const SceneAsk& ask : scene.asked) {
    if (ask.latex == latex) return ask.name.span;
  }
  for (const SceneValue& value : scene.values) {
    if (value.name.text == latex) return value.name.span;
  }
  std::vector<const SceneText*> letters{&scene.symbols.mass, &scene.symbols.position, &scene.symbols.spin,
                                        &scene.symbols.tensor};
  for (const SceneText& moment : scene.symbols.principal_moments) letters.push_back(&moment);
  for (const SceneText* letter : letters) {
    if (letter->text == latex) return letter->span;
  }
  return scene.span;
}

/// A body's path is relative to the scene's file, as that of the notes is.
std::string from_scene(const std::string& body, const std::string& scene) {
  const bool is_path = body.find('/') != std::string::npos || body.ends_with(".toml");
  if (!is_path || std::filesystem::path(body).is_absolute()) return body;
  const std::filesystem::path folder = std::filesystem::path(scene).parent_path();
  return folder.empty() ? body : (folder / body).string();
}

/// A diagnostic about an expression that the scene asks for is reported at its place in the scene.
void move_to_scene(const SceneFile& scene, const FormRequest& request, FormsReading& reading) {
  for (Diagnostic& diagnostic : reading.report.diagnostics) {
    for (std::size_t k = 0; k < reading.asked.size(); ++k) {
      if (diagnostic.span.file == reading.asked[k]) diagnostic.span = place_in_scene(scene, request.asked[k]);
    }
  }
}

/// A value has the dimension that `units` declares in the notes. What is wrong is said.
bool units_fit(const LoadedScene& loaded, const SourceMap& sources, std::ostream& err) {
  const WrittenForms& forms = loaded.reading.forms;
  bool fit = true;
  for (const SceneValue& value : loaded.scene.values) {
    const auto asked = std::ranges::find(forms.asked, value.name.text, &AskedForm::source);
    if (!value.dimension || asked == forms.asked.end()) continue;
    const ExprNode& node = forms.tree[asked->expr];
    const auto declared = forms.units.find(node.symbol);
    if (node.op != Op::symbol || declared == forms.units.end() || declared->second == *value.dimension)
      continue;
    print({{DiagnosticKind::wrong_unit, value.name.span,
            fmt::format("`{}` is a quantity of dimension {}, but the notes declare {}", value.name.text,
                        value.dimension->text(), declared->second.text())}},
          sources, err);
    fit = false;
  }
  return fit;
}

/// False where a picture was asked for and cannot be written.
bool write_plots(const LoadedScene& loaded, const SceneResult& result, std::ostream& err) {
  if (loaded.scene.plot.empty() || !result.motion) return true;
  const std::filesystem::path name(loaded.scene.plot);
  const bool inside = !name.is_absolute() && !is_one_of("..", name);
  if (!inside || name.extension() != ".svg") {
    err << "rigor: " << printable(loaded.scene.path) << ": `plot` is `" << printable(loaded.scene.plot)
        << "`, but must be a name that ends in `.svg`, in the scene's folder or below it\n";
    return false;
  }
  const std::filesystem::path path =
      std::filesystem::path(loaded.scene.path).parent_path() / loaded.scene.plot;
  const auto write = [&](const std::filesystem::path& to, const std::string& text) {
    std::ofstream file(to, std::ios::binary);
    file << text;
    const bool written = static_cast<bool>(file.flush());
    if (!written) err << "rigor: " << printable(to.string()) << ": cannot be written\n";
    return written;
  };
  bool all = true;
  if (const auto plots = plots_of(result); !plots.empty()) all = write(path, to_svg(plots));
  for (const EllipsoidPlot& spin_path : spin_paths_of(result)) {
    std::filesystem::path beside = path;
    beside.replace_filename(path.stem().string() + "-path" + path.extension().string());
    all = write(beside, to_svg(spin_path)) && all;
  }
  return all;
}

ExitCode compute(const std::string& path, const SceneCommand& command, std::ostream& out, std::ostream& err) {
  SourceMap sources;
  LoadedScene loaded;
  if (const ExitCode code = load_scene(path, sources, loaded, err); code != ExitCode::ok) return code;
  const SceneResult result = evaluate_scene(loaded.scene, std::move(loaded.body), loaded.reading.forms);
  const bool wrong = print(result.diagnostics, sources, err);
  out << (command.json ? to_json(result, sources, command.explain)
                       : print_scene(result, {.explain = command.explain}));
  if (command.explain && !command.json)
    out << fmt::format("notes: {} chains read, {} passed over\n", loaded.reading.forms.chains.size(),
                       loaded.reading.chains_passed_over);
  if (!write_plots(loaded, result, err)) return ExitCode::no_input;
  return wrong ? ExitCode::wrong : ExitCode::ok;
}

}  // namespace

ExitCode load_scene(const std::string& path, SourceMap& sources, LoadedScene& loaded, std::ostream& err) {
  auto text = read_file(path);
  if (!text) {
    err << "rigor: " << printable(path) << ": " << text.error().reason << "\n";
    return ExitCode::no_input;
  }
  Diagnostics diagnostics = mend_text(*text, 0);
  const FileId file = sources.add(path, std::move(*text));
  for (Diagnostic& diagnostic : diagnostics) diagnostic.span.file = file;
  auto scene = read_scene(sources, file, diagnostics);
  if (print(diagnostics, sources, err) || !scene) return ExitCode::wrong;
  loaded.scene = std::move(*scene);
  const auto body_path = find_body(from_scene(loaded.scene.body.text, path), body_folders(path));
  if (!body_path) {
    print({{DiagnosticKind::bad_body, loaded.scene.body.span, body_path.error().reason}}, sources, err);
    return ExitCode::wrong;
  }
  Diagnostics of_body;
  auto body = read_body_file(*body_path, sources, of_body);
  if (print(of_body, sources, err) || !body) return ExitCode::wrong;
  loaded.body = std::move(*body);
  FormRequest request{.asked = asked_of_notes(loaded.scene), .only = std::vector<std::string>()};
  if (!loaded.scene.at.empty()) request.at = loaded.scene.at;
  if (loaded.scene.motion) request.only->push_back(loaded.scene.motion->equations.text);
  loaded.reading = read_forms(sources, loaded.scene.notes_path(), request);
  move_to_scene(loaded.scene, request, loaded.reading);
  if (print(loaded.reading.report.diagnostics, sources, err))
    return loaded.reading.report.unreadable ? ExitCode::no_input : ExitCode::wrong;
  if (!request.asked.empty() && loaded.reading.forms.asked.empty()) return ExitCode::wrong;
  return units_fit(loaded, sources, err) ? ExitCode::ok : ExitCode::wrong;
}

ExitCode compute_scenes(const SceneCommand& command, std::ostream& out, std::ostream& err) {
  ExitCode worst = ExitCode::ok;
  for (const std::string& path : command.files) {
    const ExitCode code = compute(path, command, out, err);
    if (number_of(code) > number_of(worst)) worst = code;
  }
  return worst;
}

}  // namespace rigor
