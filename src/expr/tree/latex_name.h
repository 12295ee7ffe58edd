// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a symbol taken apart, as far as printing needs it: letter, primes, labels.
#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// `\mathbf{r}'_{\text{cm}}` is the letter `\mathbf{r}`, the prime and the label `\text{cm}`.
struct LatexName {
  std::string letter;  // with its face and accent
  std::string primes;  // `'`, `''`
  std::string labels;  // of the subscript, without its braces
  std::string behind;  // labels that are after the indices: `{}_{\text{x}}`

  /// Is a label a lone digit or letter, which index letters next to it would run into?
  [[nodiscard]] bool has_bare_label() const;
};

[[nodiscard]] LatexName latex_name(std::string_view name);

/// Bold faces, arrows and the like taken off: `\boldsymbol{\omega}` is `\omega`, `\hat{\mathbf{n}}` is
/// `\hat{n}`.
[[nodiscard]] std::string without_face(std::string_view letter);
/// Is there a face to take off?
[[nodiscard]] bool has_face(std::string_view letter);

/// `b` after `a`, with a blank after a control word, if a letter or digit follows.
void append_latex(std::string& a, std::string_view b);
/// `_x`, `_\alpha`, `_{ij}`; nothing for nothing.
[[nodiscard]] std::string subscript(const std::string& inside);

}  // namespace rigor
