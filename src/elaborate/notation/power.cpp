// SPDX-License-Identifier: GPL-3.0-or-later
// Powers and roots.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "base/among.h"
#include "elaborate/evidence/evidence.h"
#include "elaborate/notation/matrix.h"
#include "elaborate/notation/notations.h"
#include "elaborate/reading/matrix_product.h"
#include "elaborate/reading/triple.h"
#include "elaborate/symbol/named_symbol.h"
#include "elaborate/symbol/space_time_letter.h"
#include "elaborate/symbol/triple_letter.h"

namespace rigor {
namespace {

constexpr int largest_exponent = 64;

/// The exponent times this: 3 of `3/2` for 2, and of `3/4` for 4.
std::optional<int> times_exponent(const SyntaxTree& syntax, SyntaxId id, int times) {
  if (const auto whole = whole_number(syntax, id))
    return std::abs(*whole) <= largest_exponent ? std::optional(times * *whole) : std::nullopt;
  const SyntaxNode& node = syntax[id];
  if (node.kind == SyntaxKind::sum && node.count == 1 && syntax.children(id)[0].joint == Joint::minus) {
    const auto value = times_exponent(syntax, syntax.child(id, 0), times);
    return value ? std::optional(-*value) : std::nullopt;
  }
  const bool fraction = node.kind == SyntaxKind::fraction;
  const bool slash =
      node.kind == SyntaxKind::term && node.count == 2 && syntax.children(id)[1].joint == Joint::slash;
  if (!fraction && !slash) return std::nullopt;
  const auto above = whole_number(syntax, syntax.child(id, 0));
  const auto below = whole_number(syntax, syntax.child(id, 1));
  if (!above || !below || *below != times || std::abs(*above) > largest_exponent) return std::nullopt;
  return *above;
}

/// `e^{\lambda t}`: Euler's number, unless e is declared, carries scripts or has a plain number above it.
bool is_exponential(const Reading& reading, SyntaxId id) {
  const SyntaxTree& syntax = reading.syntax;
  const SyntaxId base = syntax.child(id, 0);
  if (syntax[base].kind != SyntaxKind::symbol) return false;
  const WrittenSymbol& symbol = syntax.symbol(base);
  const bool euler = symbol.letter == "e" || symbol.letter == "\\mathrm{e}";
  return euler && symbol.face == Face::plain && symbol.accent == Accent::none && symbol.lower.empty() &&
         symbol.primes == 0 && !is_declared(reading.names.symbols, {symbol.letter, 0, false}) &&
         !whole_number(syntax, syntax.child(id, 1)).has_value();
}

/// `H^0`, `E^1`: nobody writes such a power of a letter, but of Euler's number.
bool reads_as_order(const Reading& reading, SyntaxId id) {
  const SyntaxTree& syntax = reading.syntax;
  const SyntaxId base = syntax.child(id, 0);
  if (syntax[base].kind != SyntaxKind::symbol || syntax[syntax.child(id, 1)].kind != SyntaxKind::number)
    return false;
  const std::string& exponent = syntax.text(syntax.child(id, 1));
  const WrittenSymbol& symbol = syntax.symbol(base);
  const bool euler = symbol.letter == "e" && symbol.lower.empty() && symbol.face == Face::plain &&
                     !is_declared(reading.names.symbols, {symbol.letter, 0, false});
  return (exponent == "0" || exponent == "1") && !euler;
}

/// Of what is the exponent made: numbers, and plain letters with nothing but labels at them?
std::optional<std::vector<std::string>> letters_of_number(const SyntaxTree& syntax, SyntaxId exponent) {
  std::vector<std::string> letters;
  for (const SyntaxId id : nodes_below(syntax, {exponent})) {
    const SyntaxNode& node = syntax[id];
    switch (node.kind) {
      case SyntaxKind::number:
      case SyntaxKind::sum:
      case SyntaxKind::term:
      case SyntaxKind::fraction:
      case SyntaxKind::group:
      case SyntaxKind::power:
        break;
      case SyntaxKind::symbol: {
        const WrittenSymbol& symbol = syntax.symbol(id);
        const bool plain = symbol.face == Face::plain && symbol.accent == Accent::none &&
                           symbol.primes == 0 && symbol.dots == 0 && symbol.change.empty();
        if (!plain) return std::nullopt;
        letters.push_back(symbol.letter);
        break;
      }
      default:
        return std::nullopt;
    }
  }
  return letters;
}

/// n of `u^{n+1}`, which may count the steps of a scheme.
bool may_count(const std::string& letter) {
  static constexpr std::array<std::string_view, 8> counters{"i", "j", "k", "l", "m", "n", "s", "t"};
  return is_one_of(letter, counters);
}

bool is_said_for_all(const Reading& reading, const std::string& letter) {
  const auto symbol = find_symbol(reading.names.symbols, {letter, 0, false});
  return symbol && is_for_all(reading.names.scope, *symbol);
}

/// k of `\sum_{k=0}^n a_kx^k`; in `\sum_i p_iq^i` and `\sum_k x_kx^k` it can be an index of both.
bool counts_above(const Reading& reading, SyntaxId base, const std::string& letter) {
  if (!reading.letters.counted.contains(letter) || letter == "T" || letter == "H") return false;
  if (!reading.letters.below.contains(letter)) return letter.size() == 1;
  const SyntaxTree& syntax = reading.syntax;
  if (letter.size() > 1 || letter == "i" || letter == "j") return false;
  if (syntax[base].kind != SyntaxKind::symbol) return true;
  for (std::uint32_t k = 0; k < syntax.size(); ++k) {
    const SyntaxId id{k};
    if (syntax[id].kind != SyntaxKind::symbol || syntax.symbol(id).letter != syntax.symbol(base).letter)
      continue;
    if (std::ranges::any_of(syntax.symbol(id).lower,
                            [&](const WrittenIndex& index) { return index.text == letter; }))
      return false;
  }
  return true;
}

/// `x^n`, `2^n`, `(1 + x)^\alpha`, `T V^{\gamma - 1}`: what stands above is a number for sure. It is where it
/// is written as no index is, and where all its letters stand on the line as well, or are declared.
bool is_number_above(const Reading& reading, SyntaxId base, SyntaxId exponent) {
  const SyntaxTree& syntax = reading.syntax;
  const auto letters = letters_of_number(syntax, exponent);
  if (!letters || syntax[exponent].kind == SyntaxKind::group) return false;  // `f^{(2)}` is a derivative
  const Evidence& evidence = *reading.names.symbols.evidence;
  const bool of_symbol = syntax[base].kind == SyntaxKind::symbol;
  const bool of_number = syntax[base].kind == SyntaxKind::number;
  if (of_symbol && may_be_raised(syntax.symbol(base), evidence)) return false;
  static constexpr std::array<std::string_view, 4> marks{"T", "H", "i", "j"};  // transposes, the unit i
  return std::ranges::all_of(*letters, [&](const std::string& letter) {
    if (counts_above(reading, base, letter)) return true;
    if (reading.letters.is_sure(letter) || reading.indices.summed.contains(letter) ||
        evidence.counters.contains(letter))
      return false;
    if (of_number || is_declared(reading.names.symbols, {letter, 0, false}) ||
        is_said_for_all(reading, letter))
      return true;
    const bool alone = syntax[exponent].kind == SyntaxKind::symbol;
    if (alone && is_one_of(letter, marks)) return false;
    return evidence.exponents.contains(letter) || (is_reckoned(syntax, exponent) && !may_count(letter));
  });
}

MaybeTyped real_power(Reading& reading, const Typed& base, SyntaxId exponent, Span span,
                      const Around& around) {
  const auto above = elaborate(reading, exponent, around);
  if (!above) return std::nullopt;
  if (base.rank != 0 || above->rank != 0 || !above->free.empty())
    return unsupported(reading, span, "a power of a vector with such an exponent is not defined");
  note(reading, "a power whose exponent is not a whole number is one of a positive number");
  const auto quarters = times_exponent(reading.syntax, exponent, 4);
  if (quarters && !has_complex_numbers(reading.tree, base.id)) {  // `(a/\pi)^{1/4}`, whose square is a root
    const Typed root = apply_op(reading.tree, Op::root, span, 0, {base});
    const Typed fourth = apply_op(reading.tree, Op::root, span, 0, {root});
    return *quarters == 1 ? fourth : apply_op(reading.tree, Op::power, span, 0, {fourth}, *quarters);
  }
  return apply_op(reading.tree, Op::real_power, span, 0, {base, *above});
}

/// `\sigma_i^2` is the square of each matrix, unless it is meant as `\sigma_i\sigma_i`.
void guess_no_sum(Reading& reading, const Typed& member) {
  const std::string& letter = member.free[0].letter;
  note(reading, fmt::format("a power of a matrix with the index `{0}` is not summed over `{0}`", letter));
  if (!reading.found.guess)
    reading.found.guess = Obstacle{
        DiagnosticKind::ambiguous_reading,
        fmt::format("a power of a matrix with the index `{0}` can be summed over `{0}` or not", letter),
        {"write the factors out, or the sum"}};
}

/// `L^2` of three operators L_i.
std::optional<MaybeTyped> square_of_triple(Reading& reading, SyntaxId raised, Span span,
                                           const Around& around) {
  const WrittenSymbol& symbol = reading.syntax.symbol(raised);
  const std::string base = letter_with_marks(symbol);
  const Names& names = reading.names;
  const bool triple = symbol.face == Face::plain && symbol.lower.empty() && symbol.dots == 0 &&
                      is_operator(*names.symbols.evidence, base, 1) && is_known(names, base, 1, false) &&
                      !is_declared(names.symbols, {base, 0, false});
  if (!triple) return std::nullopt;
  const WrittenName name{.base = base, .axes = {}, .particles = {}};
  const auto vector = named_symbol(reading, {symbol, name, span, around}, base, 1);
  if (!vector) return MaybeTyped();
  note(reading, fmt::format("`{0}^2` is the sum of the squares of the components of `{0}`", base));
  return MaybeTyped(apply_op(reading.tree, Op::dot, span, 0, {*vector, *vector}));
}

}  // namespace

std::optional<int> whole_number(const SyntaxTree& syntax, SyntaxId id) {
  const SyntaxNode& node = syntax[id];
  if (node.kind == SyntaxKind::number) {
    const std::string& digits = syntax.text(id);
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc{} && end == digits.data() + digits.size() ? std::optional(value) : std::nullopt;
  }
  if (node.kind == SyntaxKind::sum && node.count == 1 && syntax.children(id)[0].joint == Joint::minus) {
    const auto value = whole_number(syntax, syntax.child(id, 0));
    return value ? std::optional(-*value) : std::nullopt;
  }
  return std::nullopt;
}

namespace {

bool is_imaginary(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::symbol && may_be_imaginary_unit(syntax.symbol(id));
}

/// `E/kT`, `x^2/2\sigma^2`: letters stand behind the slash, and nothing else. Of a phase, `iE/\hbar t`, it is
/// not clear.
bool divides_by_letters(const SyntaxTree& syntax, std::span<const SyntaxChild> factors, std::size_t slash) {
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const SyntaxId id = factors[k].id;
    if (is_imaginary(syntax, id)) return false;
    if (k < slash) continue;
    if (k > slash && factors[k].joint != Joint::juxtaposed) return false;
    const bool power = syntax[id].kind == SyntaxKind::power;
    const bool letter = syntax[power ? syntax.child(id, 0) : id].kind == SyntaxKind::symbol;
    if (!letter && !(k == slash && syntax[id].kind == SyntaxKind::number)) return false;
  }
  return true;
}

/// In an exponent nobody multiplies by T of `E/kT`.
bool slashes_are_clear(const SyntaxTree& syntax, SyntaxId exponent) {
  const std::vector<SyntaxId> nodes = nodes_below(syntax, {exponent});
  return std::ranges::all_of(nodes, [&](SyntaxId id) {
    if (syntax[id].kind != SyntaxKind::term) return true;
    const std::span<const SyntaxChild> factors = syntax.children(id);
    const auto slash = std::ranges::find(factors, Joint::slash, &SyntaxChild::joint);
    return slash == factors.end() || slash + 1 == factors.end() ||
           divides_by_letters(syntax, factors, static_cast<std::size_t>(slash - factors.begin()));
  });
}

}  // namespace

