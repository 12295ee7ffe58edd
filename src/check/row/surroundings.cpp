// SPDX-License-Identifier: GPL-3.0-or-later
// What is said around a step: its sentence, the relations in lines of prose, laws above it, and `use`.
#include "check/row/row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "check/place/place.h"
#include "check/prose/denial.h"
#include "check/question/base_letters.h"
#include "check/question/unread.h"
#include "check/scope/definition.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

constexpr std::size_t most_laws = 12;  // the last ones are looked at

/// `a > 0`, `i \ne j`, `x \le y`: letters and numbers in order, and nothing else.
bool orders_letters(const SyntaxTree& syntax, const ParsedChain& chain) {
  const auto is_plain = [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::symbol || syntax[id].kind == SyntaxKind::number;
  };
  const bool letter =
      std::ranges::any_of(chain.sides, [&](SyntaxId id) { return syntax[id].kind == SyntaxKind::symbol; });
  return letter && !chain.written.relations.empty() && std::ranges::all_of(chain.sides, is_plain) &&
         std::ranges::all_of(chain.written.relations,
                             [](const WrittenRelation& relation) { return is_order(relation.kind); });
}

bool share_a_letter(const std::set<std::string>& one, const std::set<std::string>& other) {
  return std::ranges::any_of(one, [&](const std::string& letter) { return other.contains(letter); });
}

/// Those that the definitions of a row's letters lead to: t of `x = a`, where `x = a\cos\omega t`.
std::set<std::string> letters_of_definitions(RowPlace& place, const ParsedChain& parsed) {
  const auto reading = read_here(place, parsed);
  std::set<std::string> letters;
  for (const Side& side : reading->sides) {
    if (!side.typed) continue;
    for (const SymbolId each : symbols_reached(place.tree, place.names.scope, {side.typed->id})) {
      const NameKey* key = key_of(place.names.symbols, base_of(place.tree.symbols, each));
      if (key != nullptr) letters.insert(key->base);
    }
  }
  return letters;
}

bool can_be_assumed(RelationKind kind) {
  return kind == RelationKind::equal || kind == RelationKind::defines || is_order(kind);
}

/// `c`, `-c`, `2c`, `c/2`; not `1/c`
bool is_one_letter(const ExprTree& tree, ExprId id) {
  const ExprNode& node = tree[id];
  if (node.op == Op::symbol) return !tree.symbols[node.symbol].derivation;
  if (node.op != Op::negate && node.op != Op::multiply && node.op != Op::divide) return false;
  std::vector<ExprId> children(tree.children(id).begin(), tree.children(id).end());
  if (node.op == Op::divide && !symbols_in(tree, children[1]).empty()) return false;
  std::erase_if(children, [&](ExprId child) { return symbols_in(tree, child).empty(); });
  return children.size() == 1 && is_one_letter(tree, children[0]);
}

/// `v = gt`, `\kappa = a/b`, not `\psi = c`, `x = 2a`: it says at all times and places what its left side is.
bool is_meaning(const ExprTree& tree, const Equation& equation) {
  return !tree.symbols[tree[equation.left].symbol].derivation && !is_one_letter(tree, equation.right);
}

/// `\mathbf B = (0, 0, B)`
bool is_vector_by_components(const ExprTree& tree, const Equation& equation) {
  const ExprNode& left = tree[equation.left];
  return equation.relation == Relation::equal && left.op == Op::symbol && left.rank == 1 &&
         tree[equation.right].op == Op::tuple;
}

/// How a line stands to a row.
struct LineAtRow {
  bool same_sentence = false;
  bool stated_above = false;  // "We know that $ab = 0$." holds from there on
  bool defines = false;       // it is above, in reach, and may bring in a letter

  [[nodiscard]] bool counts() const { return same_sentence || stated_above || defines; }
};

LineAtRow line_at_row(const RowPlace& place, const SaidInLine& said) {
  const ProseBeside& here = place.notes.prose.beside[place.event];
  if (said.sentence == here.sentence) return {.same_sentence = true};
  if (said.in_passing && said.argument != here.argument) return {};
  const bool above = said.before <= place.event && (said.alone || said.cue == Cue::definition);
  if (!above || !place.notes.prose.sections.reaches(said.place, here.place)) return {};
  return {.stated_above = said.alone && said.sentence < here.sentence,
          .defines = said.cue == Cue::definition};
}

