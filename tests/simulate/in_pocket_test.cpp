// SPDX-License-Identifier: MIT
//
// Checks that no ball may start inside a pocket: a ball beyond the fall line is refused, in a puzzle and in a shot. In
// a mouth, before the capture circle, a ball may stand.
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"

using namespace bankshot;

namespace {

struct Refusal {
  std::string path, reason;
};

/// Returns none when the text is accepted.
template <class Read>
std::optional<Refusal> refusal(Read&& read, const std::string& text) {
  try {
    read(text);
    return {};
  } catch (const InvalidInput& e) {
    return Refusal{e.path, e.what()};
  }
}

std::string scene(const std::string& table, const Vec2d& cue, const Vec2d& eight) {
  return fmt::format(
      R"("table": {}, "physics": "rolling", "ball": {{"at": [{}, {}]}}, "others": [{{"id": "8", "at": [{}, {}]}}])",
      table, cue.x, cue.y, eight.x, eight.y);
}

std::string shot(const std::string& scene) { return "{" + scene + R"(, "shot": {"speed": 1, "angle": 0}})"; }
std::string puzzle(const std::string& scene) { return "{" + scene + R"(, "target": {"ball": "8"}})"; }

std::vector<std::string> tables() {
  std::vector<std::string> out;
  for (const char* jaws : {"true", "false"}) {
    for (const char* name : {"pool-7ft", "pool-9ft", "snooker-12ft"})
      out.push_back(fmt::format(R"({{"preset": "{}", "jaws": {}}})", name, jaws));
    out.push_back(fmt::format(R"({{"length": 2.2, "width": 1.3, "pockets": "six", "jaws": {}}})", jaws));
  }
  return out;
}

const Vec2d in_the_open{0.61, 0.43};

}  // namespace

TEST_CASE("a ball beyond the fall line of a pocket is refused, in a puzzle as in a shot") {
  int refused = 0, in_pocket = 0;
  for (const std::string& table : tables()) {
    const ShotRequest open = read_shot(shot(scene(table, in_the_open, {0.4, 0.4})));
    const Boundary boundary(open.table, open.ball.body);
    const Vec2d middle = (open.table.lowest() + open.table.highest()) / 2.0;
    for (const Circle& pocket : boundary.pockets)
      for (const double beyond : {-0.9, -0.5, 0.0, 0.5, 0.99, 1.01, 1.5, 3.0}) {
        // The fall line touches the capture circle where the circle is nearest to the table; these places lie behind
        // it.
        const Vec2d out = (pocket.centre - middle) / norm(pocket.centre - middle);
        const Vec2d at = pocket.centre + out * (beyond * pocket.radius);
        const std::string named = contact_name(open.table, pocket.contact);
        INFO(table << ", " << named << ", " << beyond << " of the radius beyond its centre");
        const auto other = refusal(read_shot, shot(scene(table, in_the_open, at)));
        const auto cue = refusal(read_puzzle, puzzle(scene(table, at, in_the_open)));
        REQUIRE(other);
        REQUIRE(cue);
        CHECK(other->path == "/others/0/at");
        CHECK(cue->path == "/ball/at");
        refused += 2;
        if (std::abs(beyond) >= 1) continue;
        CHECK(other->reason == "ball 8 lies in pocket " + named);
        CHECK(cue->reason == "ball cue lies in pocket " + named);
        CHECK(refusal(read_puzzle, puzzle(scene(table, in_the_open, at)))->reason == other->reason);
        CHECK(refusal(read_shot, shot(scene(table, at, in_the_open)))->reason == cue->reason);
        in_pocket += 4;
      }
  }
  CHECK(refused == 8 * 6 * 8 * 2);
  CHECK(in_pocket == 8 * 6 * 5 * 4);
}

TEST_CASE("a ball stands in the mouth of a pocket up to the capture circle, and falls when it is pushed on") {
  int standing = 0, fell = 0;
  for (const std::string& table : tables()) {
    const ShotRequest open = read_shot(shot(scene(table, in_the_open, {0.4, 0.4})));
    const Boundary boundary(open.table, open.ball.body);
    for (const Circle& pocket : boundary.pockets) {
      const Vec2d middle{0.5 * (open.table.lowest().x + open.table.highest().x), pocket.centre.y > 0.5 ? 0.4 : 0.9};
      const bool corner = std::abs(pocket.centre.x - middle.x) > 0.1;
      const Vec2d in = corner ? Vec2d{pocket.centre.x < middle.x ? 1.0 : -1.0, pocket.centre.y < 0.5 ? 1.0 : -1.0}
                              : Vec2d{0, pocket.centre.y < 0.5 ? 1.0 : -1.0};
      for (const double away : {1.0001, 1.05}) {
        ShotRequest pushed = open;
        pushed.others[0].at = pocket.centre + in / norm(in) * (away * pocket.radius);
        if (boundary.clearance(pushed.others[0].at) < 0) continue;  // a circle behind the cushions
        INFO(table << ", " << contact_name(open.table, pocket.contact) << ", " << away);
        REQUIRE_NOTHROW(validate(pushed));
        ++standing;
        std::swap(pushed.ball.at, pushed.others[0].at);
        pushed.launch = {1, wrap_angle(std::atan2(-in.y, -in.x))};
        const Trajectory t = simulate(pushed);
        CHECK(t.end == EventKind::pocket);
        fell += t.end == EventKind::pocket;
      }
    }
  }
  CHECK(standing > 60);
  CHECK(fell == standing);
}

TEST_CASE("balls that stood behind a pocket are refused, as a point pocket never is") {
  const auto eight = refusal(read_shot, shot(scene(R"("pool-9ft")", in_the_open, {0, 0})));
  REQUIRE(eight);
  CHECK(eight->reason == "ball 8 lies in pocket bottom-left");
  const auto round =
      refusal(read_shot, shot(scene(R"({"preset": "pool-9ft", "jaws": false})", in_the_open, {.03, .03})));
  REQUIRE(round);
  CHECK(round->reason == "ball 8 lies in pocket bottom-left");
  CHECK(!refusal(read_shot, R"({"table": {"length": 2, "width": 1, "pockets": [{"name": "hole", "at": [1, 0.5],
    "radius": 0}]}, "physics": "ideal", "ball": {"at": [1, 0.5], "radius": 0}, "shot": {"speed": 1, "angle": 10}})"));
}
