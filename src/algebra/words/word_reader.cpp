// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/words/word_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "algebra/engine/undecidable.h"
#include "algebra/words/matrix_parts.h"
#include "algebra/words/state_words.h"
#include "expr/tree/unsized.h"

namespace rigor {
namespace {

constexpr int largest_power = 16;

[[nodiscard]] Coefficient number(const std::string& digits) {
  std::string whole = digits;
  std::int64_t below = 1;
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    whole.erase(point, 1);
    if (digits.size() > 9) throw Undecidable("the numbers before products of operators become too large");
    for (std::size_t k = point + 1; k < digits.size(); ++k) below *= 10;
  }
  std::int64_t above = 0;
  const auto [end, error] = std::from_chars(whole.data(), whole.data() + whole.size(), above);
  if (error != std::errc{} || end != whole.data() + whole.size() || whole.size() > 9)
    throw Undecidable("the numbers before products of operators become too large");
  return rational(WordFraction{above, 1} * WordFraction{1, below});
}

[[nodiscard]] int sign_of(std::uint8_t i, std::uint8_t j, std::uint8_t k) {
  return (static_cast<int>(i) - j) * (static_cast<int>(j) - k) * (static_cast<int>(k) - i) / 2;
}

}  // namespace

WordReader::WordReader(const Question& question, CommutingParts& parts, Unfolding unfolding, Budget& budget)
    : question_(question), parts_(parts), unfolding_(unfolding), budget_(budget) {
  see_squares();
  if (unfolding != Unfolding::unspoken) return;
  for (const Equation& assumption : question.assumptions) {
    for (const ExprId side : {assumption.left, assumption.right}) {
      const std::vector<SymbolId> own = symbols_in(*question.tree, side);
      spoken_of_.insert(own.begin(), own.end());
    }
  }
}

/// Where the inverse, a power, the trace or the determinant of a matrix is written, it is square; and where
/// an inverse is, it has one.
void WordReader::see_squares() {
  std::vector<ExprId> roots{question_.claim.left, question_.claim.right};
  for (const Equation& each : question_.assumptions) roots.insert(roots.end(), {each.left, each.right});
  for (const Definition& each : question_.definitions) roots.push_back(each.body);
  for (const ExprId id : nodes_below(tree(), roots)) {
    const ExprNode& node = tree()[id];
    transposes_ = transposes_ || node.op == Op::transpose;
    adjoints_ = adjoints_ || node.op == Op::conjugate;
    traces_ = traces_ || node.op == Op::trace;
    determinants_ = determinants_ || node.op == Op::matrix_determinant;
    const bool inverts = (node.op == Op::power && node.exponent < 0) || node.op == Op::divide;
    const bool asks =
        inverts || node.op == Op::power || node.op == Op::trace || node.op == Op::matrix_determinant;
    if (node.op == Op::symbol && tree().symbols[node.symbol].unsized == Unsized::square)
      square_.insert(node.symbol);
    if (!asks) continue;
    ExprId of = tree().children(id)[node.op == Op::divide ? 1 : 0];
    while (tree()[of].op == Op::transpose) of = tree().children(of)[0];
    if (tree()[of].op != Op::symbol) continue;
    const Unsized kind = tree().symbols[tree()[of].symbol].unsized;
    if (kind == Unsized::none || kind == Unsized::oblong) continue;
    square_.insert(tree()[of].symbol);
    if (inverts) inverted_.insert(tree()[of].symbol);
  }
}

bool WordReader::unfolds(SymbolId symbol) const {
  return unfolding_ == Unfolding::all || (unfolding_ == Unfolding::unspoken && !spoken_of_.contains(symbol));
}

