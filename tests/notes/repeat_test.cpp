// SPDX-License-Identifier: GPL-3.0-or-later
// The same notes give the same bytes, whatever was checked before and wherever memory happens to lie.
#include <regex>
#include <sstream>

#include "catch.h"
#include "program.h"

namespace rigor {
namespace {

using Words = std::vector<std::string>;

/// Every note that is here, and those of derivations/.
Words all_notes() {
  Words paths;
  for (const char* folder : {"pass", "fail", "run", "../../derivations"})
    for (const std::string& path : notes_in(folder)) paths.push_back(path);
  return paths;
}

Words check_all(Words options) {
  options.insert(options.begin(), "check");
  for (const std::string& path : all_notes()) options.push_back(path);
  return options;
}

/// Without how long the run took, which stands at the end of the last line.
std::string without_time(const std::string& report) {
  const std::size_t last = report.rfind("; ");
  REQUIRE(last != std::string::npos);
  REQUIRE(std::regex_match(report.substr(last), std::regex("; [0-9.]+ m?s\n")));
  return report.substr(0, last);
}

std::string without_milliseconds(const std::string& json) {
  return std::regex_replace(json, std::regex("\"milliseconds\": [-+.0-9e]+"), "");
}

/// The first line in which two texts differ, or nothing.
std::string first_difference(const std::string& one, const std::string& two) {
  if (one == two) return "";
  std::istringstream first(one);
  std::istringstream second(two);
  std::string left;
  std::string right;
  for (int line = 1;; ++line) {
    const bool more_left = static_cast<bool>(std::getline(first, left));
    const bool more_right = static_cast<bool>(std::getline(second, right));
    if (!more_left || !more_right || left != right)
      return "line " + std::to_string(line) + ":\n" + left + "\n" + right;
  }
}

TEST_CASE("the terminal report of all notes is the same twice in one process, and in another one", "[long]") {
  const Words arguments = check_all({"--color", "always"});
  const std::string report = without_time(run_inside(arguments).text);
  CHECK(first_difference(report, without_time(run_inside(arguments).text)) == "");
  CHECK(first_difference(report, without_time(run_program(arguments).text)) == "");
}

TEST_CASE("what is said of a note does not depend on the notes before it", "[long]") {
  Words paths = all_notes();
  Words backwards{"check", "--json"};
  backwards.insert(backwards.end(), paths.rbegin(), paths.rend());
  const std::string together = without_milliseconds(run_inside(backwards).text);
  for (const std::string& path : paths) {
    const std::string alone = without_milliseconds(run_inside({"check", "--json", path}).text);
    const std::size_t begin = alone.find("    {\n");  // the one file of the report
    const std::size_t end = alone.find("\n    }", begin);
    INFO(path);
    CHECK((together.find(alone.substr(begin, end - begin)) != std::string::npos));
  }
}

}  // namespace
}  // namespace rigor
