// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/letters.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>

#include "base/among.h"
#include "elaborate/evidence/evidence.h"

namespace rigor {
namespace {

bool is_strong(const std::string& letter) {
  return letter.size() == 1 && letter[0] >= 'i' && letter[0] <= 'n';
}

bool is_small_latin(const WrittenIndex& index) {
  return index.form == IndexForm::letter && index.text.size() == 1 && index.text[0] >= 'a' &&
         index.text[0] <= 'z';
}

/// Every node below the roots, parents first.
void for_each_node(const SyntaxTree& syntax, const std::vector<SyntaxId>& roots,
                   const std::function<void(SyntaxId)>& visit) {
  std::vector<SyntaxId> stack(roots.rbegin(), roots.rend());
  while (!stack.empty()) {
    const SyntaxId id = stack.back();
    stack.pop_back();
    visit(id);
    for (const SyntaxChild& child : syntax.children(id)) stack.push_back(child.id);
  }
}

std::vector<std::string> latin_letters(const std::vector<WrittenIndex>& indices) {
  std::vector<std::string> letters;
  for (const WrittenIndex& index : indices) {
    if (is_small_latin(index) && axis_of_letter(index.text) == 0) letters.push_back(index.text);
  }
  return letters;
}

/// `(\partial S/\partial T)_p`: p is held, and no index.
bool holds_by_name(const SyntaxTree& syntax, SyntaxId component) {
  SyntaxId of = syntax.child(component, 0);
  while (syntax[of].kind == SyntaxKind::group) of = syntax.child(of, 0);
  if (syntax[of].kind != SyntaxKind::derivative || !syntax.derivative(of).partial) return false;
  return std::ranges::all_of(syntax.derivative(of).by,
                             [](const WrittenVariable& by) { return by.symbol.lower.empty(); });
}

/// Letters that an index notation of this statement settles: on δ and ε, on brackets, under explicit sums.
void read_definite(const SyntaxTree& syntax, SyntaxId id, const Names& names, Letters& letters) {
  const SyntaxKind kind = syntax[id].kind;
  std::vector<std::string> found;
  if (kind == SyntaxKind::symbol) {
    const WrittenSymbol& symbol = syntax.symbol(id);
    const auto triple = triple_of_member(*names.symbols.evidence, symbol);
    if (is_kronecker_of_states(symbol, *names.symbols.evidence)) return;
    if (is_kronecker(symbol) || is_levi_civita(symbol) || is_basis_family(symbol) || triple)
      found = latin_letters(symbol.lower);
  } else if (kind == SyntaxKind::component) {
    if (!holds_by_name(syntax, id)) found = latin_letters(syntax.indices(id));
  } else if (kind == SyntaxKind::big_sum && runs_over_numbers(syntax, id, names)) {
    letters.counted.insert(syntax.big_sum(id).indices[0].text);
    letters.labels.insert(syntax.big_sum(id).indices[0].text);
    if (syntax.big_sum(id).to == "N") letters.counted.insert("N");
    for (const SyntaxChild& limit : syntax.children(id).subspan(1)) {
      for (const SyntaxId each : nodes_below(syntax, {limit.id})) {
        if (syntax[each].kind == SyntaxKind::symbol) letters.counted.insert(syntax.symbol(each).letter);
      }
    }
  } else if (kind == SyntaxKind::big_sum) {
    found = latin_letters(syntax.big_sum(id).indices);
  } else if (kind == SyntaxKind::derivative) {
    for (const WrittenVariable& by : syntax.derivative(id).by) {
      const std::vector<std::string> own = latin_letters(by.symbol.lower);
      found.insert(found.end(), own.begin(), own.end());
    }
  }
  letters.evidence = letters.evidence || !found.empty();
  letters.indices.insert(found.begin(), found.end());
}

/// Letters on a symbol that is known to be a vector, and all letters of a subscript that has one index letter
/// for sure.
void read_by_company(const SyntaxTree& syntax, SyntaxId id, const Names& names, Letters& letters) {
  if (syntax[id].kind != SyntaxKind::symbol) return;
  const WrittenSymbol& symbol = syntax.symbol(id);
  const std::vector<std::string> own = latin_letters(symbol.lower);
  const bool labelled =
      std::ranges::any_of(own, [&](const std::string& letter) { return letters.labels.contains(letter); });
  if (own.empty() || labelled || (symbol.face == Face::vector && !is_basis_family(symbol))) return;
  const std::string base = letter_with_marks(symbol);
  const bool known_vector = own.size() == 1 && (names.symbols.sightings->bold.contains({base, false}) ||
                                                names.symbols.sightings->bold.contains({base, true}) ||
                                                is_declared(names.symbols, {base, 1, false}) ||
                                                is_declared(names.symbols, {base, 1, true}));
  const bool company = own.size() > 1 && std::ranges::any_of(own, [&](const std::string& letter) {
                         return letters.is_index(letter);
                       });
  const bool tensor = is_declared(names.symbols, {base, static_cast<int>(own.size()), false});
  if (!known_vector && !company && !tensor) return;
  letters.evidence = true;
  letters.indices.insert(own.begin(), own.end());
}

/// i of `F^{i0}`, a tensor of space-time, and of `E^i` beside \mathbf E is an index, also on what stands
/// beside it.
void read_indices_above(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const Names& names,
                        Letters& letters) {
  const SpaceTime& seen = names.symbols.evidence->space_time;
  if (!seen.shown) return;
  for_each_node(syntax, sides, [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::power) return;
    const SyntaxId base = syntax.child(id, 0);
    if (syntax[base].kind != SyntaxKind::symbol) return;
    const std::string letter = letter_with_marks(syntax.symbol(base));
    if (!seen.tensors.contains(letter) && !names.symbols.sightings->bold.contains({letter, false})) return;
    for (const WrittenIndex& index : indices_above(syntax, syntax.child(id, 1))) {
      if (index.form != IndexForm::letter) continue;
      letters.indices.insert(index.text);
      letters.evidence = true;
    }
  });
}

/// `Q_{ab}` and `Q_{ba}`: a and b are indices.
void read_permutations(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Letters& letters) {
  std::set<std::pair<std::string, std::string>> seen;
  for_each_node(syntax, sides, [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::symbol) return;
    const std::vector<std::string> own = latin_letters(syntax.symbol(id).lower);
    if (own.size() != 2 || own[0] == own[1]) return;
    const std::string base = letter_with_marks(syntax.symbol(id));
    if (seen.contains({base, own[1] + own[0]})) letters.indices.insert(own.begin(), own.end());
    seen.insert({base, own[0] + own[1]});
  });
}

