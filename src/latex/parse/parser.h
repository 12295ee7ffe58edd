// SPDX-License-Identifier: GPL-3.0-or-later
// The recursive descent behind parse_side. Every method reads a stretch of tokens whose end is already known:
// brackets are matched before their contents are read, so that a bracket left open spoils one node and not
// the rest. Each takes the tokens that it puts into the tree to the account; what nobody takes is reported.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "latex/token/accounting.h"
#include "latex/token/choices.h"
#include "latex/token/syntax.h"
#include "latex/token/tokens.h"
#include "latex/token/vocabulary.h"

namespace rigor {

class Parser {
 public:
  /// `side`: where the tokens of the side stand, whose braces a second reading may lift; or nothing.
  Parser(SyntaxTree& tree, SideAccount& account, int depth, Choices* choices, std::span<Token> side)
      : tree_(tree), account_(account), depth_(depth), choices_(choices), side_(side) {}

  /// A sum of terms; `place` is where to point if there is nothing.
  SyntaxId expression(TokenView tokens, Span place);

  /// Where reading is, in the stretch at hand.
  struct Cursor {
    TokenView tokens;
    std::size_t at = 0;
    [[nodiscard]] bool done() const { return at >= tokens.size(); }
    [[nodiscard]] const Token& token() const { return tokens[at]; }
    void skip_spacing();
  };

 private:
  SyntaxId term(Cursor& cursor);
  void divide_by_all_behind(TokenView tokens, std::vector<SyntaxChild>& factors);
  SyntaxId missing_operand(Joint joint, Span place, std::span<const SyntaxChild> before);
  SyntaxId factor(Cursor& cursor);
  SyntaxId signed_factor(Cursor& cursor);
  SyntaxId primary(Cursor& cursor);
  SyntaxId scripts(Cursor& cursor, SyntaxId base);
  std::optional<std::vector<WrittenVariable>> read_raised_indices(TokenView content);
  SyntaxId act_by(Cursor& cursor, std::vector<WrittenVariable> by, Span span);
  SyntaxId raised_behind(SyntaxId base);
  SyntaxId add_primes(SyntaxId base, std::uint8_t primes, Span place);
  SyntaxId add_indices(SyntaxId base, TokenView content, Span place);
  std::optional<SyntaxId> add_upper_label(SyntaxId base, TokenView content, Span place);
  SyntaxId exponent(SyntaxId base, TokenView content, Span place);
  static bool starts_sign(const Cursor& cursor);

  // parser_braces.cpp
  bool lifts_braces(const Cursor& cursor);
  bool lifts_braces_of_argument(const Cursor& cursor, std::size_t begin);
  bool lifts(const Cursor& cursor, std::size_t begin);
  SyntaxId stacked_powers(Span span);

  // parser_brackets.cpp
  SyntaxId bracketed(Cursor& cursor);
  [[nodiscard]] bool holds_one_letter(SyntaxId group) const;
  [[nodiscard]] bool is_bold_letter(SyntaxId group) const;
  SyntaxId bars(Cursor& cursor);
  std::size_t outer_bar(const Cursor& cursor, std::size_t close);
  std::optional<SyntaxId> reversed_interval(Cursor& cursor);
  SyntaxId in_brackets(TokenView content, Span span);
  SyntaxId bracket_contents(TokenView content, Span span, std::uint32_t pair);
  SyntaxId environment(Cursor& cursor);
  void read_between(TokenView body, std::span<const TokenView> cells);
  SyntaxId cases(TokenView body, Span span);
  SyntaxId matrix(TokenView body, Span span, bool determinant);

  // parser_names.cpp
  SyntaxId letter(Cursor& cursor);
  SyntaxId changed(Cursor& cursor);
  static bool starts_accent(TokenView tokens, std::size_t at);
  SyntaxId nested_accent(Cursor& cursor);
  SyntaxId styled(Cursor& cursor, Style style);
  SyntaxId switched(Cursor& cursor, Style style, std::size_t at);
  SyntaxId restyle(SyntaxId inner, Style style, Span span);
  SyntaxId number(Cursor& cursor);
  SyntaxId asked(Cursor& cursor);  // `?`
  SyntaxId box_operator(Cursor& cursor, SyntaxId box, Span place);

  // parser_struck.cpp
  SyntaxId struck(Cursor& cursor);     // \cancel
  SyntaxId struck_to(Cursor& cursor);  // \cancelto

