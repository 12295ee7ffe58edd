// SPDX-License-Identifier: GPL-3.0-or-later
// Matchers for Catch2, version 2 or 3, whichever is there:
//
//   CHECK_THAT(rigor::step("\\mathbf{A}\\times\\mathbf{A} = 0"), rigor::is_proved());
//   CHECK_THAT(rigor::notes("notes/euler.tex"), rigor::all_hold());
//
// What fails shows the statement, its sample, and the nearest statement that is true.
#pragma once

#include <string>

#include <rigor/rigor.h>

#if defined(__has_include)
#if __has_include(<catch2/matchers/catch_matchers.hpp>)
#include <catch2/matchers/catch_matchers.hpp>
#define RIGOR_CATCH_MATCHER Catch::Matchers::MatcherBase
#endif
#endif
#if !defined(RIGOR_CATCH_MATCHER)
#include <catch2/catch.hpp>
#define RIGOR_CATCH_MATCHER Catch::MatcherBase
#endif

namespace rigor {

/// A step with this verdict, about which nothing else is wrong.
class VerdictMatcher : public RIGOR_CATCH_MATCHER<CheckedStep> {
 public:
  explicit VerdictMatcher(StepVerdict verdict) : verdict_(verdict) {}
  bool match(const CheckedStep& checked) const override {
    return checked.verdict == verdict_ && (verdict_ != StepVerdict::proved || checked.holds);
  }
  std::string describe() const override { return "is " + std::string(name_of(verdict_)); }

 private:
  StepVerdict verdict_;
};

/// A step that holds: proved, given, defined or skipped, or refuted as the notes expect.
class HoldsMatcher : public RIGOR_CATCH_MATCHER<CheckedStep> {
 public:
  bool match(const CheckedStep& checked) const override { return checked.holds; }
  std::string describe() const override { return "holds"; }
};

/// Notes whose steps all hold.
class AllHoldMatcher : public RIGOR_CATCH_MATCHER<CheckedNotes> {
 public:
  bool match(const CheckedNotes& checked) const override { return checked.all_hold; }
  std::string describe() const override { return "hold in every step"; }
};

inline VerdictMatcher is_proved() { return VerdictMatcher(StepVerdict::proved); }
inline VerdictMatcher is_refuted() { return VerdictMatcher(StepVerdict::refuted); }
inline VerdictMatcher is_undecided() { return VerdictMatcher(StepVerdict::undecided); }
inline VerdictMatcher is_not_understood() { return VerdictMatcher(StepVerdict::not_understood); }
inline HoldsMatcher holds() { return {}; }
inline AllHoldMatcher all_hold() { return {}; }

}  // namespace rigor

#undef RIGOR_CATCH_MATCHER
