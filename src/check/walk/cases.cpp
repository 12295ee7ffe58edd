// SPDX-License-Identifier: GPL-3.0-or-later
// One case of `f(x) = \begin{cases} … \end{cases}`, and rows for which it is known which case holds. What a
// case says of its letters is assumed for its own row. What it defines holds where its conditions do, and
// nowhere else: not under an integral, not at a value `f(0)`, and at the border without derivatives.
#include "check/walk/topics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/prose/open_words.h"
#include "check/prose/restrictions.h"
#include "check/scope/definition.h"
#include "check/word/prose_words.h"
#include "elaborate/name/function_value.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

/// Nothing where one of its relations cannot be read.
std::optional<std::vector<Equation>> relations_of(Walk& walk, const ParsedChain& condition) {
  if (condition.written.condition || condition.written.doubt) return std::nullopt;
  std::vector<Equation> relations;
  auto reading = read_chain(walk.notes.syntax, walk.tree, walk.names, condition, {});
  add_used(walk, reading->used());
  for (std::size_t k = 0; k < condition.written.relations.size(); ++k) {
    Diagnostics ignored;
    if (!reading->sides[k].typed || !reading->sides[k + 1].typed) return std::nullopt;
    const auto claim = reading->claim(condition, k, false, ignored);
    if (!claim || !ignored.empty()) return std::nullopt;
    relations.push_back(claim->equation);
  }
  return relations;
}

/// "For $x > 0$ we have", "Inside the sphere, $r < R$, this gives": words that say no more than that it holds
/// then. "For $x$ other than $x > 0$" says another thing, and so may what is in no list.
bool says_only_when(std::string_view lead) {
  static constexpr auto known = std::to_array<std::string_view>(
      {"for",  "if",    "when",     "where",    "in",       "the",    "region",    "range",   "interval",
       "case", "all",   "every",    "any",      "inside",   "sphere", "cylinder",  "then",    "we",
       "have", "get",   "find",     "obtain",   "one",      "has",    "gets",      "finds",   "this",
       "that", "gives", "so",       "thus",     "hence",    "it",     "follows",   "becomes", "reads",
       "is",   "now",   "solution", "function", "equation", "and",    "therefore", "which",   "there"});
  const std::string text = lowered(lead.substr(lead.rfind('\n') + 1));
  return std::ranges::all_of(words_of(text),
                             [&](std::string_view word) { return word == "$" || is_one_of(word, known); });
}

/// What is known at the row: next to it, or of a row that is no case, in the words before it.
std::vector<Equation> known_at(Walk& walk, const ParsedChain& parsed) {
  std::vector<Equation> known;
  const auto add = [&](const ParsedChain& condition) {
    const auto relations = relations_of(walk, condition);
    if (relations) known.insert(known.end(), relations->begin(), relations->end());
  };
  for (const ParsedChain& condition : parsed.assumed) add(condition);
  if (parsed.written.of_cases) return known;
  const ProseBeside& beside = walk.notes.prose.beside[walk.event];
  if (!says_only_when(beside.lead)) return known;
  std::vector<const SaidInLine*> conditions;
  for (const SaidInLine& said : walk.notes.prose.said) {
    const bool here = said.sentence == beside.sentence && said.cue == Cue::condition &&
                      said.before == walk.event && !said.at_place && said.words.empty();
    if (here) conditions.push_back(&said);
  }
  if (conditions.size() != 1) return known;  // of two, the row may be about either
  for (const ParsedChain& condition : conditions.front()->chains) add(condition);
  return known;
}

/// `x > 0` implies `x \ge 0` and `x \ne 0`.
bool implies(const ExprTree& tree, const Equation& known, const Equation& wanted) {
  const auto same = [&](ExprId a, ExprId b) { return same_expression(tree, a, tree, b); };
  const bool straight = same(known.left, wanted.left) && same(known.right, wanted.right);
  const bool turned = same(known.left, wanted.right) && same(known.right, wanted.left);
  const bool symmetric = wanted.relation == Relation::equal || wanted.relation == Relation::unequal;
  if (known.relation == wanted.relation) return straight || (turned && symmetric);
  if (known.relation != Relation::less) return false;
  if (wanted.relation == Relation::unequal) return straight || turned;
  return straight && wanted.relation == Relation::less_or_equal;
}

/// Does it hold in a neighbourhood, too, so that rates and slopes can be taken?
bool is_open_condition(const Equation& condition) {
  return condition.relation == Relation::less || condition.relation == Relation::unequal;
}

enum class Holds : std::uint8_t { no, at_the_border, inside };

Holds holds(const ExprTree& tree, const std::vector<Equation>& known, const CaseDefinition& of) {
  bool inside = true;
  for (const Equation& wanted : of.conditions) {
    const auto by = [&](const Equation& each) { return implies(tree, each, wanted); };
    if (std::ranges::none_of(known, by)) return Holds::no;
    inside = inside && std::ranges::any_of(
                           known, [&](const Equation& each) { return by(each) && is_open_condition(each); });
  }
  return inside ? Holds::inside : Holds::at_the_border;
}

