// SPDX-License-Identifier: GPL-3.0-or-later
// Macros of the author: \newcommand, \renewcommand, \providecommand, \DeclareRobustCommand (starred too;
// optional first argument), \NewDocumentCommand with stars and optional arguments, \DeclareMathOperator,
// \DeclarePairedDelimiter (as \left…\right), \let and \def with undelimited parameters.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "latex/token/token.h"
#include "source/diagnostic.h"

namespace rigor {

enum class MacroUse : std::uint8_t {
  expands,     // the body takes the place of the call, and is expanded in its turn
  stands_for,  // \let to what is no macro: the body is one token, which is never expanded again
  delimiters,  // \DeclarePairedDelimiter: `*` or `[\big]` may be between the control and the argument
  unreadable,  // the definition could not be read: a call is `bad_macro`
  unseen,      // the same in a package, which the author did not write: a call is `unsupported`
};

struct MacroParameter {
  enum class Kind : std::uint8_t { plain, optional, star };
  Kind kind = Kind::plain;
  std::vector<Token> value = {};  // of an optional one that is not there
};

struct Macro {
  std::vector<MacroParameter> parameters = {};  // 9 at most
  std::vector<Token> body = {};
  MacroUse use = MacroUse::expands;
};

using MacroTable = std::map<std::string, Macro, std::less<>>;

/// How long what is defined in a stretch of tokens holds.
enum class MacroScope : std::uint8_t {
  lasting,  // the table keeps it
  group,    // to the end of the stretch, or of the braces around it
};

/// The tokens with every macro of `macros` replaced, definitions in the stream carried out (and removed) in
/// order. Tokens of an argument keep their own spans; tokens of a body get the span of the call (from the
/// control to the last argument), of the outermost one where calls are nested. As in TeX, a macro that is the
/// whole argument of a command stays one argument: `\frac\a\b` becomes `\frac{…}{…}`. A face over an
/// expression goes to its letters (`faces.h`). Ends always: past 200
/// nested or 20,000 expansions or 200,000 tokens out of bodies it reports `macro_recursion` at the call and
/// returns nothing, as for a call without its arguments (`bad_macro`), so that a half-expanded equation is
/// never judged. Definitions that cannot be read are `bad_macro`.
[[nodiscard]] std::optional<std::vector<Token>> expand(std::span<const Token> tokens, MacroTable& macros,
                                                       Diagnostics& diagnostics,
                                                       MacroScope scope = MacroScope::lasting);

}  // namespace rigor
