// SPDX-License-Identifier: GPL-3.0-or-later
// What the letters of one file stand for: which symbols were seen, declared, defined and assumed, and where
// each holds.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "elaborate/evidence/evidence.h"
#include "expr/calculus/differentiate.h"
#include "expr/statement/statement.h"
#include "latex/token/syntax.h"

namespace rigor {

/// A symbol's name apart from indices: `r`, `T_{\text{rot}}`, `\hat{n}`. `A_i` and `\mathbf{A}` share one
/// key, `I` and `I_{ij}` do not.
struct NameKey {
  std::string base;
  int rank = 0;
  bool per_particle = false;
  friend auto operator<=>(const NameKey&, const NameKey&) = default;
};

/// How a symbol was written somewhere in the file.
struct Sightings {
  std::set<std::pair<std::string, bool>> bold;    // base, per particle: `\mathbf{A}` without a letter index
  std::set<std::string> bold_indexed;             // `\boldsymbol\omega_i`
  std::set<NameKey> indexed;                      // rank = number of letter indices: `I_{ij}`
  std::set<std::string> summed_greek;             // `\alpha` of some \sum_\alpha
  std::set<std::string> crossed;                  // bases of bold factors of a cross product
  std::set<NameKey> rates;                        // a time derivative of it is written
  std::set<std::pair<std::string, bool>> fields;  // that a ∂ or ∇ stands directly before: base, vector?
  std::set<std::pair<std::string, bool>> partial_rates;  // that a ∂/∂t stands directly before
  bool places = false;                                   // some derivative by place is written
  std::set<std::string> mixed_axes;                      // `\lambda_{i'j}`: two indices, one of them primed
  std::set<std::string>
      diagonal;            // X where `X_i = X_{ii}` or `X_{ij} = X_i\delta_{ij}` is said: principal values
  bool hatted_ij = false;  // \hat\imath or \hat\jmath: then \hat k is an axis as well
};

/// A directive or an equation that brought something into scope.
struct Origin {
  std::string text;                        // as it is named in a verdict's `uses`: `definition (8)`
  std::string section;                     // of an equation
  std::optional<std::size_t> directive{};  // number of the directive, to mark it as used
  std::string expanded = {};               // of an assumption: `text` without macros of the notes
  std::size_t place = 0;                   // of an equation: its section, as `Sections` counts them
  std::size_t event = 0;                   // and its display
  bool conditional = false;                // it stands behind "if", "suppose", "for small …"
  bool on_its_line = false;                // its own line says when: `y = x \quad (x < 1)`
  bool of_a_case = false;                  // its heading is of a special case
};

struct NamedDefinition {
  Definition definition;
  Origin origin;
  int depth = 0;
  bool at_instant = false;  // said of components along other axes: it holds now, its derivatives do not
};

struct NamedAssumption {
  Equation equation;
  Origin origin;
  int depth = 0;
  bool at_instant = false;            // as above
  std::optional<SymbolId> rate_of{};  // all it says is how this changes: nothing, where nothing else has it
  bool without_sample = false;  // nothing was found that satisfies it: what is proved from it proves nothing
};

/// An assumption that could not be read: what it would say of its letters is not known.
struct UnreadAssumption {
  std::string text;
  std::set<std::string> letters;
  std::size_t directive = 0;
  int depth = 0;
};

/// `frame rot rotates with \boldsymbol{\omega} in in`: components are along the axes of `rotating`; the
/// rotation carries those axes' components to `fixed` ones.
struct Frame {
  std::string rotating;
  std::string fixed;
  SymbolId rotation{};
  ExprId angular_velocity{};
  std::size_t directive = 0;
  int depth = 0;
};

/// A symbol, or one component of it, that is small: this is 0 to zeroth order.
struct SmallQuantity {
  ExprId quantity{};
  std::vector<ParticleId> particles = {};  // free
  std::size_t directive = 0;
  int depth = 0;
};

class Names {
 public:
  Sightings sightings;
  Evidence evidence;  // of the section at hand and of those around it

