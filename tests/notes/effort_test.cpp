// SPDX-License-Identifier: GPL-3.0-or-later
// No step of notes takes more work than a step has by default: of ours, of what becomes of them when bytes
// are lost, doubled and exchanged, and of formulas with many roots.
#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "catch.h"
#include "check/entry/check.h"
#include "source/read_file.h"

using namespace rigor;

namespace {

/// The most work that a step took.
std::uint64_t most_work(const FileReport& report) {
  std::uint64_t most = 0;
  for (const Step& step : report.steps) {
    INFO(report.path << ": " << step.source);
    CHECK(step.work < default_effort);
    most = std::max(most, step.work);
  }
  return most;
}

std::vector<std::string> notes_in(const char* folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".md" || extension == ".tex") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// The text with some bytes lost, doubled, or exchanged with the next one.
std::string spoilt(std::string text, std::uint32_t seed) {
  constexpr int slips = 40;
  std::mt19937 random(seed);
  for (int i = 0; i < slips; ++i) {
    const std::size_t at = random() % (text.size() - 1);
    switch (random() % 3) {
      case 0:
        text.erase(at, 1);
        break;
      case 1:
        text.insert(at, 1, text[at]);
        break;
      default:
        std::swap(text[at], text[at + 1]);
    }
  }
  return text;
}

std::uint64_t most_work_in(const std::string& name, std::string text) {
  SourceMap sources;
  return most_work(check_text(sources, name, std::move(text)));
}

}  // namespace

TEST_CASE("no step of our notes takes more work than the default", "[long]") {
  std::uint64_t most = 0;
  for (const char* folder : {"../../derivations", "pass", "fail"}) {
    for (const std::string& path : notes_in(folder)) {
      SourceMap sources;
      most = std::max(most, most_work(check_file(sources, path)));
    }
  }
  CHECK(most > 1000);
}

TEST_CASE("no step of notes with lost, doubled and exchanged bytes takes more work than the default",
          "[notes]") {
  std::uint32_t seed = 0;
  for (const std::string& path : notes_in("../../derivations")) {
    const Result<std::string> text = read_file(path);
    REQUIRE(text);
    for (int i = 0; i < 4; ++i) most_work_in(path, spoilt(*text, ++seed));
  }
}

TEST_CASE("formulas with roots of roots take less work than the default", "[notes]") {
  constexpr std::string_view orbit = R"(
<!-- rigor: vector \mathbf r -->
<!-- rigor: scalar k, m -->
<!-- rigor: constant k, m -->

$$E = \frac12m|\dot{\mathbf r}|^2 - \frac{k}{|\mathbf r|}, \qquad l = m|\mathbf r\times\dot{\mathbf r}|$$

$$p = \frac{l^2}{mk}, \qquad e = \sqrt{1 + \frac{El^2}{mk^2}}, \qquad a = \frac{p}{1-e^2}$$

$$b = a\sqrt{1-e^2} = \sqrt{ap}$$

$$\frac{2\pi m\,ab}{l} = 2\pi\sqrt{\frac{ma^3}{k}}$$
)";
  CHECK(most_work_in("orbit.md", std::string(orbit)) > 100'000);
}
