// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/markdown/math_macros.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/ascii.h"

namespace rigor {
namespace {

/// What a configuration is written in.
enum class ConfigLanguage : std::uint8_t { yaml, script };

/// Reads values of a configuration from left to right.
class ConfigReader {
 public:
  ConfigReader(std::string_view text, ConfigLanguage language) : text_(text), language_(language) {}

  [[nodiscard]] bool done() const { return at_ >= text_.size(); }
  [[nodiscard]] char next() const { return done() ? '\0' : text_[at_]; }
  bool take(char sign) {
    skip();
    if (next() != sign) return false;
    ++at_;
    return true;
  }

  /// Over white space, and over comments of scripts.
  void skip() {
    while (!done()) {
      const std::string_view rest = text_.substr(at_);
      if (is_white(rest[0])) {
        ++at_;
      } else if (language_ == ConfigLanguage::script && rest.starts_with("//")) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (language_ == ConfigLanguage::script && rest.starts_with("/*")) {
        const std::size_t end = text_.find("*/", at_);
        at_ = end == std::string_view::npos ? text_.size() : end + 2;
      } else {
        return;
      }
    }
  }

  /// A string in quotes.
  std::optional<std::string> quoted() {
    skip();
    constexpr std::string_view raw = "String.raw`";
    if (text_.substr(at_).starts_with(raw)) return raw_until(at_ + raw.size(), '`');
    const char quote = next();
    if (quote != '\'' && quote != '"') return std::nullopt;
    std::string value;
    for (std::size_t at = at_ + 1; at < text_.size(); ++at) {
      const char c = text_[at];
      const char behind = at + 1 < text_.size() ? text_[at + 1] : '\0';
      const bool escapes = language_ == ConfigLanguage::script || quote == '"';
      if (c == quote && !escapes && behind == quote) {
        value += text_[++at];
      } else if (c == quote) {
        at_ = at + 1;
        return value;
      } else if (c == '\\' && escapes) {
        if (behind != '\\' && behind != quote) return std::nullopt;  // no backslash of TeX is written so
        value += text_[++at];
      } else {
        value += c;
      }
    }
    return std::nullopt;
  }

  /// A name without quotes, up to the colon.
  std::optional<std::string> bare_name() {
    skip();
    std::size_t end = at_ + (next() == '\\' ? 1 : 0);
    while (end < text_.size() && is_letter(text_[end])) ++end;
    if (end == at_) return std::nullopt;
    std::string name(text_.substr(at_, end - at_));
    at_ = end;
    return name;
  }

