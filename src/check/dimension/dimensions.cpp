// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/dimension/dimensions.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "check/constant/natural_units.h"
#include "check/dimension/dimension_words.h"
#include "check/doubt/own_units.h"

namespace rigor {
namespace {

enum class Part : std::uint8_t {
  none,      // not read as it was meant
  source,    // says what its symbols are
  follows,   // proved, or one of a directive's claims: has to agree with the sources
  mistaken,  // refuted
};

/// A step that is not understood may still say what its dimensions are.
bool is_read(const Step& step) {
  return std::ranges::all_of(step.diagnostics, [](const Diagnostic& diagnostic) {
    return diagnostic.kind == DiagnosticKind::unknown_change ||
           diagnostic.kind == DiagnosticKind::no_real_value || diagnostic.severity() == Severity::warning;
  });
}

Part part_of(const DimensionStatement& statement, const Step& step) {
  switch (step.verdict) {
    case Verdict::skipped:
      return Part::none;
    case Verdict::not_understood:
      if (!is_read(step)) return Part::none;
      break;
    case Verdict::refuted:
      return step.expected_refuted ? Part::none : Part::mistaken;
    case Verdict::proved:
      if (!step.measures) return Part::follows;
      break;
    case Verdict::given:
    case Verdict::definition:
    case Verdict::undecided:
    case Verdict::law:
    case Verdict::suspect:
      break;
  }
  return statement.source == DimensionSource::law ? Part::source : Part::follows;
}

class Solving {
 public:
  Solving(const DimensionRecord& record, const SourceMap& sources, FileReport& report)
      : record_(record), sources_(sources), report_(report) {}

  void solve() {
    if (record_.units.empty() && !makes_time_a_number()) {
      weak_time_ = note_reason({});
      take_time(*weak_time_);
    }
    for (const DimensionEquation& fact : record_.facts)
      static_cast<void>(system_.add(fact.left, fact.right,
                                    note_reason({DimensionReason::Kind::statement, fact.right_span})));
    for (const DeclaredUnit& unit : record_.units) declare(unit);
    for (const DimensionStatement& statement : record_.statements) {
      const Part part = part_of(statement, step_of(statement));
      if (part == Part::source && agrees(statement, true)) take(statement);
    }
    for (const DimensionStatement& statement : record_.statements) {
      const Part part = part_of(statement, step_of(statement));
      if (part == Part::follows || part == Part::mistaken) static_cast<void>(agrees(statement, true));
    }
    numbers_count_ = !weak_time_;
    for (const DimensionStatement& statement : record_.statements) {
      if (numbers_count_ && part_of(statement, step_of(statement)) != Part::none) compare_number(statement);
    }
    complete();
    list();
  }

 private:
  Step& step_of(const DimensionStatement& statement) const { return report_.steps[statement.step]; }

  Reason note_reason(DimensionReason reason) {
    reasons_.push_back(reason);
    return static_cast<Reason>(reasons_.size() - 1);
  }

  void take_time(Reason reason) {
    DimensionForm time;
    time.add(time_unknown, 1);
    DimensionForm second;
    second.fixed = Dimension::of(BaseQuantity::time);
    static_cast<void>(system_.add(time, second, reason));
  }

  void declare(const DeclaredUnit& unit) {
    DimensionForm known;
    known.fixed = unit.dimension;
    const Reason reason = note_reason({DimensionReason::Kind::units, unit.span});
    const DimensionWords words(record_, system_, reasons_, sources_);
    const DimensionEquation equation{unit.symbol, known, unit.span, unit.span, Alike::known};
    const auto contradiction = system_.add(unit.symbol, known, reason);
    if (contradiction) report_.diagnostics.push_back(words.describe(equation, *contradiction, unit.span));
  }