void read_repetition(const SyntaxTree& syntax, SyntaxId id, Letters& letters) {
  if (syntax[id].kind != SyntaxKind::term) return;
  std::map<std::string, int> count;
  for (const SyntaxChild& child : syntax.children(id)) {
    if (syntax[child.id].kind != SyntaxKind::symbol) continue;
    for (const std::string& letter : latin_letters(syntax.symbol(child.id).lower)) {
      if (is_strong(letter) && ++count[letter] > 1) letters.evidence = true;
    }
  }
}

/// `v_i` and `v_f`, `E_n` and a bare `n`: labels.
void read_labels(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Letters& letters) {
  std::map<std::string, std::set<std::string>> on_base;
  std::set<std::string> bare;
  for_each_node(syntax, sides, [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::symbol) return;
    const WrittenSymbol& symbol = syntax.symbol(id);
    if (symbol.lower.empty() && symbol.face == Face::plain) bare.insert(symbol.letter);
    const std::vector<std::string> own = latin_letters(symbol.lower);
    letters.below.insert(own.begin(), own.end());
    if (own.size() == 1) on_base[letter_with_marks(symbol)].insert(own[0]);
  });
  letters.bare = bare;
  for (const auto& [base, own] : on_base) {
    if (own.contains("i") && own.contains("f") && !letters.indices.contains("i"))
      letters.labels.insert({"i", "f"});
    for (const std::string& letter : own) {
      if (bare.contains(letter) && !letters.indices.contains(letter)) letters.labels.insert(letter);
    }
  }
}

