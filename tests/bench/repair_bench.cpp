// SPDX-License-Identifier: GPL-3.0-or-later
// For each slip of the pen in a proved row: is the original among the statements that are offered, how soon,
// and how long does the search take? With a list of files, those only; with `--missed`, also the slips that
// are not offered their original.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "slip_offers.h"

namespace rigor::twins {
namespace {

struct Row {
  std::size_t slips = 0;
  std::size_t refuted = 0;
  std::size_t offered = 0;  // anything
  std::size_t equal = 0;    // one of the three makes the same side true
  std::size_t first = 0;    // what is offered first is the original, but for the order of terms and factors
  std::size_t same = 0;     // one of the three is
  std::vector<double> milliseconds = {};

  void add(const Offer& offer) {
    ++slips;
    refuted += offer.answer == Answer::refuted ? 1 : 0;
    offered += offer.offered.empty() ? 0 : 1;
    equal += offer.equal > 0 ? 1 : 0;
    first += offer.same == 1 ? 1 : 0;
    same += offer.same > 0 ? 1 : 0;
    milliseconds.push_back(offer.milliseconds);
  }
};

double quantile(std::vector<double> sample, double at) {
  if (sample.empty()) return 0.0;
  std::sort(sample.begin(), sample.end());
  return sample[static_cast<std::size_t>(at * static_cast<double>(sample.size() - 1))];
}

void print(std::string_view name, const Row& row) {
  if (row.slips == 0) return;
  const auto percent = [&](std::size_t count) {
    return 100.0 * static_cast<double>(count) / static_cast<double>(row.slips);
  };
  fmt::print("{:<18}{:>8}{:>11.1f}{:>11.1f}{:>10.1f}{:>10.1f}{:>10.1f}{:>9.2f}{:>9.2f}{:>9.2f}\n", name,
             row.slips, percent(row.refuted), percent(row.offered), percent(row.equal), percent(row.first),
             percent(row.same), quantile(row.milliseconds, 0.5), quantile(row.milliseconds, 0.95),
             quantile(row.milliseconds, 1.0));
}

void print_missed(const Offer& offer) {
  static constexpr std::array<std::string_view, 5> answers{"proved", "refuted", "law", "open", "unread"};
  fmt::print("{}\t{}\t{}\t{}\t{}\t{}\n", name_of(offer.slip), answers[static_cast<std::size_t>(offer.answer)],
             offer.place, offer.original, offer.twin, fmt::join(offer.offered, " ;; "));
}

int measure(const std::vector<std::string>& files, bool list_missed) {
  std::array<Row, slip_count> rows{};
  Row all;
  std::size_t count = 0;
  std::size_t not_alone = 0;
  for (const std::string& file : files) {
    const Offers found = offers_of(file);
    count += found.rows;
    not_alone += found.not_alone;
    for (const Offer& offer : found.offers) {
      rows[static_cast<std::size_t>(offer.slip)].add(offer);
      all.add(offer);
      if (list_missed && offer.same == 0) print_missed(offer);
    }
  }
  fmt::print("{:<18}{:>8}{:>11}{:>11}{:>10}{:>10}{:>10}{:>9}{:>9}{:>9}\n", "slip", "slips", "refuted, %",
             "offered, %", "equal, %", "first, %", "of 3, %", "ms", "ms 95 %", "ms most");
  for (std::size_t k = 0; k < slip_count; ++k) print(name_of(static_cast<Slip>(k)), rows[k]);
  print("all", all);
  fmt::print("{} proved rows, {} of them left out: they rest on laws or on words beside them\n", count,
             not_alone);
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
