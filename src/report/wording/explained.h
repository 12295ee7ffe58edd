// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of notes with the small steps between their forms, line by line, ready to be shown.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "derive/chain/explanation.h"
#include "expr/statement/written_forms.h"
#include "source/source_map.h"

namespace rigor {

enum class ExplainedAs : std::uint8_t {
  known,     // a definition, or given: nothing to explain
  small,     // by small steps
  by_cases,  // component by component
  refuted,
  expected_refuted,
  open,  // a gap, or not proved
};

enum class LineKind : std::uint8_t {
  holds,
  refuted,
  not_reached,  // the other side, which no step led to
  words,        // no mathematics, only a rule
};

/// One line of a derivation.
struct ExplainedLine {
  std::string relation;  // LaTeX, to what is above: `=`, `\approx`, `<`; `\ne` where `=` is refuted
  std::string latex;
  std::string rule;  // in words, with names in LaTeX
  LineKind kind = LineKind::holds;
};

/// The relation as it is shown: with a question mark over it if the line was not reached.
[[nodiscard]] std::string shown_relation(const ExplainedLine& line);

/// What one expression is turned into.
struct ExplainedBlock {
  std::string head;  // LaTeX
  std::string rule;  // said of the head: `for each component i`
  std::vector<ExplainedLine> lines;
};

struct ExplainedChain {
  std::string place;  // `notes.md:12 (6)`
  std::vector<ExplainedAs> steps;
  std::vector<ExplainedBlock> blocks;
};

struct ExplainedTally {
  std::size_t chains = 0;  // with a step that is to be explained
  std::size_t whole = 0;   // of these, with all such steps explained
  std::size_t steps = 0;   // that are to be explained
  std::size_t explained = 0;
  std::size_t by_cases = 0;  // of these
  std::size_t refuted = 0;   // and not expected
};

/// Explains each step; the tree of `forms` gets the expressions between. Cost: well under a second a step.
[[nodiscard]] ExplainedChain explain_chain(WrittenForms& forms, std::size_t chain, const SourceMap& sources);

[[nodiscard]] ExplainedTally tally(const std::vector<ExplainedChain>& chains);
/// `explained 5 of 6 steps in 2 chains, 1 of them whole (50 %)`
[[nodiscard]] std::string tally_text(const ExplainedTally& tally);

/// Words and mathematics of a rule apart: `definition of \mathbf{v}_\alpha`.
struct RulePart {
  bool is_math = false;
  std::string text;
};
[[nodiscard]] std::vector<RulePart> rule_parts(const std::string& rule);

}  // namespace rigor