/// n of `E_{2n}` beside E_n: a component would have as many indices.
std::set<std::string> counters_of_multiples(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  std::set<std::pair<std::string, std::string>> members;
  std::set<std::pair<std::string, std::string>> multiples;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind != SyntaxKind::symbol) continue;
    const WrittenSymbol& symbol = syntax.symbol(id);
    const std::vector<WrittenIndex>& lower = symbol.lower;
    if (lower.empty() || lower.size() > 2 || !is_small_latin(lower.back()) || !is_strong(lower.back().text))
      continue;
    if (lower.size() == 1) members.emplace(letter_with_marks(symbol), lower.back().text);
    if (lower.size() == 2 && lower[0].form == IndexForm::digit)
      multiples.emplace(letter_with_marks(symbol), lower.back().text);
  }
  std::set<std::string> counters;
  for (const auto& each : multiples) {
    if (members.contains(each)) counters.insert(each.second);
  }
  return counters;
}

/// n of `x_{n+1}` labels x_n beside it, too; elsewhere in the section where no term repeats it.
void read_counters(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const Names& names,
                   Letters& letters) {
  std::set<std::string> counters = names.symbols.evidence->counters;
  std::set<std::string> here = counters_of_multiples(syntax, sides);
  for_each_node(syntax, sides, [&](SyntaxId id) {
    if (syntax[id].kind == SyntaxKind::symbol) {
      for (const WrittenIndex& index : syntax.symbol(id).lower) {
        const std::vector<std::string> own = counters_in(index);
        here.insert(own.begin(), own.end());
      }
    }
    if (syntax[id].kind != SyntaxKind::term) return;
    std::set<std::string> in_term;
    for (const SyntaxChild& child : syntax.children(id)) {
      if (syntax[child.id].kind != SyntaxKind::symbol) continue;
      for (const std::string& letter : latin_letters(syntax.symbol(child.id).lower)) {
        if (!in_term.insert(letter).second) counters.erase(letter);
      }
    }
  });
  counters.merge(here);
  const std::set<std::string>& numbers = names.symbols.evidence->state_labels;
  counters.insert(numbers.begin(), numbers.end());
  std::ranges::copy_if(counters, std::inserter(letters.labels, letters.labels.end()),
                       [&](const std::string& letter) { return !letters.indices.contains(letter); });
}

/// Is it declared with its subscripts as one letter: `scalar \omega_n`?
bool is_declared_with_labels(const WrittenSymbol& symbol, const Names& names) {
  return !symbol.lower.empty() &&
         is_declared(names.symbols, {with_labels(letter_with_marks(symbol), symbol.lower), 0, false});
}

/// `A_iA_i`: who counts with labels writes a square.
void find_repeated_components(const SyntaxTree& syntax, SyntaxId term, std::set<std::string>& sure) {
  std::set<std::pair<std::string, std::vector<std::string>>> seen;
  for (const SyntaxChild& child : syntax.children(term)) {
    if (syntax[child.id].kind != SyntaxKind::symbol) continue;
    const std::vector<std::string> own = latin_letters(syntax.symbol(child.id).lower);
    const bool strong = !own.empty() && std::ranges::all_of(own, is_strong);
    if (strong && !seen.insert({letter_with_marks(syntax.symbol(child.id)), own}).second)
      sure.insert(own.begin(), own.end());
  }
}

bool holds_a_vector(const SyntaxTree& syntax, SyntaxId root) {
  bool found = false;
  for_each_node(syntax, {root}, [&](SyntaxId id) {
    found = found || (syntax[id].kind == SyntaxKind::symbol && syntax.symbol(id).face == Face::vector);
  });
  return found;
}

