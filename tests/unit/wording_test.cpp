#include "renderer/core/wording.h"

#include <catch2/catch.hpp>

using namespace glimt;

TEST_CASE("numbers are grouped by thousands") {
  CHECK(grouped(0) == "0");
  CHECK(grouped(999) == "999");
  CHECK(grouped(1000) == "1,000");
  CHECK(grouped(1234567) == "1,234,567");
}

TEST_CASE("nouns follow their number") {
  CHECK(counted(1, "face") == "1 face");
  CHECK(counted(0, "face") == "0 faces");
}

TEST_CASE("names that would break a line or a terminal become printable") {
  CHECK(printable("a\nb\x1b[31m") == "a?b?[31m");
  CHECK(printable("\xe2\x99\xbb") == "\xe2\x99\xbb");
  CHECK(printable(std::string(1000, 'x')).size() < 500);
}

TEST_CASE("long lists of names are cut") {
  CHECK(listed({}).empty());
  CHECK(listed({"a"}) == "'a'");
  CHECK(listed({"a", "b", "c"}) == "'a', 'b' and 'c'");
  CHECK(listed({"a", "b", "c", "d", "e", "f"}) == "'a', 'b', 'c', 'd' and 2 more");
}

TEST_CASE("a mistyped name finds the known one, and a strange name finds none") {
  const std::vector<std::string> known = {"position", "target", "up", "vertical_fov"};
  CHECK(nearest("positon", known) == "position");
  CHECK(nearest("verticalFov", known) == "vertical_fov");
  CHECK(nearest("weather", known).empty());
  CHECK(nearest(std::string(100'000, 'x'), known).empty());
}
