// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/other_reading.h"

#include <fmt/format.h>

#include <array>

#include "algebra/words/operator_question.h"
#include "base/among.h"
#include "base/ascii.h"
#include "check/average/average_value.h"
#include "check/meaning/beyond_reals.h"
#include "check/meaning/both_orders.h"
#include "check/meaning/ordered_product.h"
#include "check/verdict/law_diagnostic.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

OtherReading says(const ExprTree& tree, const std::set<SymbolId>& symbols, std::string message,
                  std::string_view what = "a number") {
  const std::string& first = tree.symbols[*symbols.begin()].name;
  return {std::move(message),
          {fmt::format("`rigor: scalar {}` says that {} {}", first,
                       symbols.size() == 1 ? "it is" : "the first is", what)}};
}

std::string quoted(const ExprTree& tree, const std::set<SymbolId>& symbols) {
  return quoted_names(tree, {symbols.begin(), symbols.end()});
}

/// Letters that stand for numbers beside operators: masses, frequencies, constants.
bool is_usual_number_beside_operators(std::string_view letter) {
  static constexpr auto numbers = std::to_array<std::string_view>(
      {"m",        "M",       "t",      "e",       "c",       "g",         "k",
       "n",        "l",       "s",      "N",       "\\hbar",  "\\omega",   "\\Omega",
       "\\lambda", "\\alpha", "\\beta", "\\gamma", "\\theta", "\\epsilon", "\\delta",
       "\\mu",     "\\nu",    "\\tau",  "\\kappa", "\\eta",   "\\xi",      "\\zeta"});
  return is_one_of(letter, numbers);
}

/// Of these a conjugate is itself.
bool is_usual_real_beside_operators(std::string_view letter) {
  static constexpr auto reals = std::to_array<std::string_view>(
      {"m", "M", "t", "\\hbar", "\\omega", "\\Omega", "\\theta", "k", "n", "N"});
  return is_one_of(letter, reals);
}

/// E of `E_n|n\rangle`, n itself, and angles: beside states they are real numbers.
bool is_usual_real_beside_states(std::string_view letter, const Evidence& evidence) {
  static constexpr auto reals =
      std::to_array<std::string_view>({"E", "\\phi", "\\varphi", "\\vartheta", "\\Delta", "\\Phi"});
  return evidence.states && (is_one_of(letter, reals) || evidence.state_labels.contains(std::string(letter)));
}

/// Beside operators any other letter may be one, too: V of `H = p^2/2m + V`. A proof takes it for a number.
std::optional<OtherReading> beside_operators(const Question& question, const Names& names) {
  const ExprTree& tree = *question.tree;
  const Evidence& evidence = *names.symbols.evidence;
  std::vector<ExprId> roots{question.claim.left, question.claim.right};
  for (const Equation& each : question.assumptions) roots.insert(roots.end(), {each.left, each.right});
  const auto body_of = [&](SymbolId symbol) {
    const Definition* definition = definition_in(question, symbol);
    return definition == nullptr ? std::nullopt : std::optional(definition->body);
  };
  const std::vector<SymbolId> reached = symbols_reached(tree, roots, body_of);
  const bool conjugates = std::ranges::any_of(nodes_below(tree, roots), [&](ExprId id) {
    return tree[id].op == Op::conjugate && has_operators(tree, id);
  });
  std::set<SymbolId> open;
  std::set<SymbolId> complex;
  for (const SymbolId symbol : reached) {
    const Symbol& known = tree.symbols[symbol];
    const NameKey* key = key_of(names.symbols, base_of(tree.symbols, symbol));
    if (known.noncommuting || known.is_fixed() || known.declared || key == nullptr) continue;
    const std::string letter = without_labels(key->base);
    const bool defined = definition_in(question, symbol) != nullptr;
    const bool number = evidence.declared_real.contains(key->base) || evidence.real.contains(letter) ||
                        known.complex || is_usual_number_beside_operators(letter) ||
                        is_usual_real_beside_states(letter, evidence);
    if (!number && !defined) open.insert(symbol);
    const bool real = known.complex || evidence.real.contains(letter) ||
                      is_usual_real_beside_operators(letter) || is_usual_real_beside_states(letter, evidence);
    if (conjugates && !real && !defined) complex.insert(symbol);
  }
  if (!open.empty())
    return says(tree, open,
                fmt::format("{} beside operators can be {}; it holds for {}", quoted(tree, open),
                            open.size() == 1 ? "one as well, or a number" : "some as well, or numbers",
                            open.size() == 1 ? "a number" : "numbers"));
  if (complex.empty()) return std::nullopt;
  return says(tree, complex,
              fmt::format("{} can be complex, but it is proved for real numbers only", quoted(tree, complex)),
              "a real number");
}