  // parser_states.cpp
  std::optional<SyntaxId> state_bracket(Cursor& cursor);     // \ket, \langle
  std::optional<SyntaxId> pair_in_brackets(Cursor& cursor);  // \comm{A}{B}
  std::optional<SyntaxId> expectation(Cursor& cursor);       // \mathbb E[X]
  SyntaxId deviation(SyntaxId of, Span span);

  // parser_kets.cpp
  SyntaxId state_named(const char* kind, TokenView content, Span span);
  SyntaxId bracket_of_states(TokenView bra, const std::optional<TokenView>& between, TokenView ket,
                             Span span);
  std::optional<SyntaxId> ket(Cursor& cursor);               // |a\rangle
  std::optional<SyntaxId> angles_of_states(Cursor& cursor);  // \langle a|
  std::optional<SyntaxId> named_states(Cursor& cursor);      // \ket{a}, \mel{a}{H}{b}

  // parser_controls.cpp
  SyntaxId control(Cursor& cursor);
  SyntaxId annotated(Cursor& cursor);  // \overset, \stackrel
  SyntaxId braced(Cursor& cursor);     // \underbrace, \overbrace
  SyntaxId fraction(Cursor& cursor);
  SyntaxId root(Cursor& cursor);
  SyntaxId signed_summand(Cursor& cursor);
  SyntaxId big_sum(Cursor& cursor);
  SyntaxId braced_bracket(Cursor& cursor);  // \abs{…}, \norm{…}, \qty(…)

  // parser_partial.cpp
  struct EvaluationBar {
    std::vector<WrittenIndex> indices;  // empty: it does not name a frame
    Span span;
    std::string text;  // of its subscript; empty: it has two limits
    std::optional<std::pair<TokenView, TokenView>> limits = {};
  };
  SyntaxId physics_derivative(Cursor& cursor, bool partial);
  SyntaxId partial(Cursor& cursor);
  static bool shows_arguments(const Cursor& cursor, const std::vector<WrittenVariable>& by);
  bool take_times(TokenView order, std::vector<WrittenVariable>& by);
  std::optional<Obstacle> read_partial_index(TokenView content, std::vector<WrittenVariable>& by);
  std::optional<EvaluationBar> evaluation_bar(Cursor& cursor);
  SyntaxId in_frame(SyntaxId node, bool partial, EvaluationBar bar);

  // parser_derivatives.cpp
  SyntaxId dotted(Cursor& cursor);
  static bool is_derivative(TokenView above, TokenView below);
  SyntaxId derivative_fraction(Cursor& cursor, TokenView above, TokenView below, Span span);
  std::optional<SyntaxId> slash_derivative(Cursor& cursor);
  std::optional<WrittenDerivative> written_derivative(TokenView above, TokenView below, Obstacle& obstacle);
  std::optional<WrittenDerivative> operator_in(TokenView content);
  SyntaxId bracketed_operator(Cursor& cursor, WrittenDerivative derivative, Span span);
  SyntaxId operate(Cursor& cursor, WrittenDerivative derivative, Span span);
  std::optional<std::vector<WrittenVariable>> variables(TokenView below, bool partial);
  [[nodiscard]] std::optional<WrittenVariable> variable(SyntaxId node) const;
  [[nodiscard]] bool is_one_factor(SyntaxId operand) const;
  [[nodiscard]] bool is_constant(SyntaxId id) const;
  SyntaxId unclear_operand(Span span);

  // parser_units.cpp
  static bool starts_quantity(const Cursor& cursor);
  SyntaxId quantity(Cursor& cursor);
  SyntaxId one_degree(Span span);
  static std::size_t degree_end(const Cursor& cursor);  // `^\circ`
  SyntaxId in_degrees(Cursor& cursor, SyntaxId number, std::size_t end);
  [[nodiscard]] bool takes_unit(SyntaxId id) const;
  [[nodiscard]] bool is_pi(SyntaxId id) const;
  [[nodiscard]] bool has_unit(SyntaxId id) const;
  SyntaxId angstrom(Cursor& cursor);
  std::optional<SyntaxId> unit_fraction(Cursor& cursor, bool spaced);
  std::optional<SyntaxId> unit_behind(Cursor& cursor, SyntaxId before, bool spaced);

