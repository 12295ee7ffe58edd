// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/event/notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "base/ascii.h"
#include "check/event/declared_first.h"
#include "check/event/demand.h"
#include "check/word/said_kinds.h"
#include "check/word/sizes.h"
#include "latex/parse/parse.h"
#include "latex/split/conditions.h"
#include "latex/split/rows.h"
#include "latex/text/scoped_macros.h"
#include "latex/unit/quantity_words.h"
#include "source/suggest.h"

namespace rigor {
namespace {

class CheckedNotesReader {
 public:
  CheckedNotesReader(SourceMap& sources, FileId file, Diagnostics& diagnostics)
      : sources_(sources), diagnostics_(diagnostics) {
    notes_.file = file;
  }

  Notes read(const FileId* sidecar, std::span<const FileId> asked, const AddedStatement* added) {
    const Document document = read_document(sources_, notes_.file, diagnostics_);
    for (const Item& item : document.items) {
      std::visit([this](const auto& each) { add(each); }, item);
    }
    parse_displays();
    if (sidecar != nullptr) insert_sidecar(*sidecar);
    for (const FileId each : asked) notes_.asked.push_back(read_asked(each));
    if (added != nullptr) insert(*added);
    notes_.events = with_declarations_first(std::move(notes_.events), notes_.syntax);
    add_prose();
    return std::move(notes_);
  }

 private:
  void add(const Heading& heading) { notes_.events.emplace_back(heading); }

  void add(const MacroText& text) { macros_.define(sources_, text, diagnostics_); }

  void add(const MacroGroup& group) { macros_.pass(group); }

  void add(const DirectiveLine& line) {
    if (auto directive = read(line.span))
      notes_.events.emplace_back(PlacedDirective{std::move(*directive), line.span});
  }

  void add(const Display& display) {
    ParsedDisplay parsed;
    parsed.span = display.span;
    const std::uint32_t size = display.body.end - display.body.begin;
    if (size > max_display_bytes) {
      parsed.unread = true;
      parsed.diagnostics.push_back(
          {DiagnosticKind::display_too_long,
           {display.span.file, display.span.begin, display.span.begin + 1},
           fmt::format("a display of {} bytes is not read; the limit is {}", size, max_display_bytes)});
    } else if (const auto tokens = macros_.expand_display(sources_, display, parsed.diagnostics)) {
      if (const Token* brace = unbalanced_brace(*tokens)) {
        parsed.unread = true;
        parsed.diagnostics.push_back({DiagnosticKind::unbalanced, brace->span,
                                      brace->kind == TokenKind::begin_group
                                          ? "`{` is not closed in this display"
                                          : "`}` closes nothing"});
      } else if (expanded_tokens_ + tokens->size() > max_expanded_tokens) {
        parsed.unread = true;
        parsed.diagnostics.push_back({DiagnosticKind::display_too_long,
                                      display.span,
                                      "with this display the notes come to more than a million signs, macros "
                                      "written out: it is not read",
                                      {},
                                      {"shorten the macros, or check the chapters one by one"}});
      } else {
        expanded_tokens_ += tokens->size();
        add_quantity_words(*tokens, quantity_words_);
        expanded_.push_back({notes_.events.size(), *tokens, display.environment, display.cyclic});
      }
    } else {
      parsed.unread = true;
    }
    if (parsed.unread && size <= max_display_bytes)
      parsed.tags = tags_in(lex(sources_, display.body, display.quotes));
    notes_.events.emplace_back(std::move(parsed));
  }

  /// Behind the last display, for all of them tell which words stand for quantities.
  void parse_displays() {
    for (const ExpandedDisplay& display : expanded_) {
      auto& parsed = std::get<ParsedDisplay>(notes_.events[display.event]);
      parsed.chains = parse_chains(with_quantity_words(display.tokens, quantity_words_), display.environment,
                                   notes_.syntax, parsed.diagnostics);
      const bool images = display.cyclic && !parsed.chains.empty() && parsed.chains.back().image == 0;
      if (images) add_images(parsed.chains, notes_.syntax);
    }
    expanded_.clear();
  }

  void insert(const AddedStatement& added) {
    const auto place = added.at ? place_named(notes_, *added.at) : std::nullopt;
    const std::size_t behind = place ? place->behind : notes_.events.size();
    const Span all{added.text, 0, static_cast<std::uint32_t>(sources_.text(added.text).size())};
    add(Display{.span = all, .body = all, .environment = {}});
    parse_displays();
    const auto where = notes_.events.begin() + static_cast<std::ptrdiff_t>(behind);
    std::rotate(where, notes_.events.end() - 1, notes_.events.end());
  }

