// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/words/matrix_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <utility>

#include "algebra/engine/undecidable.h"

namespace rigor {
namespace {

[[nodiscard]] bool is_vector(const Letter& letter, const ExprTree& tree) {
  return tree.symbols[letter.symbol].unsized == Unsized::column;
}

[[nodiscard]] std::string text_of(const Word& word) {
  std::string text;
  for (const Letter& letter : word)
    text += fmt::format("{}{}{} ", static_cast<std::uint32_t>(letter.symbol), letter.inverse ? "-" : "",
                        letter.transpose ? "T" : "");
  return text;
}

[[nodiscard]] std::string text_of(const WordSum& sum) {
  std::string text;
  for (const auto& [word, coefficient] : sum) {
    text += text_of(word) + ':';
    for (const auto& [monomial, value] : coefficient) {
      text += fmt::format("{}/{}", value.above, value.below);
      for (const auto& [part, exponent] : monomial) text += fmt::format(" {}^{}", part, exponent);
      text += ',';
    }
    text += ';';
  }
  return text;
}

/// An inverse matrix of an operator and its adjoint are not numbers of real matrices.
void refuse_adjoints(const Word& word) {
  if (std::ranges::any_of(word, &Letter::adjoint))
    throw Undecidable("adjoints beside transposes and traces are not decided");
}

[[nodiscard]] Coefficient number_of(const Word& word, CommutingParts& parts) {
  refuse_adjoints(word);
  return power_of_part(parts.number_named("#" + std::min(text_of(word), text_of(transpose(word)))), 1);
}

[[nodiscard]] WordSum single(Word word, const Coefficient& coefficient) {
  return {{std::move(word), coefficient}};
}

/// All words that a trace does not tell apart, from the left; the least is the name of all.
[[nodiscard]] std::string least_rotation(Word word) {
  std::string least = text_of(word);
  for (std::size_t k = 1; k < word.size(); ++k) {
    std::rotate(word.begin(), word.begin() + 1, word.end());
    least = std::min(least, text_of(word));
  }
  return least;
}

/// Letters at the ends that cancel in a trace: X⁻¹…X.
[[nodiscard]] Word without_cancelling_ends(Word word) {
  while (word.size() >= 2) {
    Letter last = word.back();
    last.inverse = !last.inverse;
    if (last != word.front()) break;
    word.erase(word.begin());
    word.pop_back();
  }
  return word;
}

/// A written number, or a letter.
[[nodiscard]] Coefficient number_of_rows(ExprId rows, CommutingParts& parts) {
  const ExprTree& tree = parts.tree();
  if (tree[rows].op == Op::number) return rational({std::stoi(tree.digits(rows)), 1});
  return power_of_part(parts.number_of(rows), 1);
}

/// baseⁿ of a positive number or a letter, as the notes write it.
[[nodiscard]] Coefficient to_the_rows(ExprId base, ExprId rows, int sign, CommutingParts& parts) {
  const std::array both{base, rows};
  ExprTree& tree = parts.tree();
  return power_of_part(parts.number_of(tree.add({.op = Op::real_power}, both)), sign);
}

/// cⁿ of one term, in its factors.
[[nodiscard]] Coefficient to_the_rows(const Coefficient& c, ExprId rows, CommutingParts& parts) {
  ExprTree& tree = parts.tree();
  Coefficient total = rational({1, 1});
  if (tree[rows].op == Op::number) {
    for (int k = std::stoi(tree.digits(rows)); k > 0; --k) total = times(total, c);
    return total;
  }
  const auto& [monomial, value] = *c.begin();
  if (c.size() > 1 || value.above < 0)
    throw Undecidable("the determinant of such a multiple of a matrix of n rows is not decided");
  for (const auto& [number, sign] : {std::pair(value.above, 1), std::pair(value.below, -1)}) {
    if (number != 1)
      total = times(total, to_the_rows(tree.add_number({}, std::to_string(number)), rows, sign, parts));
  }
  for (const auto& [part, exponent] : monomial) {
    if (std::abs(exponent) != 1 || part == CommutingParts::imaginary)
      throw Undecidable("the determinant of such a multiple of a matrix of n rows is not decided");
    total = times(total, to_the_rows(parts.part(part), rows, exponent, parts));
  }
  return total;
}

[[nodiscard]] Coefficient trace_of(Word word, std::optional<ExprId> rows, CommutingParts& parts) {
  if (word.empty() && rows) return number_of_rows(*rows, parts);
  refuse_adjoints(word);
  const ExprTree& tree = parts.tree();
  word = without_cancelling_ends(std::move(word));
  const auto row = std::ranges::find_if(
      word, [&](const Letter& letter) { return is_vector(letter, tree) && letter.transpose; });
  if (row != word.end()) {  // tr xyᵀ = yᵀx
    std::rotate(word.begin(), row, word.end());
    WordSum number = with_numbers_out(single(std::move(word), rational({1, 1})), parts);
    if (number.size() != 1 || !number.begin()->first.empty())
      throw Undecidable("the trace of what is no square matrix is not decided");
    return number.begin()->second;
  }
  if (std::ranges::any_of(word, [&](const Letter& letter) { return is_vector(letter, tree); }))
    throw Undecidable("the trace of what is no square matrix is not decided");
  const std::string name = std::min(least_rotation(word), least_rotation(transpose(word)));
  return power_of_part(parts.number_named("#tr " + name), 1);
}

/// X of a sum whose words are all numbers or X⁻¹…X.
[[nodiscard]] bool strip_ends(WordSum& sum) {
  std::optional<Letter> end;
  for (const auto& [word, coefficient] : sum) {
    if (word.empty()) continue;
    const Word inner = without_cancelling_ends(word);
    if (inner.size() == word.size() || (end && *end != word.back())) return false;
    end = word.back();
  }
  if (!end) return false;
  WordSum rest;
  for (auto& [word, coefficient] : sum) {
    Word inner = word.empty() ? word : Word(word.begin() + 1, word.end() - 1);
    add_to(rest, single(std::move(inner), coefficient));
  }
  sum = std::move(rest);
  return true;
}

}  // namespace

WordSum with_numbers_out(const WordSum& sum, CommutingParts& parts) {
  const ExprTree& tree = parts.tree();
  WordSum result;
  for (const auto& [whole, coefficient] : sum) {
    Word word;
    Coefficient factor = coefficient;
    std::optional<std::size_t> row;  // in `word`, behind which no vector stands yet
    for (const Letter& letter : whole) {
      word.push_back(letter);
      if (!is_vector(letter, tree)) continue;
      if (letter.transpose) {
        row = word.size() - 1;
      } else if (row) {
        const auto begin = word.begin() + static_cast<std::ptrdiff_t>(*row);
        factor = times(factor, number_of(Word(begin, word.end()), parts));
        word.erase(begin, word.end());
        row.reset();
      }
    }
    add_to(result, single(std::move(word), factor));
  }
  return result;
}

Coefficient trace_of(const WordSum& sum, std::optional<ExprId> rows, CommutingParts& parts) {
  Coefficient total;
  for (const auto& [word, coefficient] : sum) add_to(total, times(coefficient, trace_of(word, rows, parts)));
  return total;
}

Coefficient determinant_of(const WordSum& given, const std::set<SymbolId>& square, std::optional<ExprId> rows,
                           CommutingParts& parts) {
  WordSum sum = given;
  for (const auto& [word, coefficient] : sum) {
    refuse_adjoints(word);
    for (const Letter& letter : word) {
      if (!square.contains(letter.symbol))
        throw Undecidable("nothing says that the factors in a determinant are square matrices");
    }
  }
  while (strip_ends(sum)) {
  }
  if (sum.empty()) return {};
  const bool alone = sum.begin()->second == rational({1, 1});
  if (sum.size() > 1 || (!alone && !rows))
    return power_of_part(parts.number_named("#det " + std::min(text_of(sum), text_of(transpose(sum)))), 1);
  Coefficient total = alone ? rational({1, 1}) : to_the_rows(sum.begin()->second, *rows, parts);
  for (const Letter& letter : sum.begin()->first) {
    const std::string name = text_of(Word{{.symbol = letter.symbol, .component = letter.component}});
    total = times(total, power_of_part(parts.number_named("#det " + name), letter.inverse ? -1 : 1));
  }
  return total;
}

}  // namespace rigor
