// SPDX-License-Identifier: MIT
#include "sim/scene/validate_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/geometry/opening.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot::validation {
namespace {

std::string show(const Vec2d& p) { return fmt::format("[{}, {}]", p.x, p.y); }

/// Checks that a point is finite. `path` is a function, so that the path is built only for an error.
void need_point(const Vec2d& p, auto&& path) {
  if (std::isfinite(p.x) && std::isfinite(p.y)) return;
  need_finite(p.x, path() + "/0");
  need_finite(p.y, path() + "/1");
}

bool segments_meet(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const auto side = [](Vec2d p, Vec2d q, Vec2d r) {
    const double s = cross(q - p, r - p);
    return (s > 0) - (s < 0);
  };
  const auto between = [](Vec2d p, Vec2d q, Vec2d r) { return dot(r - p, r - q) <= 0; };
  const int abc = side(a, b, c), abd = side(a, b, d), cda = side(c, d, a), cdb = side(c, d, b);
  if (abc != abd && cda != cdb) return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) || (cda == 0 && between(c, d, a)) ||
         (cdb == 0 && between(c, d, b));
}

void check_shape(const Table& t) {
  const auto& v = t.vertices;
  const std::size_t n = v.size();
  if (n < 3) fail("/table/vertices", fmt::format("a polygon needs at least 3 vertices, not {}", n));
  for (std::size_t i = 0; i < n; ++i) need_point(v[i], [&] { return at("/table/vertices", i); });
  if (!(std::isfinite(t.diagonal()) && t.diagonal() > 0))
    fail("/table", "the table is too small or too large to compute with");
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2d a = v[i], b = v[(i + 1) % n], c = v[(i + 2) % n];
    if (a == b) fail(at("/table/vertices", i), "this edge has length zero: the next vertex is the same");
    area += cross(a - v[0], b - v[0]);
    if (cross(b - a, c - b) == 0 && dot(b - a, c - b) < 0)
      fail(at("/table/vertices", (i + 1) % n), "the outline turns back on itself here");
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if (!(i == 0 && j == n - 1) && segments_meet(v[i], v[i + 1], v[j], v[(j + 1) % n]))
        fail(at("/table/vertices", j), fmt::format("edge {} crosses or touches edge {}", j, i));
  if (!(area > 0)) fail("/table/vertices", "the vertices must run anticlockwise");
}

/// Returns the index of the first name that occurs earlier in the list, too.
std::optional<std::size_t> second_of_a_name(const std::vector<std::string_view>& names) {
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (names[i] == names[j]) return i;
  return {};
}

void check_names(const Table& t) {
  if (const auto i = second_of_a_name({t.cushions.begin(), t.cushions.end()}))
    fail(at("/table/names", *i), fmt::format("\"{}\" names two cushions", t.cushions[*i]));
  for (const std::string& name : t.cushions) {
    const std::string_view number = std::string_view(name).substr(std::min<std::size_t>(name.size(), 1));
    std::size_t vertex = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), vertex);
    if (name.starts_with('v') && error == std::errc() && vertex < t.vertices.size() &&
        name == "v" + std::to_string(vertex))
      fail("/table/names", fmt::format("\"v{0}\" is the name of vertex {0}", vertex));
  }
  std::vector<std::string_view> pockets{"any"};
  for (const Pocket& p : t.pockets) pockets.push_back(p.name);
  if (const auto i = second_of_a_name(pockets))
    fail(at("/table/pockets", *i - 1) + "/name",
         fmt::format("\"{}\" is taken; names of pockets are unique and not \"any\"", pockets[*i]));
}

/// Checks that some cushion is left between any two mouths.
void check_mouths(const Table& t) {
  std::vector<Break> breaks;
  for (const JawPieces& m : obstacles(t).jaws) breaks.insert(breaks.end(), m.breaks.begin(), m.breaks.end());
  const auto ends_first = [](const Break& x, const Break& y) {
    return std::pair(x.rail, x.begin) < std::pair(y.rail, y.begin);
  };
  std::ranges::sort(breaks, ends_first);
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    const Break &x = breaks[i - 1], &y = breaks[i];
    if (x.rail == y.rail && !(x.end < y.begin))
      fail("/table/jaws", fmt::format("the jaws leave nothing of cushion {} between two pockets",
                                      t.cushions[static_cast<std::size_t>(x.rail)]));
  }
}

