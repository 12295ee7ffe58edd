// SPDX-License-Identifier: GPL-3.0-or-later
// Is a relation in a line a fact of its sentence? "With $v = 0$ the energy is" says so of what follows; "with
// $v = 0$ at the top", "if $a_i = 0$ for some $i$", "where $n = 1$ is the ground state" and "$x > 0$ or $y >
// 0$" speak of a time, a place, a case or a name. Nothing says how far such words reach, so that only what is
// known to restrict nothing may be after the relation. The lists are closed, and are in
// docs/notation.md.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Words, numbers, `$`, `\n` and signs of punctuation of a sentence as in `ProseBeside`.
[[nodiscard]] std::vector<std::string_view> parts_of_sentence(std::string_view sentence);

/// One piece of mathematics in a line of a sentence.
struct MathsInLine {
  std::string text;
  bool relates = false;
};

enum class SaidOf {
  the_row,  // of what follows; and of all that is no relation
  a_name,   // "where $\omega = \sqrt{k/m}$ is the frequency": of a letter that it brings in, and of no other
  something,  // restricted by the words around it
};

/// What each of `maths`, the `$` of the sentence in order, is said about.
[[nodiscard]] std::vector<SaidOf> said_of(std::string_view sentence, const std::vector<MathsInLine>& maths);

/// The part of a sentence up to its next display, from `begin` on, with "or", "iff", "unless", "only", …: it
/// chooses or doubts, and asserts no part of it.
[[nodiscard]] bool has_doubt(const std::vector<std::string_view>& parts, std::size_t begin = 0);

/// Do the words after the `$` at `parts[at]` leave what is said about it unchanged? A relation after it is
/// not looked at.
[[nodiscard]] bool stands_free(const std::vector<std::string_view>& parts, std::size_t at);

}  // namespace rigor
