// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/markdown/markdown_blocks.h"

#include <cmark-gfm.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>

namespace rigor {
namespace {

struct FreeNode {
  void operator()(cmark_node* node) const { cmark_node_free(node); }
};
struct FreeIterator {
  void operator()(cmark_iter* iterator) const { cmark_iter_free(iterator); }
};

std::size_t line_of(int line) { return line > 0 ? static_cast<std::size_t>(line) - 1 : 0; }

std::optional<MarkdownBlock> leaf(cmark_node* node) {
  MarkdownBlock block;
  const cmark_node_type type = cmark_node_get_type(node);
  if (type == CMARK_NODE_PARAGRAPH) {
    block.kind = MarkdownBlock::Kind::text;
  } else if (type == CMARK_NODE_HEADING) {
    block.kind = MarkdownBlock::Kind::heading;
    block.level = cmark_node_get_heading_level(node);
  } else if (type == CMARK_NODE_HTML_BLOCK) {
    block.kind = MarkdownBlock::Kind::html;
  } else if (type == CMARK_NODE_CODE_BLOCK) {
    int length = 0;
    int offset = 0;
    char mark = 0;
    block.kind = MarkdownBlock::Kind::code;
    block.fenced = cmark_node_get_fenced(node, &length, &offset, &mark) != 0;
  } else {
    return std::nullopt;
  }
  block.first = line_of(cmark_node_get_start_line(node));
  block.last = std::max(block.first, line_of(cmark_node_get_end_line(node)));
  return block;
}

/// cmark lets a title above a line of `=` or `-` end where the next block begins.
std::size_t last_line_of_heading(const MarkdownBlock& heading, const std::vector<std::string_view>& lines) {
  const char mark = heading.level == 1 ? '=' : '-';
  for (std::size_t k = heading.first + 1; k <= heading.last && k < lines.size(); ++k) {
    const std::string_view line = lines[k];
    const std::size_t begin = line.find(mark);
    const std::size_t end = line.find_last_of(mark);
    if (begin <= 3 && line.find_first_not_of(mark, begin) > end && line.find_first_not_of(" \t\r") == begin &&
        line.find_first_not_of(" \t\r", end + 1) == line.npos)
      return k;
  }
  return heading.last;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return lines;
}

}  // namespace

std::vector<MarkdownBlock> markdown_blocks(const std::string& text) {
  const std::unique_ptr<cmark_node, FreeNode> document(
      cmark_parse_document(text.data(), text.size(), CMARK_OPT_DEFAULT));
  const std::unique_ptr<cmark_iter, FreeIterator> iterator(cmark_iter_new(document.get()));
  const std::vector<std::string_view> lines = lines_of(text);
  std::vector<MarkdownBlock> blocks;
  std::uint32_t quotes = 0;
  std::size_t quote_last = 0;
  for (cmark_event_type event; (event = cmark_iter_next(iterator.get())) != CMARK_EVENT_DONE;) {
    cmark_node* const node = cmark_iter_get_node(iterator.get());
    if (cmark_node_get_type(node) == CMARK_NODE_BLOCK_QUOTE) {
      if (event == CMARK_EVENT_ENTER && quotes++ == 0) quote_last = line_of(cmark_node_get_end_line(node));
      if (event == CMARK_EVENT_EXIT) --quotes;
    } else if (event == CMARK_EVENT_ENTER) {
      auto block = leaf(node);
      if (!block) continue;
      if (block->kind == MarkdownBlock::Kind::heading) block->last = last_line_of_heading(*block, lines);
      block->quotes = quotes;
      block->quote_last = quote_last;
      blocks.push_back(*block);
    }
  }
  return blocks;
}

}  // namespace rigor
