// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/form/form_record.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/event/demand.h"
#include "check/form/notation_of_notes.h"
#include "check/question/question.h"
#include "check/question/question_names.h"
#include "source/suggest.h"

namespace rigor {
namespace {

/// What is taken as 0 is defined as 0, so that nothing has to know more than definitions.
void define_zeros(ExprTree& tree, Question& question, QuestionNames& names) {
  for (const SymbolId symbol : question.zeroed) {
    const Symbol& zero = tree.symbols[symbol];
    Definition definition{.symbol = symbol};
    if (zero.per_particle) definition.particle = tree.add_particle("p");
    definition.body = zero_of_rank(tree, zero.first_seen, zero.rank);
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
      const bool known =
          std::any_of(question.definitions.begin(), question.definitions.end(),
                      [&](const Definition& definition) { return definition.symbol == symbol; });
      if (!is_pi || known) continue;
      Definition pi{.symbol = symbol};
      pi.body = tree.add_number(letter.first_seen, digits);
      question.definitions.push_back(pi);
    }
  }
}

/// The definitions and assumptions that concern some expressions.
Question question_about(ExprTree& tree, Names& names, std::span<const ExprId> expressions) {
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

}  // namespace

void FormRecorder::plan(Names& names) {
  known_ = bases_in(notes_, names);
  asked_behind_ = notes_.events.empty() ? 0 : notes_.events.size() - 1;
  const auto find = [&](const std::string& name) {
    auto place = place_named(notes_, name);
    if (place) return place;
    Diagnostic unknown{DiagnosticKind::unknown_anchor,
                       {notes_.file, 0, 0},
                       fmt::format("no equation and no section is named `{}`", name)};
    if (const auto near = suggest(name, place_names(notes_)))
      unknown.help = {fmt::format("did you mean `{}`?", *near)};
    diagnostics_.push_back(std::move(unknown));
    return place;
  };
  if (request_.at) {
    if (const auto place = find(*request_.at)) asked_behind_ = place->behind - 1;
  }
  if (decides()) return;
  std::vector<NamedPlace> wanted;
  for (const std::string& name : *request_.only) {
    if (auto place = find(name)) wanted.push_back(std::move(*place));
  }
  needed_ = chains_needed(notes_, names, notes_.asked, wanted);
}

void FormRecorder::enter(std::size_t event) {
  const auto* heading = std::get_if<Heading>(&notes_.events[event]);
  if (heading == nullptr) return;
  std::erase_if(sections_, [&](const Heading* open) { return open->level >= heading->level; });
  sections_.push_back(heading);
}

void FormRecorder::note(Span relation, Judgement& judgement) {
  WrittenStep step;
  if (!judgement.of_another_question) {
    step.question = std::move(judgement.question);
    step.question->tree = nullptr;
  }
  step.sample = std::move(judgement.sample);
  step.names = std::move(judgement.names);
  step.nearly_question = std::move(judgement.nearly_question);
  if (step.nearly_question) step.nearly_question->exact.tree = nullptr;
  decided_.emplace_back(relation, std::move(step));
}

void FormRecorder::add(ExprTree& tree, Names& names, const Chain& chain) {
  const WrittenChain& written = chain.parsed.written;
  WrittenFormChain forms{.tag = written.tag,
                         .label = written.label,
                         .section = chain.steps.empty() ? std::string() : chain.steps[0].section,
                         .span = written.span,
                         .assumed = chain.assumed,
                         .image = chain.parsed.image};
  for (const Heading* heading : sections_) forms.headings.push_back(heading->title);
  if (!names.frames().empty()) {
    const Frame& frame = names.frames().back();
    forms.frame = FrameNames{frame.rotation, frame.rotating, frame.fixed};
  }
  std::vector<ExprId> expressions;
  std::vector<FreeIndex> free;
  std::vector<FreeParticle> particles;
  for (std::size_t k = 0; k < chain.reading.sides.size(); ++k) {
    WrittenForm form{
        .expr = {}, .source = folded(sources_.text(written.sides[k].span)), .span = written.sides[k].span};
    form.expanded = text_of(written.sides[k].tokens);
    if (const auto& typed = chain.reading.sides[k].typed) {
      form.expr = typed->id;
      expressions.push_back(typed->id);
      merge_free(free, typed->free);
      merge_free(particles, typed->particles);
    }
    forms.forms.push_back(std::move(form));
  }
  forms.indices = ids_of(free);
  forms.particles = ids_of(particles);
  Question question = question_about(tree, names, expressions);
  forms.definitions = std::move(question.definitions);
  forms.assumptions = std::move(question.assumptions);
  for (std::size_t k = 0; k < written.relations.size(); ++k) {
    WrittenStep step;
    for (auto& [relation, noted] : decided_) {
      if (relation == written.relations[k].span) step = std::move(noted);
    }
    step.kind = written.relations[k].text;
    step.nearly = chain.first_order || written.relations[k].kind == RelationKind::nearly;
    if (k < chain.steps.size()) {
      step.outcome = outcome_of(chain.steps[k]);
      step.defines = chain.steps[k].verdict == Verdict::definition;
      step.given = chain.steps[k].verdict == Verdict::given;
      step.expected_refuted = chain.steps[k].expected_refuted;
    }
    if (step.question) define_zeros(tree, *step.question, step.names);
    if (auto& nearly = step.nearly_question) define_zeros(tree, nearly->exact, nearly->names);
    forms.steps.push_back(std::move(step));
  }
  decided_.clear();
  if (request_.answer_holes && chain.parsed.image == 0)
    record_holes({notes_.syntax, tree, names, chain.parsed, chain.assumed, chain.first_order}, forms,
                 forms_.chains.size(), holes_);
  forms_.chains.push_back(std::move(forms));
}

/// Every letter stands somewhere in the notes, as it is read where they begin or with what is declared here.
bool FormRecorder::is_known(SyntaxId id, const std::string& source, Names& names) {
  std::set<std::string> bases = bases_in(notes_, names);
  bases.insert(known_.begin(), known_.end());
  std::vector<std::string> known;
  for (const std::string& base : bases) known.push_back(without_text_face(base));
  for (const std::string& base : bases_below(notes_.syntax, id, names)) {
    if (bases.contains(base)) continue;
    const std::string letter = without_text_face(base);
    Diagnostic unknown{DiagnosticKind::unknown_quantity, notes_.syntax[id].span,
                       letter == without_text_face(source)
                           ? fmt::format("`{}` is nowhere in the notes", source)
                           : fmt::format("`{}` of `{}` is nowhere in the notes", letter, source)};
    if (const auto near = suggest(letter, known)) unknown.help = {fmt::format("did you mean `{}`?", *near)};
    diagnostics_.push_back(std::move(unknown));
    return false;
  }
  return true;
}

bool FormRecorder::read(SyntaxId id, const std::string& source, ExprTree& tree, Names& names) {
  if (!is_known(id, source, names)) return false;
  Diagnostics own;
  Elaborator elaborator(notes_.syntax, tree, names, read_letters(notes_.syntax, {id}, names), own);
  const auto typed = elaborator.expression(id);
  diagnostics_.insert(diagnostics_.end(), own.begin(), own.end());
  if (!typed) return false;
  forms_.asked.push_back({source, typed->id, ids_of(typed->free), ids_of(typed->particles)});
  return true;
}

void FormRecorder::ask(std::size_t event, ExprTree& tree, Names& names) {
  if (event != asked_behind_) return;
  bool all = true;
  for (std::size_t k = 0; k < notes_.asked.size(); ++k)
    all = read(notes_.asked[k], request_.asked[k], tree, names) && all;
  if (!all) forms_.asked.clear();
  std::vector<ExprId> expressions;
  for (const AskedForm& form : forms_.asked) expressions.push_back(form.expr);
  forms_.definitions = question_about(tree, names, expressions).definitions;
}

void FormRecorder::see(const ExprTree& tree, Names& names) {
  forms_.notation = notation_of_notes(notes_, names, tree);
}

FormsReading FormRecorder::finish(ExprTree&& tree) && {
  forms_.tree = std::move(tree);
  FormsReading reading;
  reading.forms = std::move(forms_);
  reading.holes = std::move(holes_);
  reading.chains_passed_over = passed_over_;
  return reading;
}

}  // namespace rigor
