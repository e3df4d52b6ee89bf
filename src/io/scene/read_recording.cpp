// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/scene/attempt.hpp"
#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "io/format/recording_keys.hpp"
#include "io/json/reader.hpp"
#include "io/scene/read_shot.hpp"
#include "io/scene/write_scene.hpp"

namespace bankshot {
namespace {

using namespace tolerance::recording;

/// Returns the number of the ball with this name.
int ball_named(const Reader& r, const std::string& name, const ShotRequest& scene) {
  std::vector<std::string_view> names{scene.ball.id};
  for (const Ball& other : scene.others) names.push_back(other.id);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) r.fail("is of no ball of this scene" + known_words(name, names));
  return static_cast<int>(found - names.begin());
}

Sample read_sample(const Reader& r) {
  if (!r.is_array() || r.size() != 3) r.fail("must be [t, x, y]");
  const auto numbers = r.items();
  const Vec2d unit = r.units().position;
  return {numbers[0].number(), {numbers[1].number() * unit.x, numbers[2].number() * unit.y}};
}

/// Returns true if a point is beyond the cushions by more than a camera's error.
bool off_table(const Boundary& boundary, const Vec2d& at) { return boundary.clearance(at) < -off_the_table; }

/// Returns true if no ball is fast enough for these two samples.
bool too_far(const Sample& a, const Sample& b) { return norm(b.at - a.at) > jump + fastest_ball * (b.time - a.time); }

/// Checks the samples of a track. A single sample may be anywhere, as an outlier. Two consecutive samples that agree
/// with each other, but not with the earlier ones, are refused.
void check_way(const std::vector<Reader>& places, const std::vector<Sample>& samples, const Boundary& boundary) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i > 0 && !(samples[i].time > samples[i - 1].time))
      places[i].fail(fmt::format("must be later than the sample before it, which is of {} s", samples[i - 1].time));
    if (i + 1 == samples.size()) break;
    const Sample &here = samples[i], &next = samples[i + 1];
    if (off_table(boundary, here.at) && off_table(boundary, next.at))
      places[i].fail("is off the table, and so is the next");
    if (i < 2 || !(next.time > here.time) || too_far(here, next)) continue;
    const Sample &before = samples[i - 1], &first = samples[i - 2];
    if (too_far(before, here) && too_far(before, next) && too_far(first, here) && !too_far(first, before))
      places[i].fail("is farther from those before it than a ball can go; from here on it may be another ball");
  }
}

/// Checks that the ball does not move again after it has come to rest: that would be a second shot.
void check_one_shot(const std::vector<Reader>& places, const std::vector<Sample>& samples) {
  const auto stands = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from + 1; i <= to; ++i)
      if (norm(samples[i].at - samples[from].at) > standing) return false;
    return true;
  };
  bool moved = false, stood = false;
  for (std::size_t i = 0, from = 0; i < samples.size(); ++i) {
    while (samples[i].time - samples[from].time > standing_time) ++from;
    const bool still = i > 0 && samples[i].time - samples[0].time >= standing_time && i - from >= 4 && stands(from, i);
    moved = moved || norm(samples[i].at - samples[0].at) > 10 * standing;
    if (stood && !still && i + 2 < samples.size()) {
      const auto away = [&](std::size_t k) { return norm(samples[k].at - samples[from].at) > 10 * standing; };
      if (away(i) && away(i + 1) && away(i + 2)) places[i].fail("moves again after it stood: this is a second shot");
      continue;
    }
    stood = moved && still;
  }
}

Track read_track(const Reader& r, int ball, const ShotRequest& scene, const Boundary& boundary) {
  Track track{.ball = ball};
  const std::vector<Reader> places = r.items();
  for (const Reader& place : places) track.samples.push_back(read_sample(place));
  if (track.samples.size() < 3) r.fail("must have at least three samples");
  check_way(places, track.samples, boundary);
  if (ball == 0 && scene.others.empty()) check_one_shot(places, track.samples);
  return track;
}

