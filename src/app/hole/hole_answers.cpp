// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hole/hole_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "app/hole/hole_text.h"
#include "app/hole/write_back.h"
#include "base/among.h"
#include "check/entry/read_forms.h"
#include "expr/print/print_latex.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

constexpr int most_rounds = 16;

/// A hole on the way to its answer.
struct OpenHole {
  const WrittenHole* written = nullptr;
  HoleAnswer answer = {};
  HolePlace place = {};
  std::vector<std::string> candidates = {};
  std::set<std::string> moving = {};  // candidates that hold the other side as a whole
  std::size_t tried = 0;
  std::string obstacle = {};
  std::optional<std::string> would_be = {};  // refuted, though anything that fits equals it
  bool repeats_other = false;                // what is on the other side was found
  bool settled = false;

  [[nodiscard]] bool is_trying() const { return !settled && tried < candidates.size(); }
};

class Answering {
 public:
  Answering(const HoleNotes& notes, AnswerForm form) : notes_(notes), wanted_{.form = form} {}

  HoleAnswers run() {
    read();
    if (result_.reading.forms.asked.size() < notes_.by.size()) return std::move(result_);
    for (const AskedForm& asked : result_.reading.forms.asked) wanted_.by.push_back(asked.expr);
    for (const WrittenHole& hole : result_.reading.holes) {
      if (is_asked(hole)) open(hole);
    }
    for (int round = 0; round < most_rounds && any_trying(); ++round) try_all();
    for (OpenHole& hole : open_) result_.holes.push_back(close(hole));
    return std::move(result_);
  }

 private:
  void read() {
    FormRequest request{.at = notes_.at, .sidecar = notes_.sidecar, .statement = notes_.statement};
    request.answer_holes = true;
    request.asked = notes_.by;
    result_.reading = read_forms_of_text(result_.sources, notes_.path, notes_.text, request);
    for (const std::string& place : notes_.places) {
      const bool known =
          std::ranges::any_of(result_.reading.forms.chains,
                              [&](const WrittenFormChain& chain) { return stands_at(chain, place); });
      if (!known) result_.unknown_places.push_back(place);
    }
  }

  bool is_asked(const WrittenHole& hole) const {
    if (notes_.statement) return hole.span.file == *result_.reading.statement;
    const WrittenFormChain& chain = result_.reading.forms.chains[hole.chain];
    return notes_.places.empty() || std::ranges::any_of(notes_.places, [&](const std::string& place) {
             return stands_at(chain, place);
           });
  }

  FileId own_file() const {
    return notes_.statement ? *result_.reading.statement : result_.reading.report.file;
  }

  void open(const WrittenHole& written) {
    OpenHole hole{.written = &written};
    hole.answer.span = written.span;
    hole.answer.troubles = written.troubles;
    const auto trouble = [&](std::string message, std::vector<std::string> help = {}) {
      hole.answer.troubles.push_back(
          {DiagnosticKind::hole, written.span, std::move(message), {}, std::move(help)});
    };
    if (written.span.file != own_file()) {
      trouble(fmt::format("it is in `{}`, which another file reads", result_.sources.path(written.span.file)),
              {"ask for that file by itself"});
    } else {
      hole.answer.written_there = is_written_hole(result_.sources, written.span);
      if (!hole.answer.written_there)
        trouble("it comes from a macro, so nothing can replace it", {"write the square itself"});
    }
    if (written.alone && written.troubles.empty())
      hole.answer.other = source_of(written.chain, written.partner);
    hole.place = place_of(result_.sources, written.span, written.alone);
    if (hole.answer.troubles.empty()) propose_for(hole);
    open_.push_back(std::move(hole));
  }

  void propose_for(OpenHole& hole) {
    const std::string other = bare(source_of(hole.written->chain, hole.written->partner));
    for (const HoleReading& reading : hole.written->readings) {
      if (reading.takes_anything) {
        hole.obstacle = "every value fits: it is multiplied by 0";
        continue;
      }
      HoleProblem problem{.question = reading.questions[0],
                          .claim = reading.claim,
                          .hole = reading.symbol,
                          .node = reading.node,
                          .names = {},
                          .nearly = reading.nearly,
                          .small = reading.small};
      for (const FittingName& name : reading.names) problem.names.push_back(name.expr);
      Proposals proposals = propose(result_.reading.forms.tree, problem, wanted_);
      if (hole.obstacle.empty()) hole.obstacle = proposals.obstacle;
      hole.answer.impossible = hole.answer.impossible || proposals.impossible;
      if (proposals.may_be_added) {
        const std::string part = print(hole, *proposals.may_be_added);
        hole.answer.freedom = proposals.any_vector
                                  ? fmt::format(R"(`{}` with any vector `\mathbf{{w}}` can be added)", part)
                                  : fmt::format("any multiple of `{}` can be added", part);
      }
      if (wanted_.form == AnswerForm::collected) add_forms_of_notes(hole, reading, other);
      if (proposals.refuted_necessary) {
        hole.would_be = print(hole, *proposals.necessary);
        continue;
      }
      hole.answer.among_small = hole.answer.among_small || !reading.small.empty();
      for (const ExprId value : proposals.values) {
        const std::string latex = print(hole, value);
        if (holds(value, reading.claim.left)) hole.moving.insert(latex);
        add(hole, latex, other);
      }
    }
  }

