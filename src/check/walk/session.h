// SPDX-License-Identifier: GPL-3.0-or-later
// The walk through one file's notes: what holds where, and a verdict for every step.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "check/dimension/dimension_record.h"
#include "check/doubt/borrowed.h"
#include "check/event/notes.h"
#include "check/form/form_record.h"
#include "check/lint/lint.h"
#include "check/repair/chain_ends.h"
#include "check/verdict/chain_reading.h"
#include "check/verdict/judge.h"
#include "check/walk/check.h"

namespace rigor {

class Session {
 public:
  /// All are kept by reference.
  Session(const SourceMap& sources, const Notes& notes, FileReport& report, const CheckOptions& options);

  void run();
  /// The tree of all expressions, when the walk is over.
  [[nodiscard]] ExprTree&& take_tree() { return std::move(tree_); }

 private:
  /// How a chain's statements enter: as claims of the notes, or by a directive.
  enum class Role : std::uint8_t { display, claim, given, let };
  struct Context {
    Role role = Role::display;
    bool first_order = false;        // `=` means ≈
    std::optional<Span> place = {};  // where steps are reported, if not where they stand
    std::size_t directive = 0;
  };

  void sight_all();
  void follow(const Heading& heading);
  void follow(const PlacedDirective& placed);
  void follow(const ParsedDisplay& display);
  void follow_where(const Directive& directive, Context context);
  void declare(const Directive& directive);
  void declare_for_now(const Directive& directive, SyntaxId id);
  void declare_symbol(const Directive& directive, SyntaxId id);
  void declare_rotation(const Directive& directive, const NameKey& key, SymbolId symbol);
  void declare_basis(const Directive& directive, SyntaxId id);
  void declare_elaborated(const Directive& directive, SyntaxId id);  // constant, variable, small, frame
  std::optional<Typed> read_declared(SyntaxId id);
  void declare_read(const Directive& directive, const Typed& typed);
  void declare_small(const Directive& directive, const Typed& typed);
  void declare_constant(const Directive& directive, const Typed& typed);
  void assume_rates_vanish(const Directive& directive, SymbolId symbol);
  void check_constant(const Directive& directive);
  void imply_primed_axes();
  ExprId whole_symbol(const Typed& typed);
  void follow_chains(const ParsedDisplay& display);
  bool take_first_order();
  void end_statement(Span span);
  void end_section();
  void forget_wheres();
  bool is_for_now(const Context& context) const;
  void excuse_refuted(const ParsedChain& parsed, std::size_t first_step);
  void suggest_repairs(const ParsedChain& parsed, const Context& context, std::size_t first_step);
  std::vector<TokenView> sides_near(const ParsedChain& parsed) const;
  void report_unmet(const Directive& expectation, Span statement);
  void report_lints();
  void report_unused();
  void heed_conditions(const ParsedDisplay& display, std::size_t first_step);