  /// What the prose says around the displays, with the relations in its lines read as far as syntax goes.
  void add_prose() {
    std::vector<ProseEvent> events;
    for (const Event& event : notes_.events) {
      ProseEvent seen{.span = rigor::span_of(event)};
      if (std::holds_alternative<ParsedDisplay>(event)) seen.kind = ProseEvent::Kind::display;
      if (const auto* heading = std::get_if<Heading>(&event)) {
        seen.kind = ProseEvent::Kind::heading;
        seen.level = heading->level;
      }
      events.push_back(seen);
    }
    notes_.prose = read_prose(sources_, events);
    for (SaidInLine& said : notes_.prose.said) {
      const auto tokens = maths_in_line(said.span);
      if (!tokens) continue;
      Diagnostics none;
      said.chains = parse_chains(*tokens, "", notes_.syntax, none);
      const auto parts = conditions_in(*tokens);  // `x, y > 0`
      if (parts && parts->size() > 1) said.chains = parse_each(*parts);
    }
    add_said_kinds();
    add_said_sizes();
    for (SaidInLine& said : notes_.prose.said) {
      for (const ParsedChain& chain : said.chains)
        said.letters.push_back(letters_written_in(notes_.syntax, chain.sides));
    }
  }

  std::optional<Tokens> maths_in_line(Span span) {
    Diagnostics none;
    auto tokens = expand(lex(sources_, span), macros_.table(), none);
    if (!tokens || unbalanced_brace(*tokens) != nullptr) return std::nullopt;
    return with_quantity_words(*std::move(tokens), quantity_words_);
  }

  std::vector<ParsedChain> parse_each(const std::vector<Tokens>& parts) {
    std::vector<ParsedChain> chains;
    Diagnostics none;
    for (const Tokens& part : parts) {
      for (ParsedChain& chain : parse_chains(part, "", notes_.syntax, none))
        chains.push_back(std::move(chain));
    }
    return chains;
  }

  /// "For an acute angle $\varphi$": adjectives as relations of the letters that they are at.
  void add_said_kinds() {
    for (const ProseSentence& sentence : notes_.prose.sentences) {
      if (sentence.asks) continue;
      for (const SaidKind& kind : said_kinds(sentence.text)) {
        if (kind.maths >= sentence.maths.size()) continue;
        const Span span = sentence.maths[kind.maths];
        const auto tokens = maths_in_line(span);
        if (!tokens) continue;
        for (const Tokens& letter : listed_letters(*tokens)) {
          for (const std::string_view relation : kind.relations) {
            if (relation == self_adjoint) {
              add_self_adjoint(sentence, letter);
            } else if (sentence.has_display) {
              add_said_kind(sentence, span, letter, relation);
            } else if (relation == "$ > 0") {
              add_size(sentence, letter, {});
            }
          }
        }
      }
    }
  }

  /// "of mass $m$", "$m$ is positive": that m is so, for those who ask.
  void add_said_sizes() {
    for (const ProseSentence& sentence : notes_.prose.sentences) {
      if (sentence.asks) continue;
      for (const SaidSize& size : said_sizes(sentence.text)) {
        if (size.maths >= sentence.maths.size()) continue;
        const auto tokens = maths_in_line(sentence.maths[size.maths]);
        if (!tokens) continue;
        for (const Tokens& letter : listed_letters(*tokens)) add_size(sentence, letter, size.noun);
      }
    }
  }

  void add_size(const ProseSentence& sentence, const Tokens& letter, std::string_view noun) {
    for (ParsedChain& chain : parse_each({about(letter, "$ > 0").first}))
      notes_.prose.sizes.push_back({std::move(chain), text_of(letter), sentence.place, std::string(noun)});
  }

  /// "the Hermitian operator $\hat A$"
  void add_self_adjoint(const ProseSentence& sentence, const Tokens& letter) {
    for (ParsedChain& chain : parse_each({about(letter, self_adjoint).first}))
      notes_.prose.self_adjoint.push_back({std::move(chain), text_of(letter), sentence.place});
  }

  void add_said_kind(const ProseSentence& sentence, Span span, const Tokens& letter,
                     std::string_view relation) {
    SaidInLine said{
        .span = span, .cue = Cue::condition, .sentence = sentence.number, .place = sentence.place};
    auto [tokens, words] = about(letter, relation);
    said.words = std::move(words);
    said.chains = parse_each({std::move(tokens)});
    notes_.prose.said.push_back(std::move(said));
  }