std::vector<WordSum> WordReader::read(ExprId id, const AxesOfIndices& axes) {
  budget_.count(3);
  const ExprNode node = tree()[id];
  if (!reaches_operators(id)) return commuting(id, axes);
  const std::vector<ExprId> children(tree().children(id).begin(), tree().children(id).end());
  switch (node.op) {
    case Op::symbol:
      return symbol(id, axes);
    case Op::add: {
      Components total = read(children[0], axes);
      for (std::size_t k = 1; k < children.size(); ++k) {
        const Components next = read(children[k], axes);
        for (std::size_t c = 0; c < total.size(); ++c) add_to(total[c], next[c]);
      }
      return total;
    }
    case Op::negate: {
      Components all = read(children[0], axes);
      for (WordSum& each : all) each = opposite(each);
      return all;
    }
    case Op::conjugate: {
      Components all = read(children[0], axes);
      for (WordSum& each : all) each = adjoint(each, parts_);
      return all;
    }
    case Op::transpose: {
      Components all = read(children[0], axes);
      for (WordSum& each : all) each = transpose(each);
      return all;
    }
    case Op::trace:
      if (traces_forbidden_) throw Undecidable("no matrices of a finite size obey what stands above");
      return {scalar(trace(read_scalar(children[0], axes), rows_of(id)))};
    case Op::matrix_determinant:
      return {scalar(determinant_of(reduced(read_scalar(children[0], axes)), square_, rows_of(id), parts_))};
    case Op::multiply:
      return product(id, axes);
    case Op::dot:
    case Op::cross:
      return dot_or_cross(id, axes);
    case Op::divide: {
      const WordSum reciprocal = quotient(children[1], axes);
      Components all = read(children[0], axes);
      for (WordSum& each : all) each = times(each, reciprocal);
      return all;
    }
    case Op::power:
      return {power(id, axes)};
    case Op::component: {
      const Components all = read(children[0], axes);
      if (tree()[children[0]].rank != 1) break;
      return {all[axis_of(tree().slots(id)[0], axes) - 1u]};
    }
    case Op::tuple: {
      Components all;
      for (const ExprId child : children) all.push_back(read_scalar(child, axes));
      return all;
    }
    case Op::index_sum: {
      Components total(component_count(node));
      AxesOfIndices inside = axes;
      for (std::uint8_t axis = 1; axis <= tree().space(node.index).dimension; ++axis) {
        inside[node.index] = axis;
        const Components next = read(children[0], inside);
        for (std::size_t c = 0; c < total.size(); ++c) add_to(total[c], next[c]);
      }
      return total;
    }
    default:
      if (auto number = function_of_numbers(id, axes)) return {*std::move(number)};
      break;
  }
  throw Undecidable("operators are read in sums, products, powers, commutators and adjoints only");
}

/// `\sqrt{x^Tx}`, `\ln\det A`: of numbers that matrices make. Nothing where an operator is left.
std::optional<WordSum> WordReader::function_of_numbers(ExprId id, const AxesOfIndices& axes) {
  const ExprNode node = tree()[id];
  const bool fits = node.op == Op::root || node.op == Op::function || node.op == Op::absolute ||
                    node.op == Op::real_power || node.op == Op::real_part || node.op == Op::imaginary_part;
  if (!fits) return std::nullopt;
  std::vector<ExprId> children;
  for (const ExprId child : std::vector<ExprId>(tree().children(id).begin(), tree().children(id).end())) {
    const WordSum inside = with_all_numbers_out(reduced(read_scalar(child, axes)));
    if (inside.size() > 1 || (inside.size() == 1 && !inside.begin()->first.empty())) return std::nullopt;
    children.push_back(
        as_expression(inside.empty() ? Coefficient{} : inside.begin()->second, parts_, node.span));
  }
  return scalar(power_of_part(parts_.number_of(parts_.tree().add(node, children)), 1));
}

/// Of the matrix of a trace or a determinant.
std::optional<ExprId> WordReader::rows_of(ExprId id) const {
  return tree()[id].count == 2 ? std::optional(tree().children(id)[1]) : std::nullopt;
}

/// Is there an operator in it, or in what defines a symbol of it?
bool WordReader::reaches_operators(ExprId id) {
  const auto [at, is_new] = reaching_.try_emplace(id, false);
  if (!is_new) return at->second;
  const auto body_of = [&](SymbolId symbol) {
    const Definition* definition = definition_in(question_, symbol);
    return definition == nullptr ? std::nullopt : std::optional(definition->body);
  };
  const std::vector<SymbolId> reached = symbols_reached(tree(), {id}, body_of);
  const bool reaches =
      std::ranges::any_of(reached, [&](SymbolId symbol) { return tree().symbols[symbol].noncommuting; });
  reaching_[id] = reaches;
  return reaches;
}

