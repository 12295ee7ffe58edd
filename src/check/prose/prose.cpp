// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/prose/prose.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "base/among.h"
#include "base/ascii.h"
#include "check/word/contrary_words.h"
#include "check/word/prose_behind.h"
#include "check/word/prose_words.h"
#include "check/word/words_behind.h"

namespace rigor {
namespace {

constexpr std::size_t longest_inline = 400;  // bytes of mathematics in a line

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// Comments become blanks, so that places stay.
std::string without_comments(std::string_view text, Format format) {
  std::string result(text);
  if (format == Format::markdown) {
    for (std::size_t at = result.find("<!--"); at != std::string::npos; at = result.find("<!--", at)) {
      const std::size_t end = std::min(result.find("-->", at), result.size());
      const std::size_t behind = std::min(end + 3, result.size());
      // A line of its own vanishes with its line break, so that it parts no paragraphs.
      for (std::size_t k = at; k < behind; ++k) result[k] = ' ';
      if (behind < result.size() && result[behind] == '\n') result[behind] = ' ';
    }
    return result;
  }
  for (std::size_t at = result.find('%'); at != std::string::npos; at = result.find('%', at)) {
    if (at > 0 && result[at - 1] == '\\') {
      ++at;
      continue;
    }
    const std::size_t end = std::min(result.find('\n', at), result.size());
    for (std::size_t k = at; k < end; ++k) result[k] = ' ';
    if (end < result.size()) result[end] = ' ';
    at = end;
  }
  return result;
}

bool relates(std::string_view mathematics) {
  static constexpr std::array<std::string_view, 14> signs{"=",    "<",        ">",          "\\le",  "\\ge",
                                                          "\\ne", "\\neq",    "\\leq",      "\\geq", "\\ll",
                                                          "\\gg", "\\approx", "\\parallel", "\\perp"};
  return std::ranges::any_of(signs, [&](std::string_view sign) {
    const auto at = mathematics.find(sign);
    if (at == std::string_view::npos) return false;
    const std::size_t behind = at + sign.size();
    return sign[0] != '\\' || behind >= mathematics.size() || !is_letter(mathematics[behind]) ||
           sign == "\\le" || sign == "\\ge";
  });
}

/// Does the display's own text end its sentence?
bool ends_sentence(std::string_view display) {
  for (bool cut = true; cut;) {
    cut = false;
    while (!display.empty() && (is_space(display.back()) || display.back() == '`')) display.remove_suffix(1);
    for (const std::string_view closing : {"$$", "\\]"}) {
      if (!display.ends_with(closing)) continue;
      display.remove_suffix(closing.size());
      cut = true;
    }
    if (display.empty() || display.back() != '}') continue;
    for (const std::string_view control : {"\\end{", "\\tag{", "\\tag*{", "\\label{"}) {
      const auto at = display.rfind(control);
      if (at == std::string_view::npos || display.find('}', at) != display.size() - 1) continue;
      display = display.substr(0, at);
      cut = true;
    }
  }
  return !display.empty() && display.back() == '.';
}

/// "(b) The block", "(ii) For": a part of a problem; not "(3) gives".
bool begins_a_part(std::string_view text, std::size_t at) {
  constexpr std::size_t longest = 4;
  if (text[at] != '(') return false;
  const std::size_t close = text.find(')', at);
  if (close == std::string_view::npos || close == at + 1 || close - at > longest + 1) return false;
  if (!std::ranges::all_of(text.substr(at + 1, close - at - 1),
                           [](char c) { return is_letter(c) || is_digit(c); }))
    return false;
  return close + 2 < text.size() && text[close + 1] == ' ' && is_capital_letter(text[close + 2]);
}

bool is_abbreviation(std::string_view word) {
  static constexpr std::array<std::string_view, 14> known{"e",   "g",  "i",   "eq",   "eqs", "fig", "cf",
                                                          "sec", "vs", "ref", "resp", "dr",  "eqn", "ca"};
  return is_one_of(word, known);
}

Cue cue_of(std::string_view word) {
  static constexpr auto apart = std::to_array<std::string_view>(
      {"unless",   "near",       "except",  "excluding", "without", "not",        "no",
       "never",    "nor",        "neither", "away",      "around",  "close",      "about",
       "beyond",   "approaches", "tends",   "than",      "nearly",  "almost",     "approximately",
       "roughly",  "far",        "limit",   "cannot",    "before",  "until",      "avoid",
       "avoiding", "besides",    "had",     "should",    "forget",  "forgetting", "mistake"});
  if (is_one_of(word, apart)) return Cue::apart;
  static constexpr std::array<std::string_view, 20> definitions{
      "with",    "where", "define",     "defining", "defined",     "let",     "put",
      "putting", "set",   "write",      "writing",  "setting",     "denote",  "introduce",
      "by",      "here",  "abbreviate", "call",     "introducing", "denoting"};
  static constexpr std::array<std::string_view, 15> conditions{
      "if",       "when",    "whenever", "for",   "at",      "case", "provided", "assume",
      "assuming", "suppose", "given",    "since", "because", "on",   "while"};
  if (is_one_of(word, definitions)) return Cue::definition;
  return is_one_of(word, conditions) ? Cue::condition : Cue::none;
}

/// "Putting $a = b$ gives rest, but in general we find": what stands before it is not said of what follows.
bool turns_away(std::string_view word) {
  static constexpr auto words = std::to_array<std::string_view>(
      {"but", "yet", "however", "whereas", "generally", "otherwise", "correctly", "truth"});
  return is_one_of(word, words);
}

/// "On the wall, where $u = a + b$": what is said there need not hold outside of it.
bool names_a_place(std::string_view word) {
  static constexpr std::array<std::string_view, 14> words{
      "at",     "on",   "inside", "outside",   "along",    "within", "near",
      "during", "when", "across", "initially", "whenever", "while",  "until"};
  return is_one_of(word, words);
}

/// `.` of "where $a = b$.", "**Note.**", "(see below.)", "he asked: why?\""
bool stands_last(std::string_view text, std::size_t at) {
  const std::string_view behind = text.substr(at + 1);
  if (behind.empty() || is_space(behind[0])) return true;
  return std::ranges::any_of(std::to_array<std::string_view>({"*", ")", "\"", "''", "\u201d"}),
                             [&](std::string_view closing) { return behind.starts_with(closing); });
}

/// Displays one after the other, without a word between them: how many of them a sentence shows.
constexpr std::size_t most_marks = 64;

bool ends_in_marks(std::string_view sentence) {
  std::size_t marks = 0;
  for (; !sentence.empty() && (sentence.back() == '\n' || sentence.back() == ' '); sentence.remove_suffix(1))
    marks += sentence.back() == '\n' ? 1 : 0;
  return marks >= most_marks;
}

/// Up to its first mathematics or stop.
std::string_view clause_at(std::string_view text, std::size_t at) {
  return text.substr(at, text.find_first_of(".;:$\\", at) - at);
}

class ProseReader {
 public:
  explicit ProseReader(const SourceMap& sources) : sources_(sources), walk_(prose_.sections) {}