void check_pockets(const Table& t, const Boundary& b) {
  check_mouths(t);
  for (std::size_t i = 0; i < t.pockets.size(); ++i) {
    const Pocket& p = t.pockets[i];
    need_point(p.at, [&] { return at("/table/pockets", i) + "/at"; });
    if (p.jaws) {
      const Vec2d way = p.at - p.jaws->at;
      const auto arcs = openings(b, b.pockets[i]);
      const Gap<double> gap = arcs.empty() ? Gap<double>{0, 0} : arcs.front().gap(way / norm(way), 0);
      if (!(gap.low < gap.high))
        fail("/table/mouth", fmt::format("no ball passes between the jaws of pocket \"{}\"", p.name));
      continue;
    }
    const double distance = b.distance_to_centres(p.at);
    const bool point = p.radius == 0 && b.body.radius == 0;
    if (p.radius == 0 && b.body.radius > 0)
      fail(at("/table/pockets", i),
           fmt::format("pocket \"{}\" has radius 0: only a ball of radius 0 can fall into a point", p.name));
    if (point ? distance > tolerance::point_pocket * b.diagonal : distance >= p.radius)
      fail(at("/table/pockets", i),
           fmt::format("no ball can fall into pocket \"{}\": a centre comes no nearer than {:.6g} m, "
                       "and it captures within {:.6g} m",
                       p.name, distance, p.radius));
  }
}

void check_cushion(const CushionVariant& cushion, const Body& body) {
  const double R = body.radius;
  const auto check = [&](const CushionCoefficient& c, double its) {
    if (c.allows(its, R)) return;
    const std::string path = fmt::format("/physics/cushion/{}", c.key());
    if (&c == &cushion_coefficient::height)
      fail(path, fmt::format("the nose of the cushions, {} m over the cloth, must lie between the ball's radius {} m "
                             "and its diameter {} m",
                             its, R, 2 * R));
    if (!std::isfinite(c.high)) fail(path, fmt::format("{} must be at least {}", its, c.low * c.scale(R)));
    fail(path, fmt::format("{} must be between {} and {}", its, c.low * c.scale(R), c.high * c.scale(R)));
  };
  std::visit([&](const auto& law) { for_each_coefficient(law, check); }, cushion);
}

void check_physics(const Physics& physics, const Body& body) {
  const double e = restitution(physics).at_rest;
  if (!(e >= 0 && e <= 1)) fail("/physics/restitution", fmt::format("{} must be between 0 and 1", e));
  if (!carries_spin(physics) && !(std::holds_alternative<Mirror>(physics.cushion) && restitution(physics).constant()))
    fail("/physics/cushion", "without spin a cushion is a mirror of constant restitution");
  if (const auto* m = std::get_if<SlideRoll>(&physics.motion)) {
    if (!(body.radius > 0)) fail("/ball/radius", "0 is a point, which only the physics \"ideal\" and \"rolling\" know");
    if (!(m->sliding_friction >= 0 && std::isfinite(m->sliding_friction * m->g)))
      fail("/physics/sliding_friction", "must be finite and at least 0");
    const double slope = m->rolling_friction.per_speed;
    if (slope > 0 && slope < tolerance::slowest)
      fail("/physics/rolling_friction/per_speed",
           fmt::format("{} s/m is too small to compute with; at least {:g}, or 0", slope, tolerance::slowest));
    if (const auto* own = std::get_if<CustomCushion>(&physics.cushion); own && !own->law)
      fail("/physics/cushion", "a custom cushion needs a law");
    check_cushion(physics.cushion, body);
    const double* const its = cloth_friction(physics.cushion);
    if (its && *its != m->sliding_friction)
      fail("/physics/cushion", fmt::format("the cloth's sliding friction is {} during an impact and {} between two",
                                           *its, m->sliding_friction));
  }
  const Vec2d& tilt = physics.tilt;
  if (!(std::abs(tilt.x) <= 1 && std::abs(tilt.y) <= 1))
    fail("/table/tilt", fmt::format("{} must be between -1 and 1", show(tilt)));
  if (is_ideal(physics) && !is_level(physics))
    fail("/table/tilt", "in the physics \"ideal\" a ball has no weight; \"rolling\" and \"spin\" know one");
  const double a = deceleration(physics);
  if (!(a >= 0 && a <= tolerance::fastest))
    fail("/physics", fmt::format("friction · g is {} m/s² and must be between 0 and {}", a, tolerance::fastest));
}

void check_own_cushions(const Table& table, const Physics& physics) {
  if (table.own.empty()) return;
  if (table.own.size() != table.cushions.size())
    fail("/table/cushions", fmt::format("{} cushions have {} entries", table.cushions.size(), table.own.size()));
  for (std::size_t i = 0; i < table.own.size(); ++i) {
    const RailCushion& rail = table.own[i];
    if (!rail.any()) continue;
    const std::string path = "/table/cushions/" + table.cushions[i];
    if (is_ideal(physics)) fail(path, "in the physics \"ideal\" all cushions are perfect mirrors");
    if (std::holds_alternative<CustomCushion>(physics.cushion)) fail(path, "a custom cushion is the same all around");
    if (rail.restitution) {
      const double e = rail.restitution->at_rest;
      if (!(e >= 0 && e <= 1)) fail(path + "/restitution", fmt::format("{} must be between 0 and 1", e));
      if (!carries_spin(physics) && !rail.restitution->constant())
        fail(path + "/restitution", "must be one number without the physics \"spin\"");
    }
    if (rail.friction && std::holds_alternative<Mirror>(physics.cushion))
      fail(path + "/friction", "a cushion that is a mirror has no friction");
    if (rail.friction && !(*rail.friction >= 0 && std::isfinite(*rail.friction)))
      fail(path + "/friction", fmt::format("{} must be at least 0", *rail.friction));
  }
}

