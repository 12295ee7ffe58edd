// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/markdown_blocks.h"

#include <cmark-gfm.h>

#include <algorithm>
#include <memory>
#include <optional>

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

}  // namespace

std::vector<MarkdownBlock> markdown_blocks(const std::string& text) {
  const std::unique_ptr<cmark_node, FreeNode> document(
      cmark_parse_document(text.data(), text.size(), CMARK_OPT_DEFAULT));
  const std::unique_ptr<cmark_iter, FreeIterator> iterator(cmark_iter_new(document.get()));
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
      block->quotes = quotes;
      block->quote_last = quote_last;
      blocks.push_back(*block);
    }
  }
  return blocks;
}

}  // namespace rigor