  bool holds(ExprId whole, ExprId part) const {
    const ExprTree& tree = result_.reading.forms.tree;
    return !symbols_in(tree, part).empty() && std::ranges::any_of(nodes_below(tree, {whole}), [&](ExprId id) {
      return same_expression(tree, id, tree, part);
    });
  }

  /// What the notes write with no other symbols than those that are wanted.
  void add_forms_of_notes(OpenHole& hole, const HoleReading& reading, const std::string& other) const {
    const ExprTree& tree = result_.reading.forms.tree;
    std::set<SymbolId> known;
    for (const ExprId each : wanted_.by) {
      for (const SymbolId symbol : symbols_in(tree, each)) known.insert(symbol);
    }
    for (const WrittenFormChain& chain : result_.reading.forms.chains) {
      if (&chain == &result_.reading.forms.chains[hole.written->chain]) continue;
      for (const WrittenForm& form : chain.forms) {
        if (!form.expr || tree[*form.expr].rank != tree[reading.node].rank) continue;
        const std::vector<SymbolId> symbols = symbols_in(tree, *form.expr);
        const bool fits = !symbols.empty() && std::ranges::all_of(symbols, [&](SymbolId symbol) {
          return known.contains(symbol);
        });
        if (fits) add(hole, form.source, other);
      }
    }
  }

  /// What is on the other side already says nothing, unless it is a number.
  static void add(OpenHole& hole, std::string latex, const std::string& other) {
    const bool number = !other.empty() && other.find_first_not_of("0123456789.") == std::string::npos;
    if (hole.written->alone && bare(latex) == other && !number) {
      hole.repeats_other = true;
      return;
    }
    const bool known = is_one_of(latex, hole.candidates);
    if (!known) hole.candidates.push_back(std::move(latex));
  }

  std::string print(const OpenHole& hole, ExprId id) const {
    const WrittenForms& forms = result_.reading.forms;
    return print_latex(forms.tree, id, notation_at(forms, forms.chains[hole.written->chain]));
  }

  const std::string& source_of(std::size_t chain, std::size_t side) const {
    return result_.reading.forms.chains[chain].forms[side].source;
  }

  bool any_trying() const { return std::ranges::any_of(open_, &OpenHole::is_trying); }

  /// The next candidates are put in, and all is read again.
  void try_all() {
    std::vector<PlacedText> replacements;
    for (const OpenHole& hole : open_) {
      if (hole.settled || hole.is_trying())
        replacements.push_back({hole.answer.span, placed(hole.candidates[hole.tried], hole.place)});
    }
    FormRequest request{.at = notes_.at, .sidecar = notes_.sidecar, .statement = notes_.statement};
    std::string text = notes_.text;
    std::string& changed = notes_.statement ? *request.statement : text;
    changed = with_replacements(std::move(changed), std::move(replacements));
    SourceMap sources;
    const FormsReading again = read_forms_of_text(sources, notes_.path, std::move(text), request);
    for (OpenHole& hole : open_) {
      if (!hole.settled && !hole.is_trying()) continue;
      settle(hole, again);
    }
  }

  static void settle(OpenHole& hole, const FormsReading& again) {
    hole.settled = false;
    const WrittenHole& written = *hole.written;
    bool proved = written.chain < again.forms.chains.size();
    if (proved) {
      const std::vector<WrittenStep>& steps = again.forms.chains[written.chain].steps;
      for (std::size_t k = written.side == 0 ? 0 : written.side - 1; k < steps.size() && k <= written.side;
           ++k) {
        proved = proved && steps[k].outcome == Outcome::proved;
      }
    }
    hole.settled = proved;
    if (!proved) ++hole.tried;
  }

  HoleAnswer close(OpenHole& hole) const {
    HoleAnswer answer = std::move(hole.answer);
    if (hole.settled) {
      answer.latex = hole.candidates[hole.tried];
      answer.text = placed(*answer.latex, hole.place);
      answer.only_moves_other = hole.moving.contains(*answer.latex);
      answer.impossible = false;
      return answer;
    }
    const auto trouble = [&](std::string message) {
      answer.troubles.push_back({DiagnosticKind::hole, answer.span, std::move(message)});
    };
    if (!answer.troubles.empty()) return answer;
    if (hole.would_be) {
      answer.impossible = true;
      trouble(fmt::format("no value fits: it would have to be `{}`, but with that the sides differ",
                          *hole.would_be));
    } else if (answer.freedom) {
      trouble(fmt::format("there are many answers, or none: {} to each", *answer.freedom));
    } else if (!hole.obstacle.empty()) {
      trouble("no answer was found: " + hole.obstacle);
    } else if (hole.repeats_other && hole.candidates.empty()) {
      trouble("nothing shorter than the other side was found");
    } else {
      trouble("no answer could be proved");
    }
    return answer;
  }

  const HoleNotes& notes_;
  WantedForm wanted_;
  HoleAnswers result_;
  std::vector<OpenHole> open_;
};

}  // namespace

HoleAnswers answer_holes(const HoleNotes& notes, AnswerForm form) { return Answering(notes, form).run(); }

}  // namespace rigor
