// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <fmt/format.h>

#include <sstream>

#include "app/grammar.h"
#include "source/suggest.h"

namespace rigor {

CommandLine parse_command_line(int argc, const char* const* argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  Grammar grammar;
  if (!first.empty() && first[0] != '-' && !grammar.has(first)) {
    const std::string meant = suggest(first, grammar.names()).value_or("check");
    return usage_error(fmt::format("`{}` is no command; did you mean `{}`?", first, meant), meant);
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
  return grammar.line();
}

}  // namespace rigor