  /// Does one statement by itself say that the time is a number?
  bool makes_time_a_number() const {
    return std::ranges::any_of(record_.statements, [](const DimensionStatement& statement) {
      DimensionSystem alone;
      for (const DimensionEquation& equation : statement.equations)
        static_cast<void>(alone.add(equation.left, equation.right, 0));
      DimensionForm time;
      time.add(time_unknown, 1);
      return alone.reduce(time).form.is_none();
    });
  }

  /// Does a statement agree with what is known, together with what is assumed for it? The first equation that
  /// does not is reported.
  bool agrees(const DimensionStatement& statement, bool report) {
    DimensionSystem own(&system_);
    const std::size_t before = reasons_.size();
    for (const std::size_t assumed : statement.assumed) {
      const DimensionStatement& other = record_.statements[assumed];
      for (const DimensionEquation& equation : other.equations) {
        if (is_left_out(equation)) continue;
        static_cast<void>(own.add(equation.left, equation.right, note_reason(written(other, equation))));
      }
    }
    bool agree = true;
    for (const DimensionEquation& equation : statement.equations) {
      if (is_left_out(equation)) continue;
      const Reason reason = note_reason(written(statement, equation));
      const DimensionWords words(record_, own, reasons_, sources_);
      const auto contradiction = own.add(equation.left, equation.right, reason);
      if (!contradiction) continue;
      const bool meant = step_of(statement).verdict != Verdict::proved || words.is_declared(*contradiction);
      if (report && meant)
        say(statement, words.describe(equation, *contradiction, step_of(statement).relation_span), equation);
      agree = false;
      break;
    }
    reasons_.resize(before);
    return agree;
  }

  void compare_number(const DimensionStatement& statement) {
    if (statement.equations.empty() || statement.equations.back().alike != Alike::number) return;
    const DimensionEquation& equation = statement.equations.back();
    const DimensionWords words(record_, system_, reasons_, sources_);
    const auto contradiction = DimensionSystem(&system_).add(equation.left, equation.right, 0);
    if (contradiction)
      say(statement, words.describe(equation, *contradiction, step_of(statement).relation_span), equation);
  }

  void say(const DimensionStatement& statement, Diagnostic diagnostic, const DimensionEquation& equation) {
    Step& step = step_of(statement);
    if (may_be_natural(statement, diagnostic) || has_a_unit_of_the_notes(step)) return;
    const bool doubt = diagnostic.kind == DiagnosticKind::dimension_doubt;
    if (doubt && (step.verdict == Verdict::proved || equation.alike == Alike::components)) return;
    const bool known = std::ranges::any_of(report_.steps, [&](const Step& other) {
      return std::ranges::any_of(other.diagnostics, [&](const Diagnostic& old) {
        return old.kind == diagnostic.kind && old.span == diagnostic.span &&
               old.message == diagnostic.message;
      });
    });
    if (!known) step.diagnostics.push_back(std::move(diagnostic));
  }

  /// `1/m` of `m = 0.511\,\mathrm{MeV}` is a length where ħ and c are 1.
  bool may_be_natural(const DimensionStatement& statement, const Diagnostic& diagnostic) const {
    return mentions_electronvolts(sources_.text(step_of(statement).span)) ||
           std::ranges::any_of(diagnostic.labels, [&](const Label& label) {
             return mentions_electronvolts(sources_.text(label.span));
           });
  }

  /// `1\,\text{F} = 10^{-15}\,\text{m}`: F is no farad in these notes.
  bool has_a_unit_of_the_notes(const Step& step) const {
    return std::ranges::any_of(report_.steps, [&](const Step& each) {
      if (each.verdict != Verdict::undecided) return false;
      const auto unit = unit_introduced(each.left, each.right);
      return unit && writes_unit(step.source, *unit);
    });
  }

  void take(const DimensionStatement& statement) {
    for (const DimensionEquation& equation : statement.equations) {
      if (is_left_out(equation)) continue;
      static_cast<void>(
          system_.add(equation.left, equation.right, note_reason(written(statement, equation))));
    }
  }

