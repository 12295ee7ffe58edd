// SPDX-License-Identifier: GPL-3.0-or-later
// Second half of splitting a display: from rows to chains `a = b = c`, each with its tag and with what is
// next to it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latex/split/rows.h"
#include "latex/token/accounting.h"
#include "latex/token/syntax.h"
#include "latex/token/vocabulary.h"

namespace rigor {

struct WrittenRelation {
  RelationKind kind = RelationKind::equal;
  Span span;
  std::string text;  // `=`, `\equiv`
};

struct WrittenSide {
  Tokens tokens;
  Span span;
};

/// How an equation hangs on those before it on its line.
enum class Inference : std::uint8_t {
  none,
  conclusion,   // `\Rightarrow`, `\therefore`, "hence" is before it: they are assumed for it
  equivalence,  // `\iff`: so they are; the other direction is not asked for
};

/// `sides[k] relations[k] sides[k + 1]`; one side more than relations.
struct WrittenChain {
  std::vector<WrittenSide> sides;
  std::vector<WrittenRelation> relations;
  std::string tag;
  std::string label;
  /// Words or signs next to the equation that change what it says and are not read.
  std::optional<Obstacle> condition;
  Span condition_span;
  /// Words or signs next to the equation that may restrict it ("to first order", `i \ne j`): it may be
  /// proved, never refuted.
  std::optional<Obstacle> doubt;
  bool only_counts = false;    // the doubt is which numbers a letter takes: `n = 0, 1, 2, \dots`
  bool only_said_for = false;  // the doubt is that it holds under what `assumed` says
  /// Relations that say when it holds: after "for" or "if", in its tag, at its braces. Where there are some,
  /// there is a doubt.
  std::vector<WrittenChain> assumed;
  bool of_cases = false;  // one of `\begin{cases} … \end{cases}`: it is said for `assumed`, without a doubt
  bool alternative = false;   // "or" is next to it
  bool digits_go_on = false;  // `3.14159...`: a decimal of it is cut off, and not rounded
  Inference inference = Inference::none;
  bool premise = false;   // something is inferred from it on its line
  bool explains = false;  // "where", "with" is before it: it says what a letter of its line is
  /// "(no sum)" next to the equation: no letter is summed but under an explicit sign.
  bool no_sum = false;
  /// "and cyclic permutations", "etc." next to the equation or right after the display: it is said for
  /// 1 → 2 → 3 → 1 (x → y → z → x), too.
  bool cyclic = false;
  std::size_t statement = 0;  // which statement of the display; equations on one line share it
  Span span;
};

/// As it was written, without layout around its sides.
[[nodiscard]] std::string text_of(const WrittenChain& chain);

/// The chains of a display, and what each of its tokens is to them.
struct SplitDisplay {
  std::vector<WrittenChain> chains;
  Tokens tokens;  // with their places
  TokenUses uses;
};

/// A stretch without a relation that is neither a tag nor a remark makes a chain with one side and no
/// relation. `environment` is the display's own (empty for `$$`): it says what `&` separates. Where a token
/// is left over, the chains of its statement get a condition.
[[nodiscard]] SplitDisplay split_and_count(TokenView tokens, std::string_view environment,
                                           Diagnostics& diagnostics);
/// The same without the accounts.
[[nodiscard]] std::vector<WrittenChain> split_display(TokenView tokens, std::string_view environment,
                                                      Diagnostics& diagnostics);

}  // namespace rigor