  /// The symbol of this key, made at first sight. Marks the directive that declared it as used.
  SymbolId resolve(ExprTree& tree, const NameKey& key, const std::string& name, Span span);
  /// The symbol if it exists.
  [[nodiscard]] std::optional<SymbolId> find(const NameKey& key) const;
  [[nodiscard]] bool is_declared(const NameKey& key) const;
  /// Nothing for symbols that no name of the notes stands for, derivatives among them.
  [[nodiscard]] const NameKey* key_of(SymbolId symbol) const;

  /// Declares kind and properties from here to the end of the section; an earlier symbol of this key is
  /// forgotten, unless no equation has it yet.
  SymbolId declare(ExprTree& tree, const NameKey& key, Symbol symbol, std::size_t directive);
  void declare_particles(const std::string& letter, std::size_t directive);
  [[nodiscard]] bool is_particle_letter(const std::string& letter);
  /// The same without marking the directive as used.
  [[nodiscard]] bool labels_particles(const std::string& letter) const {
    return particle_letters_.contains(letter) || sightings.summed_greek.contains(letter);
  }

  void define(NamedDefinition definition);
  void assume(NamedAssumption assumption);
  /// What was defined and assumed, to be taken back by `restore` (but for what equations define since).
  struct Scene {
    std::vector<NamedDefinition> definitions;
    std::vector<NamedAssumption> assumptions;
  };
  [[nodiscard]] Scene scene() const { return {definitions_, assumptions_}; }
  void restore(Scene scene);
  void replace(Scene scene) {
    definitions_ = std::move(scene.definitions);
    assumptions_ = std::move(scene.assumptions);
  }

  /// What a directive declared, defined and assumed holds no longer.
  void forget(std::size_t directive);

  struct Constant {
    SymbolId symbol{};
    std::size_t directive = 0;
    int depth = 0;
    std::size_t frames = 0;  // in force where it stands
  };
  void declare_constant(SymbolId symbol, std::size_t directive);
  [[nodiscard]] const std::vector<Constant>& constants() const { return constants_; }
  [[nodiscard]] bool is_declared_constant(SymbolId symbol) const;
  /// What else is said of it makes it change: then nothing is known of how.
  void withdraw_constant(SymbolId symbol);
  /// Statements are meant for all values of the symbol, to the end of the section.
  void mean_for_all(SymbolTable& symbols, SymbolId symbol);
  void declare_variable(SymbolId symbol) { variables_.emplace_back(symbol, depth_); }
  /// How a symbol (or a derivative) changes; marks the directive that says so as used. What nothing is said
  /// of varies.
  [[nodiscard]] Dependence dependence(const ExprTree& tree, SymbolId symbol, By by);
  /// Does anything say how a symbol changes: a declaration, a definition, a derivative that is written?
  [[nodiscard]] bool knows_change(const ExprTree& tree, SymbolId symbol, By by) const;

  /// From here on components are along turning axes; `before` is what held without them, and holds again
  /// behind the section.
  void declare_frame(Frame frame, Scene before);
  /// By an equation, and not before the frame in force.
  [[nodiscard]] bool is_made_in_frame(const NamedDefinition& definition) const;
  /// I_i where `I_{ij} = I_i\delta_{ij}` is said: three numbers that belong to axes, no vector.
  [[nodiscard]] bool is_principal_value(const SymbolTable& symbols, SymbolId symbol) const;
  /// Does a ∂ or ∇ stand before it, or in what defines it, somewhere in the file?
  [[nodiscard]] bool is_field(const ExprTree& tree, SymbolId symbol) const;
  /// Is it the time, or the place where the notes speak of places and not of a body that moves?
  [[nodiscard]] bool is_free_variable(const ExprTree& tree, SymbolId symbol, By by);
  /// As if the last frame had not been declared; its definitions stay.
  void withdraw_frame();
  [[nodiscard]] const std::vector<Frame>& frames() const { return frames_; }
  void declare_small(SmallQuantity small);
  [[nodiscard]] const std::vector<SmallQuantity>& small() const { return small_; }
  /// A quantity that is declared small, and is of another order by what else is said of it.
  void note_other_order(SymbolId small) { of_other_order_.emplace_back(small, depth_); }
  [[nodiscard]] bool is_of_other_order(SymbolId small) const;
  /// Is the scalar of this name small by a directive?
  [[nodiscard]] bool is_small_scalar(const ExprTree& tree, const std::string& base) const;
  /// The rotation whose first axis is primed, if primed axes were spoken of.
  [[nodiscard]] std::optional<SymbolId> primed_axes() const { return primed_axes_; }
  void set_primed_axes(SymbolId rotation) { primed_axes_ = rotation; }

