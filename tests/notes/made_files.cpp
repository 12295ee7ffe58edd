// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_files.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <random>

#include "program.h"

namespace rigor {
namespace {

constexpr std::size_t many = 50'000;
constexpr std::size_t longest_display = 65'000;  // in bytes, a little less than is read
constexpr std::size_t ten_megabytes = 10'000'000;

const std::string dot_product = R"(\mathbf{A}\cdot\mathbf{B})";
const std::string reversed = R"(\mathbf{B}\cdot\mathbf{A})";
const std::string closing = " = " + reversed + "$$";

std::string repeated(const std::string& text, std::size_t times) {
  std::string result;
  result.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

std::string nested(const std::string& open, const std::string& close, std::size_t times = many) {
  return "$$" + repeated(open, times) + dot_product + repeated(close, times) + closing;
}

/// As deep as one display can be that is read.
std::string deepest(const std::string& open, const std::string& close) {
  return nested(open, close, longest_display / (open.size() + close.size()));
}

std::string environments(std::size_t times) {
  return "\\begin{equation}\n" + repeated("\\begin{aligned}\n", times) + "\\end{equation}\n";
}

/// `\maaaa`, `\maaab` and so on: a macro's name has letters only.
std::string macro_name(std::size_t number) {
  std::string letters;
  for (int i = 0; i < 4; ++i, number /= 26)
    letters.insert(letters.begin(), static_cast<char>('a' + number % 26));
  return "\\m" + letters;
}

std::string definition(const std::string& name, const std::string& body) {
  return "\\newcommand{" + name + "}{" + body + "}\n";
}

std::string macros() {
  std::string text;
  for (std::size_t i = 0; i < many; ++i) text += definition(macro_name(i), dot_product);
  return text + "\\[ " + dot_product + " = " + reversed + " \\]\n";
}

std::string macro_chain() {
  std::string text = definition(macro_name(0), dot_product);
  for (std::size_t i = 1; i < many; ++i) text += definition(macro_name(i), macro_name(i - 1));
  return text + "\\[ " + macro_name(many - 1) + " = " + reversed + " \\]\n";
}

std::string macro_brackets() {
  return definition("\\opening", std::string(many, '(')) + definition("\\closing", std::string(many, ')')) +
         "\\[ \\opening " + dot_product + " \\closing = " + reversed + " \\]\n";
}

std::string random_bytes() {
  std::mt19937 generator(20240607);
  std::string text = "\xFF";
  while (text.size() < 100'000) text += static_cast<char>(generator() & 0xFFU);
  return text;
}

/// Cut behind a row of an environment, so that the environment is open.
std::string half_of_a_document() {
  const std::string whole = text_of("../../derivations/vector-identities.tex");
  return whole.substr(0, whole.find("\\\\\n", whole.size() / 2));
}

std::string long_chain() {
  std::string text = "$$" + dot_product;
  for (int i = 1; i <= 2000; ++i)
    text += (i % 10 == 0 ? "\n = " : " = ") + (i % 2 == 1 ? reversed : dot_product);
  return text + "$$\n";
}

using Recipe = std::function<std::string()>;

const std::map<std::string, Recipe>& recipes() {
  static const std::map<std::string, Recipe> table{
      {"blank.md", [] { return text_of("pass/chains.md"); }},
      {"empty.md", [] { return std::string(); }},
      {"prose-10MB.md", [] { return std::string(ten_megabytes, 'x'); }},
      {"display-10MB.md",
       [] {
         const std::string term = dot_product + " + ";
         return "$$" + repeated(term, ten_megabytes / term.size()) + dot_product + closing;
       }},
      {"dollars-10MB.md", [] { return std::string(ten_megabytes + 1, '$'); }},
      {"braces.md", [] { return nested("{", "}"); }},
      {"brackets.md", [] { return nested("(", ")"); }},
      {"left-brackets.md", [] { return nested("\\left(", "\\right)"); }},
      {"fractions.md", [] { return nested("\\frac{", "}{2}"); }},
      {"environments.tex", [] { return environments(many); }},
      {"braces-64KB.md", [] { return deepest("{", "}"); }},
      {"brackets-64KB.md", [] { return deepest("(", ")"); }},
      {"left-brackets-64KB.md", [] { return deepest("\\left(", "\\right)"); }},
      {"fractions-64KB.md", [] { return deepest("\\frac{", "}{2}"); }},
      {"environments-64KB.tex", [] { return environments(4000); }},
      {"macro-brackets.tex", macro_brackets},
      {"open-braces.md", [] { return "$$" + std::string(many, '{') + closing; }},
      {"open-brackets.md", [] { return "$$" + std::string(many, '(') + closing; }},
      {"macros.tex", macros},
      {"macro-chain.tex", macro_chain},
      {"self.tex", [] { return "\\input{self}\n\\[ " + dot_product + " = " + reversed + " \\]\n"; }},
      {"unreadable.md", [] { return "$$" + dot_product + closing; }},
      {"random.md", random_bytes},
      {"half.tex", half_of_a_document},
      {"wide-derivative.md", [] { return "$$\\frac{d}{dt}(" + repeated("abc", 20'000) + ") = 0$$\n"; }},
      {"derivatives.md",
       [] {
         return "$$" + repeated("\\nabla^2", 5) + " f = 0$$\n\n$$" + repeated("\\nabla\\times(", 12) +
                "\\mathbf{A}" + repeated(")", 12) + " = 0$$\n";
       }},
      {"rates.md",
       [] {
         const std::string rate = "\\frac{d^8}{dt^8}";
         return "$$" + repeated(rate, 33) + "x = " + rate + "x$$\n";
       }},
      {"operators.md", [] { return "$$" + repeated("\\nabla^2", 8'000) + " f = 0$$\n"; }},
      {"ninth-rate.md", [] { return "$$\\frac{d^9}{dt^9}(abcefghk) = 0$$\n"; }},
      {"long-chain.md", long_chain},
  };
  return table;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  const auto parent = std::filesystem::temp_directory_path();
  std::random_device number;
  do path_ = (parent / ("rigor-test-" + std::to_string(number()))).string();
  while (!std::filesystem::create_directory(path_));
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string make_file(const std::string& name, const TemporaryFolder& folder) {
  const std::string text = recipes().at(name)();
  const std::string path = folder.path() + "/" + (name == "blank.md" ? "name with blank.md" : name);
  std::ofstream(path, std::ios::binary) << text;
  if (name == "unreadable.md") std::filesystem::permissions(path, std::filesystem::perms::none);
  return path;
}

}  // namespace rigor