/// Is it written at values, `f(0)`, or under an integral? There the letter of its condition is another one.
bool is_meant_elsewhere(const Walk& walk, SymbolId symbol) {
  const SymbolTable& symbols = walk.tree.symbols;
  const auto is_about = [&](SymbolId each) { return base_of(symbols, each) == symbol; };
  for (const auto& [value, of] : walk.names.symbols.function_values) {
    if (is_about(of.of)) return true;
  }
  for (std::size_t k = 0; k < symbols.size(); ++k) {
    const auto& integral = symbols[static_cast<SymbolId>(k)].integral;
    if (!integral) continue;
    if (std::ranges::any_of(symbols_reached(walk.tree, walk.names.scope, parts_of(*integral)), is_about))
      return true;
  }
  return false;
}

bool is_differentiated(const Walk& walk, SymbolId symbol) {
  const SymbolTable& symbols = walk.tree.symbols;
  for (std::size_t k = 0; k < symbols.size(); ++k) {
    const auto id = static_cast<SymbolId>(k);
    if (id != symbol && symbols[id].derivation && base_of(symbols, id) == symbol) return true;
  }
  return false;
}

/// Is there a bound letter in the row, so that it speaks of more than one place?
bool binds_letters(const Walk& walk, const ParsedChain& parsed) {
  return std::ranges::any_of(nodes_below(walk.notes.syntax, parsed.sides), [&](SyntaxId id) {
    const SyntaxKind kind = walk.notes.syntax[id].kind;
    return kind == SyntaxKind::integral || kind == SyntaxKind::line_integral || kind == SyntaxKind::between ||
           kind == SyntaxKind::big_sum;
  });
}

void define_where_known(Walk& walk, const ParsedChain& parsed, const std::vector<Equation>& known,
                        CaseInForce& in_force) {
  if (binds_letters(walk, parsed)) return;
  for (const CaseDefinition& each : walk.above.cases) {
    const SymbolId symbol = each.definition.symbol;
    const bool reaches =
        walk.notes.prose.sections.reaches(each.place, walk.notes.prose.beside[walk.event].place);
    if (!reaches || definition_of(walk.names.scope, symbol) != nullptr) continue;
    const Holds where = holds(walk.tree, known, each);
    if (where == Holds::no || is_meant_elsewhere(walk, symbol)) continue;
    if (where == Holds::at_the_border && is_differentiated(walk, symbol)) continue;
    if (where == Holds::at_the_border) in_force.at_border.push_back(symbol);
    Origin origin{each.name, walk.section, std::nullopt};
    origin.place = each.place;
    origin.event = each.event;
    define(walk.names.scope, {each.definition, std::move(origin), walk.names.scope.depth});
    in_force.defined.push_back(symbol);
  }
}

/// The row is about all values of what its condition is about, `x` of `x < L`: a letter that is varied, or of
/// which the page says nothing, and not a bound. Not so where words around it may restrict it further.
void mean_for_all_values(Walk& walk, const ParsedChain& parsed, const std::vector<Equation>& conditions) {
  const Prose& prose = walk.notes.prose;
  const bool conditional = std::ranges::any_of(prose.said, [&](const SaidInLine& said) {
    return said.sentence == prose.beside[walk.event].sentence && said.cue == Cue::condition;
  });
  const WrittenChain& written = parsed.written;
  if (conditional || open_word(prose, walk.event) ||
      said_around(prose, walk.event, walk.sources, written.span, written.tag))
    return;
  const auto is_letter = [&](ExprId side) { return walk.tree[side].op == Op::symbol; };
  const auto is_varied = [&](SymbolId symbol) {
    return is_free_variable(walk.names, walk.tree, symbol, By::space) ||
           is_free_variable(walk.names, walk.tree, symbol, By::time);
  };
  const auto is_told = [&](SymbolId symbol) {
    return std::ranges::any_of(walk.above.stated, [&](const StatedLaw& stated) {
      const Equation& law = stated.law.equation;
      return is_one_of(symbol, symbols_reached(walk.tree, walk.names.scope, {law.left, law.right}));
    });
  };
  for (const Equation& each : conditions) {
    const bool may_bound = is_letter(each.left) && is_letter(each.right);  // `r < R`
    for (const ExprId side : {each.left, each.right}) {
      if (!is_letter(side)) continue;
      const SymbolId symbol = walk.tree[side].symbol;
      if (is_varied(symbol) || (!may_bound && !is_told(symbol))) mean_for_all(walk.names.scope, symbol);
    }
  }
}

}  // namespace

