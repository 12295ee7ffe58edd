// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hole/derive.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/hole/hole_answers.h"
#include "app/hole/solve.h"
#include "app/hole/write_back.h"
#include "app/host/screen.h"
#include "base/utf8.h"
#include "latex/document/document.h"
#include "latex/layout/mathml.h"
#include "latex/layout/plain_text.h"
#include "latex/token/token.h"
#include "source/latin1.h"
#include "source/read_file.h"
#include "source/render.h"

namespace rigor {
namespace {

AnswerForm form_named(const DeriveCommand& command) {
  if (!command.in_terms_of.empty()) return AnswerForm::collected;
  if (command.form == "expanded") return AnswerForm::expanded;
  if (command.form == "components") return AnswerForm::components;
  return command.form == "factored" ? AnswerForm::factored : AnswerForm::contracted;
}

ExitCode worse(ExitCode a, ExitCode b) {
  const auto severity = [](ExitCode code) {
    return code == ExitCode::wrong ? 3 : code == ExitCode::open ? 2 : 0;
  };
  return severity(a) >= severity(b) ? a : b;
}

/// An expression that was written as LaTeX, in the format that is asked for.
std::string in_format(const std::string& latex, MathFormat format) {
  if (format == MathFormat::latex) return latex;
  SourceMap sources;
  const FileId file = sources.add("answer", latex);
  const Tokens tokens = lex(sources, {file, 0, static_cast<std::uint32_t>(latex.size())});
  return format == MathFormat::mathml ? to_mathml(tokens, MathStyle::display) : to_plain_text(tokens);
}

class Deriving {
 public:
  Deriving(const DeriveCommand& command, std::ostream& out, std::ostream& err)
      : command_(command), out_(out), err_(err) {}

  ExitCode run() {
    HoleNotes notes{.sidecar = command_.sidecar, .by = command_.in_terms_of};
    if (command_.is_statement) {
      notes.statement = command_.what;
      if (!command_.places.empty()) notes.at = command_.places[0];
    } else {
      notes.places = command_.places;
    }
    const std::string path = command_.is_statement ? command_.in.value_or("") : command_.what;
    if (const ExitCode code = load(path, notes); code != ExitCode::ok) return code;
    if (!command_.first_order.empty()) add_small_directive(notes);
    if (!command_.solve_for.empty()) return solve(notes);
    HoleAnswers answers = answer_holes(notes, form_named(command_));
    if (auto nearly = to_first_order(notes, answers)) {
      err_ << "rigor: to first order in what is small, with `\\approx` for `=`\n";
      answers = std::move(*nearly);
    }
    ExitCode code = print_errors(answers);
    if (answers.reading.report.unreadable) return ExitCode::no_input;
    if (!command_.derivative.empty() || !command_.first_order.empty()) return transform(notes, answers, code);
    code = worse(code, print(answers));
    if (command_.write) {
      const ExitCode written = write(notes, answers);
      if (written != ExitCode::ok) return written;
    }
    return code;
  }

 private:
  ExitCode load(const std::string& path, HoleNotes& notes) {
    if (path.empty()) return ExitCode::ok;
    auto text = read_file(path);
    if (!text) {
      err_ << fmt::format("rigor: {}: {}\n", printable(path), text.error().reason);
      return ExitCode::no_input;
    }
    notes.path = path;
    notes.decoded = !decode_latin1(*text, 0).empty();
    notes.text = std::move(*text);
    return ExitCode::ok;
  }

  void print(const Diagnostic& diagnostic, const SourceMap& sources) {
    err_ << render(diagnostic, sources, {.color = terminal_options(command_.color, err_).color});
  }