  void chain(const ParsedChain& parsed, const Context& context);
  [[nodiscard]] bool decides() const { return options_.forms == nullptr || options_.forms->decides(); }
  [[nodiscard]] bool may_redefine(const Typed& left, const Typed& right);
  using Side = ChainReading::Side;
  bool reads(const ParsedChain& parsed);
  void chain_as_read(const ParsedChain& parsed, const Context& context);
  bool is_nonsense(const ParsedChain& parsed, const std::vector<SyntaxId>& sides);
  ParsedChain sensible_readings(const ParsedChain& parsed);
  bool decide_in_all_readings(const ParsedChain& parsed, std::size_t which, const Claim& claim, Step& step);
  bool would_define(const Typed& left, const Typed& right);
  Link across(const ParsedChain& parsed, std::size_t left, std::size_t right, ChainReading& reading);
  void explain_slips(const ParsedChain& parsed, std::size_t first_step, ChainReading& reading,
                     const Context& context);
  void explain_slip(const ParsedChain& parsed, std::size_t first_step, std::size_t which,
                    const ChainPlace& place);
  void refute_by_digits(const ParsedChain& parsed, const Claim& claim, Judgement& judgement);
  bool replay_by_digits(const Claim& claim, Step& step);
  [[nodiscard]] std::vector<const ParsedChain*> alternatives_with(const ParsedChain& parsed) const;
  bool proves_alternatives(const ParsedChain& parsed, Step& step);
  [[nodiscard]] bool may_be_large(const std::string& letter) const;
  struct Coefficient {
    int order = 0;
    Equation equation;
  };
  std::optional<Equation> with_letter_open(Equation equation, SymbolId letter);
  std::optional<std::vector<Coefficient>> coefficients(const Equation& equation, SymbolId letter, int power);
  bool decides_up_to_order(const ParsedChain& parsed, std::size_t which, const Context& context, Step& step);
  bool proves_with_dots_on_vectors(const ParsedChain& parsed, std::size_t which, const Claim& claim,
                                   Step& step);
  void step(const ParsedChain& parsed, std::size_t which, ChainReading& reading, const Context& context);
  void decide_step(const ParsedChain& parsed, std::size_t which, ChainReading& reading,
                   const Context& context, Step& step);
  bool defines(const ParsedChain& parsed, const Side& left, const Side& right, const Context& context,
               Step& step);
  bool redefines(const Judgement& judgement, const ParsedChain& parsed, const Typed& left, const Typed& right,
                 const Context& context, Step& step);
  [[nodiscard]] bool concludes(const NamedDefinition& earlier) const;
  [[nodiscard]] bool is_denied(const Context& context) const;
  bool takes_apart(const ParsedChain& parsed, const Typed& left, const Typed& right, const Context& context,
                   Step& step);
  std::vector<Label> earlier_place(const NamedDefinition& earlier) const;
  void add_definition(const Typed& left, const Typed& right, const ParsedChain& parsed,
                      const Context& context, Step& step);
  void add_assumption(const Typed& left, const Typed& right, const Equation& equation,
                      const ParsedChain& parsed, std::size_t which, const Context& context, Step& step);
  [[nodiscard]] Standpoint standpoint(const ParsedChain& parsed);
  void add_said(const SaidInLine& said, const ParsedChain& parsed, Standpoint& at);
  void declare_use(const Directive& directive);
  void heed(const ParsedChain& parsed, std::size_t which, const Claim& claim, const Side& left,
            const Side& right, const Context& context, Judgement& judgement);
  std::optional<std::pair<std::string, std::string>> doubt_left(const ParsedChain& parsed, std::size_t which,
                                                                const Claim& claim, const Context& context);
  bool speaks_of_integration() const;
  [[nodiscard]] bool is_late_definition(const Typed& left, const Typed& right) const;
  std::optional<std::string> letter_borrowed_for(const ParsedChain& parsed, std::size_t which,
                                                 const Claim& claim);
  [[nodiscard]] bool is_conditional() const;
  [[nodiscard]] bool is_of_a_case() const;
  [[nodiscard]] bool is_assumed_about(SymbolId symbol) const;
  std::vector<SymbolId> said_anew();
  void heed_proof(const ParsedChain& parsed, const Claim& claim, Judgement& judgement);
  [[nodiscard]] bool is_alternative(const ParsedChain& parsed) const;
  [[nodiscard]] std::vector<const ParsedChain*> conditions_beside(const ParsedChain& parsed) const;
  [[nodiscard]] bool is_condition_beside(const ParsedChain& parsed) const;
  bool is_in_doubt() const;
  bool find_sample();  // of all assumptions in force
  static Diagnostic no_sample(Span span);
  static Diagnostic changing_constant(Span span, const std::string& name);
  void mark_all_given();
  void compare_orders(const Equation& equation, Span span, Diagnostics& diagnostics);
  bool is_rule(const Typed& left, const Typed& right);
  bool is_determined(SymbolId symbol) const;
  void assume_rules_above(SymbolId symbol);
  std::optional<Definition> as_square(const Typed& left, const Typed& right);
  bool stands_in_brackets(SyntaxId power) const;
  RecordedStep* recorded_of(const Step& step);
  void accept(Judgement judgement, Step& step);
  bool join_component_rules(const Typed& left);  // true if it made one
  bool is_circular(const Typed& left, const Typed& right) const;
  std::optional<Definition> as_definition(const Typed& left, const Typed& right);
  void mark_seen(const std::vector<Side>& sides);
  void declare_units(const Directive& directive);
  void record_dimensions(const ParsedChain& parsed, ChainReading& reading, const Context& context,
                         std::size_t first_step);
  void finish_dimensions();
  Step new_step(const ParsedChain& parsed, std::size_t which, const Context& context) const;
  void add(Step step);
  [[nodiscard]] std::string written(Span span) const;  // blanks folded
  [[nodiscard]] std::string place_name(const ParsedChain& parsed) const;

  const SourceMap& sources_;
  const Notes& notes_;
  FileReport& report_;
  const CheckOptions& options_;
  ExprTree tree_;
  Names names_;
  std::string section_;
  DimensionRecorder dimensions_{tree_, names_};
  std::vector<const Directive*> directives_;
  std::vector<std::pair<std::size_t, SymbolId>> constants_;  // directive, symbol
  std::vector<std::pair<std::size_t, SymbolId>> for_all_;    // the same
  Sample sample_;                                            // the last one that met the assumptions in force
  std::map<SymbolId, bool> mirrored_;                        // declared polar (true) or axial
  std::size_t event_ = 0;                                    // that is followed
  std::vector<UseDirective> uses_;
  std::vector<Fact> laws_;                                 // and definitions behind their first use
  std::vector<std::pair<std::size_t, Span>> unread_rows_;  // where, and what: relations such as `\perp`
  std::vector<StatedEquation> stated_;                     // for the lints
  // for the next statement; forgotten when it is over, whatever became of it
  std::vector<const Directive*> expectations_;
  const Directive* skip_ = nullptr;
  const Directive* first_order_ = nullptr;
  std::vector<std::size_t> wheres_;          // directives
  std::vector<const Directive*> in_force_;   // expectations of the chain at hand
  std::vector<const Directive*> unmatched_;  // no statement came before the end of their section
};

}  // namespace rigor
