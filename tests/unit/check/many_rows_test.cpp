// SPDX-License-Identifier: GPL-3.0-or-later
// Notes as long as books: memory that grows with the rows, not with their square.
#include <fmt/format.h>

#include <functional>
#include <string>

#include "check/entry/check.h"
#include "peak_memory.h"

namespace rigor {
namespace {

/// MiB for the check of notes in which row k is what `row` gives.
double memory_for(int rows, const std::function<std::string(int)>& row) {
  std::string text;
  for (int k = 0; k < rows; ++k) text += row(k) + "\n\n";
  return peak_memory_of([&] {
    SourceMap sources;
    return check_text(sources, "book.md", text).steps.size() == static_cast<std::size_t>(rows);
  });
}

TEST_CASE("a scope for each of many rows that define takes little memory") {
  if (!memory_is_our_own) return;
  const auto row = [](int k) { return fmt::format("$$x_{{{}}} = x_{{{}}} + a$$", k + 1, k); };
  CHECK(memory_for(2000, row) < 100);  // 1,170 where each row has a scope of its own
}

TEST_CASE("displays without words between them take little memory") {
  if (!memory_is_our_own) return;
  const auto row = [](int) { return std::string("$$x + y = y + x$$"); };
  CHECK(memory_for(10'000, row) < 130);  // 205 where each has all that are before it in its sentence
}

TEST_CASE("results that follow from results hold each beginning once") {
  if (!memory_is_our_own) return;
  const auto row = [](int k) {
    return std::string(k % 2 == 0 ? "The law is\n\n$$mF_i = ka_i \\tag{1}$$"
                                  : "Hence\n\n$$m^2F_i = mka_i \\tag{2}$$");
  };
  CHECK(memory_for(40, row) < 20);  // 320 where each holds all that those before it hold, again and again
}

}  // namespace
}  // namespace rigor
