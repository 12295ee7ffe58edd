// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/advice/advise_forms.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "numeric/advice/simplest_point.h"

namespace rigor {
namespace {

constexpr std::size_t most_proposals = 60;
constexpr std::size_t last_effort = 6;  // of the attack that advice has to stand
constexpr double wide_size = 1e49;      // of ranges that leave out extreme sizes only
constexpr double ordinary_size = 1e74;  // where the cheapest form may be another one than beyond

class FormAdviser {
 public:
  FormAdviser(const SearchSpace& space, const ExprTree& tree, std::span<const double> costs,
              std::uint64_t seed)
      : space_(space), tree_(tree), attacker_(space, seed), by_cost_(costs.size()) {
    std::iota(by_cost_.begin(), by_cost_.end(), std::size_t{0});
    std::ranges::stable_sort(by_cost_, {}, [&](std::size_t form) { return costs[form]; });
  }

  std::optional<RangeAdvice> advise(std::size_t most_work) {
    bool any = false;
    for (const Range& range : {Range{}, Range{.least = 1e-75, .most = 1e75}, Range{.most = 8}}) {
      for (const std::size_t form : by_cost_) any = attacker_.worst(form, range, {}).has_value() || any;
    }
    if (!any) return std::nullopt;
    RangeAdvice advice;
    for (std::size_t k = 0; k < most_proposals && advice.parts.empty(); ++k) {
      if (attacker_.work() > most_work) return std::nullopt;
      auto proposed = proposal();
      if (proposed.empty()) break;
      if (stands(proposed)) advice.parts = std::move(proposed);
    }
    if (advice.parts.empty()) {
      advice.others = losing_forms({}, by_cost_.size());
      return advice;
    }
    if (advice.parts.size() == 1) add_second_range(advice.parts);
    for (AdvisedForm& part : advice.parts) part.others = losing_forms(part.range, part.form);
    return advice;
  }

 private:
  /// Has no point of the range been seen where the form loses? A range in which no point meets the conditions
  /// says nothing of a form.
  [[nodiscard]] bool seems_safe(std::size_t form, const Range& range) const {
    if (std::ranges::find(empty_, range) != empty_.end()) return false;
    return std::ranges::none_of(attacker_.losing_points(form),
                                [&](const Point& point) { return contains(space_, range, point); });
  }
  /// The cheapest one that seems safe.
  [[nodiscard]] std::optional<std::size_t> form_for(const Range& range) const {
    for (const std::size_t form : by_cost_)
      if (seems_safe(form, range)) return form;
    return std::nullopt;
  }

  /// From the simplest: one form everywhere; one for all sizes but extreme ones; one for each half; both; one
  /// up to a size, which is what angles and exponents need; any half of any range.
  [[nodiscard]] std::vector<AdvisedForm> proposal() const {
    const std::vector<Range> ranges = ranges_of_sizes();
    const auto is_wide = [](const Range& range) { return range.most > wide_size; };
    if (auto whole = one_form(ranges[0]); !whole.empty()) return whole;
    for (const Range& range : ranges) {
      if (!is_wide(range)) continue;
      if (auto one = one_form(range); !one.empty()) return one;
    }
    if (auto halves = two_forms(ranges[0], false); !halves.empty()) return halves;
    for (const bool wide : {true, false}) {
      for (const Range& range : ranges) {
        if (is_wide(range) != wide) continue;
        if (auto one = one_form(range); !one.empty()) return one;
      }
      for (const Range& range : ranges) {
        if (is_wide(range) != wide) continue;
        if (auto two = two_forms(range, !wide); !two.empty()) return two;
      }
    }
    return {};
  }

  [[nodiscard]] std::vector<AdvisedForm> one_form(const Range& range) const {
    const auto form = form_for(range);
    if (!form) return {};
    return {{*form, range, {}}};
  }

  [[nodiscard]] std::vector<AdvisedForm> two_forms(const Range& range, bool compares_letters) const {
    for (Half half : halves_of(space_, tree_)) {
      if (half.by == Half::By::larger && !compares_letters) continue;
      Range first = range;
      first.half = half;
      const auto one = form_for(first);
      if (!one) continue;
      Range second = range;
      half.first = false;
      second.half = half;
      const auto other = form_for(second);
      if (other) return {{*one, first, {}}, {*other, second, {}}};
    }
    return {};
  }

  [[nodiscard]] bool stands(const std::vector<AdvisedForm>& parts) {
    for (const std::size_t effort : {std::size_t{1}, last_effort}) {
      for (const AdvisedForm& part : parts) {
        const auto found = attacker_.worst(part.form, part.range, {.effort = effort, .refutes = true});
        if (!found) empty_.push_back(part.range);
        if (!found || found->loss > no_loss) return false;
        if (!seems_safe(part.form, part.range)) return false;
      }
    }
    return true;
  }

  /// What holds beyond a range of sizes; or, where one form is safe everywhere, a cheaper one for ordinary
  /// sizes.
  void add_second_range(std::vector<AdvisedForm>& parts) {
    const AdvisedForm only = parts[0];
    if (!only.range.has_all_sizes()) {
      Range beyond = only.range;
      beyond.beyond = true;
      const auto form = form_for(beyond);
      if (form && stands({{*form, beyond, {}}})) parts.push_back({*form, beyond, {}});
      return;
    }
    for (const Range& range : ranges_of_sizes()) {
      if (range.has_all_sizes() || range.most < ordinary_size) continue;
      const auto form = form_for(range);
      if (!form || *form == only.form || !stands({{*form, range, {}}})) continue;
      Range beyond = range;
      beyond.beyond = true;
      parts = {{*form, range, {}}, {only.form, beyond, {}}};
      return;
    }
  }

  [[nodiscard]] std::vector<OtherForm> losing_forms(const Range& range, std::size_t besides) {
    std::vector<OtherForm> others;
    for (std::size_t form = 0; form < by_cost_.size(); ++form) {
      if (form == besides) continue;
      const auto found = attacker_.worst(form, range, {.effort = 2, .ordinary = true});
      if (!found || found->loss <= no_loss) continue;
      others.push_back({form, simplest_point(attacker_, space_, form, range, *found)});
    }
    return others;
  }

  const SearchSpace& space_;
  const ExprTree& tree_;
  Attacker attacker_;
  std::vector<std::size_t> by_cost_;
  std::vector<Range> empty_;  // in which an attack met no point
};

}  // namespace

std::optional<RangeAdvice> advise_forms(const SearchSpace& space, const ExprTree& tree,
                                        std::span<const double> costs, std::uint64_t seed,
                                        std::size_t most_work) {
  return FormAdviser(space, tree, costs, seed).advise(most_work);
}

}  // namespace rigor