  /// `relation` with the letter for its `$`, and how it is written.
  static std::pair<Tokens, std::string> about(const Tokens& letter, std::string_view relation) {
    Tokens tokens;
    std::string words;
    const Span place = rigor::span_of(TokenView(letter));
    for (std::size_t at = 0; at < relation.size();) {
      std::size_t length = 1;
      if (relation[at] == '$') {
        tokens.insert(tokens.end(), letter.begin(), letter.end());
        words += text_of(letter);
      } else if (relation[at] == '\\') {
        while (at + length < relation.size() && is_letter(relation[at + length])) ++length;
        tokens.push_back({TokenKind::control, relation.substr(at + 1, length - 1), place});
        words += relation.substr(at, length);
      } else {
        const TokenKind kind = relation[at] == '0'   ? TokenKind::digit
                               : relation[at] == ' ' ? TokenKind::space
                                                     : TokenKind::other;
        tokens.push_back({kind, relation.substr(at, 1), place});
        words += relation[at];
      }
      at += length;
    }
    return {std::move(tokens), std::move(words)};
  }

  SyntaxId read_asked(FileId text) {
    const Span all{text, 0, static_cast<std::uint32_t>(sources_.text(text).size())};
    const auto opaque = [&](std::string reason) {
      return notes_.syntax.add_opaque(all, {DiagnosticKind::bad_syntax, std::move(reason), {}});
    };
    auto tokens = expand(lex(sources_, all), macros_.table(), diagnostics_);
    if (!tokens || tokens->empty()) return opaque("there is no expression");
    if (const Token* brace = unbalanced_brace(*tokens))
      return opaque(brace->kind == TokenKind::begin_group ? "`{` is not closed" : "`}` closes nothing");
    tokens = with_quantity_words(*std::move(tokens), quantity_words_);
    // As in a display, sizes of brackets and the like mean nothing.
    Diagnostics none;
    const std::vector<WrittenChain> chains = split_display(*tokens, "", none);
    const bool one_side = chains.size() == 1 && chains[0].sides.size() == 1 && !chains[0].condition;
    return parse_side(one_side ? TokenView(chains[0].sides[0].tokens) : TokenView(*tokens), all,
                      notes_.syntax);
  }

  std::optional<Directive> read(Span line) {
    auto directive = read_directive(sources_, line, macros_.table(), notes_.syntax, diagnostics_);
    if (!directive) directive = unread_assumption(line);
    if (directive) directive->number = notes_.directive_count++;
    return directive;
  }

  /// An assumption in which not even an equation could be read still says something about its letters.
  [[nodiscard]] std::optional<Directive> unread_assumption(Span line) const {
    Directive directive;
    directive.span = without_comment(sources_, line);
    directive.text = std::string(sources_.text(directive.span));
    directive.kind = directive.text.starts_with("where ") ? DirectiveKind::where : DirectiveKind::given;
    const bool assumes = directive.text.starts_with("given ") || directive.text.starts_with("where ");
    return assumes ? std::optional(std::move(directive)) : std::nullopt;
  }

  /// Each line goes before the event that its anchor names; lines of one anchor keep their order.
  void insert_sidecar(FileId sidecar) {
    std::map<std::size_t, std::vector<PlacedDirective>> before;
    for (const SidecarLine& line : read_sidecar(sources_, sidecar, diagnostics_)) {
      const auto event = place_of(line.anchor);
      if (!event) continue;
      auto directive = read(line.directive);
      if (!directive) continue;
      const bool at_end = *event >= notes_.events.size();
      const Span place = at_end ? Span{notes_.file, 0, 0} : rigor::span_of(notes_.events[*event]);
      before[*event].push_back({std::move(*directive), reported_at(line.anchor, place)});
    }
    std::vector<Event> events;
    for (std::size_t k = 0; k <= notes_.events.size(); ++k) {
      for (PlacedDirective& placed : before[k]) events.emplace_back(std::move(placed));
      if (k < notes_.events.size()) events.push_back(std::move(notes_.events[k]));
    }
    notes_.events = std::move(events);
  }

  /// `at line 57` reports at line 57, whatever is there; what holds from the start, at the start.
  Span reported_at(const Anchor& anchor, Span place) const {
    if (anchor.kind == AnchorKind::start) return {notes_.file, 0, 0};
    if (anchor.kind != AnchorKind::line) return place;
    const std::uint32_t begin = sources_.line_start(notes_.file, anchor.line);
    return {notes_.file, begin,
            begin + static_cast<std::uint32_t>(sources_.line_text(notes_.file, anchor.line).size())};
  }

