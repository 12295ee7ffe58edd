// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/document/document_input.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "base/among.h"
#include "latex/token/words.h"
#include "source/read_file.h"

namespace rigor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t deepest_input = 16;
constexpr std::size_t most_requests = 1000;

/// Empty where the file system cannot say.
fs::path real_path(const fs::path& path) {
  std::error_code error;
  fs::path result = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? fs::path() : result;
}

/// The repository that the folder is in: its nearest folder with `.git` or `rigor.toml`. Many notes have
/// their preamble above their own folder. Without a repository, the folder itself.
fs::path root_of(const fs::path& folder) {
  std::error_code error;
  for (fs::path at = folder; !at.empty(); at = at.parent_path()) {
    if (fs::exists(at / ".git", error) || fs::exists(at / "rigor.toml", error)) return at;
    if (at == at.root_path()) break;
  }
  return folder;
}

/// Packages whose notation is read by its names: their own files are programs, even where they lie beside the
/// notes.
bool is_known_package(std::string_view name) {
  static const WordSet names(
      "amsbsy amscd amsfonts amsmath amssymb amstext amsthm bm braket cancel commath derivative diffcoeff "
      "empheq esdiff esint etoolbox fontspec geometry graphicx hyperref ifthen isomath leftidx mathrsfs "
      "mathtools nicefrac physics physics2 siunitx slashed tensor tikz unicode-math upgreek xcolor xfrac "
      "xparse");
  return names.contains(name);
}

/// LaTeX writes a name with blanks in quotes; they belong to no name.
std::string without_quotes(std::string_view name) {
  std::string result(name);
  std::erase(result, '"');
  return result;
}

}  // namespace

InputFiles::InputFiles(SourceMap& sources, FileId top, Diagnostics& diagnostics)
    : sources_(sources), diagnostics_(diagnostics), folder_(fs::path(sources.path(top)).parent_path()) {
  root_ = root_of(real_path(folder_.empty() ? fs::path(".") : folder_));
  stack_.push_back(real_path(sources.path(top)));
  claims_in_.emplace(stack_.back(), false);
}

std::optional<FileId> InputFiles::open(std::string_view name, Span place) {
  if (++requests_ > most_requests) {
    if (requests_ > most_requests + 1) return std::nullopt;
    return report(
        DiagnosticKind::missing_input, place,
        fmt::format("no more than {} files are read; this and all later ones are left out", most_requests));
  }
  const fs::path asked{without_quotes(name)};
  const std::string shown = asked.string() + (asked.has_extension() ? "" : ".tex");
  if (stack_.size() > deepest_input) {
    return report(DiagnosticKind::missing_input, place,
                  fmt::format("`{}` is read more than {} files deep, and left out", shown, deepest_input));
  }
  return add(find(asked, ".tex"), shown, place);
}

std::optional<FileId> InputFiles::open_package(std::string_view name, std::string_view extension,
                                               Span place) {
  if (requests_ > most_requests || stack_.size() > deepest_input || is_known_package(name))
    return std::nullopt;
  const std::string shown = std::string(name) + std::string(extension);
  const fs::path path = find(fs::path(name), extension);
  std::error_code error;
  const fs::path real = real_path(path);
  const bool reads = !real.empty() && is_inside(real) && fs::exists(path, error) &&
                     !is_one_of(real, stack_) && !claims_in_.contains(real);
  if (!reads) return std::nullopt;
  ++requests_;
  return add(path, shown, place);
}

std::optional<FileId> InputFiles::add(const fs::path& path, const std::string& shown, Span place) {
  const fs::path real = real_path(path);
  if (real.empty())
    return report(DiagnosticKind::missing_input, place, fmt::format("`{}` is not a path", shown));
  if (!is_inside(real)) {
    return report(DiagnosticKind::input_outside, place,
                  fmt::format("`{}` is outside the folder of the notes", shown));
  }
  if (is_one_of(real, stack_)) {
    return report(DiagnosticKind::missing_input, place, fmt::format("`{}` reads itself", shown));
  }
  const auto [before, fresh] = claims_in_.emplace(real, false);
  if (!fresh && before->second) {
    report(DiagnosticKind::unsupported, place,
           fmt::format("`{}` was read before; its equations are not checked again here", shown));
    diagnostics_.back().help.emplace_back("if symbols mean something else here, write the equations here");
  }
  if (!fresh) return std::nullopt;
  auto text = read_file(path.string());
  if (!text) {
    return report(DiagnosticKind::missing_input, place,
                  fmt::format("`{}` cannot be read: {}", shown, text.error().reason));
  }
  Diagnostics mended = mend_notes(*text, 0);
  const FileId file = sources_.add(path.string(), std::move(*text));
  for (Diagnostic& diagnostic : mended) {
    diagnostic.span.file = file;
    diagnostics_.push_back(std::move(diagnostic));
  }
  stack_.push_back(real);
  return file;
}

void InputFiles::close(bool has_claims) {
  claims_in_[stack_.back()] = has_claims;
  stack_.pop_back();
}

std::optional<FileId> InputFiles::report(DiagnosticKind kind, Span place, std::string message) {
  diagnostics_.push_back({kind, place, std::move(message)});
  return std::nullopt;
}

/// LaTeX looks from the folder of the main file; \subfile and many editors from that of the file itself. Each
/// looks for `NAME.tex` before `NAME`.
fs::path InputFiles::find(const fs::path& name, std::string_view extension) const {
  fs::path with_extension = name;
  if (name.extension() != extension) with_extension += extension;
  const fs::path beside = stack_.back().parent_path().lexically_relative(stack_.front().parent_path());
  for (const fs::path& folder : {folder_, folder_ / beside}) {
    for (const fs::path& each : {with_extension, name}) {
      fs::path found = (folder / each).lexically_normal();
      std::error_code error;
      if (fs::exists(found, error) && !fs::is_directory(found, error)) return found;
    }
  }
  return (folder_ / (name.has_extension() ? name : with_extension)).lexically_normal();
}

bool InputFiles::is_inside(const fs::path& canonical) const {
  const fs::path relative = canonical.lexically_relative(root_);
  return !relative.empty() && *relative.begin() != "..";
}

}  // namespace rigor
