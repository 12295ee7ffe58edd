// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/markdown/markdown_dialects.h"

#include "latex/markdown/markdown_fences.h"

namespace rigor {
namespace {

/// Containers inside containers: each shows when the one around it is gone.
constexpr int most_nested = 24;

class DialectMarks {
 public:
  DialectMarks(const NotesText& text, const LineStarts& lines, MarkdownShape& shape,
               std::set<std::size_t>& open_fences)
      : text_(text), lines_(lines), shape_(shape), open_fences_(open_fences) {}

  bool take_from(const std::vector<MarkdownBlock>& blocks) {
    changed_ = false;
    for (const MarkdownBlock& block : blocks) {
      if (block.kind == MarkdownBlock::Kind::code) {
        if (block.fenced && !shape_.is_covered(block.first)) take_fence(block);
      } else {
        take_lines(block);
      }
    }
    return changed_;
  }

 private:
  void blank(std::size_t line) {
    if (shape_.blank(line)) changed_ = true;
  }

  void take_fence(const MarkdownBlock& block) {
    const auto fence = fence_at(text_, line_start(text_, lines_[block.first]).at);
    if (!fence) return;
    if (!closes_fence(text_, *fence, lines_[block.last])) {
      open_fences_.insert(block.first);
      return blank(block.first);
    }
    const std::size_t words = fence->begin + fence->marks;
    if (content_of_fence(text_.between(words, text_.line_end(words))) != FenceContent::markdown) return;
    blank(block.first);
    blank_options(block.first + 1, lines_[block.last]);
    // A fence inside ends with the one around it, at the latest: its last line closes both.
    if (!ends_inside_a_fence(block)) blank(block.last);
  }

  [[nodiscard]] bool ends_inside_a_fence(const MarkdownBlock& block) const {
    std::optional<Fence> open;
    for (std::size_t line = block.first + 1; line < block.last; ++line) {
      if (open && closes_fence(text_, *open, lines_[line])) {
        open.reset();
      } else if (!open && !shape_.is_covered(line)) {
        open = fence_at(text_, line_start(text_, lines_[line]).at);
      }
    }
    return open.has_value();
  }

  void blank_options(std::size_t line, std::size_t end) {
    for (const std::size_t behind = behind_options(text_, lines_[line], end); lines_[line] < behind; ++line)
      blank(line);
  }

  void take_lines(const MarkdownBlock& block) {
    for (std::size_t line = block.first; line <= block.last; ++line) {
      if (shape_.is_covered(line)) continue;
      const std::size_t at = line_start(text_, lines_[line]).at;
      if (const auto colons = colon_mark_at(text_, at)) {
        line = take_colons(line, *colons);
      } else if (begins_indented_content(text_, at) && shape_.make_item(line)) {
        changed_ = true;
      }
    }
  }

  /// The last line that is done with.
  std::size_t take_colons(std::size_t line, const ColonMark& mark) {
    const std::string_view words = text_.between(mark.words, text_.line_end(mark.words));
    const FenceContent content = mark.closes ? FenceContent::markdown : content_of_colons(words);
    if (content == FenceContent::markdown) {
      blank(line);
      if (!mark.closes) blank_options(line + 1, text_.size());
      return line;
    }
    const auto end = find_colon_end(text_, lines_[line + 1], mark.colons, text_.size());
    if (content == FenceContent::math) return end ? lines_.line_at(*end) : line;
    const std::size_t last = end ? lines_.line_at(*end) : line;
    for (; line <= last; ++line) blank(line);
    return last;
  }

  const NotesText& text_;
  const LineStarts& lines_;
  MarkdownShape& shape_;
  std::set<std::size_t>& open_fences_;
  bool changed_ = false;
};

}  // namespace

std::vector<MarkdownBlock> blocks_of_dialects(const NotesText& text, const LineStarts& lines,
                                              MarkdownShape& shape, std::set<std::size_t>& open_fences) {
  std::vector<MarkdownBlock> blocks = markdown_blocks(shape.text());
  DialectMarks marks(text, lines, shape, open_fences);
  for (int pass = 1; pass < most_nested && marks.take_from(blocks); ++pass)
    blocks = markdown_blocks(shape.text());
  return blocks;
}

}  // namespace rigor
