// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "base/ascii.h"
#include "latex/document/document_reader.h"
#include "latex/markdown/markdown_dialects.h"
#include "latex/markdown/markdown_fences.h"
#include "latex/markdown/math_macros.h"

namespace rigor {
namespace {

/// Searches for a closing mark that end in nothing, before they are given up.
constexpr int failures_searched = 8;
/// Readings of the blocks and the displays, each with what the other found.
constexpr int most_passes = 6;

/// What is known of a text before its displays are looked for.
struct MarkdownText {
  const LineStarts& lines;
  const std::vector<MarkdownBlock>& blocks;
  const std::set<std::size_t>& open_fences;
};

class MarkdownReader : NotesReader {
 public:
  MarkdownReader(DocumentReading& reading, FileId file, const MarkdownText& known)
      : NotesReader(reading, file, Format::markdown), known_(known) {}

  /// What the front matter defines: MyST's `math:`, and definitions as LaTeX has them, for `header-includes`.
  void read_front_matter(std::size_t end) {
    add_macros(text_.span(0, end), macros_of_front_matter(text_.between(0, end)));
    for (at_ = 0; at_ < end;) {
      const std::string_view word = text_[at_] == '\\' ? text_.control_word(at_) : std::string_view();
      const auto form = definition_form(word);
      const auto extent = form ? definition_extent(text_, *form, at_ + 1 + word.size()) : DefinitionExtent{};
      if (extent.open) break;  // it is not closed before the end of the file, and neither is another one
      const bool whole = form && extent.end <= end && !extent.name.empty();
      if (whole) add(MacroText{text_.span(at_, extent.end), false, true});
      if (whole) {
        at_ = extent.end;
      } else {
        at_ += text_[at_] == '\\' ? 2 : 1;
      }
    }
  }

  void read() {
    auto open_fence = known_.open_fences.begin();
    for (const MarkdownBlock& block : known_.blocks) {
      for (; open_fence != known_.open_fences.end() && *open_fence <= block.first; ++open_fence)
        report_open_fence(*open_fence);
      end_ = known_.lines[block.last + 1];
      if (end_ <= at_ || !goes_on()) continue;
      at_ = std::max(at_, known_.lines[block.first]);
      limit_ = block.quotes > 0 ? known_.lines[block.quote_last + 1] : text_.size();
      quotes_ = block.quotes;
      open_code_spans_ = 0;
      read_block(block);
    }
    for (; open_fence != known_.open_fences.end(); ++open_fence) report_open_fence(*open_fence);
  }

 private:
  void read_block(const MarkdownBlock& block) {
    const bool whole = at_ == known_.lines[block.first];
    line_ = line_start(text_, at_);
    if (block.kind == MarkdownBlock::Kind::code) {
      if (block.fenced && whole) read_fence(block);
      at_ = std::max(at_, end_);
    } else if (block.kind == MarkdownBlock::Kind::heading && whole && !line_.marked &&
               !opens_display(text_.between(at_, end_))) {
      read_heading(block);
    } else {
      read_text();
    }
  }

  /// `## Title`, or a title above a line of `=` or `-`.
  void read_heading(const MarkdownBlock& block) {
    const Span title =
        block.first == block.last ? atx_title(text_, at_) : text_.trimmed(at_, known_.lines[block.last]);
    const Span whole = text_.trimmed(at_, end_);
    std::string words(text_.between(title.begin, title.end));
    std::ranges::replace(words, '\n', ' ');
    add(Heading{text_.span(at_, whole.end), block.level, std::move(words)});
    at_ = end_;
  }

  /// To the end of the block, or of what reaches beyond it.
  void read_text() {
    while (goes_on() && at_ < end_) {
      if (at_ == 0 || text_[at_ - 1] == '\n') {
        line_ = line_start(text_, at_);
        if (read_colon_display()) continue;
      }
      read_sign();
    }
  }

  void read_sign() {
    switch (text_[at_]) {
      case '\\':
        return read_backslash();
      case '$':
        return read_dollar();
      case '`':
        return read_code_span();
      case '<':
        return read_angle();
      case '%':
        return read_percent();
      default:
        ++at_;
    }
  }

  void read_text_display(DisplayDelimiter delimiter, std::size_t length) {
    read_display({delimiter, at_, at_ + length, {}, quotes_, nullptr, limit_});
  }

