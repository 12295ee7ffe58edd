// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include <string>

#include "catch.h"

using namespace rigor;

namespace {

/// `f: x y; n: E;`: the functions that the words show.
std::string seen(std::string_view text) {
  Evidence evidence;
  see_inline_functions(text, evidence);
  std::string found;
  for (const auto& [name, arguments] : evidence.functions) {
    found += name + ":";
    for (const std::string& argument : arguments) found += " " + argument;
    found += ";";
  }
  return found;
}

}  // namespace

TEST_CASE("a letter before letters in brackets is a function", "[seen]") {
  CHECK(seen("where $n(E)$ is the density of states") == "n: E;");
  CHECK(seen("with \\(\\omega(k) = ck\\) and $u(x, t)$") == "\\omega: k;u: t x;");
  CHECK(seen("the levels $E_n(B)$") == "E_n: B;");
  CHECK(seen("$f(x)$ and $f(y)$") == "f: x y;");
}

TEST_CASE("a product is no function", "[seen]") {
  CHECK(seen("so $n(n + 1)$ is even").empty());
  CHECK(seen("$n(2)$ and $(E)$ and $2(x)$").empty());
  CHECK(seen("$n(x)y$ and $n(x) + 1$").empty());
  CHECK(seen("$\\mathbf n(x)$").empty());
  CHECK(seen("$n_1(x)$ costs 5$").empty());
  CHECK(seen("$n(x").empty());
  CHECK(seen("$n(").empty());
}
