// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/parse/unseen_braces.h"

#include <string>

#include "catch.h"

using namespace rigor;

namespace {

/// Of the first group of the text.
struct Written {
  SourceMap sources;
  Tokens tokens;
  std::size_t at = 0;

  explicit Written(const std::string& text) {
    const FileId file = sources.add("notes.tex", text);
    tokens = lex(sources, {file, 0, static_cast<std::uint32_t>(text.size())});
    while (tokens[at].kind != TokenKind::begin_group) ++at;
  }
};

bool unseen(const std::string& text) {
  const Written written(text);
  return groups_unseen(written.tokens, written.at);
}

}  // namespace

TEST_CASE("braces around a sum act as brackets behind a minus and beside factors", "[braces]") {
  CHECK(unseen("a - {b - c}"));
  CHECK(unseen("-{a + b}"));
  CHECK(unseen("2{a + b}"));
  CHECK(unseen("{a + b}c"));
  CHECK(unseen("{a + b}^2"));
  CHECK(unseen("a/{b + c}"));
  CHECK_FALSE(unseen("a + {b - c}"));
  CHECK_FALSE(unseen("{a + b} - c"));
  CHECK_FALSE(unseen("a + {b + c} + d"));
}

TEST_CASE("braces around a product act as brackets before a script and behind a slash", "[braces]") {
  CHECK(unseen("{2b}^2"));
  CHECK(unseen("{ab}_i"));
  CHECK(unseen("a/{bc}"));
  CHECK(unseen("\\nabla{fg}"));
  CHECK(unseen("{a/b}c"));
  CHECK(unseen("{\\sin x}y"));
  CHECK(unseen("{\\sin x}^2"));
  CHECK(unseen("{-b}^2"));
  CHECK(unseen("a{-b}"));
  CHECK_FALSE(unseen("a{bc}d"));
  CHECK_FALSE(unseen("-{ab} + c"));
  CHECK_FALSE(unseen("-{a/b} + c"));
}

TEST_CASE("braces around one operand, a fraction or a change of face act as nothing", "[braces]") {
  CHECK_FALSE(unseen("{10}^{-3}"));
  CHECK_FALSE(unseen("{x_1}^2"));
  CHECK_FALSE(unseen("{(a + b)}^2"));
  CHECK_FALSE(unseen("{\\left(a + b\\right)}^2"));
  CHECK_FALSE(unseen("{\\frac{a}{b + c}}^2"));
  CHECK_FALSE(unseen("{|a + b|}^2"));
  CHECK_FALSE(unseen("{\\sqrt{a + b}}^2"));
  CHECK_FALSE(unseen("{\\mathbf{a}}^2"));
  CHECK_FALSE(unseen("{\\dot x}^2"));
  CHECK_FALSE(unseen("{\\rm Tr}A"));
  CHECK_FALSE(unseen("{\\bf a}^2"));
  CHECK_FALSE(unseen("2{a + b \\over c}"));
  CHECK_FALSE(unseen("{dx}^2"));
  CHECK_FALSE(unseen("{\\Delta x}^2"));
  CHECK_FALSE(unseen("{}^2"));
  CHECK_FALSE(unseen("a{=}b"));
}

TEST_CASE("two powers that only braces tell apart are seen as one", "[braces]") {
  const auto stacks = [](const std::string& text) {
    const Written written(text);
    return stacks_powers(written.tokens, written.at);
  };
  CHECK(stacks("{x^2}^3"));
  CHECK_FALSE(stacks("{x_2}^3"));
  CHECK_FALSE(stacks("{x^2}y"));
  CHECK_FALSE(stacks("{(x^2)}^3"));
}
