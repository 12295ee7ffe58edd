// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/file/toml_reader.h"

#include <functional>

#include "catch.h"
#include "scene/file/quantity_text.h"
#include "source/render.h"

namespace rigor {
namespace {

/// What reading `text` reports, as it is printed; `read` does nothing if the text is no TOML.
std::string reported(std::string text, const std::function<void(TomlReader&)>& read = {}) {
  SourceMap sources;
  Diagnostics diagnostics;
  const FileId file = sources.add("a.toml", std::move(text));
  if (const auto table = parse_toml(sources, file, diagnostics); table && read) {
    TomlReader reader(*table, "the body", diagnostics);
    read(reader);
  }
  std::string printed;
  for (const Diagnostic& diagnostic : diagnostics) printed += render(diagnostic, sources);
  return printed;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

TEST_CASE("values of all types are read, each with its place, in the order of the file") {
  SourceMap sources;
  Diagnostics diagnostics;
  const std::string text = "z = \"é\" # remark\na = [1, 2.5]\nt = true\n[part]\nd = 1979-05-27\n";
  const FileId file = sources.add("a.toml", text);
  const auto table = parse_toml(sources, file, diagnostics);
  REQUIRE(table);
  CHECK(diagnostics.empty());
  REQUIRE(table->entries.size() == 4);
  CHECK(table->entries[0].key == "z");
  CHECK(table->entries[0].value.text == "é");
  CHECK(sources.text(table->entries[0].value.span) == "\"é\"");
  CHECK(table->entries[1].value.items[1].number == 2.5);
  CHECK_FALSE(table->entries[1].value.items[1].whole);
  CHECK(sources.text(table->entries[1].value.items[1].span) == "2.5");
  CHECK(table->entries[2].value.truth);
  CHECK(sources.text(table->entries[3].key_span) == "part");
  CHECK(table->entries[3].value.entries[0].value.kind == TomlKind::date);
}

TEST_CASE("what is no TOML is reported where it stops being TOML") {
  CHECK(first_line(reported("mass = \"1 kg\"\nshape = \"box\n"))
            .starts_with("a.toml:2:13: error: this is not TOML: "));
  CHECK(first_line(reported("mass = 1\nsize = 2\nmass = 3\n")) ==
        "a.toml:3:8: error: `mass` is given twice [bad-toml]");
}

TEST_CASE("tables nested too deep are refused, however they are written") {
  std::string dotted = "a";
  for (int k = 0; k < 100'000; ++k) dotted += ".a";
  CHECK(first_line(reported(dotted + " = 1\n")) ==
        "a.toml:1:130: error: tables are nested too deep [bad-toml]");
  std::string some = "a";
  for (int k = 0; k < 70; ++k) some += ".a";
  CHECK(first_line(reported(some + " = 1\n")) ==
        "a.toml:1:130: error: tables are nested too deep [bad-toml]");
  CHECK(first_line(reported("x = " + std::string(100, '[') + std::string(100, ']') + "\n")) ==
        "a.toml:1:1: error: tables are nested too deep [bad-toml]");
  CHECK(reported("[" + some + "]\n").find("tables are nested too deep") != std::string::npos);
  CHECK(reported("x = " + std::string(100'000, '[')).find("[bad-toml]") != std::string::npos);
  CHECK(reported("a.b.c = 1\nx = \"" + std::string(1'000, '.') + "\"\n").empty());
}

TEST_CASE("characters beyond ASCII are for strings and comments") {
  CHECK(reported("a = é\n") ==
        "a.toml:1:5: error: `é` can only stand in a string or a comment [bad-toml]\n"
        "    1 | a = é\n"
        "      |     ^\n");
  CHECK(reported("a = \"é\\\"é\" # é\nb = 'é'\nc = \"\"\"\né\"é\\\"\"\"\"\"\"\nd = \'\'\'é\'é\n\'\'\'\n")
            .empty());
  CHECK(first_line(reported("a = \"é\nb = é\n")).starts_with("a.toml:2:5: error: `é` can only"));
}

TEST_CASE("what toml++ asserts is reported") {
  CHECK(first_line(reported("a = [}\n")).starts_with("a.toml:1:6: error: this is not TOML: "));
  CHECK(first_line(reported("a = [1,,2]\n")).starts_with("a.toml:1:8: error: this is not TOML: "));
}

TEST_CASE("an unknown key is reported with the nearest that was asked for") {
  const auto printed = reported("radios = 1\n", [](TomlReader& reader) {
    CHECK_FALSE(reader.number("radius"));
    reader.report_unknown();
  });
  CHECK(printed ==
        "a.toml:1:1: error: the body has a key `radios`, which is not known [unknown-key]\n"
        "    1 | radios = 1\n"
        "      | ^~~~~~\n"
        "help: did you mean `radius`?\n");
}

TEST_CASE("a missing key and a wrong type are reported") {
  CHECK(first_line(reported("a = 1\n", [](TomlReader& reader) {
          CHECK(reader.require("mass") == nullptr);
        })) == "a.toml:1:1: error: the body has no `mass` [bad-toml]");
  CHECK(first_line(reported("a = 1\n", [](TomlReader& reader) { CHECK_FALSE(reader.text("a")); })) ==
        "a.toml:1:5: error: `a` is a number, but must be a string [bad-toml]");
  CHECK(first_line(reported("a = \"1\"\n", [](TomlReader& reader) { CHECK_FALSE(reader.number("a")); })) ==
        "a.toml:1:5: error: `a` is a string, but must be a number [bad-toml]");
  CHECK(first_line(reported("a = nan\n", [](TomlReader& reader) { CHECK_FALSE(reader.number("a")); })) ==
        "a.toml:1:5: error: `a` is nan, but must be finite [bad-toml]");
  CHECK(first_line(reported("a = 1.5\n", [](TomlReader& reader) { CHECK_FALSE(reader.whole("a")); })) ==
        "a.toml:1:5: error: `a` must be a whole number [bad-toml]");
  CHECK(first_line(reported("a = [1, 2]\n", [](TomlReader& reader) {
          CHECK_FALSE(reader.quantities("a", length_dimension(), 3));
        })) == "a.toml:1:5: error: `a` has 2 values, but must have 3 [bad-toml]");
}

TEST_CASE("quantities are converted to SI units, and other dimensions are refused at their place") {
  CHECK(reported("a = \"10 cm\"\nb = 0.25\nc = [\"1 m\", 2]\n", [](TomlReader& reader) {
          CHECK(reader.quantity("a", length_dimension()) == 0.1);
          CHECK(reader.quantity("b", length_dimension()) == 0.25);
          CHECK(reader.quantities("c", length_dimension(), 2) == std::vector<double>{1, 2});
          CHECK_FALSE(reader.quantity("missing", length_dimension()));
        }).empty());
  CHECK(reported("size = [\"1 m\", \"3 s\"]\n",
                 [](TomlReader& reader) { CHECK_FALSE(reader.quantities("size", length_dimension(), 2)); }) ==
        "a.toml:1:16: error: `3 s` is a time (T), but `size` must be a length (L) [wrong-unit]\n"
        "    1 | size = [\"1 m\", \"3 s\"]\n"
        "      |                ^~~~~\n");
}

}  // namespace
}  // namespace rigor
