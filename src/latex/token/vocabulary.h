// SPDX-License-Identifier: GPL-3.0-or-later
// The words of LaTeX mathematics that Rigor knows: one table for each class, so that a new notation is a new
// line here.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "latex/token/syntax.h"
#include "latex/token/token.h"

namespace rigor {

enum class RelationKind : std::uint8_t {
  equal,      // = and what is written over it
  identical,  // \equiv
  defines,    // :=
  demanded,   // = with ! above it: a condition that is imposed
  less,
  less_or_equal,
  greater,
  greater_or_equal,
  unequal,
  nearly,        // \approx, \simeq: to first order in what is small
  much_less,     // \ll
  much_greater,  // \gg
  other,         // \propto, \in…: read as a relation, not decided
  implies,       // \Rightarrow, \iff…: between equations
};
/// <, ≤, >, ≥ or ≠.
[[nodiscard]] constexpr bool is_order(RelationKind kind) {
  return kind == RelationKind::less || kind == RelationKind::less_or_equal || kind == RelationKind::greater ||
         kind == RelationKind::greater_or_equal || kind == RelationKind::unequal;
}
/// `=`, `\equiv`, `:=`: both sides are said to be the same.
[[nodiscard]] constexpr bool is_equality(RelationKind kind) {
  return kind == RelationKind::equal || kind == RelationKind::identical || kind == RelationKind::defines;
}

/// The relation that a control word (`leq`) or a sign (`<`) writes.
[[nodiscard]] std::optional<RelationKind> relation_kind(const Token& token);

/// Signs that take space or change the look, and no meaning: `\,`, `\displaystyle`, `\nonumber`…
[[nodiscard]] bool is_spacing(const Token& token);
/// Sizes before a bracket: `\left`, `\bigl`, `\Big`…; nothing but the bracket matters.
[[nodiscard]] bool is_bracket_size(const Token& token);
/// `\quad` and wider: what comes after it is another equation, a tag or a remark.
[[nodiscard]] bool is_wide_space(const Token& token);
/// Controls whose braces hold words: `\text`, `\mbox`, `\textrm`…
[[nodiscard]] bool is_words(const Token& token);
/// Controls whose one argument is kept and nothing else: `\boxed`, `\mathstrut`, `\ensuremath`…
[[nodiscard]] bool is_transparent(const Token& token);
/// Environments whose rows are rows of the display around them: `aligned`, `split`, `gathered`…
[[nodiscard]] bool is_transparent_environment(std::string_view name);

/// `\alpha` for the control `alpha` or the letter α; `\epsilon` for every form of epsilon; the letter itself
/// otherwise. Empty where the token writes no letter.
[[nodiscard]] std::string letter_of(const Token& token);
[[nodiscard]] bool is_greek(std::string_view letter);
/// A hole: the letter of `\square`, `\Box`, and of `?` where an operand is expected.
inline constexpr std::string_view hole_letter = "\\square";
inline constexpr const char* box_letter = "\\Box";  // what d'Alembert's operator differentiates by
/// Is `?` at this place the operand that a reader asks for, rather than the mark of a question?
[[nodiscard]] bool is_asking_mark(std::span<const Token> tokens, std::size_t at);

/// A face that a control gives to its argument: `\mathbf`, `\vec`, `\overleftrightarrow`; `\hat` gives an
/// accent.
struct Style {
  Face face = Face::plain;
  Accent accent = Accent::none;
  bool upright = false;            // \mathrm: a word, or a letter of its own kind
  std::string_view alphabet = {};  // `mathcal`: another letter than the plain one
};
[[nodiscard]] std::optional<Style> style_of(const Token& token);

/// How the sign joins two factors: `\cdot`, `\times`, `\cross`, `*`, `/`; `none` where it does not.
[[nodiscard]] Joint factor_joint(const Token& token);

/// `\frac`, `\nicefrac`…: a fraction of its two arguments.
[[nodiscard]] bool is_fraction(const Token& token);
/// `\dot`, `\ddot`…: how many dots it sets over its argument; 0 for other tokens.
[[nodiscard]] std::uint8_t dots_of(const Token& token);
/// `sin` for `sin`, `tr` for `Tr`: the name of a function that is read; empty for other words.
[[nodiscard]] std::string_view function_name(std::string_view word);
/// Is it a usual letter for an angle? `\cos\theta r` can be a product, where `\cos\omega t` is none.
[[nodiscard]] bool is_usual_angle(std::string_view letter);
enum class FieldOperator : std::uint8_t { gradient, divergence, curl, laplacian };
/// The derivatives of fields that the physics package names: `grad`, `gradient`, `div`…
[[nodiscard]] std::optional<FieldOperator> field_operator(std::string_view word);

/// `\ket`, `\mel`…: a bracket of states with its arguments, of braket and physics.
[[nodiscard]] bool is_state_bracket(const Token& token);

/// Why a control is not read yet, e.g. "limits are not decided yet"; empty for unknown controls.
[[nodiscard]] std::string_view unread_reason(std::string_view control);

/// Runs of plain letters in a subscript that are a word, not indices: `rot`, `cm`, `tot`, and all capitals.
[[nodiscard]] bool is_subscript_word(std::string_view letters);

}  // namespace rigor
