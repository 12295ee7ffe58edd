// SPDX-License-Identifier: GPL-3.0-or-later
// The environments that display equations, and the author's short names for them.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace rigor {

/// `align`, `align*`, `equation`…: what stands inside is a displayed equation. The star counts as part of the
/// name.
[[nodiscard]] bool is_display_environment(std::string_view name);
/// `{2}` stands behind `\begin{alignat}`, `{align}` behind `\begin{empheq}`.
[[nodiscard]] bool takes_argument(std::string_view name);
/// `[…]` may stand behind `\begin{dmath}` and `\begin{empheq}`.
[[nodiscard]] bool takes_options(std::string_view name);
/// `\begin{verbatim}` and its kind: nothing inside is read.
[[nodiscard]] bool is_verbatim_environment(std::string_view name);

/// `$$`, `\[` or the `\begin` of a display stands somewhere in the text.
[[nodiscard]] bool opens_display(std::string_view text);

/// Controls that stand for `\begin{name}` or `\end{name}` of a display, as in
/// `\newcommand{\be}{\begin{equation}}`.
struct EnvironmentAliases {
  using Names = std::map<std::string, std::string, std::less<>>;  // from the control to the environment
  Names begins;
  Names ends;

  /// Records what the control is defined as: the body of a macro without parameters. Other bodies end an
  /// alias.
  void define(std::string_view control, std::string_view body);
};

}  // namespace rigor
