// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/scope/section_evidence.h"

#include <variant>
#include <vector>

#include "elaborate/evidence/evidence.h"

namespace rigor {
namespace {

/// The first events of the stretches that belong to a section: its own, and those around it.
std::vector<std::size_t> beginnings(const Notes& notes, std::optional<std::size_t> heading) {
  std::vector<std::size_t> begins;
  const bool preamble = notes.events.empty() || !std::holds_alternative<Heading>(notes.events[0]);
  if (preamble) begins.push_back(0);
  if (!heading) return begins;
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k <= *heading; ++k) {
    const auto* at = std::get_if<Heading>(&notes.events[k]);
    if (at == nullptr) continue;
    while (!open.empty() && std::get<Heading>(notes.events[open.back()]).level >= at->level) open.pop_back();
    open.push_back(k);
  }
  begins.insert(begins.end(), open.begin(), open.end());
  return begins;
}

void see_chains(const Notes& notes, const std::vector<ParsedChain>& chains, std::optional<Span> without,
                Evidence& evidence) {
  for (const ParsedChain& chain : chains) {
    if (chain.written.span == without) continue;
    for (const SyntaxId side : chain.sides) {
      see_kinds(notes.syntax, side, evidence);
      see_changing(notes.syntax, side, evidence);
      see_differentials(notes.syntax, side, evidence);
      see_subscripts(notes.syntax, side, evidence);
    }
    see_families(notes.syntax, chain.sides, evidence);
    see_summed_members(notes.syntax, chain.sides, evidence.members);
    see_components(notes.syntax, chain.sides, evidence);
    see_matrices(notes.syntax, chain.sides, chain.written, evidence);
    see_ties(notes.syntax, chain.sides, evidence);
    see_order(notes.syntax, chain.sides, chain.written, evidence);
    see_letters(notes.syntax, chain.sides, chain.written, evidence);
    see_functions(notes.syntax, chain.sides, evidence);
    see_raised(notes.syntax, chain.sides, evidence);
    see_space_time(notes.syntax, chain.sides, evidence.space_time);
    see_complex(notes.syntax, chain.sides, evidence);
    see_operators(notes.syntax, chain.sides, evidence);
    see_unsized_matrices(notes.syntax, chain.sides, evidence);
    see_averages(notes.syntax, chain.sides, evidence);
  }
}

/// The words between two places of one file.
void see_between(const SourceMap& sources, Span before, Span behind, Evidence& evidence) {
  if (before.file != behind.file || before.end >= behind.begin) return;
  const std::string_view text = sources.text({before.file, before.end, behind.begin});
  see_words(text, evidence);
  see_said_order(text, evidence);
  see_said(text, evidence);
  see_unit_matrices(text, evidence);
  see_spaces(text, evidence);
  see_said_space_time(text, evidence.space_time);
  see_said_changes(text, evidence);
  see_inline_functions(text, evidence);
  see_said_raised(text, evidence);
  see_said_complex(text, evidence);
  see_said_operators(text, evidence);
  see_said_unsized_matrices(text, evidence);
  see_said_averages(text, evidence);
  see_counting(text, true, evidence);
}

}  // namespace

Evidence evidence_of_section(const SourceMap& sources, const Notes& notes, std::optional<std::size_t> heading,
                             std::optional<Span> without) {
  Evidence evidence;
  for (const std::size_t begin : beginnings(notes, heading)) {
    Span last{notes.file, 0, 0};
    std::size_t k = begin;
    for (; k < notes.events.size(); ++k) {
      const auto* title = std::get_if<Heading>(&notes.events[k]);
      const Span place = span_of(notes.events[k]);
      if (k > begin || title == nullptr) see_between(sources, last, place, evidence);
      if (title != nullptr && k > begin) break;
      if (title != nullptr) {
        see_words(title->title, evidence);
        see_said_order(title->title, evidence);
        see_said(title->title, evidence);
        see_heading(title->title, evidence);
        see_spaces(title->title, evidence);
        see_said_space_time(title->title, evidence.space_time);
        see_said_changes(title->title, evidence);
        see_said_raised(title->title, evidence);
        see_said_complex(title->title, evidence);
        see_said_operators(title->title, evidence);
        see_said_unsized_matrices(title->title, evidence);
        see_said_averages(title->title, evidence);
      }
      last = place;
      if (std::holds_alternative<ParsedDisplay>(notes.events[k]) && place.file == notes.file) {
        see_counting(sources.text(place), false, evidence);
        see_said_space_time(sources.text(place), evidence.space_time);
      }
      if (const auto* display = std::get_if<ParsedDisplay>(&notes.events[k]))
        see_chains(notes, display->chains, without, evidence);
      if (const auto* placed = std::get_if<PlacedDirective>(&notes.events[k])) {
        for (const SyntaxId symbol : placed->directive.symbols) {
          see_kinds(notes.syntax, symbol, evidence);
          const DirectiveKind kind = placed->directive.kind;
          if (kind == DirectiveKind::complex || kind == DirectiveKind::scalar)
            see_declared_complex(notes.syntax.symbol(symbol), kind == DirectiveKind::complex, evidence);
        }
        see_chains(notes, placed->directive.chains, without, evidence);
      }
    }
    for (const SaidInLine& said : notes.prose.said) {
      if (said.before < begin || said.before > k) continue;
      for (const ParsedChain& chain : said.chains) {
        see_components(notes.syntax, chain.sides, evidence);
        see_matrices(notes.syntax, chain.sides, chain.written, evidence);
        see_ties(notes.syntax, chain.sides, evidence);
        see_complex(notes.syntax, chain.sides, evidence);
        see_operators(notes.syntax, chain.sides, evidence);
        see_unsized_matrices(notes.syntax, chain.sides, evidence);
        see_averages(notes.syntax, chain.sides, evidence);
        for (const SyntaxId side : chain.sides) {
          see_changing(notes.syntax, side, evidence);
          see_differentials(notes.syntax, side, evidence);
        }
      }
    }
    if (k == notes.events.size()) {
      const auto size = static_cast<std::uint32_t>(sources.text(notes.file).size());
      see_between(sources, last, {notes.file, size, size}, evidence);
    }
  }
  if (!evidence.space_time.tensors.empty() || !evidence.space_time.indices.empty()) {
    SpaceTime file;
    see_said_space_time(sources.text(notes.file), file);
    settle_space_time(file, evidence);
  }
  settle_order(evidence);
  settle_changes(evidence);
  settle_complex(evidence);
  settle_unsized_matrices(evidence);
  settle_operators(evidence);
  return evidence;
}

}  // namespace rigor
