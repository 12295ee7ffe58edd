// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/dimension/dimension_record.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
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
  for (const ExprId id : nodes_below(tree, {left, right})) {
    if (tree[id].op != Op::symbol) continue;
    const auto orders = static_cast<std::size_t>(tree.symbols[tree[id].symbol].order(By::space));
    const auto slots = tree.slots(id);
    for (std::size_t k = 0; k < orders; ++k)
      axes[slots.size() > k ? slots[slots.size() - 1 - k].axis : 0u] = true;
  }
  return axes;
}

/// `2`, `(1, 0, 3)`, `3\hat{x}`, `2\pi`
bool holds_only_numbers(const ExprTree& tree, ExprId root) {
  return std::ranges::none_of(nodes_below(tree, {root}), [&](ExprId id) {
    const Op op = tree[id].op;
    const bool circle = op == Op::symbol && tree.symbols[tree[id].symbol].circle_number;
    return (op == Op::symbol && !circle) || op == Op::delta || op == Op::epsilon;
  });
}

/// `m_\alpha`, `I_{ij}`, `\mathbf{r}_\alpha`: a vector's bold letter needs no index.
std::string written_name(const Symbol& symbol) {
  const std::string letter = symbol.name.substr(0, symbol.name.find_first_of("_'^"));
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

/// Relations between quantities of one dimension.
bool compares(RelationKind kind) {
  return kind != RelationKind::other && kind != RelationKind::implies && kind != RelationKind::demanded;
}

/// `x(\SI{7.6}{s})`: a value at that time, or a product.
bool takes_measured_argument(const SyntaxTree& syntax, std::span<const SyntaxChild> factors) {
  for (std::size_t k = 1; k < factors.size(); ++k) {
    const bool beside = factors[k].joint == Joint::juxtaposed &&
                        syntax[factors[k - 1].id].kind == SyntaxKind::symbol &&
                        syntax[factors[k].id].kind == SyntaxKind::group;
    // `\SI{2}{s}` is a group by itself.
    if (!beside || syntax[syntax.child(factors[k].id, 0)].kind != SyntaxKind::group) continue;
    bool unit = false;
    bool other = false;
    for (const SyntaxId id : nodes_below(syntax, {factors[k].id})) {
      unit = unit || syntax[id].kind == SyntaxKind::unit;
      other = other || syntax[id].kind == SyntaxKind::symbol || syntax[id].kind == SyntaxKind::sum;
    }
    if (unit && !other) return true;
  }
  return false;
}

bool has_measured_argument(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  return std::ranges::any_of(nodes_below(syntax, sides), [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::term && takes_measured_argument(syntax, syntax.children(id));
  });
}

class DimensionRecorder {
 public:
  DimensionRecorder(const ExprTree& tree, const SyntaxTree& syntax, const FileReport& report);

  void add(const LedgerEntry& entry) {
    names_ = entry.scope.get();
    std::visit([this](const auto& what) { add(what); }, entry.what);
  }
  [[nodiscard]] DimensionRecord finish();

 private:
  /// One relation between two sides; without `compared`, what is inside the sides only. `inner_left`:
  /// what is inside the left side, too.
  struct Relation {
    std::size_t step = 0;
    ExprId left{};
    ExprId right{};
    Span left_span;
    Span right_span;
    bool compared = true;
    bool inner_left = true;
    DimensionSource source = DimensionSource::law;
  };
  void add(const Statement& statement);
  void add(const UnitLine& line);
  void add(const FrameLine& line);
  void add(const SectionBegins&);
  void add(const StatementEnds&) { assumed_.clear(); }
  void relate(const Relation& relation);
  void renew(SymbolId symbol);
  struct Declared {
    Dimension dimension;
    std::size_t section = 0;
  };
  DimensionForm form_of(SymbolId id);
  DimensionForm form_of(ExprId symbol, std::vector<DimensionEquation>& equations);
  Unknown unknown_of(SymbolId symbol);
  Unknown fresh(UnknownName name = {});
  DimensionReader reader(std::vector<DimensionEquation>& equations);
  void in_body(const ExprNode& node, std::vector<DimensionEquation>& equations);
  void relate_positions(const Relation& relation, std::vector<DimensionEquation>& equations);
  [[nodiscard]] bool is_pure_number(SymbolId base) const;
  bool is(SymbolId symbol, const NameKey& key) const { return find_symbol(names_->symbols, key) == symbol; }

  const ExprTree& tree_;
  const SyntaxTree& syntax_;
  const FileReport& report_;
  const Names* names_ = nullptr;  // where the entry at hand stands
  DimensionRecord record_;
  std::map<SymbolId, Unknown> unknowns_;
  std::map<SymbolId, Declared> declared_;
  std::map<SymbolId, bool> body_definitions_;  // read already
  std::vector<std::size_t> assumed_;           // statements
  std::vector<bool> used_;                     // unknowns, in statements
  std::size_t section_ = 0;
};

DimensionRecorder::DimensionRecorder(const ExprTree& tree, const SyntaxTree& syntax, const FileReport& report)
    : tree_(tree), syntax_(syntax), report_(report) {
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

/// Without `units` above it, letters of earlier sections are taken for other quantities.
void DimensionRecorder::add(const SectionBegins&) {
  ++section_;
  if (record_.units.empty()) unknowns_.clear();
}

/// The symbol is now the name of another quantity.
void DimensionRecorder::renew(SymbolId symbol) {
  if (declared_.contains(symbol) || is(symbol, {"t", 0, false})) return;
  unknowns_.erase(symbol);
}

/// In another section than an earlier one, the symbol is taken for another quantity.
void DimensionRecorder::add(const UnitLine& line) {
  const SymbolId base = base_of(tree_.symbols, tree_[line.symbol].symbol);
  const auto earlier = declared_.find(base);
  const bool another = earlier != declared_.end() && earlier->second.section != section_ &&
                       earlier->second.dimension != line.dimension && !is(base, {"t", 0, false});
  if (another) unknowns_.erase(base);
  declared_[base] = {line.dimension, section_};
  std::vector<DimensionEquation> none;
  record_.units.push_back({form_of(line.symbol, none), line.dimension, line.span, line.directive});
}

/// An angular velocity turns by so much a time.
void DimensionRecorder::add(const FrameLine& line) {
  std::vector<DimensionEquation> none;
  const Span span = tree_[line.angular_velocity].span;
  demand(record_.facts,
         {form_of(line.angular_velocity, none), one(time_unknown, -1), span, span, Alike::known});
}

/// Directions and rotations, and π, unless it is declared.
bool DimensionRecorder::is_pure_number(SymbolId base) const {
  const Symbol& symbol = tree_.symbols[base];
  const bool axes =
      std::ranges::any_of(*names_->scope.frames, [&](const Frame& frame) { return frame.rotation == base; });
  const bool pi = is(base, {"\\pi", 0, false}) && !declared_.contains(base);
  return symbol.unit || symbol.rotation || axes || pi;
}

DimensionRecord DimensionRecorder::finish() {
  for (DeclaredUnit& unit : record_.units)
    unit.used =
        std::ranges::any_of(unit.symbol.unknowns, [&](const auto& entry) { return used_[entry.first]; });
  return std::move(record_);
}

/// A symbol's own dimension, less what it is differentiated by. Recursion: a variable can be a rate.
DimensionForm DimensionRecorder::form_of(SymbolId id) {
  const SymbolId base = base_of(tree_.symbols, id);
  const Symbol& symbol = tree_.symbols[base];
  DimensionForm form;
  if (symbol.unit_of_measure) {
    form.fixed = *symbol.unit_of_measure;
  } else if (!is_pure_number(base)) {
    form.add(unknown_of(base), 1);
  }
  if (const Symbol& own = tree_.symbols[id]; own.derivation) {
    form.add(time_unknown, SmallRational(-own.order(By::time)));
    form.add(space_unknown, SmallRational(-own.order(By::space)));
    for (const Variable& by : own.derivation->by) {
      if (by.by == By::letter) form.add(form_of(by.letter), -1);
    }
  }
  return form;
}

DimensionForm DimensionRecorder::form_of(ExprId id, std::vector<DimensionEquation>& equations) {
  const ExprNode& node = tree_[id];
  DimensionForm form = form_of(node.symbol);
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
    if (const auto position = find_symbol(names_->symbols, {"r", 1, true}))
      equal(one(unknown_of(*position)), one(space_unknown));
  }
  static const std::array<NameKey, 5> positions{
      {{"r", 1, true}, {"r", 0, true}, {"x", 0, true}, {"y", 0, true}, {"z", 0, true}}};
  for (const NameKey& key : positions) {
    if (is(node.symbol, key)) equal(one(unknown_of(node.symbol)), one(space_unknown));
  }
  const NamedDefinition* definition = definition_of(names_->scope, node.symbol);
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
void DimensionRecorder::relate_positions(const Relation& relation,
                                         std::vector<DimensionEquation>& equations) {
  const std::array<bool, 4> axes = differentiated_axes(tree_, relation.left, relation.right);
  if (std::ranges::none_of(axes, [](bool taken) { return taken; })) return;
  for (const ExprId side : {relation.left, relation.right}) {
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

void DimensionRecorder::relate(const Relation& relation) {
  DimensionStatement made;
  made.step = relation.step;
  made.source = relation.source;
  made.span = cover(relation.left_span, relation.right_span);
  std::vector<DimensionEquation> inner_left;
  const DimensionForm left = reader(relation.inner_left ? made.equations : inner_left).read(relation.left);
  const DimensionForm right = reader(made.equations).read(relation.right);
  relate_positions(relation, made.equations);
  if (relation.compared) {
    const bool number = holds_only_numbers(tree_, relation.left) || holds_only_numbers(tree_, relation.right);
    demand(made.equations,
           {left, right, relation.left_span, relation.right_span, number ? Alike::number : Alike::sides});
  }
  made.assumed = assumed_;
  for (const ExprId side : {relation.left, relation.right}) {
    for (const SymbolId symbol : symbols_in(tree_, side)) {
      if (tree_.symbols[symbol].order(By::time) > 0) {
        used_[time_unknown] = true;
        record_.unknowns[time_unknown].listed = true;
      }
      const auto known = unknowns_.find(base_of(tree_.symbols, symbol));
      if (known != unknowns_.end()) used_[known->second] = true;
    }
  }
  made.equations.shrink_to_fit();
  record_.statements.push_back(std::move(made));
}

void DimensionRecorder::add(const Statement& statement) {
  const ParsedChain& chain = *statement.chain;
  if (!statement.is_settled() || statement.guessed || has_measured_argument(syntax_, chain.sides)) return;
  const bool where = statement.role == Role::given && statement.for_now;
  const bool local = where || statement.role == Role::claim;
  bool read_before = false;
  for (std::size_t k = 0; k < chain.written.relations.size(); ++k) {
    const auto& left = statement.sides[k];
    const auto& right = statement.sides[k + 1];
    if (!left || !right || k >= statement.step_count) {
      read_before = false;
      continue;
    }
    const Step& step = report_.steps[statement.first_step + k];
    const bool redefined = step.verdict == Verdict::definition &&
                           std::ranges::any_of(step.diagnostics, [](const Diagnostic& each) {
                             return each.kind == DiagnosticKind::redefinition;
                           });
    if (redefined && tree_[left->id].op == Op::symbol) renew(tree_[left->id].symbol);
    relate({.step = statement.first_step + k,
            .left = left->id,
            .right = right->id,
            .left_span = chain.written.sides[k].span,
            .right_span = chain.written.sides[k + 1].span,
            .compared = compares(chain.written.relations[k].kind),
            .inner_left = !read_before,
            .source = local ? DimensionSource::local : DimensionSource::law});
    read_before = true;
    if (where) assumed_.push_back(record_.statements.size() - 1);  // until the next statement ends
  }
}

}  // namespace

DimensionRecord record_dimensions(const Ledger& ledger, const SyntaxTree& syntax, const FileReport& report) {
  DimensionRecorder recorder(ledger.tree, syntax, report);
  for (const LedgerEntry& entry : ledger.entries) recorder.add(entry);
  return recorder.finish();
}

}  // namespace rigor