MaybeTyped elaborate_power(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const SyntaxId raised = syntax.child(id, 0);
  const SyntaxId exponent = syntax.child(id, 1);
  const Span span = syntax[id].span;
  if (auto tensor = raised_letter(reading, id, around)) return *std::move(tensor);
  if (is_exponential(reading, id)) {
    const bool divides_by_all = reading.rules.divides_by_all;
    reading.rules.divides_by_all = divides_by_all || slashes_are_clear(syntax, exponent);
    const auto argument = elaborate(reading, exponent, around);
    reading.rules.divides_by_all = divides_by_all;
    if (argument && reading.found.triples && argument->layout == Layout::matrix)
      return matrix_exponential(reading, *argument, span);
    return argument ? elementary_function(reading, "exp", *argument, span) : std::nullopt;
  }
  // Not `\operatorname{tr}^2 A`, where the exponent stands before the argument.
  const bool behind_trace = syntax[raised].kind == SyntaxKind::function && syntax.text(raised) == "tr" &&
                            syntax[exponent].span.begin >= syntax[syntax.child(raised, 0)].span.end;
  if (behind_trace)
    return ambiguous(reading, span, "this can be the power of a trace, or the trace of a power",
                     {"put brackets around what has the power"});
  if (reads_as_order(reading, id)) {
    const WrittenSymbol& symbol = syntax.symbol(raised);
    return ambiguous(reading, span,
                     fmt::format("the {} above `{}` can be a power, or the order of an approximation",
                                 syntax.text(exponent), symbol.letter),
                     {fmt::format("write the power as `({})^{}`", symbol.letter, syntax.text(exponent))});
  }
  const auto whole = whole_number(syntax, exponent);
  const bool of_symbol = syntax[raised].kind == SyntaxKind::symbol;
  if (of_symbol && whole && may_be_raised(syntax.symbol(raised), *reading.names.symbols.evidence) &&
      !is_declared_letter(reading.names, syntax.symbol(raised)) &&
      !is_coordinate_on_line(reading, syntax.symbol(raised))) {
    const std::string& letter = syntax.symbol(raised).letter;
    return ambiguous(
        reading, span,
        fmt::format("`{}` has upper indices elsewhere: this can be one of them or a power", letter),
        {fmt::format("`rigor: scalar {}` makes it a power", letter)});
  }
  if (of_symbol && whole == 2) {
    if (const auto square = square_of_triple(reading, raised, span, around)) return *square;
    if (const auto triple = triple_without_index(reading, syntax.symbol(raised), span))
      return *triple ? dot_with_triple(reading, **triple, **triple, span) : MaybeTyped{};
  }
  Around inside = around;
  inside.squared = of_symbol && whole == 2;
  const auto base = elaborate(reading, raised, inside);
  if (!base) return std::nullopt;
  if (is_triple(*base))
    return whole == 2 ? dot_with_triple(reading, *base, *base, span)
                      : unsupported(reading, span, "of a vector of matrices only the square is read");
  if (base->layout != Layout::none) {
    if (whole && of_symbol && !base->free.empty()) guess_no_sum(reading, *base);
    if (whole) return matrix_power(reading, *base, *whole, span);
    const bool hermitian = syntax[exponent].kind == SyntaxKind::symbol &&
                           syntax.symbol(exponent).letter == "H" && syntax.symbol(exponent).lower.empty();
    if (hermitian) return adjoint_of(reading, *base, span);  // nobody has a number H above a matrix
    return unsupported(reading, syntax[exponent].span, "powers of matrices are read with whole numbers only");
  }
  const auto halves = times_exponent(syntax, exponent, 2);
  const bool number_above = !halves && is_number_above(reading, raised, exponent);
  if (!halves && !number_above) {
    return unsupported(reading, syntax[exponent].span,
                       "what stands above is read as a power only where it is a number for sure");
  }
  if (halves == 2) return base;
  if (!base->free.empty()) {
    const std::string& letter = base->free[0].letter;
    return ambiguous(
        reading, span,
        fmt::format("a power of a component with the free index `{}` can be summed over `{}` or not", letter,
                    letter),
        {"write the factors out, or the sum"});
  }
  if (base->rank > 1) return unsupported(reading, span, "a power of a tensor is not decided");
  if (number_above) return real_power(reading, *base, exponent, span, around);
  if (base->rank == 1 && has_complex_numbers(reading.tree, base->id))
    return ambiguous(reading, span,
                     "a power of a complex vector can be one of its length, or of its product with itself",
                     {"write `|…|^2`, or the product with a dot"});
  if (base->rank == 1) {
    if (*halves == 4) return apply_op(reading.tree, Op::dot, span, 0, {*base, *base});
    if (*halves % 4 != 0)
      return unsupported(reading, span,
                         "an odd power of a vector is not defined, and matrices in bold are not read",
                         {"a power of its length is written without bold"});
    const Typed length = apply_op(reading.tree, Op::length, span, 0, {*base});
    return apply_op(reading.tree, Op::power, span, 0, {length}, *halves / 2);
  }
  if (*halves % 2 == 0) return apply_op(reading.tree, Op::power, span, 0, {*base}, *halves / 2);
  const Typed root = apply_op(reading.tree, Op::root, span, 0, {*base});
  return *halves == 1 ? root : apply_op(reading.tree, Op::power, span, 0, {root}, *halves);
}

MaybeTyped elaborate_root(Reading& reading, SyntaxId id, const Around& around) {
  const auto radicand = elaborate(reading, reading.syntax.child(id, 0), around);
  if (!radicand) return std::nullopt;
  if (radicand->rank != 0)
    return wrong_rank(reading, reading.syntax[id].span, "the root of a vector or tensor is not defined");
  if (!radicand->free.empty())
    return unsupported(reading, reading.syntax[id].span,
                       "a root of a component with a free index is not decided");
  return apply_op(reading.tree, Op::root, reading.syntax[id].span, 0, {*radicand});
}

}  // namespace rigor
