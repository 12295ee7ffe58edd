// SPDX-License-Identifier: GPL-3.0-or-later
// Sums: of terms, which must agree in rank and free indices, and over an index or over particles.
#include <fmt/format.h>

#include <algorithm>

#include "elaborate/notation/elaborator.h"

namespace rigor {
namespace {

const char* kind_of(int rank) {
  if (rank == 0) return "a scalar";
  return rank == 1 ? "a vector" : "a tensor";
}

[[nodiscard]] bool has_no_limits(const WrittenSum& sum) { return sum.from.empty() && sum.to.empty(); }

[[nodiscard]] bool runs_over_axes(const WrittenSum& sum) {
  return has_no_limits(sum) || (sum.from == "1" && sum.to == "3");
}

/// A sum of the notes that runs the letter between other limits than those of the axes.
[[nodiscard]] const WrittenSum* sum_with_limits(const SyntaxTree& syntax, const std::string& letter) {
  for (std::size_t i = 0; i < syntax.size(); ++i) {
    const auto id = static_cast<SyntaxId>(i);
    if (syntax[id].kind != SyntaxKind::big_sum) continue;
    const WrittenSum& sum = syntax.big_sum(id);
    const bool same = std::any_of(sum.indices.begin(), sum.indices.end(),
                                  [&](const WrittenIndex& index) { return index.text == letter; });
    if (same && !runs_over_axes(sum)) return &sum;
  }
  return nullptr;
}

}  // namespace

std::optional<Typed> Elaborator::sum(SyntaxId id) {
  const Span span = syntax_[id].span;
  std::vector<Typed> addends;
  bool failed = false;
  for (const SyntaxChild& child : syntax_.children(id)) {
    Maybe addend = expression(child.id);
    if (!addend) {
      failed = true;
      continue;
    }
    if (child.joint == Joint::minus)
      *addend = make(Op::negate, tree_[addend->id].span, addend->rank, {&*addend});
    addends.push_back(std::move(*addend));
  }
  if (failed || addends.empty()) return std::nullopt;
  std::erase_if(addends,
                [&](const Typed& addend) { return addends.size() > 1 && is_literal_zero(tree_, addend); });
  if (addends.empty()) {
    Typed zero;
    zero.id = tree_.add_number(span, "0");
    return zero;
  }
  if (addends.size() == 1) return addends[0];
  Typed total;
  total.rank = addends[0].rank;
  std::vector<ExprId> children;
  for (const Typed& addend : addends) {
    failed = !same_type(addends[0], addend, "term", {tree_[addend.id].span, diagnostics_}) || failed;
    children.push_back(addend.id);
    merge_free(total.free, addend.free);
    merge_free(total.particles, addend.particles);
    merge_free(total.bound, addend.bound);
  }
  if (failed) return std::nullopt;
  total.id =
      tree_.add({.op = Op::add, .rank = static_cast<std::uint8_t>(total.rank), .span = span}, children);
  return total;
}

/// Terms of a sum, and the sides of a relation, have one rank and the same free indices; `place` is where
/// `other` disagrees.
bool Elaborator::same_type(const Typed& first, const Typed& other, const char* what,
                           Mismatch mismatch) const {
  const Span first_span = tree_[first.id].span;
  const Span other_span = tree_[other.id].span;
  if (first.rank != other.rank && dyad_) {
    mismatch.diagnostics.push_back(
        {DiagnosticKind::ambiguous_reading, *dyad_, guess_->message, {}, guess_->help});
    return false;
  }
  if (first.rank != other.rank) {
    mismatch.diagnostics.push_back(
        {DiagnosticKind::rank_mismatch,
         mismatch.relation,
         fmt::format("{} stands against {}", kind_of(other.rank), kind_of(first.rank)),
         {{first_span, kind_of(first.rank)}}});
    return false;
  }
  const auto missing = [](const auto& from, const auto& in) {
    return std::find_if(from.begin(), from.end(), [&](const auto& entry) {
      return std::none_of(in.begin(), in.end(), [&](const auto& old) { return old.letter == entry.letter; });
    });
  };
  const auto report = [&](const auto& entry, Span without) {
    const bool shown = letters_.is_sure(entry.letter);
    const DiagnosticKind kind =
        shown ? DiagnosticKind::free_index_mismatch : DiagnosticKind::ambiguous_reading;
    mismatch.diagnostics.push_back(
        {kind,
         entry.span,
         shown ? fmt::format("the free index `{}` stands on one {} only", entry.letter, what)
               : fmt::format("`{}` can be a free index, which then stands on one {} only, or a label",
                             entry.letter, what),
         {{without, fmt::format("no free `{}` here", entry.letter)}}});
    return false;
  };
  if (const auto extra = missing(other.free, first.free); extra != other.free.end())
    return report(*extra, first_span);
  if (const auto extra = missing(first.free, other.free); extra != first.free.end())
    return report(*extra, other_span);
  return true;
}

std::optional<Typed> Elaborator::big_sum(SyntaxId id) {
  const WrittenSum& written = syntax_.big_sum(id);
  const Span span = syntax_[id].span;
  for (const WrittenIndex& index : written.indices) {
    const bool particle = names_.is_particle_letter(index.text);
    if (index.primes > 0 || index.form == IndexForm::digit || index.form == IndexForm::word) {
      return unsupported(index.span, fmt::format("a sum over `{}` is not read", index.text));
    }
    const bool all = has_no_limits(written) || (written.from == "1" && written.to == "N");
    if (particle && !all)
      return unsupported(index.span, "a sum over some of the particles is not decided",
                         {"a sum over all has no limits, or `1` and `N`"});
    if (particle && !written.to.empty() && letters_.bare.contains("N")) {
      guess_ = Obstacle{DiagnosticKind::unsupported, "`N` was not taken for the number of particles", {}};
    }
    const WrittenSum* const other =
        !particle && has_no_limits(written) ? sum_with_limits(syntax_, index.text) : nullptr;
    if (other != nullptr)
      return unsupported(
          index.span,
          fmt::format("the sum over `{}` can run over the axes, or from {} to {} as elsewhere in the notes",
                      index.text, other->from, other->to),
          {"limits at the sum settle it"});
    if (!particle && !runs_over_axes(written)) {
      return unsupported(
          index.span, fmt::format("the sum over `{}` does not run over the axes 1 to 3", index.text),
          {fmt::format("if `{}` labels particles, say `rigor: particles {}`", index.text, index.text)});
    }
    if (particle) {
      bound_particles_[index.text].push_back(tree_.add_particle(index.text));
    } else {
      bound_indices_[index.text].push_back(tree_.add_index(index.text));
    }
  }
  Maybe body = expression(syntax_.child(id, 0));
  for (auto index = written.indices.rbegin(); index != written.indices.rend(); ++index) {
    const bool particle = bound_particles_.contains(index->text);
    ExprNode node{.op = particle ? Op::particle_sum : Op::index_sum, .span = span};
    if (particle) {
      auto& ids = bound_particles_[index->text];
      node.particle = ids.back();
      ids.pop_back();
      if (ids.empty()) bound_particles_.erase(index->text);
    } else {
      auto& ids = bound_indices_[index->text];
      node.index = ids.back();
      ids.pop_back();
      if (ids.empty()) bound_indices_.erase(index->text);
      if (body) body->bound.push_back({index->text, node.index, index->span});
    }
    if (!body) continue;
    node.rank = static_cast<std::uint8_t>(body->rank);
    body->id = tree_.add(node, std::span(&body->id, 1));
  }
  return body;
}

}  // namespace rigor
