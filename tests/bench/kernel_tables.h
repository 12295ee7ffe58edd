// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of kernels and their peers as tables and pictures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "kernel_rows.h"
#include "report/picture/plot.h"

namespace rigor {

/// Their names, in order.
[[nodiscard]] std::vector<std::string> tables_of(std::span<const KernelRow> rows);

/// A line for each family, with time and error of everything that was measured on it; lines of equal names in
/// the order of the rows.
[[nodiscard]] std::string table_text(std::span<const KernelRow> rows, const std::string& table);

/// The same in Markdown: a line for each name, with its least and greatest time, its worst error and the
/// family that has it; then a table of errors by family.
[[nodiscard]] std::string table_markdown(std::span<const KernelRow> rows, const std::string& table);

/// Time against error: a mark for each family and name.
[[nodiscard]] Plot table_plot(std::span<const KernelRow> rows, const std::string& table);

}  // namespace rigor
