// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/syntax.h"

#include <algorithm>

#include "base/check.h"

namespace rigor {
namespace {

template <class T>
std::uint32_t append(std::vector<T>& list, T value) {
  list.push_back(std::move(value));
  return static_cast<std::uint32_t>(list.size() - 1);
}

}  // namespace

SyntaxId SyntaxTree::add(SyntaxKind kind, Span span, std::span<const SyntaxChild> children,
                         std::uint32_t payload) {
  for (const SyntaxChild& child : children) {
    RIGOR_CHECK(static_cast<std::size_t>(child.id) < nodes_.size(), static_cast<std::size_t>(child.id));
  }
  SyntaxNode node{kind, span};
  node.first = static_cast<std::uint32_t>(children_.size());
  node.count = static_cast<std::uint32_t>(children.size());
  node.payload = payload;
  children_.insert(children_.end(), children.begin(), children.end());
  return SyntaxId{append(nodes_, node)};
}

SyntaxId SyntaxTree::add_symbol(Span span, WrittenSymbol symbol) {
  return add(SyntaxKind::symbol, span, {}, append(symbols_, std::move(symbol)));
}

SyntaxId SyntaxTree::add_component(Span span, SyntaxId base, std::vector<WrittenIndex> indices) {
  const SyntaxChild child{base};
  return add(SyntaxKind::component, span, {&child, 1}, append(index_lists_, std::move(indices)));
}

SyntaxId SyntaxTree::add_big_sum(Span span, WrittenSum sum, std::span<const SyntaxChild> body_and_limits) {
  return add(SyntaxKind::big_sum, span, body_and_limits, append(sums_, std::move(sum)));
}

SyntaxId SyntaxTree::add_big_sum(Span span, WrittenSum sum, SyntaxId body) {
  const SyntaxChild child{body};
  return add(SyntaxKind::big_sum, span, {&child, 1}, append(sums_, std::move(sum)));
}

SyntaxId SyntaxTree::add_derivative(Span span, WrittenDerivative derivative, SyntaxId operand) {
  const SyntaxChild child{operand};
  return add(SyntaxKind::derivative, span, {&child, 1}, append(derivatives_, std::move(derivative)));
}

SyntaxId SyntaxTree::add_named(SyntaxKind kind, Span span, std::string name, SyntaxId child) {
  const SyntaxChild only{child};
  return add(kind, span, {&only, 1}, append(texts_, std::move(name)));
}

SyntaxId SyntaxTree::add_integral(Span span, std::string measure, SyntaxId body, const std::string& region) {
  std::vector<SyntaxChild> children{{body}};
  if (!region.empty()) children.push_back({add_text(SyntaxKind::text, span, region)});
  return add(SyntaxKind::integral, span, children, append(texts_, std::move(measure)));
}

SyntaxId SyntaxTree::add_text(SyntaxKind kind, Span span, std::string text) {
  return add(kind, span, {}, append(texts_, std::move(text)));
}

SyntaxId SyntaxTree::add_opaque(Span span, Obstacle obstacle) {
  return add(SyntaxKind::opaque, span, {}, append(obstacles_, std::move(obstacle)));
}

std::span<const SyntaxChild> SyntaxTree::children(SyntaxId id) const {
  const SyntaxNode& node = (*this)[id];
  return std::span(children_).subspan(node.first, node.count);
}

const WrittenSymbol& SyntaxTree::symbol(SyntaxId id) const {
  RIGOR_CHECK((*this)[id].kind == SyntaxKind::symbol);
  return symbols_[(*this)[id].payload];
}

const std::vector<WrittenIndex>& SyntaxTree::indices(SyntaxId id) const {
  RIGOR_CHECK((*this)[id].kind == SyntaxKind::component);
  return index_lists_[(*this)[id].payload];
}

const WrittenSum& SyntaxTree::big_sum(SyntaxId id) const {
  RIGOR_CHECK((*this)[id].kind == SyntaxKind::big_sum);
  return sums_[(*this)[id].payload];
}

const WrittenDerivative& SyntaxTree::derivative(SyntaxId id) const {
  RIGOR_CHECK((*this)[id].kind == SyntaxKind::derivative);
  return derivatives_[(*this)[id].payload];
}

const std::string& SyntaxTree::text(SyntaxId id) const {
  const SyntaxKind kind = (*this)[id].kind;
  RIGOR_CHECK(kind == SyntaxKind::number || kind == SyntaxKind::text || kind == SyntaxKind::function ||
              kind == SyntaxKind::integral || kind == SyntaxKind::unit);
  return texts_[(*this)[id].payload];
}

const Obstacle& SyntaxTree::obstacle(SyntaxId id) const {
  RIGOR_CHECK((*this)[id].kind == SyntaxKind::opaque);
  return obstacles_[(*this)[id].payload];
}

std::vector<SyntaxId> nodes_below(const SyntaxTree& syntax, std::vector<SyntaxId> roots) {
  std::vector<SyntaxId> nodes;
  std::ranges::reverse(roots);
  while (!roots.empty()) {
    nodes.push_back(roots.back());
    roots.pop_back();
    const auto children = syntax.children(nodes.back());
    for (auto child = children.rbegin(); child != children.rend(); ++child) roots.push_back(child->id);
  }
  return nodes;
}

}  // namespace rigor