Recording read_recording(const Reader& doc, std::string id) {
  Recording out;
  ShotRequest& s = out.scene;
  doc.only(format::recording);
  s.id = read_id(doc, std::move(id));
  read_setting(doc, s);
  out.launch_given = read_launch(doc, s);
  const Boundary boundary(s.table, s.ball.body);
  // Start positions are measured, too: a ball slightly beyond a cushion is moved back to touch it.
  s.ball.at = boundary.moved_inside(s.ball.at, off_the_table);
  for (Ball& other : s.others) other.at = Boundary(s.table, other.body).moved_inside(other.at, off_the_table);
  validate(s);
  if (const auto v = doc.find("sigma")) out.sigma = v->length(format::recording["sigma"].bounds);
  if (const auto v = doc.find("cushions")) out.cushions = read_sequence(*v, s.table);
  const auto tracks = doc.find("track"), rests = doc.find("rest");
  if (tracks)
    for (const auto& [name, r] : tracks->members())
      out.tracks.push_back(read_track(r, ball_named(r, name, s), s, boundary));
  if (rests)
    for (const auto& [name, r] : rests->members()) {
      const int ball = ball_named(r, name, s);
      auto track = std::ranges::find(out.tracks, ball, &Track::ball);
      if (track == out.tracks.end()) track = out.tracks.insert(track, Track{.ball = ball});
      track->rest = r.point();
      if (off_table(boundary, *track->rest)) r.fail("is off the table");
    }
  std::ranges::sort(out.tracks, {}, &Track::ball);
  return out;
}

/// Returns the table as JSON, by its preset name if possible, because the preset defines the nose height.
Json named_table_json(const ShotRequest& s) {
  for (const TablePreset& preset : table_presets())
    if (is_level(s.physics) && s.table == make_table(preset)) return preset.name;
  return table_json(s.table, s.physics.tilt);
}

}  // namespace

Recording read_recording(std::string_view text) {
  std::string id;
  const Json json = parse_document(text, &id);
  const Units units = read_units(Reader(json));
  const Reader doc(json, "", units);
  Recording out = read_recording(doc, std::move(id));
  if (out.tracks.empty()) doc.fail("must have one of the keys \"track\", \"rest\"");
  return out;
}

Attempt read_attempt(std::string_view text) {
  std::string id;
  const Json json = parse_document(text, &id);
  const Units units = read_units(Reader(json));
  const Reader doc(json, "", units);
  Attempt out{.seen = read_recording(doc, std::move(id))};
  if (doc.find("puzzle")) try {
      out.puzzle = read_puzzle(write_json(json.at("puzzle")));
    } catch (const InvalidInput& e) {
      throw InvalidInput("/puzzle" + e.path, e.what());
    }
  if (const auto v = doc.find("made")) out.made = v->boolean();
  if (!out.seen.launch_given && !out.puzzle) doc.fail("must say what was meant: \"shot\" or \"puzzle\"");
  if (!out.seen.tracks.empty()) return out;
  if (!out.made) doc.fail("must say what happened: \"track\", \"rest\" or \"made\"");
  if (!out.puzzle) doc.fail("must have the \"puzzle\" that was made or missed where no ball was seen");
  return out;
}

std::string write_recording(const Recording& r) {
  const ShotRequest& s = r.scene;
  constexpr const char* models[] = {"ideal", "rolling", "spin"};
  Json j{{"table", named_table_json(s)}, {"physics", models[s.physics.motion.index()]}, {"ball", ball_json(s.ball)}};
  if (!s.others.empty()) j["others"] = others_json(s.others, s.ball.body);
  for (const Track& track : r.tracks) {
    const std::string& id = ball_of(s, track.ball).id;
    for (const Sample& sample : track.samples) j["track"][id].push_back({sample.time, sample.at.x, sample.at.y});
    if (track.rest) j["rest"][id] = pair_json(*track.rest);
  }
  if (r.sigma) j["sigma"] = *r.sigma;
  if (r.cushions)
    for (const Contact c : *r.cushions) j["cushions"].push_back(contact_name(s.table, c));
  if (r.launch_given) j["shot"] = launch_json(s.launch, s.spin);
  return write_json(s.id, j);
}

}  // namespace bankshot
