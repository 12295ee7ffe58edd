// SPDX-License-Identifier: GPL-3.0-or-later
// Environments: rows and cells.
#include "latex/layout/layout_reader.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

struct TableShape {
  TableAlignment alignment = TableAlignment::centre;
  std::string_view open = {};
  std::string_view close = {};
  bool takes_argument = false;  // `{rcl}`, `{2}`
};

std::optional<TableShape> shape_of(std::string_view name) {
  using enum TableAlignment;
  static const WordMap<TableShape> shapes{{"matrix smallmatrix gather gathered", {}},
                                          {"pmatrix", {centre, "(", ")"}},
                                          {"bmatrix", {centre, "[", "]"}},
                                          {"Bmatrix", {centre, "{", "}"}},
                                          {"vmatrix", {centre, "|", "|"}},
                                          {"Vmatrix", {centre, "‖", "‖"}},
                                          {"array subarray", {centre, {}, {}, true}},
                                          {"cases dcases", {left, "{", {}}},
                                          {"rcases", {left, {}, "}"}},
                                          {"aligned align split flalign", {pairs}},
                                          {"alignedat alignat", {pairs, {}, {}, true}},
                                          {"eqnarray", {equations}},
                                          {"lgathered", {left}},
                                          {"multline multlined", {staggered}}};
  if (name.ends_with('*')) name.remove_suffix(1);
  return shapes.find(name);
}

/// Depth of braces and environments: `&` and `\\` divide a table only at 0.
class TableNesting {
 public:
  bool outside(const Token& token) {
    if (token.kind == TokenKind::end_group || is_control(token, "end")) depth_ -= depth_ > 0 ? 1 : 0;
    const bool is_outside = depth_ == 0;
    if (token.kind == TokenKind::begin_group || is_control(token, "begin")) ++depth_;
    return is_outside;
  }

 private:
  int depth_ = 0;
};

bool ends_row(const Token& token) { return is_control_of(token, {"\\", "cr", "newline", "tabularnewline"}); }

/// After `\\`, `\\*`, `\\[2pt]`.
std::size_t behind_row_end(TokenView tokens, std::size_t at) {
  if (is_sign_at(tokens, at, "*")) ++at;
  const Argument length = optional_argument_at(tokens, at);
  return is_length(length.content) ? length.next : at;
}

bool has_rows(TokenView tokens) {
  TableNesting nesting;
  for (const Token& token : tokens) {
    if (nesting.outside(token) && (token.kind == TokenKind::align || ends_row(token))) return true;
  }
  return false;
}

}  // namespace

Box LayoutReader::table(TokenView tokens, TableAlignment alignment, LayoutContext context) {
  Box box{.kind = BoxKind::table};
  box.alignment = alignment;
  TableNesting nesting;
  std::string tag;
  std::size_t begin = 0;
  bool filled = false;  // something is in the row
  const auto finish_cell = [&](std::size_t end) {
    LayoutReader reader(tokens.subspan(begin, end - begin), {context.depth + 1, context.face});
    box.parts.push_back(reader.read());
    filled = filled || !is_empty(box.parts.back());
    if (!reader.tag().empty()) tag = reader.tag();
  };
  const auto finish_row = [&] {
    const std::size_t before = box.row_ends.empty() ? 0 : box.row_ends.back();
    if (filled) {
      box.row_ends.push_back(box.parts.size());
      box.tags.push_back(tag);
    } else {
      box.parts.resize(before);
      if (!tag.empty() && !box.tags.empty()) box.tags.back() = tag;
    }
    tag.clear();
    filled = false;
  };
  for (std::size_t at = 0; at < tokens.size();) {
    const bool outside = nesting.outside(tokens[at]);
    if (outside && tokens[at].kind == TokenKind::align) {
      finish_cell(at);
      begin = ++at;
    } else if (outside && ends_row(tokens[at])) {
      finish_cell(at);
      finish_row();
      begin = at = behind_row_end(tokens, at + 1);
    } else {
      ++at;
    }
  }
  finish_cell(tokens.size());
  finish_row();
  return box;
}

void LayoutReader::environment() {
  const std::string name = text_of(take_argument());
  const auto shape = shape_of(name);
  if (name == "array" || name == "aligned" || name == "gathered") static_cast<void>(take_optional());
  if (shape && shape->takes_argument) static_cast<void>(take_argument());
  int open = 1;
  std::size_t end = at_;
  for (; end < tokens_.size(); ++end) {
    if (is_control(tokens_[end], "begin")) ++open;
    if (is_control(tokens_[end], "end") && --open == 0) break;
  }
  const TokenView body = tokens_.subspan(at_, end - at_);
  at_ = end < tokens_.size() ? argument_at(tokens_, end + 1).next : end;
  const LayoutContext deeper{context_.depth + 1, context_.face};
  if (!shape && !has_rows(body)) {
    LayoutReader reader(body, deeper);
    push(reader.read());
    if (!reader.tag().empty()) tag_ = reader.tag();
    return;
  }
  const TableShape used = shape.value_or(TableShape{});
  if (context_.depth > 60) return push(words_box(text_of(body)));
  Box cells = table(body, used.alignment, deeper);
  if (used.open.empty() && used.close.empty()) return push(std::move(cells));
  push(fence_box(used.open, std::move(cells), used.close));
}

ShownDisplay layout_of_display(TokenView tokens, std::string_view environment) {
  if (has_rows(tokens)) {
    const auto shape = shape_of(environment);
    const TableAlignment alignment = shape ? shape->alignment : TableAlignment::pairs;
    Box box = LayoutReader::table(tokens, alignment, {});
    if (box.row_ends.size() != 1) return {std::move(box), {}};
    std::string tag = std::move(box.tags.front());
    box.tags.front().clear();
    return {std::move(box), std::move(tag)};
  }
  LayoutReader reader(tokens, {});
  Box box = reader.read();
  return {std::move(box), reader.tag()};
}

}  // namespace rigor
