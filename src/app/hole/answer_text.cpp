// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hole/answer_text.h"

#include "latex/layout/mathml.h"
#include "latex/layout/plain_text.h"
#include "latex/token/token.h"

namespace rigor {

std::string in_format(const std::string& latex, MathFormat format) {
  if (format == MathFormat::latex) return latex;
  SourceMap sources;
  const FileId file = sources.add("answer", latex);
  const std::vector<Token> tokens = lex(sources, {file, 0, static_cast<std::uint32_t>(latex.size())});
  return format == MathFormat::mathml ? to_mathml(tokens, MathStyle::display) : to_plain_text(tokens);
}

}  // namespace rigor
