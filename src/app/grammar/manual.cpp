// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/manual.h"

#include <fmt/format.h>

#include <string_view>

#include "app/grammar/exit_code.h"
#include "base/version.h"

namespace rigor {
namespace {

/// Text as it may be in a line that does not begin with it: signs that roff would read are escaped.
std::string roff(std::string_view text) {
  std::string line;
  bool typed = false;
  for (const char letter : text) {
    switch (letter) {
      case '\\':
        line += "\\(rs";
        break;
      case '-':
        line += "\\-";
        break;
      case '\'':
        line += "\\(aq";
        break;
      case '~':
        line += "\\(ti";
        break;
      case '^':
        line += "\\(ha";
        break;
      case '`':
        typed = !typed;
        line += typed ? "\\fB" : "\\fR";
        break;
      default:
        line += letter;
    }
  }
  return line;
}

std::string bold(std::string_view text) { return fmt::format("\\fB{}\\fR", roff(text)); }
std::string italic(std::string_view text) { return fmt::format("\\fI{}\\fR", roff(text)); }

/// A line of text; `\&` in front, since a full stop at the start would be a request.
std::string line(const std::string& text) { return fmt::format("\\&{}\n", text); }

std::string option_head(const OptionWords& option) {
  std::string head;
  for (const std::string& name : option.names) head += (head.empty() ? "" : ", ") + bold(name);
  if (option.value.empty()) return head;
  return head + (head.empty() ? "" : " ") + italic(option.value);
}

std::string list(const std::vector<OptionWords>& options) {
  std::string text;
  for (const OptionWords& option : options)
    text += ".TP\n" + option_head(option) + "\n" + line(roff(option.what));
  return text;
}

/// `rigor check [OPTIONS] FILE...`
std::string usage(const ProgramWords& program, const CommandWords& command) {
  std::string text = bold(program.name + " " + command.name);
  if (!command.options.empty()) text += fmt::format(" [{}]", italic("OPTIONS"));
  for (const OptionWords& operand : command.operands) {
    const std::string word = italic(operand.value) + (operand.many ? "..." : "");
    text += " " + (operand.required ? word : fmt::format("[{}]", word));
  }
  return text;
}

std::string section_of(const ProgramWords& program, const CommandWords& command) {
  std::string text = fmt::format(".SS {} {}\n", program.name, roff(command.name));
  text += line(usage(program, command)) + ".PP\n" + line(roff(command.what) + ".");
  text += list(command.operands) + list(command.options);
  if (command.examples.empty()) return text;
  text += fmt::format(".PP\n{}:\n.RS\n.nf\n", command.examples.size() == 1 ? "Example" : "Examples");
  for (const std::string& example : command.examples) text += line(bold(program.name + " " + example));
  return text + ".fi\n.RE\n";
}

}  // namespace

std::string manual_page(const ProgramWords& program) {
  std::string what = program.what.substr(0, program.what.find_last_not_of('.') + 1);
  if (what.starts_with(program.name + " ")) what.erase(0, program.name.size() + 1);
  std::string upper;
  for (const char letter : program.name)
    upper += letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;

  std::string text = fmt::format(".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n", upper, program.name, version);
  text += fmt::format(".SH NAME\n{} \\- {}\n", program.name, roff(what));
  text += ".SH SYNOPSIS\n.nf\n";
  for (const CommandWords& command : program.commands) text += line(usage(program, command));
  text += ".fi\n.SH DESCRIPTION\n" + line(roff(program.what));
  text +=
      "Each relation of each displayed equation is a step. It is proved, refuted with a sample on which\n"
      "its sides differ, or left open, at file:line:column.\n";
  text += ".SH OPTIONS\n" + list(program.options);
  text += ".SH COMMANDS\n";
  for (const CommandWords& command : program.commands) text += section_of(program, command);
  text += ".SH EXIT STATUS\n";
  for (const ExitCodeInfo& entry : exit_code_table())
    text += fmt::format(".TP\n.B {}\n{}", number_of(entry.code), line(roff(entry.meaning)));
  return text;
}

}  // namespace rigor
