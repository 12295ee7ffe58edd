// SPDX-License-Identifier: GPL-3.0-or-later
// What controls and characters look like: the sign that `\times`, `\leq`, `\alpha` print.
#pragma once

#include <optional>
#include <string_view>

#include "latex/layout/layout.h"

namespace rigor {

struct PrintedSign {
  std::string_view text;
  SignRole role = SignRole::ordinary;
  bool letter = false;  // set in italics as letters are: α, ℓ
};

/// The sign of a control word or of a control symbol such as `\{`.
[[nodiscard]] std::optional<PrintedSign> sign_of_control(std::string_view control);
/// Of one character that is typed as it is: `+`, `∑`, `·`.
[[nodiscard]] std::optional<PrintedSign> sign_of_character(std::string_view character);

/// `\hat`: what is over (or under) its argument.
struct PrintedAccent {
  std::string_view text;
  bool wide = false;
  bool below = false;
};
[[nodiscard]] std::optional<PrintedAccent> accent_of(std::string_view control);

/// How wide a space is, in em: `\,`, `\quad`, `~`; `\displaystyle` and others that print nothing have no
/// width.
[[nodiscard]] std::optional<double> space_of(std::string_view control);

/// The typeface that `\mathbf`, `\mathcal`… give to their argument.
[[nodiscard]] std::optional<Typeface> typeface_of(std::string_view control);

/// `\sin`, `\Tr`: an upright word before its argument; empty for other controls.
[[nodiscard]] std::string_view printed_function(std::string_view control);

}  // namespace rigor