/// A relation in a line is a definition where it brings in a fresh letter, and a condition of its own
/// sentence. `cases`: that are named above the row.
void add_said(RowPlace& place, const SaidInLine& said, const ParsedChain& parsed,
              std::optional<CasesNamed>& cases, Standpoint& at) {
  const auto [same_sentence, stated_above, defines] = line_at_row(place, said);
  if (!same_sentence && !stated_above && !defines) return;
  if (!same_sentence) {
    if (!cases) cases.emplace(place.notes.prose, place.event, place.section);
    if (cases->names_another_since(case_said_in(place.notes.prose, said.sentence, place.section))) return;
  }
  for (const ParsedChain& chain : said.chains) {
    bool understood = !chain.written.relations.empty() && !chain.written.condition && !chain.written.doubt;
    std::vector<Fact> facts;
    const auto reading = read_here(place, chain);
    for (std::size_t k = 0; k < chain.written.relations.size() && understood; ++k) {
      Diagnostics ignored;
      const bool typed = reading->sides[k].typed && reading->sides[k + 1].typed &&
                         can_be_assumed(chain.written.relations[k].kind) && !guess_of(reading->reading());
      const auto claim = typed ? reading->claim(chain, k, false, ignored) : std::nullopt;
      understood = claim.has_value();
      if (!understood) break;
      const ExprNode& left = place.tree[claim->equation.left];
      const bool fresh = left.op == Op::symbol && !seen_in_equation(place.names.scope, left.symbol) &&
                         definition_of(place.names.scope, left.symbol) == nullptr &&
                         claim->equation.relation == Relation::equal &&
                         !symbols_in(place.tree, claim->equation.right).empty();
      if (!same_sentence && !fresh && !stated_above) continue;
      const bool brings_in = same_sentence || (fresh && said.cue == Cue::definition &&
                                               is_said_for_good(place, said, left.symbol));
      Fact fact{claim->equation,
                {},
                said.cue != Cue::none && said.cue != Cue::apart && brings_in,
                said.place,
                said.span};
      const bool meaning = fresh && is_meaning(place.tree, claim->equation);
      fact.at_instant = said.cue == Cue::condition || said.at_place || !meaning;
      fact.proves = fact.proves && (meaning || !said.named);
      fact.text = fmt::format("{} (line {})", said.words.empty() ? written_at(place, said.span) : said.words,
                              place.sources.line_column(said.span.file, said.span.begin).line);
      facts.push_back(std::move(fact));
    }
    at.facts.insert(at.facts.end(), facts.begin(), facts.end());
    if (understood || !(same_sentence || stated_above) || !at.unread.empty()) continue;
    const SyntaxTree& syntax = place.notes.syntax;
    if (share_a_letter(letters_written_in(syntax, chain.sides), letters_written_in(syntax, parsed.sides)))
      at.unread = written_at(place, said.span);
  }
}

/// `S_{ij} = \tfrac12(T_{ij} + T_{ji})` below `T_{ij} = S_{ij} + A_{ij}`: it may say what S is.
bool is_late_definition(const RowPlace& place, const Typed& left, const Typed& right) {
  const ExprNode& node = place.tree[left.id];
  if (node.op != Op::symbol || place.tree.symbols[node.symbol].derivation ||
      place.tree.symbols[node.symbol].declared || definition_of(place.names.scope, node.symbol) != nullptr)
    return false;
  const std::vector<SymbolId> direct = symbols_in(place.tree, right.id);
  return !is_one_of(node.symbol, direct) && is_circular(place.tree, place.names.scope, left, right);
}

}  // namespace

bool is_alternative(const RowPlace& place, const ParsedChain& parsed) {
  if (parsed.written.alternative) return true;
  const ProseBeside& beside = place.notes.prose.beside[place.event];
  const auto before = beside.lead.rfind('\n');
  const auto is_or = [](std::string words) {
    std::erase_if(words, [](char c) { return c == ' ' || c == ','; });
    return words == "or" || words == "orelse";
  };
  return (before != std::string::npos && is_or(beside.lead.substr(before + 1))) || is_or(beside.tail);
}