/// Matrices and operators were multiplied as numbers are: what is proved counts where it holds in their
/// order as well, and nothing is refuted.
std::optional<OtherReading> in_order(const Question& question, const Names& names, bool proved) {
  const ExprTree& tree = *question.tree;
  const Equation& claim = question.claim;
  std::set<SymbolId> ordered = ordered_symbols(tree, names, question);
  ordered.merge(symbols_in_both_orders(tree, names, claim));
  if (proved) ordered.merge(capitals_that_must_commute(question, names));
  if (ordered.empty()) return std::nullopt;
  if (proved && claim.relation == Relation::equal &&
      (equal_in_order(question, ordered) || is_linear_in(question, ordered)))
    return std::nullopt;
  const bool one = ordered.size() == 1;
  return says(tree, ordered,
              fmt::format("{} can be {}, which need not commute, or {}; it {} for numbers",
                          quoted(tree, ordered), one ? "a matrix or an operator" : "matrices or operators",
                          one ? "a number" : "numbers", proved ? "holds" : "does not hold"));
}

/// Calls `visit` for each node of the claim.
template <typename Visit>
void for_each_node(const Question& question, const Visit& visit) {
  for (const ExprId id : nodes_below(*question.tree, {question.claim.left, question.claim.right}))
    visit((*question.tree)[id]);
}

struct ClaimVectors {
  std::set<SymbolId> open;  // those that no directive declares
  bool any = false;
};

ClaimVectors vectors_of(const Question& question) {
  const SymbolTable& symbols = question.tree->symbols;
  ClaimVectors vectors;
  for_each_node(question, [&](const ExprNode& node) {
    if (node.op != Op::symbol) return;
    const SymbolId base = base_of(symbols, node.symbol);
    if (symbols[base].rank == 0) return;
    vectors.any = true;
    if (!symbols[base].declared) vectors.open.insert(base);
  });
  return vectors;
}

/// A length is not the root of `a·a` for complex vectors, whose squares need not be positive.
std::optional<OtherReading> in_complex_vectors(const Question& question, const Names& names) {
  const Evidence& evidence = *names.symbols.evidence;
  const auto is_imaginary = [&](const char* letter) {
    return evidence.letters.contains(letter) && !labels_particles(names.symbols, letter);
  };
  if (!evidence.complex_vectors && !is_imaginary("i") && !is_imaginary("\\mathrm{i}")) return std::nullopt;
  bool asked = question.claim.relation != Relation::equal;
  bool measured = false;
  for_each_node(question, [&](const ExprNode& node) {
    measured = measured || node.op == Op::length;
    asked = asked || node.op == Op::length || node.op == Op::conjugate || node.op == Op::real_part ||
            node.op == Op::imaginary_part;
  });
  std::set<SymbolId> open = vectors_of(question).open;
  std::erase_if(open, [&](SymbolId symbol) {
    const NameKey* key = key_of(names.symbols, symbol);
    const bool of_entries = key != nullptr && key->shape.any();  // which are known, and looked at one by one
    const bool matrix = of_entries && key->rank > 1;
    return question.tree->symbols[symbol].complex || matrix || (of_entries && !measured) ||
           (key != nullptr && evidence.real.contains(key->base));
  });
  if (!asked || open.empty()) return std::nullopt;
  return OtherReading{
      fmt::format("{} can be complex, but it is proved for real vectors only", quoted(*question.tree, open)),
      {fmt::format("`rigor: vector {}` says that it is real", question.tree->symbols[*open.begin()].name)}};
}

/// A matrix or column that is no vector of a space.
bool is_of_columns(const ExprNode& node) { return node.rank > 0 && node.axes[0].id == space_of_columns; }