  /// Why the notes, or the statement, cannot be read.
  ExitCode print_errors(const HoleAnswers& answers) {
    ExitCode code = ExitCode::ok;
    for (const Diagnostic& diagnostic : answers.reading.report.diagnostics) {
      if (diagnostic.severity() == Severity::warning) continue;
      if (diagnostic.kind == DiagnosticKind::unused_directive)
        continue;  // what a hole needs may be used later
      print(diagnostic, answers.sources);
      if (diagnostic.severity() == Severity::error) code = ExitCode::wrong;
    }
    for (const std::string& place : answers.unknown_places) {
      err_ << fmt::format("rigor: {}: no equation and no section is named `{}`\n", printable(command_.what),
                          printable(place));
      code = ExitCode::wrong;
    }
    if (code == ExitCode::ok && answers.holes.empty()) {
      const std::string what = command_.is_statement ? "the statement" : printable(command_.what);
      err_ << fmt::format("rigor: {} has no hole{}; write `\\square` for what is to be found\n", what,
                          command_.places.empty() || command_.is_statement ? "" : " there");
      print_step_errors(answers);
      code = command_.is_statement ? ExitCode::wrong : ExitCode::ok;
    }
    return code;
  }

  void print_step_errors(const HoleAnswers& answers) {
    if (!command_.is_statement) return;
    for (const Step& step : answers.reading.report.steps) {
      for (const Diagnostic& diagnostic : step.diagnostics) {
        if (diagnostic.span.file == *answers.reading.statement) print(diagnostic, answers.sources);
      }
    }
  }

  ExitCode print(const HoleAnswers& answers) {
    ExitCode code = ExitCode::ok;
    for (const HoleAnswer& hole : answers.holes) {
      if (hole.latex) {
        if (!command_.is_statement) {
          const LineColumn place = answers.sources.line_column(hole.span.file, hole.span.begin);
          out_ << fmt::format("{}:{}:{}: ", printable(answers.sources.path(hole.span.file)), place.line,
                              place.column);
        }
        out_ << in_format(*hole.latex, command_.format) << "\n";
      }
      for (const Diagnostic& trouble : hole.troubles) print(trouble, answers.sources);
      if (hole.latex && hole.freedom)
        err_ << fmt::format("rigor: this is one of many answers: {}\n", *hole.freedom);
      if (!hole.latex) code = worse(code, hole.impossible ? ExitCode::wrong : ExitCode::open);
    }
    return code;
  }

  ExitCode write(const HoleNotes& notes, const HoleAnswers& answers) {
    std::vector<PlacedText> replacements;
    for (const HoleAnswer& hole : answers.holes) {
      if (hole.latex) replacements.push_back({hole.span, hole.text});
    }
    if (replacements.empty()) return ExitCode::ok;
    const bool unsure = std::ranges::any_of(
        answers.reading.report.diagnostics, [](const Diagnostic& each) {  // a `?` may stand for such a byte
          return each.kind == DiagnosticKind::invalid_utf8 || each.kind == DiagnosticKind::nul_byte;
        });
    if (unsure || notes.decoded) {
      err_ << fmt::format("rigor: {}: nothing is written into a file that is not UTF-8\n",
                          printable(notes.path));
      return ExitCode::wrong;
    }
    const auto written = replace_file(notes.path, with_replacements(notes.text, std::move(replacements)));
    if (written) return ExitCode::ok;
    err_ << fmt::format("rigor: {}: cannot be written: {}\n", printable(notes.path), written.error().reason);
    return ExitCode::no_input;
  }