  /// Markdown writes `\[` for a plain bracket: inside a line that is what is there, unless it is closed.
  void read_bracket(DisplayDelimiter delimiter, std::size_t length) {
    if (at_ == line_.at) return read_text_display(delimiter, length);
    std::size_t& not_before = no_bracket_before_[delimiter == DisplayDelimiter::bracket ? 0 : 1];
    if (at_ >= not_before) {
      const auto end = read_closed_display({delimiter, at_, at_ + length, {}, quotes_, nullptr, limit_});
      if (end.outcome == DisplayEnd::Outcome::closed) return;
      not_before = end.begin;
    }
    at_ += length;
  }

  void read_backslash() {
    const std::string_view word = text_.control_word(at_);
    if (!word.empty()) {
      if (!read_environment(word, quotes_, limit_) && !read_definition(word)) at_ += 1 + word.size();
    } else if (text_.has("\\\\[", at_)) {
      read_bracket(DisplayDelimiter::double_bracket, 3);
    } else if (text_.has("\\[", at_)) {
      read_bracket(DisplayDelimiter::bracket, 2);
    } else if (text_.has("\\\\(", at_)) {
      read_parenthesis(3, "\\\\)");
    } else if (text_.has("\\(", at_)) {
      read_parenthesis(2, "\\)");
    } else {
      at_ = std::min(at_ + (text_[at_ + 1] == '\n' ? 1 : 2), text_.size());
    }
  }

  /// Inline mathematics, or a plain parenthesis where it is not closed.
  void read_parenthesis(std::size_t length, std::string_view closing) {
    const std::size_t begin = at_ + length;
    at_ = begin;
    const std::size_t end = end_;
    if (begin < no_parenthesis_before_ || begin > end) return;
    const auto close = text_.between(begin, end).find(closing);
    if (close == std::string_view::npos) {
      no_parenthesis_before_ = end;
    } else {
      pass_inline(begin, begin + close, closing.size());
    }
  }

  void read_dollar() {
    if (text_[at_ + 1] == '$') return read_text_display(DisplayDelimiter::dollars, 2);
    const std::size_t begin = at_ + 1;
    at_ = begin;
    if (text_[begin] == '`') return read_dollar_code(begin + 1);
    if (begin < no_dollar_before_ || begin >= text_.size() || is_white(text_[begin])) return;
    std::size_t at = begin;
    for (; at < end_; ++at) {
      if (text_[at] == '\\') ++at;
      if (text_[at] != '$') continue;
      const bool after_blank = is_white(text_[at - 1]);
      if (after_blank && text_[at + 1] == '$') break;
      if (!after_blank && !is_digit(text_[at + 1])) return pass_inline(begin, at, 1);
    }
    no_dollar_before_ = at;
  }

  /// GitHub's inline mathematics, `` $`…`$ ``.
  void read_dollar_code(std::size_t begin) {
    const auto close = text_.between(begin, std::max(begin, end_)).find("`$");
    if (close != std::string_view::npos) pass_inline(begin, begin + close, 2);
  }

  /// Obsidian's comments: `%% … %%`, in a line or from the start of one over any number of lines.
  void read_percent() {
    const std::size_t begin = at_++;
    const bool opens = text_[at_] == '%' && (begin == line_.at || is_blank(text_[begin - 1]));
    if (!opens || begin < no_comment_before_) return;
    const std::size_t until = begin == line_.at ? text_.size() : end_;
    const auto close = text_.between(begin + 2, std::max(begin + 2, until)).find("%%");
    if (close != std::string_view::npos) {
      at_ = begin + 2 + close + 2;
    } else {
      no_comment_before_ = until;
    }
  }

  /// Stands after inline mathematics. Only definitions count in it: notes that KaTeX shows begin with
  /// `$\newcommand…$`.
  void pass_inline(std::size_t begin, std::size_t end, std::size_t closing_length) {
    for (at_ = begin; at_ < end;) {
      if (text_[at_] != '\\') {
        ++at_;
        continue;
      }
      const std::string_view word = text_.control_word(at_);
      if (!word.empty() && read_definition(word)) continue;
      at_ += std::max<std::size_t>(word.size(), 1) + 1;
    }
    at_ = std::max(at_, end + closing_length);
  }

  /// `` `…` ``, closed by as many marks as opened it; else the marks are text.
  void read_code_span() {
    const std::size_t begin = at_;
    while (text_[at_] == '`') ++at_;
    const std::size_t marks = at_ - begin;
    const std::size_t end = end_;
    if (open_code_spans_ == failures_searched) return;
    for (std::size_t at = at_; at < end; ++at) {
      if (text_[at] != '`') continue;
      std::size_t behind = at;
      while (text_[behind] == '`') ++behind;
      if (behind - at == marks) {
        at_ = behind;
        return;
      }
      at = behind;
    }
    ++open_code_spans_;
  }