  Prose read(const std::vector<ProseEvent>& events) {
    prose_.beside.resize(events.size());
    for (event_ = 0; event_ < events.size(); ++event_) {
      const ProseEvent& event = events[event_];
      if (event.kind != ProseEvent::Kind::passed_over) {
        const auto [read, is_new] = read_to_.try_emplace(event.span.file);
        std::uint32_t& at = read->second;
        if (is_new) at = behind_preamble(event.span.file);
        if (at < event.span.begin) take({event.span.file, at, event.span.begin});
        at = std::max(at, event.span.end);
      }
      if (event.kind == ProseEvent::Kind::heading) {
        end_sentence();
        walk_.heading(event.level);
        place_ = walk_.here();
        take_heading(event.span);
      }
      ProseBeside& beside = prose_.beside[event_];
      beside.lead = sentence_;
      beside.references = references_;
      beside.sentence = number_;
      beside.place = place_;
      beside.paragraph = paragraph_;
      beside.argument = argument_;
      if (event.kind == ProseEvent::Kind::display) ++displays_;
      beside.displays = displays_;
      if (event.kind != ProseEvent::Kind::display) continue;
      end_tail();
      last_display_ = event_;
      if (!ends_in_marks(sentence_)) sentence_ += "\n";
      tail_begin_ = sentence_.size();
      if (ends_sentence(sources_.text(event.span))) end_sentence();
    }
    if (!events.empty()) take_rest(events);
    end_sentence();
    return std::move(prose_);
  }

