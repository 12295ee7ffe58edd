// SPDX-License-Identifier: GPL-3.0-or-later
// What was computed for a scene and what was not, with the reason: the record behind `--explain`.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// The parts of a scene that quantities may depend on.
struct SceneNode {
  std::string name;  // `principal moments`, `T_{rot}`
  bool computed = false;
  std::string reason;  // skipped: why; computed: what for, or how
  double milliseconds = 0;
};

class SceneLedger {
 public:
  /// A node that may be computed; until it is, it counts as skipped for the reason given.
  void expect(std::string name, std::string reason) {
    if (find(name) == nullptr) nodes_.push_back({std::move(name), false, std::move(reason), 0});
  }
  /// Says why a node that was not computed was not needed.
  void skip(const std::string& name, std::string reason) {
    expect(name, "");
    find(name)->reason = std::move(reason);
  }
  /// Calls `work`, and records its time as the node's; more calls add up.
  template <class Work>
  auto compute(const std::string& name, std::string reason, Work work) {
    const auto begin = std::chrono::steady_clock::now();
    auto result = work();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    expect(name, "");
    SceneNode& node = *find(name);
    node.computed = true;
    node.reason = std::move(reason);
    node.milliseconds += time.count();
    return result;
  }

  [[nodiscard]] const std::vector<SceneNode>& nodes() const { return nodes_; }

 private:
  [[nodiscard]] SceneNode* find(const std::string& name) {
    for (SceneNode& node : nodes_) {
      if (node.name == name) return &node;
    }
    return nullptr;
  }

  std::vector<SceneNode> nodes_;
};

}  // namespace rigor
