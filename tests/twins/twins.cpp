// SPDX-License-Identifier: GPL-3.0-or-later
#include "twins.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>

#include "base/check.h"
#include "check/entry/check.h"
#include "check/entry/read_forms.h"
#include "check/event/notes.h"
#include "check/form/forms.h"
#include "declarations.h"
#include "latex/document/document.h"
#include "random_samples.h"
#include "source/read_file.h"

namespace rigor::twins {
namespace {

bool lies_in(Span inner, Span outer) { return outer.begin <= inner.begin && inner.end <= outer.end; }

const Step* step_at(const FileReport& report, std::size_t relation) {
  const auto found = std::find_if(report.steps.begin(), report.steps.end(),
                                  [&](const Step& step) { return step.relation_span.begin == relation; });
  return found == report.steps.end() ? nullptr : &*found;
}

/// What the help of its diagnostics asks for: `use \\mathbf{p}`, `for all I_{2}`.
std::vector<std::string> uses_asked_for(const Step& step) {
  constexpr std::string_view opening = "`rigor: ";
  std::vector<std::string> uses;
  for (const Diagnostic& diagnostic : step.diagnostics) {
    for (const std::string& help : diagnostic.help) {
      const auto end = help.find('`', opening.size());
      const bool names_it = help.starts_with("`rigor: use ") || help.starts_with("`rigor: for all ");
      if (names_it && end != std::string::npos && help.find("…") > end)
        uses.push_back(help.substr(opening.size(), end - opening.size()));
    }
  }
  return uses;
}

bool has(const Step& step, std::initializer_list<DiagnosticKind> kinds) {
  return std::any_of(step.diagnostics.begin(), step.diagnostics.end(), [&](const Diagnostic& diagnostic) {
    return std::find(kinds.begin(), kinds.end(), diagnostic.kind) != kinds.end();
  });
}

Outcome outcome_of(const Step& step) {
  if (step.verdict == Verdict::proved) return Outcome::proved_equal;
  if (step.verdict == Verdict::refuted && step.counterexample) return Outcome::refuted;
  if (step.verdict == Verdict::law) return Outcome::law_like;
  if (step.verdict == Verdict::undecided)
    return has(step, {DiagnosticKind::follows_from_nothing}) ? Outcome::law_like : Outcome::undecided;
  if (step.verdict != Verdict::not_understood) return Outcome::failed;
  if (has(step, {DiagnosticKind::free_index_mismatch, DiagnosticKind::index_repeats,
                 DiagnosticKind::index_clash, DiagnosticKind::rank_mismatch,
                 DiagnosticKind::ambiguous_reading, DiagnosticKind::no_real_value})) {
    return Outcome::malformed;
  }
  return Outcome::failed;
}

std::string summary_of(const Step& step) {
  std::string summary(rigor::name_of(step.verdict));
  for (const Diagnostic& diagnostic : step.diagnostics)
    summary += fmt::format(" [{}]", info(diagnostic.kind).name);
  return summary;
}

/// The text between relation and relation, as in the notes.
Span left_of(const Step& step) { return {step.span.file, step.span.begin, step.relation_span.begin}; }
Span right_of(const Step& step) { return {step.span.file, step.relation_span.end, step.span.end}; }

constexpr int most_uses = 5;  // rounds: one definition may show the next

/// How many samples for each proved twin; a long run asks for more.
std::uint32_t wanted_samples() {
  const char* wanted = std::getenv("RIGOR_PROPERTY_SAMPLES");
  return wanted == nullptr ? 100 : static_cast<std::uint32_t>(std::strtoul(wanted, nullptr, 10));
}

/// What is proved of the chain at `relation` of these notes is tried on random samples: the first failure.
std::string failure_of_proofs(const std::string& path, std::string text, std::size_t relation) {
  const std::uint32_t wanted = wanted_samples();
  constexpr std::uint64_t seed = 0x7477696e;
  Limits limits;
  limits.steps = 10'000ull * wanted;
  SourceMap sources;
  const FormsReading reading = read_forms_of_text(sources, path, std::move(text), {});
  for (const WrittenFormChain& chain : reading.forms.chains) {
    if (relation < chain.span.begin || relation >= chain.span.end) continue;
    for (std::size_t k = 0; k < chain.steps.size(); ++k) {
      const WrittenStep& step = chain.steps[k];
      if (step.outcome != rigor::Outcome::proved || !step.question) continue;
      Question question = *step.question;
      question.tree = &reading.forms.tree;
      const RandomSamples samples = try_random_samples(question, wanted, seed, limits);
      if (!samples.failed) continue;
      return fmt::format("{}: left {}, right {}", chain.forms[k + 1].source, samples.failed->left,
                         samples.failed->right);
    }
  }
  return {};
}

class Mutations {
 public:
  explicit Mutations(const std::string& path) : path_(path) {
    auto text = read_file(path);
    RIGOR_CHECK(text.has_value(), path);
    text_ = *std::move(text);
    whole_ = check_text(sources_, path_, text_);
    Diagnostics ignored;
    document_ = read_document(sources_, whole_.file, ignored);
    const Notes notes = read_notes(sources_, whole_.file, nullptr, ignored);
    const std::set<std::string> declared = declarations(notes, whole_.steps);
    for (const std::string& line : declared) declarations_ += directive(line);
    for (const std::string& line : meant_for_all(sources_, notes, declared)) meant_ += directive(line);
  }

