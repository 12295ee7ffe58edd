// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/other_notation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"

namespace rigor {
namespace {

struct NotationOfStep {
  const SyntaxTree& syntax;
  const Evidence& evidence;
  std::array<SyntaxId, 2> sides;
  std::vector<SyntaxId> nodes = nodes_below(syntax, {sides[0], sides[1]});

  [[nodiscard]] SyntaxKind kind(SyntaxId id) const { return syntax[id].kind; }
  [[nodiscard]] bool is_symbol(SyntaxId id) const { return kind(id) == SyntaxKind::symbol; }
  [[nodiscard]] SyntaxId bare(SyntaxId id) const {
    while (kind(id) == SyntaxKind::group && !syntax.children(id).empty()) id = syntax.child(id, 0);
    return id;
  }
  /// With or without a label.
  [[nodiscard]] bool is_capital(SyntaxId id) const {
    if (!is_symbol(id)) return false;
    const WrittenSymbol& symbol = syntax.symbol(id);
    return symbol.face == Face::plain && symbol.accent == Accent::none && symbol.dots == 0 &&
           symbol.change.empty() && is_capital_letter(symbol.letter);
  }
  /// The same, and bold nowhere in the section.
  [[nodiscard]] bool is_plain_capital(SyntaxId id) const {
    return is_capital(id) && !evidence.vectors.contains(letter_with_marks(syntax.symbol(id)));
  }
};

NotationOfStep notation_of(const SyntaxTree& syntax, const Names& names, const ParsedChain& parsed,
                           std::size_t which) {
  return {syntax, *names.symbols.evidence, {parsed.sides[which], parsed.sides[which + 1]}};
}

/// How many points more are added than subtracted, and what else is in the sum.
struct PointCount {
  int weight = 0;
  int points = 0;
  int others = 0;
  int bold_elsewhere = 0;  // of the points: the vector to it may have its name
  SyntaxId first{};
};

PointCount count_points(const NotationOfStep& step, SyntaxId side) {
  PointCount count;
  side = step.bare(side);
  const auto add = [&](SyntaxId id, int sign) {
    if (!step.is_capital(id)) {
      ++count.others;
      return;
    }
    if (!step.is_plain_capital(id)) ++count.bold_elsewhere;
    if (count.points++ == 0) count.first = id;
    count.weight += sign;
  };
  if (step.kind(side) != SyntaxKind::sum) {
    add(side, 1);
  } else {
    for (const SyntaxChild& term : step.syntax.children(side))
      add(term.id, term.joint == Joint::minus ? -1 : 1);
  }
  return count;
}

/// `Q - P` is a vector, and `Q = P + \mathbf v` a point.
std::optional<OpenPart> open_points(const NotationOfStep& step) {
  const auto named = [&](SyntaxId id) {
    return OpenPart{step.syntax[id].span, fmt::format("`{}` can be a point", step.syntax.symbol(id).letter)};
  };
  for (const SyntaxId id : step.nodes) {
    if (step.kind(id) != SyntaxKind::sum) continue;
    const PointCount count = count_points(step, id);
    const bool distance = count.points > 1 && count.others == 0 && count.weight == 0;
    if (distance && count.bold_elsewhere < count.points) return named(count.first);
  }
  const PointCount left = count_points(step, step.sides[0]);
  const PointCount right = count_points(step, step.sides[1]);
  const bool moved = left.weight == 1 && right.weight == 1 && left.others + right.others > 0 &&
                     left.bold_elsewhere + right.bold_elsewhere == 0;
  return moved ? std::optional(named(left.first)) : std::nullopt;
}

bool is_function_named(const NotationOfStep& step, SyntaxId id, std::string_view name) {
  if (step.kind(id) == SyntaxKind::power) id = step.syntax.child(id, 0);
  return step.kind(id) == SyntaxKind::function && step.syntax.text(id) == name;
}

/// `q_0 + \vec q`, `\cos\alpha + \hat n\sin\alpha`
bool is_quaternion(const NotationOfStep& step, SyntaxId sum) {
  std::set<std::string> numbers;
  std::set<std::string> vectors;
  bool cosine = false;
  bool turned = false;
  for (const SyntaxChild& term : step.syntax.children(sum)) {
    if (step.is_symbol(term.id)) {
      const WrittenSymbol& symbol = step.syntax.symbol(term.id);
      const bool zeroth = symbol.lower.size() == 1 && symbol.lower[0].text == "0";
      if (symbol.face == Face::plain && zeroth) numbers.insert(symbol.letter);
      if (symbol.face == Face::vector && symbol.lower.empty()) vectors.insert(symbol.letter);
    }
    cosine = cosine || is_function_named(step, term.id, "cos");
    if (step.kind(term.id) != SyntaxKind::term) continue;
    const auto factors = step.syntax.children(term.id);
    const bool sine = std::ranges::any_of(
        factors, [&](const SyntaxChild& factor) { return is_function_named(step, factor.id, "sin"); });
    const bool axis = std::ranges::any_of(factors, [&](const SyntaxChild& factor) {
      return step.is_symbol(factor.id) && (step.syntax.symbol(factor.id).accent == Accent::hat ||
                                           step.syntax.symbol(factor.id).face == Face::vector);
    });
    turned = turned || (sine && axis && factors.size() == 2);
  }
  const bool both =
      std::ranges::any_of(numbers, [&](const std::string& letter) { return vectors.contains(letter); });
  return both || (cosine && turned && step.syntax.children(sum).size() == 2);
}

std::optional<OpenPart> open_quaternion(const NotationOfStep& step) {
  for (const SyntaxId id : step.nodes) {
    if (step.kind(id) == SyntaxKind::sum && is_quaternion(step, id))
      return OpenPart{step.syntax[id].span, "the sum of a number and a vector can be a quaternion"};
  }
  return std::nullopt;
}

/// `XY = [-2, 8, 48]`: the values of what the capitals name.
std::optional<OpenPart> open_list(const NotationOfStep& step) {
  const auto is_number = [&](SyntaxId id) {
    if (step.kind(id) == SyntaxKind::sum && step.syntax.children(id).size() == 1)
      id = step.syntax.child(id, 0);
    return step.kind(id) == SyntaxKind::number;
  };
  for (const std::size_t k : {0, 1}) {
    const SyntaxId list = step.sides[k];
    if (step.kind(list) != SyntaxKind::tuple) continue;
    const bool numbers = std::ranges::all_of(step.syntax.children(list),
                                             [&](const SyntaxChild& entry) { return is_number(entry.id); });
    const std::vector<SyntaxId> other = nodes_below(step.syntax, {step.sides[1 - k]});
    const auto fits = [&](SyntaxId id) { return !step.is_symbol(id) || step.is_plain_capital(id); };
    const bool capitals = std::ranges::all_of(other, fits) &&
                          std::ranges::any_of(other, [&](SyntaxId id) { return step.is_symbol(id); });
    if (numbers && capitals) return OpenPart{step.syntax[list].span, "this can be a list of data"};
  }
  return std::nullopt;
}

/// `\cos\omega(\mathbf k)`: the letter that ends the argument can be a function of the vector.
std::optional<OpenPart> open_function(const NotationOfStep& step) {
  const auto holds_vector = [&](SyntaxId id) {
    return std::ranges::any_of(nodes_below(step.syntax, {id}), [&](SyntaxId each) {
      return step.is_symbol(each) && step.syntax.symbol(each).face == Face::vector;
    });
  };
  for (const SyntaxId id : step.nodes) {
    if (step.kind(id) != SyntaxKind::term) continue;
    const auto factors = step.syntax.children(id);
    for (std::size_t k = 1; k < factors.size(); ++k) {
      const bool bracket = factors[k].joint == Joint::juxtaposed &&
                           step.kind(factors[k].id) == SyntaxKind::group && holds_vector(factors[k].id);
      if (!bracket || step.kind(factors[k - 1].id) != SyntaxKind::function) continue;
      SyntaxId last = step.syntax.child(factors[k - 1].id, 0);
      if (step.kind(last) == SyntaxKind::term) last = step.syntax.children(last).back().id;
      if (step.is_symbol(last) && step.syntax.symbol(last).face == Face::plain)
        return OpenPart{step.syntax[last].span, "this letter can be a function of what follows it"};
    }
  }
  return std::nullopt;
}

/// `\nabla_2 f`: on a surface, or by the place of the second particle.
std::optional<OpenPart> open_gradient(const NotationOfStep& step) {
  for (const SyntaxId id : step.nodes) {
    if (!step.is_symbol(id) || step.syntax.symbol(id).letter != "\\nabla") continue;
    const std::vector<WrittenIndex>& lower = step.syntax.symbol(id).lower;
    if (lower.size() == 1 && lower[0].form == IndexForm::digit)
      return OpenPart{step.syntax[id].span, fmt::format("`{}` can number a gradient", lower[0].text)};
  }
  return std::nullopt;
}

/// Where a letter is a subscript in a step.
struct SubscriptUses {
  std::vector<const WrittenSymbol*> symbols;
  std::array<bool, 2> on_side{};
  bool definite = false;  // on δ, ε, a bracket, or under a sum or derivative: an index
};

void add_uses(const NotationOfStep& step, SyntaxId id, const std::string& letter, SubscriptUses& uses) {
  const auto has = [&](const std::vector<WrittenIndex>& indices) {
    return std::ranges::any_of(indices, [&](const WrittenIndex& each) { return each.text == letter; });
  };
  switch (step.kind(id)) {
    case SyntaxKind::symbol: {
      const WrittenSymbol& symbol = step.syntax.symbol(id);
      if (!has(symbol.lower)) return;
      uses.symbols.push_back(&symbol);
      uses.definite = uses.definite || is_kronecker(symbol) || is_levi_civita(symbol);
      return;
    }
    case SyntaxKind::component:
      uses.definite = uses.definite || has(step.syntax.indices(id));
      return;
    case SyntaxKind::big_sum:
      uses.definite = uses.definite || has(step.syntax.big_sum(id).indices);
      return;
    case SyntaxKind::derivative:
      for (const WrittenVariable& by : step.syntax.derivative(id).by)
        uses.definite = uses.definite || has(by.symbol.lower);
      return;
    default:
      return;
  }
}

SubscriptUses uses_of(const NotationOfStep& step, const std::string& letter) {
  SubscriptUses uses;
  for (const std::size_t k : {0, 1}) {
    const std::size_t before = uses.symbols.size();
    for (const SyntaxId id : nodes_below(step.syntax, {step.sides[k]})) add_uses(step, id, letter, uses);
    uses.on_side[k] = uses.symbols.size() > before;
  }
  return uses;
}

bool is_index_letter(const WrittenIndex& index) {
  return index.form == IndexForm::letter && index.text.size() == 1 && index.text[0] >= 'i' &&
         index.text[0] <= 'n';
}

/// Is it the only letter of i … n that is a subscript in the step?
bool is_only_index(const NotationOfStep& step, const std::string& letter) {
  return std::ranges::all_of(step.nodes, [&](SyntaxId id) {
    if (!step.is_symbol(id)) return true;
    return std::ranges::all_of(step.syntax.symbol(id).lower, [&](const WrittenIndex& each) {
      return !is_index_letter(each) || each.text == letter;
    });
  });
}

bool is_twice_in_a_term(const NotationOfStep& step, const std::string& letter) {
  return std::ranges::any_of(step.nodes, [&](SyntaxId id) {
    if (step.kind(id) != SyntaxKind::term) return false;
    return 1 < std::ranges::count_if(step.syntax.children(id), [&](const SyntaxChild& factor) {
             return step.is_symbol(factor.id) &&
                    std::ranges::any_of(step.syntax.symbol(factor.id).lower,
                                        [&](const WrittenIndex& each) { return each.text == letter; });
           });
  });
}

/// `\mathbf e_i` beside `\mathbf e_r`: the incident and the reflected one.
bool is_of_a_labelled_family(const NotationOfStep& step, const SubscriptUses& uses) {
  return std::ranges::all_of(uses.symbols, [&](const WrittenSymbol* symbol) {
    if (symbol->face != Face::vector || symbol->lower.size() != 1) return false;
    return std::ranges::any_of(step.nodes, [&](SyntaxId id) {
      if (!step.is_symbol(id)) return false;
      const WrittenSymbol& other = step.syntax.symbol(id);
      if (other.letter != symbol->letter || other.face != Face::vector || other.lower.size() != 1)
        return false;
      const WrittenIndex& label = other.lower[0];
      return label.form != IndexForm::digit && !is_index_letter(label) && axis_of_letter(label.text) == 0;
    });
  });
}

std::optional<std::string> letter_at(const NotationOfStep& step, Span place) {
  for (const SyntaxId id : step.nodes) {
    if (!step.is_symbol(id)) continue;
    for (const WrittenIndex& index : step.syntax.symbol(id).lower)
      if (index.span == place) return index.text;
  }
  return std::nullopt;
}

}  // namespace

std::optional<OpenPart> other_kind(const SyntaxTree& syntax, const Names& names, const ParsedChain& parsed,
                                   std::size_t which) {
  const NotationOfStep step = notation_of(syntax, names, parsed, which);
  for (const auto& look : {open_points, open_quaternion, open_list, open_function, open_gradient})
    if (auto open = look(step)) return open;
  return std::nullopt;
}

std::optional<OpenPart> other_subscript(const SyntaxTree& syntax, const Names& names,
                                        const ParsedChain& parsed, std::size_t which, Span place) {
  const NotationOfStep step = notation_of(syntax, names, parsed, which);
  const auto letter = letter_at(step, place);
  if (!letter) return std::nullopt;
  const SubscriptUses uses = uses_of(step, *letter);
  if (uses.definite || uses.symbols.empty()) return std::nullopt;
  const bool numbered = std::ranges::all_of(uses.symbols, [](const WrittenSymbol* symbol) {
    return symbol->lower.size() > 1 && symbol->lower.back().form == IndexForm::digit;
  });
  if (numbered) return OpenPart{place, fmt::format("`{}` and the number can be one label", *letter)};
  if (is_of_a_labelled_family(step, uses))
    return OpenPart{place, fmt::format("`{}` can be a label", *letter)};
  const bool single = std::ranges::all_of(uses.symbols, [](const WrittenSymbol* symbol) {
    return symbol->lower.size() == 1 && symbol->face == Face::plain;
  });
  if (!single || !is_only_index(step, *letter)) return std::nullopt;
  const bool of_vectors = std::ranges::all_of(uses.symbols, [&](const WrittenSymbol* symbol) {
    return step.evidence.vectors.contains(letter_with_marks(*symbol));
  });
  if (uses.on_side[0] && uses.on_side[1] && !of_vectors)
    return OpenPart{place, fmt::format("`{}` can number the members of a list", *letter)};
  const bool usual = is_one_of(*letter, {"i", "j", "k"});
  if (!usual && !is_twice_in_a_term(step, *letter))
    return OpenPart{place, fmt::format("`{}` can be a label, as of the normal component", *letter)};
  return std::nullopt;
}

}  // namespace rigor