/// How often each letter is in a subscript.
using IndexCounts = std::map<std::string, int>;

/// `a_n` and `\mathbf a`: the normal component as well as one of three, unless n is there twice.
bool may_label(const std::string& letter, const IndexCounts& counts) {
  const auto found = counts.find(letter);
  return letter != "i" && letter != "j" && letter != "k" && found != counts.end() && found->second == 1;
}

/// Letters that are indices by what they are on alone.
void find_sure(const SyntaxTree& syntax, SyntaxId id, const Names& names, const IndexCounts& counts,
               std::set<std::string>& sure) {
  const SyntaxKind kind = syntax[id].kind;
  std::vector<std::string> found;
  if (kind == SyntaxKind::term) find_repeated_components(syntax, id, sure);
  if (kind == SyntaxKind::component && holds_a_vector(syntax, syntax.child(id, 0)) &&
      syntax[syntax.child(id, 0)].kind == SyntaxKind::group)
    found = latin_letters(syntax.indices(id));
  if (kind == SyntaxKind::derivative) {
    for (const WrittenVariable& by : syntax.derivative(id).by) {
      const std::vector<std::string> own = latin_letters(by.symbol.lower);
      found.insert(found.end(), own.begin(), own.end());
    }
  }
  if (kind == SyntaxKind::symbol) {
    const WrittenSymbol& symbol = syntax.symbol(id);
    const std::vector<std::string> own = latin_letters(symbol.lower);
    const std::string base = letter_with_marks(symbol);
    const int rank = static_cast<int>(own.size());
    const bool declared =
        is_declared(names.symbols, {base, rank, false}) || is_declared(names.symbols, {base, rank, true});
    const bool component = symbol.face == Face::plain && own.size() == 1 &&
                           names.symbols.evidence->vectors.contains(base) && !may_label(own[0], counts);
    if (is_kronecker(symbol) || is_levi_civita(symbol) || is_basis_family(symbol) || declared || component)
      found = own;
  }
  std::copy_if(found.begin(), found.end(), std::inserter(sure, sure.end()), [](const std::string& letter) {
    return is_strong(letter) || (letter.size() == 1 && letter[0] >= 'a' && letter[0] <= 'h');
  });
}

/// A symbol with one index for sure has no labels next to it, nor elsewhere in the statement.
void read_sure(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const Names& names,
               Letters& letters) {
  IndexCounts counts;
  for_each_node(syntax, sides, [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::symbol) return;
    for (const std::string& letter : latin_letters(syntax.symbol(id).lower)) ++counts[letter];
  });
  for_each_node(syntax, sides, [&](SyntaxId id) { find_sure(syntax, id, names, counts, letters.sure); });
  std::set<std::string> indexed;
  for (bool grown = true; grown;) {
    const std::size_t before = letters.sure.size() + indexed.size();
    for_each_node(syntax, sides, [&](SyntaxId id) {
      if (syntax[id].kind != SyntaxKind::symbol || syntax.symbol(id).face == Face::vector) return;
      const std::vector<std::string> own = latin_letters(syntax.symbol(id).lower);
      const std::string base = letter_with_marks(syntax.symbol(id));
      const bool sure = std::ranges::any_of(own, [&](const auto& each) { return letters.is_sure(each); });
      if (sure) indexed.insert(base);
      if (!indexed.contains(base)) return;
      std::copy_if(own.begin(), own.end(), std::inserter(letters.sure, letters.sure.end()),
                   [&](const std::string& letter) { return letters.is_index(letter); });
    });
    grown = letters.sure.size() + indexed.size() > before;
  }
}

/// Is the row about the usual matrices of a triple, and about other operators?
void read_triple(const WrittenSymbol& symbol, const Evidence& evidence, Letters& letters) {
  const auto member = triple_of_member(evidence, symbol);
  const auto triple = member ? member : whole_triple(evidence, symbol);
  if (triple) {
    letters.has_usual_triple = letters.has_usual_triple || triple->usual;
  } else if (is_operator(evidence, symbol)) {
    letters.has_operators = true;
  }
}

