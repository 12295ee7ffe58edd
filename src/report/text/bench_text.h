// SPDX-License-Identifier: GPL-3.0-or-later
// Time against error for all forms of a chain in all arithmetics: a picture, a table in Markdown, and advice.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/text/eval_text.h"

namespace rigor {

/// The trials on which the forms differ most in double, in their own order; at most `most`.
[[nodiscard]] std::vector<std::size_t> telling_trials(const ChainResult& result, std::size_t most);

/// One panel for each of these trials; the line joins the points that no other beats.
[[nodiscard]] std::string bench_picture(const EvaluatedChain& evaluated,
                                        const std::vector<std::size_t>& trials);

/// A heading, the forms, the picture if there is one, a row for each form and arithmetic, and the advice.
[[nodiscard]] std::string bench_markdown(const EvaluatedChain& evaluated,
                                         const std::vector<std::size_t>& trials, const SourceMap& sources,
                                         const std::optional<std::string>& picture);

/// A table of chains whose forms err alike: its head, and the row of one.
[[nodiscard]] std::string bench_rows_head();
[[nodiscard]] std::string bench_row(const EvaluatedChain& evaluated, const SourceMap& sources);

/// `rigid-bodies-6`, `rigid-bodies-line-120`: a name for the picture's file.
[[nodiscard]] std::string file_name_of(const WrittenFormChain& chain, const SourceMap& sources);

}  // namespace rigor
