// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/check.h"

#include "catch.h"

namespace rigor {
namespace {

std::string message_of_failure() {
  try {
    const int rank = 4;
    RIGOR_CHECK(rank < 3, rank, "tensor");
  } catch (const InternalError& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("a check that holds does nothing") {
  RIGOR_CHECK(1 + 1 == 2, "two");
  RIGOR_CHECK(true);
}

TEST_CASE("a check that fails says the condition, the place and the values") {
  const std::string message = message_of_failure();
  CHECK(message.starts_with("check failed at "));
  CHECK(message.find("check_test.cpp:") != std::string::npos);
  CHECK(message.ends_with(": rank < 3; values: 4 tensor"));
}

}  // namespace
}  // namespace rigor