 private:
  /// The preamble of a document in LaTeX is no prose.
  std::uint32_t behind_preamble(FileId file) const {
    constexpr std::string_view begins = "\\begin{document}";
    const auto at = sources_.text(file).find(begins);
    return at == std::string_view::npos ? 0 : static_cast<std::uint32_t>(at + begins.size());
  }

  void take_rest(const std::vector<ProseEvent>& events) {
    const FileId file = events.back().span.file;
    const auto size = static_cast<std::uint32_t>(sources_.text(file).size());
    const auto at = read_to_.find(file);
    if (at != read_to_.end() && at->second < size) take({file, at->second, size});
  }

  void end_tail() {
    if (last_display_ && tail_begin_ <= sentence_.size()) {
      prose_.beside[*last_display_].tail = sentence_.substr(tail_begin_);
      prose_.beside[*last_display_].references = references_;
    }
    last_display_.reset();
  }

  void end_sentence(char ending = '.') {
    end_tail();
    const bool has_display = sentence_.find('\n') != std::string::npos;
    if (sentence_.find_first_not_of(" \n") != std::string::npos)
      prose_.sentences.push_back({sentence_, number_, place_, paragraph_, argument_, displays_before_,
                                  has_display, ending == '?', std::move(maths_)});
    const std::vector<SaidOf> said_of_each = said_of(sentence_, texts_);
    for (std::size_t k = prose_.said.size(); k-- > 0 && prose_.said[k].sentence == number_;) {
      SaidInLine& said = prose_.said[k];
      said.alone = !has_display;
      const SaidOf of = said_of_each[said.maths];
      said.named = said.named || of == SaidOf::a_name;
      if (of == SaidOf::something && said.cue != Cue::apart) said.cue = Cue::none;
    }
    maths_.clear();
    texts_.clear();
    at_place_ = false;
    displays_before_ = displays_;
    sentence_.clear();
    references_.clear();
    cue_ = Cue::none;
    ++number_;
  }

  /// The mathematics of a heading says which case its section is about.
  void take_heading(Span span) {
    const std::string text(sources_.text(span));
    for (std::size_t at = 0; at < text.size();) {
      const bool opens = text[at] == '$' || text.compare(at, 2, "\\(") == 0;
      at = opens ? read_inline(text, at, span) : at + 1;
    }
    for (SaidInLine& said : prose_.said) {
      if (said.sentence == number_) said.cue = Cue::condition;
    }
    sentence_.clear();
    end_sentence();
  }

  void take(Span span) {
    const Format format = format_of(sources_, span.file);
    const std::string text = without_comments(sources_.text(span), format);
    std::size_t walked = 0;  // whole lines, so that what is said has the section of its own line
    for (std::size_t at = 0; at < text.size(); at = read_at(text, at, span)) {
      if (at >= walked)
        walked = walk_to(std::min(text.find('\n', at), text.size() - 1) + 1, walked, text, format);
    }
    walk_to(text.size(), walked, text, format);
  }

  std::size_t walk_to(std::size_t end, std::size_t begin, std::string_view text, Format format) {
    walk_.text(text.substr(begin, end - begin), format);
    if (walk_.here() != place_) {
      end_sentence();
      place_ = walk_.here();
    }
    return end;
  }

  /// One word, sign or stretch of mathematics; the place after it.
  std::size_t read_at(const std::string& text, std::size_t at, Span span) {
    const char c = text[at];
    if (is_space(c)) return read_blanks(text, at);
    if (c == '$' || text.compare(at, 2, "\\(") == 0) return read_inline(text, at, span);
    if (is_letter(c)) return read_word(text, at);
    if (c == '\\') return read_control(text, at);
    if (c == '(' || c == '{') note_reference(text, at);
    const bool ends = (c == '.' || c == '!' || c == '?') && stands_last(text, at) &&
                      !(c == '.' && is_abbreviation(last_word()));
    if (ends) {
      end_sentence(c);
    } else if (is_digit(c)) {
      sentence_ += c;
    } else if (c == ',' || c == ';' || c == ':' || c == '(' || c == ')') {
      sentence_ += c;
      if (cue_ == Cue::apart) cue_ = Cue::none;
    }
    return at + 1;
  }

