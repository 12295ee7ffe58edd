// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/form/written_forms_of_notes.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/event/demand.h"
#include "check/form/notation_of_notes.h"
#include "check/question/question.h"
#include "check/question/question_names.h"
#include "elaborate/notation/elaborate.h"
#include "source/suggest.h"

namespace rigor {
namespace {

/// What is taken as 0 is defined as 0, so that nothing has to know more than definitions.
void define_zeros(ExprTree& tree, Question& question, QuestionNames& names) {
  for (const SymbolId symbol : question.zeroed) {
    const Symbol& zero = tree.symbols[symbol];
    Definition definition{.symbol = symbol};
    if (zero.per_particle) definition.particle = tree.add_particle("p");
    definition.body = zero_of_rank(tree, zero.first_seen, zero.rank, zero.axes);
    question.definitions.push_back(std::move(definition));
    names.definitions.push_back(name_of_zero(tree, symbol));
  }
  question.zeroed.clear();
}

/// π where nobody says that the letter is something else. To the exact side it is any number.
void define_pi(ExprTree& tree, Question& question, std::span<const ExprId> expressions) {
  static constexpr const char* digits =
      "3.1415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679"
      "82148086513282306647093844609550582231725359408128481117450284102701938521105559644622948954930381964"
      "4";
  std::vector<ExprId> roots(expressions.begin(), expressions.end());
  for (const Definition& definition : question.definitions) roots.push_back(definition.body);
  for (const ExprId root : roots) {
    for (const SymbolId symbol : symbols_in(tree, root)) {
      const Symbol& letter = tree.symbols[symbol];
      const bool is_pi = letter.name == "\\pi" && letter.rank == 0 && !letter.per_particle &&
                         !letter.declared && !letter.derivation;
      const bool known = std::ranges::any_of(
          question.definitions, [&](const Definition& definition) { return definition.symbol == symbol; });
      if (!is_pi || known) continue;
      Definition pi{.symbol = symbol};
      pi.body = tree.add_number(letter.first_seen, digits);
      question.definitions.push_back(pi);
    }
  }
}

/// The definitions and assumptions that concern some expressions.
Question question_about(ExprTree& tree, const Names& names, std::span<const ExprId> expressions) {
  if (expressions.empty()) return {};
  Equation same;
  same.left = same.right = expressions.front();
  Question question = prepare(tree, names, same, 0, Precision::exact, 0, expressions).question;
  QuestionNames unnamed;
  define_zeros(tree, question, unnamed);
  define_pi(tree, question, expressions);
  return question;
}

std::vector<IndexId> ids_of(const std::vector<FreeIndex>& free) {
  std::vector<IndexId> ids;
  for (const FreeIndex& each : free) ids.push_back(each.id);
  return ids;
}

std::vector<ParticleId> ids_of(const std::vector<FreeParticle>& free) {
  std::vector<ParticleId> ids;
  for (const FreeParticle& each : free) ids.push_back(each.id);
  return ids;
}

/// Blanks folded.
std::string folded(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!blank) {
      result += c;
    } else if (!result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  while (!result.empty() && result.back() == ' ') result.pop_back();
  return result;
}

/// `T_{\text{rot}}` as `T_{rot}`.
std::string without_text_face(std::string name) {
  static constexpr std::string_view face = "\\text{";
  for (auto at = name.find(face); at != std::string::npos; at = name.find(face)) {
    const auto end = name.find('}', at);
    if (end != std::string::npos) name.erase(end, 1);
    name.erase(at, face.size());
  }
  return name;
}

std::optional<Outcome> outcome_of(const Step& step) {
  switch (step.verdict) {
    case Verdict::proved:
      return Outcome::proved;
    case Verdict::refuted:
      return Outcome::refuted;
    case Verdict::undecided:
      return Outcome::undecided;
    default:
      return std::nullopt;
  }
}

/// The floating-point side and explanations know the common space of three dimensions: the expression, and
/// all that its letters are defined by, must belong to it.
bool is_common(const ExprTree& tree, const NameScope& scope, ExprId root) {
  const auto body_is_common = [&](SymbolId symbol) {
    const auto body = body_of_definition(scope, symbol);
    return !body || is_of_common_space(tree, *body);
  };
  const std::vector<SymbolId> reached = symbols_reached(tree, scope, {root});
  return is_of_common_space(tree, root) && std::ranges::all_of(reached, [&](SymbolId symbol) {
           return body_is_common(symbol) && body_is_common(base_of(tree.symbols, symbol));
         });
}

bool is_common(const ExprTree& tree, const NameScope& scope, const Question& question) {
  const auto sides_are_common = [&](const Equation& equation) {
    return is_common(tree, scope, equation.left) && is_common(tree, scope, equation.right);
  };
  return sides_are_common(question.claim) && std::ranges::all_of(question.assumptions, sides_are_common);
}

/// A tag or a heading; a diagnostic where there is none.
std::optional<NamedPlace> place_asked_for(const Notes& notes, const std::string& name,
                                          Diagnostics& diagnostics) {
  auto place = place_named(notes, name);
  if (place) return place;
  Diagnostic unknown{DiagnosticKind::unknown_anchor,
                     {notes.file, 0, 0},
                     fmt::format("no equation and no section is named `{}`", name)};
  if (const auto near = suggest(name, place_names(notes)))
    unknown.help = {fmt::format("did you mean `{}`?", *near)};
  diagnostics.push_back(std::move(unknown));
  return place;
}

class FormCollector {
 public:
  FormCollector(Ledger& ledger, const FormRequest& request, const Notes& notes, const SourceMap& sources,
                FileReport& report)
      : ledger_(ledger), request_(request), notes_(notes), sources_(sources), report_(report) {}