void sight_crossed(const SyntaxTree& syntax, SyntaxId term, Sightings& sightings) {
  const std::span<const SyntaxChild> factors = syntax.children(term);
  for (std::size_t k = 1; k < factors.size(); ++k) {
    if (factors[k].joint != Joint::cross) continue;
    for (const SyntaxId id : {factors[k - 1].id, factors[k].id}) {
      if (syntax[id].kind == SyntaxKind::symbol)
        sightings.crossed.insert(letter_with_marks(syntax.symbol(id)));
    }
  }
}

}  // namespace

bool Letters::is_index(const std::string& letter) const {
  if (labels.contains(letter)) return false;
  return is_strong(letter) || indices.contains(letter);
}

bool Letters::is_sure(std::string_view letter) const {
  const std::string own(letter.substr(0, letter.find('\'')));
  return sure.contains(own) && !labels.contains(own);
}

bool is_member_of_sequence(const WrittenSymbol& symbol, const std::string& counter) {
  return symbol.face == Face::plain && symbol.accent != Accent::hat && symbol.dots == 0 &&
         symbol.primes == 0 && symbol.change.empty() && symbol.lower.size() == 1 &&
         symbol.lower[0].text == counter && symbol.lower[0].primes == 0 && !is_kronecker(symbol) &&
         !is_levi_civita(symbol) && !is_basis_family(symbol);
}

bool runs_over_numbers(const SyntaxTree& syntax, SyntaxId big_sum, const Names& names) {
  const WrittenSum& sum = syntax.big_sum(big_sum);
  if (sum.indices.size() != 1 || sum.from.empty() || sum.to.empty()) return false;
  const WrittenIndex& index = sum.indices[0];
  const bool letter = index.form == IndexForm::letter || index.form == IndexForm::greek;
  if (index.primes > 0 || !letter || labels_particles(names.symbols, index.text)) return false;
  const std::string axes = std::to_string(space_of(names.symbols).dimension);
  const bool may_be_axes = sum.from == "1" && sum.to == axes;
  bool alone = false;
  std::vector<SyntaxId> above;  // j of `x^j`, which may be an upper index
  for (const SyntaxId id : nodes_below(syntax, {syntax.child(big_sum, 0)})) {
    if (syntax[id].kind == SyntaxKind::power) above.push_back(syntax.child(id, 1));
    const bool component = syntax[id].kind == SyntaxKind::component;
    if (!component && syntax[id].kind != SyntaxKind::symbol) continue;
    if (!component && !may_be_axes && is_member_of_sequence(syntax.symbol(id), index.text)) continue;
    for (const WrittenIndex& below : component ? syntax.indices(id) : syntax.symbol(id).lower) {
      const std::vector<std::string> counters = counters_in(below);
      const bool counts = below.text.starts_with("^{(") && below.text.find(index.text) != std::string::npos;
      if (below.text == index.text || counts || is_one_of(index.text, counters)) return false;
    }
    if (!component && !is_one_of(id, above))
      alone = alone || (syntax.symbol(id).letter == index.text && syntax.symbol(id).lower.empty() &&
                        is_undecorated(syntax.symbol(id)));
  }
  return alone || !may_be_axes;
}

