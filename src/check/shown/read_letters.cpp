// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/shown/read_letters.h"

#include <algorithm>
#include <set>

#include "base/among.h"
#include "elaborate/name/function_value.h"
#include "elaborate/name/letters.h"

namespace rigor {
namespace {

bool is_first_word(const std::string& base, const std::string& name) {
  return name == base || without_labels(name) == base;
}

bool has_quantity(const SyntaxTree& syntax, const std::vector<SyntaxId>& roots, const std::string& base) {
  return std::ranges::any_of(nodes_below(syntax, roots), [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::symbol && is_first_word(letter_with_marks(syntax.symbol(id)), base);
  });
}

LetterKind kind_of_symbol(const Names& names, const ExprTree& tree, SymbolId id) {
  const Symbol& symbol = tree.symbols[id];
  if (symbol.unit_of_measure) return LetterKind::measure_unit;
  if (is_function_value(names, tree, id)) return LetterKind::function_value;
  if (symbol.rotation) return LetterKind::rotation;
  if (symbol.rank == 1) return symbol.unit ? LetterKind::unit_vector : LetterKind::vector;
  if (symbol.rank > 1) return symbol.symmetric ? LetterKind::symmetric_tensor : LetterKind::tensor;
  return LetterKind::scalar;
}

/// What says what the quantity is: a directive, its definition, words, else how it is written.
std::vector<LetterSource> sources_of(const ExprTree& tree, const Names& names, const LettersOfNotes& known,
                                     SymbolId id) {
  std::vector<LetterSource> sources;
  const auto add_directive = [&](std::optional<std::size_t> number) {
    const auto found = number ? known.directives.find(*number) : known.directives.end();
    if (found == known.directives.end()) return;
    const Directive& directive = found->second->directive;
    const bool is_new =
        std::ranges::none_of(sources, [&](const LetterSource& each) { return each.span == directive.span; });
    if (is_new) sources.push_back({SourceKind::directive, directive.text, directive.span});
  };
  const NameKey* key = key_of(names.symbols, id);
  if (key != nullptr) add_directive(declared_by(names.symbols, *key));
  for (const DeclaredConstant& constant : names.scope.constants)
    if (constant.symbol == id) add_directive(constant.directive);
  for (const SmallQuantity& small : names.scope.small)
    if (tree[small.quantity].symbol == id) add_directive(small.directive);
  if (const NamedDefinition* named = definition_of(names.scope, id)) {
    if (!named->origin.directive) sources.push_back({SourceKind::definition, named->origin.text, {}});
    add_directive(named->origin.directive);
  }
  if (key == nullptr) return sources;
  for (const auto& [number, placed] : known.directives) {
    const Directive& directive = placed->directive;
    const bool meant = directive.kind == DirectiveKind::for_all && is_for_all(names.scope, id);
    if (meant && has_quantity(known.notes.syntax, directive.symbols, key->base)) add_directive(number);
  }
  const auto written = known.places.find(key->base);
  const FirstWritten first = written == known.places.end() ? FirstWritten{} : written->second;
  for (const SaidInLine& said : known.notes.prose.said) {
    const bool names_it = !said.words.empty() && std::ranges::any_of(said.chains, [&](const auto& chain) {
      return has_quantity(known.notes.syntax, chain.sides, key->base);
    });
    if (names_it) sources.push_back({SourceKind::words, said.words, said.span});
  }
  const auto& whole = key->rank == 1 ? first.vector : first.tensor;
  if (key->rank > 0 && whole) {
    sources.push_back({SourceKind::face, {}, *whole});
  } else if (key->rank > 0 && first.indexed) {
    sources.push_back({SourceKind::indexed, {}, *first.indexed});
  } else if (sources.empty() && first.at) {
    sources.push_back({SourceKind::first, {}, *first.at});
  }
  return sources;
}

ReadLetter quantity_as_read(const ExprTree& tree, const Names& names, const LettersOfNotes& known,
                            SymbolId id) {
  const Symbol& symbol = tree.symbols[id];
  ReadLetter letter{.name = symbol.name, .kind = kind_of_symbol(names, tree, id), .rank = symbol.rank};
  letter.per_particle = symbol.per_particle;
  letter.constant = is_declared_constant(names.scope, id);
  letter.small = std::ranges::any_of(
      names.scope.small, [&](const SmallQuantity& small) { return tree[small.quantity].symbol == id; });
  letter.for_all = is_for_all(names.scope, id);
  letter.field = is_field(names, tree, id);
  if (const NameKey* key = key_of(names.symbols, id))
    letter.complex = names.symbols.evidence->complex.contains(without_labels(key->base));
  letter.sources = sources_of(tree, names, known, id);
  return letter;
}

/// The index and particle letters of two sides: those that are free, and those that a sum binds.
class BoundLetters {
 public:
  BoundLetters(const ExprTree& tree, const Names& names, const LettersOfNotes& known,
               const std::set<std::string>& repeated)
      : tree_(tree), names_(names), known_(known), repeated_(repeated) {}

