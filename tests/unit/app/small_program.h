// SPDX-License-Identifier: GPL-3.0-or-later
// A small program with each kind of option, for the tests of what is made of such words.
#pragma once

#include "app/grammar/words.h"

namespace rigor {

[[nodiscard]] inline ProgramWords small_program() {
  ProgramWords program{.name = "prog", .what = "prog does things."};
  program.options = {{{"-h", "--help"}, "", ValueKind::none, {}, "Print help"}};
  CommandWords look{.name = "look", .what = "Look at files"};
  look.options = {{{"--color"}, "WHEN", ValueKind::choice, {"auto", "never"}, "`auto` or `never`"},
                  {{"-o", "--output"}, "FILE", ValueKind::file, {}, ".starts with a full stop \\ ~"},
                  {{"--into"}, "FOLDER", ValueKind::folder, {}, "where to"},
                  {{"--at"}, "TAG", ValueKind::other, {}, "which"},
                  {{"--json"}, "", ValueKind::none, {}, "as JSON"}};
  look.operands = {{{}, "FILE", ValueKind::file, {}, "what to look at", true, true}};
  look.examples = {"look a.md", "look --at '(6)' a.md"};
  program.commands.push_back(std::move(look));
  program.commands.push_back({.name = "leave", .what = "Leave"});
  return program;
}

}  // namespace rigor
