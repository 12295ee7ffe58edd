// SPDX-License-Identifier: GPL-3.0-or-later
// Macros that notes in Markdown configure instead of defining them: MyST's `math:` in the front matter, and
// the configuration of MathJax or KaTeX in a `<script>`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

struct MathMacro {
  std::string name;  // letters, without a backslash
  std::string body;
  int parameters = 0;
  std::optional<std::string> first = {};  // what the first of them is by default
};

/// The entries of `math:` in YAML: `'\vec': '\mathbf{#1}'`, `'\vec': ['\mathbf{#1}', 1]`, `macro:` below a
/// name.
[[nodiscard]] std::vector<MathMacro> macros_of_front_matter(std::string_view yaml);
/// The entries of each `macros: {…}`: `RR: "\\mathbb{R}"`, `bm: ["\\boldsymbol{#1}", 1]`. Other code ends
/// them.
[[nodiscard]] std::vector<MathMacro> macros_of_script(std::string_view script);

/// `\renewcommand{\vec}[1]{\mathbf{#1}}`
[[nodiscard]] std::string definition_of(const MathMacro& macro);

}  // namespace rigor
