// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "report/wording/figures.h"

namespace rigor {
namespace {

using Field = std::string KernelRow::*;

/// What stands in a field of the rows of a table, each once, in order.
std::vector<std::string> distinct(std::span<const KernelRow> rows, const std::string& table, Field field) {
  std::vector<std::string> found;
  for (const KernelRow& row : rows) {
    if (row.table == table && std::find(found.begin(), found.end(), row.*field) == found.end())
      found.push_back(row.*field);
  }
  return found;
}

const KernelRow* find_row(std::span<const KernelRow> rows, const std::string& table, const std::string& name,
                          const std::string& family) {
  for (const KernelRow& row : rows)
    if (row.table == table && row.name == name && row.family == family) return &row;
  return nullptr;
}

/// What was measured under one name.
struct NameSummary {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  const KernelRow* worst = nullptr;
};

NameSummary summary_of(std::span<const KernelRow> rows, const std::string& table, const std::string& name) {
  NameSummary summary;
  for (const KernelRow& row : rows) {
    if (row.table != table || row.name != name) continue;
    summary.least = std::min(summary.least, row.nanoseconds);
    summary.most = std::max(summary.most, row.nanoseconds);
    if (summary.worst == nullptr || !(row.error <= summary.worst->error)) summary.worst = &row;
  }
  return summary;
}

}  // namespace

std::vector<std::string> tables_of(std::span<const KernelRow> rows) {
  std::vector<std::string> tables;
  for (const KernelRow& row : rows)
    if (std::find(tables.begin(), tables.end(), row.table) == tables.end()) tables.push_back(row.table);
  return tables;
}

std::string table_text(std::span<const KernelRow> rows, const std::string& table) {
  std::string text = fmt::format("{}\n", table);
  for (const std::string& family : distinct(rows, table, &KernelRow::family)) {
    text += fmt::format("  {}\n", family);
    for (const KernelRow& row : rows) {
      if (row.table == table && row.family == family)
        text += fmt::format("    {:<36}{:>12.2f} ns   error {:<8} {}\n", row.name, row.nanoseconds,
                            short_number(row.error), row.remark);
    }
  }
  return text;
}

std::string table_markdown(std::span<const KernelRow> rows, const std::string& table) {
  const std::vector<std::string> names = distinct(rows, table, &KernelRow::name);
  const std::vector<std::string> families = distinct(rows, table, &KernelRow::family);
  std::string text = "| | ns | worst error | on |\n|---|---|---|---|\n";
  for (const std::string& name : names) {
    const NameSummary summary = summary_of(rows, table, name);
    text +=
        fmt::format("| {} | {} to {} | {} | {} |\n", name, short_number(summary.least),
                    short_number(summary.most), short_number(summary.worst->error), summary.worst->family);
  }
  if (families.size() == 1) return text;
  text += "\n| error |";
  for (const std::string& name : names) text += fmt::format(" {} |", name);
  text += "\n|---|";
  for (std::size_t n = 0; n < names.size(); ++n) text += "---|";
  for (const std::string& family : families) {
    text += fmt::format("\n| {} |", family);
    for (const std::string& name : names) {
      const KernelRow* const row = find_row(rows, table, name, family);
      text += row == nullptr ? " |" : fmt::format(" {} |", short_number(row->error));
    }
  }
  return text + "\n";
}

Plot table_plot(std::span<const KernelRow> rows, const std::string& table) {
  Plot plot{table, {"ns", true}, {"relative error", true}, {}};
  for (const std::string& name : distinct(rows, table, &KernelRow::name)) {
    PlotSeries series{name, {}, mark_at(plot.series.size()), Stroke::none};
    for (const KernelRow& row : rows)
      if (row.table == table && row.name == name) series.points.push_back({row.nanoseconds, row.error});
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace rigor
