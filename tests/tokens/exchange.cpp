// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string_view>
#include <variant>

#include "latex/document/document.h"
#include "latex/dump_syntax.h"

namespace rigor::exchange {
namespace {

/// What a display is read as, and which of its tokens stand in a statement that is not understood.
struct Reading {
  std::string dump;
  SplitDisplay split;
  std::set<std::uint32_t> excused = {};
  std::size_t not_understood = 0;
};

bool holds_opaque(const SyntaxTree& tree) {
  for (std::size_t k = 0; k < tree.size(); ++k) {
    if (tree[static_cast<SyntaxId>(k)].kind == SyntaxKind::opaque) return true;
  }
  return false;
}

/// All but the sides, of which only what is read counts: their text differs wherever a token does.
std::string dump_frame(WrittenChain chain) {
  for (WrittenSide& side : chain.sides) side.tokens.clear();
  return dump_chain(chain);
}

Reading read(const Tokens& tokens, const std::string& environment) {
  Diagnostics diagnostics;
  Reading reading{{}, split_and_count(tokens, environment, diagnostics)};
  for (const WrittenChain& chain : reading.split.chains) {
    reading.dump += dump_frame(chain);
    bool understood = !chain.condition;
    for (const WrittenSide& side : chain.sides) {
      SyntaxTree tree;
      reading.dump += " | " + dump_syntax(tree, parse_side(side.tokens, side.span, tree));
      const bool opaque = holds_opaque(tree);
      understood = understood && !opaque;
      if (!opaque && !chain.condition) continue;
      for (const Token& token : side.tokens) reading.excused.insert(token.place);
    }
    for (const WrittenChain& condition : chain.assumed) {
      reading.dump += " || " + dump_frame(condition);
      for (const WrittenSide& side : condition.sides) {
        SyntaxTree tree;
        reading.dump += " | " + dump_syntax(tree, parse_side(side.tokens, side.span, tree));
      }
    }
    reading.dump += '\n';
    reading.not_understood += understood ? 0 : 1;
  }
  for (const Diagnostic& diagnostic : diagnostics)
    reading.dump += fmt::format("!{}\n", info(diagnostic.kind).name);
  return reading;
}

/// A letter that no token of the display is or holds.
std::string_view fresh_letter(const Tokens& tokens) {
  static constexpr std::string_view letters[] = {"q", "k", "w", "h", "j", "g", "u", "y", "Q", "K", "W", "H",
                                                 "J", "G", "U", "Y", "z", "Z", "f", "n", "s", "v", "x", "ξ"};
  for (const std::string_view letter : letters) {
    const bool occurs = std::any_of(tokens.begin(), tokens.end(), [&](const Token& token) {
      return token.kind == TokenKind::letter && token.text == letter;
    });
    if (!occurs) return letter;
  }
  return "η";
}

bool is_judged(const Reading& reading, const Token& token) {
  return reading.split.uses.of(token) != TokenUse::condition && !reading.excused.contains(token.place);
}

}  // namespace

void Tally::add(const Tally& other) {
  displays += other.displays;
  statements += other.statements;
  not_understood += other.not_understood;
  tokens += other.tokens;
  exchanged += other.exchanged;
  inserted += other.inserted;
  left_over += other.left_over;
  no_difference.insert(no_difference.end(), other.no_difference.begin(), other.no_difference.end());
}

std::vector<TokenDisplay> displays_of(SourceMap& sources, FileId file) {
  Diagnostics diagnostics;
  MacroTable macros;
  std::vector<TokenDisplay> displays;
  const Document document = read_document(sources, file, diagnostics);
  for (const Item& item : document.items) {
    if (const auto* macro = std::get_if<MacroText>(&item))
      static_cast<void>(expand(lex(sources, macro->span), macros, diagnostics));
    const auto* display = std::get_if<Display>(&item);
    if (display == nullptr) continue;
    auto tokens = expand(lex(sources, display->body, display->quotes), macros, diagnostics);
    if (tokens && unbalanced_brace(*tokens) == nullptr)
      displays.push_back({std::move(*tokens), display->environment});
  }
  return displays;
}

Tally exchange_tokens(const SourceMap& sources, const TokenDisplay& display) {
  const Reading before = read(display.tokens, display.environment);
  Tally tally{.displays = 1,
              .statements = before.split.chains.size(),
              .not_understood = before.not_understood,
              .tokens = display.tokens.size()};
  for (const Token& token : before.split.tokens) {
    const bool none = before.split.uses.of(token) == TokenUse::none && !is_layout(token);
    tally.left_over += none && before.not_understood < before.split.chains.size() ? 1 : 0;
  }
  const std::string_view letter = fresh_letter(display.tokens);
  for (std::size_t at = 0; at < display.tokens.size(); ++at) {
    const Token& token = before.split.tokens[at];
    const TokenUse use = before.split.uses.of(token);
    if (!is_judged(before, token)) continue;
    Tokens tokens = display.tokens;
    tokens[at].kind = TokenKind::letter;
    tokens[at].text = letter;
    ++tally.exchanged;
    if (unbalanced_brace(tokens) != nullptr) continue;
    const Reading after = read(tokens, display.environment);
    if (use == TokenUse::aside) {  // the length of a space, say: of it nothing may be read
      const bool argument = token.kind != TokenKind::control && token.kind != TokenKind::begin_group &&
                            token.kind != TokenKind::end_group;
      if (!argument || after.dump == before.dump) continue;
    } else if (after.dump != before.dump || !is_judged(after, after.split.tokens[at])) {
      continue;
    }
    const LineColumn place = sources.line_column(token.span.file, token.span.begin);
    tally.no_difference.push_back(fmt::format("{}:{}:{}: `{}`", sources.path(token.span.file), place.line,
                                              place.column, text_of({&display.tokens[at], 1})));
  }
  return tally;
}

Tally insert_signs(const SourceMap& sources, const TokenDisplay& display) {
  const auto sign = [](TokenKind kind, std::string_view text) { return Token{kind, text, {}}; };
  const Token open = sign(TokenKind::begin_group, "{");
  const Token close = sign(TokenKind::end_group, "}");
  const Token above = sign(TokenKind::superscript, "^");
  const auto word = [&](const char* control, std::initializer_list<const char*> letters) {
    Tokens tokens{sign(TokenKind::control, control), open};
    for (const char* letter : letters) tokens.push_back(sign(TokenKind::letter, letter));
    tokens.push_back(close);
    return tokens;
  };
  struct Added {
    Tokens tokens;
    bool behind;
  };
  const Added added[] = {
      {{above, sign(TokenKind::digit, "0")}, true}, {{above, open, sign(TokenKind::other, "*"), close}, true},
      {{sign(TokenKind::other, "'")}, true},        {word("text", {"g", "r", "a", "d"}), false},
      {word("mathrm", {"R", "e"}), false},          {word("operatorname", {"t", "r"}), false}};
  const Reading before = read(display.tokens, display.environment);
  Tally tally;
  for (std::size_t at = 0; at < display.tokens.size(); ++at) {
    const Token& token = before.split.tokens[at];
    const bool side = before.split.uses.of(token) == TokenUse::side && is_judged(before, token);
    if (!side || token.kind != TokenKind::letter) continue;
    for (const auto& [signs, behind] : added) {
      Tokens tokens = display.tokens;
      const auto place = tokens.begin() + static_cast<std::ptrdiff_t>(at + (behind ? 1 : 0));
      tokens.insert(place, signs.begin(), signs.end());
      ++tally.inserted;
      const Reading after = read(tokens, display.environment);
      if (after.dump != before.dump || after.not_understood > before.not_understood) continue;
      const LineColumn where = sources.line_column(token.span.file, token.span.begin);
      tally.no_difference.push_back(fmt::format("{}:{}:{}: `{}` at `{}`", sources.path(token.span.file),
                                                where.line, where.column, text_of(signs),
                                                text_of({&display.tokens[at], 1})));
    }
  }
  return tally;
}

}  // namespace rigor::exchange
