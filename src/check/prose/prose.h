// SPDX-License-Identifier: GPL-3.0-or-later
// What the prose around each display says: the sentence that leads into it, what follows it in the same
// sentence, and the relations in a line (`with $\beta = v/c$`) with the word that brings them in.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "check/directive/directive.h"
#include "check/prose/sections.h"

namespace rigor {

/// How a relation in a line is meant, by the last such word before it in its sentence.
enum class Cue : std::uint8_t {
  none,        // mentioned, or restricted by words around it
  definition,  // with, where, let …
  condition,   // if, for, at …
  apart,       // unless, near, except, not …: it is not said to hold
};

/// A relation in a line of prose.
struct SaidInLine {
  Span span;
  Cue cue = Cue::none;
  std::size_t sentence = 0;
  std::size_t before = 0;  // the event that stands next after it
  std::size_t place = 0;
  std::size_t argument = 0;              // as in `ProseBeside`
  bool at_place = false;                 // after "at the wall", "on the axis": it holds there only
  bool named = false;                    // "is the frequency": it holds only if it brings in its letter
  bool in_passing = false;               // "its momentum is $p = mv$": of what the argument speaks of
  std::size_t maths = 0;                 // its number among the mathematics of its sentence
  bool alone = false;                    // no display is in its sentence, or it is in a heading
  std::vector<ParsedChain> chains = {};  // filled by who parses it
  std::vector<std::set<std::string>> letters = {};  // of each chain, as `letters_written_in` gives them
  std::string words = {};  // that say it, where it is no relation: "acute angle `\varphi`"
};

/// "of mass $m$", "the Hermitian operator $\hat A$", in a line.
struct LetterInLine {
  ParsedChain chain;  // that says so: `m > 0`, `\hat A^\dagger = \hat A`
  std::string letter;
  std::size_t place = 0;
  std::string noun = {};  // "mass"; empty where the words say "positive"
};

/// A whole sentence of the prose.
struct ProseSentence {
  std::string text;  // as in `ProseBeside`
  std::size_t number = 0;
  std::size_t place = 0;
  std::size_t paragraph = 0;
  std::size_t argument = 0;  // as in `ProseBeside`
  std::size_t displays = 0;  // that are before it
  bool has_display = false;
  bool asks = false;             // it ends with a question mark
  std::vector<Span> maths = {};  // in its lines
};

/// A word of a sentence that may name a case (`case_words_of()`).
struct CaseWord {
  std::size_t word = 0;  // its number among those that differ
  std::size_t sentence = 0;
  std::size_t place = 0;
};

/// Few differ, however many are said.
struct CaseWords {
  std::vector<std::string> different;
  std::vector<CaseWord> said;  // in the order of the sentences
};

/// Of one event. Mathematics in a line stands as `$` in the text, a display as `\n`.
struct ProseBeside {
  std::string lead;                          // the words of its sentence before a display
  std::string tail;                          // and after it, up to the next display
  std::vector<std::string> references = {};  // `1.3` of "with (1.3)", `eq:newton` of `\eqref{eq:newton}`
  std::size_t sentence = 0;
  std::size_t place = 0;
  std::size_t paragraph = 0;
  std::size_t argument = 0;  // its paragraph, or the part of it up to where another case begins
  std::size_t displays = 0;  // up to this one, if it is one
};

struct Prose {
  Sections sections;
  std::vector<ProseBeside> beside;  // one for each event
  std::vector<SaidInLine> said;
  std::vector<LetterInLine> sizes = {};         // filled by who parses them
  std::vector<LetterInLine> self_adjoint = {};  // the same
  std::vector<ProseSentence> sentences;
  CaseWords case_words = {};
};

/// Where an event stands, and what it is to the prose.
struct ProseEvent {
  enum class Kind : std::uint8_t { heading, display, passed_over } kind = Kind::passed_over;
  Span span;
  int level = 0;  // of a heading
};

/// The letters that are in these expressions themselves, not in subscripts.
[[nodiscard]] std::set<std::string> letters_written_in(const SyntaxTree& syntax,
                                                       const std::vector<SyntaxId>& sides);

/// `events` in the order of the text. Cost: linear in the text.
[[nodiscard]] Prose read_prose(const SourceMap& sources, const std::vector<ProseEvent>& events);

}  // namespace rigor
