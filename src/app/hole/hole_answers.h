// SPDX-License-Identifier: GPL-3.0-or-later
// The holes of notes, each with an answer that was put into its place, read from there and proved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/form/forms.h"
#include "derive/answer/propose.h"

namespace rigor {

/// Which notes, and what of them.
struct HoleNotes {
  std::string path = {};                      // empty: a statement without notes
  std::string text = {};                      // of the notes, as it is in the file but for Latin-1
  std::optional<std::string> statement = {};  // only its holes are answered
  std::optional<std::string> at = {};         // where the statement stands: a tag or a heading
  std::optional<std::string> sidecar = {};
  std::vector<std::string> by = {};      // expressions that the form is about, as LaTeX
  std::vector<std::string> places = {};  // tags or headings, without a statement; empty: all holes
  bool decoded = false;  // the file is in Latin-1, and `text` is not: nothing can be written back
};

struct HoleAnswer {
  Span span;
  std::optional<std::string> latex = {};  // proved in its place
  std::string text = {};  // what is written for the hole: the answer with brackets where it needs them
  std::optional<std::string> freedom = {};  // what can be added to it, of many answers
  std::optional<std::string> other = {};    // what the notes say it is equal to, if it is alone
  bool written_there = false;               // the hole's own characters are in the text, not in a macro
  bool impossible = false;                  // no value fits
  bool only_moves_other = false;  // the answer holds what the notes say it is equal to: it says little
  bool among_small = false;       // something is small where it stands
  Diagnostics troubles = {};      // why there is no answer
};

struct HoleAnswers {
  SourceMap sources = {};
  FormsReading reading = {};  // of the notes as they are
  std::vector<HoleAnswer> holes = {};
  std::vector<std::string> unknown_places = {};
};

/// Never throws for anything in the notes. Cost: a reading of the notes with all their verdicts, and one for
/// each round in which the next answers are tried, at most 16.
[[nodiscard]] HoleAnswers answer_holes(const HoleNotes& notes, AnswerForm form);

}  // namespace rigor
