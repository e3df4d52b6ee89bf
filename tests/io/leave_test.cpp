// SPDX-License-Identifier: MIT
//
// The key `leave` of a puzzle, and what an answer says of it.
#include "bankshot/scene/leave.hpp"

#include "bankshot/plan/planner.hpp"
#include "bankshot/scene/json.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

std::string puzzle(const std::string& leave, const std::string& rest = R"("target": {"ball": "8"})") {
  return R"({"table": "pool-9ft", "ball": {"at": [0.8, 0.5]}, "others": [{"id": "8", "at": [1.5, 0.7]}], )" + rest +
         R"(, "leave": )" + leave + "}";
}

std::string refused(const std::string& text) {
  try {
    read_puzzle(text);
  } catch (const InvalidInput& e) {
    return e.path;
  }
  return "accepted";
}

}  // namespace

TEST_CASE("every form of a leave is read and written") {
  const char* const leave =
      GENERATE(R"({"point": [1.9, 0.6], "within": 0.1})", R"({"point": [1.9, 0.6]})",
               R"({"polygon": [[1.2, 0.3], [1.8, 0.3], [1.5, 0.9]]})", R"({"for": "8"})", R"({"safe": ["8"]})",
               R"({"for": ["8"]})", R"({"for": [["8"]]})", R"({"against": "8"})");
  const std::string written = write_puzzle(read_puzzle(puzzle(leave)));
  CHECK(written.find("\"leave\"") != std::string::npos);
  CHECK(write_puzzle(read_puzzle(written)) == written);
}

TEST_CASE("a leave that cannot be is refused with its place") {
  CHECK(refused(puzzle("[1, 0.5]")) == "/leave");
  CHECK(refused(puzzle("{}")) == "/leave");
  CHECK(refused(puzzle(R"({"next": "8"})")) == "/leave");
  CHECK(refused(puzzle(R"({"point": [9, 0.5]})")) == "/leave/point");
  CHECK(refused(puzzle(R"({"point": [1, 0.5], "within": 0})")) == "/leave/within");
  CHECK(refused(puzzle(R"({"polygon": [[1, 0.5], [1, 0.6]]})")) == "/leave/polygon");
  CHECK(refused(puzzle(R"({"for": "9"})")) == "/leave/for");
  CHECK(refused(puzzle(R"({"for": []})")) == "/leave/for");
  CHECK(refused(puzzle(R"({"for": [["8"], ["9"]]})")) == "/leave/for/1/0");
  CHECK(refused(puzzle(R"({"against": {}})")) == "/leave/against");
  CHECK(refused(puzzle(R"({"for": "8"})", R"("table": "carom-10ft", "target": {"ball": "8"})")) != "accepted");
  CHECK(refused(puzzle(R"({"safe": []})")) == "/leave/safe");
  CHECK(refused(puzzle(R"({"point": [1, 0.5]})", R"("target": {"pocket": "any"})")) == "/leave");
  CHECK(refused(puzzle(R"({"point": [1, 0.5]})", R"("target": {"ball": "8"}, "physics": "ideal")")) == "/leave");
  CHECK(refused(puzzle(R"({"point": [1, 0.5]})", R"("target": {"ball": "8"}, "prefer": {"leave": [1, 0.5]})")) ==
        "/prefer/leave");
}

TEST_CASE("the distance from a region is 0 inside, and else that to its nearest edge") {
  const LeaveRegion square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  CHECK(distance_to(square, {0.5, 0.5}) == 0);
  CHECK(distance_to(square, {1.5, 0.5}) == Approx(0.5));
  CHECK(distance_to(square, {2, 2}) == Approx(std::sqrt(2.0)));
  const LeaveRegion other_way{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  CHECK(distance_to(other_way, {0.5, 0.5}) == 0);
}

TEST_CASE("an answer with a leave is read back as it was written, and its text tells the leave") {
  const Puzzle p = read_puzzle(
      puzzle(R"({"point": [1.2, 0.8], "within": 0.3})", R"("target": {"ball": "8", "pocket": "any"}, "cushions": 0)"));
  const Answer a = solve(p);
  REQUIRE(a.status == Status::solved);
  const std::string json = to_json(p, a, false);
  const Answer again = read_answer(json, &p);
  REQUIRE(again.shots.front().leave);
  CHECK(again.shots.front().leave->at == a.shots.front().leave->at);
  CHECK(again.shots.front().leave->spread.has_value() == a.shots.front().leave->spread.has_value());
  CHECK(to_text(p, a).find("to make it and stop within 300 mm of the place") != std::string::npos);
}
