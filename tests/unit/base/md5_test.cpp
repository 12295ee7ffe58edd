// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/md5.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("the digests are those of RFC 1321") {
  CHECK(md5("") == "d41d8cd98f00b204e9800998ecf8427e");
  CHECK(md5("abc") == "900150983cd24fb0d6963f7d28e17f72");
  CHECK(md5("abcdefghijklmnopqrstuvwxyz") == "c3fcd3d76192e4007dfb496cca67e13b");
  CHECK(md5("12345678901234567890123456789012345678901234567890123456789012345678901234567890") ==
        "57edf4a22be3c955ac49da2e2107b67a");
}

TEST_CASE("texts about as long as a block have the digests of md5sum") {
  CHECK(md5(std::string(55, 'a')) == "ef1772b6dff9a122358552954ad0df65");
  CHECK(md5(std::string(56, 'a')) == "3b0c8ac703f828b04c6c197006d17218");
  CHECK(md5(std::string(64, 'a')) == "014842d480b571495a4a0363793f7367");
  CHECK(md5(std::string(1000, '\xff')) == "23cc517ae5734b068e21c92920a5ee02");
}

}  // namespace
}  // namespace rigor
