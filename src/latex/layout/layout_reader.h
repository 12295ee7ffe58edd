// SPDX-License-Identifier: GPL-3.0-or-later
// One stretch of tokens as a row of boxes. A group, an argument, a cell is read by a reader of its own.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "latex/layout/layout.h"
#include "latex/layout/signs.h"

namespace rigor {

/// What the brackets around a stretch say of it.
struct LayoutContext {
  unsigned depth = 0;  // of brackets
  Typeface face = Typeface::italic;
};

class LayoutReader {
 public:
  LayoutReader(TokenView tokens, LayoutContext context) : tokens_(tokens), context_(context) {}

  /// A row of all that was read; a single part stands for itself.
  [[nodiscard]] Box read();
  /// After `read`: what `\tag` outside all groups says, as printed.
  [[nodiscard]] const std::string& tag() const { return tag_; }

  /// Rows and cells of all tokens, as `\\` and `&` divide them.
  [[nodiscard]] static Box table(TokenView tokens, TableAlignment alignment, LayoutContext context);

 private:
  void step();
  void letter(const Token& token);
  void number();
  void sign(PrintedSign printed, int size = 0);
  void scripts();

  void control(std::string_view name);
  bool bracket(std::string_view name);
  bool fraction(std::string_view name);
  bool stacked(std::string_view name);
  bool vanishing(std::string_view name);
  bool kept(std::string_view name);
  bool words(std::string_view name);
  bool quantity(std::string_view name);       // siunitx
  bool physics(std::string_view name);        // what the physics package abbreviates
  bool derivative(std::string_view name);     // of it
  bool physics_fence(std::string_view name);  // of it
  void over(std::string_view name);
  void negated();
  void function_word(Box word);
  void environment();
  void left_fence();

  /// The next argument as a box; `take_argument` as tokens.
  [[nodiscard]] Box argument();
  [[nodiscard]] Box argument(Typeface face);
  [[nodiscard]] TokenView take_argument();
  [[nodiscard]] std::optional<TokenView> take_optional();
  [[nodiscard]] Box inner(TokenView tokens) const { return inner(tokens, context_.face); }
  [[nodiscard]] Box inner(TokenView tokens, Typeface face) const;
  /// The sign of a delimiter at the place, which is passed; nothing for `.`.
  [[nodiscard]] std::optional<PrintedSign> delimiter();
  [[nodiscard]] bool next_is(std::string_view sign) const;
  void skip_star();
  void push(Box box) { parts_.push_back(std::move(box)); }

  TokenView tokens_;
  LayoutContext context_;
  std::size_t at_ = 0;
  std::vector<Box> parts_;
  std::string tag_;
};

// Boxes of one kind.

[[nodiscard]] Box row_box(std::vector<Box> parts);
[[nodiscard]] Box letter_box(std::string_view text, Typeface face);
[[nodiscard]] Box sign_box(std::string_view text, SignRole role);
[[nodiscard]] Box words_box(std::string_view text);
[[nodiscard]] Box space_box(double width);
[[nodiscard]] Box fence_box(std::string_view open, Box inside, std::string_view close);
[[nodiscard]] Box fraction_box(Box above, Box below);
[[nodiscard]] Box scripts_box(Box base, Box lower, Box upper);

[[nodiscard]] bool is_empty(const Box& box);
/// The role of a sign, with its scripts; ordinary for anything else.
[[nodiscard]] SignRole role_of(const Box& box);

/// The contents of `\text{…}`: words, with mathematics between dollar signs.
[[nodiscard]] Box text_box(TokenView tokens, LayoutContext context);
/// The same without mathematics, on one line.
[[nodiscard]] std::string text_line(TokenView tokens);

}  // namespace rigor
