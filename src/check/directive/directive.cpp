// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/directive/directive.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "base/ascii.h"
#include "check/directive/warning_names.h"
#include "latex/parse/parse.h"
#include "latex/reading/both_signs.h"
#include "latex/reading/cyclic_image.h"
#include "latex/split/conditions.h"
#include "latex/unit/quantity_words.h"
#include "latex/unit/units.h"
#include "source/suggest.h"

namespace rigor {
namespace {

struct DirectiveWord {
  std::string_view word;
  DirectiveKind kind;
};

constexpr std::array directive_words{DirectiveWord{"vector", DirectiveKind::vector},
                                     DirectiveWord{"scalar", DirectiveKind::scalar},
                                     DirectiveWord{"complex", DirectiveKind::complex},
                                     DirectiveWord{"tensor", DirectiveKind::tensor},
                                     DirectiveWord{"particles", DirectiveKind::particles},
                                     DirectiveWord{"constant", DirectiveKind::constant},
                                     DirectiveWord{"let", DirectiveKind::let},
                                     DirectiveWord{"given", DirectiveKind::given},
                                     DirectiveWord{"claim", DirectiveKind::claim},
                                     DirectiveWord{"expect", DirectiveKind::expect},
                                     DirectiveWord{"skip", DirectiveKind::skip},
                                     DirectiveWord{"rotation", DirectiveKind::rotation},
                                     DirectiveWord{"basis", DirectiveKind::basis},
                                     DirectiveWord{"frame", DirectiveKind::frame},
                                     DirectiveWord{"small", DirectiveKind::small},
                                     DirectiveWord{"variable", DirectiveKind::variable},
                                     DirectiveWord{"where", DirectiveKind::where},
                                     DirectiveWord{"order", DirectiveKind::first_order},
                                     DirectiveWord{"allow", DirectiveKind::allow},
                                     DirectiveWord{"warn", DirectiveKind::warn},
                                     DirectiveWord{"units", DirectiveKind::units},
                                     DirectiveWord{"for all", DirectiveKind::for_all},
                                     DirectiveWord{"use", DirectiveKind::use},
                                     DirectiveWord{"space", DirectiveKind::space},
                                     DirectiveWord{"law next", DirectiveKind::expect}};

/// Those of symbols, before or after the kind.
bool describes_symbols(const std::string& word) {
  return word == "symmetric" || word == "unit" || word == "polar" || word == "axial";
}

/// Of two words, the first: it opens a line and says nothing yet.
bool is_half(const std::string& word) { return word == "first" || word == "for" || word == "law"; }

bool is_adjective(const std::string& word) { return describes_symbols(word) || is_half(word); }

/// The line's leading words: `symmetric tensor`, `tensor (symmetric)`, `unit vector`.
struct Opening {
  std::vector<std::string> words;
  Span rest;
};

std::string next_word(std::string_view text, std::size_t& at) {
  while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
  const std::size_t begin = at;
  if (at < text.size() && text[at] == '(') ++at;
  while (at < text.size() && is_letter(text[at])) ++at;
  if (at > begin && text[begin] == '(' && at < text.size() && text[at] == ')') ++at;
  std::string word(text.substr(begin, at - begin));
  std::erase_if(word, [](char c) { return c == '(' || c == ')'; });
  return word;
}

Opening read_opening(const SourceMap& sources, Span line) {
  const std::string_view text = sources.text(line);
  Opening opening;
  std::size_t at = 0;
  while (true) {
    const std::size_t before = at;
    const std::string word = next_word(text, at);
    const bool adjective = describes_symbols(word) || (is_half(word) && opening.words.empty());
    const bool kind_known =
        std::ranges::any_of(opening.words, [](const std::string& known) { return !is_adjective(known); });
    if (kind_known && !adjective) {
      at = before;
      break;
    }
    if (word.empty()) break;
    opening.words.push_back(word);
    for (const std::string_view two : {"for all", "law next"}) {
      if (opening.words.size() == 2 && fmt::format("{}", fmt::join(opening.words, " ")) == two)
        opening.words = {std::string(two)};
    }
  }
  opening.rest = {line.file, line.begin + static_cast<std::uint32_t>(at), line.end};
  return opening;
}

std::vector<TokenView> split_at_commas(TokenView tokens) {
  std::vector<TokenView> parts;
  Nesting nesting(false);
  std::size_t begin = 0;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (nesting.enter(tokens[at]) != 0 || !is_sign(tokens[at], ",")) continue;
    parts.push_back(trim(tokens.subspan(begin, at - begin)));
    begin = at + 1;
  }
  parts.push_back(trim(tokens.subspan(begin)));
  std::erase_if(parts, [](TokenView part) { return part.empty(); });
  return parts;
}

class DirectiveReader {
 public:
  DirectiveReader(const SourceMap& sources, MacroTable& macros, SyntaxTree& syntax, Diagnostics& diagnostics)
      : sources_(sources), macros_(macros), syntax_(syntax), diagnostics_(diagnostics) {}

