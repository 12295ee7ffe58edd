// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels beside what others have, in one process on the same data: time, error, and what must be
// reached. Errors are for the exact inputs, against references of 50 digits and more; a failure, a NaN or a
// wrong sign counts as infinite.
//
//   kernel_bench [--into FOLDER]     with FOLDER: also FOLDER/kernels.md and a picture for each table
//
// RIGOR_INSTRUCTION_SET=x86_64_v3, or baseline, holds the kernels to AVX2, or SSE2; the peers keep what the
// machine has.
//
// Exit code 0 if all targets are met, 1 if not, 64 for a wrong command line.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "kernel_tables.h"
#include "kernel_targets.h"
#include "mass_sums_cases.h"
#include "mesh_cases.h"
#include "moments_cases.h"
#include "numeric/lane/lane_kernels.h"
#include "stability_cases.h"
#include "torque_free_cases.h"
#include "torque_free_step_cases.h"
#include "validity_cases.h"

namespace rigor {
namespace {

std::vector<KernelRow> all_rows() {
  std::vector<KernelRow> rows;
  for (const auto measure : {moments_rows, stability_rows, mass_sums_rows, mesh_rows, torque_free_rows,
                             torque_free_step_rows, validity_rows})
    for (KernelRow& row : measure()) rows.push_back(std::move(row));
  return rows;
}

std::string targets_markdown(const std::vector<KernelTarget>& targets) {
  std::string text = "| what | wanted | measured | |\n|---|---|---|---|\n";
  for (const KernelTarget& target : targets)
    text += fmt::format("| {} | {} | {} | {} |\n", target.what, target.wanted, target.measured,
                        target.met ? "met" : "missed");
  return text;
}

/// The name of a table as that of a file.
std::string file_name(std::string table) {
  std::erase(table, ',');
  std::replace(table.begin(), table.end(), ' ', '-');
  return "kernels-" + table + ".svg";
}

bool write(const std::filesystem::path& folder, const std::vector<KernelRow>& rows,
           const std::vector<KernelTarget>& targets) {
  std::string page = targets_markdown(targets);
  for (const std::string& table : tables_of(rows)) {
    std::ofstream picture(folder / file_name(table));
    picture << to_svg(table_plot(rows, table));
    if (!picture.flush()) return false;
    page += fmt::format("\n### {}\n\n![time against error]({})\n\n{}", table, file_name(table),
                        table_markdown(rows, table));
  }
  std::ofstream file(folder / "kernels.md");
  file << page;
  return static_cast<bool>(file.flush());
}

int run(const std::filesystem::path& folder) {
  const std::vector<KernelRow> rows = all_rows();
  const std::vector<KernelTarget> targets = kernel_targets(rows);
  for (const std::string& table : tables_of(rows)) fmt::print("{}\n", table_text(rows, table));
  fmt::print("Lanes of {}: {} doubles at once.\n", lane_kernels().instruction_set, lane_kernels().lanes);
  bool met = true;
  for (const KernelTarget& target : targets) {
    fmt::print("{:<72}{:>20}{:>12}  {}\n", target.what, target.wanted, target.measured,
               target.met ? "met" : "missed");
    met = met && target.met;
  }
  if (!folder.empty() && !write(folder, rows, targets)) {
    std::cerr << "kernel_bench: " << folder.string() << " cannot be written\n";
    return 1;
  }
  return met ? 0 : 1;
}

}  // namespace
}  // namespace rigor

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) return rigor::run({});
  if (words.size() == 2 && words[0] == "--into") return rigor::run(words[1]);
  std::cerr << "usage: kernel_bench [--into FOLDER]\n";
  return 64;
}