  FormsReading collect(const Names& start) {
    for (const LedgerEntry& entry : ledger_.entries) {
      if (const auto* statement = std::get_if<Statement>(&entry.what)) add(*statement, *entry.scope);
      if (const auto* line = std::get_if<UnitLine>(&entry.what))
        forms_.units[tree_[line->symbol].symbol] = line->dimension;
    }
    std::shared_ptr<const Names> asked_at = ledger_.end;
    if (request_.at) {
      const auto place = place_asked_for(notes_, *request_.at, report_.diagnostics);
      if (place) asked_at = ledger_.behind_events[place->behind - 1];
    }
    ask(start, *asked_at);
    forms_.notation = notation_of_notes(notes_, *ledger_.end, tree_);
    FormsReading reading;
    reading.forms = std::move(forms_);
    reading.holes = std::move(holes_);
    reading.chains_passed_over = ledger_.passed_over;
    return reading;
  }

 private:
  void add(const Statement& statement, const Names& scope);
  WrittenStep step_of(const Statement& statement, const NameScope& scope, std::size_t which);
  void ask(const Names& start, const Names& scope);
  bool read(SyntaxId id, const std::string& source, const std::set<std::string>& known, Names& names);
  [[nodiscard]] bool is_known(SyntaxId id, const std::string& source, const std::set<std::string>& known,
                              const Names& names);