/// Checks a ball's body. `path` is that of the ball.
void check_body(const Body& body, const std::string& path) {
  if (!(body.radius >= 0 && std::isfinite(body.radius)))
    fail(path + "/radius", fmt::format("{} must be at least 0", body.radius));
  if (!(body.mass > 0 && std::isfinite(body.mass)))
    fail(path + "/mass", fmt::format("{} must be greater than 0", body.mass));
  if (!std::isfinite(body.mass * tolerance::fastest * tolerance::fastest))
    fail(path + "/mass", fmt::format("{} kg is too heavy to compute with", body.mass));
}

/// Checks that the ball is on the table and in no pocket.
void check_stands(const Table& table, const Boundary& b, const Ball& ball, const std::string& path) {
  if (const Circle* const pocket = b.pocket_around(ball.at))
    fail(path, fmt::format("ball {} lies in pocket {}", ball.id, contact_name(table, pocket->contact)));
  check_inside(b, ball.at, path, "the centre of the ball");
}

/// Checks that two balls do not overlap. Touching balls are legal.
void check_apart(const Ball& ball, const Ball& other, const std::string& path) {
  const double overlap = touching_distance(ball.body, other.body) - norm(ball.at - other.at);
  if (!(overlap > tolerance::overlap)) return;
  fail(path, fmt::format("ball \"{}\" at {} overlaps ball \"{}\" by {:.6g} m{}", ball.id, show(ball.at), other.id,
                         overlap, overlap <= tolerance::settled_overlap ? "; \"settle\": true moves them apart" : ""));
}

}  // namespace

void fail(const std::string& path, const std::string& reason) { throw InvalidInput(path, reason); }

std::string at(std::string_view list, std::size_t i) { return fmt::format("{}/{}", list, i); }

void need_finite(double v, const std::string& path) {
  if (!std::isfinite(v)) fail(path, fmt::format("{} must be a finite number", v));
}

void check_inside(const Boundary& b, const Vec2d& p, const std::string& path, std::string_view what) {
  need_point(p, [&] { return path; });
  const double clearance = b.clearance(p);
  if (clearance < -b.touch)
    fail(path, fmt::format("{}: {} must be inside the table, at least the ball's radius {} m from "
                           "each cushion; it is {:.6g} m too far out",
                           show(p), what, b.body.radius, -clearance));
}

void check_others(const Table& table, const Boundary& boundary, const Ball& struck, const std::vector<Ball>& others,
                  const Physics& physics) {
  if (others.empty()) return;
  if (!(struck.body.radius > 0)) fail("/ball/radius", "0 is a point, which no other ball can meet");
  if (!rests(physics) && !is_ideal(physics))
    fail("/table/tilt",
         fmt::format("{}: no ball stands on so steep a table, and there are \"others\"", show(physics.tilt)));
  const BallBall& law = physics.ball_ball;
  if (!(law.restitution >= 0 && law.restitution <= 1))
    fail("/physics/ball_ball/restitution", fmt::format("{} must be between 0 and 1", law.restitution));
  const BallFriction& f = law.friction;
  const auto finite = [](double v) { return v >= 0 && std::isfinite(v); };
  if (!(finite(f.fast) && finite(f.fast + f.more) && finite(f.fades)))
    fail("/physics/ball_ball/friction",
         fmt::format("{} + {} exp(-{} slip) must be at least 0", f.fast, f.more, f.fades));
  for (std::size_t i = 0; i < others.size(); ++i) {
    const Ball& ball = others[i];
    const std::string path = at("/others", i);
    const auto before = [&](std::size_t k) -> const Ball& { return k == 0 ? struck : others[k - 1]; };
    for (std::size_t k = 0; k <= i; ++k)
      if (before(k).id == ball.id)
        fail(path + "/id", fmt::format("\"{}\" is taken; names of balls are unique and not \"cue\"", ball.id));
    check_body(ball.body, path);
    if (!(ball.body.radius > 0)) fail(path + "/radius", "0 must be greater than 0");
    check_cushion(physics.cushion, ball.body);
    const std::optional<Boundary> own =
        ball.body == struck.body ? std::nullopt : std::optional(Boundary(table, ball.body));
    check_stands(table, own ? *own : boundary, ball, path + "/at");
    for (std::size_t k = 0; k <= i; ++k) check_apart(ball, before(k), path + "/at");
  }
}

Boundary check_scene(const Table& table, const Ball& ball, const Physics& physics) {
  check_shape(table);
  check_names(table);
  check_body(ball.body, "/ball");
  check_physics(physics, ball.body);
  check_own_cushions(table, physics);
  Boundary boundary(table, ball.body);
  check_pockets(table, boundary);
  check_stands(table, boundary, ball, "/ball/at");
  return boundary;
}

}  // namespace bankshot::validation