/// Sums, products and what indices make of it are taken apart, so that equal parts are seen.
std::vector<WordSum> WordReader::commuting(ExprId id, const AxesOfIndices& axes) {
  const ExprNode node = tree()[id];
  if (node.rank > 1) throw Undecidable("tensors beside operators are not decided");
  if (node.rank == 1) {
    Components all;
    const ExprId whole = at_axes(id, axes);
    for (std::uint8_t axis = 1; axis <= node.axes[0].dimension; ++axis) {
      const Slot slot{axis, {}};
      const ExprId component = parts_.tree().add({.op = Op::component, .span = node.span},
                                                 std::span(&whole, 1), std::span(&slot, 1));
      all.push_back(scalar(power_of_part(parts_.number_of(component), 1)));
    }
    return all;
  }
  const std::vector<ExprId> children(tree().children(id).begin(), tree().children(id).end());
  const std::vector<Slot> slots(tree().slots(id).begin(), tree().slots(id).end());
  WordSum result;
  switch (node.op) {
    case Op::number:
      return {scalar(number(tree().digits(id)))};
    case Op::imaginary_unit:
      return {scalar(power_of_part(CommutingParts::imaginary, 1))};
    case Op::delta:
      return {scalar(rational({axis_of(slots[0], axes) == axis_of(slots[1], axes) ? 1 : 0, 1}))};
    case Op::epsilon:
      return {scalar(
          rational({sign_of(axis_of(slots[0], axes), axis_of(slots[1], axes), axis_of(slots[2], axes)), 1}))};
    case Op::add:
      for (const ExprId child : children) add_to(result, read_scalar(child, axes));
      return {result};
    case Op::negate:
      return {opposite(read_scalar(children[0], axes))};
    case Op::multiply:
      result = scalar(rational({1, 1}));
      for (const ExprId child : children) result = times(result, read_scalar(child, axes));
      return {result};
    case Op::divide:
      return {times(read_scalar(children[0], axes), quotient(children[1], axes))};
    case Op::power:
      if (std::abs(node.exponent) <= largest_power) return {power(id, axes)};
      break;
    case Op::index_sum: {
      AxesOfIndices inside = axes;
      for (std::uint8_t axis = 1; axis <= tree().space(node.index).dimension; ++axis) {
        inside[node.index] = axis;
        add_to(result, read_scalar(children[0], inside));
      }
      return {result};
    }
    default:
      break;
  }
  return {scalar(power_of_part(parts_.number_of(at_axes(id, axes)), 1))};
}

WordSum WordReader::read_scalar(ExprId id, const AxesOfIndices& axes) { return std::move(read(id, axes)[0]); }

std::vector<WordSum> WordReader::symbol(ExprId id, const AxesOfIndices& axes) {
  const ExprNode node = tree()[id];
  const Symbol& symbol = tree().symbols[node.symbol];
  const Definition* definition = definition_in(question_, node.symbol);
  const bool number = definition != nullptr && !symbol.noncommuting && is_number(definition->body);
  if (number && !unfolds(node.symbol)) return {scalar(power_of_part(parts_.number_of(id), 1))};
  if (definition != nullptr && !symbol.noncommuting && !number)
    throw Undecidable(
        fmt::format("`{}` is read as a number, but what defines it has operators", symbol.name));
  if (definition != nullptr && unfolds(node.symbol)) return defined(*definition, id, axes);
  if (symbol.rank > 1 || node.particle != no_particle)
    throw Undecidable(
        fmt::format("`{}` is an operator of many components, which are not decided", symbol.name));
  const auto letter = [&](std::uint8_t component) {
    return WordSum{{Word{Letter{.symbol = node.symbol, .component = component}}, rational({1, 1})}};
  };
  if (node.slot_count == 1) return {letter(axis_of(tree().slots(id)[0], axes))};
  if (symbol.rank == 0) return {letter(0)};
  Components all;
  for (std::uint8_t axis = 1; axis <= symbol.axes[0].dimension; ++axis) all.push_back(letter(axis));
  return all;
}

