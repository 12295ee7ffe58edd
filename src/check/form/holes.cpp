// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/form/holes.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/among.h"
#include "check/form/hole_names.h"
#include "check/question/question.h"
#include "check/verdict/chain_reading.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

constexpr std::size_t most_letters = 8;  // that a hole's own are chosen from

bool joins_values(RelationKind kind) { return is_equality(kind) || kind == RelationKind::nearly; }

/// The holes below a node, from left to right.
std::vector<SyntaxId> holes_below(const SyntaxTree& syntax, SyntaxId root) {
  std::vector<SyntaxId> nodes = nodes_below(syntax, {root});
  std::erase_if(nodes, [&](SyntaxId id) {
    return syntax[id].kind != SyntaxKind::symbol || syntax.symbol(id).letter != hole_letter;
  });
  return nodes;
}

/// Index letters on symbols, in order of occurrence, each once.
void letters_below(const SyntaxTree& syntax, SyntaxId root, std::vector<std::string>& letters) {
  for (const SyntaxId id : nodes_below(syntax, {root})) {
    if (letters.size() >= most_letters) return;
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    for (const WrittenIndex& index : syntax.symbol(id).lower) {
      const bool one_letter = index.form == IndexForm::letter && axis_of_letter(index.text) == 0;
      const std::string key = index.text + std::string(index.primes, '\'');
      const bool known = is_one_of(key, letters);
      if (one_letter && !known) letters.push_back(key);
    }
  }
}

class HoleReader {
 public:
  HoleReader(const HoleChain& chain, std::size_t side, std::size_t partner)
      : chain_(chain), side_(side), partner_(partner) {}

  std::vector<HoleReading> read(Diagnostics& troubles) {
    std::vector<HoleReading> readings;
    for (const int rank : {0, 1, 2}) {
      const std::vector<HoleShape> shapes =
          rank == 0 ? scalar_shapes() : std::vector{HoleShape{.rank = rank}};
      bool found = false;
      for (const HoleShape& shape : shapes) {
        if (auto reading = attempt(shape)) {
          if (!is_known(readings, *reading)) readings.push_back(std::move(*reading));
          found = true;
          break;
        }
      }
      if (!found && rank == 0) plain_ = std::move(last_);
    }
    if (readings.empty() && differentiated_) {
      troubles = {
          {DiagnosticKind::hole, span_of_hole(), "it is differentiated, and derivatives are not undone"}};
    } else if (readings.empty()) {
      troubles = std::move(plain_);
    }
    return readings;
  }

 private:
  /// A hole whose letters or face are written has one shape.
  bool is_known(const std::vector<HoleReading>& readings, const HoleReading& other) const {
    return std::ranges::any_of(readings, [&](const HoleReading& each) {
      return chain_.tree[each.node].rank == chain_.tree[other.node].rank;
    });
  }

  /// No letters, those that are free on one side only, then one or two of those that occur.
  std::vector<HoleShape> scalar_shapes() {
    std::vector<HoleShape> shapes{HoleShape{}};
    std::vector<std::string> letters;
    for (const std::size_t side : {partner_, side_})
      letters_below(chain_.syntax, chain_.parsed.sides[side], letters);
    if (auto difference = one_sided()) shapes.push_back({.letters = std::move(*difference)});
    for (const std::string& one : letters) shapes.push_back({.letters = {one}});
    for (std::size_t a = 0; a < letters.size(); ++a) {
      for (std::size_t b = a + 1; b < letters.size(); ++b)
        shapes.push_back({.letters = {letters[a], letters[b]}});
    }
    const std::size_t plain = shapes.size();
    for (const std::string& particle : particles_) {
      for (std::size_t k = 0; k < plain; ++k) {
        HoleShape shape = shapes[k];
        shape.particles = {particle};
        shapes.push_back(std::move(shape));
      }
    }
    return shapes;
  }

  /// The letters that stand free on one side only if the hole is a plain number.
  std::optional<std::vector<std::string>> one_sided() {
    const ChainReading reading = read_as({});
    const auto& own = reading.sides[side_].typed;
    const auto& other = reading.sides[partner_].typed;
    if (other) {
      for (const FreeParticle& particle : other->particles) particles_.push_back(particle.letter);
    }
    if (!own || !other) return std::nullopt;
    std::vector<std::string> letters;
    const auto add_missing = [&](const std::vector<FreeIndex>& from, const std::vector<FreeIndex>& in) {
      for (const FreeIndex& each : from) {
        const bool both =
            std::ranges::any_of(in, [&](const FreeIndex& old) { return old.letter == each.letter; });
        if (!both) letters.push_back(each.letter);
      }
    };
    add_missing(other->free, own->free);
    add_missing(own->free, other->free);
    return letters;
  }

  ChainReading read_as(const HoleShape& shape) {
    ReadingRules how{.no_sum = chain_.parsed.written.no_sum};
    how.hole = shape;
    return ChainReading(chain_.syntax, chain_.tree, chain_.names, chain_.parsed, how);
  }

