// SPDX-License-Identifier: MIT
#include "io/answer/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "io/answer/launch_words.hpp"
#include "sim/plan/played.hpp"

namespace bankshot {
namespace {

/// Returns a distance as text; none if it is exact.
std::optional<std::string> inexact_words(double metres, const Table& table) {
  std::string words = distance_words(metres, table);
  return words == "exact" ? std::nullopt : std::optional(std::move(words));
}

/// Returns the nearest of D. Alciatore's names for the fullness of a hit.
std::string_view fullness_words(double full) {
  constexpr double whole = 0.985;  // shown as 99 % or more
  if (full > 7.0 / 8 && full < whole) return "nearly full hit";
  constexpr std::string_view names[] = {"thin hit", "1/4-ball hit", "half-ball hit", "3/4-ball hit", "full hit"};
  return names[static_cast<std::size_t>(std::lround(4 * std::clamp(full, 0.0, 1.0)))];
}

/// Describes a hit. `by` is the number of the hitting ball; 0 is the cue ball.
std::string hit_words(const Puzzle& p, const Hit& hit, int by = 0) {
  const double cut = degrees(hit.cut), full = std::clamp(fullness(p, hit, by), 0.0, 1.0);
  constexpr double none = 0.05;  // degrees; not visible to a player
  return fmt::format("{}, {} ({:.0f} %)", contact_name(p, Contact::ball(hit.ball)), fullness_words(full), 100 * full) +
         (std::abs(cut) < none
              ? ""
              : fmt::format(", cutting it {:.1f} degrees to the {}", std::abs(cut), cut > 0 ? "left" : "right"));
}

std::string arrival_words(const Puzzle& p, const Shot& s) {
  const auto [time, speed, at] = s.path.arrival;
  const std::string who = s.path.then.empty() ? "" : contact_name(p, Contact::ball(s.arriving())) + " ";
  if (const Pocket* pocket = pocket_reached(p, s)) {
    const State<double> end = state_on_arrival(p, s);
    return fmt::format("{}falls into {} after {:.2f} s at {:.2f} m/s, {}", who, pocket->name, time, speed,
                       speed > 0 ? beside_words(end.at, end.velocity, pocket->place()) : "at its rim");
  }
  if (!s.path.hits.empty() && s.path.then.empty())
    return fmt::format("meets {}, after {:.2f} s at {:.2f} m/s", hit_words(p, s.path.hits.back()), time, speed);
  const auto off = inexact_words(s.verification.miss, p.table);
  const std::string where = off ? *off + " off" : speed == 0 ? "exactly on" : "exactly over";
  return speed == 0 ? fmt::format("{}rests {} the point after {:.2f} s", who, where, time)
                    : fmt::format("{}passes {} the point after {:.2f} s at {:.2f} m/s", who, where, time, speed);
}

/// Describes one side of a margin: "up to 0.4 m/s slower", "any amount faster", "not slower".
std::string side_of_margin(const std::optional<double>& by, double unit, std::string_view unit_words,
                           std::string_view way) {
  constexpr double least = 1e-6;  // degrees or m/s; finer than any player
  if (!by) return fmt::format("any amount {}", way);
  const double most = std::abs(*by) * unit;
  return most < least ? fmt::format("not {}", way) : fmt::format("up to {:.3g} {} {}", most, unit_words, way);
}

/// Returns the margin without an upper limit of the speed if the limit is faster than every allowed launch.
Margin playable(const Puzzle& p, const Shot& s) {
  Margin m = *s.robustness.margin;
  if (m.speed[1] && s.launch.speed + *m.speed[1] > std::max(p.speed.high, Puzzle{}.speed.high)) m.speed[1].reset();
  return m;
}

std::vector<Row> margin_rows(const Margin& m) {
  const auto none = [](const auto& ends) { return !ends[0] && !ends[1]; };
  const auto both = [](const auto& ends, double unit, std::string_view words, std::string_view less,
                       std::string_view more) {
    return side_of_margin(ends[0], unit, words, less) + ", " + side_of_margin(ends[1], unit, words, more);
  };
  return {{"margin",
           none(m.angle) ? "any aim makes it" : both(m.angle, degrees(1), "degrees", "to the right", "to the left")},
          {"", none(m.speed) ? "any speed makes it" : both(m.speed, 1, "m/s", "slower", "faster")}};
}

std::string cushion_names(const Table& table, const std::vector<Contact>& cushions) {
  constexpr std::size_t most_named = 12;
  std::string names;
  for (std::size_t i = 0; i < std::min(most_named, cushions.size()); ++i)
    names += (i ? ", " : "") + contact_name(table, cushions[i]);
  if (cushions.size() > most_named) names += fmt::format(" and {} more", cushions.size() - most_named);
  return names;
}

}  // namespace

std::string distance_words(double metres, const Table& table) {
  constexpr double exact = 1e-6, mm = 1e-3;
  if (metres <= exact * table.diagonal()) return "exact";
  if (metres >= 1) return fmt::format("{:.2f} m", metres);
  return metres < 10 * mm ? fmt::format("{:.2g} mm", metres / mm) : fmt::format("{:.0f} mm", metres / mm);
}

std::string percent_words(double probability) {
  constexpr double nearly = 0.995, hardly = 0.005;
  if (probability >= nearly) return "over 99 %";
  if (probability <= hardly) return probability > 0 ? "under 1 %" : "0 %";
  return fmt::format("{:.0f} %", 100 * probability);
}

std::string success_words(const Shot& shot) {
  const double success = *shot.robustness.success;
  const auto fails = [](const auto& sides) { return sides[0] || sides[1]; };
  const bool may_fail = success < 1 || (shot.robustness.margin &&
                                        (fails(shot.robustness.margin->angle) || fails(shot.robustness.margin->speed)));
  return may_fail ? percent_words(success) : "100 %";
}

std::string place_words(const Table& table, const Vec2d& at) {
  const Vec2d low = table.lowest(), high = table.highest();
  if (!table.is_rectangle()) return fmt::format("at x = {:.2f} m, y = {:.2f} m", at.x, at.y);
  const auto from = [](double down, double up, std::string_view first, std::string_view last) {
    return fmt::format("{:.2f} m from the {} rail", std::min(down, up), down <= up ? first : last);
  };
  return from(at.x - low.x, high.x - at.x, "left", "right") + ", " + from(at.y - low.y, high.y - at.y, "bottom", "top");
}

std::string nearest_words(const Answer::Nearest& nearest, const Table& table) {
  const Launch& l = nearest.shot.launch;
  const auto off = inexact_words(nearest.shot.verification.miss, table);
  return fmt::format("{:.2f} degrees at {:.2f} m/s: {}; it {}", degrees(l.angle), l.speed,
                     off ? *off + " off" : "right on the target", nearest.why);
}

namespace {

bool is_carom(const Shot& shot) { return shot.path.then.empty() && shot.path.hits.size() > 1; }

/// Returns the cue ball's cushions before and after the first ball of a carom. For other shots, the first list holds
/// all cushions and the second is empty.
std::array<std::vector<Contact>, 2> around_first_ball(const Shot& shot) {
  const auto& all = shot.path.cushions;
  const auto split = is_carom(shot) ? all.begin() + shot.path.hits.front().after : all.end();
  return {std::vector<Contact>{all.begin(), split}, {split, all.end()}};
}

std::string cushion_words(const Puzzle& p, const Shot& shot) {
  const auto named = [&](const std::vector<Contact>& cushions) {
    return cushions.empty() ? "none" : cushion_names(p.table, cushions);
  };
  const auto [first, then] = around_first_ball(shot);
  if (!is_carom(shot)) return named(first);
  return fmt::format("{}; off {}: {}", named(first), contact_name(p, Contact::ball(shot.path.hits.front().ball)),
                     named(then));
}

/// Returns what the shot does to other balls, followed by `aim`.
std::string target_of(const Puzzle& p, const Shot& shot, const std::string& aim) {
  const auto name = [&](int ball) { return contact_name(p, Contact::ball(ball)); };
  if (shot.path.hits.empty()) return aim;
  if (shot.path.then.empty()) return "onto " + name(shot.path.hits.back().ball);
  std::string to;
  for (const ObjectBallPath& sent : shot.path.then)
    to += (to.empty() ? "to send " : "onto ") + name(sent.ball) + " " +
          (sent.cushions.empty() ? "" : "by " + cushion_names(p.table, sent.cushions) + " ");
  return to + aim;
}

/// Lists the coefficients whose plausible error moves the arrival visibly, the largest effect first.
std::vector<std::string> sensitivity_words(const Puzzle& p, const Shot& shot) {
  struct Step {
    std::string_view in_name;
    double by;
    std::string_view words;
  };
  constexpr Step steps[] = {{"height", 0.001, "1 mm of nose height"},
                            {"tilt.x", 0.001, "1 mm a metre of rise along x"},
                            {"tilt.y", 0.001, "1 mm a metre of rise along y"},
                            {"rolling_friction", 0.001, "0.001 of"},
                            {"frequency_ratio", 0.1, "0.1 of"},
                            {"", 0.01, "0.01 of"}};
  std::vector<std::pair<double, std::string>> lines;
  for (const Sensitivity& s : shot.robustness.sensitivity) {
    const Step& step = *std::ranges::find_if(
        steps, [&](const Step& one) { return s.coefficient.find(one.in_name) != std::string::npos; });
    const auto off = inexact_words(s.by * step.by, p.table);
    if (!off) continue;
    const std::string what =
        step.words.ends_with(" of") ? fmt::format("{} {}", step.words, s.coefficient) : std::string(step.words);
    lines.emplace_back(s.by * step.by, fmt::format("{} moves it by {}", what, *off));
  }
  std::ranges::stable_sort(lines, std::greater(), [](const auto& line) { return line.first; });
  std::vector<std::string> out;
  for (auto& [by, line] : lines) out.push_back(std::move(line));
  return out;
}

}  // namespace

std::string title_words(const Puzzle& p, const Shot& shot) {
  const Pocket* pocket = pocket_reached(p, shot);
  const std::string aim = pocket                        ? "into " + pocket->name
                          : shot.path.arrival.speed > 0 ? "through the ring"
                                                        : "to rest in the ring";
  const std::string to = target_of(p, shot, aim);
  constexpr std::size_t most_named = 5;
  if (shot.path.cushions.size() > most_named) return fmt::format("By {} cushions {}", shot.path.cushions.size(), to);
  const auto [first, then] = around_first_ball(shot);
  const std::string start = first.empty() ? (shot.spin.masse == 0 ? "Straight " : "In a curve ")
                                          : "By " + cushion_names(p.table, first) + " ";
  if (!is_carom(shot)) return start + to;
  return start + "off " + contact_name(p, Contact::ball(shot.path.hits.front().ball)) + " " +
         (then.empty() ? "" : "by " + cushion_names(p.table, then) + " ") + to;
}

namespace {

/// Adds the touched balls with their fullness, and the ghost ball of the first hit.
void add_hits(const Puzzle& p, const Shot& shot, std::vector<Row>& rows) {
  if (is_carom(shot)) rows.push_back({"touches", hit_words(p, shot.path.hits.front())});
  for (std::size_t i = 0; i < shot.path.then.size(); ++i) {
    rows.push_back(
        {i == 0 ? "touches" : "onto", hit_words(p, shot.path.hits[i], i == 0 ? 0 : shot.path.then[i - 1].ball)});
    if (!shot.path.then[i].cushions.empty())
      rows.push_back({"bank", "off " + cushion_names(p.table, shot.path.then[i].cushions)});
  }
  if (!shot.path.hits.empty()) rows.push_back({"ghost", "ball " + place_words(p.table, shot.path.hits.front().at)});
}

constexpr std::string_view next_row = "next";

/// Returns the probability of a leave in words.
std::string leave_words(const Puzzle& p, const ShotLeave& leave) {
  const std::string chance = percent_words(leave.success);
  if (const auto* place = std::get_if<LeavePlace>(&*p.leave))
    return fmt::format("{} to make it and stop within {} of the place", chance, distance_words(place->within, p.table));
  if (std::holds_alternative<LeaveRegion>(*p.leave)) return chance + " to make it and stop inside the region";
  if (const auto* next = std::get_if<LeaveForNext>(&*p.leave)) {
    const bool one = next->order.size() == 1 && next->order.front().size() == 1;
    return fmt::format("{} to make it and then, by an estimate, to pot {}", chance,
                       one ? contact_name(p, Contact::ball(next->order.front().front())) : "the next ball");
  }
  if (std::holds_alternative<LeaveAgainst>(*p.leave)) return chance + " to make it and leave the opponent no pot";
  return chance + " to make it and leave no direct hit";
}

/// Returns whether a shot pots the last ball that is to be potted.
bool pots_last(const Puzzle& p, const Shot& shot) {
  const auto* next = std::get_if<LeaveForNext>(&*p.leave);
  return next && next->order == PottingOrder{{shot.arriving()}};
}

/// Adds the leave of the cue ball, or its scratch.
void add_leave(const Puzzle& p, const Shot& shot, std::vector<Row>& rows) {
  if (shot.path.scratch)
    rows.push_back({scratch_row, "the cue ball falls into " +
                                     (shot.path.scratch_pocket
                                          ? p.table.pockets[static_cast<std::size_t>(*shot.path.scratch_pocket)].name
                                          : std::string("a pocket"))});
  if (!shot.path.cue_rests) return;
  std::string stops = "stops " + place_words(p.table, *shot.path.cue_rests);
  if (p.rest_near) {
    const auto off = inexact_words(norm(*shot.path.cue_rests - *p.rest_near), p.table);
    stops += ", " + (off ? *off + " from" : "exactly") + " where it should be";
  }
  if (shot.leave && shot.leave->miss > 0)
    if (const auto off = inexact_words(shot.leave->miss, p.table)) stops += ", " + *off + " from where it should be";
  if (shot.leave && !shot.leave->cushions.empty()) stops += ", off " + cushion_names(p.table, shot.leave->cushions);
  rows.push_back({"cue ball", stops});
  if (!shot.leave) return;
  if (const auto& next = shot.leave->next)
    rows.push_back(
        {next_row,
         fmt::format("{} into {}, {} from there by an estimate", contact_name(p, Contact::ball(next->ball)),
                     p.table.pockets[static_cast<std::size_t>(next->pocket)].name, percent_words(next->success))});
  if (!pots_last(p, shot)) rows.push_back({"leave", leave_words(p, *shot.leave)});
}

/// Returns a pot in words: "ball "2" into top-left".
std::string pot_words(const Puzzle& p, const Shot& shot) {
  const Pocket* const pocket = pocket_reached(p, shot);
  return contact_name(p, Contact::ball(shot.arriving())) + (pocket ? " into " + pocket->name : "");
}

/// Returns the rows about what is planned after a shot.
std::vector<Row> rows_of(const Plan& plan) {
  std::vector<Row> rows;
  std::string then;
  for (const Plan::Step& step : plan.next)
    then += (then.empty() ? "" : "; ") + pot_words(step.puzzle, step.shot) +
            fmt::format(", {}", percent_words(step.shot.robustness.success.value_or(0)));
  if (!then.empty()) rows.push_back({"then", then});
  if (const std::size_t balls = plan.clears.size(); balls > 1)
    rows.push_back({"clears", fmt::format("{} in {} of visits, by an estimate",
                                          plan.whole ? "the table" : fmt::format("the next {} balls", balls),
                                          percent_words(plan.clears.back()))});
  if (!plan.why.empty()) rows.push_back({"why", plan.why});
  return rows;
}

}  // namespace

std::vector<Row> rows_of(const Puzzle& asked, const Shot& shot, const Plan* plan) {
  std::vector<Row> rows = rows_of(asked, shot);
  if (!plan) return rows;
  if (!plan->next.empty()) std::erase_if(rows, [](const Row& row) { return row.what == next_row; });
  std::ranges::move(rows_of(*plan), std::back_inserter(rows));
  return rows;
}

std::vector<Row> rows_of(const Puzzle& asked, const Shot& shot) {
  const Puzzle p = as_played(asked, shot);
  const ShotRequest r = as_request(p, shot);
  std::vector<Row> rows{{"aim", aim_words(r, shot.path.cushions.empty() ? pocket_reached(p, shot) : nullptr)},
                        {"speed", speed_words(r)}};
  if (asked.in_hand && shot.placed)
    rows.insert(rows.begin(), {"place", "the cue ball " + place_words(p.table, *shot.placed)});
  if (p.ball.body.radius > 0) rows.push_back({"tip", tip_words(r)});
  for (std::string& warning : warnings(p, shot)) rows.push_back({"warning", std::move(warning)});
  rows.push_back(
      {"cushions", cushion_words(p, shot) + (shot.path.touches_jaws ? "; and off the jaws of a pocket" : "")});
  add_hits(p, shot, rows);
  rows.push_back({"arrives", arrival_words(p, shot)});
  add_leave(p, shot, rows);
  if (shot.robustness.success) rows.push_back({"success", success_words(shot) + " for " + player_words(p.noise)});
  if (shot.robustness.margin && shot.path.scratch && !is_ideal(p.physics))
    rows.push_back({"margin", "none, because the cue ball falls into a pocket"});
  else if (shot.robustness.margin)
    for (Row& row : margin_rows(playable(p, shot))) rows.push_back(std::move(row));
  const auto moved = inexact_words(norm(shot.verification.by_angle) * radians(0.1), p.table);
  rows.push_back({"note", moved ? "0.1 degrees of aim moves the arrival by " + *moved
                                : "a small error of aim does not move the arrival"});
  for (const std::string& line : sensitivity_words(p, shot)) rows.push_back({"", line});
  return rows;
}

}  // namespace bankshot
