// SPDX-License-Identifier: GPL-3.0-or-later
// What Rigor says about a place in the notes: a kind from one registry, a message, labels and help.
// Messages: lower case, no full stop, back-ticks around what was written; what was observed comes in the
// message, what might help in `help`.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/span.h"

namespace rigor {

enum class Severity : std::uint8_t { error, refuted, undecided, not_understood, warning, suspect };

/// One entry of `diagnostic_table()` each; `docs/diagnostics.md` has a paragraph for each.
enum class DiagnosticKind : std::uint8_t {
  // the file
  unreadable_file,
  invalid_utf8,
  read_as_latin1,
  nul_byte,
  no_equations,
  no_relation,
  // the notes as text
  unbalanced,
  macro_recursion,
  bad_macro,
  missing_input,
  input_outside,
  display_too_long,
  nesting_too_deep,
  bad_syntax,
  unsupported,
  passed_over,
  // directives
  unknown_directive,
  bad_directive,
  unused_directive,
  unknown_anchor,
  unknown_quantity,
  // meaning
  follows_from_nothing,
  suspect,
  ambiguous_reading,
  free_index_mismatch,
  index_repeats,
  index_clash,
  rank_mismatch,
  dimension_mismatch,
  dimension_clash,
  dimension_doubt,
  bold_index,
  dotted_length,
  unsummed_index,
  index_rides,
  unknown_change,
  no_real_value,
  circular_definition,
  redefinition,
  // lints: what is read, and is perhaps not what was meant
  two_meanings,
  shared_letter,
  mixed_spelling,
  plain_vector,
  hidden_index,
  idle_sum,
  near_name,
  repeated_side,
  mixed_frames,
  scalar_zero,
  mixed_parity,
  unused_definition,
  // bodies and scenes
  bad_toml,
  unknown_key,
  wrong_unit,
  bad_body,
  bad_mesh,
  bad_cloud,
  bad_scene,
  // verdicts
  refuted,
  undecided,
  borrowed,
  restricted,
  hole,
  zero_equals_zero,
  no_sample,
  unexpected_verdict,
  not_confirmed,
};

struct DiagnosticInfo {
  DiagnosticKind kind;
  std::string_view name;  // as printed in brackets, e.g. "index-repeats"
  Severity severity;
  std::string_view summary;  // one line, for the documentation
  bool off = false;          // reported only where `warn` asks for it
};

[[nodiscard]] std::span<const DiagnosticInfo> diagnostic_table();
[[nodiscard]] const DiagnosticInfo& info(DiagnosticKind kind);
[[nodiscard]] std::string_view name_of(Severity severity);

struct Label {
  Span span;
  std::string text;  // may be empty: the place alone is meant
};

struct Diagnostic {
  DiagnosticKind kind;
  Span span;
  std::string message;
  std::vector<Label> labels = {};
  std::vector<std::string> help = {};

  [[nodiscard]] Severity severity() const { return info(kind).severity; }
};

using Diagnostics = std::vector<Diagnostic>;

inline void report(Diagnostics& diagnostics, DiagnosticKind kind, Span span, std::string message,
                   std::vector<std::string> help = {}) {
  diagnostics.push_back({kind, span, std::move(message), {}, std::move(help)});
}

}  // namespace rigor
