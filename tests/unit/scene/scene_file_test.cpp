// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/file/scene_file.h"

#include <cmath>

#include "catch.h"

namespace rigor {
namespace {

struct ReadScene {
  SourceMap sources;
  Diagnostics diagnostics;
  std::optional<SceneFile> scene;

  explicit ReadScene(std::string text) {
    const FileId file = sources.add("scenes/some.toml", std::move(text));
    scene = read_scene(sources, file, diagnostics);
  }
  /// `line: kind: message`, a line each.
  [[nodiscard]] std::string messages() const {
    std::string all;
    for (const Diagnostic& each : diagnostics) {
      all += std::to_string(sources.line_column(each.span.file, each.span.begin).line) + ": " +
             std::string(info(each.kind).name) + ": " + each.message + "\n";
    }
    return all;
  }
};

const std::string head = "notes = \"../a.md\"\nbody = \"book\"\n";
const std::string ask = "[ask]\nquantities = ['T_{rot}']\n";

TEST_CASE("a scene needs notes, a body and a question, and has good defaults", "[scene file]") {
  const ReadScene read(head + ask);
  CHECK(read.messages() == "");
  REQUIRE(read.scene);
  CHECK(read.scene->title == "some");
  CHECK(read.scene->notes_path() == "a.md");
  CHECK(read.scene->body.text == "book");
  CHECK(!read.scene->spin);
  CHECK(!read.scene->motion);
  CHECK(read.scene->symbols.spin.text == "\\boldsymbol{\\omega}");
  CHECK(asked_of_notes(*read.scene) == std::vector<std::string>{"T_{rot}"});
}

TEST_CASE("what is missing is said, at the file", "[scene file]") {
  const ReadScene read("title = \"t\"\n");
  CHECK(!read.scene);
  CHECK(read.messages() ==
        "1: bad-toml: the scene has no `notes`\n1: bad-toml: the scene has no `body`\n1: bad-toml: the scene "
        "has no "
        "`ask`\n");
}

TEST_CASE("quantities over the time, letters and values are asked of the notes once each", "[scene file]") {
  const ReadScene read(head +
                       "[values]\n'\\tau' = [1, 2, 3]\n[symbols]\nspin = '\\vec{w}'\n[motion]\nequations = "
                       "\"(22)\"\nduration = \"2 s\"\n[ask]\nquantities = ['L', 'L(t)', 'principal moments', "
                       "'principal axes']\n");
  CHECK(read.messages() == "");
  REQUIRE(read.scene);
  CHECK(asked_of_notes(*read.scene) == std::vector<std::string>{"L", "\\tau", "\\vec{w}"});
  CHECK(read.scene->asked[1].kind == SceneAskKind::over_time);
  CHECK(read.scene->asked[2].kind == SceneAskKind::principal_moments);
  CHECK(read.scene->asked[3].kind == SceneAskKind::principal_axes);
  CHECK(read.scene->motion->duration == 2);
}

TEST_CASE("a spin is read with its unit", "[scene file]") {
  const ReadScene read(head + "spin = [\"60 rpm\", \"90 deg/s\", 3]\n" + ask);
  REQUIRE(read.scene);
  CHECK((*read.scene->spin)[0] == Approx(2 * 3.14159265358979));
  CHECK((*read.scene->spin)[1] == Approx(3.14159265358979 / 2));
  CHECK((*read.scene->spin)[2] == 3);
  CHECK(ReadScene(head + "spin = [\"1 kg\", 0, 0]\n" + ask).messages() ==
        "3: wrong-unit: `1 kg` is a mass (M), but `spin` must be a rate (T^{-1})\n");
  CHECK(ReadScene(head + "spin = [0, \"2 kHz\", 0]\n" + ask).messages() ==
        "3: wrong-unit: `2 kHz` counts turns or radians: a spin needs an angle\n");
  CHECK(ReadScene(head + "spin = [1, 0]\n" + ask).messages() ==
        "3: bad-toml: `spin` has 2 values, but must have 3\n");
  CHECK(ReadScene(head + "spin = [nan, 0, 0]\n" + ask).messages() ==
        "3: bad-toml: `spin` is nan, but must be finite\n");
}

TEST_CASE("components of one value with two units contradict each other", "[scene file]") {
  CHECK(ReadScene(head + "[values]\n'\\tau' = [\"1 kg\", \"1 m\", 0]\n" + ask).messages() ==
        "4: wrong-unit: `1 m` is a length (L), but another component of `\\tau` is a mass (M)\n");
  CHECK(ReadScene(head + "[values]\n'\\tau' = [1, 2]\n" + ask).messages() ==
        "4: bad-toml: `\\tau` has 2 components, but must have 3\n");
  CHECK(ReadScene(head + "[values]\n'\\tau' = inf\n" + ask).messages() ==
        "4: bad-toml: `\\tau` is inf, but must be finite\n");
}

TEST_CASE("values are at most 200", "[scene file]") {
  std::string values = "[values]\n";
  for (int i = 0; i < 200; ++i) values += "'a_{" + std::to_string(i) + "}' = 1\n";
  CHECK(ReadScene(head + values + ask).messages() == "");
  CHECK(ReadScene(head + values + "b = 1\n" + ask).messages() ==
        "3: bad-scene: 201 values are too many: at most 200\n");
}

TEST_CASE("an orientation is a quaternion, or an axis and an angle", "[scene file]") {
  const ReadScene turned(head + "orientation = { axis = [0, 0, 2], angle = \"90 deg\" }\n" + ask);
  REQUIRE(turned.scene);
  CHECK((*turned.scene->orientation)[0] == Approx(std::sqrt(0.5)));
  CHECK((*turned.scene->orientation)[3] == Approx(std::sqrt(0.5)));
  const ReadScene given(head + "orientation = [3, 0, 4, 0]\n" + ask);
  REQUIRE(given.scene);
  CHECK((*given.scene->orientation)[2] == Approx(0.8));
  for (const std::string size : {"1.7e308", "1e-308"}) {  // lengths that overflow, or whose squares are 0
    const ReadScene far(head + "orientation = { axis = [0, " + size + ", " + size +
                        "], angle = \"90 deg\" }\n" + ask);
    REQUIRE(far.scene);
    CHECK((*far.scene->orientation)[2] == Approx(0.5));
    const ReadScene large(head + "orientation = [" + size + ", 0, " + size + ", 0]\n" + ask);
    REQUIRE(large.scene);
    CHECK((*large.scene->orientation)[2] == Approx(std::sqrt(0.5)));
  }
  CHECK(ReadScene(head + "orientation = { axis = [0, 0, 0], angle = 1 }\n" + ask).messages() ==
        "3: bad-scene: the orientation has no axis\n");
  CHECK(ReadScene(head + "orientation = [0, 0, 0, 0]\n" + ask).messages() ==
        "3: bad-scene: the orientation has no axis\n");
}

TEST_CASE("what a scene cannot mean is a diagnostic at its place", "[scene file]") {
  CHECK(ReadScene(head + "[ask]\nquantities = ['L(t)']\n").messages() ==
        "4: bad-scene: `L(t)` needs a motion, but the scene has none\n");
  CHECK(ReadScene(head + "[ask]\nquantities = []\n").messages() ==
        "4: bad-scene: the scene asks for nothing\n");
  for (const char* blank : {"''", "'  '"}) {
    CHECK(ReadScene(head + "[ask]\nquantities = ['L', " + blank + "]\n").messages() ==
          "4: bad-scene: a quantity without a name is asked for\n");
  }
  CHECK(ReadScene(head + "axes = \"inertial\"\n" + ask).messages() ==
        "3: bad-scene: `axes` is `inertial`, but must be `body` or `principal`\n");
  CHECK(ReadScene(head + "sping = [1, 0, 0]\n" + ask).messages() ==
        "3: unknown-key: the scene has a key `sping`, which is not known\n");
  CHECK(ReadScene(head + "[motion]\nequations = \"(22)\"\nduration = 0\n" + ask).messages() ==
        "5: bad-scene: the motion has no duration\n");
  CHECK(ReadScene(head + "[motion]\nequations = \"(22)\"\nduration = 1\nrows = 1\n" + ask).messages() ==
        "6: bad-scene: `rows` is 1, but must be between 2 and 100000\n");
  CHECK(ReadScene(head + "[motion]\nequations = \"(22)\"\nduration = 1\ntolerance = 1e-17\n" + ask)
            .messages() == "6: bad-scene: `tolerance` is 1e-17, but must be between 1e-15 and 0.01\n");
  for (const std::string split : {"0", "1001"}) {
    CHECK(ReadScene(head + "[motion]\nequations = \"(22)\"\nduration = 1\nsplit = " + split + "\n" + ask)
              .messages() == "6: bad-scene: `split` is " + split + ", but must be between 1 and 1000\n");
  }
}

}  // namespace
}  // namespace rigor
