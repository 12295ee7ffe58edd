// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <filesystem>

#include "app/grammar/grammar.h"

namespace rigor {
namespace {

/// The words as they were typed.
struct DeriveWords {
  DeriveCommand command;
  std::string in_terms_of;
  std::string first_order;
};

/// `I_{ij}, \omega`: apart at commas outside braces.
std::vector<std::string> listed(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    if (c == '{' || c == '(') ++depth;
    if (c == '}' || c == ')') --depth;
    if (c == ',' && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) {
    part.erase(0, std::min(part.find_first_not_of(" \t"), part.size()));
    part.erase(part.find_last_not_of(" \t") + 1);
  }
  std::erase_if(parts, [](const std::string& part) { return part.empty(); });
  return parts;
}

bool reads_as_statement(const std::string& what) {
  std::error_code error;
  return !std::filesystem::exists(what, error) && what.find_first_of("=<>?\\") != std::string::npos;
}

/// What does not go together; empty if all is well.
std::string contradiction(const DeriveCommand& command) {
  const bool transformed = !command.derivative.empty() || !command.first_order.empty();
  const int forms = (command.form != "contracted" ? 1 : 0) + (command.in_terms_of.empty() ? 0 : 1) +
                    (command.first_order.empty() ? 0 : 1) + (command.solve_for.empty() ? 0 : 1) +
                    (command.derivative.empty() ? 0 : 1);
  if (forms > 1)
    return "`--form`, `--in-terms-of`, `--first-order`, `--derivative` and `--solve-for` do not go together";
  if (!command.is_statement) {
    if (command.in) return "`--in` gives the notes of a statement, but no statement is given";
    if (transformed) return "`--derivative` and `--first-order` belong to a statement on the command line";
    if (!command.solve_for.empty()) return "`--solve-for` belongs to a statement on the command line";
    return {};
  }
  if (command.write) return "`--write` belongs to a file, but a statement is given";
  if (command.places.size() > 1) return "a statement has one place, but `--at` is given more than once";
  if (!command.places.empty() && !command.in) return "`--at` names a place in notes; `--in` says which";
  return {};
}

}  // namespace

void add_derive(Grammar& grammar) {
  const auto words = std::make_shared<DeriveWords>();
  CLI::App& app = grammar.command(
      "derive", "Answer holes: what `\\square` stands for, in notes or in a statement",
      {R"(derive '|\mathbf A\times\mathbf B|^2 = \square')", "derive notes/rigid-bodies.md --write",
       R"(derive 'T_{rot} = \tfrac12\,\square\,\omega_i\omega_j' --in notes/rigid-bodies.md --at '(7)')",
       R"(derive '(\mathbf A\times\mathbf B)\cdot\mathbf C = \square' --form components)",
       "derive 'a x^2 + 2 b x + c = 0' --solve-for x"},
      [words]() -> CommandLine {
        DeriveCommand& command = words->command;
        command.is_statement = reads_as_statement(command.what);
        command.in_terms_of = listed(words->in_terms_of);
        command.first_order = listed(words->first_order);
        if (std::string wrong = contradiction(command); !wrong.empty())
          return usage_error(std::move(wrong), "derive");
        return {.derive = std::move(command)};
      });
  DeriveCommand& derive = words->command;
  app.add_option("FILE|STATEMENT", derive.what, "Notes, or an equation with a `\\square` in it")
      ->required()
      ->type_name("");
  app.add_option_function<std::string>(
         "--in", [&derive](const std::string& path) { derive.in = path; },
         "Notes whose letters, definitions and assumptions a statement uses")
      ->type_name("FILE");
  app.add_option(
         "--at", derive.places,
         "Of a file: only the holes with this tag or in this section; of a statement: where it stands in "
         "`--in`")
      ->type_name("TAG|HEADING")
      ->allow_extra_args(false);
  add_sidecar(app, derive.sidecar);
  app.add_flag("--write", derive.write, "Write the answers into the file, in place of the holes");
  app.add_option("--form", derive.form, "`contracted` (the default), `expanded`, `components` or `factored`")
      ->type_name("FORM")
      ->check(one_of("form", {"contracted", "expanded", "components", "factored"}));
  app.add_option("--in-terms-of", words->in_terms_of, "Only with these symbols, or as a polynomial in them")
      ->type_name("SYMBOLS");
  app.add_option("--first-order", words->first_order, "Drop terms of second order in these symbols")
      ->type_name("SYMBOLS");
  app.add_option("--derivative", derive.derivative, "The answer's derivative by `t` or a coordinate")
      ->type_name("SYMBOL");
  app.add_option("--solve-for", derive.solve_for, "Solve the statement, which has no hole, for a symbol")
      ->type_name("SYMBOL");
  app.add_option_function<std::string>(
         "--format",
         [&derive](const std::string& word) {
           derive.format = word == "mathml" ? MathFormat::mathml
                           : word == "text" ? MathFormat::text
                                            : MathFormat::latex;
         },
         "`latex` (the default), `mathml` or `text`")
      ->type_name("FORMAT")
      ->check(one_of("format", {"latex", "mathml", "text"}));
  add_color(app, derive.color);
}

}  // namespace rigor
