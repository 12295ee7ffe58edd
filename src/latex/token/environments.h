// SPDX-License-Identifier: GPL-3.0-or-later
// The environments that display equations, and the author's short names for them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace rigor {

/// `align`, `align*`, `equation`…: what is inside is a displayed equation. The star counts as part of the
/// name.
[[nodiscard]] bool is_display_environment(std::string_view name);
/// `{2}` is after `\begin{alignat}`, `{align}` after `\begin{empheq}`.
[[nodiscard]] bool takes_argument(std::string_view name);
/// `[…]` may be after `\begin{dmath}` and `\begin{empheq}`.
[[nodiscard]] bool takes_options(std::string_view name);
/// `\begin{verbatim}` and its kind, and `filecontents`: nothing inside is read.
[[nodiscard]] bool is_verbatim_environment(std::string_view name);
/// Displays of packages whose form is not known: `maxi`, `DispWithArrows`.
[[nodiscard]] bool is_unread_display(std::string_view name);

/// `$$`, `\[` or the `\begin` of a display stands somewhere in the text.
[[nodiscard]] bool opens_display(std::string_view text);

/// A display whose delimiters an author has given another name.
struct OwnDisplay {
  std::string environment;  // `equation`; `displaymath` for `\[`
  std::string meaning;      // how its body is laid out: `align` for an `aligned` that fills the `equation`
  int parameters = 0;       // arguments after the own name, which are no part of the body
  bool optional_first = false;  // the first of them in brackets
};

/// What `text` opens, if it is the opening of a display and nothing that is displayed: `\begin{equation}`,
/// `\[`, also with `\label{#1}` or a `\begin{aligned}` after it.
[[nodiscard]] std::optional<OwnDisplay> display_opening(std::string_view text);
/// The environment in `\end{equation}`, `\end{aligned}\end{equation}`, `\]`; empty for other texts.
[[nodiscard]] std::string display_closing(std::string_view text);

/// What a definition has after its name; an environment's has a closing body, too.
struct OwnBodies {
  std::string_view opening;
  std::string_view closing = {};
  int parameters = 0;
  bool optional_first = false;
};

/// The author's short names: `\newcommand{\be}{\begin{equation}}`, `\newenvironment{eq}{\[}{\]}`.
struct EnvironmentAliases {
  std::map<std::string, OwnDisplay, std::less<>> begins;  // by the control that opens
  std::map<std::string, std::string, std::less<>> ends;   // from the control that closes to the environment
  std::map<std::string, OwnDisplay, std::less<>> environments;  // by the name of the author's environment
  std::set<std::string, std::less<>> unread_controls;           // a display opens in their definition that is
  std::set<std::string, std::less<>> unread_environments;       // not followed
  std::set<std::string, std::less<>> verbatims;                 // \lstnewenvironment, \excludecomment

  /// Records what the control is defined as. Other bodies end an alias.
  void define(std::string_view control, const OwnBodies& bodies);
  /// The same for an environment.
  void define_environment(std::string_view name, const OwnBodies& bodies);
};

}  // namespace rigor
