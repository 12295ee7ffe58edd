// SPDX-License-Identifier: GPL-3.0-or-later
// `eval`, `bench` and `scene` as whole commands.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/command/run.h"
#include "catch.h"

namespace rigor {
namespace {

struct Ended {
  int code = 0;
  std::string out;
  std::string err;
};

Ended run_words(std::vector<std::string> words) {
  words.insert(words.begin(), "rigor");
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  std::ostringstream out;
  std::ostringstream err;
  const int code = run(static_cast<int>(pointers.size()), pointers.data(), out, err);
  return {code, out.str(), err.str()};
}

/// An empty folder that is gone at the end.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              ("rigor-forms-" + std::to_string(::getpid()) + "-" + std::to_string(++count))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }
  [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  static inline int count = 0;
  std::filesystem::path path_;
};

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

const std::string square =
    "$$|\\mathbf{A}\\times\\mathbf{B}|^2 = A^2B^2 - (\\mathbf{A}\\cdot\\mathbf{B})^2 \\tag{1}$$\n";

}  // namespace

TEST_CASE("an evaluation without times prints the same bytes twice") {
  const Folder folder;
  const std::string notes = folder.write("a.md", square);
  const Ended text = run_words({"eval", notes, "--no-times"});
  CHECK(text.code == 0);
  CHECK(text.out == run_words({"eval", notes, "--no-times"}).out);
  const Ended json = run_words({"eval", notes, "--no-times", "--json"});
  CHECK(json.out == run_words({"eval", notes, "--no-times", "--json"}).out);
}

TEST_CASE("the forms as text and as JSON say the same") {
  const Folder folder;
  const std::string notes = folder.write("a.md", square);
  const std::string text = run_words({"eval", notes, "--no-times"}).out;
  const auto json = nlohmann::json::parse(run_words({"eval", notes, "--no-times", "--json"}).out);
  const auto& chain = json["chains"][0];
  CHECK(chain["tag"] == "(1)");
  CHECK(chain["forms"].size() == 2);
  CHECK(chain["trials"].size() == 7);
  CHECK(chain["advice"]["form"] == 0);
  CHECK(text.find(chain["advice"]["text"].get<std::string>()) != std::string::npos);
  const auto& lengths = chain["trials"][6];
  CHECK(lengths["name"] == "lengths 1e+160");
  CHECK(lengths["forms"][1]["double"]["overflows"] == lengths["forms"][1]["measured"]);
  CHECK(lengths["forms"][1]["double"]["relative_error"]["worst"].is_null());
}

TEST_CASE("the point of an advice, put in again, gives the errors that it names") {
  const Folder folder;
  const std::string notes = folder.write("a.md", "$$x^2 - y^2 = (x-y)(x+y)$$\n");
  const auto json = nlohmann::json::parse(run_words({"eval", notes, "--no-times", "--json"}).out);
  const std::string advice = json["chains"][0]["advice"]["text"];
  const auto from = advice.find(" at ") + 4;
  const auto to = advice.find(": it errs");
  REQUIRE(from < to);
  const std::string point = advice.substr(from, to - from);
  const auto again =
      nlohmann::json::parse(run_words({"eval", notes, "--no-times", "--json", "--with", point}).out);
  const auto& worst = json["chains"][0]["search"]["ranges"][0]["losing"][0];
  const auto& given = again["chains"][0]["trials"];
  REQUIRE(given.size() == 1);
  CHECK(worst["form"] == 0);
  for (std::size_t form = 0; form < 2; ++form)
    CHECK(given[0]["forms"][form]["double"] == worst["forms"][form]["double"]);
  const Ended ended = run_words({"eval", notes, "--with", "x"});
  CHECK(ended.code == 1);
  CHECK(ended.err.find("`x` gives no letter a number") != std::string::npos);
}

TEST_CASE("what cannot be read in the notes is reported, and the rest is evaluated") {
  const Folder folder;
  const Ended ended =
      run_words({"eval", folder.write("a.md", "$$\\mathbf a = \\mathbf b\\cdot\\mathbf c$$\n\n" + square),
                 "--no-times"});
  CHECK(ended.code == 1);
  CHECK(ended.err.find("a.md:1:") != std::string::npos);
  CHECK(ended.out.find("Compute A") != std::string::npos);
}

TEST_CASE("pictures of chains with one tag have names of their own") {
  const Folder folder;
  const std::string notes = folder.write("a.md", square + "\n# B\n\n" + square);
  const Ended ended = run_words({"bench", notes, "--into", folder / "out"});
  CHECK(ended.code == 0);
  const std::string table = text_of(folder / "out/a-forms.md");
  CHECK(table.find("![time against error](a-1.svg)") != std::string::npos);
  CHECK(table.find("![time against error](a-1-2.svg)") != std::string::npos);
  CHECK(text_of(folder / "out/a-1.svg").find("<svg") != std::string::npos);
  CHECK(text_of(folder / "out/a-1-2.svg").find("<svg") != std::string::npos);
  CHECK(table.find("| B | double-double |") != std::string::npos);
}

TEST_CASE("what cannot be written is said") {
  const Folder folder;
  const std::string notes = folder.write("a.md", square);
  const Ended ended = run_words({"bench", notes, "--into", notes + "/below"});
  CHECK(ended.code == 66);
  CHECK(ended.err.find("cannot be written") != std::string::npos);
}

TEST_CASE("the heading of a section takes those within it") {
  const Folder folder;
  const std::string notes = folder.write("a.md", "# Top\n\n## Inner\n\n" + square + "\n# Other\n\n" + square);
  const auto chains = [&](const std::string& place) {
    return nlohmann::json::parse(
               run_words({"eval", notes, "--at", place, "--no-times", "--json"}).out)["chains"]
        .size();
  };
  CHECK(chains("Top") == 1);
  CHECK(chains("Inner") == 1);
  CHECK(chains("(1)") == 2);
}

TEST_CASE("a folder of bodies means all of them, and must have one") {
  const Folder folder;
  const std::string notes = folder.write("a.md",
                                         "<!-- rigor:\nparticles \\alpha\nscalar m_\\alpha\n-->\n$$M = "
                                         "\\sum_\\alpha m_\\alpha + \\sum_\\alpha m_\\alpha$$\n");
  folder.write("some/one.toml", "particles = [{ mass = 1, position = [0, 0, 0] }]\n");
  folder.write("some/two.toml", "particles = [{ mass = 2, position = [0, 0, 0] }]\n");
  std::filesystem::create_directories(folder / "none");
  const Ended some = run_words({"eval", notes, "--no-times", "--body", folder / "some"});
  CHECK(some.code == 0);
  CHECK(some.out.find("one ") != std::string::npos);
  CHECK(some.out.find("two ") != std::string::npos);
  const Ended none = run_words({"eval", notes, "--no-times", "--body", folder / "none"});
  CHECK(none.code == 66);
  CHECK(none.err.find("there is no body in the folder") != std::string::npos);
}

TEST_CASE("a scene's JSON is the same twice, and has times only with --explain") {
  const Folder folder;
  folder.write("notes.md", "<!-- rigor:\nparticles \\alpha\n-->\n$$M = \\sum_\\alpha m_\\alpha$$\n");
  folder.write("bodies/one.toml", "particles = [{ mass = 3, position = [0, 0, 0] }]\n");
  const std::string scene = folder.write(
      "scene.toml", "notes = \"notes.md\"\nbody = \"bodies/one.toml\"\n[ask]\nquantities = ['M']\n");
  const Ended ended = run_words({"scene", scene, "--json"});
  CHECK(ended.code == 0);
  CHECK(ended.out == run_words({"scene", scene, "--json"}).out);
  const auto json = nlohmann::json::parse(ended.out);
  CHECK(json["quantities"][0]["value"][0] == 3.0);
  CHECK_FALSE(json["nodes"][0].contains("milliseconds"));
  const auto explained = nlohmann::json::parse(run_words({"scene", scene, "--json", "--explain"}).out);
  CHECK(explained["nodes"][0].contains("milliseconds"));
}

TEST_CASE("an unknown quantity is reported at its place in the scene") {
  const Folder folder;
  folder.write("notes.md", "<!-- rigor:\nparticles \\alpha\n-->\n$$M = \\sum_\\alpha m_\\alpha$$\n");
  folder.write("bodies/one.toml", "particles = [{ mass = 3, position = [0, 0, 0] }]\n");
  const std::string scene =
      folder.write("scene.toml", "notes = \"notes.md\"\nbody = \"one\"\n[ask]\nquantities = ['M', 'N']\n");
  const Ended ended = run_words({"scene", scene});
  CHECK(ended.code == 1);
  CHECK(ended.err.find("scene.toml:4:20: error: `N` is nowhere in the notes [unknown-quantity]") !=
        std::string::npos);
}

}  // namespace rigor
