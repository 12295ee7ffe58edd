// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/possible_ranks.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

/// The ranks as digits, `01`; `-` for none.
std::string ranks_of(const std::string& text, const Evidence& evidence = {}) {
  Stretch stretch(text);
  SyntaxTree syntax;
  Names names;
  names.symbols.evidence = Shared(evidence);
  const Tokens side = stretch.side();
  const SyntaxId root = parse_side(side, span_of(side), syntax);
  see_kinds(syntax, root, names.symbols.evidence.write());
  std::vector<OpenPart> open;
  const RankSet ranks = possible_ranks(syntax, root, read_letters(syntax, {root}, names), names, open);
  std::string digits;
  for (int rank = 0; rank <= 3; ++rank) {
    if ((ranks >> rank & 1) != 0) digits += std::to_string(rank);
  }
  return digits.empty() ? "-" : digits;
}

Evidence of_vectors(std::set<std::string> letters) {
  Evidence evidence;
  evidence.vectors = std::move(letters);
  return evidence;
}

Evidence of_crossed(std::set<std::string> letters) {
  Evidence evidence;
  evidence.crossed = std::move(letters);
  return evidence;
}

}  // namespace

TEST_CASE("a plain letter has any rank until something settles it") {
  CHECK(ranks_of("w") == "012");
  CHECK(ranks_of("x") == "0");
  CHECK(ranks_of("\\frac{1}{w}") == "0");
  CHECK(ranks_of("w\\mathbf a") == "1");
  CHECK(ranks_of("W\\mathbf a").find('1') != std::string::npos);
  CHECK(ranks_of("w", of_vectors({"w"})) == "0");
}

TEST_CASE("a bold capital is a vector or a matrix, and a vector where it is crossed") {
  CHECK(ranks_of("\\mathbf A") == "12");
  CHECK(ranks_of("\\mathbf a") == "1");
  CHECK(ranks_of("\\mathbf A", of_crossed({"A"})) == "1");
}

TEST_CASE("only what fails for all ranks of its letters has none") {
  CHECK(ranks_of("\\mathbf a + |\\mathbf b|") == "-");
  CHECK(ranks_of("\\mathbf a + w") == "1");
  CHECK(ranks_of("\\mathbf a + O(w^2)") == "1");
  CHECK(ranks_of("\\frac{1}{\\mathbf a}") == "-");
  CHECK(ranks_of("\\sin\\mathbf a") == "-");
  CHECK(ranks_of("(\\mathbf a\\cdot\\mathbf b)\\times\\mathbf c") == "-");
  CHECK(ranks_of("\\nabla\\times(\\mathbf a\\cdot\\mathbf b)") == "-");
  CHECK(ranks_of("\\nabla\\cdot\\mathbf a + x") == "0");
  CHECK(ranks_of("\\mathbf a\\cdot\\mathbf b + \\foo") == "0");
}
