// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include "app/grammar/grammar.h"

namespace rigor {
namespace {

/// The words that `one_of` allows; none if the option takes others.
std::vector<std::string> choices_of(CLI::Option& option) {
  std::vector<std::string> choices;
  const CLI::Validator* const validator = [&]() -> const CLI::Validator* {
    try {
      return option.get_validator(0);
    } catch (const CLI::OptionNotFound&) {
      return nullptr;
    }
  }();
  if (validator == nullptr) return choices;
  std::istringstream names(validator->get_name());
  for (std::string name; std::getline(names, name, choice_separator);) choices.push_back(name);
  return choices;
}

ValueKind kind_of(const OptionWords& option) {
  if (option.value.empty()) return ValueKind::none;
  if (!option.choices.empty()) return ValueKind::choice;
  if (option.value.find("FOLDER") != std::string::npos) return ValueKind::folder;
  const bool is_file = option.names.empty() || option.value.find("FILE") != std::string::npos;
  return is_file ? ValueKind::file : ValueKind::other;
}

OptionWords words_of(CLI::Option& option) {
  OptionWords words;
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  if (option.get_positional()) {
    words.value = option.get_name(true);
  } else if (option.get_expected_max() > 0) {
    words.value = option.get_type_name();
  }
  words.choices = choices_of(option);
  words.kind = kind_of(words);
  words.what = option.get_description();
  words.required = option.get_required();
  words.many = option.get_items_expected_max() > 1;
  return words;
}

}  // namespace

ProgramWords Grammar::words() {
  ProgramWords program{.name = app_.get_name(), .what = app_.get_description()};
  for (CLI::Option* option : app_.get_options()) program.options.push_back(words_of(*option));
  for (const Command& command : commands_) {
    CommandWords words{.name = command.words->get_name(), .what = command.words->get_description()};
    for (CLI::Option* option : command.words->get_options())
      (option->get_positional() ? words.operands : words.options).push_back(words_of(*option));
    words.examples = command.examples;
    program.commands.push_back(std::move(words));
  }
  return program;
}

}  // namespace rigor
