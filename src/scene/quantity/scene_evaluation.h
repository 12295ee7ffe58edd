// SPDX-License-Identifier: GPL-3.0-or-later
// One scene while it is evaluated: first everything asked for is compiled, then what that reads is made, then
// it is run.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "numeric/measure/evaluate.h"
#include "scene/motion/spin_law.h"
#include "scene/quantity/scene.h"
#include "scene/quantity/scene_values.h"

namespace rigor {

class SceneEvaluation {
 public:
  /// Scene and forms are kept by reference.
  SceneEvaluation(const SceneFile& scene, Body body, const WrittenForms& forms);

  [[nodiscard]] SceneResult run();

 protected:  // a test measures motions of its own with it
  static constexpr const char* law_node = "law of motion";
  static constexpr const char* motion_node = "motion";

  /// Something asked for, with its program.
  struct Asked {
    const SceneAsk* ask = nullptr;
    const AskedForm* form = nullptr;   // null: a part of the scene itself
    std::optional<Program> program{};  // nothing: it could not be compiled
    bool failed = false;
  };

  void report(DiagnosticKind kind, Span span, std::string message, const std::string& help = {});
  void fail(Asked& asked, const std::string& message, const std::string& help = {});

  // scene.cpp
  [[nodiscard]] bool compile_all();
  void compile(Asked& asked, std::set<SceneRole>& read);
  void note_roles(const Program& program, std::set<SceneRole>& read) const;
  [[nodiscard]] bool reads(const Program& program, const std::vector<SymbolId>& symbols) const;

  // scene_law.cpp
  void collect_law(std::set<SceneRole>& read);
  void add_to_law(const WrittenFormChain& chain, std::size_t step, std::set<SceneRole>& read);
  void make_law();
  void move();
  [[nodiscard]] bool split(const SpinRates& rates, const MotionRequest& request);

  // scene_quantity.cpp
  void evaluate_one(Asked& asked);
  void evaluate_own_part(Asked& asked);
  /// What a program reads, for each of the spins; everything else is the same for all.
  [[nodiscard]] Samples samples_for(const Program& program, std::span<const Vector3> spins);
  [[nodiscard]] Arithmetic arithmetic_for(const Program& program) const;
  [[nodiscard]] std::vector<double> run_program(const Program& program, std::span<const Vector3> spins);
  /// Does it read the letter t? Along a motion that is the time, of which the values say nothing.
  [[nodiscard]] bool reads_time(const Program& program) const;
  void follow_motion(const Asked& asked, SceneQuantity& quantity);
  void note_drift(const SceneText& name, const SceneQuantity& quantity,
                  const std::vector<std::vector<double>>& rows);

  const SceneFile& scene_;
  const WrittenForms& forms_;
  SceneResult result_;
  SceneLedger ledger_;
  SceneBody body_;
  SceneLetters letters_;
  SceneValues values_;
  std::vector<SymbolId> spin_symbols_;
  std::vector<SymbolId> rate_symbols_;
  std::vector<Definition> definitions_;  // of the notes, without those of letters that have a value
  std::vector<Asked> asked_;
  std::vector<LawEquation> law_;
  std::vector<Program> law_programs_;
  std::size_t chains_of_law_ = 0;
  bool needs_motion_ = false;
  bool needs_law_ = false;
  std::optional<SpinLaw> law_of_spin_;
  Vector3 start_{};  // the spin at the time 0
};

}  // namespace rigor