  // parser_acting.cpp
  std::optional<SyntaxId> acts(Cursor& cursor);
  SyntaxId lone_differential(Cursor& cursor, std::size_t behind);
  std::optional<SyntaxId> landau(Cursor& cursor, std::size_t end);
  SyntaxId material(Cursor& cursor, TokenView above, TokenView below, Span span);
  std::optional<SyntaxId> slash_material(Cursor& cursor, std::size_t end);
  SyntaxId material_of(SyntaxId operand, Span span);
  SyntaxId field_word(Cursor& cursor, const std::string& word, std::size_t behind);
  SyntaxId words(Cursor& cursor);

  // parser_functions.cpp
  SyntaxId function(Cursor& cursor, std::string_view name, std::size_t behind);
  SyntaxId function_argument(Cursor& cursor, Span place, std::string_view name, std::size_t begin);
  SyntaxId bracket_argument(Cursor& cursor);
  /// What a function is written with, and where its argument begins.
  struct Application {
    std::string_view name;
    std::size_t begin;  // of the function
    std::size_t argument;
  };
  SyntaxId plain_argument(Cursor& cursor, std::string_view name, std::size_t begin);
  bool argument_ends(const Cursor& cursor, const Application& application);
  bool bracket_belongs(const Cursor& cursor, const Application& application);
  bool letter_belongs(const Cursor& cursor, const Application& application, SyntaxId argument);
  SyntaxId with_letter(Cursor& cursor, SyntaxId argument);
  bool power_belongs(const Cursor& cursor, const Application& application);
  SyntaxId unclear_argument(Span span, std::string_view name);
  [[nodiscard]] bool is_rate_or_change(SyntaxId node) const;
  [[nodiscard]] bool is_conjugate(SyntaxId node) const;
  [[nodiscard]] bool is_average(SyntaxId node) const;
  SyntaxId field_function(Cursor& cursor, std::string_view name);

  // parser_integrals.cpp
  /// What the differentials of one integral say.
  struct Measure {
    std::string name;  // `m` or `V`; empty: another one
    std::string text;
    std::optional<Span> span;               // of the last one
    std::optional<SyntaxId> variable = {};  // a plain number
    Measure* outer = nullptr;               // of the integral around this one
    int count = 0;
    std::vector<SyntaxId> behind = {};  // factors behind it, where others stand before it
    bool divides = false;               // `\int y\,dx/x`: what is divided is not clear
  };
  /// What is written at the sign of an integral.
  struct Bounds {
    std::optional<TokenView> lower = {};
    std::optional<TokenView> upper = {};
    std::string region = {};
    bool whole_body = true;
    bool again = false;  // two on one side
  };
  SyntaxId integral(Cursor& cursor);
  Bounds bounds(Cursor& cursor);
  bool read_measure(Cursor& cursor);
  [[nodiscard]] std::optional<SyntaxId> variable_of_measure(SyntaxId node, int order) const;
  bool starts_outer_measure(const Cursor& cursor) const;
  [[nodiscard]] bool has_letter(const std::vector<SyntaxId>& nodes, const WrittenSymbol& symbol) const;
  SyntaxId limit(TokenView tokens, Span place);
  SyntaxId between(SyntaxId value, TokenView lower, TokenView upper, Span span);
  [[nodiscard]] bool ends_at_bar(SyntaxId node) const;
  void put_product_before_bar(std::vector<SyntaxChild>& factors);
  SyntaxId with_measure(TokenView tokens, Span place);
  [[nodiscard]] std::string measure_name(SyntaxId node, int order) const;

  SyntaxId opaque(Span span, std::string message, DiagnosticKind kind = DiagnosticKind::unsupported,
                  std::vector<std::string> help = {});
  /// Reads an inner stretch one level deeper.
  SyntaxId inner(TokenView tokens, Span place);
  /// Is the second reading wanted here? `choice` gives the place and both readings.
  bool takes_second(Choice choice) {
    return choices_ != nullptr && choices_->takes_second(std::move(choice));
  }

  void read(TokenView tokens) { account_.read(tokens); }
  void read_sign(const Cursor& cursor) { account_.read(cursor.tokens.subspan(cursor.at, 1)); }
  /// The tokens from `begin` to where the cursor is.
  void read_since(const Cursor& cursor, std::size_t begin) {
    account_.read(cursor.tokens.subspan(begin, cursor.at - begin));
  }

  SyntaxTree& tree_;
  SideAccount& account_;
  int depth_;
  Choices* choices_;
  std::span<Token> side_;
  const Token* asked_ = nullptr;  // the brace that was asked about last
  Measure* measure_ = nullptr;    // of the integral whose integrand is being read, outside its brackets
};

}  // namespace rigor