  std::optional<Directive> read(Span line) {
    const Opening opening = read_opening(sources_, line);
    Directive directive;
    directive.span = line;
    directive.text = std::string(sources_.text(line));
    const auto kind = kind_of(opening.words, line, directive);
    if (!kind) return std::nullopt;
    directive.kind = *kind;
    if (directive.polar && directive.kind != DirectiveKind::vector)
      return bad(line, "only a vector is declared polar or axial", "e.g. `axial vector \\mathbf{B}`");
    if (directive.kind == DirectiveKind::skip) return directive;
    if (directive.kind == DirectiveKind::first_order) {
      if (opening.words.front() == "first") return directive;
      return bad(line, "`order` is not a directive by itself",
                 "`first order` says how the next statement is meant");
    }
    if (directive.kind == DirectiveKind::allow || directive.kind == DirectiveKind::warn)
      return read_warning_names(sources_, opening.rest, directive, diagnostics_) ? std::optional(directive)
                                                                                 : std::nullopt;
    if (directive.kind == DirectiveKind::frame) return frame(opening.rest, std::move(directive));
    if (directive.kind == DirectiveKind::space) return space(opening.rest, std::move(directive));
    if (directive.kind == DirectiveKind::use) return use(opening.rest, std::move(directive));
    if (is_one_of("law next", opening.words)) {
      directive.expected = Verdict::law;
      return directive;
    }
    if (directive.kind == DirectiveKind::expect) return expectation(opening.rest, std::move(directive));
    auto tokens = expand(lex(sources_, opening.rest), macros_, diagnostics_);
    if (!tokens) return std::nullopt;
    tokens = with_named_words(*std::move(tokens));
    const bool equations = directive.kind == DirectiveKind::let || directive.kind == DirectiveKind::given ||
                           directive.kind == DirectiveKind::where || directive.kind == DirectiveKind::claim;
    return equations ? with_chains(*tokens, std::move(directive))
                     : with_symbols(*tokens, std::move(directive));
  }

 private:
  std::optional<DirectiveKind> kind_of(const std::vector<std::string>& words, Span line,
                                       Directive& directive) {
    std::string unknown = words.empty() ? std::string(sources_.text(line)) : words[0];
    for (const std::string& word : words) {
      if (word == "symmetric") directive.symmetric = true;
      if (word == "unit") directive.unit = true;
      if (word == "polar" || word == "axial") directive.polar = word == "polar";
    }
    for (const std::string& word : words) {
      const auto known = std::ranges::find(directive_words, word, &DirectiveWord::word);
      if (known != directive_words.end()) return known->kind;
      if (!is_adjective(word)) unknown = word;
    }
    const Span place{line.file, line.begin,
                     std::min(line.end, line.begin + static_cast<std::uint32_t>(unknown.size()))};
    Diagnostic diagnostic{DiagnosticKind::unknown_directive, place,
                          fmt::format("`{}` is not a directive", unknown)};
    std::vector<std::string> known;
    for (const DirectiveWord& entry : directive_words) known.emplace_back(entry.word);
    if (const auto near = suggest(unknown, known)) {
      diagnostic.help = {fmt::format("did you mean `{}`?", *near)};
    } else {
      diagnostic.help = {fmt::format("known are {}", fmt::join(known, ", "))};
    }
    diagnostics_.push_back(std::move(diagnostic));
    return std::nullopt;
  }

  std::optional<Directive> bad(Span span, std::string message, std::string help) {
    diagnostics_.push_back({DiagnosticKind::bad_directive, span, std::move(message), {}, {std::move(help)}});
    return std::nullopt;
  }

  std::optional<Directive> expectation(Span rest, Directive directive) {
    std::size_t at = 0;
    const std::string word = next_word(sources_.text(rest), at);
    for (const Verdict each : {Verdict::refuted, Verdict::law, Verdict::suspect}) {
      if (word != name_of(each)) continue;
      directive.expected = each;
      return directive;
    }
    return bad(
        directive.span, fmt::format("`expect {}` is not known", word),
        "`expect refuted` says that the next statement is false, `expect suspect` that it is likely to "
        "be, `expect law` that it is stated and not concluded");
  }