  Twins all() {
    for (std::size_t item = 0; item < document_.items.size(); ++item) {
      if (const auto* display = std::get_if<Display>(&document_.items[item])) mutate(item, *display);
    }
    return std::move(result_);
  }

 private:
  std::vector<const Step*> proved_in(Span display) const {
    std::vector<const Step*> proved;
    for (const Step& step : whole_.steps) {
      const bool image = step.source.find("(cyclic image") != std::string::npos;  // spoilt with its original
      if (step.verdict == Verdict::proved && !image && lies_in(step.span, display)) proved.push_back(&step);
    }
    return proved;
  }

  bool defines_something(Span display) const {
    return std::any_of(whole_.steps.begin(), whole_.steps.end(), [&](const Step& step) {
      return step.verdict == Verdict::definition && lies_in(step.span, display);
    });
  }

  std::string_view text(Span span) const { return sources_.text(span); }

  std::string directive(std::string_view line) const {
    const bool latex = format_of(path_) == Format::latex;
    return fmt::format(fmt::runtime(latex ? "% rigor: {}\n" : "<!-- rigor: {} -->\n\n"), line);
  }

  std::string heading(const Heading& heading) const {
    if (format_of(path_) == Format::markdown)
      return fmt::format("{} {}\n\n", std::string(static_cast<std::size_t>(heading.level), '#'),
                         heading.title);
    std::string sub;
    for (int level = 1; level < heading.level; ++level) sub += "sub";
    return fmt::format("\\{}section{{{}}}\n\n", sub, heading.title);
  }

  static bool is_for_next(std::string_view directive) {
    constexpr std::array words{"where", "first order", "expect", "skip"};
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return directive.starts_with(word); });
  }

  /// All that the notes say before the display which can matter to it.
  std::string context(std::size_t display) const {
    std::string context;
    std::string pending;  // directives for the next statement only
    for (std::size_t k = 0; k < display; ++k) {
      const Item& item = document_.items[k];
      if (const auto* title = std::get_if<Heading>(&item)) context += heading(*title);
      if (const auto* line = std::get_if<DirectiveLine>(&item)) {
        const std::string_view said = text(line->span);
        if (said.starts_with("claim")) {
          pending.clear();
        } else {
          (is_for_next(said) ? pending : context) += directive(said);
        }
      }
      if (const auto* macro = std::get_if<MacroText>(&item))
        context += fmt::format("{}\n", text(macro->span));
      const auto* other = std::get_if<Display>(&item);
      if (other == nullptr) continue;
      if (defines_something(other->span)) context += fmt::format("{}{}\n\n", pending, text(other->span));
      pending.clear();
    }
    return context + pending;
  }

  struct Judged {
    Outcome outcome = Outcome::failed;
    std::string said = "no step";
    std::string source = {};
    bool open = false;  // a declaration might settle it
    std::vector<std::string> uses = {};
    std::string broken_by = {};
  };

