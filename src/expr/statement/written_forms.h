// SPDX-License-Identifier: GPL-3.0-or-later
// What notes hand to the floating-point side: every chain with its sides as they were written, the
// definitions and assumptions in force there, and what the exact side says about each step.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "expr/print/notation.h"
#include "expr/statement/question_names.h"
#include "expr/statement/statement.h"

namespace rigor {

/// One side of a chain.
struct WrittenForm {
  std::optional<ExprId> expr;  // nothing: it could not be read
  std::string source;          // LaTeX as written, blanks folded
  std::string expanded = {};   // the same without macros of the notes
  Span span = {};
  bool other_space = false;  // it was read, but not in the space of three dimensions
};

/// The relation between a form and the next one, and what the exact side was asked about it and answered.
struct WrittenStep {
  std::string kind;                       // as written: `=`, `\approx`
  bool nearly = false;                    // to first order only
  bool expected_refuted = false;          // a directive says that it is false
  bool defines = false;                   // the left form is a name for the right one
  bool given = false;                     // what the notes take for granted
  std::optional<Outcome> outcome = {};    // nothing: it was not asked, or its answer does not count
  bool stated = false;                    // a law: it need not follow from anything
  std::optional<Question> question = {};  // its `tree` is not set
  QuestionNames names = {};               // of the question's definitions and assumptions
  std::optional<NearlyQuestion> nearly_question = {};  // `nearly`: the step before anything was left out
  std::optional<Sample> sample = {};                   // refuted: where the sides differ
  std::vector<Equation> conditions = {};               // orders that words say for it, whether needed or not
};

/// a = b = c, as it is in the notes. All forms share their free letters.
struct WrittenFormChain {
  std::string tag;                         // `(6)`, or empty
  std::string label;                       // of \label
  std::string section;                     // its heading
  std::vector<std::string> headings = {};  // of the sections that it is in, the outermost first
  Span span = {};
  bool assumed = false;  // said by `given` or `where`: not a claim
  int image = 0;         // of "and cyclic permutations"
  std::vector<WrittenForm> forms = {};
  std::vector<WrittenStep> steps = {};       // one fewer than forms
  std::vector<IndexId> indices = {};         // free
  std::vector<ParticleId> particles = {};    // free
  std::vector<Definition> definitions = {};  // of what the forms speak of, and of what these speak of
  std::vector<Equation> assumptions = {};    // that bear on it
  std::vector<Equation> conditions = {};     // what words say of it besides: where its numbers lie
  std::optional<FrameNames> frame = {};      // in force there
};

/// Is it the chain with this tag, with or without brackets, or in a section of this heading?
[[nodiscard]] bool stands_at(const WrittenFormChain& chain, const std::string& place);

/// What was asked for by name: `T_{rot}`, `I_{ij}`, `(\Omega_2)^2`.
struct AskedForm {
  std::string source;
  ExprId expr{};
  std::vector<IndexId> indices;
  std::vector<ParticleId> particles;
};

struct WrittenForms {
  ExprTree tree;
  std::vector<WrittenFormChain> chains;
  std::vector<AskedForm> asked;         // in the order in which they were asked for
  std::vector<Definition> definitions;  // that those asked for need
  std::map<SymbolId, Dimension> units;  // that the notes declare
  Notation notation = {};               // of the notes, with no frame
};

/// How the notes write where the chain stands.
[[nodiscard]] Notation notation_at(const WrittenForms& forms, const WrittenFormChain& chain);

}  // namespace rigor