  /// `v = 2`: a unit can be left out, so that this is no source; it is compared when all else is known.
  bool is_left_out(const DimensionEquation& equation) const {
    return equation.alike == Alike::number && !numbers_count_;
  }

  DimensionReason written(const DimensionStatement& statement, const DimensionEquation& equation) const {
    const bool whole = equation.alike == Alike::sides || equation.alike == Alike::known;
    return {DimensionReason::Kind::statement,
            whole ? statement.span : cover_if_near(equation.left_span, equation.right_span)};
  }

  static Span cover_if_near(Span first, Span second) {
    return first.file == second.file ? cover(first, second) : second;
  }

  /// What is proved still says what its symbols are, where nothing else does; and t is the time.
  void complete() {
    if (!record_.units.empty()) take_time(note_reason({}));
    for (const DimensionStatement& statement : record_.statements) {
      const Part part = part_of(statement, step_of(statement));
      const bool says = part == Part::source || part == Part::follows;
      if (says && statement.source == DimensionSource::law && agrees(statement, false)) take(statement);
    }
    for (const DimensionStatement& statement : record_.statements) {
      const bool follows = part_of(statement, step_of(statement)) == Part::follows;
      if (follows && statement.source == DimensionSource::local) note_local(statement);
    }
  }

  /// Letters of a directive's claim can mean something else in another one: each claim speaks for itself, and
  /// what two of them find differently stays free.
  void note_local(const DimensionStatement& statement) {
    DimensionSystem own(&system_);
    std::set<Unknown> unknowns;
    const auto take_equations = [&](const DimensionStatement& each) {
      for (const DimensionEquation& equation : each.equations) {
        static_cast<void>(own.add(equation.left, equation.right, 0));
        for (const DimensionForm* form : {&equation.left, &equation.right})
          for (const auto& [unknown, factor] : form->unknowns) unknowns.insert(unknown);
      }
    };
    for (const std::size_t assumed : statement.assumed) take_equations(record_.statements[assumed]);
    take_equations(statement);
    for (const Unknown unknown : unknowns) {
      if (find(system_, unknown)) continue;
      const auto found = find(own, unknown);
      if (!found) continue;
      const auto [entry, is_new] = found_locally_.try_emplace(unknown, found);
      if (!is_new && entry->second != found) entry->second.reset();
    }
  }

  /// The dimension of an unknown, if it is determined.
  static std::optional<Dimension> find(const DimensionSystem& system, Unknown unknown) {
    DimensionForm own;
    own.add(unknown, 1);
    const DimensionForm form = system.reduce(own).form;
    return form.unknowns.empty() && form.is_valid() ? std::optional(form.fixed) : std::nullopt;
  }

  void list() {
    std::set<std::pair<std::string, std::optional<std::string>>> listed;
    for (const SymbolDimension& each : report_.dimensions) listed.emplace(each.symbol, each.dimension);
    for (Unknown unknown = 0; unknown < record_.unknowns.size(); ++unknown) {
      if (!record_.unknowns[unknown].listed) continue;
      std::optional<Dimension> found = find(system_, unknown);
      if (const auto local = found_locally_.find(unknown); !found && local != found_locally_.end())
        found = local->second;
      SymbolDimension entry{record_.unknowns[unknown].text, std::nullopt};
      if (found) entry.dimension = found->text();
      if (listed.emplace(entry.symbol, entry.dimension).second)
        report_.dimensions.push_back(std::move(entry));
    }
  }

  const DimensionRecord& record_;
  const SourceMap& sources_;
  FileReport& report_;
  DimensionSystem system_;
  std::vector<DimensionReason> reasons_;
  std::map<Unknown, std::optional<Dimension>> found_locally_;  // nothing: in two ways
  std::optional<Reason> weak_time_;
  bool numbers_count_ = false;  // what holds only numbers is compared
};

}  // namespace

void solve_dimensions(const DimensionRecord& record, const SourceMap& sources, FileReport& report) {
  Solving(record, sources, report).solve();
}

}  // namespace rigor