  bool matches(const Event& event, const Anchor& anchor) const {
    if (const auto* heading = std::get_if<Heading>(&event))
      return anchor.kind == AnchorKind::section && heading->title == anchor.text;
    const auto* display = std::get_if<ParsedDisplay>(&event);
    if (display == nullptr || (anchor.kind != AnchorKind::tag && anchor.kind != AnchorKind::label))
      return false;
    return std::ranges::any_of(display->chains, [&](const ParsedChain& chain) {
      return (anchor.kind == AnchorKind::tag ? chain.written.tag : chain.written.label) == anchor.text;
    });
  }

  std::optional<std::size_t> place_of(const Anchor& anchor) {
    if (anchor.kind == AnchorKind::start) return 0;
    if (anchor.kind == AnchorKind::line) {
      if (anchor.line > sources_.line_count(notes_.file)) return unknown(anchor, {});
      const std::uint32_t begin = sources_.line_start(notes_.file, anchor.line);
      for (std::size_t k = 0; k < notes_.events.size(); ++k) {
        const Span span = rigor::span_of(notes_.events[k]);
        if (span.file == notes_.file && span.begin >= begin) return k;
      }
      return notes_.events.size();
    }
    std::vector<std::string> known;
    for (std::size_t k = 0; k < notes_.events.size(); ++k) {
      if (matches(notes_.events[k], anchor)) return anchor.kind == AnchorKind::section ? k + 1 : k;
      note_names(notes_.events[k], anchor.kind, known);
    }
    return unknown(anchor, known);
  }

  static void note_names(const Event& event, AnchorKind kind, std::vector<std::string>& names) {
    if (const auto* heading = std::get_if<Heading>(&event); heading != nullptr && kind == AnchorKind::section)
      names.push_back(heading->title);
    const auto* display = std::get_if<ParsedDisplay>(&event);
    if (display == nullptr || kind == AnchorKind::section) return;
    for (const ParsedChain& chain : display->chains)
      names.push_back(kind == AnchorKind::tag ? chain.written.tag : chain.written.label);
  }

  std::optional<std::size_t> unknown(const Anchor& anchor, const std::vector<std::string>& known) {
    if (!reported_.insert(anchor.span.begin).second) return std::nullopt;
    Diagnostic diagnostic{DiagnosticKind::unknown_anchor, anchor.span,
                          fmt::format("`{}` is nowhere in the notes", sources_.text(anchor.span))};
    if (const auto near = suggest(anchor.text, known))
      diagnostic.help = {fmt::format("did you mean `{}`?", *near)};
    diagnostics_.push_back(std::move(diagnostic));
    return std::nullopt;
  }

  /// A display whose macros are replaced.
  struct ExpandedDisplay {
    std::size_t event;
    Tokens tokens;
    std::string environment;
    bool cyclic;
  };

  SourceMap& sources_;
  Diagnostics& diagnostics_;
  Notes notes_;
  std::vector<ExpandedDisplay> expanded_;
  std::size_t expanded_tokens_ = 0;  // of all displays
  std::set<std::string> quantity_words_;
  ScopedMacros macros_;
  std::set<std::uint32_t> reported_;
};

}  // namespace

Notes read_notes(SourceMap& sources, FileId file, const FileId* sidecar, Diagnostics& diagnostics,
                 std::span<const FileId> asked, const AddedStatement* added) {
  return CheckedNotesReader(sources, file, diagnostics).read(sidecar, asked, added);
}

Span span_of(const Event& event) {
  if (const auto* heading = std::get_if<Heading>(&event)) return heading->span;
  if (const auto* placed = std::get_if<PlacedDirective>(&event)) return placed->place;
  return std::get<ParsedDisplay>(event).span;
}

std::vector<std::string> headings_at(const Notes& notes, std::size_t event) {
  std::vector<const Heading*> open;
  for (std::size_t k = 0; k <= event && k < notes.events.size(); ++k) {
    const auto* heading = std::get_if<Heading>(&notes.events[k]);
    if (heading == nullptr) continue;
    std::erase_if(open, [&](const Heading* each) { return each->level >= heading->level; });
    open.push_back(heading);
  }
  std::vector<std::string> titles;
  for (const Heading* heading : open) titles.push_back(heading->title);
  return titles;
}

}  // namespace rigor