  void read_angle() {
    if (text_.has("<!--", at_)) return read_comment();
    const std::string_view name = raw_element_at(text_, at_);
    if (!name.empty()) return read_element(name);
    ++at_;
  }

  /// `<pre> … </pre>`: nothing inside is a display. `<code>` is closed in its paragraph, or is text.
  void read_element(std::string_view name) {
    const std::size_t begin = at_;
    const bool inside_line = name == "code";
    const std::string closing = fmt::format("</{}", name);
    const std::size_t until = inside_line ? end_ : text_.size();
    const bool searched = endless_.contains(closing);
    const auto close = searched ? std::string_view::npos : find_element_end(text_, closing, begin, until);
    if (close != std::string_view::npos) {
      at_ = close + closing.size();
      if (name == "script") add_macros(text_.span(begin, at_), macros_of_script(text_.between(begin, close)));
    } else if (inside_line) {
      ++at_;
    } else {
      endless_.insert(closing);
      report(begin, begin + 1 + name.size(), fmt::format("`<{}` is not closed", name),
             fmt::format("close the element with `{}>`", closing));
      at_ = text_.after_blank_line(begin);
    }
  }

  void add_macros(Span place, const std::vector<MathMacro>& macros) {
    for (const MathMacro& macro : macros)
      add(MacroText{place, false, true, reading_.sources.keep(definition_of(macro))});
  }

  void read_comment() {
    const std::string_view opening = "<!--";
    const std::string_view closing = "-->";
    const std::size_t begin = at_ + opening.size();
    const std::size_t end = endless_.contains(closing) ? text_.size() : text_.find(closing, begin);
    if (end < text_.size()) {
      add_comment_directives(begin, end);
      at_ = end + closing.size();
    } else {
      endless_.emplace(closing);
      report(at_, begin, "`<!--` is not closed", "close the comment with `-->`");
      at_ = text_.after_blank_line(at_);
    }
  }

  /// `<!-- rigor: … -->`: each line that is not empty.
  void add_comment_directives(std::size_t begin, std::size_t end) {
    constexpr std::string_view word = "rigor:";
    begin = text_.trimmed(begin, end).begin;
    if (!text_.has(word, begin)) return;
    for (std::size_t line = begin + word.size(); line < end;) {
      const std::size_t line_end = line + std::min(text_.between(line, end).find('\n'), end - line);
      const bool quoted = line_.quotes > 0 && text_[line - 1] == '\n';
      const std::size_t from = quoted ? std::min(line_start(text_, line).at, line_end) : line;
      const Span directive = text_.trimmed(from, line_end);
      if (!directive.empty()) add(DirectiveLine{directive});
      line = line_end + 1;
    }
  }

  void report_open_fence(std::size_t line) {
    const auto fence = fence_at(text_, line_start(text_, known_.lines[line]).at);
    if (!fence) return;
    const std::string_view marks = text_.between(fence->begin, fence->begin + fence->marks);
    report(fence->begin, text_.trimmed(fence->begin, text_.line_end(fence->begin)).end,
           "a fenced block is not closed", fmt::format("close it with a line `{}`", marks));
  }

  void read_fence(const MarkdownBlock& block) {
    const auto fence = fence_at(text_, line_.at);
    const std::size_t last = known_.lines[block.last];
    if (!fence) return;
    if (!closes_fence(text_, *fence, last)) return report_open_fence(block.first);
    const std::size_t words = fence->begin + fence->marks;
    const std::size_t first = text_.next_line(words);
    if (content_of_fence(text_.between(words, text_.line_end(words))) == FenceContent::math) {
      add_fenced_display(fence->begin, words, last);
    } else if (text_.between(first, std::max(first, last)).find(".. math::") != std::string_view::npos &&
               text_.between(words, text_.line_end(words)).find("{eval-rst}") != std::string_view::npos) {
      report_unread(text_.span(fence->begin, text_.line_end(words)),
                    "displays of reStructuredText are not read", "write them as a fence `{math}`");
    }
  }