  void take(const Typed& side) {
    for (const ExprId id : nodes_below(tree_, {side.id})) {
      const ExprNode& node = tree_[id];
      if (node.op == Op::index_sum && is_written(tree_.name(node.index)))
        add(tree_.name(node.index), LetterKind::index, true);
      if (node.op == Op::particle_sum) add(tree_.name(node.particle), LetterKind::particle, true);
    }
    for (const FreeIndex& free : side.free) add(free.letter, LetterKind::index, false);
    for (const FreeParticle& free : side.particles) add(free.letter, LetterKind::particle, false);
    for (const FreeIndex& bound : side.bound) add(bound.letter, LetterKind::index, true);
  }

  std::vector<ReadLetter> letters = {};

 private:
  [[nodiscard]] bool is_written(const std::string& letter) const { return repeated_.contains(letter); }

  void add(const std::string& name, LetterKind kind, bool summed) {
    const auto same = std::ranges::find_if(
        letters, [&](const ReadLetter& each) { return each.name == name && each.kind == kind; });
    if (same != letters.end()) return;
    ReadLetter letter{.name = name, .kind = kind, .summed = summed};
    letter.repeated = summed && repeated_.contains(name);
    if (const auto number = particles_declared_by(names_.symbols, name)) {
      const auto found = known_.directives.find(*number);
      if (kind == LetterKind::particle && found != known_.directives.end())
        letter.sources.push_back(
            {SourceKind::directive, found->second->directive.text, found->second->directive.span});
    }
    letters.push_back(std::move(letter));
  }

  const ExprTree& tree_;
  const Names& names_;
  const LettersOfNotes& known_;
  const std::set<std::string>& repeated_;
};

}  // namespace

FirstPlaces first_places(const Notes& notes, const Names& names) {
  FirstPlaces places;
  const auto note = [&](std::optional<Span>& first, Span span) {
    if (!first) first = span;
  };
  for (const Event& event : notes.events) {
    const auto* display = std::get_if<ParsedDisplay>(&event);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains) {
      if (chain.image > 0) continue;
      const Letters letters = read_letters(notes.syntax, chain.sides, names);
      for (const SyntaxId id : nodes_below(notes.syntax, chain.sides)) {
        if (notes.syntax[id].kind != SyntaxKind::symbol) continue;
        const WrittenSymbol& symbol = notes.syntax.symbol(id);
        const WrittenName name = take_apart(symbol, letters, names);
        FirstWritten& written = places[name.base];
        const Span span = notes.syntax[id].span;
        note(written.at, span);
        if (symbol.face == Face::tensor) note(written.tensor, span);
        if (symbol.face == Face::vector || symbol.accent == Accent::hat) note(written.vector, span);
        if (!name.axes.empty()) note(written.indexed, span);
      }
    }
  }
  return places;
}

LettersOfNotes letters_of_notes(const Notes& notes, const Names& names) {
  LettersOfNotes known{notes, first_places(notes, names), {}};
  for (const Event& event : notes.events) {
    if (const auto* placed = std::get_if<PlacedDirective>(&event))
      known.directives[placed->directive.number] = placed;
  }
  return known;
}

std::vector<ReadLetter> letters_of_row(const ExprTree& tree, const Names& names, const LettersOfNotes& known,
                                       const Statement& statement, std::size_t which,
                                       const std::set<SymbolId>& ordered) {
  std::vector<SymbolId> shown;
  std::set<SymbolId> rated;
  std::vector<ReadLetter> letters;
  BoundLetters bound(tree, names, known, statement.how.summed);
  for (const std::size_t side : {which, which + 1}) {
    const auto& typed = statement.sides[side];
    if (!typed) continue;
    for (const SymbolId symbol : letters_in(tree, typed->id)) {
      const SymbolId base = base_of(tree.symbols, symbol);
      if (tree.symbols[base].integral) continue;
      if (tree.symbols[symbol].order(By::time) > 0) rated.insert(base);
      if (!is_one_of(base, shown)) shown.push_back(base);
    }
    bound.take(*typed);
  }
  for (const SymbolId symbol : shown) {
    letters.push_back(quantity_as_read(tree, names, known, symbol));
    letters.back().has_rate = rated.contains(symbol);
    letters.back().ordered = ordered.contains(symbol);
  }
  letters.insert(letters.end(), bound.letters.begin(), bound.letters.end());
  return letters;
}

}  // namespace rigor
