// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/grammar/debug.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("each topic prints a line a step, with its place") {
  SourceMap sources;
  FileReport file;
  file.file = sources.add("notes.md", "\n$$a = b$$\n");
  file.steps.resize(2);
  file.steps[0].span = {file.file, 3, 8};
  file.steps[0].milliseconds = 0.4256;
  file.steps[0].verdict = Verdict::proved;
  file.steps[0].route = "moments";
  file.steps[0].uses = {"definition a", "convention: sums"};
  file.steps[1].span = {file.file, 7, 8};
  CHECK(print_debug(DebugTopic::time, file, sources) ==
        "debug time: notes.md:2:3: 0.426 ms\n"
        "debug time: notes.md:2:7: 0.000 ms\n");
  CHECK(print_debug(DebugTopic::steps, file, sources) ==
        "debug steps: notes.md:2:3: proved; route: moments; uses: definition a, convention: sums\n"
        "debug steps: notes.md:2:7: not-understood\n");
}

TEST_CASE("the table has each topic at its own place") {
  const auto table = debug_topic_table();
  for (std::size_t i = 0; i < table.size(); ++i) CHECK(static_cast<std::size_t>(table[i].topic) == i);
}

}  // namespace
}  // namespace rigor