  std::optional<int> number() {
    skip();
    if (!is_digit(next()) || (at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) return std::nullopt;
    return text_[at_++] - '0';
  }

  /// The rest of the line, up to a comment of YAML.
  std::string plain() {
    const std::size_t comment = text_.find(" #", at_);
    std::string_view value = text_.substr(at_, std::min(comment, text_.size()) - at_);
    at_ = text_.size();
    while (!value.empty() && is_white(value.front())) value.remove_prefix(1);
    while (!value.empty() && is_white(value.back())) value.remove_suffix(1);
    return std::string(value);
  }

  /// Behind the word `macros` and its `: {`; false where there is none any more.
  bool enter_macros() {
    while (true) {
      std::size_t word = text_.find("acros", at_);
      if (word == std::string_view::npos) return false;
      at_ = word + 5;
      if (word == 0 || (text_[word - 1] != 'm' && text_[word - 1] != 'M')) continue;
      if (next() == '\'' || next() == '"') ++at_;
      if (take(':') && take('{')) return true;
    }
  }

 private:
  std::optional<std::string> raw_until(std::size_t begin, char closing) {
    const std::size_t end = text_.find(closing, begin);
    if (end == std::string_view::npos) return std::nullopt;
    at_ = end + 1;
    return std::string(text_.substr(begin, end - begin));
  }

  std::string_view text_;
  ConfigLanguage language_;
  std::size_t at_ = 0;
};

int highest_in(std::string_view body) {
  int highest = 0;
  for (std::size_t at = 0; at + 1 < body.size(); ++at) {
    if (body[at] == '#' && is_digit(body[at + 1])) highest = std::max(highest, body[at + 1] - '0');
  }
  return highest;
}

/// A body without comments whose braces are closed.
bool is_whole(std::string_view body) {
  int depth = 0;
  for (std::size_t at = 0; at < body.size(); ++at) {
    if (body[at] == '%') return false;
    if (body[at] == '{') ++depth;
    if (body[at] == '}' && --depth < 0) return false;
    if (body[at] == '\\') ++at;
  }
  return depth == 0;
}

bool is_sound(const MathMacro& macro) {
  return !macro.name.empty() && std::ranges::all_of(macro.name, [](char c) { return is_letter(c); }) &&
         is_whole(macro.body) && (!macro.first || is_whole(*macro.first)) &&
         macro.parameters >= highest_in(macro.body);
}

/// `"…"` or `["…", 1]` or `["…", 2, "…"]`.
std::optional<MathMacro> macro_in_quotes(ConfigReader& reader, std::string name) {
  if (name.starts_with('\\')) name.erase(0, 1);
  MathMacro macro{.name = std::move(name), .body = {}};
  const bool list = reader.take('[');
  auto body = reader.quoted();
  if (!body) return std::nullopt;
  macro.body = std::move(*body);
  macro.parameters = highest_in(macro.body);
  if (list && reader.take(',')) {
    const auto count = reader.number();
    if (!count) return std::nullopt;
    macro.parameters = *count;
    if (reader.take(',')) {
      macro.first = reader.quoted();
      if (!macro.first) return std::nullopt;
    }
  }
  if (list && !reader.take(']')) return std::nullopt;
  return macro;
}

std::size_t indentation_of(std::string_view line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

/// One line of `math:`; `named` is the name in a line above that has its macro below it.
std::optional<MathMacro> macro_of_line(std::string_view line, std::string& named) {
  ConfigReader reader(line, ConfigLanguage::yaml);
  const bool in_quotes = line.find_first_of("'\"") == indentation_of(line);
  auto key = in_quotes ? reader.quoted() : reader.bare_name();
  if (!key || !reader.take(':')) return std::nullopt;
  const bool below = key == "macro" && !named.empty();
  if (!below && !key->starts_with('\\')) return std::nullopt;
  std::string name = below ? std::exchange(named, {}) : *key;
  reader.skip();
  if (reader.done()) {
    named = std::move(name);
    return std::nullopt;
  }
  const char first = reader.next();
  if (first == '\'' || first == '"' || first == '[') return macro_in_quotes(reader, std::move(name));
  if (first == '{' || first == '|' || first == '>') return std::nullopt;
  MathMacro macro{.name = name.substr(1), .body = reader.plain()};
  macro.parameters = highest_in(macro.body);
  return macro;
}

}  // namespace

std::vector<MathMacro> macros_of_front_matter(std::string_view yaml) {
  std::vector<MathMacro> macros;
  bool inside = false;
  std::string named;
  for (std::size_t at = 0; at < yaml.size();) {
    const std::size_t end = std::min(yaml.find('\n', at), yaml.size());
    std::string_view line = yaml.substr(at, end - at);
    at = end + 1;
    while (!line.empty() && is_white(line.back())) line.remove_suffix(1);
    if (line.empty() || line[indentation_of(line)] == '#') continue;
    if (indentation_of(line) == 0) {
      inside = line == "math:";
      continue;
    }
    if (!inside) continue;
    auto macro = macro_of_line(line, named);
    if (macro && is_sound(*macro)) macros.push_back(std::move(*macro));
  }
  return macros;
}

std::vector<MathMacro> macros_of_script(std::string_view script) {
  std::vector<MathMacro> macros;
  ConfigReader reader(script, ConfigLanguage::script);
  while (reader.enter_macros()) {
    while (!reader.take('}')) {
      auto name = reader.quoted();
      if (!name) name = reader.bare_name();
      if (!name || !reader.take(':')) break;
      auto macro = macro_in_quotes(reader, std::move(*name));
      if (!macro) break;
      if (is_sound(*macro)) macros.push_back(std::move(*macro));
      static_cast<void>(reader.take(','));
    }
  }
  return macros;
}

std::string definition_of(const MathMacro& macro) {
  std::string text = fmt::format("\\renewcommand{{\\{}}}", macro.name);
  if (macro.parameters > 0) text += fmt::format("[{}]", macro.parameters);
  if (macro.first) text += fmt::format("[{}]", *macro.first);
  return text + "{" + macro.body + "}";
}

}  // namespace rigor
