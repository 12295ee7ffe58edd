// SPDX-License-Identifier: GPL-3.0-or-later
// What is printed reads back: all forms of some notes are replaced by what is printed of them, and the notes
// are read again.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "expr/print/print_latex.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

struct Replaced {
  std::string text;
  int forms = 0;
};

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The notes with every form in their own file as it is printed.
Replaced with_printed_forms(const std::string& text, const FormsReading& reading, FileId file) {
  struct Change {
    Span span;
    std::string latex;
  };
  std::vector<Change> changes;
  for (const WrittenFormChain& chain : reading.forms.chains) {
    const Notation notation = notation_at(reading.forms, chain);
    for (const WrittenForm& form : chain.forms) {
      const bool two_signs = form.source.find("\\pm") != std::string::npos ||
                             form.source.find("\\mp") != std::string::npos;  // written once for two forms
      if (chain.image > 0 || two_signs || !form.expr || form.span.file != file) continue;
      changes.push_back({form.span, print_latex(reading.forms.tree, *form.expr, notation)});
    }
  }
  std::sort(changes.begin(), changes.end(),
            [](const Change& a, const Change& b) { return a.span.begin > b.span.begin; });
  // The left side of cases is written once for all of them.
  const auto same_place = [](const Change& a, const Change& b) { return a.span == b.span; };
  changes.erase(std::unique(changes.begin(), changes.end(), same_place), changes.end());
  Replaced result{text, 0};
  for (const Change& change : changes) {
    result.text.replace(change.span.begin, change.span.end - change.span.begin, " " + change.latex + " ");
    ++result.forms;
  }
  return result;
}

/// What does not read back, one line each.
std::string differences(const std::filesystem::path& path, int& forms) {
  const std::string text = contents(path);
  SourceMap sources;
  const FormsReading before = read_forms_of_text(sources, path.string(), text, {});
  if (before.forms.chains.empty()) return {};
  const FileId file = before.report.file;
  const Replaced replaced = with_printed_forms(std::string(sources.text(file)), before, file);
  forms += replaced.forms;
  SourceMap again;
  const FormsReading after = read_forms_of_text(again, path.string(), replaced.text, {});
  std::string wrong;
  if (after.forms.chains.size() != before.forms.chains.size())
    return path.string() + ": " + std::to_string(before.forms.chains.size()) + " chains became " +
           std::to_string(after.forms.chains.size()) + "\n";
  for (std::size_t c = 0; c < before.forms.chains.size(); ++c) {
    const auto& was = before.forms.chains[c];
    const auto& is = after.forms.chains[c];
    for (std::size_t k = 0; k < was.forms.size(); ++k) {
      if (!was.forms[k].expr) continue;
      const bool read = k < is.forms.size() && is.forms[k].expr.has_value();
      if (read && same_expression(before.forms.tree, *was.forms[k].expr, after.forms.tree, *is.forms[k].expr))
        continue;
      wrong += path.filename().string() + " " + was.tag + ": " + was.forms[k].source + "\n  printed " +
               print_latex(before.forms.tree, *was.forms[k].expr, notation_at(before.forms, was)) +
               "\n  was " + dump(before.forms.tree, *was.forms[k].expr) + "\n  is  " +
               (read ? dump(after.forms.tree, *is.forms[k].expr) : std::string("not read")) + "\n";
    }
  }
  return wrong;
}

std::vector<std::filesystem::path> notes_in(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".md" || extension == ".tex") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

TEST_CASE("every form of the notes reads back as it was when it is printed", "[print]") {
  for (const std::string folder : {"derivations", "tests/notes/pass"}) {
    int forms = 0;
    std::string wrong;
    for (const auto& path : notes_in(folder)) wrong += differences(path, forms);
    INFO(wrong);
    CHECK(wrong.empty());
    CHECK(forms > 200);
  }
}

}  // namespace rigor