  void note_unread(UnreadAssumption unread);
  [[nodiscard]] const std::vector<UnreadAssumption>& unread() const { return unread_; }
  void doubt_last_assumption() { assumptions_.back().without_sample = true; }
  /// `vector A`: the plain letter is the vector itself, not its length.
  void declare_plain(const NameKey& key) { plain_.insert(key); }
  [[nodiscard]] bool is_plain(const NameKey& key) const { return plain_.contains(key) && is_declared(key); }
  [[nodiscard]] const std::vector<NamedDefinition>& definitions() const { return definitions_; }
  [[nodiscard]] const std::vector<NamedAssumption>& assumptions() const { return assumptions_; }
  [[nodiscard]] const NamedDefinition* definition_of(SymbolId symbol) const;
  void forget_definition(SymbolId symbol);

  /// A heading of this level closes all sections of its level and below, with what their directives declared.
  void open_section(SymbolTable& symbols, int level);

  /// Was the symbol part of an equation before, in this section or one around it? (A declaration alone is
  /// not.)
  [[nodiscard]] bool seen_in_equation(SymbolId symbol) const { return seen_.contains(symbol); }
  void mark_seen(SymbolId symbol) {
    seen_.emplace(symbol, depth_);
    ever_seen_.insert(symbol);
  }

  void mark_used(std::size_t directive);
  void mark_unused(std::size_t directive) { used_.erase(directive); }
  [[nodiscard]] bool is_used(std::size_t directive) const { return used_.contains(directive); }
  /// The names in scope, for suggestions.
  [[nodiscard]] std::vector<std::string> known_names(const ExprTree& tree) const;

 private:
  [[nodiscard]] bool is_differentiated_by_place(const NameKey& key) const;
  [[nodiscard]] Dependence change_of(const ExprTree& tree, SymbolId symbol, By by);
  struct Entry {
    SymbolId symbol{};
    std::optional<std::size_t> directive;
    int depth = 0;
  };
  struct ParticleLetter {
    std::size_t directive;
    int depth;
  };

  std::map<NameKey, Entry> entries_;
  std::map<SymbolId, NameKey> keys_;
  std::vector<Constant> constants_;
  std::vector<std::pair<SymbolId, int>> variables_;  // and the depth
  std::vector<std::pair<SymbolId, int>> for_all_;    // the same
  std::vector<Frame> frames_;
  std::vector<Scene> before_frames_;  // one for each
  std::vector<SmallQuantity> small_;
  std::vector<std::pair<SymbolId, int>> of_other_order_;  // and the depth
  std::vector<UnreadAssumption> unread_;
  std::optional<SymbolId> primed_axes_;
  std::map<NameKey, SymbolId>
      declared_before_;  // a declaration that says the same again means the same symbol
  std::map<std::string, ParticleLetter> particle_letters_;
  std::vector<NamedDefinition> definitions_;
  std::vector<NamedAssumption> assumptions_;
  std::map<SymbolId, int> seen_;  // the depth of the section that saw it first
  std::set<SymbolId> ever_seen_;  // in an equation of any section
  std::set<std::size_t> used_;
  std::set<NameKey> plain_;
  int depth_ = 0;
};

}  // namespace rigor