/// Does the claim name single components or axes? `axes`: unit vectors along axes count.
bool has_components(const Question& question, bool axes) {
  bool found = false;
  for_each_node(question, [&](const ExprNode& node) {
    if ((node.op == Op::basis && !axes) || is_of_columns(node)) return;
    found = found || node.op == Op::basis || node.op == Op::tuple || node.op == Op::index_sum ||
            node.op == Op::component || node.slot_count > 0;
  });
  return found;
}

/// Does it depend on the number of dimensions, or on the metric? `p^2` of a four-vector need not be positive.
bool counts_dimensions(const Question& question) {
  const bool order = question.claim.relation != Relation::equal;
  bool found = false;
  for_each_node(question, [&](const ExprNode& node) {
    const bool squares = node.op == Op::dot || node.op == Op::length || node.op == Op::power;
    found =
        found || node.op == Op::delta || node.op == Op::epsilon || node.op == Op::cross || (order && squares);
  });
  return found;
}

/// Three matrices, which say by themselves how many axes their vector has: "two dimensions" are those of
/// their columns.
bool has_triple(const Question& question, const Names& names) {
  bool found = false;
  for_each_node(question, [&](const ExprNode& node) {
    const NameKey* key = node.op == Op::symbol ? key_of(names.symbols, node.symbol) : nullptr;
    const bool letter = key != nullptr && key->shape.any();
    found = found || (node.rank == 3 && (node.op == Op::tuple || letter));
  });
  return found;
}

/// Is it about tensors of space-time, whose four axes and signs are read?
bool is_of_space_time(const Question& question) {
  bool found = false;
  for_each_node(question, [&](const ExprNode& node) {
    const bool letter = node.op == Op::symbol && question.tree->symbols[node.symbol].rank > 0 &&
                        question.tree->symbols[node.symbol].axes[0] == space_time;
    const bool slot = node.slot_count > 0 && node.first_slot[0].axis == 0 &&
                      question.tree->space(node.first_slot[0].variable) == space_time;
    found = found || letter || slot ||
            (node.op == Op::index_sum && question.tree->space(node.index) == space_time) ||
            (node.op == Op::tuple && node.axes[0] == space_time);
  });
  return found;
}

/// A proof that counts components, or needs their axes, holds along three Cartesian ones.
std::optional<OtherReading> in_another_space(const Question& question, const Names& names, bool proved) {
  const Evidence& evidence = *names.symbols.evidence;
  // `space` says how many dimensions it has, but nothing about its metric.
  const bool said = space_of(names.symbols) != common_space;
  const std::string& of_space = said ? evidence.other_metric : evidence.other_space;
  const std::string& words = of_space.empty() ? evidence.other_axes : of_space;
  if (!proved || words.empty() || has_triple(question, names) || is_of_space_time(question))
    return std::nullopt;
  const bool axes = !of_space.empty() || !evidence.hatted_axes;
  const bool asked = has_components(question, axes) || (!of_space.empty() && counts_dimensions(question));
  const ClaimVectors vectors = vectors_of(question);
  if (!asked || (vectors.any && vectors.open.empty())) return std::nullopt;
  std::vector<std::string> help;
  if (!vectors.open.empty() && !said) {
    const Symbol& open = question.tree->symbols[*vectors.open.begin()];
    help.push_back(fmt::format("`rigor: {} {}` says that it has three components along Cartesian axes",
                               open.rank == 1 ? "vector" : "tensor", open.name));
  }
  return OtherReading{fmt::format("the text speaks of `{}`, but it is proved along {}Cartesian axes only",
                                  words, said ? "" : "three "),
                      std::move(help)};
}

/// What holds for real numbers need not in another arithmetic.
std::optional<OtherReading> in_another_arithmetic(const Question& question, const Names& names, bool proved) {
  const std::string& words = names.symbols.evidence->other_arithmetic;
  if (!proved || words.empty()) return std::nullopt;
  std::set<SymbolId> open;
  for (const ExprId side : {question.claim.left, question.claim.right}) {
    for (const SymbolId symbol : symbols_in(*question.tree, side)) {
      const SymbolId base = base_of(question.tree->symbols, symbol);
      if (!question.tree->symbols[base].declared) open.insert(base);
    }
  }
  if (open.empty()) return std::nullopt;
  return says(*question.tree, open,
              fmt::format("the text speaks of `{}`, but it is proved for real numbers only", words),
              "a real number");
}