Letters read_letters(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const Names& names) {
  Letters letters;
  read_indices_above(syntax, sides, names, letters);
  for_each_node(syntax, sides, [&](SyntaxId id) { read_definite(syntax, id, names, letters); });
  read_permutations(syntax, sides, letters);
  read_labels(syntax, sides, letters);
  read_counters(syntax, sides, names, letters);
  for_each_node(syntax, sides, [&](SyntaxId id) { read_by_company(syntax, id, names, letters); });
  for_each_node(syntax, sides, [&](SyntaxId id) { read_repetition(syntax, id, letters); });
  for_each_node(syntax, sides, [&](SyntaxId id) {
    letters.has_nabla = letters.has_nabla || is_nabla(syntax, id);
    if (syntax[id].kind == SyntaxKind::derivative) {
      for (const WrittenVariable& by : syntax.derivative(id).by)
        if (by.symbol.dots == 0) letters.by.insert(letter_with_marks(by.symbol));
    }
    if (syntax[id].kind != SyntaxKind::symbol) return;
    read_triple(syntax.symbol(id), *names.symbols.evidence, letters);
    if (!syntax.symbol(id).change.empty()) letters.changes.insert(syntax.symbol(id).change);
    if (is_declared_with_labels(syntax.symbol(id), names)) return;
    const std::vector<std::string> own = latin_letters(syntax.symbol(id).lower);
    if (syntax.symbol(id).face == Face::vector) {
      letters.bold_vectors.insert(letter_with_marks(syntax.symbol(id)));
      letters.bold_vectors.insert(with_labels(letter_with_marks(syntax.symbol(id)), syntax.symbol(id).lower));
    }
    if (own.size() == 1 && letters.is_index(own[0]) && !labels_particles(names.symbols, own[0]))
      letters.indexed_vectors.insert(letter_with_marks(syntax.symbol(id)));
  });
  read_sure(syntax, sides, names, letters);
  return letters;
}

void sight_sums(const SyntaxTree& syntax, SyntaxId root, Sightings& sightings) {
  for_each_node(syntax, {root}, [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::big_sum) return;
    for (const WrittenIndex& index : syntax.big_sum(id).indices) {
      if (index.form == IndexForm::greek) sightings.summed_greek.insert(index.text);
    }
  });
}

void sight_faces(const SyntaxTree& syntax, SyntaxId root, Names& names) {
  for_each_node(syntax, {root}, [&](SyntaxId id) {
    if (syntax[id].kind == SyntaxKind::term) sight_crossed(syntax, id, names.symbols.sightings.write());
    if (syntax[id].kind != SyntaxKind::symbol) return;
    const WrittenSymbol& symbol = syntax.symbol(id);
    const bool hat = symbol.accent == Accent::hat;
    if (hat && (symbol.letter == "i" || symbol.letter == "j" || symbol.letter == "\\imath" ||
                symbol.letter == "\\jmath")) {
      names.symbols.sightings.write().hatted_ij = true;
    }
    if (symbol.face != Face::vector && !hat) return;
    const WrittenName name = take_apart(symbol, Letters{}, names);
    if (name.axes.empty()) {
      names.symbols.sightings.write().bold.insert({name.base, name.per_particle()});
    } else if (std::ranges::all_of(
                   name.axes, [](const WrittenIndex& index) { return index.form == IndexForm::digit; })) {
      names.symbols.sightings.write().bold.insert({with_labels(name.base, name.axes), name.per_particle()});
    } else {
      names.symbols.sightings.write().bold_indexed.insert(name.base);
    }
  });
}

void sight_indices(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, Names& names) {
  const Letters letters = read_letters(syntax, sides, names);
  for_each_node(syntax, sides, [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::symbol) return;
    const WrittenSymbol& symbol = syntax.symbol(id);
    const WrittenName name = take_apart(symbol, letters, names);
    const bool any_letter = std::ranges::any_of(name.axes, [](const WrittenIndex& index) {
      return index.form == IndexForm::letter && axis_of_letter(index.text) == 0;
    });
    if (any_letter)
      names.symbols.sightings.write().indexed.insert(
          {name.base, static_cast<int>(name.axes.size()), name.per_particle()});
  });
}

