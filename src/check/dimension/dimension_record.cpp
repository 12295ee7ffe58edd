// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/dimension/dimension_record.h"

#include <algorithm>
#include <array>
#include <unordered_set>
#include <utility>

#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

DimensionForm one(Unknown unknown, const SmallRational& factor = 1) {
  DimensionForm form;
  form.add(unknown, factor);
  return form;
}

/// The axes that a derivative by coordinates is taken along: 1, 2, 3, or 0 for all of them.
std::array<bool, 4> differentiated_axes(const ExprTree& tree, ExprId left, ExprId right) {
  std::array<bool, 4> axes{};
  std::vector<ExprId> pending{left, right};
  std::unordered_set<std::uint32_t> seen;
  while (!pending.empty()) {
    const ExprId id = pending.back();
    pending.pop_back();
    if (!seen.insert(static_cast<std::uint32_t>(id)).second) continue;
    for (const ExprId child : tree.children(id)) pending.push_back(child);
    if (tree[id].op != Op::symbol) continue;
    const auto& derivation = tree.symbols[tree[id].symbol].derivation;
    if (!derivation || derivation->space == 0) continue;
    const auto slots = tree.slots(id);
    for (std::size_t k = 0; k < derivation->space; ++k)
      axes[slots.size() > k ? slots[slots.size() - 1 - k].axis : 0u] = true;
  }
  return axes;
}

/// `2`, `(1, 0, 3)`, `3\hat{x}`
bool holds_only_numbers(const ExprTree& tree, ExprId root) {
  std::vector<ExprId> pending{root};
  std::unordered_set<std::uint32_t> seen;
  while (!pending.empty()) {
    const ExprId id = pending.back();
    pending.pop_back();
    if (!seen.insert(static_cast<std::uint32_t>(id)).second) continue;
    const Op op = tree[id].op;
    if (op == Op::symbol || op == Op::delta || op == Op::epsilon) return false;
    for (const ExprId child : tree.children(id)) pending.push_back(child);
  }
  return true;
}

/// `m_\alpha`, `I_{ij}`, `\mathbf{r}_\alpha`: a vector's bold letter needs no index.
std::string written_name(const Symbol& symbol) {
  const std::string letter = symbol.name.substr(0, symbol.name.find_first_of("_'"));
  const bool greek = letter.starts_with("\\") &&
                     !letter_of({TokenKind::control, letter.substr(1), symbol.first_seen}).empty();
  const bool whole = letter.starts_with("\\") && !greek;
  std::string indices = symbol.per_particle ? "\\alpha" : "";
  if (!whole && symbol.rank > 0) {
    if (symbol.per_particle) indices += " ";
    indices += std::string("ijklmn").substr(0, static_cast<std::size_t>(std::min(symbol.rank, 6)));
  }
  if (indices.empty()) return symbol.name;
  const bool single = indices.size() == 1 || indices == "\\alpha";
  return symbol.name + (single ? "_" + indices : "_{" + indices + "}");
}

}  // namespace

DimensionRecorder::DimensionRecorder(const ExprTree& tree, Names& names) : tree_(tree), names_(names) {
  fresh({"t"});
  fresh();
}

Unknown DimensionRecorder::fresh(UnknownName name) {
  record_.unknowns.push_back(std::move(name));
  used_.push_back(false);
  return static_cast<Unknown>(record_.unknowns.size() - 1);
}

Unknown DimensionRecorder::unknown_of(SymbolId symbol) {
  const auto known = unknowns_.find(symbol);
  if (known != unknowns_.end()) return known->second;
  const bool time = is(symbol, {"t", 0, false});
  if (time) record_.unknowns[time_unknown].listed = true;
  const Unknown made = time ? time_unknown : fresh({written_name(tree_.symbols[symbol]), true});
  unknowns_.emplace(symbol, made);
  return made;
}

void DimensionRecorder::enter_section() {
  ++section_;
  if (record_.units.empty()) unknowns_.clear();
}

void DimensionRecorder::renew(SymbolId symbol) {
  if (declared_.contains(symbol) || is(symbol, {"t", 0, false})) return;
  unknowns_.erase(symbol);
}

void DimensionRecorder::declare(ExprId symbol, const Dimension& dimension, Span span, std::size_t directive) {
  const SymbolId base = base_of(tree_.symbols, tree_[symbol].symbol);
  const auto earlier = declared_.find(base);
  const bool another = earlier != declared_.end() && earlier->second.section != section_ &&
                       earlier->second.dimension != dimension && !is(base, {"t", 0, false});
  if (another) unknowns_.erase(base);
  declared_[base] = {dimension, section_};
  std::vector<DimensionEquation> none;
  record_.units.push_back({form_of(symbol, none), dimension, span, directive});
}

void DimensionRecorder::declare_angular_velocity(ExprId symbol) {
  std::vector<DimensionEquation> none;
  const Span span = tree_[symbol].span;
  demand(record_.facts, {form_of(symbol, none), one(time_unknown, -1), span, span, Alike::known});
}

/// Directions and rotations, and π, unless it is declared.
bool DimensionRecorder::is_pure_number(SymbolId base) const {
  const Symbol& symbol = tree_.symbols[base];
  const bool axes = std::any_of(names_.frames().begin(), names_.frames().end(),
                                [&](const Frame& frame) { return frame.rotation == base; });
  const bool pi = is(base, {"\\pi", 0, false}) && !declared_.contains(base);
  return symbol.unit || symbol.rotation || axes || pi;
}