std::vector<WordSum> WordReader::defined(const Definition& definition, ExprId id, const AxesOfIndices& axes) {
  const ExprNode node = tree()[id];
  if (definition.by_square || definition.particle != no_particle || !opened_.insert(definition.symbol).second)
    throw Undecidable(
        fmt::format("`{}` is an operator that only its square defines", tree().symbols[node.symbol].name));
  unfolded_.insert(definition.symbol);
  const bool before = std::exchange(of_page_, true);
  const int rank = tree().symbols[definition.symbol].rank;
  Components all;
  if (definition.indices.empty()) {
    all = read(definition.body, axes);
  } else {
    for (std::uint8_t axis = 1; axis <= tree().space(definition.indices[0]).dimension; ++axis)
      all.push_back(read_scalar(definition.body, {{definition.indices[0], axis}}));
  }
  opened_.erase(definition.symbol);
  of_page_ = before;
  if (rank == 1 && node.slot_count == 1) return {all[axis_of(tree().slots(id)[0], axes) - 1u]};
  return all;
}

/// In the order of the factors; one of them may be a vector.
std::vector<WordSum> WordReader::product(ExprId id, const AxesOfIndices& axes) {
  Components total{scalar(rational({1, 1}))};
  for (const ExprId factor : std::vector<ExprId>(tree().children(id).begin(), tree().children(id).end())) {
    const Components next = read(factor, axes);
    if (total.size() > 1 && next.size() > 1) throw Undecidable("tensors of operators are not decided");
    Components product;
    for (const WordSum& first : total) {
      for (const WordSum& second : next) product.push_back(times(first, second));
    }
    budget_.count(20);
    total = std::move(product);
  }
  return total;
}

WordSum WordReader::dot(ExprId left, ExprId right, const AxesOfIndices& axes) {
  if (tree()[left].rank != 1 || tree()[right].rank != 1)
    throw Undecidable("tensors of operators are not decided");
  const Components first = read(left, axes);
  const Components second = read(right, axes);
  WordSum total;
  for (std::size_t axis = 0; axis < first.size(); ++axis) add_to(total, times(first[axis], second[axis]));
  return total;
}

std::vector<WordSum> WordReader::dot_or_cross(ExprId id, const AxesOfIndices& axes) {
  const ExprId left = tree().children(id)[0];
  const ExprId right = tree().children(id)[1];
  if (tree()[id].op == Op::dot) return {dot(left, right, axes)};
  const Components a = read(left, axes);
  const Components b = read(right, axes);
  if (a.size() != 3 || b.size() != 3) throw Undecidable("tensors of operators are not decided");
  Components all;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    WordSum component = times(a[j], b[k]);
    add_to(component, opposite(times(a[k], b[j])));
    all.push_back(std::move(component));
  }
  return all;
}

/// What is squared where a length is, or a name that is defined by its square: the square itself.
std::optional<ExprId> WordReader::squared(ExprId id) {
  const ExprNode node = tree()[id];
  if (node.op == Op::root) return tree().children(id)[0];
  if (node.op != Op::symbol || !unfolds(node.symbol)) return std::nullopt;
  const Definition* definition = definition_in(question_, node.symbol);
  if (definition == nullptr || !definition->by_square || !definition->indices.empty() ||
      tree()[definition->body].op != Op::root)
    return std::nullopt;
  unfolded_.insert(node.symbol);
  return tree().children(definition->body)[0];
}

WordSum WordReader::power(ExprId id, const AxesOfIndices& axes) {
  const ExprNode node = tree()[id];
  const ExprId base = tree().children(id)[0];
  if (std::abs(node.exponent) > largest_power)
    throw Undecidable("such a high power of operators is not decided");
  int exponent = node.exponent;
  WordSum factor;
  const bool even = exponent > 0 && exponent % 2 == 0 && reaches_operators(base);
  const auto square = even ? squared(base) : std::nullopt;
  if (square) {
    factor = read_scalar(*square, axes);
    exponent /= 2;
  } else if (even && tree()[base].op == Op::length) {
    const ExprId vector = tree().children(base)[0];
    factor = dot(vector, vector, axes);
    exponent /= 2;
  } else if (exponent < 0) {
    factor = quotient(base, axes);
    exponent = -exponent;
  } else {
    factor = read_scalar(base, axes);
  }
  WordSum total = scalar(rational({1, 1}));
  for (int k = 0; k < exponent; ++k) {
    budget_.count(20);
    total = times(total, factor);
  }
  return total;
}