std::vector<const ParsedChain*> conditions_beside(const RowPlace& place, const ParsedChain& parsed) {
  std::vector<const ParsedChain*> conditions;
  const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[place.event]);
  if (display == nullptr || orders_letters(place.notes.syntax, parsed)) return conditions;
  for (const ParsedChain& chain : display->chains) {
    const bool beside = &chain != &parsed && chain.written.statement == parsed.written.statement &&
                        chain.written.inference == Inference::none && !chain.written.alternative;
    if (beside && orders_letters(place.notes.syntax, chain)) conditions.push_back(&chain);
  }
  return conditions;
}

bool is_condition_beside(const RowPlace& place, const ParsedChain& parsed) {
  const auto* display = std::get_if<ParsedDisplay>(&place.notes.events[place.event]);
  if (display == nullptr || !orders_letters(place.notes.syntax, parsed)) return false;
  if (parsed.written.inference != Inference::none || parsed.written.alternative) return false;
  return std::ranges::any_of(display->chains, [&](const ParsedChain& chain) {
    return chain.written.statement == parsed.written.statement && !chain.written.relations.empty() &&
           !is_order(chain.written.relations[0].kind);
  });
}

Standpoint standpoint(RowPlace& place, const ParsedChain& parsed) {
  Standpoint at{.prose = place.notes.prose,
                .event = place.event,
                .uses = place.above.uses,
                .facts = {},
                .heading = lowered(place.section),
                .unread = {}};
  std::optional<CasesNamed> cases;
  const std::set<std::string> written = letters_written_in(place.notes.syntax, parsed.sides);
  std::optional<std::set<std::string>> defined;
  const auto bears = [&](const SaidInLine& said, const std::set<std::string>& letters) {
    if (share_a_letter(letters, written)) return true;
    if (said.before > place.event || !place.notes.prose.sections.reaches(said.place, at.beside().place))
      return false;
    if (!defined) defined = letters_of_definitions(place, parsed);
    return share_a_letter(letters, *defined);
  };
  for (const SaidInLine& said : place.notes.prose.said) {
    if (!line_at_row(place, said).counts()) continue;
    const bool defines = said.cue == Cue::definition && said.before <= place.event;
    for (std::size_t k = 0; k < said.chains.size(); ++k) {
      if (said.chains[k].written.relations.empty() || !(defines || bears(said, said.letters[k]))) continue;
      add_said(place, said, parsed, cases, at);
      break;
    }
  }
  for (const ParsedChain* chain : conditions_beside(place, parsed)) {
    SaidInLine said{.span = chain->written.span, .cue = Cue::condition, .sentence = at.beside().sentence};
    said.place = at.beside().place;
    said.chains.push_back(*chain);
    add_said(place, said, parsed, cases, at);
  }
  for (const auto& [chain, is_said] : definitions_behind(place, parsed)) {
    SaidInLine said{.span = chain->written.span, .cue = Cue::definition, .sentence = at.beside().sentence};
    said.place = at.beside().place;
    said.chains.push_back(*chain);
    const std::size_t before = at.facts.size();
    const std::string unread = at.unread;
    add_said(place, said, parsed, cases, at);
    if (is_said) continue;
    const auto added = at.facts.begin() + static_cast<std::ptrdiff_t>(before);
    at.facts.erase(std::remove_if(added, at.facts.end(), [](const Fact& fact) { return fact.at_instant; }),
                   at.facts.end());
    at.unread = unread;  // it is a row of its own
  }
  if (at.unread.empty()) at.unread = unread_premise(place, parsed);
  for (const ParsedChain& chain : parsed.assumed) {
    SaidInLine said{.span = chain.written.span, .cue = Cue::condition, .sentence = at.beside().sentence};
    said.words = text_of(chain.written);
    said.place = at.beside().place;
    said.chains.push_back(chain);
    add_said(place, said, parsed, cases, at);
  }
  const std::set<std::string> own = letters_of(text_of(parsed.written));
  for (const auto& [where, span] : place.above.unread_rows) {
    if (!at.unread.empty() || !place.notes.prose.sections.reaches(where, at.beside().place)) continue;
    const std::string text = written_at(place, span);
    const bool shares = std::ranges::any_of(letters_of(text),
                                            [&](const std::string& letter) { return own.contains(letter); });
    if (shares) at.unread = text;
  }
  const std::vector<Fact>& laws = place.above.laws;
  const std::size_t first = laws.size() - std::min(laws.size(), most_laws);
  for (std::size_t k = first; k < laws.size(); ++k) {
    at.facts.push_back(laws[k]);
    Fact& law = at.facts.back();
    law.elsewhere = !place.notes.prose.sections.reaches(law.place, at.beside().place);
    law.proves = law.proves && !law.elsewhere;
  }
  return at;
}