  /// `frame rot rotates with \boldsymbol{\omega} in in`
  std::optional<Directive> frame(Span rest, Directive directive) {
    static constexpr std::string_view with = " rotates with ";
    static constexpr std::string_view in = " in ";
    const std::string_view text = sources_.text(rest);
    const auto verb = text.find(with);
    const auto last = text.rfind(in);
    const bool fits =
        verb != std::string_view::npos && last != std::string_view::npos && last >= verb + with.size();
    std::size_t at = 0;
    if (fits) {
      directive.rotating = next_word(text, at);
      at = last + in.size();
      directive.fixed = next_word(text, at);
    }
    if (directive.rotating.empty() || directive.fixed.empty() || directive.rotating == directive.fixed)
      return bad(directive.span, "the directive does not name two frames and an angular velocity",
                 "e.g. `frame rot rotates with \\boldsymbol{\\omega} in in`");
    const Span velocity{rest.file, rest.begin + static_cast<std::uint32_t>(verb + with.size()),
                        rest.begin + static_cast<std::uint32_t>(last)};
    const auto tokens = expand(lex(sources_, velocity), macros_, diagnostics_);
    if (!tokens) return std::nullopt;
    return with_symbols(*tokens, std::move(directive));
  }

  /// `space plane 2`
  std::optional<Directive> space(Span rest, Directive directive) {
    std::istringstream words{std::string(sources_.text(rest))};
    std::string dimension;
    std::string more;
    words >> directive.space >> dimension >> more;
    const bool one_digit = dimension.size() == 1 && dimension[0] >= '1' && dimension[0] <= '9';
    if (!one_digit || !more.empty())
      return bad(directive.span, "the directive does not name a space and its dimension, from 1 to 9",
                 "e.g. `space plane 2`");
    directive.dimension = dimension[0] - '0';
    return directive;
  }

  /// `use (2.1), line 12, label hooke, \mathbf{p}`
  std::optional<Directive> use(Span rest, Directive directive) {
    auto tokens = expand(lex(sources_, rest), macros_, diagnostics_);
    if (!tokens) return std::nullopt;
    tokens = with_named_words(*std::move(tokens));
    for (const TokenView part : split_at_commas(*tokens)) {
      static constexpr std::string_view label_word = "label ";
      const std::string text(sources_.text(span_of(part)));
      if (text.starts_with(label_word)) {
        directive.places.push_back(text.substr(label_word.size()));
        continue;
      }
      const bool tag = text.size() > 2 && text.front() == '(' && text.back() == ')';
      const bool label = text.find(':') != std::string::npos;
      if (tag || label || text.starts_with("line ")) {
        directive.places.push_back(text);
        continue;
      }
      const SyntaxId symbol = parse_side(part, span_of(part), syntax_);
      if (syntax_[symbol].kind != SyntaxKind::symbol)
        return bad(span_of(part), fmt::format("`{}` is not a tag, a label, a line or a symbol", text),
                   "e.g. `use (2.1), line 12, label hooke, \\mathbf{p}`");
      directive.symbols.push_back(symbol);
    }
    return directive;
  }

  std::optional<Directive> with_symbols(TokenView tokens, Directive directive) {
    for (TokenView part : split_at_commas(tokens)) {
      if (directive.kind == DirectiveKind::units && !take_dimension(part, directive)) return std::nullopt;
      const SyntaxId symbol = parse_side(part, span_of(part), syntax_);
      if (syntax_[symbol].kind != SyntaxKind::symbol)
        return bad(span_of(part), fmt::format("`{}` is not a symbol", text_of(part)),
                   "symbols are separated by commas");
      directive.symbols.push_back(symbol);
    }
    if (directive.symbols.empty())
      return bad(directive.span, "the directive names no symbol",
                 "symbols are separated by commas, e.g. `vector \\mathbf{A}, \\mathbf{B}`");
    return directive;
  }

  /// The dimension after the colon; what comes before it is left.
  bool take_dimension(TokenView& part, Directive& directive) {
    const auto colon = std::ranges::find_if(part, [](const Token& token) { return is_sign(token, ":"); });
    if (colon == part.end()) {
      bad(span_of(part), fmt::format("`{}` has no dimension after a colon", text_of(part)),
          "e.g. `units m: M, v: L/T, F: N`");
      return false;
    }
    const TokenView behind = trim(TokenView(colon + 1, part.end()));
    std::string problem;
    const std::string text = behind.empty() ? std::string() : std::string(sources_.text(span_of(behind)));
    const auto unit = read_unit(text, UnitNames::dimensions, &problem);
    if (!unit) {
      bad(span_of(part), std::move(problem), "a dimension is a product of powers of M, L, T or of units");
      return false;
    }
    directive.dimensions.emplace_back(unit->exponents);
    part = trim(TokenView(part.begin(), colon));
    return true;
  }

