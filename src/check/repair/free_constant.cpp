// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair/free_constant.h"

#include <array>
#include <string_view>

#include "base/ascii.h"
#include "check/question/decision_cache.h"
#include "check/verdict/chain_reading.h"
#include "check/verdict/judge.h"
#include "latex/parse/parse.h"

namespace rigor {
namespace {

class Absorption {
 public:
  Absorption(ExprTree& tree, Names& names, const WrongStep& wrong, DecisionCache* cache)
      : tree_(tree), names_(names), wrong_(wrong), cache_(cache) {}

  std::optional<std::string> letter() {
    for (const std::string_view letter : {"C", "c", "K"}) {
      if (stands_alone(letter, 0) && stands_alone(letter, 1) && absorbs(letter)) return std::string(letter);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] const Tokens& side(std::size_t which) const {
    return wrong_.parsed.written.sides[wrong_.which + which].tokens;
  }

  /// Without labels and primes, and not to be multiplied by itself.
  [[nodiscard]] bool stands_alone(std::string_view letter, std::size_t which) const {
    const Tokens& tokens = side(which);
    std::size_t count = 0;
    for (std::size_t at = 0; at < tokens.size(); ++at) {
      if (!is_letter(tokens[at], letter)) continue;
      ++count;
      const std::string_view next = at + 1 < tokens.size() ? tokens[at + 1].text : std::string_view{};
      if (next == "_" || next == "'" || next == "^") return false;
    }
    return count == 1;
  }

  bool absorbs(std::string_view letter) {
    static constexpr std::array<std::string_view, 13> numbers{"(0)",
                                                              "(1)",
                                                              "(-1)",
                                                              "(\\frac{1}{2})",
                                                              "(-\\frac{1}{2})",
                                                              "(2)",
                                                              "(-2)",
                                                              "(\\frac{1}{4})",
                                                              "(-\\frac{1}{4})",
                                                              "(\\frac{1}{3})",
                                                              "(-\\frac{1}{3})",
                                                              "(\\frac{3}{2})",
                                                              "(-\\frac{3}{2})"};
    for (const std::string_view right : numbers) {
      if (right != "(0)" && holds_with(letter, "(0)", right)) return true;
      if (right != "(0)" && right != "(1)" && holds_with(letter, "(1)", right)) return true;
    }
    return false;
  }

  Tokens with(std::string_view letter, std::string_view number, std::size_t which) {
    const FileId file = sources_.add("constant", std::string(number));
    const Tokens value = lex(sources_, {file, 0, static_cast<std::uint32_t>(number.size())});
    Tokens tokens;
    for (const Token& token : side(which)) {
      if (is_letter(token, letter)) {
        tokens.insert(tokens.end(), value.begin(), value.end());
      } else {
        tokens.push_back(token);
      }
    }
    return tokens;
  }

  bool holds_with(std::string_view letter, std::string_view left, std::string_view right) {
    ParsedChain chain = wrong_.parsed;
    SyntaxTree syntax;
    std::array<Tokens, 2> sides{with(letter, left, 0), with(letter, right, 1)};
    for (std::size_t k = 0; k < chain.sides.size(); ++k) {
      const bool changed = k == wrong_.which || k == wrong_.which + 1;
      const Tokens& tokens = changed ? sides[k - wrong_.which] : chain.written.sides[k].tokens;
      chain.sides[k] = parse_side(tokens, chain.written.sides[k].span, syntax);
    }
    const Names before = names_;
    const auto reading = read_chain(syntax, tree_, names_, chain, wrong_.rules);
    Diagnostics ignored;
    bool holds = false;
    if (reading->sides[wrong_.which].typed && reading->sides[wrong_.which + 1].typed) {
      const auto claim = reading->claim(chain, wrong_.which, wrong_.first_order, ignored);
      holds = claim && judge(tree_, names_, *claim, limits_of_guesses, cache_).verdict == Verdict::proved;
    }
    names_ = before;
    return holds;
  }

  ExprTree& tree_;
  Names& names_;
  const WrongStep& wrong_;
  DecisionCache* cache_;
  SourceMap sources_;
};

}  // namespace

std::optional<std::string> absorbing_constant(const ExprTree& tree, const Names& names,
                                              const WrongStep& wrong, DecisionCache* cache) {
  ExprTree own_tree = tree;
  Names own_names = names;
  return Absorption(own_tree, own_names, wrong, cache).letter();
}

}  // namespace rigor
