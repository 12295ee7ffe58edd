// SPDX-License-Identifier: GPL-3.0-or-later
// How long the default effort of a step lasts: the time of a unit on steps that are slow in different ways,
// beside a step whose work is samples alone. Processor time; each figure is the least of several runs.
//
// Fails if the default would last longer than two seconds on any of them.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "algebra/budget.h"
#include "check/check.h"

namespace rigor::bench {
namespace {

constexpr int runs = 5;
constexpr double most_seconds = 2.0;

/// A note with one slow display, which is its last step.
struct Slow {
  const char* what;
  const char* note;
};

constexpr Slow slow[] = {
    {"powers of sums", R"(<!-- rigor: scalar a, b, c, d, e, f, g -->
$$(a+b+c+d+e+f+g)^6 + \sqrt{(a+b)^2} = (g+f+e+d+c+b+a)^2(a+b+c+d+e+f+g)^4 + |a+b|$$
)"},
    {"roots and assumptions", R"(<!-- rigor: scalar E, k, l, m, a, b, p, e -->
<!-- rigor: where k > 0, m > 0, l > 0, E < 0 -->
<!-- rigor: given p = \frac{l^2}{mk} -->
<!-- rigor: given e^2 = 1 + \frac{2El^2}{mk^2} -->
<!-- rigor: given a(1-e^2) = p -->
<!-- rigor: given b^2 = ap -->
$$E = -\frac{k}{2a}$$
$$\frac{2\pi m\,ab}{l} = 2\pi\sqrt{\frac{ma^3}{k}}$$
)"},
    {"an orbit in components", R"(<!-- rigor: vector \mathbf r -->
<!-- rigor: scalar k, m, G, M -->
<!-- rigor: constant k, m, G, M -->
$$E = \frac12m|\dot{\mathbf r}|^2 - \frac{k}{|\mathbf r|}, \qquad l = m|\mathbf r\times\dot{\mathbf r}|$$
$$p = \frac{l^2}{mk}, \qquad e = \sqrt{1 + \frac{El^2}{mk^2}}, \qquad a = \frac{p}{1-e^2}$$
$$b = a\sqrt{1-e^2} = \sqrt{ap}$$
$$\frac{2\pi m\,ab}{l} = 2\pi\sqrt{\frac{ma^3}{k}}$$
)"},
};

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

int run() {
  bool in_time = true;
  fmt::print("{:<28} {:>12} {:>10} {:>10} {:>22}\n", "step", "units", "ms", "ns a unit",
             "the default lasts, s");
  for (const Slow& each : slow) {
    double least = 1e9;
    std::uint64_t units = 0;
    for (int i = 0; i < runs; ++i) {
      SourceMap sources;
      const double start = processor_seconds();
      const FileReport report = check_text(sources, "slow.md", each.note);
      least = std::min(least, processor_seconds() - start);
      units = 0;
      for (const Step& step : report.steps) units += step.work;
    }
    const double a_unit = least / static_cast<double>(std::max<std::uint64_t>(units, 1));
    const double lasts = a_unit * static_cast<double>(default_effort);
    in_time = in_time && lasts < most_seconds;
    fmt::print("{:<28} {:>12} {:>10.1f} {:>10.0f} {:>22.2f}\n", each.what, units, least * 1e3, a_unit * 1e9,
               lasts);
  }
  return in_time ? 0 : 1;
}

}  // namespace
}  // namespace rigor::bench

int main() { return rigor::bench::run(); }
