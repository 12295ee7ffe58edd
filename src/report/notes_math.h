// SPDX-License-Identifier: GPL-3.0-or-later
// LaTeX that stands in a report (a side, a repair, a value of a sample) as boxes, with the macros of the
// notes.
#pragma once

#include <optional>
#include <string>

#include "latex/document.h"
#include "latex/layout.h"
#include "latex/macros.h"
#include "source/source_map.h"

namespace rigor {

class NotesMath {
 public:
  /// `macros`: those in force at the end of the notes. Both arguments outlive this.
  NotesMath(SourceMap& sources, MacroTable& macros) : sources_(sources), macros_(macros) {}

  /// Nothing where a macro never ends or lacks its arguments.
  [[nodiscard]] std::optional<Box> box_of(const std::string& latex);

  /// A line of prose such as a heading, with mathematics between dollar signs: words and boxes. In Markdown
  /// the words are taken as they are.
  [[nodiscard]] Box line_of(const std::string& prose, Format format);

  /// A rule such as `definition of \mathbf{v}_\alpha`: from the first word that is LaTeX on, mathematics.
  [[nodiscard]] Box rule_of(const std::string& rule);

 private:
  [[nodiscard]] std::vector<Token> lexed(const std::string& text);

  SourceMap& sources_;
  MacroTable& macros_;
};

}  // namespace rigor