  /// The answer goes into a further statement, which has a hole again.
  ExitCode transform(const HoleNotes& notes, const HoleAnswers& answers, ExitCode code) {
    for (const HoleAnswer& hole : answers.holes) {
      const std::optional<std::string> given = hole.other ? hole.other : hole.latex;
      if (!given) {
        for (const Diagnostic& trouble : hole.troubles) print(trouble, answers.sources);
        code = worse(code, hole.impossible ? ExitCode::wrong : ExitCode::open);
        continue;
      }
      HoleNotes next = notes;
      AnswerForm form = AnswerForm::contracted;
      if (!command_.derivative.empty()) {
        const std::string& by = command_.derivative;
        const std::string sign =
            by == "t" ? R"(\frac{d}{dt})" : fmt::format(R"(\frac{{\partial}}{{\partial {}}})", by);
        next.statement = fmt::format(R"({}\left({}\right) = \square)", sign, *given);
      } else {
        form = AnswerForm::first_order;
        next.by = command_.first_order;
        next.statement = fmt::format(R"({} \approx \square)", *given);
      }
      const HoleAnswers derived = answer_holes(next, form);
      code = worse(code, print_errors(derived));
      code = worse(code, print(derived));
    }
    return code;
  }

  /// `\ddot q = \square q` with a small q: where an equality has no answer but the other side itself, moved
  /// to the hole, a first order may say more.
  [[nodiscard]] std::optional<HoleAnswers> to_first_order(const HoleNotes& notes,
                                                          const HoleAnswers& exact) const {
    const auto says_more = [](const HoleAnswer& hole) { return hole.latex && !hole.only_moves_other; };
    if (!notes.statement || exact.holes.size() != 1 || !exact.holes[0].among_small) return std::nullopt;
    const std::size_t sign = notes.statement->find('=');
    const bool one_equality =
        sign != std::string::npos && notes.statement->find('=', sign + 1) == std::string::npos;
    if (says_more(exact.holes[0]) || !one_equality) return std::nullopt;
    HoleNotes nearly = notes;
    nearly.statement->replace(sign, 1, "\\approx ");
    HoleAnswers answers = answer_holes(nearly, form_named(command_));
    if (answers.holes.size() != 1 || !says_more(answers.holes[0])) return std::nullopt;
    return answers;
  }

  /// After the notes, so that their lines keep their numbers, unless the statement is within them.
  void add_small_directive(HoleNotes& notes) const {
    const bool latex = format_of(notes.path) == Format::latex;
    std::string directive = latex ? "" : "<!-- rigor:\n";
    const auto add_line = [&](std::string_view kind, const std::string& symbol) {
      directive += fmt::format("{}{} {}\n", latex ? "% rigor: " : "", kind, symbol);
    };
    for (const std::string& symbol : command_.first_order) {
      if (notes.path.empty()) add_line(is_bold(symbol) ? "vector" : "scalar", symbol);
      add_line("small", symbol);
    }
    if (!latex) directive += "-->\n";
    if (latex || notes.at || !command_.is_statement) {
      notes.text.insert(0, directive);
    } else {
      notes.text += "\n\n" + directive;
    }
  }

  /// Without notes, nothing else says what a symbol is.
  static bool is_bold(std::string_view symbol) {
    return symbol.find("\\mathbf") != symbol.npos || symbol.find("\\boldsymbol") != symbol.npos ||
           symbol.find("\\vec") != symbol.npos;
  }

  ExitCode solve(const HoleNotes& notes) {
    const SolvedStatement solved = solve_statement(notes, command_.solve_for);
    for (const Diagnostic& diagnostic : solved.diagnostics) print(diagnostic, solved.sources);
    for (const std::string& root : solved.roots)
      out_ << in_format(fmt::format("{} = {}", command_.solve_for, root), command_.format) << "\n";
    if (!solved.obstacle.empty())
      err_ << fmt::format("rigor: no answer for `{}`: {}\n", printable(command_.solve_for),
                          printable(solved.obstacle));
    if (solved.roots.empty()) return solved.malformed ? ExitCode::wrong : ExitCode::open;
    return solved.obstacle.empty() ? ExitCode::ok : ExitCode::open;
  }

  const DeriveCommand& command_;
  std::ostream& out_;
  std::ostream& err_;
};

}  // namespace

ExitCode derive_holes(const DeriveCommand& command, std::ostream& out, std::ostream& err) {
  return Deriving(command, out, err).run();
}

}  // namespace rigor