  /// `(1.3)`, `{eq:newton}` behind `\eqref`, and {eq}`newton` of MyST.
  void note_reference(const std::string& text, std::size_t at) {
    constexpr std::string_view role = "{eq}`";
    const bool named = text.compare(at, role.size(), role) == 0;
    const char close = named ? '`' : text[at] == '(' ? ')' : '}';
    const std::size_t begin = at + (named ? role.size() : 1);
    const std::size_t end = text.find(close, begin);
    constexpr std::size_t longest = 60;
    if (end == std::string::npos || end == begin || end - begin > longest) return;
    const std::string label = text.substr(begin, end - begin);
    if (label.find_first_of(" \n$\\") == std::string::npos) references_.push_back(label);
  }

  std::size_t read_blanks(const std::string& text, std::size_t at) {
    std::size_t lines = 0;
    for (; at < text.size() && is_space(text[at]); ++at) lines += text[at] == '\n' ? 1 : 0;
    const bool capital = at < text.size() && (is_capital_letter(text[at]) || begins_a_part(text, at));
    const auto last = sentence_.find_last_not_of(' ');
    const bool behind_display = last != std::string::npos && sentence_[last] == '\n';
    // A capital after a blank line or a display begins a sentence, also where no full stop stands.
    if ((lines > 1 || (lines == 1 && behind_display)) && capital) end_sentence();
    // In Markdown blank lines stand around displays; the sentence that has one in it is of one paragraph.
    const bool meets_display = at == text.size() ? !behind_display : behind_display && !capital;
    const std::string clause = capital ? lowered(clause_at(text, at)) : std::string();
    const bool ends = lines > 1 && (sentence_.empty() || !meets_display);
    const bool goes_on = ends && goes_on_with_the_argument(clause);
    if (ends && !goes_on) ++paragraph_;
    if ((ends && !goes_on) || (sentence_.empty() && begins_a_case(clause))) ++argument_;
    if (!sentence_.empty() && sentence_.back() != ' ') sentence_ += ' ';
    return at;
  }

  std::size_t read_word(const std::string& text, std::size_t at) {
    std::size_t end = at;
    while (end < text.size() && (is_letter(text[end]) || text[end] == '-' || text[end] == '\'')) ++end;
    const std::string word = lowered(text.substr(at, end - at));
    // "except for $x = 0$", "not at $x = 0$"
    if (const Cue cue = cue_of(word); cue != Cue::none && cue_ != Cue::apart) cue_ = cue;
    at_place_ = at_place_ || names_a_place(word);
    // "the general solution" turns nothing away, "in general" does.
    if (turns_away(word) || (word == "general" && sentence_.ends_with("in "))) turn_away();
    sentence_ += word;
    return end;
  }

  void turn_away() {
    for (std::size_t k = prose_.said.size(); k-- > 0 && prose_.said[k].sentence == number_;)
      prose_.said[k].cue = Cue::apart;
  }

  std::string last_word() const {
    std::size_t begin = sentence_.size();
    while (begin > 0 && is_letter(sentence_[begin - 1])) --begin;
    return sentence_.substr(begin);
  }

  /// Directly before the `$` that was read last.
  std::string word_before_mathematics() const {
    std::size_t end = sentence_.size() - 1;
    while (end > 0 && sentence_[end - 1] == ' ') --end;
    std::size_t begin = end;
    while (begin > 0 && is_letter(sentence_[begin - 1])) --begin;
    return sentence_.substr(begin, end - begin);
  }

  /// "its momentum is $p = …$", "with the radius $r = …$"
  bool names_in_passing() const {
    const std::string word = word_before_mathematics();
    if (is_measure(word)) return true;
    if (word != "is") return false;
    const std::size_t begin = sentence_.find_last_of(".;:,$\n", sentence_.size() - 2) + 1;
    const std::vector<std::string_view> clause = words_of(std::string_view(sentence_).substr(begin));
    return std::ranges::any_of(
        clause, [](std::string_view each) { return is_named_quantity(each) || is_measure(each); });
  }

  bool stands_behind_a_comma() const {
    const std::size_t before = sentence_.find_last_not_of(' ', sentence_.size() - 2);
    return sentence_.size() > 1 && before != std::string::npos && sentence_[before] == ',';
  }

  static bool is_full_stop(const std::string& text, std::size_t at) {
    return at < text.size() && text[at] == '.' && stands_last(text, at);
  }

  /// "and $L = T - V$", directly behind a display: what that says goes on here.
  bool goes_on_from_display() const {
    if (word_before_mathematics() != "and") return false;
    const std::size_t at = sentence_.rfind("and");
    const std::size_t before = sentence_.find_last_not_of(' ', at - 1);
    return at > 0 && before != std::string::npos && sentence_[before] == '\n';
  }

