// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the tables and pictures behind docs/accuracy.md: which forms of the notes to compute, what programs
// cost beside hand-written loops and GiNaC, the kernels beside their peers, and the notes' formulas against
// the motion of bodies.
//
//   accuracy FOLDER PROGRAM_BENCH KERNEL_BENCH      from the top of the repository; FOLDER/tables.md
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "app/command/run.h"
#include "app/command/scene.h"
#include "app/host/sample_bodies.h"
#include "report/stability_report.h"

namespace rigor {
namespace {

/// What a command prints; empty if it cannot be run.
std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) text += buffer.data();
  pclose(pipe);  // a bench that misses its mark has measured, too
  return text;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string machine() {
  const std::string model = first_line(output_of("lscpu | sed -n 's/^Model name: *//p'"));
  const std::string number = first_line(output_of("lscpu | sed -n 's/^Model: *//p'"));
  return fmt::format("{} (model {}), {} cores", model, number, first_line(output_of("nproc")));
}

/// What a file holds, which is then taken away.
std::string taken_from(const std::filesystem::path& written) {
  std::ifstream file(written);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  std::filesystem::remove(written);
  return text;
}

/// The part of the page about one file of notes, from what `rigor bench --into` wrote.
std::string forms_of(const std::string& notes, const std::filesystem::path& folder) {
  std::vector<const char*> words{"rigor",        "bench",  notes.c_str(),       "--into",
                                 folder.c_str(), "--body", "derivations/bodies"};
  std::ostringstream ignored;
  if (run(static_cast<int>(words.size()), words.data(), ignored, std::cerr) != 0) return "";
  return taken_from(folder / (std::filesystem::path(notes).stem().string() + "-forms.md"));
}

/// The part of the page about kernels, from what `kernel_bench --into` wrote.
std::string kernels(const std::string& kernel_bench, const std::filesystem::path& folder) {
  output_of(kernel_bench + " --into '" + folder.string() + "'");
  return taken_from(folder / "kernels.md");
}

/// Table and picture of the notes' frequencies against the motion of all bodies.
std::string nature(const std::filesystem::path& folder) {
  SourceMap sources;
  LoadedScene loaded;
  if (load_scene("derivations/scenes/stability.toml", sources, loaded, std::cerr) != ExitCode::ok) return "";
  std::vector<Body> bodies;
  if (read_bodies({"derivations/bodies"}, "derivations/scenes/stability.toml", sources, bodies, std::cerr) !=
      ExitCode::ok)
    return "";
  constexpr std::array pushes{0.1, 0.03, 0.01, 0.003, 0.001};
  const auto measured = measure_stability(loaded.scene, bodies, loaded.reading.forms, 5.0, pushes);
  std::ofstream(folder / "stability.svg") << to_svg(stability_plot(measured));
  return "![error against push](stability.svg)\n\n" + stability_table(measured);
}

constexpr const char* introduction =
    R"(Each form is computed as it is written. The error is the worst relative one over the samples of a trial, against exact
values for the same inputs; a result that overflows or is not a number errs by infinity. The samples of a trial are numbers
of one family, or spins of one sample body (`thin axis`: about its axis of least moment). The points of a picture are
float, double, long double and double-double (dd); the line joins those that no other beats.

)";

constexpr const char* of_kernels =
    R"(One process, the same inputs for all, one thread. Times are the least of many runs, for one tensor, one point, one
triangle or one moment of time. Errors are relative, the worst of a family, against references of 50 digits or more for the
exact inputs; a failure, a NaN and a wrong sign count as infinite. Peers are compiled for this machine with the kernels'
options, `-O3 -ffp-contract=off -fno-math-errno`.

)";

constexpr const char* of_nature =
    R"(A body spins about one of its principal axes with a small push across it. Its motion follows the equations (22) of
`derivations/rigid-bodies.md`; its frequency, or rate of growth, is compared with the notes' Ω². Both hold to first order
in the push, so that the error falls as its square.

)";

int write(const std::filesystem::path& folder, const std::string& program_bench,
          const std::string& kernel_bench) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  struct Part {
    std::string heading;
    std::string text;
  };
  std::vector<Part> parts;
  // GiNaC leaves files behind where its compiler runs
  const std::string table =
      output_of("cd " + std::filesystem::temp_directory_path().string() + " && " + program_bench);
  parts.push_back(
      {"Programs beside hand-written loops and GiNaC", table.empty() ? "" : "```\n" + table + "```\n"});
  const std::string beside = kernels(kernel_bench, folder);
  parts.push_back({"Kernels beside their peers", beside.empty() ? "" : of_kernels + beside});
  const std::string measured = nature(folder);
  parts.push_back({"The notes against nature", measured.empty() ? "" : of_nature + measured});
  parts.push_back({"Forms in derivations/rigid-bodies.md, on all sample bodies",
                   forms_of("derivations/rigid-bodies.md", folder)});
  std::string page = fmt::format(
      "# Time against error\n\nMade by `cmake --build --preset bench --target accuracy` on {}, {}, at "
      "{}{}.\n\n{}",
      machine(), first_line(output_of("c++ --version")), first_line(output_of("git rev-parse --short HEAD")),
      output_of("git status --porcelain -- src").empty() ? "" : " with changes", introduction);
  for (const Part& part : parts) {
    if (part.text.empty()) {
      std::cerr << "accuracy: nothing was measured for `" << part.heading << "`\n";
      return 1;
    }
    page += fmt::format("## {}\n\n{}\n", part.heading, part.text);
  }
  std::ofstream file(folder / "tables.md");
  file << page;
  return file.flush() ? 0 : 1;
}

}  // namespace
}  // namespace rigor

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "usage: accuracy FOLDER PROGRAM_BENCH KERNEL_BENCH\n";
    return 64;
  }
  return rigor::write(argv[1], argv[2], argv[3]);
}
