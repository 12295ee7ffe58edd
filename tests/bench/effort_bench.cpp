// SPDX-License-Identifier: GPL-3.0-or-later
// How long the default effort of a step lasts: the time of a unit on steps that are slow in different ways,
// beside a step whose work is samples alone. Processor time; each figure is the least of several runs.
//
// Fails if the default would last longer than two seconds on any of them, or if one is not read any more.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "algebra/engine/budget.h"
#include "check/entry/check.h"

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
<!-- rigor: for all E, k, l, m, a, b -->
<!-- rigor: where k > 0 -->
<!-- rigor: where m > 0 -->
<!-- rigor: where l > 0 -->
<!-- rigor: where E < 0 -->
<!-- rigor: given p = \frac{l^2}{mk} -->
<!-- rigor: given e^2 = 1 + \frac{2El^2}{mk^2} -->
<!-- rigor: given a(1-e^2) = p -->
<!-- rigor: given b^2 = ap -->
$$E = -\frac{k}{2a}$$
$$\frac{2m\,ab}{l} = 2\sqrt{\frac{ma^3}{k}}$$
)"},
    {"an orbit in components", R"(<!-- rigor: vector \mathbf r -->
<!-- rigor: scalar k, m, G, M -->
<!-- rigor: constant k, m, G, M -->
$$E = \frac12m|\dot{\mathbf r}|^2 - \frac{k}{|\mathbf r|}, \qquad l = m|\mathbf r\times\dot{\mathbf r}|$$
$$p = \frac{l^2}{mk}, \qquad e = \sqrt{1 + \frac{El^2}{mk^2}}, \qquad a = \frac{p}{1-e^2}$$
$$b = a\sqrt{1-e^2} = \sqrt{ap}$$
$$\frac{2\pi m\,ab}{l} = 2\pi\sqrt{\frac{ma^3}{k}}$$
)"},
    {"a product of many sums", R"(<!-- rigor: scalar a, b, c, d, e, f -->
$$(a+b+c)(b+c+d)(c+d+e)(d+e+f)(e+f+a)(f+a+b)(a-b+c)(b-c+d)(c-d+e) = (a+b+c)(c-d+e)(b+c+d)(b-c+d)(c+d+e)(a-b+c)(d+e+f)(f+a+b)(e+f+a)$$
)"},
    {"quotients of sums", R"(<!-- rigor: scalar a, b, c, d, e, f -->
$$\frac{1}{a+b} + \frac{1}{b+c} + \frac{1}{c+d} + \frac{1}{d+e} + \frac{1}{e+f} + \frac{1}{f+a} = \frac{1}{f+a} + \frac{1}{e+f} + \frac{1}{d+e} + \frac{1}{b+c} + \frac{b+c+2d-d+a}{(a+b)(c+d)}$$
)"},
    {"nested roots", R"(<!-- rigor: scalar a, b, c, d -->
<!-- rigor: where a > 0, b > 0, c > 0, d > 0 -->
$$\sqrt{a+b}\sqrt{b+c}\sqrt{c+d}\sqrt{a+\sqrt{b+c}} = \sqrt{(a+b)(b+c)(c+d)\left(a+\sqrt{b+c}\right)}$$
$$\left(\sqrt{a} + \sqrt{b} + \sqrt{c} + \sqrt{d}\right)^6 = \left(\sqrt{a} + \sqrt{b} + \sqrt{c} + \sqrt{d}\right)^4\left(a + b + c + d + 2\sqrt{ab} + 2\sqrt{ac} + 2\sqrt{ad} + 2\sqrt{bc} + 2\sqrt{bd} + 2\sqrt{cd}\right)$$
)"},
    {"roots of high powers",
     R"($$\sqrt{\frac{b}{\frac{(x_i y_i)^{64}}{\sqrt{x_i y_i\,\mathbf{a}\cdot\mathbf{b}}}} + c} - y \approx c$$
)"},
    {"many indices", R"(<!-- rigor: vector \mathbf a, \mathbf b, \mathbf c, \mathbf d -->
$$\epsilon_{ijk}\epsilon_{klm}\epsilon_{mnp}\epsilon_{pqr}a_ib_jc_ld_na_qb_r = \epsilon_{rqp}\epsilon_{pnm}\epsilon_{mlk}\epsilon_{kji}a_ib_jc_ld_na_qb_r$$
)"},
    {"vectors, lengths and products", R"(<!-- rigor: vector \mathbf a, \mathbf b, \mathbf c, \mathbf d -->
$$|\mathbf a\times\mathbf b|^2|\mathbf c\times\mathbf d|^2 = \left(|\mathbf a|^2|\mathbf b|^2 - (\mathbf a\cdot\mathbf b)^2\right)\left(|\mathbf c|^2|\mathbf d|^2 - (\mathbf c\cdot\mathbf d)^2\right)$$
$$\frac{\mathbf a\times(\mathbf b\times\mathbf c)}{|\mathbf a - \mathbf b|^3|\mathbf b - \mathbf c|^3} = \frac{\mathbf b(\mathbf a\cdot\mathbf c) - \mathbf c(\mathbf a\cdot\mathbf b)}{|\mathbf b - \mathbf a|^3|\mathbf c - \mathbf b|^3}$$
)"},
    {"sums over particles", R"(<!-- rigor: particles \alpha, \beta -->
<!-- rigor: vector \mathbf r_\alpha, \mathbf v_\alpha, \mathbf R, \mathbf V -->
<!-- rigor: scalar m_\alpha -->
$$\sum_\alpha\sum_\beta m_\alpha m_\beta|(\mathbf r_\alpha - \mathbf r_\beta)\times(\mathbf v_\alpha - \mathbf v_\beta)|^2 = \sum_\alpha\sum_\beta m_\alpha m_\beta\left(|\mathbf r_\alpha - \mathbf r_\beta|^2|\mathbf v_\alpha - \mathbf v_\beta|^2 - ((\mathbf r_\alpha - \mathbf r_\beta)\cdot(\mathbf v_\alpha - \mathbf v_\beta))^2\right)$$
$$\sum_\alpha\frac{m_\alpha|\mathbf r_\alpha - \mathbf R|^2(\mathbf v_\alpha\cdot\mathbf V)^2}{|\mathbf r_\alpha + \mathbf R|^3} = \sum_\alpha\frac{m_\alpha(|\mathbf r_\alpha|^2 - 2\mathbf r_\alpha\cdot\mathbf R + |\mathbf R|^2)(\mathbf v_\alpha\cdot\mathbf V)^2}{|\mathbf r_\alpha + \mathbf R|^3}$$
)"},
    {"orders", R"(<!-- rigor: scalar a, b, c, d -->
<!-- rigor: where 0 < a < b < c < d -->
$$(b-a)(c-b)(d-c)(d-a) > 0, \qquad a^2 + b^2 + c^2 + d^2 \ge ab + bc + cd + da, \qquad \sqrt{ab} + \sqrt{cd} \le \frac{a+b+c+d}{2}$$
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
    double reading = 1e9;  // with nothing decided
    std::uint64_t units = 0;
    std::size_t unread = 0;
    for (int i = 0; i < runs; ++i) {
      SourceMap sources;
      const double start = processor_seconds();
      const FileReport report = check_text(sources, "slow.md", each.note);
      least = std::min(least, processor_seconds() - start);
      SourceMap again;
      const double begin = processor_seconds();
      static_cast<void>(check_text(again, "slow.md", each.note, {.effort = 1}));
      reading = std::min(reading, processor_seconds() - begin);
      units = unread = 0;
      for (const Step& step : report.steps) {
        units += step.work;
        if (step.verdict == Verdict::not_understood) ++unread;
      }
    }
    in_time = in_time && unread == 0;
    if (unread > 0) fmt::print("{}: {} steps are not read\n", each.what, unread);
    const double a_unit = (least - reading) / static_cast<double>(std::max<std::uint64_t>(units, 1));
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