  std::optional<HoleReading> attempt(const HoleShape& shape) {
    ChainReading reading = read_as(shape);
    last_ = reading.sides[side_].diagnostics;
    const auto& partner = reading.sides[partner_];
    last_.insert(last_.end(), partner.diagnostics.begin(), partner.diagnostics.end());
    const auto& own = reading.sides[side_].typed;
    if (!own || !partner.typed) return std::nullopt;
    const std::size_t step = std::min(side_, partner_);
    auto claim = reading.claim(chain_.parsed, step, *partner.typed, *own, chain_.first_order, last_);
    if (!claim || reading.reading().found.holes.empty()) return std::nullopt;
    for (std::size_t k = step; k < std::max(side_, partner_); ++k)
      claim->nearly = claim->nearly || chain_.parsed.written.relations[k].kind == RelationKind::nearly;
    if (!claim->nearly) claim->nearly = chain_.first_order;
    const Span span = span_of_hole();
    HoleReading found{.claim = claim->equation, .nearly = claim->nearly};
    for (const Hole& hole : reading.reading().found.holes) {
      if (hole.span == span) found.symbol = hole.symbol;
    }
    const auto node = node_of(found.claim.right, found.symbol);
    if (!node || is_differentiated(found)) {
      differentiated_ = true;
      return std::nullopt;
    }
    found.node = *node;
    try_names(chain_.tree, chain_.names, *claim, found);
    ask(found);
    return found;
  }

  Span span_of_hole() const {
    return chain_.syntax[holes_below(chain_.syntax, chain_.parsed.sides[side_])[0]].span;
  }

  /// Its derivative is a symbol of its own, in which no value can be put.
  bool is_differentiated(const HoleReading& found) const {
    const std::vector<SymbolId> symbols = symbols_in(chain_.tree, found.claim.right);
    return std::ranges::any_of(symbols, [&](SymbolId symbol) {
      return symbol != found.symbol && base_of(chain_.tree.symbols, symbol) == found.symbol;
    });
  }

  /// Nothing where a derivative took the hole for a constant.
  std::optional<ExprId> node_of(ExprId root, SymbolId symbol) const {
    std::vector<ExprId> pending{root};
    while (!pending.empty()) {
      const ExprId id = pending.back();
      pending.pop_back();
      if (chain_.tree[id].op == Op::symbol && chain_.tree[id].symbol == symbol) return id;
      for (const ExprId child : chain_.tree.children(id)) pending.push_back(child);
    }
    return std::nullopt;
  }

  void ask(HoleReading& found) {
    for (const SmallQuantity& small : chain_.names.scope.small) found.small.push_back(small.quantity);
    const Precision precision = found.nearly ? Precision::small_order : Precision::exact;
    for (int order = 0; order <= (found.nearly ? 1 : 0); ++order) {
      Prepared prepared = prepare(chain_.tree, chain_.names, found.claim, 0, precision, order);
      prepared.question.tree = nullptr;
      found.questions.push_back(std::move(prepared.question));
    }
  }

  const HoleChain& chain_;
  std::size_t side_;
  std::size_t partner_;
  Diagnostics last_;
  Diagnostics plain_;  // of the plainest shape
  bool differentiated_ = false;
  std::vector<std::string> particles_;
};

/// The nearest side without a hole that the chain says is equal.
std::optional<std::size_t> partner_of(const HoleChain& chain, std::size_t side) {
  const std::vector<SyntaxId>& sides = chain.parsed.sides;
  const auto& relations = chain.parsed.written.relations;
  const auto fits = [&](std::size_t other) { return holes_below(chain.syntax, sides[other]).empty(); };
  for (std::size_t k = side; k > 0 && joins_values(relations[k - 1].kind); --k) {
    if (fits(k - 1)) return k - 1;
  }
  for (std::size_t k = side; k < relations.size() && joins_values(relations[k].kind); ++k) {
    if (fits(k + 1)) return k + 1;
  }
  return std::nullopt;
}

}  // namespace

void record_holes(const HoleChain& chain, const WrittenFormChain& forms, std::size_t position,
                  std::vector<WrittenHole>& into) {
  const WrittenChain& written = chain.parsed.written;
  for (std::size_t side = 0; side < chain.parsed.sides.size(); ++side) {
    const std::vector<SyntaxId> holes = holes_below(chain.syntax, chain.parsed.sides[side]);
    for (const SyntaxId id : holes) {
      WrittenHole hole{.span = chain.syntax[id].span,
                       .statement = written.span,
                       .chain = position,
                       .side = side,
                       .alone = id == chain.parsed.sides[side],
                       .tag = forms.tag,
                       .label = forms.label,
                       .headings = forms.headings,
                       .readings = {},
                       .troubles = {}};
      const auto trouble = [&](std::string message) {
        hole.troubles.push_back({DiagnosticKind::hole, hole.span, std::move(message)});
      };
      const auto partner = partner_of(chain, side);
      if (written.condition) {
        hole.troubles.push_back({written.condition->kind,
                                 written.condition_span,
                                 written.condition->message,
                                 {},
                                 written.condition->help});
      } else if (chain.assumed) {
        trouble("an assumption has no hole: nothing says what belongs there");
      } else if (holes.size() > 1) {
        trouble(
            fmt::format("one expression has {} holes, but one equation determines only one", holes.size()));
      } else if (!partner) {
        trouble("nothing in the statement says what this is equal to");
      } else {
        hole.partner = *partner;
        hole.readings = HoleReader(chain, side, *partner).read(hole.troubles);
        if (hole.readings.empty() && hole.troubles.empty())
          trouble("no rank and no indices of the hole fit here");
      }
      into.push_back(std::move(hole));
    }
  }
}

}  // namespace rigor