/// 1/x of a number, or of operators.
WordSum WordReader::quotient(ExprId id, const AxesOfIndices& axes) {
  WordSum below = read_scalar(id, axes);
  if (below.empty()) throw Undecidable("it divides by zero");
  if (below.size() == 1 && below.begin()->first.empty()) {
    const Coefficient reciprocal = inverse(below.begin()->second, false);
    if (!reciprocal.empty()) return scalar(reciprocal);
  }
  if (!reaches_operators(id)) return scalar(power_of_part(parts_.number_of(at_axes(id, axes)), -1));
  return inverse_of(with_all_numbers_out(reduced(std::move(below))));
}

/// The inverse of a product is that of its factors in the other order, if these have one.
WordSum WordReader::inverse_of(const WordSum& below) {
  if (below.empty()) throw Undecidable("it divides by zero");
  if (below.size() > 1) return inverse_letter(below);
  const auto& [word, coefficient] = *below.begin();
  for (const Letter& letter : word) {
    if (tree().symbols[letter.symbol].unsized == Unsized::column)
      throw Undecidable("a column has no inverse");
    const bool defined = definition_in(question_, letter.symbol) != nullptr;
    if (!of_page_ && defined && tree().symbols[letter.symbol].unsized != Unsized::none)
      throw Undecidable("what defines a matrix may leave it no inverse");
    if (!of_page_ && is_annihilated(letter.symbol))
      throw Undecidable("what stands above may leave a matrix no inverse");
  }
  if (word.empty()) {
    const Span span = tree()[question_.claim.left].span;
    const Coefficient reciprocal = inverse(coefficient, false);
    return scalar(reciprocal.empty()
                      ? power_of_part(parts_.number_of(as_expression(coefficient, parts_, span)), -1)
                      : reciprocal);
  }
  const Coefficient reciprocal = inverse(coefficient, false);
  const bool separate = std::ranges::all_of(word, [&](const Letter& letter) {
    return tree().symbols[letter.symbol].unsized == Unsized::none || inverted_.contains(letter.symbol);
  });
  if (reciprocal.empty() || !separate) return inverse_letter(below);
  Word turned(word.rbegin(), word.rend());
  for (Letter& letter : turned) letter.inverse = !letter.inverse;
  return {{std::move(turned), reciprocal}};
}

/// S of (A + B)⁻¹ and (MᵀM)⁻¹. Of what is its own transpose the inverse is, too.
WordSum WordReader::inverse_letter(const WordSum& below) {
  const auto letter = [](SymbolId symbol, bool turned) {
    return WordSum{{Word{Letter{.symbol = symbol, .transpose = turned}}, rational({1, 1})}};
  };
  const WordSum turned = transpose(below);
  for (const auto& [known, symbol] : inverse_letters_) {
    if (known == below) return letter(symbol, false);
    if (known == turned) return letter(symbol, true);
  }
  const bool oblong = std::ranges::any_of(below, [&](const auto& each) {
    return std::ranges::any_of(
        each.first, [&](const Letter& one) { return tree().symbols[one.symbol].unsized == Unsized::oblong; });
  });
  // Where laws or definitions say something of its letters, it may not exist: (I - P)⁻¹ where P² = P.
  if (!of_page_ && knows_something())
    throw Undecidable("what stands above may leave no inverse of a sum or product of its matrices");
  const bool alone = below.size() == 1 && below.begin()->first.size() == 1;
  if (oblong && (alone || !inverse_letters_.empty()))
    throw Undecidable("a matrix that need not be square may have no inverse");
  if (inverse_letters_.size() >= 4)
    throw Undecidable("so many inverses of sums of operators are not decided");
  ExprTree& own = parts_.tree();
  Symbol made;
  made.name = "(" + std::to_string(inverse_letters_.size()) + ")^{-1}";
  made.noncommuting = true;
  made.unsized = Unsized::square;
  made.made_at = own.size();
  const SymbolId symbol = own.symbols.add(std::move(made));
  square_.insert(symbol);
  inverse_letters_.emplace_back(below, symbol);
  const WordSum inverse = letter(symbol, false);
  for (WordSum one : {times(below, inverse), times(inverse, below)}) {
    add_to(one, scalar(rational({-1, 1})));
    inverse_laws_.push_back(std::move(one));
  }
  if (transposes_ && turned == below) {
    WordSum same = letter(symbol, true);
    add_to(same, opposite(inverse));
    inverse_laws_.push_back(std::move(same));
  }
  return inverse;
}

