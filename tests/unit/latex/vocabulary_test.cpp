// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/vocabulary.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

/// The first token of a text; the text outlives it.
struct One {
  Stretch stretch;
  explicit One(const std::string& text) : stretch(text) {}
  operator const Token&() const { return stretch.tokens.at(0); }  // NOLINT: meant to convert
};

}  // namespace

TEST_CASE("relations are known as controls and as signs") {
  CHECK(relation_kind(One("=")) == RelationKind::equal);
  CHECK(relation_kind(One("\\equiv")) == RelationKind::identical);
  CHECK(relation_kind(One("≡")) == RelationKind::identical);
  CHECK(relation_kind(One("\\coloneqq")) == RelationKind::defines);
  CHECK(relation_kind(One("\\iff")) == RelationKind::implies);
  CHECK(relation_kind(One("⇒")) == RelationKind::implies);
  for (const char* text : {"\\propto", "\\to", "\\sim", "\\in", "\\lesssim", "∝", "→"}) {
    INFO(text);
    CHECK(relation_kind(One(text)) == RelationKind::other);
  }
  for (const char* text : {"+", "\\cdot", "a", "|", ":", "\\foo"}) {
    INFO(text);
    CHECK_FALSE(relation_kind(One(text)).has_value());
  }
}

TEST_CASE("orders, inequality and near equality are told apart") {
  const auto all = [](std::initializer_list<const char*> texts, RelationKind kind) {
    for (const char* text : texts) {
      INFO(text);
      CHECK(relation_kind(One(text)) == kind);
    }
  };
  all({"<", "\\lt"}, RelationKind::less);
  all({"\\le", "\\leq", "\\leqslant", "≤", "⩽"}, RelationKind::less_or_equal);
  all({">", "\\gt"}, RelationKind::greater);
  all({"\\ge", "\\geq", "\\geqslant", "≥", "⩾"}, RelationKind::greater_or_equal);
  all({"\\ne", "\\neq", "≠"}, RelationKind::unequal);
  all({"\\approx", "\\simeq", "\\cong", "\\approxeq", "≈", "≃", "≅"}, RelationKind::nearly);
  all({"\\ll", "≪"}, RelationKind::much_less);
  all({"\\gg", "≫"}, RelationKind::much_greater);
}

TEST_CASE("dots, functions and derivatives of fields are known by name") {
  CHECK(dots_of(One("\\dot")) == 1);
  CHECK(dots_of(One("\\dddot")) == 3);
  CHECK(dots_of(One("\\hat")) == 0);
  CHECK(function_name("sin") == "sin");
  CHECK(function_name("Tr") == "tr");
  CHECK(function_name("arcsin") == "arcsin");
  CHECK(function_name("max").empty());
  CHECK(field_operator("gradient") == FieldOperator::gradient);
  CHECK_FALSE(field_operator("sin").has_value());
}

TEST_CASE("product signs join factors") {
  for (const char* text : {"\\cdot", "\\vdot", "·"}) CHECK(factor_joint(One(text)) == Joint::dot);
  for (const char* text : {"\\times", "\\cross", "×"}) CHECK(factor_joint(One(text)) == Joint::cross);
  CHECK(factor_joint(One("/")) == Joint::slash);
  for (const char* text : {"+", "\\circ", "x", "\\wedge"}) CHECK(factor_joint(One(text)) == Joint::none);
}

TEST_CASE("a letter has one name, however it is written") {
  CHECK(letter_of(One("A")) == "A");
  CHECK(letter_of(One("\\omega")) == "\\omega");
  CHECK(letter_of(One("ω")) == "\\omega");
  for (const char* text : {"\\epsilon", "\\varepsilon", "ε", "ϵ"}) CHECK(letter_of(One(text)) == "\\epsilon");
  for (const char* text : {"\\times", "1", "\\foo", "∑"}) CHECK(letter_of(One(text)).empty());
}

TEST_CASE("Greek letters are told from other named letters") {
  CHECK(is_greek("\\alpha"));
  CHECK(is_greek("\\Omega"));
  for (const char* letter : {"a", "\\ell", "\\hbar", "\\imath", ""}) CHECK_FALSE(is_greek(letter));
}

TEST_CASE("a style gives a face, an accent, or upright letters") {
  for (const char* text : {"\\mathbf", "\\vec", "\\boldsymbol", "\\bm", "\\vb", "\\va"}) {
    INFO(text);
    REQUIRE(style_of(One(text)).has_value());
    CHECK(style_of(One(text))->face == Face::vector);
  }
  CHECK(style_of(One("\\overleftrightarrow"))->face == Face::tensor);
  CHECK(style_of(One("\\hat"))->accent == Accent::hat);
  CHECK(style_of(One("\\overline"))->accent == Accent::bar);
  CHECK(style_of(One("\\widetilde"))->accent == Accent::tilde);
  CHECK(style_of(One("\\mathrm"))->upright);
  CHECK_FALSE(style_of(One("\\frac")).has_value());
}

TEST_CASE("spacing, wide space, sizes and words are told apart") {
  for (const char* text : {"\\,", "\\!", "~", "\\displaystyle", "\\nonumber", "\\ "}) {
    INFO(text);
    CHECK(is_spacing(One(text)));
    CHECK_FALSE(is_wide_space(One(text)));
  }
  CHECK(is_wide_space(One("\\quad")));
  CHECK_FALSE(is_spacing(One("\\quad")));
  for (const char* text : {"\\left", "\\bigl", "\\Big", "\\middle"}) CHECK(is_bracket_size(One(text)));
  for (const char* text : {"\\text", "\\mbox", "\\textrm"}) CHECK(is_words(One(text)));
  CHECK_FALSE(is_words(One("\\mathbf")));
  CHECK(is_transparent(One("\\boxed")));
}

TEST_CASE("environments of rows are transparent, those of values are not") {
  for (const char* name : {"aligned", "split", "gathered", "align*"}) CHECK(is_transparent_environment(name));
  for (const char* name : {"cases", "pmatrix", "array", "tikz"})
    CHECK_FALSE(is_transparent_environment(name));
}

TEST_CASE("a control that is not read yet has a reason, an unknown one has none") {
  CHECK(unread_reason("lim") == "limits are not decided yet");
  CHECK_FALSE(unread_reason("max").empty());
  CHECK(unread_reason("foo").empty());
}

TEST_CASE("capitals and known words are labels, single letters are not") {
  for (const char* word : {"rot", "cm", "CM", "ext", "kin"}) CHECK(is_subscript_word(word));
  for (const char* word : {"ij", "C", "i", "xyz", ""}) CHECK_FALSE(is_subscript_word(word));
}