  std::optional<Directive> with_chains(TokenView tokens, Directive directive) {
    const bool assumes = directive.kind == DirectiveKind::given || directive.kind == DirectiveKind::where;
    const auto parts = assumes ? conditions_in(tokens) : std::nullopt;
    if (parts && parts->size() > 1) {
      // `x, y > 0`, `x > 0, y > 0`: each is given, and none is a condition of the others.
      for (const Tokens& part : *parts) {
        for (ParsedChain& chain : parse_chains(part, "", syntax_, diagnostics_))
          directive.chains.push_back(std::move(chain));
      }
    } else {
      directive.chains = parse_chains(tokens, "", syntax_, diagnostics_);
    }
    for (const ParsedChain& chain : directive.chains) {
      if (directive.kind == DirectiveKind::claim || chain.assumed.empty()) continue;
      const std::string condition = text_of(chain.assumed.front().written);
      return bad(directive.span,
                 fmt::format("what is given holds without conditions, but `{}` is one", condition),
                 "a comma or `and` between two relations gives both");
    }
    const bool relation =
        !directive.chains.empty() && std::ranges::all_of(directive.chains, [](const ParsedChain& chain) {
          return !chain.written.relations.empty();
        });
    if (!relation)
      return bad(directive.span, "the directive holds no equation",
                 "e.g. `given \\sum_\\alpha m_\\alpha \\mathbf{r}_\\alpha = 0`");
    return directive;
  }

  const SourceMap& sources_;
  MacroTable& macros_;
  SyntaxTree& syntax_;
  Diagnostics& diagnostics_;
};

}  // namespace

Span without_comment(const SourceMap& sources, Span line) {
  std::string_view text = sources.text(line);
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool begins = text[at] == '#' && (at == 0 || text[at - 1] == ' ' || text[at - 1] == '\t');
    if (!begins) continue;
    text = text.substr(0, at);
    break;
  }
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  std::uint32_t begin = line.begin;
  while (!text.empty() && blank(text.front())) {
    text.remove_prefix(1);
    ++begin;
  }
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return {line.file, begin, begin + static_cast<std::uint32_t>(text.size())};
}

std::optional<Directive> read_directive(const SourceMap& sources, Span line, MacroTable& macros,
                                        SyntaxTree& syntax, Diagnostics& diagnostics) {
  const Span bare = without_comment(sources, line);
  if (bare.empty()) return std::nullopt;
  return DirectiveReader(sources, macros, syntax, diagnostics).read(bare);
}

void add_images(std::vector<ParsedChain>& chains, SyntaxTree& syntax) {
  const WrittenAxes axes = axes_in(syntax, chains.back().sides);
  for (int image = 1; image <= 2; ++image) {
    ParsedChain next = chains.back();
    next.image = image;
    next.assumed.clear();
    next.remainders.clear();
    if (axes.obstacle) {
      next.written.condition = axes.obstacle;
      next.written.condition_span = axes.place;
      chains.push_back(std::move(next));
      return;
    }
    for (SyntaxId& side : next.sides) side = cyclic_image(syntax, side, axes);
    for (std::vector<SyntaxId>& other : next.others) {
      for (SyntaxId& side : other) side = cyclic_image(syntax, side, axes);
    }
    chains.push_back(std::move(next));
  }
}

std::vector<ParsedChain> parse_chains(TokenView tokens, std::string_view environment, SyntaxTree& syntax,
                                      Diagnostics& diagnostics) {
  const auto parsed = [&](WrittenChain& written) {
    ParsedChain chain;
    Readings readings = parse_readings(written, syntax);
    chain.sides = std::move(readings.sides);
    chain.choices = std::move(readings.choices);
    chain.others = std::move(readings.others);
    chain.remainders = remainders_of(syntax, chain.sides);
    chain.written = std::move(written);
    return chain;
  };
  std::vector<ParsedChain> chains;
  const auto add = [&](WrittenChain written, std::string signs) {
    ParsedChain chain = parsed(written);
    chain.signs = std::move(signs);
    for (WrittenChain& condition : chain.written.assumed) chain.assumed.push_back(parsed(condition));
    if (chain.written.of_cases && !chain.assumed.empty()) {
      chain.signs += chain.signs.empty() ? "where " : ", where ";
      for (const ParsedChain& condition : chain.assumed) {
        if (&condition != &chain.assumed.front()) chain.signs += " and ";
        chain.signs += text_of(condition.written);
      }
    }
    const bool cyclic = chain.written.cyclic;
    chains.push_back(std::move(chain));
    if (cyclic) add_images(chains, syntax);
  };
  for (WrittenChain& written : split_display(tokens, environment, diagnostics)) {
    if (!is_two_statements(written)) {
      add(std::move(written), "");
      continue;
    }
    add(with_signs(written, true), "upper signs");
    add(with_signs(written, false), "lower signs");
  }
  return chains;
}

}  // namespace rigor
