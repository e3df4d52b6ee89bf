// SPDX-License-Identifier: MIT
//
// Single-ball shots computed with pooltool 0.6.0 (github.com/ekiefl/pooltool). It puts the ball 1e-6 m off a cushion at
// each bounce without changing the event's time. Events therefore agree only to about 1e-5 m, and places of rest to
// 2e-5 m.
#include <nlohmann/json.hpp>
#include <sstream>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

using nlohmann::json;
using namespace bankshot;

namespace {

double distance(const Vec2d& p, const json& q) { return norm(p - Vec2d{q[0], q[1]}); }

struct Worst {
  double rest = 0, event = 0;
};

void compare(json line, Worst& worst) {
  const json expect = line["expect"];
  line.erase("expect");
  const ShotRequest shot = read_shot(line.dump());
  const Trajectory t = simulate(shot);
  std::vector<std::string> names;
  for (const Contact c : t.sequence()) names.push_back(contact_name(shot.table, c));
  INFO(line["id"]);
  REQUIRE(names == expect["cushions"].get<std::vector<std::string>>());
  worst.rest = std::max(worst.rest, distance(t.events.back().state.at, expect["at"]));
  CHECK(t.events.back().time == Approx(expect["rest_time"].get<double>()).margin(5e-4));
  std::vector<Record> events;
  for (const Record& e : t.events)
    if (e.kind == EventKind::cushion || e.kind == EventKind::slide_to_roll) events.push_back(e);
  REQUIRE(events.size() == expect["events"].size());
  for (std::size_t i = 0; i < events.size(); ++i) {
    const json& e = expect["events"][i];
    CHECK((events[i].kind == EventKind::cushion) == (e["type"] == "cushion"));
    worst.event = std::max(worst.event, distance(events[i].state.at, e["at"]));
    CHECK(distance(events[i].state.velocity, e["velocity"]) < 1e-4);
    CHECK(events[i].state.spin.z == Approx(e["spin"][2].get<double>()).margin(5e-3));
  }
}

}  // namespace

TEST_CASE("single-ball shots agree with pooltool") {
  const std::string file = GENERATE("tests/problems/han2005_paths.jsonl", "tests/problems/mirror_paths.jsonl");
  std::istringstream lines(test::read_repository_file(file));
  Worst worst;
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) compare(json::parse(line), worst);
  CHECK(count == 132);
  CHECK(worst.rest <= 2e-5);
  CHECK(worst.event <= 3e-5);
  WARN(file << ": worst place of rest " << worst.rest << " m, worst event " << worst.event << " m");
}
