// SPDX-License-Identifier: GPL-3.0-or-later
// For each false twin that is refuted: is its original among the statements that are offered, how soon, and
// how long does the search take? With a list of files, those only; with `--missed`, also the twins without
// it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "twins.h"

namespace rigor::twins {
namespace {

struct Row {
  std::size_t refuted = 0;
  std::size_t first = 0;   // what is offered first equals the original
  std::size_t among = 0;   // one of the three does
  std::size_t letter = 0;  // one is the original letter by letter
  std::vector<double> milliseconds = {};

  void add(const Suggested& suggested) {
    ++refuted;
    first += suggested.place == 1 ? 1 : 0;
    among += suggested.place > 0 ? 1 : 0;
    letter += suggested.is_original ? 1 : 0;
    milliseconds.push_back(suggested.milliseconds);
  }
};

double quantile(std::vector<double> sample, double at) {
  if (sample.empty()) return 0.0;
  std::sort(sample.begin(), sample.end());
  return sample[static_cast<std::size_t>(at * static_cast<double>(sample.size() - 1))];
}

void print(std::string_view name, const Row& row) {
  const auto percent = [&](std::size_t count) {
    return row.refuted == 0 ? 0.0 : 100.0 * static_cast<double>(count) / static_cast<double>(row.refuted);
  };
  fmt::print("{:<16}{:>8}{:>10.1f}{:>10.1f}{:>12.1f}{:>10.2f}{:>10.2f}{:>10.2f}\n", name, row.refuted,
             percent(row.first), percent(row.among), percent(row.letter), quantile(row.milliseconds, 0.5),
             quantile(row.milliseconds, 0.95), quantile(row.milliseconds, 1.0));
}

int measure(const std::vector<std::string>& files, bool list_missed) {
  std::array<Row, slip_count> rows{};
  Row all;
  for (const std::string& file : files) {
    for (const Twin& twin : twins_of(file, Repairs::of_all).twins) {
      if (twin.outcome != Outcome::refuted && twin.outcome != Outcome::refuted_declared) continue;
      rows[static_cast<std::size_t>(twin.slip)].add(twin.suggested);
      all.add(twin.suggested);
      if (list_missed && twin.suggested.place != 1)
        fmt::print("{}\t{}\t{}\t{}\t{}\t{}\n", twin.suggested.place, name_of(twin.slip), twin.place,
                   twin.original, twin.twin, twin.suggested.first);
    }
  }
  fmt::print("{:<16}{:>8}{:>10}{:>10}{:>12}{:>10}{:>10}{:>10}\n", "slip", "refuted", "first, %", "of 3, %",
             "verbatim, %", "ms", "ms 95 %", "ms most");
  for (std::size_t k = 0; k < slip_count; ++k) print(name_of(static_cast<Slip>(k)), rows[k]);
  print("all", all);
  return 0;
}

}  // namespace
}  // namespace rigor::twins

int main(int argc, char** argv) {
  std::vector<std::string> files;
  bool list_missed = false;
  for (int k = 1; k < argc; ++k) {
    const std::string argument = argv[k];
    if (argument == "--missed") {
      list_missed = true;
    } else {
      files.push_back(argument);
    }
  }
  if (files.empty()) {
    files = {"derivations/rigid-bodies.md", "derivations/rotating-frames.tex",
             "derivations/vector-calculus.tex", "derivations/vector-identities.tex"};
  }
  return rigor::twins::measure(files, list_missed);
}
