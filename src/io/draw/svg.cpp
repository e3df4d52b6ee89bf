// SPDX-License-Identifier: MIT
#include "bankshot/draw/svg.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/in_hand.hpp"
#include "io/answer/launch_words.hpp"
#include "io/draw/caption.hpp"
#include "io/draw/moving.hpp"
#include "io/draw/path.hpp"
#include "io/draw/table.hpp"

namespace bankshot {
namespace {

using namespace drawing;

constexpr std::size_t most_listed = 16;

/// Returns the line width. Pictures without words are shown small, so their lines are wider.
double line_width(const PictureStyle& style) { return style.words ? 2.6 : 5; }

/// Returns the rows that fit into a picture.
std::vector<Row> caption_rows(std::vector<Row> all, const Trajectory& t) {
  std::erase_if(all, [](const Row& r) {
    return r.what.empty() || r.what == "cushions" || r.what == "margin" || r.what == "note" || r.what == "ghost";
  });
  all.push_back({"dots", fmt::format("one every {:g} s", dot_step(t))});
  return all;
}

/// Draws the balls before the shot.
void draw_standing(Canvas& c, const Puzzle& p) {
  for (const Ball& other : p.others) draw_other(c, other, other.at);
  draw_ball(c, p.ball, p.ball.at);
}

/// Draws the balls before the shot, or moving if the style asks for it.
void draw_balls(Canvas& c, const Puzzle& p, const Shot& shot, const PictureStyle& style) {
  style.moving ? draw_moving(c, as_request(p, shot)) : draw_standing(c, p);
}

/// Draws the object balls and their paths up to where each hits the next. Returns the path of the last.
Trajectory draw_sent(Canvas& c, const ShotRequest& r, const Trajectory& all, const Shot& shot,
                     const PictureStyle& style) {
  Trajectory t;
  for (std::size_t i = 0; i < shot.path.then.size(); ++i) {
    const Ball& ball = ball_of(r, shot.path.then[i].ball);
    t = path_of(all, shot.path.then[i].ball);
    draw_path(c, ball, t, {.colour = colour_of(c, ball), .width = 0.8 * line_width(style), .numbers = false});
    draw_other(c, ball, i + 1 < shot.path.then.size() ? shot.path.hits[i + 1].at : shot.path.arrival.at, 0.6);
  }
  return t;
}

/// Draws the cue ball's path to where it stops or falls, dashed, with a symbol at its end.
void draw_leave(Canvas& c, ShotRequest request, const Shot& shot, const PictureStyle& style) {
  if (!shot.path.cue_rests && !(shot.path.scratch_pocket && !is_ideal(request.physics))) return;
  request.until = {};
  const Trajectory all = simulate(request), whole = path_of(all, 0);
  draw_path(c, request.ball, whole,
            {.colour = c.c.paths[0], .width = 0.6 * line_width(style), .dashed = true, .ghosts = false});
  const Vec2d at = shot.path.cue_rests ? *shot.path.cue_rests : end_of(whole, 0).state.at;
  draw_stop(c, request.ball, at, shot.path.cue_rests.has_value());
}

/// Draws the shots that are planned after the first, in lighter lines, the later ones the fainter.
void draw_plan(Canvas& c, const Plan& plan, const PictureStyle& style) {
  double opacity = 0.5;
  for (const Plan::Step& step : plan.next) {
    ShotRequest r = as_request(step.puzzle, step.shot);
    if (&step != &plan.next.back()) r.until = {};  // up to where the next shot begins
    const Trajectory all = simulate(r);
    const PathStyle thin{.colour = c.c.paths[0],
                         .width = 0.6 * line_width(style),
                         .opacity = opacity,
                         .ghosts = false,
                         .numbers = false};
    draw_path(c, step.puzzle.ball, path_of(all, 0), thin);
    for (const ObjectBallPath& sent : step.shot.path.then) {
      const Ball& ball = ball_of(r, sent.ball);
      PathStyle own = thin;
      own.colour = colour_of(c, ball);
      draw_path(c, ball, path_of(all, sent.ball), own);
    }
    draw_ball(c, step.puzzle.ball, step.shot.path.hits.front().at, opacity);
    constexpr double fainter = 0.7;
    opacity *= fainter;
  }
}

/// Draws one shot, with what is planned after it if `plan` is not null.
void draw_one(Canvas& c, const Puzzle& asked, const Shot& shot, const PictureStyle& style, const Plan* plan) {
  const Puzzle p = as_played(asked, shot);
  const ShotRequest request = as_request(p, shot);
  const Trajectory all = simulate(request), t = path_of(all, 0);
  const Pocket* pocket = pocket_reached(p, shot);
  const auto aim = pocket && shot.path.cushions.empty() && aims_into(request, *pocket)
                       ? std::nullopt
                       : sight(p.table, p.ball.at, direction(shot.launch.angle));
  draw_table(c, style.words, aim);
  draw_band(c, p, shot);
  draw_target(c, p, pocket);
  draw_wanted_leave(c, p);
  if (shot.leave && shot.leave->spread) draw_spread(c, *shot.leave->spread);
  if (aim && style.words) draw_aim(c, p.ball.at, *aim);
  if (plan) draw_plan(c, *plan, style);
  draw_leave(c, request, shot, style);
  draw_path(c, p.ball, t, {.colour = c.c.paths[0], .width = line_width(style), .numbers = style.words});
  if (style.words) draw_dots(c, request, t, c.c.paths[0]);
  draw_ball(c, p.ball, shot.path.then.empty() ? shot.path.arrival.at : shot.path.hits.front().at, 0.6);
  const Trajectory arriving = shot.path.then.empty() ? t : draw_sent(c, request, all, shot, style);
  draw_balls(c, p, shot, style);
  draw_opening(c, p, shot, arriving.events.back().state.velocity);
  if (!style.words) return;
  draw_caption(c, title_words(p, shot), caption_rows(rows_of(p, shot, plan), t), &request);
}

std::string listed(const Puzzle& p, const Shot& s) {
  std::string names;
  for (const Contact cushion : s.path.cushions) names += (names.empty() ? "" : ", ") + contact_name(p.table, cushion);
  return fmt::format("{}: {:.1f}°, {:.2f} m/s{}", names.empty() ? "straight" : names, degrees(s.launch.angle),
                     s.launch.speed, s.robustness.success ? ", success " + success_words(s) : "");
}

/// Draws several shots: the best in front, unlisted ones faint behind.
void draw_all(Canvas& c, const Puzzle& p, const Answer& a, const PictureStyle& style) {
  draw_table(c, style.words);
  draw_target(c, p);
  draw_wanted_leave(c, p);
  std::vector<Entry> list;
  std::vector<Trajectory> paths;
  const auto colour = [&](std::size_t i) { return c.c.paths[i % c.c.paths.size()]; };
  for (const Shot& s : a.shots) paths.push_back(path_of(p, s));
  for (std::size_t i = paths.size(); i-- > 0;)
    draw_path(c, p.ball, paths[i],
              {.colour = colour(i),
               .width = i == 0 ? 3.2 : 1.8,
               .opacity = i >= most_listed ? 0.25
                          : i == 0         ? 1
                                           : 0.85,
               .ghosts = false});
  const std::size_t shown = std::min(most_listed, paths.size());
  for (std::size_t i = shown; i-- > 0;) draw_tag(c, p.ball, paths[i], static_cast<int>(i) + 1, colour(i));
  for (std::size_t i = 0; i < shown; ++i) list.push_back({static_cast<int>(i) + 1, colour(i), listed(p, a.shots[i])});
  draw_balls(c, p, a.shots.front(), style);
  if (!style.words) return;
  draw_list(c,
            fmt::format("{} shots, the best first{}", paths.size(),
                        shown < paths.size() ? fmt::format("; the first {} are listed", shown) : ""),
            list);
}

/// Draws the puzzle, and the nearest miss if there is one.
void draw_none(Canvas& c, const Puzzle& p, const Answer& a, const PictureStyle& style) {
  draw_table(c, style.words);
  draw_target(c, p);
  draw_wanted_leave(c, p);
  std::vector<Row> rows;
  if (a.nearest) {
    const Shot& s = a.nearest->shot;
    draw_path(c, p.ball, path_of(p, s),
              {.colour = c.c.aim, .width = line_width(style), .dashed = true, .numbers = style.words});
    draw_ball(c, p.ball, s.path.arrival.at, 0.4);
    rows.push_back({"nearest", nearest_words(*a.nearest, p.table)});
  }
  draw_standing(c, p);
  if (!style.words || a.message.empty()) return;
  rows.push_back({"why", a.message});
  draw_caption(c, a.nearest ? "No shot; dashed is the nearest miss" : "No shot", rows);
}

/// Says how the cue ball's own path ends.
std::string ending(const Trajectory& t, const Table& table) {
  const Record& end = t.events.back();
  const std::string after = fmt::format(" after {:.2f} s and {:.2f} m", end.time, t.length);
  const auto fell = std::ranges::find(t.events, EventKind::pocket, &Record::kind);
  if (fell != t.events.end()) return "in " + contact_name(table, fell->contact) + after;
  return (t.end == EventKind::rest ? "at rest" : "stopped") + after;
}

/// Says which other balls fall, and where.
std::string fallen(const ShotRequest& r, const Trajectory& t) {
  std::string out;
  for (const Record& e : t.events)
    if (e.kind == EventKind::pocket && e.ball != 0)
      out +=
          fmt::format("{}{} in {}", out.empty() ? "" : ", ", ball_of(r, e.ball).id, contact_name(r.table, e.contact));
  return out;
}

/// Draws the other balls at their start positions, and faintly at their ends.
void draw_others(Canvas& c, const ShotRequest& r, const Trajectory& t, const PictureStyle& style) {
  for (int ball = 1; ball <= static_cast<int>(r.others.size()); ++ball) {
    const Ball& other = ball_of(r, ball);
    const Trajectory own = path_of(t, ball);
    if (own.legs.empty()) continue;
    draw_path(c, other, own,
              {.colour = colour_of(c, other), .width = 0.7 * line_width(style), .ghosts = false, .numbers = false});
    draw_other(c, other, end_of(own, ball).state.at, 0.6);
  }
  if (style.moving) return;
  for (const Ball& other : r.others) draw_other(c, other, other.at);
}

}  // namespace

std::string draw(const ShotRequest& r, const Trajectory& all, const PictureStyle& style) {
  Canvas c(r.table, style);
  const Trajectory t = path_of(all, 0);
  const auto aim = r.launch.speed > 0 ? sight(r.table, r.ball.at, direction(r.launch.angle)) : std::nullopt;
  draw_table(c, style.words, aim);
  if (aim && style.words) draw_aim(c, r.ball.at, *aim);
  draw_others(c, r, all, style);
  draw_path(c, r.ball, t, {.colour = c.c.paths[0], .width = line_width(style), .numbers = style.words});
  if (style.words) draw_dots(c, r, t, c.c.paths[0]);
  draw_ball(c, r.ball, t.events.back().state.at, 0.6);
  style.moving ? draw_moving(c, r) : draw_ball(c, r.ball, r.ball.at);
  const std::string title = fmt::format("{:.2f} m/s at {:.2f} degrees", r.launch.speed, degrees(r.launch.angle));
  if (style.words) {
    std::vector<Row> rows{{"aim", aim_words(r)}, {"speed", speed_words(r)}};
    if (r.ball.body.radius > 0) rows.push_back({"tip", tip_words(r)});
    rows.push_back({"ends", ending(t, r.table)});
    if (const std::string balls = fallen(r, all); !balls.empty()) rows.push_back({"balls", balls});
    rows.push_back({"dots", fmt::format("one every {:g} s", dot_step(t))});
    draw_caption(c, title, rows, &r);
  }
  return c.document(title);
}

std::string draw(const Table& table, const Ball& ball, std::span<const LabelledPath> paths, const PictureStyle& style) {
  Canvas c(table, style);
  draw_table(c, style.words);
  std::vector<Swatch> legend;
  std::string title;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const char* colour = c.c.paths[i % c.c.paths.size()];
    draw_path(c, ball, paths[i].trajectory, {.colour = colour, .width = line_width(style), .numbers = false});
    draw_ball(c, ball, paths[i].trajectory.events.back().state.at, 0.6, colour);
    legend.push_back({paths[i].label, colour});
    title += (title.empty() ? "" : ", ") + paths[i].label;
  }
  draw_ball(c, ball, ball.at);
  if (style.words) draw_legend(c, legend);
  return c.document(title);
}

std::string draw(const Puzzle& asked, const Answer& answer, const PictureStyle& style) {
  const bool in_hand = !answer.shots.empty() && answer.shots.front().placed;
  const Puzzle puzzle = in_hand ? placed(asked, *answer.shots.front().placed) : asked;
  Canvas c(puzzle.table, style);
  if (answer.shots.empty())
    draw_none(c, puzzle, answer, style);
  else if (answer.shots.size() == 1)
    draw_one(c, puzzle, answer.shots.front(), style, answer.plan ? &*answer.plan : nullptr);
  else
    draw_all(c, puzzle, answer, style);
  // A picture of the puzzle alone has an empty answer.
  return c.document(answer.message.empty() ? "The question: " + target_words(puzzle)
                                           : fmt::format("{}: {}", name(answer.status), answer.message));
}

}  // namespace bankshot
