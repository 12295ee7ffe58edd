// SPDX-License-Identifier: GPL-3.0-or-later
// `--at TAG|HEADING|LINE`: which of the equations of some notes are meant.
#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "source/source_map.h"

namespace rigor {

/// Where an equation stands, by all its names.
struct EquationPlace {
  std::string tag = {};
  std::string label = {};
  std::vector<std::string> headings = {};
  Span span = {};
};

class AskedPlaces {
 public:
  /// `file` is that of the notes; lines of files that they read are not meant. Keeps references.
  AskedPlaces(const std::vector<std::string>& asked, std::vector<EquationPlace> places, FileId file,
              const SourceMap& sources)
      : asked_(asked), places_(std::move(places)), file_(file), sources_(sources) {}

  /// Is it asked for? All are, if no place is named.
  [[nodiscard]] bool wants(std::size_t which) const;
  /// False, with a message, if the notes do not have a place. `path` is what they are called.
  [[nodiscard]] bool are_all_known(const std::string& path, std::ostream& err) const;

 private:
  [[nodiscard]] bool is_at(const EquationPlace& place, const std::string& asked) const;

  const std::vector<std::string>& asked_;
  std::vector<EquationPlace> places_;
  FileId file_;
  const SourceMap& sources_;
};

}  // namespace rigor