  /// What is said to the step whose relation stands at `relation` of the text.
  Judged judge(std::string text, std::size_t relation) const {
    SourceMap sources;
    const FileReport report = check_text(sources, path_, text, {.repairs = Repairs::none});
    const Step* step = step_at(report, relation);
    if (step == nullptr) return {};
    std::string broken_by;
    if (step->verdict == Verdict::proved) broken_by = failure_of_proofs(path_, std::move(text), relation);
    const bool open = step->verdict == Verdict::law ||
                      has(*step, {DiagnosticKind::follows_from_nothing, DiagnosticKind::ambiguous_reading});
    return {outcome_of(*step),     summary_of(*step),   step->source, open,
            uses_asked_for(*step), std::move(broken_by)};
  }

  /// The same once the definitions that are said elsewhere are said to hold here.
  Judged with_uses(Judged judged, const std::string& before, const std::string& edited,
                   std::size_t relation) const {
    std::string said = before;
    for (int round = 0; round < most_uses && !judged.uses.empty(); ++round) {
      for (const std::string& use : judged.uses) said += directive(use);
      judged = judge(said + edited, said.size() + relation);
      if (judged.outcome == Outcome::refuted) judged.outcome = Outcome::refuted_used;
    }
    return judged;
  }

  void mutate(std::size_t item, const Display& display) {
    const std::vector<const Step*> steps = proved_in(display.span);
    if (steps.empty()) return;
    const std::string before = context(item);
    const std::string own(text(display.span));
    for (const Step* step : steps) {
      ++result_.statements;
      const Judged same = judge(before + own, before.size() + step->relation_span.begin - display.span.begin);
      if (same.outcome != Outcome::proved_equal || same.source != step->source)
        result_.lost.push_back(step->source);
      mutate(*step, display.span, before, own);
    }
  }

  void mutate(const Step& step, Span display, const std::string& before, const std::string& own) {
    const Tokens left = lex(sources_, left_of(step));
    const Tokens right = lex(sources_, right_of(step));
    for (const Tokens* side : {&left, &right}) {
      for (const Edit& edit : slips_of(sources_, *side, {left, right})) {
        const std::size_t longer = side == &left ? edit.text.size() - (edit.span.end - edit.span.begin) : 0;
        const std::size_t relation = step.relation_span.begin + longer;
        const std::string edited = with_edit(own, display.begin, edit);
        Judged judged = judge(before + edited, before.size() + relation - display.begin);
        judged = with_uses(std::move(judged), before, edited, relation - display.begin);
        if (judged.outcome == Outcome::failed || judged.outcome == Outcome::undecided)
          judged = judge(with_edit(text_, 0, edit), relation);
        if (judged.open || judged.outcome == Outcome::undecided) {
          const std::string declared = declarations_ + before + meant_;
          Judged again = judge(declared + edited, declared.size() + relation - display.begin);
          again = with_uses(std::move(again), declared, edited, relation - display.begin);
          if (again.outcome == Outcome::refuted || again.outcome == Outcome::refuted_used)
            again.outcome = Outcome::refuted_declared;
          if (again.outcome == Outcome::refuted_declared || again.outcome == Outcome::malformed)
            judged = again;
        }
        result_.twins.push_back({edit.slip, place_of(step), step.source, judged.source, judged.outcome,
                                 judged.said, judged.broken_by});
      }
    }
  }

  std::string place_of(const Step& step) const {
    return fmt::format("{}:{}", std::filesystem::path(path_).filename().string(),
                       sources_.line_column(step.span.file, step.relation_span.begin).line);
  }

  std::string path_;
  std::string text_;
  SourceMap sources_;
  FileReport whole_;
  std::string declarations_;
  std::string meant_;  // for all values
  Document document_;
  Twins result_;
};

}  // namespace

std::string_view name_of(Outcome outcome) {
  static constexpr std::array<std::string_view, outcome_count> names{
      "refuted", "declared", "used", "proved equal", "malformed", "undecided", "law-like", "failed"};
  return names[static_cast<std::size_t>(outcome)];
}

Twins twins_of(const std::string& path) { return Mutations(path).all(); }

}  // namespace rigor::twins
