// SPDX-License-Identifier: GPL-3.0-or-later
// LaTeX that is in a report as boxes: what the author wrote (a side, a repair, a value of a sample) with
// the macros of the notes, what rigor printed (a line of a derivation) without.
#pragma once

#include <optional>
#include <string>

#include "latex/document/document.h"
#include "latex/layout/layout.h"
#include "latex/macro/macros.h"
#include "source/source_map.h"

namespace rigor {

class NotesMath {
 public:
  /// `sources` outlives this. No macro is in force.
  explicit NotesMath(SourceMap& sources) : sources_(sources) {}

  /// From now on these macros are in force, and no others.
  void put_in_force(const MacroTable& macros) { macros_ = macros; }

  /// Nothing where a macro never ends or lacks its arguments.
  [[nodiscard]] std::optional<Box> box_of(const std::string& latex);
  /// Of what rigor printed, in which every macro has been replaced.
  [[nodiscard]] Box box_of_printed(const std::string& latex);

  /// A line of prose such as a heading, with mathematics between dollar signs: words and boxes. In Markdown
  /// the words are taken as they are.
  [[nodiscard]] Box line_of(const std::string& prose, Format format);

  /// A rule such as `definition of \mathbf{v}_\alpha`: from the first word that is LaTeX on, mathematics, as
  /// rigor printed it.
  [[nodiscard]] Box rule_of(const std::string& rule);

 private:
  [[nodiscard]] std::vector<Token> lexed(const std::string& text);

  SourceMap& sources_;
  MacroTable macros_;
};

}  // namespace rigor
