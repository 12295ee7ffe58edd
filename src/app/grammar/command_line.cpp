// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/command_line.h"

#include <fmt/format.h>

#include <sstream>

#include "app/grammar/grammar.h"
#include "source/suggest.h"

namespace rigor {

namespace {

/// `derive ''`, `--at ' '`, `--sidecar=`: no file, statement or name is empty.
bool is_empty(std::string_view word) {
  const std::size_t sign = word.starts_with("--") ? word.find('=') : std::string_view::npos;
  if (sign != std::string_view::npos) word.remove_prefix(sign + 1);
  return word.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  Grammar grammar;
  if (!first.empty() && first[0] != '-' && !grammar.has(first)) {
    const std::string meant = suggest(first, grammar.names()).value_or("check");
    return usage_error(fmt::format("`{}` is not a command; did you mean `{}`?", first, meant), meant);
  }
  try {
    grammar.app().parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    std::ostringstream text;
    grammar.app().exit(asked, text, text);
    return {.text = text.str()};
  } catch (const CLI::ParseError& error) {
    return usage_error(error.what(), grammar.given());
  }
  for (int k = 1; k < argc; ++k) {
    if (is_empty(argv[k])) return usage_error(fmt::format("argument {} is empty", k), grammar.given());
  }
  return grammar.line();
}

}  // namespace rigor
