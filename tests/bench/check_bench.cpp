// SPDX-License-Identifier: GPL-3.0-or-later
// Where the time goes in `rigor check`, on our rigid-body notes and, where they are found, on the original
// ones with their sidecar.
//
// Phases, in milliseconds of processor time and as multiples of the first one:
//   read        the text to the syntax tree (`read_notes`)
//   elaborate   the session without its decisions: names, meanings, definitions, verdicts; by display and
//               directive (the first one bears the look at how all symbols are written)
//   quick look  the first samples of each decision (`Refuter::quick_look`), measured by itself; by step
//   proof       the rest of each decision (`decide` less the quick look); by step
// then the whole process, beside one that only starts and ends. Each figure is a median of many runs.
//
// Fails if the program needs more than 64 MiB, or if not one of its runs ends within 60 ms: a busy machine
// makes some runs slow, not all.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "algebra/point/scope.h"
#include "algebra/sample/refute.h"
#include "base/check.h"
#include "check/event/notes.h"
#include "check/step/report.h"
#include "check/walk/walk.h"
#include "decide_watch.h"
#include "process.h"
#include "source/read_file.h"

namespace rigor::bench {
namespace {

/// What is checked.
struct Subject {
  std::string notes;
  std::string sidecar;  // may be empty
};

constexpr const char* any_particles_tag = "(7)";  // a sum over any number of particles
constexpr int runs = 21;
constexpr int process_runs = 31;
constexpr std::size_t slowest_shown = 8;
constexpr double most_milliseconds = 60.0;
constexpr double most_mebibytes = 64.0;

/// Time on the processor, so that other programs do not count.
class Stopwatch {
 public:
  [[nodiscard]] double milliseconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
  }
  double start_ = now();
};

double median(std::vector<double> values) {
  RIGOR_CHECK(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The times of one phase's parts, each run by run.
class Phase {
 public:
  void add(const std::vector<double>& of_parts) {
    parts_.resize(std::max(parts_.size(), of_parts.size()));
    double sum = 0;
    for (std::size_t k = 0; k < of_parts.size(); ++k) {
      parts_[k].push_back(of_parts[k]);
      sum += of_parts[k];
    }
    totals_.push_back(sum);
  }

  [[nodiscard]] double total() const { return median(totals_); }
  /// The median of each part.
  [[nodiscard]] std::vector<double> parts() const {
    std::vector<double> medians;
    for (const std::vector<double>& part : parts_) medians.push_back(median(part));
    return medians;
  }

 private:
  std::vector<double> totals_;
  std::vector<std::vector<double>> parts_;
};

struct SessionTimes {
  std::vector<double> displays;   // each event of the notes, without its decisions
  std::vector<double> decisions;  // each step; 0 where nothing was asked
  FileReport report;
};

/// `decide` is what the session's questions are answered with, and what it returns is timed.
template <class Decide>
SessionTimes timed_session(const SourceMap& sources, const Notes& notes, Decide decide) {
  SessionTimes times;
  double deciding = 0.0;  // since the last event
  const DecideWatch watch([&](const Question& question, const Limits& limits) {
    const Stopwatch stopwatch;
    double milliseconds = 0.0;
    Decision decision = decide(question, limits, stopwatch, milliseconds);
    times.decisions.resize(std::max(times.decisions.size(), times.report.steps.size() + 1));
    times.decisions[times.report.steps.size()] += milliseconds;
    deciding += stopwatch.milliseconds();
    return decision;
  });
  const Stopwatch stopwatch;
  double before = 0.0;
  const CheckOptions options{.progress = [&](std::size_t, std::size_t) {
    const double now = stopwatch.milliseconds();
    times.displays.push_back(now - before - deciding);
    before = now;
    deciding = 0.0;
  }};
  static_cast<void>(walk_through(sources, notes, times.report, options));
  times.decisions.resize(times.report.steps.size());
  return times;
}

SessionTimes time_decisions(const SourceMap& sources, const Notes& notes) {
  return timed_session(
      sources, notes,
      [](const Question& question, const Limits& limits, const Stopwatch& stopwatch, double& milliseconds) {
        Decision decision = decide_unwatched(question, limits);
        milliseconds = stopwatch.milliseconds();
        return decision;
      });
}

/// The quick look alone; the answer comes from the whole decision, which is not timed.
SessionTimes time_quick_looks(const SourceMap& sources, const Notes& notes) {
  return timed_session(
      sources, notes,
      [](const Question& question, const Limits& limits, const Stopwatch& stopwatch, double& milliseconds) {
        const Scope scope(question, Scope::Definitions::unfolded);
        Refuter refuter(scope, limits);
        static_cast<void>(refuter.quick_look());
        milliseconds = stopwatch.milliseconds();
        return decide_unwatched(question, limits);
      });
}

struct Phases {
  Phase read;
  Phase elaborate;
  Phase quick_look;
  Phase proof;
  std::vector<std::string> displays;  // the names of what `elaborate` is made of
  std::vector<std::string> steps;     // and of `quick_look` and `proof`
  std::vector<std::string> tags;      // of the steps
};

std::string place_of(const SourceMap& sources, Span span) {
  return fmt::format("line {:>3}", sources.line_column(span.file, span.begin).line);
}

Phases measure(SourceMap& sources, FileId file, const FileId* sidecar) {
  Phases phases;
  for (int run = 0; run < runs; ++run) {
    const Stopwatch reading;
    Diagnostics ignored;
    const Notes notes = read_notes(sources, file, sidecar, ignored);
    phases.read.add({reading.milliseconds()});

    const SessionTimes whole = time_decisions(sources, notes);
    const SessionTimes quick = time_quick_looks(sources, notes);
    std::vector<double> proofs;
    for (std::size_t k = 0; k < whole.decisions.size(); ++k) {
      proofs.push_back(std::max(0.0, whole.decisions[k] - quick.decisions[k]));
    }
    phases.elaborate.add(whole.displays);
    phases.quick_look.add(quick.decisions);
    phases.proof.add(proofs);
    if (run > 0) continue;
    for (const Event& event : notes.events) phases.displays.push_back(place_of(sources, span_of(event)));
    for (const Step& step : whole.report.steps) {
      phases.steps.push_back(
          fmt::format("{} {:<5} {:.60}", place_of(sources, step.span), step.tag, step.source));
      phases.tags.push_back(step.tag);
    }
  }
  return phases;
}

/// One line of the table; the parts that take no time at all (definitions decide nothing) do not count.
void print_phase(const char* name, const Phase& phase, double baseline,
                 const std::vector<std::string>& names) {
  const std::vector<double> parts = phase.parts();
  std::vector<double> busy;
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(busy), [](double part) { return part > 0.0; });
  const auto worst = std::max_element(parts.begin(), parts.end());
  fmt::print("{:<12}{:>9.3f}{:>8.2f}{:>9}{:>11.4f}{:>11.4f}  {}\n", name, phase.total(),
             phase.total() / baseline, busy.size(), median(busy), *worst,
             names[static_cast<std::size_t>(worst - parts.begin())]);
}

void print_phases(const Phases& phases) {
  const double baseline = phases.read.total();
  fmt::print("{:<12}{:>9}{:>8}{:>9}{:>11}{:>11}\n", "phase", "ms", "x read", "parts", "median ms",
             "worst ms");
  print_phase("read", phases.read, baseline, {"the file"});
  print_phase("elaborate", phases.elaborate, baseline, phases.displays);
  print_phase("quick look", phases.quick_look, baseline, phases.steps);
  print_phase("proof", phases.proof, baseline, phases.steps);
}

void print_slowest(const Phases& phases) {
  std::vector<std::pair<double, std::size_t>> decisions;
  const std::vector<double> quick = phases.quick_look.parts();
  const std::vector<double> proof = phases.proof.parts();
  for (std::size_t k = 0; k < quick.size(); ++k) decisions.emplace_back(quick[k] + proof[k], k);
  std::sort(decisions.rbegin(), decisions.rend());
  fmt::print("\nslowest decisions   quick ms   proof ms\n");
  for (std::size_t rank = 0; rank < decisions.size(); ++rank) {
    const std::size_t k = decisions[rank].second;
    const bool any_particles = phases.tags[k] == any_particles_tag;
    if (rank >= slowest_shown && !any_particles) continue;
    fmt::print("{:>10.4f} ms{:>15.4f}{:>11.4f}  {}\n", decisions[rank].first, quick[k], proof[k],
               phases.steps[k]);
  }
  fmt::print("{} sums over particles: its proof knows moments, no number of particles\n", any_particles_tag);
}

struct ProcessTimes {
  double median = 0.0;  // elapsed
  double best = 0.0;
  double worst = 0.0;
  double processor = 0.0;  // median
  double mebibytes = 0.0;  // most
};

ProcessTimes time_process(const std::vector<std::string>& command) {
  std::vector<double> elapsed;
  std::vector<double> processor;
  ProcessTimes result;
  for (int run = 0; run < process_runs; ++run) {
    const ProcessCost cost = run_process(command);
    RIGOR_CHECK(cost.exit_code >= 0, command.back(), cost.exit_code);
    elapsed.push_back(cost.elapsed);
    processor.push_back(cost.processor);
    result.mebibytes = std::max(result.mebibytes, cost.mebibytes);
  }
  result.median = median(elapsed);
  result.best = *std::min_element(elapsed.begin(), elapsed.end());
  result.worst = *std::max_element(elapsed.begin(), elapsed.end());
  result.processor = median(processor);
  return result;
}

void print_process(const char* name, const ProcessTimes& times, const ProcessTimes& baseline) {
  fmt::print("{:<16}{:>11.1f}{:>9.1f}{:>9.1f}{:>14.1f}{:>8.2f}{:>8.1f}\n", name, times.median, times.best,
             times.worst, times.processor, times.processor / baseline.processor, times.mebibytes);
}

FileId load(SourceMap& sources, const std::string& path) {
  auto text = read_file(path);
  RIGOR_CHECK(text.has_value(), path);
  return sources.add(path, *std::move(text));
}

/// True if the goal is met.
bool bench(const Subject& subject) {
  SourceMap sources;
  const FileId notes = load(sources, subject.notes);
  std::optional<FileId> sidecar;
  if (!subject.sidecar.empty()) sidecar = load(sources, subject.sidecar);
  const Phases phases = measure(sources, notes, sidecar ? &*sidecar : nullptr);
  fmt::print("{}: {} steps, medians of {} runs\n\n", subject.notes, phases.steps.size(), runs);
  print_phases(phases);
  print_slowest(phases);

  std::vector<std::string> command{RIGOR_PROGRAM, "check", subject.notes};
  if (sidecar) command.insert(command.end(), {"--sidecar", subject.sidecar});
  const ProcessTimes idle = time_process({RIGOR_PROGRAM, "--version"});
  const ProcessTimes check = time_process(command);
  fmt::print("\n{:<16}{:>11}{:>9}{:>9}{:>14}{:>8}{:>8}\n", "process", "elapsed ms", "best", "worst",
             "processor ms", "ratio", "MiB");
  print_process("rigor --version", idle, idle);
  print_process("rigor check", check, idle);
  const bool met = check.best <= most_milliseconds && check.mebibytes <= most_mebibytes;
  fmt::print("the goal of {} ms and {} MiB is {}\n\n", most_milliseconds, most_mebibytes,
             met ? "met" : "missed");
  return met;
}

int bench() {
  const Subject original{RIGOR_ORIGINAL_NOTES "/rigid-bodies.md", "derivations/physics-111.rigor"};
  bool met = bench(Subject{"derivations/rigid-bodies.md", ""});
  if (std::filesystem::is_regular_file(original.notes)) {
    met = bench(original) && met;
  } else {
    fmt::print("{} is not there and was not measured\n", original.notes);
  }
  return met ? 0 : 1;
}

}  // namespace
}  // namespace rigor::bench

int main() { return rigor::bench::bench(); }
