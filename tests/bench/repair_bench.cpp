// SPDX-License-Identifier: GPL-3.0-or-later
// For each slip of the pen in a proved row: is the original among the statements that are offered, how soon,
// and how long does the search take? With a list of files, those only; with `--missed`, also the slips that
// are not offered their original. `--twins`: no offers, but what is proved of rows that rest on definitions
// or laws of their page, with one slip of the pen in them; each of these is to be looked at. `--alone`:
// without rows that rest on laws, for which a whole page is checked with each slip; `--every N`: each N-th
// slip only.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "slip_offers.h"

namespace rigor::twins {
namespace {

struct Row {
  std::size_t slips = 0;
  std::size_t refuted = 0;  // or suspected
  std::size_t offered = 0;  // anything
  std::size_t equal = 0;    // one of the three makes the same side true
  std::size_t first = 0;    // what is offered first is the original, but for the order of terms and factors
  std::size_t same = 0;     // one of the three is
  std::vector<double> milliseconds = {};

  void add(const Offer& offer) {
    ++slips;
    refuted += offer.answer == Answer::refuted || offer.answer == Answer::suspect ? 1 : 0;
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

void print_offer(const Offer& offer) {
  static constexpr std::array<std::string_view, answer_count> answers{"proved", "refuted", "law",
                                                                      "open",   "unread",  "suspect"};
  fmt::print("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", name_of(offer.slip),
             answers[static_cast<std::size_t>(offer.answer)], offer.on_page ? "page" : "alone", offer.place,
             offer.original, offer.twin, fmt::join(offer.offered, " ;; "), offer.said);
}

int measure(const std::vector<std::string>& files, bool list_missed, const Asked& asked) {
  std::array<Row, slip_count> rows{};
  Row all;
  Row on_page;
  Offers sums;
  std::size_t others = 0;
  for (const std::string& file : files) {
    const Offers found = offers_of(file, asked);
    sums.rows += found.rows;
    sums.on_page += found.on_page;
    for (const std::string& lost : found.lost) fmt::print("lost: {}: {}\n", file, lost);
    for (const Offer& offer : found.offers) {
      rows[static_cast<std::size_t>(offer.slip)].add(offer);
      all.add(offer);
      if (offer.on_page) on_page.add(offer);
      others = std::max(others, offer.others);
      if (list_missed && offer.same == 0) print_offer(offer);
    }
    std::fflush(stdout);
  }
  fmt::print("{:<18}{:>8}{:>11}{:>11}{:>10}{:>10}{:>10}{:>9}{:>9}{:>9}\n", "slip", "slips", "found, %",
             "offered, %", "equal, %", "first, %", "of 3, %", "ms", "ms 95 %", "ms most");
  for (std::size_t k = 0; k < slip_count; ++k) print(name_of(static_cast<Slip>(k)), rows[k]);
  print("all", all);
  print("asked on the page", on_page);
  fmt::print("{} proved rows, {} of them rest on laws or on words beside them\n", sums.rows, sums.on_page);
  fmt::print("one slip makes at most {} rows of other chains be found wrong\n", others);
  return 0;
}

/// A search that finds nothing takes all the work it may; proofs take a small part of it.
constexpr std::uint64_t effort_of_twins = 60'000;

int measure_twins(const std::vector<std::string>& files) {
  Offers sums;
  std::size_t proved = 0;
  for (const std::string& file : files) {
    const Offers found = offers_of(file, {.offers = false, .effort = effort_of_twins});
    sums.results += found.results;
    sums.twins += found.twins;
    proved += found.proved.size();
    for (const std::string& lost : found.lost) fmt::print("lost: {}: {}\n", file, lost);
    for (const Offer& offer : found.proved) print_offer(offer);
    std::fflush(stdout);
  }
  fmt::print("{} proved rows that rest on definitions or laws, {} twins, {} of them proved\n", sums.results,
             sums.twins, proved);
  return 0;
}

}  // namespace
}  // namespace rigor::twins

int main(int argc, char** argv) {
  std::vector<std::string> files;
  bool list_missed = false;
  bool twins = false;
  rigor::twins::Asked asked{.twins = false};
  for (int k = 1; k < argc; ++k) {
    const std::string argument = argv[k];
    if (argument == "--missed") {
      list_missed = true;
    } else if (argument == "--twins") {
      twins = true;
    } else if (argument == "--alone") {
      asked.pages = false;
    } else if (argument == "--every" && k + 1 < argc) {
      asked.every = std::max(1ul, std::strtoul(argv[++k], nullptr, 10));
    } else {
      files.push_back(argument);
    }
  }
  if (files.empty()) {
    files = {"derivations/rigid-bodies.md", "derivations/rotating-frames.tex",
             "derivations/vector-calculus.tex", "derivations/vector-identities.tex"};
  }
  return twins ? rigor::twins::measure_twins(files) : rigor::twins::measure(files, list_missed, asked);
}