  Ledger& ledger_;
  ExprTree& tree_ = ledger_.tree;
  const FormRequest& request_;
  const Notes& notes_;
  const SourceMap& sources_;
  FileReport& report_;
  std::vector<WrittenHole> holes_;
  WrittenForms forms_;
};

/// The relation between two sides, with what was asked about it in the definitions of the notes only.
WrittenStep FormCollector::step_of(const Statement& statement, const NameScope& scope, std::size_t which) {
  const WrittenRelation& relation = statement.chain->written.relations[which];
  WrittenStep step = statement.asked[which];
  if (step.question && !is_common(tree_, scope, *step.question)) step = {};
  step.kind = relation.text;
  step.nearly = statement.first_order || relation.kind == RelationKind::nearly;
  if (which < statement.step_count) {
    const Step& decided = report_.steps[statement.first_step + which];
    step.outcome = outcome_of(decided);
    step.stated = decided.verdict == Verdict::law;
    step.defines = decided.verdict == Verdict::definition;
    step.given = decided.verdict == Verdict::given;
    step.expected_refuted = decided.expected_refuted;
  }
  if (step.question) define_zeros(tree_, *step.question, step.names);
  if (auto& nearly = step.nearly_question) define_zeros(tree_, nearly->exact, nearly->names);
  return step;
}

void FormCollector::add(const Statement& statement, const Names& scope) {
  if (!statement.is_settled()) return;
  Names names = scope;
  const WrittenChain& written = statement.chain->written;
  const bool assumed = !is_claimed(statement.role);
  WrittenFormChain forms{
      .tag = written.tag,
      .label = written.label,
      .section = statement.step_count == 0 ? std::string() : report_.steps[statement.first_step].section,
      .headings = headings_at(notes_, statement.event),
      .span = written.span,
      .assumed = assumed,
      .image = statement.chain->image};
  if (!names.scope.frames->empty()) {
    const Frame& frame = names.scope.frames->back();
    forms.frame = FrameNames{frame.rotation, frame.rotating, frame.fixed};
  }
  std::vector<ExprId> expressions;
  std::vector<FreeIndex> free;
  std::vector<FreeParticle> particles;
  for (std::size_t k = 0; k < statement.sides.size(); ++k) {
    WrittenForm form{
        .expr = {}, .source = folded(sources_.text(written.sides[k].span)), .span = written.sides[k].span};
    form.expanded = text_of(written.sides[k].tokens);
    const auto& typed = statement.sides[k];
    form.other_space = typed && !is_common(tree_, names.scope, typed->id);
    if (typed && !form.other_space) {
      form.expr = typed->id;
      expressions.push_back(typed->id);
      merge_free(free, typed->free);
      merge_free(particles, typed->particles);
    }
    forms.forms.push_back(std::move(form));
  }
  forms.indices = ids_of(free);
  forms.particles = ids_of(particles);
  Question question = question_about(tree_, names, expressions);
  forms.definitions = std::move(question.definitions);
  forms.assumptions = std::move(question.assumptions);
  for (std::size_t k = 0; k < written.relations.size(); ++k) {
    forms.steps.push_back(step_of(statement, names.scope, k));
    const std::vector<Equation>& said = forms.steps.back().conditions;
    forms.conditions.insert(forms.conditions.end(), said.begin(), said.end());
  }
  for (std::vector<Equation>* equations : {&forms.assumptions, &forms.conditions}) {
    std::erase_if(*equations, [&](const Equation& equation) {
      return !is_common(tree_, names.scope, equation.left) || !is_common(tree_, names.scope, equation.right);
    });
  }
  if (request_.answer_holes && statement.chain->image == 0 && space_of(scope.symbols) == common_space)
    record_holes({notes_.syntax, tree_, names, *statement.chain, assumed, statement.first_order}, forms,
                 forms_.chains.size(), holes_);
  forms_.chains.push_back(std::move(forms));
}

/// Every letter stands somewhere in the notes, as it is read where they begin or with what is declared here.
bool FormCollector::is_known(SyntaxId id, const std::string& source, const std::set<std::string>& known,
                             const Names& names) {
  std::set<std::string> bases = bases_in(notes_, names);
  bases.insert(known.begin(), known.end());
  std::vector<std::string> plain;
  for (const std::string& base : bases) plain.push_back(without_text_face(base));
  for (const std::string& base : bases_below(notes_.syntax, id, names)) {
    if (bases.contains(base)) continue;
    const std::string letter = without_text_face(base);
    Diagnostic unknown{DiagnosticKind::unknown_quantity, notes_.syntax[id].span,
                       letter == without_text_face(source)
                           ? fmt::format("`{}` is nowhere in the notes", source)
                           : fmt::format("`{}` of `{}` is nowhere in the notes", letter, source)};
    if (const auto near = suggest(letter, plain)) unknown.help = {fmt::format("did you mean `{}`?", *near)};
    report_.diagnostics.push_back(std::move(unknown));
    return false;
  }
  return true;
}

bool FormCollector::read(SyntaxId id, const std::string& source, const std::set<std::string>& known,
                         Names& names) {
  if (!is_known(id, source, known, names)) return false;
  Diagnostics own;
  Reading reading{notes_.syntax, tree_, names, read_letters(notes_.syntax, {id}, names), own};
  const auto typed = elaborate(reading, id);
  report_.diagnostics.insert(report_.diagnostics.end(), own.begin(), own.end());
  if (!typed) return false;
  if (!is_common(tree_, names.scope, typed->id)) {
    report_.diagnostics.push_back(
        {DiagnosticKind::unsupported, notes_.syntax[id].span,
         fmt::format(
             "`{}` belongs to a space other than that of three dimensions, where nothing is evaluated yet",
             source)});
    return false;
  }
  forms_.asked.push_back({source, typed->id, ids_of(typed->free), ids_of(typed->particles)});
  return true;
}

void FormCollector::ask(const Names& start, const Names& scope) {
  Names names = scope;
  const std::set<std::string> known = bases_in(notes_, start);
  bool all = true;
  for (std::size_t k = 0; k < notes_.asked.size(); ++k)
    all = read(notes_.asked[k], request_.asked[k], known, names) && all;
  if (!all) forms_.asked.clear();
  std::vector<ExprId> expressions;
  for (const AskedForm& form : forms_.asked) expressions.push_back(form.expr);
  forms_.definitions = question_about(tree_, names, expressions).definitions;
}

}  // namespace

std::set<const ParsedChain*> chains_of_request(const FormRequest& request, const Notes& notes,
                                               const Names& names, Diagnostics& diagnostics) {
  std::vector<NamedPlace> wanted;
  for (const std::string& name : *request.only) {
    if (auto place = place_asked_for(notes, name, diagnostics)) wanted.push_back(*std::move(place));
  }
  return chains_needed(notes, names, notes.asked, wanted);
}

FormsReading written_forms_of_notes(Ledger& ledger, const FormRequest& request, const Notes& notes,
                                    const Names& start, const SourceMap& sources, FileReport& report) {
  return FormCollector(ledger, request, notes, sources, report).collect(start);
}

}  // namespace rigor
