// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that the body of a macro makes on its arguments: was a star there, is an optional argument there, is
// it empty? Only what is plain when it is reached is answered.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "latex/macro/macro_stream.h"

namespace rigor {

struct MacroTest {
  enum class Kind : std::uint8_t {
    truth,     // \IfBooleanTF: of a star
    no_value,  // \IfNoValueTF: an optional argument without a default is not there
    value,     // \IfValueTF
    blank,     // \IfBlankTF, \ifblank, \ifstrempty
    equal,     // \ifthenelse{\equal{…}{…}}
  };
  Kind kind;
  bool then = true;       // a branch for what holds is written
  bool otherwise = true;  // and one for what does not
};

/// The test that a control makes; nothing for other controls.
[[nodiscard]] std::optional<MacroTest> macro_test(std::string_view control);
/// The tokens of the branch that counts; the test and all its branches are taken. Nothing where the answer is
/// not known, or a branch is missing.
[[nodiscard]] std::optional<Tokens> chosen_branch(MacroStream& stream, const MacroTest& test);

/// What an argument is that is not there, and what a star is.
[[nodiscard]] Token no_value();
[[nodiscard]] Token truth_value(bool value);

}  // namespace rigor