  /// `:::{math}` … `:::`, for which CommonMark has no block.
  bool read_colon_display() {
    const auto mark = colon_mark_at(text_, line_.at);
    if (!mark || mark->closes) return false;
    if (content_of_colons(text_.between(mark->words, text_.line_end(mark->words))) != FenceContent::math)
      return false;
    const auto last = find_colon_end(text_, text_.next_line(mark->words), mark->colons, limit_);
    if (!last) {
      report(line_.at, text_.line_end(line_.at), "a fenced block is not closed",
             fmt::format("close it with a line `{}`", text_.between(line_.at, line_.at + mark->colons)));
      at_ = text_.after_blank_line(at_);
      return true;
    }
    add_fenced_display(line_.at, mark->words, *last);
    at_ = text_.next_line(*last);
    return true;
  }

  /// From the fence at `begin`, whose words begin at `words`, to its last line.
  void add_fenced_display(std::size_t begin, std::size_t words, std::size_t last) {
    const std::size_t line_end = text_.line_end(words);
    std::size_t body = text_.next_line(words);
    const auto brace = text_.between(words, line_end).find('}');
    if (brace !=
        std::string_view::npos) {  // a directive, with its content on the first line or below its options
      const Span beside = text_.trimmed(words + brace + 1, line_end);
      body = beside.empty() ? behind_options(text_, body, last) : beside.begin;
    }
    add_directives(body, last);
    if (body >= last || text_.trimmed(body, last).empty()) return;
    const bool cyclic = text_.goes_on_cyclically(text_.line_end(last));
    const Span whole = text_.trimmed(begin, text_.line_end(last));
    add(Display{whole, text_.span(body, last), {}, quotes_, cyclic});
  }

  const MarkdownText& known_;
  LineStart line_;                                  // of the line that is being read
  std::size_t end_ = 0;                             // of the block that is being read
  std::size_t limit_ = 0;                           // of the quotation around it
  std::uint32_t quotes_ = 0;                        // how many there are
  std::size_t no_dollar_before_ = 0;                // nothing up to there closes inline mathematics
  std::size_t no_parenthesis_before_ = 0;           // the same for `\)`
  std::size_t no_comment_before_ = 0;               // the same for `%%`
  std::array<std::size_t, 2> no_bracket_before_{};  // the same for `\]` and `\\]`
  int open_code_spans_ = 0;                         // in this block
  std::set<std::string, std::less<>> endless_;      // closings that do not come any more
};

/// The lines of displays that would be something else without them. A fence is code to CommonMark, as it
/// should.
std::set<std::size_t> lines_of_displays(const NotesText& text, const Document& document,
                                        const LineStarts& lines, const MarkdownShape& shape) {
  std::set<std::size_t> covered;
  for (const Item& item : document.items) {
    const auto* const display = std::get_if<Display>(&item);
    if (display == nullptr || text[display->span.begin] == '`' || text[display->span.begin] == '~') continue;
    const std::size_t first = lines.line_at(display->span.begin) + 1;
    const std::size_t last = lines.line_at(display->span.end - 1);
    bool matter = false;
    for (std::size_t line = first; line <= last; ++line) matter = matter || shape.could_matter(line);
    for (std::size_t line = first; matter && line <= last; ++line) covered.insert(line);
  }
  return covered;
}

}  // namespace

/// The blocks say where displays can be, and displays say where there are no blocks: until both agree.
void read_markdown(DocumentReading& reading, FileId file) {
  const NotesText text(reading.sources, file, Format::markdown);
  const LineStarts lines(text);
  MarkdownShape shape(text.between(0, text.size()));
  const std::size_t front_matter = front_matter_end(text);
  for (std::size_t line = 0; lines[line] < front_matter; ++line) shape.blank(line);
  std::set<std::size_t> open_fences;
  const std::vector<MarkdownBlock> none;
  MarkdownReader(reading, file, {lines, none, open_fences}).read_front_matter(front_matter);
  for (int pass = 1;; ++pass) {
    const std::vector<MarkdownBlock> blocks = blocks_of_dialects(text, lines, shape, open_fences);
    Diagnostics diagnostics;
    DocumentReading trial{reading.sources, diagnostics};
    MarkdownReader(trial, file, {lines, blocks, open_fences}).read();
    if (pass < most_passes && shape.cover(lines_of_displays(text, trial.document, lines, shape))) continue;
    reading.document.items.insert(reading.document.items.end(),
                                  std::make_move_iterator(trial.document.items.begin()),
                                  std::make_move_iterator(trial.document.items.end()));
    reading.diagnostics.insert(reading.diagnostics.end(), diagnostics.begin(), diagnostics.end());
    return;
  }
}

}  // namespace rigor
