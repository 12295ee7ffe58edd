// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that asks only for a sum over the particles, beside that sum alone: milliseconds, the least of many
// runs that take turns, in one process on the same body. Fails if the scene takes over 10 % more at 10^6
// particles.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <utility>

#include "app/command/scene.h"
#include "numeric/body/body_letters.h"
#include "numeric/measure/evaluate.h"
#include "scene/quantity/scene.h"

namespace rigor {
namespace {

constexpr int rounds = 100;
constexpr double most_times_the_sum = 1.1;

double milliseconds(const std::function<void()>& run) {
  const auto before = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count();
}

/// The scene's time over that of the sum.
double ratio(const LoadedScene& loaded, const Body& few, const Body& body) {
  const WrittenForms& forms = loaded.reading.forms;
  const ProgramRoot root{forms.asked.at(0).expr, {}};
  const Program program = Program::compile(forms.tree, forms.definitions, std::span(&root, 1)).value();
  const Program* const programs[] = {&program};
  const BodyLetters letters = body_letters(forms.tree, programs).value();
  const auto samples_of = [&](const Body& given) {
    Samples samples(1, given.size());
    samples.borrow_particles(*letters.mass, 0, given.masses);
    for (std::uint32_t k = 0; k < 3; ++k) samples.borrow_particles(*letters.position, k, given.positions[k]);
    for (const ProgramInput& input : program.inputs()) {
      if (!input.per_particle)
        samples.set(input.symbol, input.component, (*loaded.scene.spin)[input.component]);
    }
    return samples;
  };
  double sum = 1e300;
  double scene = 1e300;
  double value = 0;
  SceneResult result;
  for (int round = 0; round < rounds; ++round) {
    {
      const Body given = body;
      const Samples samples = samples_of(given);
      sum = std::min(sum, milliseconds([&] { value = evaluate(program, samples)[0]; }));
    }
    Body given = body;  // where the sum had it
    // The copy drove the scene's own 10 us out of the caches: ten times that, if they come from memory.
    static_cast<void>(evaluate_scene(loaded.scene, few, forms));
    scene = std::min(scene,
                     milliseconds([&] { result = evaluate_scene(loaded.scene, std::move(given), forms); }));
  }
  const double asked = result.quantities.at(0).value.at(0);
  fmt::print("{:>9} particles: sum {:.4f} ms, scene {:.4f} ms, ratio {:.3f}; {:.10g} and {:.10g}\n",
             body.size(), sum, scene, scene / sum, value, asked);
  return scene / sum;
}

int run_bench() {
  // A scene frees its body, the sum does not: what is freed stays with the program, at hardly any cost.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, 1 << 28);
  SourceMap sources;
  LoadedScene loaded;
  if (load_scene("derivations/scenes/energy.toml", sources, loaded, std::cerr) != ExitCode::ok) return 1;
  double last = 0;
  const Body few = random_cloud("few", 100, 1).value();
  for (const std::size_t particles : {std::size_t{1'000}, std::size_t{100'000}, std::size_t{1'000'000}})
    last = ratio(loaded, few, random_cloud("cloud", particles, 1).value());
  return last <= most_times_the_sum ? 0 : 1;
}

}  // namespace
}  // namespace rigor

int main() { return rigor::run_bench(); }