/// A rule can fit to a rotation of a word: of `tr BA` where AB = 0.
Coefficient WordReader::trace(const WordSum& of, std::optional<ExprId> rows) {
  constexpr int most_rounds = 12;
  if (holds_kets(of, tree())) return trace_of_states(of);
  WordSum sum = reduced(of);
  for (int round = 0; rules_ != nullptr && round < most_rounds; ++round) {
    const auto turned = rules_->reduce_rotations(sum, used_);
    if (!turned) break;
    sum = *turned;
  }
  return trace_of(sum, rows, parts_);
}

/// tr A|a⟩⟨b| = ⟨b|A|a⟩
Coefficient WordReader::trace_of_states(const WordSum& of) {
  WordSum numbers;
  for (const auto& [whole, coefficient] : of) {
    Word word = whole;
    const auto bra = std::ranges::find_if(
        word, [&](const Letter& letter) { return letter.adjoint && tree().symbols[letter.symbol].ket; });
    if (bra == word.end()) throw Undecidable("the trace of an operator without states is not decided");
    std::rotate(word.begin(), bra, word.end());
    add_to(numbers, WordSum{{std::move(word), coefficient}});
  }
  numbers = with_all_numbers_out(reduced(std::move(numbers)));
  if (numbers.empty()) return {};
  if (numbers.size() != 1 || !numbers.begin()->first.empty())
    throw Undecidable("the trace of what is no operator is not decided");
  return numbers.begin()->second;
}

/// `a^Tb`, `\det A`: a number that matrices of any size make.
bool WordReader::is_number(ExprId id) const {
  return is_unsized(tree(), id) && unsized_shape(tree(), id) == UnsizedShape::number;
}

/// By a law such as `Ax = 0`.
bool WordReader::is_annihilated(SymbolId letter) const {
  if (tree().symbols[letter].unsized == Unsized::none) return false;
  return std::ranges::any_of(question_.assumptions, [&](const Equation& each) {
    for (const auto& [zero, other] : {std::pair(each.left, each.right), std::pair(each.right, each.left)}) {
      if (!tree().is_zero_literal(zero)) continue;
      const std::vector<SymbolId> own = symbols_in(tree(), other);
      if (std::ranges::find(own, letter) != own.end()) return true;
    }
    return false;
  });
}

/// Of operators.
bool WordReader::knows_something() {
  const bool laws = std::ranges::any_of(question_.assumptions, [&](const Equation& each) {
    return reaches_operators(each.left) || reaches_operators(each.right);
  });
  return laws || !unfolded_.empty();
}

WordSum WordReader::reduced(WordSum sum) {
  return rules_ == nullptr ? sum : rules_->reduce(std::move(sum), used_);
}

WordSum WordReader::with_all_numbers_out(const WordSum& sum) {
  return with_brackets_out(with_numbers_out(sum, parts_), parts_, rules_, used_);
}

std::uint8_t WordReader::axis_of(const Slot& slot, const AxesOfIndices& axes) const {
  if (slot.axis != 0) return slot.axis;
  const auto found = axes.find(slot.variable);
  if (found == axes.end()) throw Undecidable("an index beside operators is not decided");
  return found->second;
}

/// The same with numbers for the open indices.
ExprId WordReader::at_axes(ExprId id, const AxesOfIndices& axes) {
  const ExprNode node = tree()[id];
  const std::vector<ExprId> before(tree().children(id).begin(), tree().children(id).end());
  std::vector<ExprId> children;
  for (const ExprId child : before) children.push_back(at_axes(child, axes));
  std::vector<Slot> slots(tree().slots(id).begin(), tree().slots(id).end());
  bool changes = children != before;
  for (Slot& slot : slots) {
    const auto found = slot.axis == 0 ? axes.find(slot.variable) : axes.end();
    if (found == axes.end()) continue;
    slot = {found->second, {}};
    changes = true;
  }
  if (!changes) return id;
  if (node.op == Op::table) throw Undecidable("cases beside operators are not decided");
  return parts_.tree().add(node, children, slots);
}

}  // namespace rigor