CaseInForce enter_case(Walk& walk, const ParsedChain& parsed, const Context& context) {
  CaseInForce in_force{.for_all = walk.names.scope.for_all, .sample = walk.sample};
  if (context.role != Role::display) return in_force;
  const bool of_cases = parsed.written.of_cases;
  if (!of_cases && walk.above.cases.empty()) return in_force;
  in_force.known = known_at(walk, parsed);
  if (of_cases) {
    for (const ParsedChain& condition : parsed.assumed) {
      const auto relations = relations_of(walk, condition);
      const std::string text = text_of(condition.written);
      if (!relations) {
        walk.unread_case = Diagnostic{DiagnosticKind::unsupported, condition.written.span,
                                      fmt::format("the condition `{}` of this case is not read", text)};
        return in_force;
      }
      for (const Equation& each : *relations) {
        Origin origin{fmt::format("case {}", text), walk.section, std::nullopt};
        in_force.assumed.push_back(origin.text);
        const bool of_one_value = each.relation == Relation::equal;  // which says nothing of slopes there
        assume(walk.names.scope, {each, std::move(origin), walk.names.scope.depth, of_one_value});
        in_force.conditions.push_back(each);
      }
    }
    if (!in_force.assumed.empty() && decides(walk) && !is_in_doubt(walk) && !find_sample(walk))
      walk.unread_case = Diagnostic{DiagnosticKind::unsupported, parsed.written.span,
                                    "no values were found for which this case holds"};
    mean_for_all_values(walk, parsed, in_force.conditions);
  }
  define_where_known(walk, parsed, in_force.known, in_force);
  return in_force;
}

void heed_other_places(Walk& walk, CaseInForce& in_force) {
  std::erase_if(in_force.defined, [&](SymbolId symbol) {
    const bool elsewhere = is_meant_elsewhere(walk, symbol) ||
                           (is_one_of(symbol, in_force.at_border) && is_differentiated(walk, symbol));
    if (elsewhere) forget_definition(walk.names.scope, symbol);
    return elsewhere;
  });
}

void leave_case(Walk& walk, CaseInForce in_force) {
  forget_definitions(walk.names.scope, in_force.defined);
  if (!in_force.assumed.empty())
    walk.names.scope.assumptions.erase_if(
        [&](const NamedAssumption& each) { return is_one_of(each.origin.text, in_force.assumed); });
  walk.names.scope.for_all = std::move(in_force.for_all);
  walk.sample = std::move(in_force.sample);
  walk.unread_case.reset();
}

void define_case(Walk& walk, const Definition& definition, const ParsedChain& parsed, std::string name) {
  std::vector<CaseDefinition>& cases = walk.above.cases;
  std::erase_if(cases, [&](const CaseDefinition& each) {
    return each.definition.symbol == definition.symbol && each.event != walk.event;
  });
  forget_definition(walk.names.scope, definition.symbol);
  if (parsed.written.doubt) return;
  std::vector<std::string> texts;
  CaseDefinition made{definition, {}, std::move(name), 0, walk.event};
  for (const ParsedChain& condition : parsed.assumed) {
    texts.push_back(text_of(condition.written));
    const auto relations = relations_of(walk, condition);
    if (!relations) return;
    made.conditions.insert(made.conditions.end(), relations->begin(), relations->end());
  }
  made.name += fmt::format(", where {}", fmt::join(texts, " and "));
  made.place = walk.notes.prose.beside[walk.event].place;
  cases.push_back(std::move(made));
}

bool renames_cases(Walk& walk, const Judgement& judgement, const ParsedChain& parsed, const Typed& left,
                   const Typed& right, Step& step) {
  const ExprNode& node = walk.tree[left.id];
  if (judgement.verdict == Verdict::proved || node.op != Op::symbol) return false;
  std::vector<CaseDefinition>& cases = walk.above.cases;
  const auto is_earlier = [&](const CaseDefinition& each) {
    return each.definition.symbol == node.symbol && each.event != walk.event;
  };
  if (std::ranges::none_of(cases, is_earlier)) return false;
  const auto definition = as_definition(walk.tree, walk.names.scope, left, right);
  const bool concludes = announces_a_conclusion(walk.notes.prose.beside[walk.event].lead);
  if (!parsed.written.of_cases || !definition || concludes) {
    // Which of the two holds below, nobody knows.
    std::erase_if(cases, is_earlier);
    return false;
  }
  define_case(walk, *definition, parsed,
              fmt::format("definition {} {}", written_at(walk.sources, node.span),
                          name_of_place(walk.sources, parsed)));
  step.verdict = Verdict::definition;
  step.route = "definition, for one case, in the place of an earlier one";
  return true;
}

bool is_next_case(const Walk& walk, const ParsedChain& parsed, SymbolId symbol) {
  return parsed.written.of_cases && std::ranges::any_of(walk.above.cases, [&](const CaseDefinition& each) {
           return each.definition.symbol == symbol && each.event == walk.event;
         });
}

}  // namespace rigor