namespace {

/// Proved or suspect by values, constants or laws of the page, and by what it calls sizes. A result announced
/// as a conclusion that does not follow is settled as well.
bool is_settled_by_page(RowPlace& place, const StepReading& row, const Claim& claim, Standpoint& at,
                        Judgement& judgement) {
  if (agrees_with_values(place, row, claim, judgement) || agrees_with_constants(place, row, claim, judgement))
    return true;
  const Judgement by_itself = judgement;
  if (!follows_from_page(place, row, claim, judgement))
    return follows_for_sizes(place, row, claim, judgement) ||
           follows_with_letters_held(place, row, claim, judgement);
  if (judgement.verdict != Verdict::undecided) return true;
  // What follows from another case's definition may follow from what is said here.
  Judgement said = heed_place(place.tree, place.names, claim, by_itself, at, place.options.cache);
  if (said.verdict == Verdict::proved) {
    add_used(place, said.used);
    judgement = std::move(said);
  }
  return true;
}

/// What a refuted row can be instead of wrong, from which the rows below may be proved.
std::optional<Doubt> may_be_a_choice(const RowPlace& place, const StepReading& row, const Claim& claim,
                                     bool late) {
  if (late)
    return Doubt{.message = fmt::format("it may say what `{}` is, and definitions above use that",
                                        written_at(place, place.tree[row.left().typed->id].span)),
                 .help = {"`therefore` or `hence` in its sentence announces a conclusion"},
                 .kind = DiagnosticKind::borrowed};
  if (row.which == 0 && is_vector_by_components(place.tree, claim.equation) &&
      !is_meant_for_all(place.tree, place.names, claim))
    return Doubt{
        .message =
            fmt::format("it may choose the axes by the direction of `{}`", written_at(place, claim.left)),
        .help = {"`rigor: given …` makes it an assumption; `rigor: claim …` asks whether it holds for all "
                 "values"}};
  return std::nullopt;
}

/// For the rows below. `proves`: they may be proved from it, and not only be doubtful for it.
void remember(RowPlace& place, const Claim& claim, const Standpoint& at, bool proves) {
  const std::string text =
      fmt::format("{} (line {})", written_at(place, cover(claim.left, claim.right)),
                  place.sources.line_column(claim.relation.file, claim.relation.begin).line);
  place.found.laws.push_back({claim.equation, text, proves, at.beside().place, claim.relation});
}

bool is_restricted(const Judgement& judgement) {
  return std::ranges::any_of(judgement.diagnostics,
                             [](const Diagnostic& each) { return each.kind == DiagnosticKind::restricted; });
}

}  // namespace

