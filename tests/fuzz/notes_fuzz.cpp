// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as notes, through the whole `latex` floor, for libFuzzer. The first byte picks the format.
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "base/check.h"
#include "latex/document/document.h"
#include "latex/macro/macros.h"
#include "latex/parse/parse.h"
#include "latex/split/split.h"
#include "latex/token/token.h"
#include "source/read_file.h"

namespace {

using namespace rigor;

/// A display is read as `check` reads it; longer ones are not read there either.
void read_display(const SourceMap& sources, const Display& display, MacroTable& macros,
                  Diagnostics& diagnostics) {
  constexpr std::uint32_t longest = 1U << 16U;
  if (display.body.end - display.body.begin > longest) return;
  const auto tokens = expand(lex(sources, display.body, display.quotes), macros, diagnostics);
  if (!tokens) return;
  SyntaxTree tree;
  for (const WrittenChain& chain : split_display(*tokens, display.environment, diagnostics)) {
    for (const WrittenSide& side : chain.sides) static_cast<void>(parse_side(side.tokens, side.span, tree));
  }
}

}  // namespace

// The name is libFuzzer's.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::string text(data + 1, data + size);
  SourceMap sources;
  Diagnostics diagnostics = mend_text(text, 0);
  // In a folder that does not exist, so that \input finds nothing.
  const FileId file =
      sources.add(data[0] % 2 == 0 ? "nowhere/notes.tex" : "nowhere/notes.md", std::move(text));
  const Document document = read_document(sources, file, diagnostics);
  MacroTable macros;
  for (const Item& item : document.items) {
    const Span span = std::visit([](const auto& each) { return each.span; }, item);
    RIGOR_CHECK(span.begin <= span.end && span.end <= sources.text(file).size(), span.begin, span.end);
    if (const auto* const display = std::get_if<Display>(&item)) {
      read_display(sources, *display, macros, diagnostics);
    } else if (std::holds_alternative<MacroText>(item)) {
      static_cast<void>(expand(lex(sources, span), macros, diagnostics));
    }
  }
  return 0;
}