WrittenName take_apart(const WrittenSymbol& symbol, const Letters& letters, const Names& names) {
  WrittenName name;
  if (symbol.face == Face::plain && is_declared_with_labels(symbol, names)) {
    name.base = with_labels(letter_with_marks(symbol), symbol.lower);
    return name;
  }
  std::vector<WrittenIndex> labels;
  std::vector<WrittenIndex> labels_behind;  // after an axis: `T_{i\text{x}}` is not `T_{\text{x}i}`
  bool bare_label = false;                  // a digit or letter that is no axis
  // In the plane `a_3` is no label, either: it is an axis that is not there.
  const char last_axis = static_cast<char>('0' + std::max<int>(3, space_of(names.symbols).dimension));
  for (const WrittenIndex& index : symbol.lower) {
    if (const auto directive = particles_declared_by(names.symbols, index.text)) name.used.insert(*directive);
    const bool particle = labels_particles(names.symbols, index.text) && index.form != IndexForm::word;
    const bool axis_digit = index.form == IndexForm::digit && index.text.size() == 1 &&
                            index.text[0] >= '1' && index.text[0] <= last_axis;
    const bool axis_letter =
        is_small_latin(index) && (letters.is_index(index.text) || axis_of_letter(index.text) != 0);
    if (particle) {
      name.particles.push_back(index);
    } else if (axis_digit || axis_letter) {
      name.axes.push_back(index);
    } else {
      (name.axes.empty() ? labels : labels_behind).push_back(index);
      bare_label = bare_label || index.form == IndexForm::digit || index.form == IndexForm::letter;
    }
  }
  if (bare_label && !name.axes.empty()) {  // `x_{10}`, `k_{1a}`: one label of several signs
    labels.clear();
    std::copy_if(symbol.lower.begin(), symbol.lower.end(), std::back_inserter(labels),
                 [&](const WrittenIndex& index) {
                   return !labels_particles(names.symbols, index.text) || index.form == IndexForm::word;
                 });
    labels_behind.clear();
    name.axes.clear();
  }
  name.base = with_labels(letter_with_marks(symbol), labels);
  if (!labels_behind.empty()) name.base += with_labels("{}", labels_behind);
  return name;
}

bool is_kronecker_of_states(const WrittenSymbol& symbol, const Evidence& evidence) {
  if (!is_kronecker(symbol) || symbol.lower.size() != 2) return false;
  bool any = false;
  for (const WrittenIndex& index : symbol.lower) {
    const std::vector<std::string> counters = counters_in(index);
    const bool number = index.form == IndexForm::digit;
    const bool of_states = evidence.state_labels.contains(index.text) ||
                           (!counters.empty() && std::ranges::all_of(counters, [&](const std::string& each) {
                             return evidence.state_labels.contains(each);
                           }));
    if (!number && !of_states) return false;
    any = any || of_states;
  }
  return any;
}

bool is_kronecker(const WrittenSymbol& symbol) {
  return symbol.letter == "\\delta" && symbol.face == Face::plain && symbol.accent == Accent::none &&
         symbol.lower.size() == 2;
}

bool is_levi_civita(const WrittenSymbol& symbol) {
  return symbol.letter == "\\epsilon" && symbol.face == Face::plain && symbol.accent == Accent::none &&
         symbol.lower.size() == 3;
}

bool is_basis_family(const WrittenSymbol& symbol) {
  const bool vector = symbol.face == Face::vector || symbol.accent == Accent::hat;
  const bool plain = symbol.accent == Accent::none || symbol.accent == Accent::hat;
  if (symbol.letter != "e" || !vector || !plain || symbol.primes != 0 || symbol.lower.size() != 1)
    return false;
  const WrittenIndex& index = symbol.lower[0];
  return index.form == IndexForm::digit || is_strong(index.text) || axis_of_letter(index.text) != 0;
}

bool names_a_place(const WrittenSymbol& variable) {
  if (!is_undecorated(variable)) return false;
  if (variable.lower.empty()) return axis_of_letter(variable.letter) != 0;
  return variable.lower.size() == 1 && (variable.letter == "x" || variable.letter == "r");
}

std::uint8_t axis_of_letter(const std::string& letter) {
  if (letter == "x") return 1;
  if (letter == "y") return 2;
  return letter == "z" ? 3 : 0;
}

}  // namespace rigor
