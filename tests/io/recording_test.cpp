// SPDX-License-Identifier: MIT
//
// Reading recordings: an impossible sample is reported by its number.
#include "bankshot/scene/recording.hpp"

#include <fmt/format.h>

#include <cmath>

#include "bankshot/simulate/camera.hpp"
#include "support/catch.hpp"

namespace {

using namespace bankshot;

/// Returns 40 samples of a ball that rolls along x at 1 m/s, one of them changed.
std::string line(int which = -1, const std::string& sample = "", const std::string& more = "") {
  std::string track;
  for (int i = 0; i < 40; ++i)
    track += (i ? "," : "") + (i == which ? sample : fmt::format("[{}, {}, 0.5]", 0.02 * i, 0.5 + 0.02 * i));
  return fmt::format(R"({{"table": "carom-10ft", "ball": {{"at": [0.5, 0.5]}}, "track": {{"cue": [{}]}}{}}})", track,
                     more);
}

std::string complaint(const std::string& text) {
  try {
    read_recording(text);
  } catch (const InvalidInput& e) {
    return e.path + ' ' + e.what();
  }
  return "read";
}

TEST_CASE("a recording is read as it stands") {
  const Recording r =
      read_recording(line(-1, "", R"(, "rest": {"cue": [2.1, 0.5]}, "sigma": 0.001, "cushions": ["top"])"));
  REQUIRE(r.tracks.size() == 1);
  CHECK(r.tracks[0].samples.size() == 40);
  CHECK(r.tracks[0].samples[3].at.x == Approx(0.56));
  CHECK(r.tracks[0].rest == Vec2d{2.1, 0.5});
  CHECK(r.sigma == 0.001);
  REQUIRE(r.cushions);
  CHECK(*r.cushions == std::vector{Contact::rail(2)});
  CHECK_FALSE(r.launch_given);
}

TEST_CASE("what no camera sees of one shot is told with its sample") {
  using Catch::StartsWith;
  CHECK_THAT(complaint(line(7, "[0.1, 0.62, 0.5]")),
             StartsWith("/track/cue/7 [0.1,0.62,0.5] must be later than the sample before it"));
  CHECK_THAT(complaint(line(7, "[0.14, 0.64]")), StartsWith("/track/cue/7 [0.14,0.64] must be [t, x, y]"));
  CHECK_THAT(complaint(line(7, "[0.14, \"a\", 0.5]")), StartsWith("/track/cue/7/1"));
  CHECK(complaint(line(7, "[0.14, 1.9, 1.2]")) == "read");  // a single one is an outlier
  CHECK(complaint(line(7, "[0.14, 5, 0.5]")) == "read");
  CHECK_THAT(complaint(R"({"table": "carom-10ft", "ball": {"at": [0.5, 0.5]}, "track": {"red": []}})"),
             StartsWith("/track/red [] is of no ball of this scene"));
  CHECK_THAT(complaint(R"({"table": "carom-10ft", "ball": {"at": [0.5, 0.5]}})"),
             Catch::EndsWith("must have one of the keys \"track\", \"rest\""));
  CHECK_THAT(complaint(line().substr(0, 200)), StartsWith(" not JSON: unexpected end of input"));
}

TEST_CASE("a ball that jumps, leaves the table or is struck twice is told with its sample") {
  const auto changed = [](auto&& where) {
    Recording r = read_recording(line());
    std::vector<Sample>& s = r.tracks[0].samples;
    for (std::size_t i = 0; i < s.size(); ++i) s[i].at = where(static_cast<double>(i), s[i].at);
    return complaint(write_recording(r));
  };
  using Catch::StartsWith;
  CHECK_THAT(changed([](double i, Vec2d at) {
               return i < 20 ? at : at + Vec2d{0.9, 0.6};
             }),
             Catch::Contains("is farther from those before it than a ball can go") && StartsWith("/track/cue/20 "));
  CHECK_THAT(changed([](double i, Vec2d at) {
               return i < 30 ? at : Vec2d{at.x, 0.5 - 0.04 * (i - 15)};
             }),
             Catch::Contains("is off the table") && StartsWith("/track/cue/30 "));
  Recording r = read_recording(line());
  std::vector<Sample>& s = r.tracks[0].samples;
  for (int i = 0; i < 60; ++i) s.push_back({0.8 + 0.02 * i, {1.28, 0.5}});
  CHECK(complaint(write_recording(r)) == "read");
  for (int i = 0; i < 20; ++i) s.push_back({2 + 0.02 * i, {1.28 - 0.03 * i, 0.5}});
  CHECK_THAT(complaint(write_recording(r)), StartsWith("/track/cue/10"));
  CHECK_THAT(complaint(write_recording(r)), Catch::EndsWith("this is a second shot"));
}

TEST_CASE("a filmed shot reads back as it was written") {
  ShotRequest shot;
  shot.table = make_table(*find_table_preset("pool-9ft"));
  shot.ball.at = {0.6, 0.4};
  shot.physics = spin_physics(shot.ball.body);
  shot.launch = {2, 1};
  Random random(3);
  const Recording r = film(shot, simulate(shot), {.rate = 100, .noise = 1e-3, .drop = 0.2}, random);
  REQUIRE(r.tracks.size() == 1);
  const Recording again = read_recording(write_recording(r));
  REQUIRE(again.tracks.size() == 1);
  REQUIRE(again.tracks[0].samples.size() == r.tracks[0].samples.size());
  for (std::size_t i = 0; i < r.tracks[0].samples.size(); ++i) {
    CHECK(again.tracks[0].samples[i].time == r.tracks[0].samples[i].time);
    CHECK(again.tracks[0].samples[i].at == r.tracks[0].samples[i].at);
  }
  CHECK(again.tracks[0].rest == r.tracks[0].rest);
  CHECK(again.scene.ball.at == r.scene.ball.at);
}

}  // namespace