bool DimensionRecorder::is_used(const DeclaredUnit& unit) const {
  return std::any_of(unit.symbol.unknowns.begin(), unit.symbol.unknowns.end(),
                     [&](const auto& entry) { return used_[entry.first]; });
}

/// A symbol's own dimension, less what it is differentiated by.
DimensionForm DimensionRecorder::form_of(ExprId id, std::vector<DimensionEquation>& equations) {
  const ExprNode& node = tree_[id];
  const SymbolId base = base_of(tree_.symbols, node.symbol);
  const Symbol& symbol = tree_.symbols[base];
  DimensionForm form;
  if (symbol.unit_of_measure) {
    form.fixed = *symbol.unit_of_measure;
  } else if (!is_pure_number(base)) {
    form.add(unknown_of(base), 1);
  }
  if (const auto& derivation = tree_.symbols[node.symbol].derivation) {
    form.add(time_unknown, SmallRational(-derivation->time));
    form.add(space_unknown, SmallRational(-derivation->space));
  }
  if (node.particle != no_particle && tree_.name(node.particle) == "∫") in_body(node, equations);
  return form;
}

/// Inside an integral over the body: V is the volume of an element, and what is defined there silently, as ρ
/// is, has its definition.
void DimensionRecorder::in_body(const ExprNode& node, std::vector<DimensionEquation>& equations) {
  const auto equal = [&](DimensionForm left, DimensionForm right) {
    demand(equations, {std::move(left), std::move(right), node.span, node.span, Alike::known});
  };
  if (is(node.symbol, {"V", 0, true})) {
    equal(one(unknown_of(node.symbol)), one(space_unknown, 3));
    if (const auto position = names_.find({"r", 1, true}))
      equal(one(unknown_of(*position)), one(space_unknown));
  }
  static const std::array<NameKey, 5> positions{
      {{"r", 1, true}, {"r", 0, true}, {"x", 0, true}, {"y", 0, true}, {"z", 0, true}}};
  for (const NameKey& key : positions) {
    if (is(node.symbol, key)) equal(one(unknown_of(node.symbol)), one(space_unknown));
  }
  const NamedDefinition* definition = names_.definition_of(node.symbol);
  if (definition == nullptr || !body_definitions_.emplace(node.symbol, true).second) return;
  DimensionForm body = reader(equations).read(definition->definition.body);
  equal(one(unknown_of(node.symbol)), std::move(body));
}

DimensionReader DimensionRecorder::reader(std::vector<DimensionEquation>& equations) {
  DimensionReader made(
      tree_, [this, &equations](ExprId id) { return form_of(id, equations); }, equations);
  made.set_fresh([this] { return fresh(); });
  return made;
}

/// Where a statement differentiates by coordinates, what it calls the position has the dimension of these.
void DimensionRecorder::relate_positions(const Statement& statement,
                                         std::vector<DimensionEquation>& equations) {
  const std::array<bool, 4> axes = differentiated_axes(tree_, statement.left, statement.right);
  if (std::none_of(axes.begin(), axes.end(), [](bool taken) { return taken; })) return;
  for (const ExprId side : {statement.left, statement.right}) {
    for (const SymbolId symbol : symbols_in(tree_, side)) {
      const bool vector = is(symbol, {"r", 1, false}) || is(symbol, {"x", 1, false});
      const bool coordinate = (is(symbol, {"x", 0, false}) && (axes[1] || axes[0])) ||
                              (is(symbol, {"y", 0, false}) && (axes[2] || axes[0])) ||
                              (is(symbol, {"z", 0, false}) && (axes[3] || axes[0]));
      if (!vector && !coordinate) continue;
      const Span span = tree_[side].span;
      demand(equations, {one(unknown_of(symbol)), one(space_unknown), span, span, Alike::known});
    }
  }
}

void DimensionRecorder::add(const Statement& statement) {
  DimensionStatement made;
  made.step = statement.step;
  made.source = statement.source;
  made.span = cover(statement.left_span, statement.right_span);
  std::vector<DimensionEquation> inner_left;
  const DimensionForm left = reader(statement.inner_left ? made.equations : inner_left).read(statement.left);
  const DimensionForm right = reader(made.equations).read(statement.right);
  relate_positions(statement, made.equations);
  if (statement.compared) {
    const bool number =
        holds_only_numbers(tree_, statement.left) || holds_only_numbers(tree_, statement.right);
    demand(made.equations,
           {left, right, statement.left_span, statement.right_span, number ? Alike::number : Alike::sides});
  }
  made.assumed = assumed_;
  for (const ExprId side : {statement.left, statement.right}) {
    for (const SymbolId symbol : symbols_in(tree_, side)) {
      const auto& derivation = tree_.symbols[symbol].derivation;
      if (derivation && derivation->time > 0) {
        used_[time_unknown] = true;
        record_.unknowns[time_unknown].listed = true;
      }
      const auto known = unknowns_.find(base_of(tree_.symbols, symbol));
      if (known != unknowns_.end()) used_[known->second] = true;
    }
  }
  record_.statements.push_back(std::move(made));
}

}  // namespace rigor
