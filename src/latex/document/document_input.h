// SPDX-License-Identifier: GPL-3.0-or-later
// The files that notes read with \input, \include and \subfile: those of the repository that the notes are
// in, or else in the folder of the notes and below.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/diagnostic.h"
#include "source/source_map.h"

namespace rigor {

class InputFiles {
 public:
  InputFiles(SourceMap& sources, FileId top, Diagnostics& diagnostics);

  /// Reads and mends the file `name`, as the file on top of the stack names it at `place`: relative to the
  /// notes' folder, else to the folder of that file; `NAME.tex` comes before `NAME`, and `"` belong to no
  /// name. Nothing for a file that was read before (with a diagnostic if it has claims) and, with a
  /// diagnostic, for one that is outside, missing, inside itself, nested too deep or past the 1000th. A file
  /// that is returned is on the stack until `close`.
  std::optional<FileId> open(std::string_view name, Span place);
  /// The same for a package or a class, `extension` being `.sty` or `.cls`, if it lies beside the notes and
  /// is none whose notation is known. Nothing, in silence, for all others: those that are installed.
  std::optional<FileId> open_package(std::string_view name, std::string_view extension, Span place);
  /// `has_claims`: the file, or what it reads, has displays or directives.
  void close(bool has_claims);

 private:
  std::optional<FileId> add(const std::filesystem::path& path, const std::string& shown, Span place);
  std::optional<FileId> report(DiagnosticKind kind, Span place, std::string message);
  [[nodiscard]] std::filesystem::path find(const std::filesystem::path& name,
                                           std::string_view extension) const;
  [[nodiscard]] bool is_inside(const std::filesystem::path& canonical) const;

  SourceMap& sources_;
  Diagnostics& diagnostics_;
  std::filesystem::path folder_;                     // of the notes, as their path says
  std::filesystem::path root_;                       // what is read lies below it, canonical
  std::vector<std::filesystem::path> stack_;         // canonical, the notes first
  std::map<std::filesystem::path, bool> claims_in_;  // of each file that was read, canonical
  std::size_t requests_ = 0;
};

}  // namespace rigor
