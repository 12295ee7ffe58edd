// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.h"
#include "base/check.h"
#include "check/question/decision_cache.h"
#include "check/repair/missing_condition.h"
#include "check/repair/repair.h"
#include "check/repair/sides_near.h"
#include "check/review/review.h"
#include "check/step/repair_fields.h"
#include "source/processes.h"

namespace rigor {
namespace {

using Clock = std::chrono::steady_clock;

/// Not understood, since indices or ranks do not fit, and the page says of nothing near it that it follows.
bool is_malformed(const Step& step) {
  return step.verdict == Verdict::not_understood && step.repairs.empty() &&
         std::ranges::any_of(step.diagnostics, [](const Diagnostic& diagnostic) {
           return diagnostic.severity() == Severity::error && shows_repairs(diagnostic.kind);
         });
}

/// A side that another step supports is less likely to hold the slip.
Trust trust_by(const Statement& statement, std::size_t which, bool exists, const FileReport& report) {
  if (!exists) return Trust::unknown;
  const Verdict verdict = report.steps[statement.first_step + which].verdict;
  if (verdict == Verdict::proved) return Trust::supported;
  return verdict == Verdict::refuted ? Trust::doubted : Trust::unknown;
}

bool is_wrong(const Statement& statement, std::size_t which, const CheckOptions& options, const Step& step) {
  if (step.verdict != Verdict::refuted && !is_malformed(step)) return false;
  const auto& remainders = statement.chain->remainders;
  if (which + 1 < remainders.size() && remainders[which + 1]) return false;
  return !step.expected_refuted || options.repairs != Repairs::of_unexpected;
}

/// A wrong step, and what it is beside.
struct WrongPlace {
  const LedgerEntry* entry = nullptr;
  const Statement* statement = nullptr;
  std::size_t which = 0;

  [[nodiscard]] std::size_t step() const { return statement->first_step + which; }
};

/// What is offered beside one step.
struct Offer {
  std::vector<Repair> repairs = {};
  std::vector<std::string> conditions = {};
  double repair_milliseconds = 0.0;
  std::uint64_t work = 0;
};

template <class Archive>
void fields(Archive& archive, Offer& offer) {
  archive(offer.repairs, offer.conditions, offer.repair_milliseconds, offer.work);
}

std::vector<WrongPlace> wrong_places(const Ledger& ledger, const CheckOptions& options,
                                     const FileReport& report) {
  std::vector<WrongPlace> wrong;
  for (const LedgerEntry& entry : ledger.entries) {
    const auto* statement = std::get_if<Statement>(&entry.what);
    if (statement == nullptr || !is_claimed(statement->role) || statement->chain->image > 0) continue;
    for (std::size_t which = 0; which < statement->step_count; ++which) {
      if (is_wrong(*statement, which, options, report.steps[statement->first_step + which]))
        wrong.push_back({&entry, statement, which});
    }
  }
  return wrong;
}

/// Nothing that is decided for one step changes what is offered beside another.
Offer offer_beside(const WrongPlace& place, const Ledger& ledger, const Notes& notes,
                   const CheckOptions& options, const FileReport& report) {
  const auto start = Clock::now();
  const Statement& statement = *place.statement;
  const std::size_t which = place.which;
  const WrongStep wrong{.parsed = *statement.chain,
                        .which = which,
                        .first_order = statement.first_order,
                        .left = trust_by(statement, which - 1, which > 0, report),
                        .right = trust_by(statement, which + 1, which + 1 < statement.step_count, report),
                        .rules = statement.rules,
                        .near = sides_near(notes, *statement.chain)};
  options.cache->begin(options.effort);
  Offer offer;
  offer.repairs = nearest_true_statements(ledger.tree, *place.entry->scope, wrong, options.cache);
  offer.repair_milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  if (report.steps[place.step()].verdict == Verdict::refuted)
    offer.conditions = missing_conditions(ledger.tree, *place.entry->scope, wrong, options.cache);
  offer.work = options.cache->budget().used();
  return offer;
}

/// Several for each process, since some take much longer than others.
constexpr std::size_t pieces_a_process = 4;

}  // namespace

void suggest_repairs(const Ledger& ledger, const Notes& notes, const CheckOptions& options,
                     FileReport& report) {
  if (options.repairs == Repairs::none) return;
  const std::vector<WrongPlace> wrong = wrong_places(ledger, options, report);
  const std::size_t count =
      options.processes > 1 ? std::min(wrong.size(), options.processes * pieces_a_process) : 1;
  const auto first_of = [&](std::size_t piece) {
    return piece * wrong.size() / std::max<std::size_t>(count, 1);
  };
  const Pieces pieces{.count = count,
                      .work =
                          [&](std::size_t piece, const ReportProgress&) {
                            std::vector<Offer> offers;
                            for (std::size_t k = first_of(piece); k < first_of(piece + 1); ++k)
                              offers.push_back(offer_beside(wrong[k], ledger, notes, options, report));
                            ArchiveWriter writer;
                            writer(offers);
                            return writer.take();
                          },
                      .progress = {}};
  const std::vector<std::string> answers = in_processes_or_here(pieces, options.processes);
  for (std::size_t piece = 0; piece < count; ++piece) {
    std::vector<Offer> offers;
    ArchiveReader reader(answers[piece]);
    reader(offers);
    RIGOR_CHECK(reader.finished() && offers.size() == first_of(piece + 1) - first_of(piece), "lost offers",
                piece);
    for (std::size_t k = 0; k < offers.size(); ++k) {
      Step& step = report.steps[wrong[first_of(piece) + k].step()];
      step.repairs = std::move(offers[k].repairs);
      step.repair_milliseconds = offers[k].repair_milliseconds;
      step.conditions = std::move(offers[k].conditions);
      step.work = std::max(step.work, offers[k].work);
    }
  }
}

}  // namespace rigor
