// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/names.h"

#include <algorithm>

namespace rigor {

SymbolId Names::resolve(ExprTree& tree, const NameKey& key, const std::string& name, Span span) {
  const auto found = entries_.find(key);
  if (found != entries_.end()) {
    if (found->second.directive) mark_used(*found->second.directive);
    return found->second.symbol;
  }
  Symbol symbol;
  symbol.name = name;
  symbol.rank = key.rank;
  symbol.per_particle = key.per_particle;
  symbol.first_seen = span;
  // A declaration whose section is over leaves the same symbol, for which nothing is said any more; one with
  // properties of its own is another symbol.
  const auto before = declared_before_.find(key);
  const bool same = before != declared_before_.end() && !tree.symbols[before->second].symmetric &&
                    !tree.symbols[before->second].unit && !tree.symbols[before->second].rotation;
  const SymbolId id = same ? before->second : tree.symbols.add(std::move(symbol));
  tree.symbols[id].declared = false;
  keys_.emplace(id, key);
  entries_[key] = Entry{id, std::nullopt, 0};
  return id;
}

std::optional<SymbolId> Names::find(const NameKey& key) const {
  const auto found = entries_.find(key);
  return found == entries_.end() ? std::nullopt : std::optional(found->second.symbol);
}

bool Names::is_declared(const NameKey& key) const {
  const auto found = entries_.find(key);
  return found != entries_.end() && found->second.directive.has_value();
}

SymbolId Names::declare(ExprTree& tree, const NameKey& key, Symbol symbol, std::size_t directive) {
  symbol.rank = key.rank;
  symbol.per_particle = key.per_particle;
  symbol.declared = true;
  const auto before = declared_before_.find(key);
  if (before != declared_before_.end()) {
    const Symbol& known = tree.symbols[before->second];
    if (known.symmetric == symbol.symmetric && known.unit == symbol.unit &&
        known.rotation == symbol.rotation) {
      tree.symbols[before->second].declared = true;
      entries_[key] = Entry{before->second, directive, depth_};
      return before->second;
    }
  }
  // What a directive alone spoke of before (`small x`, then `scalar x`) is the same symbol.
  const auto entry = entries_.find(key);
  const bool plain = !symbol.symmetric && !symbol.unit && !symbol.rotation;
  const bool met = plain && entry != entries_.end() && !entry->second.directive &&
                   !ever_seen_.contains(entry->second.symbol) && before == declared_before_.end();
  const SymbolId id = met ? entry->second.symbol : tree.symbols.add(std::move(symbol));
  tree.symbols[id].declared = true;
  declared_before_[key] = id;
  keys_.emplace(id, key);
  entries_[key] = Entry{id, directive, depth_};
  return id;
}

void Names::declare_particles(const std::string& letter, std::size_t directive) {
  particle_letters_[letter] = ParticleLetter{directive, depth_};
}

bool Names::is_particle_letter(const std::string& letter) {
  const auto found = particle_letters_.find(letter);
  if (found == particle_letters_.end()) return sightings.summed_greek.contains(letter);
  mark_used(found->second.directive);
  return true;
}

void Names::define(NamedDefinition definition) {
  definition.depth = definition.origin.directive ? depth_ : 0;
  std::erase_if(definitions_, [&](const NamedDefinition& old) {
    return old.definition.symbol == definition.definition.symbol;
  });
  definitions_.push_back(std::move(definition));
}

void Names::assume(NamedAssumption assumption) {
  assumption.depth = depth_;
  assumptions_.push_back(std::move(assumption));
}

const NamedDefinition* Names::definition_of(SymbolId symbol) const {
  const auto found =
      std::find_if(definitions_.begin(), definitions_.end(),
                   [&](const NamedDefinition& entry) { return entry.definition.symbol == symbol; });
  return found == definitions_.end() ? nullptr : &*found;
}

void Names::forget_definition(SymbolId symbol) {
  std::erase_if(definitions_,
                [&](const NamedDefinition& entry) { return entry.definition.symbol == symbol; });
}

void Names::mean_for_all(SymbolTable& symbols, SymbolId symbol) {
  symbols[symbol].for_all = true;
  for_all_.emplace_back(symbol, depth_);
}

void Names::open_section(SymbolTable& symbols, int level) {
  const auto closed = [&](const auto& entry) { return entry.depth >= level; };
  while (!frames_.empty() && closed(frames_.back())) {
    restore(before_frames_.back());
    before_frames_.pop_back();
    frames_.pop_back();
  }
  std::erase_if(entries_, [&](const auto& entry) { return entry.second.directive && closed(entry.second); });
  std::erase_if(particle_letters_, [&](const auto& entry) { return closed(entry.second); });
  std::erase_if(definitions_,
                [&](const NamedDefinition& entry) { return entry.origin.directive && closed(entry); });
  std::erase_if(assumptions_, closed);
  std::erase_if(constants_, closed);
  std::erase_if(variables_, [&](const auto& entry) { return entry.second >= level; });
  for (const auto& [symbol, depth] : for_all_) symbols[symbol].for_all = false;
  std::erase_if(for_all_, [&](const auto& entry) { return entry.second >= level; });
  for (const auto& [symbol, depth] : for_all_) symbols[symbol].for_all = true;
  std::erase_if(small_, closed);
  std::erase_if(of_other_order_, [&](const auto& entry) { return entry.second >= level; });
  std::erase_if(unread_, closed);
  std::erase_if(seen_, [&](const auto& entry) { return entry.second >= level; });
  depth_ = level;
}

bool Names::is_made_in_frame(const NamedDefinition& definition) const {
  if (before_frames_.empty() || definition.origin.directive) return false;
  const std::vector<NamedDefinition>& before = before_frames_.back().definitions;
  return std::none_of(before.begin(), before.end(), [&](const NamedDefinition& old) {
    return old.definition.symbol == definition.definition.symbol && old.origin.text == definition.origin.text;
  });
}

void Names::restore(Scene scene) {
  for (NamedDefinition& later : definitions_) {
    if (!is_made_in_frame(later)) continue;
    std::erase_if(scene.definitions, [&](const NamedDefinition& old) {
      return old.definition.symbol == later.definition.symbol;
    });
    scene.definitions.push_back(std::move(later));
  }
  definitions_ = std::move(scene.definitions);
  assumptions_ = std::move(scene.assumptions);
}

void Names::forget(std::size_t directive) {
  const auto brought = [&](const auto& entry) { return entry.origin.directive == directive; };
  std::erase_if(entries_, [&](const auto& entry) { return entry.second.directive == directive; });
  std::erase_if(definitions_, brought);
  std::erase_if(assumptions_, brought);
  std::erase_if(unread_, [&](const UnreadAssumption& each) { return each.directive == directive; });
  for (Scene& scene : before_frames_) {
    std::erase_if(scene.definitions, brought);
    std::erase_if(scene.assumptions, brought);
  }
}

void Names::declare_constant(SymbolId symbol, std::size_t directive) {
  constants_.push_back({symbol, directive, depth_, frames_.size()});
}

bool Names::is_declared_constant(SymbolId symbol) const {
  return std::any_of(constants_.begin(), constants_.end(),
                     [&](const Constant& each) { return each.symbol == symbol; });
}

void Names::withdraw_constant(SymbolId symbol) {
  std::erase_if(constants_, [&](const Constant& each) { return each.symbol == symbol; });
}

bool Names::is_of_other_order(SymbolId small) const {
  return std::any_of(of_other_order_.begin(), of_other_order_.end(),
                     [&](const auto& each) { return each.first == small; });
}

void Names::note_unread(UnreadAssumption unread) {
  unread.depth = depth_;
  unread_.push_back(std::move(unread));
}

void Names::declare_frame(Frame frame, Scene before) {
  frame.depth = depth_;
  frames_.push_back(std::move(frame));
  before_frames_.push_back(std::move(before));
}

void Names::withdraw_frame() {
  frames_.pop_back();
  before_frames_.pop_back();
}

void Names::declare_small(SmallQuantity small) {
  small.depth = depth_;
  small_.push_back(std::move(small));
}

bool Names::is_small_scalar(const ExprTree& tree, const std::string& base) const {
  const auto symbol = find({base, 0, false});
  return symbol && std::any_of(small_.begin(), small_.end(), [&](const SmallQuantity& small) {
           return tree[small.quantity].op == Op::symbol && tree[small.quantity].symbol == *symbol;
         });
}

const NameKey* Names::key_of(SymbolId symbol) const {
  const auto found = keys_.find(symbol);
  return found == keys_.end() ? nullptr : &found->second;
}

Dependence Names::dependence(const ExprTree& tree, SymbolId symbol, By by) {
  Dependence result = change_of(tree, symbol, by);
  const NamedDefinition* named = definition_of(symbol);
  if (named != nullptr && named->definition.by_square && named->definition.particle == no_particle)
    result.square = tree.children(named->definition.body)[0];
  return result;
}

Dependence Names::change_of(const ExprTree& tree, SymbolId symbol, By by) {
  using Kind = Dependence::Kind;
  if (by == By::small) return {};  // what does not change in time can be small
  const SymbolId base = base_of(tree.symbols, symbol);
  const NameKey* base_key = key_of(base);
  if (tree.symbols[base].unit_of_measure) return {Kind::constant};
  for (const Constant& constant : constants_) {
    const NameKey* own = key_of(constant.symbol);
    const bool same = constant.symbol == base || (own != nullptr && base_key != nullptr && *own == *base_key);
    if (!same) continue;
    // A vector or tensor that does not change along fixed axes does along turning ones.
    const bool turns = base_key != nullptr && base_key->rank > 0 && !is_principal_value(tree.symbols, base);
    if (turns && by == By::time && constant.frames < frames_.size()) continue;
    mark_used(constant.directive);
    return {Kind::constant};
  }
  const NameKey* key = key_of(symbol);
  if (key == nullptr || key->per_particle || definition_of(symbol) != nullptr) return {};
  if (*key == NameKey{"\\pi", 0, false} && !is_declared(*key)) return {Kind::constant};
  const bool time = *key == NameKey{"t", 0, false};
  if (time) return {by == By::time ? Kind::variable : Kind::constant};
  if (by != By::space) return {};
  if (key->rank == 1 && (key->base == "r" || key->base == "x")) return {Kind::variable};
  if (key->rank != 0) return {};
  if (key->base == "x" || key->base == "y" || key->base == "z")
    return {Kind::variable, static_cast<std::uint8_t>(key->base[0] - 'x' + 1)};
  return {};
}

bool Names::is_principal_value(const SymbolTable& symbols, SymbolId symbol) const {
  const NameKey* key = key_of(base_of(symbols, symbol));
  return key != nullptr && key->rank == 1 && sightings.diagonal.contains(key->base);
}

bool Names::is_field(const ExprTree& tree, SymbolId symbol) const {
  const auto& derivation = tree.symbols[symbol].derivation;
  if (derivation && derivation->space > 0) return true;
  const SymbolId base = derivation ? derivation->base : symbol;
  const NameKey* key = key_of(base);
  if (key == nullptr || key->per_particle) return false;
  const std::pair face{key->base, key->rank > 0};
  if (is_differentiated_by_place(*key) || sightings.partial_rates.contains(face)) return true;
  const NamedDefinition* named = definition_of(base);
  if (named == nullptr) return false;
  const std::vector<SymbolId> inside = symbols_in(tree, named->definition.body);
  return std::any_of(inside.begin(), inside.end(), [&](SymbolId each) {
    const auto& by = tree.symbols[each].derivation;
    return by && by->space > 0;
  });
}

/// The Lagrangian L is not the vector **L**: of one letter, numbers and vectors are told apart.
bool Names::is_differentiated_by_place(const NameKey& key) const {
  if (sightings.fields.contains({key.base, key.rank > 0})) return true;
  return key.rank > 0 && is_plain(key) && sightings.fields.contains({key.base, false});
}

bool Names::is_free_variable(const ExprTree& tree, SymbolId symbol, By by) {
  if (dependence(tree, symbol, by).kind != Dependence::Kind::variable) return false;
  const NameKey* key = key_of(symbol);
  return by == By::time || (sightings.places && key != nullptr && !sightings.rates.contains(*key));
}

bool Names::knows_change(const ExprTree& tree, SymbolId symbol, By by) const {
  const SymbolId base = base_of(tree.symbols, symbol);
  if (tree.symbols[base].unit_of_measure) return true;
  if (definition_of(base) != nullptr || definition_of(symbol) != nullptr) return true;
  const auto is_it = [&](const auto& entry) { return entry.first == base; };
  if (std::any_of(variables_.begin(), variables_.end(), is_it)) return true;
  const auto constant = [&](const Constant& entry) { return entry.symbol == base; };
  if (std::any_of(constants_.begin(), constants_.end(), constant)) return true;
  const NameKey* key = key_of(base);
  if (key == nullptr || by == By::small) return true;
  if (by == By::space) return is_differentiated_by_place(*key);
  if (sightings.rates.contains(*key)) return true;
  const bool principal_values = key->rank == 1 && sightings.diagonal.contains(key->base);
  return principal_values && sightings.rates.contains({key->base, 2, key->per_particle});
}

void Names::mark_used(std::size_t directive) { used_.insert(directive); }

std::vector<std::string> Names::known_names(const ExprTree& tree) const {
  std::vector<std::string> names;
  for (const auto& [key, entry] : entries_) {
    const bool known = entry.directive.has_value() || definition_of(entry.symbol) != nullptr ||
                       seen_in_equation(entry.symbol);
    if (known) names.push_back(tree.symbols[entry.symbol].name);
  }
  return names;
}

}  // namespace rigor