/// A claim that real numbers refute is refuted for complex ones, too.
std::optional<OtherReading> in_complex_numbers(const Question& question, const Names& names, bool proved) {
  if (!proved) return std::nullopt;
  if (auto vectors = in_complex_vectors(question, names)) return vectors;
  const std::set<SymbolId> complex = complex_symbols(question, names);
  if (holds_for_complex(question, complex)) return std::nullopt;
  return says(*question.tree, complex,
              fmt::format("{} can be complex, but it is proved for real numbers only",
                          quoted(*question.tree, complex)),
              "a real number");
}

bool is_capital(const NameKey& key) {
  return key.rank == 0 && is_capital_letter(key.base[0]) &&
         (key.base.size() == 1 || key.base[1] == '_' || key.base[1] == '^');
}

/// `(I - P)^2 = I - 2P + P^2` between capitals that nothing explains.
std::optional<OtherReading> with_unit_matrix(const Question& question, const Names& names, bool proved) {
  const ExprTree& tree = *question.tree;
  const Equation& claim = question.claim;
  if (proved || claim.relation != Relation::equal) return std::nullopt;
  std::set<SymbolId> letters;
  for (const ExprId side : {claim.left, claim.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) letters.insert(symbol);
  }
  std::optional<SymbolId> unit;
  for (const SymbolId symbol : letters) {
    const NameKey* key = key_of(names.symbols, symbol);
    if (key == nullptr || !is_capital(*key)) return std::nullopt;
    const bool open = !tree.symbols[symbol].declared && definition_of(names.scope, symbol) == nullptr;
    if (open && (key->base == "I" || key->base == "E")) unit = symbol;
  }
  if (!unit || letters.size() < 2 || !equal_with_units(tree, claim.left, claim.right, {*unit}, {*unit}))
    return std::nullopt;
  return says(
      tree, {*unit},
      fmt::format("it holds if {} is the unit matrix, but not if it is a number", quoted(tree, {*unit})));
}

std::optional<OtherReading> in_determinants(const Question& question, const Names& names, bool proved) {
  const std::set<SymbolId> matrices = symbols_of_determinants(question, names);
  if (matrices.empty()) return std::nullopt;
  return says(*question.tree, matrices,
              fmt::format("{} can be {}, and the bars a determinant; it {} for numbers",
                          quoted(*question.tree, matrices), matrices.size() == 1 ? "a matrix" : "matrices",
                          proved ? "holds" : "does not hold"));
}

/// Inside averages operators keep their order.
bool averages_operators(const Question& question) {
  const ExprTree& tree = *question.tree;
  const auto body_of = [&](SymbolId symbol) {
    const Definition* definition = definition_in(question, symbol);
    return definition == nullptr ? std::nullopt : std::optional(definition->body);
  };
  return std::ranges::any_of(
      symbols_reached(tree, {question.claim.left, question.claim.right}, body_of), [&](SymbolId symbol) {
        return is_average(tree, symbol) &&
               has_operators(tree, tree.symbols[base_of(tree.symbols, symbol)].integral->integrand);
      });
}

}  // namespace

std::optional<OtherReading> other_reading(const Question& question, const Names& names, bool proved) {
  if (is_about_operators(question) || averages_operators(question))
    return proved ? beside_operators(question, names) : std::nullopt;
  if (auto order = in_order(question, names, proved)) return order;
  if (auto arithmetic = in_another_arithmetic(question, names, proved)) return arithmetic;
  if (auto complex = in_complex_numbers(question, names, proved)) return complex;
  if (auto space = in_another_space(question, names, proved)) return space;
  if (auto unit = with_unit_matrix(question, names, proved)) return unit;
  return in_determinants(question, names, proved);
}

bool holds_with_unit_matrix(const Question& question, const Names& names) {
  if (names.symbols.evidence->units.empty() || question.claim.relation != Relation::equal) return false;
  const ExprTree& tree = *question.tree;
  const std::set<SymbolId> ordered = ordered_symbols(tree, names, question);
  const std::set<SymbolId> units = unit_matrices(names, question, ordered);
  return !units.empty() && equal_with_units(tree, question.claim.left, question.claim.right, ordered, units);
}

}  // namespace rigor
