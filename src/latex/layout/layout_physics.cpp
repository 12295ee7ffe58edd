// SPDX-License-Identifier: GPL-3.0-or-later
// What the physics package abbreviates: derivatives, brackets, vectors, differentials.
#include "base/among.h"
#include "latex/layout/layout_reader.h"
#include "latex/token/words.h"

#include <algorithm>

namespace rigor {
namespace {

struct FenceSigns {
  std::string_view open;
  std::string_view close;
};

/// `\abs{x}` and others around one argument, of mathtools and physics.
std::optional<FenceSigns> fence_signs(std::string_view name) {
  static const WordMap<FenceSigns> fences{{"abs absolutevalue vqty", {"|", "|"}},
                                          {"norm", {"‖", "‖"}},
                                          {"order", {"𝒪(", ")"}},
                                          {"set Bqty", {"{", "}"}},
                                          {"pqty", {"(", ")"}},
                                          {"bqty", {"[", "]"}},
                                          {"ev expval expectationvalue", {"⟨", "⟩"}},
                                          {"bra", {"⟨", "|"}},
                                          {"ket", {"|", "⟩"}},
                                          {"ceil", {"⌈", "⌉"}},
                                          {"floor", {"⌊", "⌋"}}};
  return fences.find(name);
}

/// `\pmqty{a & b \\ c & d}`.
std::optional<FenceSigns> matrix_signs(std::string_view name) {
  static const WordMap<FenceSigns> fences{
      {"mqty matrixquantity", {"", ""}}, {"pmqty", {"(", ")"}}, {"bmqty", {"[", "]"}}, {"vmqty", {"|", "|"}}};
  return fences.find(name);
}

/// The place after the bracket that closes the one at `at`.
std::size_t behind_bracket(TokenView tokens, std::size_t at, std::string_view open, std::string_view close) {
  int depth = 0;
  for (; at < tokens.size(); ++at) {
    if (is_sign(tokens[at], open)) ++depth;
    if (is_sign(tokens[at], close) && --depth == 0) return at + 1;
  }
  return at;
}

Box upright_d() { return letter_box("d", Typeface::upright); }

}  // namespace

bool LayoutReader::physics(std::string_view name) {
  if (derivative(name) || physics_fence(name)) return true;
  if (name == "dd" || name == "differential") {
    Box d = upright_d();
    const auto power = take_optional();
    if (power) d = scripts_box(std::move(d), Box{}, inner(*power));
    push(std::move(d));
    if (is_kind_at(tokens_, at_, TokenKind::begin_group)) push(argument());
    return true;
  }
  if (is_one_of(name, {"vb", "vectorbold", "va", "vectorarrow", "vu", "vectorunit"})) {
    const bool arrow = name == "va" || name == "vectorarrow";
    const bool hat = name == "vu" || name == "vectorunit";
    const Typeface face = next_is("*") ? Typeface::bold_italic : Typeface::bold;
    skip_star();
    Box letter = argument(face);
    if (arrow || hat) {
      Box accent{.kind = BoxKind::accent, .text = arrow ? "→" : "^"};
      accent.parts.push_back(std::move(letter));
      letter = std::move(accent);
    }
    push(std::move(letter));
    return true;
  }
  if (name == "curl" || name == "divergence") {
    push(letter_box("∇", Typeface::upright));
    push(sign_box(name == "curl" ? "×" : "·", SignRole::binary));
    return true;
  }
  return false;
}

/// `\dv[n]{f}{x}`, `\pdv{f}{x}{y}`, `\dv{x}` with its argument after it.
bool LayoutReader::derivative(std::string_view name) {
  static const WordTable signs(R"(dv d  derivative d  pdv ∂  pderivative ∂  partialderivative ∂
      fdv δ  functionalderivative δ)");
  const std::string_view sign = signs.find(name);
  if (sign.empty()) return false;
  skip_star();
  const auto order = take_optional();
  std::vector<TokenView> arguments;
  while (arguments.size() < 3 && at_ < tokens_.size() &&
         (arguments.empty() || tokens_[at_].kind == TokenKind::begin_group))
    arguments.push_back(take_argument());
  const auto d = [&](bool powered) {
    Box box = letter_box(sign, Typeface::upright);
    if (arguments.size() == 3 && powered)
      return scripts_box(std::move(box), Box{}, {.kind = BoxKind::number, .text = "2"});
    return order && powered ? scripts_box(std::move(box), Box{}, inner(*order)) : box;
  };
  std::vector<Box> above;
  above.push_back(d(true));
  if (arguments.size() > 1) above.push_back(inner(arguments[0]));
  std::vector<Box> below;
  for (std::size_t k = arguments.size() > 1 ? 1 : 0; k < arguments.size(); ++k) {
    below.push_back(d(false));
    Box by = inner(arguments[k]);
    below.push_back(order ? scripts_box(std::move(by), Box{}, inner(*order)) : std::move(by));
  }
  push(fraction_box(row_box(std::move(above)), row_box(std::move(below))));
  return true;
}

bool LayoutReader::physics_fence(std::string_view name) {
  if (const auto matrix = matrix_signs(name)) {
    Box cells = table(take_argument(), TableAlignment::centre, {context_.depth + 1, context_.face});
    push(matrix->open.empty() ? std::move(cells) : fence_box(matrix->open, std::move(cells), matrix->close));
    return true;
  }
  if (const auto fence = fence_signs(name)) {
    skip_star();
    Box inside = argument();
    push(fence_box(fence->open, std::move(inside), fence->close));
    return true;
  }
  if (is_one_of(name, {"comm", "commutator", "acomm", "pb", "braket", "innerproduct"})) {
    const bool square = name.starts_with("comm");
    const bool state = name == "braket" || name == "innerproduct";
    std::vector<Box> parts;
    parts.push_back(argument());
    if (is_kind_at(tokens_, at_, TokenKind::begin_group)) {
      parts.push_back(state ? sign_box("|", SignRole::bar) : sign_box(",", SignRole::punctuation));
      parts.push_back(argument());
    }
    push(fence_box(state    ? "⟨"
                   : square ? "["
                            : "{",
                   row_box(std::move(parts)),
                   state    ? "⟩"
                   : square ? "]"
                            : "}"));
    return true;
  }
  if (name != "qty" && name != "quantity" && name != "eval" && name != "evaluated") return false;
  at_ = skip_blank(tokens_, at_);
  if (at_ >= tokens_.size()) return true;
  if (tokens_[at_].kind == TokenKind::begin_group) {
    Box inside = argument();
    push(name.starts_with("eval") ? fence_box("", std::move(inside), "|")
                                  : fence_box("{", std::move(inside), "}"));
    return true;
  }
  static constexpr FenceSigns brackets[] = {{"(", ")"}, {"[", "]"}, {"|", "|"}};
  for (const FenceSigns& each : brackets) {
    if (!is_sign(tokens_[at_], each.open)) continue;
    std::size_t end = behind_bracket(tokens_, at_, each.open, each.close);
    if (each.open == "|") {
      for (end = at_ + 1; end < tokens_.size() && !is_sign(tokens_[end], "|");) ++end;
      end = std::min(end + 1, tokens_.size());
    }
    const std::size_t last = end > at_ + 1 ? end - 1 : end;
    Box inside = inner(tokens_.subspan(at_ + 1, last - at_ - 1));
    at_ = end;
    push(fence_box(each.open, std::move(inside), each.close));
    return true;
  }
  return true;
}

}  // namespace rigor