  /// Commands of the text are no words; `\item`, `\begin` and `\par` end a sentence.
  std::size_t read_control(const std::string& text, std::size_t at) {
    std::size_t end = at + 1;
    while (end < text.size() && is_letter(text[end])) ++end;
    const std::string name = text.substr(at + 1, end - at - 1);
    const bool parts = name == "item" || name == "par" || name == "paragraph" || name == "subparagraph";
    if (parts) {
      end_sentence();
      ++argument_;
    }
    const bool names_something = name == "begin" || name == "end" || name == "label" || name == "ref" ||
                                 name == "eqref" || name == "cite";
    if (names_something && end < text.size() && text[end] == '{') {
      if (name == "begin" || name == "end") end_sentence();
      if (name == "ref" || name == "eqref") note_reference(text, end);
      return std::min(text.find('}', end), text.size() - 1) + 1;
    }
    return std::max(end, at + 2);
  }

  std::size_t read_inline(const std::string& text, std::size_t at, Span span) {
    const bool dollar = text[at] == '$';
    const std::size_t begin = at + (dollar ? 1 : 2);
    const std::size_t end = text.find(dollar ? "$" : "\\)", begin);
    if (end == std::string::npos || end - begin > longest_inline || end == begin ||
        text.find("\n\n", begin) < end)
      return begin;
    sentence_ += '$';
    const std::string_view inside = std::string_view(text).substr(begin, end - begin);
    const auto offset = [&](std::size_t k) { return span.begin + static_cast<std::uint32_t>(k); };
    maths_.push_back({span.file, offset(begin), offset(end)});
    texts_.push_back({std::string(inside), relates(inside)});
    if (texts_.back().relates) {
      prose_.said.push_back({{span.file, offset(begin), offset(end)}, cue_, number_, event_, place_});
      prose_.said.back().argument = argument_;
      prose_.said.back().at_place = at_place_;
      prose_.said.back().maths = texts_.size() - 1;
      if (cue_ == Cue::none && is_named_quantity(word_before_mathematics())) {
        prose_.said.back().cue = Cue::definition;  // "the reduced mass $\mu = …$"
        prose_.said.back().named = true;
      }
      if (cue_ == Cue::none && goes_on_from_display()) prose_.said.back().cue = Cue::definition;
      // "rolls without slipping, $v = \omega R$."
      const bool apposed = stands_behind_a_comma() && is_full_stop(text, end + (dollar ? 1 : 2));
      if (prose_.said.back().cue == Cue::none && (apposed || names_in_passing())) {
        prose_.said.back().cue = Cue::definition;
        prose_.said.back().named = true;
        prose_.said.back().in_passing = true;
      }
    }
    return end + (dollar ? 1 : 2);
  }

  const SourceMap& sources_;
  Prose prose_;
  SectionWalk walk_;
  std::map<FileId, std::uint32_t> read_to_;
  std::size_t place_ = 0;  // the section that is read
  std::size_t event_ = 0;
  std::string sentence_;
  std::vector<std::string> references_;  // of the sentence
  std::size_t number_ = 0;
  Cue cue_ = Cue::none;
  std::optional<std::size_t> last_display_;
  std::size_t tail_begin_ = 0;
  std::vector<Span> maths_;  // of the sentence
  std::vector<MathsInLine> texts_;
  bool at_place_ = false;
  std::size_t paragraph_ = 0;
  std::size_t argument_ = 0;
  std::size_t displays_ = 0;
  std::size_t displays_before_ = 0;  // the sentence
};

}  // namespace

std::set<std::string> letters_written_in(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides) {
  std::set<std::string> letters;
  for (const SyntaxId id : nodes_below(syntax, sides)) {
    if (syntax[id].kind == SyntaxKind::symbol) letters.insert(syntax.symbol(id).letter);
  }
  return letters;
}

Prose read_prose(const SourceMap& sources, const std::vector<ProseEvent>& events) {
  Prose prose = ProseReader(sources).read(events);
  std::map<std::string, std::size_t> numbers;
  for (const ProseSentence& each : prose.sentences) {
    for (const std::string& word : case_words_of(each.text)) {
      const auto [number, is_new] = numbers.try_emplace(word, numbers.size());
      if (is_new) prose.case_words.different.push_back(word);
      prose.case_words.said.push_back({number->second, each.number, each.place});
    }
  }
  return prose;
}

}  // namespace rigor