void heed_surroundings(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement) {
  if (row.role != Role::display || !place.heeds_words) return;
  const ParsedChain& parsed = row.parsed;
  if (judgement.verdict == Verdict::proved) {
    heed_proof(place, parsed, claim, judgement);
    return heed_existence(place, row, claim, judgement);
  }
  heed_digits(place, claim, judgement);
  if (judgement.verdict == Verdict::proved) return;
  Standpoint at = standpoint(place, parsed);
  at.denied = denial_of(place.notes.prose, place.event);
  if (!at.denied && is_settled_by_page(place, row, claim, at, judgement)) return;
  if (judgement.verdict == Verdict::refuted)
    at.around =
        said_around(place.notes.prose, place.event, place.sources, parsed.written.span, parsed.written.tag);
  const bool late = row.which == 0 && judgement.verdict == Verdict::refuted && !claim.nearly &&
                    claim.equation.relation == Relation::equal && !announces_a_conclusion(at.beside().lead) &&
                    is_late_definition(place, *row.left().typed, *row.right().typed);
  judgement = heed_place(place.tree, place.names, claim, std::move(judgement), at, place.options.cache);
  add_used(place, judgement.used);
  if (judgement.verdict == Verdict::refuted) {
    if (auto doubt = doubt_of_refutation(place, row, claim)) withdraw(judgement, claim, std::move(*doubt));
  }
  const bool of_operators =
      has_operators(place.tree, claim.equation.left) || has_operators(place.tree, claim.equation.right);
  if (judgement.verdict == Verdict::undecided && !at.denied && (of_operators || is_restricted(judgement)) &&
      is_suspect(place, row, claim, judgement))
    return;
  refute_by_digits(place, parsed, claim, judgement);
  if (judgement.verdict == Verdict::refuted) {
    if (auto choice = may_be_a_choice(place, row, claim, late)) {
      withdraw(judgement, claim, std::move(*choice));
      remember(place, claim, at, true);
    }
  } else if (judgement.verdict == Verdict::law && at.denied) {
    withdraw(judgement, claim,
             {.message = fmt::format("`{}` next to it may say that it does not hold", *at.denied)});
  } else if (judgement.verdict == Verdict::law) {
    state_law(place, row, claim, judgement);
    if (!claim.nearly && judgement.verdict != Verdict::suspect) remember(place, claim, at, false);
  }
}

namespace {

/// "With $N = a^\dagger a$ this becomes"; not "For a sphere, let $V = …$" or "In the second example".
bool is_said_for_good(const std::string& sentence) {
  const std::string text = lowered(sentence);
  return std::ranges::none_of(words_of(text), [](std::string_view word) {
    return is_one_of(word, {"for",    "in",      "at",       "on",      "if",       "near",   "along",
                            "inside", "case",    "example",  "test",    "instance", "first",  "second",
                            "third",  "suppose", "would",    "could",   "exercise", "unless", "when",
                            "only",   "small",   "large",    "not",     "special",  "during", "while",
                            "some",   "student", "students", "authors", "wrong",    "wrongly"});
  });
}

/// "The student writes $p = mv^2$. This is wrong."
bool is_taken_back(const std::vector<ProseSentence>& sentences,
                   std::vector<ProseSentence>::const_iterator said) {
  const auto next = std::next(said);
  if (next == sentences.end() || next->paragraph != said->paragraph) return false;
  const std::string text = lowered(next->text);
  return std::ranges::any_of(words_of(text), [](std::string_view word) {
    return is_one_of(word, {"wrong", "false", "incorrect", "mistake", "mistaken", "untrue"});
  });
}

/// Two meanings of one letter in lines: nothing says which of them holds below.
bool said_once(RowPlace& place, SymbolId letter, const SaidInLine& said) {
  const SyntaxTree& syntax = place.notes.syntax;
  // Who writes it otherwise is not found without reading all lines for each letter.
  const auto begins_with = [&](const ParsedChain& chain) {
    if (chain.sides.size() < 2 || syntax[chain.sides[0]].kind != SyntaxKind::symbol) return std::string{};
    const WrittenSymbol& symbol = syntax.symbol(chain.sides[0]);
    return with_labels(letter_with_marks(symbol), symbol.lower);
  };
  std::set<std::string> own;
  for (const ParsedChain& chain : said.chains) own.insert(begins_with(chain));
  const auto says = [&](const ParsedChain& chain) {
    const std::string begins = begins_with(chain);
    if (begins.empty() || !own.contains(begins)) return false;
    const auto reading = read_here(place, chain);
    return reading->sides[0].typed && place.tree[reading->sides[0].typed->id].symbol == letter;
  };
  return std::ranges::none_of(place.notes.prose.said, [&](const SaidInLine& other) {
    return other.span.begin != said.span.begin && std::ranges::any_of(other.chains, says);
  });
}

}  // namespace

bool is_said_for_good(RowPlace& place, const SaidInLine& said, SymbolId letter) {
  const std::vector<ProseSentence>& sentences = place.notes.prose.sentences;
  const auto sentence = std::ranges::find(sentences, said.sentence, &ProseSentence::number);
  return sentence != sentences.end() && !sentence->asks && is_said_for_good(sentence->text) &&
         !is_taken_back(sentences, sentence) && said_once(place, letter, said);
}

}  // namespace rigor
