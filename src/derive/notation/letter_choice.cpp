// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/letter_choice.h"

#include <array>
#include <map>

#include "base/among.h"
#include "derive/polynomial/nodes.h"

namespace rigor {
namespace {

constexpr std::array<const char*, 16> usual_indices{"i", "j", "k", "l", "m", "n", "p", "q",
                                                    "r", "s", "t", "u", "v", "w", "a", "b"};
constexpr std::array<const char*, 6> usual_particles{"\\alpha", "\\beta",  "\\gamma",
                                                     "\\mu",    "\\sigma", "\\rho"};

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (!name.empty() && !is_one_of(name, names)) names.push_back(name);
}

/// Recursion: as deep as the tree, which the parser bounds.
class Lettering {
 public:
  Lettering(ExprTree& tree, const LetterChoice& choice) : tree_(tree), choice_(choice) {}

  ExprId write(ExprId id, std::set<std::string>& used) {
    ExprNode node = tree_[id];
    if (node.op == Op::index_sum) {
      const std::string name = choose(tree_.name(node.index), choice_.indices, usual_indices, used);
      return renamed_sum(id, &ExprNode::index, tree_.add_index(name), indices_, used);
    }
    if (node.op == Op::particle_sum) {
      const std::string name = choose(tree_.name(node.particle), choice_.particles, usual_particles, used);
      return renamed_sum(id, &ExprNode::particle, tree_.add_particle(name), particles_, used);
    }
    const std::vector<ExprId> before(tree_.children(id).begin(), tree_.children(id).end());
    const bool apart = node.op == Op::add || node.op == Op::tuple || node.op == Op::table;
    const std::set<std::string> outside = used;
    std::vector<ExprId> after;
    for (const ExprId child : before) {
      if (!apart) {
        after.push_back(write(child, used));
        continue;
      }
      std::set<std::string> own = outside;
      after.push_back(write(child, own));
      used.insert(own.begin(), own.end());
    }
    std::vector<Slot> slots(tree_.slots(id).begin(), tree_.slots(id).end());
    bool renamed = after != before;
    for (Slot& slot : slots) {
      const auto known = slot.axis == 0 ? indices_.find(slot.variable) : indices_.end();
      if (known == indices_.end()) continue;
      slot.variable = known->second;
      renamed = true;
    }
    if (const auto known = particles_.find(node.particle); known != particles_.end()) {
      node.particle = known->second;
      renamed = true;
    }
    if (!renamed) return id;
    return with_children(tree_, id, node, after, slots);
  }

 private:
  template <class Usual>
  static std::string choose(const std::string& own, const std::vector<std::string>& first, const Usual& usual,
                            std::set<std::string>& used) {
    std::vector<std::string> names;
    add_once(names, own);
    for (const std::string& name : first) add_once(names, name);
    for (const char* name : usual) add_once(names, name);
    for (const std::string& name : names) {
      if (used.insert(name).second) return name;
    }
    for (int number = 1;;
         ++number) {  // nobody has that many sums in one product, but no letter is given twice
      const std::string name = names.front() + "_{" + std::to_string(number) + '}';
      if (used.insert(name).second) return name;
    }
  }

  /// `variable`: the letter of the node's sum; `renamed`: the letters of its sort that have another one here.
  template <class Variable>
  ExprId renamed_sum(ExprId id, Variable ExprNode::*variable, Variable fresh,
                     std::map<Variable, Variable>& renamed, std::set<std::string>& used) {
    ExprNode node = tree_[id];
    const auto outer = renamed;
    renamed[node.*variable] = fresh;
    const ExprId body = write(tree_.children(id)[0], used);
    renamed = outer;
    node.*variable = fresh;
    return tree_.add(node, std::array{body});
  }

  ExprTree& tree_;
  const LetterChoice& choice_;
  std::map<IndexId, IndexId> indices_;
  std::map<ParticleId, ParticleId> particles_;
};

}  // namespace

void note_letters(const ExprTree& tree, ExprId root, LetterChoice& choice) {
  for (const ExprId id : nodes_below(tree, {root})) {
    const ExprNode& node = tree[id];
    if (node.op == Op::index_sum) add_once(choice.indices, tree.name(node.index));
    if (node.op == Op::particle_sum) add_once(choice.particles, tree.name(node.particle));
  }
}

ExprId with_letters(ExprTree& tree, ExprId root, const LetterChoice& choice) {
  std::set<std::string> used = choice.taken;
  return Lettering(tree, choice).write(root, used);
}

}  // namespace rigor
