// SPDX-License-Identifier: GPL-3.0-or-later
// The words that the command line knows, as values: what the manual page and the completion are made of.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rigor {

/// What may be in the place of an option's value, or of a word without an option.
enum class ValueKind : std::uint8_t { none, file, folder, choice, other };

/// An option, or (without names) a word that stands for itself, such as FILE.
struct OptionWords {
  std::vector<std::string> names;  // `-h`, `--help`
  std::string value;               // `FILE`; empty: the option takes none
  ValueKind kind = ValueKind::none;
  std::vector<std::string> choices = {};  // all of them, for `choice`
  std::string what = {};
  bool required = false;
  bool many = false;  // several values may follow
};

struct CommandWords {
  std::string name;
  std::string what;  // one line
  std::vector<OptionWords> options = {};
  std::vector<OptionWords> operands = {};
  std::vector<std::string> examples = {};  // command lines without the program's name
};

struct ProgramWords {
  std::string name;
  std::string what;  // one sentence
  std::vector<OptionWords> options = {};
  std::vector<CommandWords> commands = {};
};

}  // namespace rigor
