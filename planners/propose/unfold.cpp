// SPDX-License-Identifier: MIT
#include "planners/propose/unfold.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "planners/propose/exact_line.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning {

using namespace settings::unfolding;

namespace {

/// Returns a tolerance of cross products. Sums of coordinates stand for lengths, since a root would cost too much here.
double slack(const Vec2d& a, const Vec2d& b) {
  return ray_slack * (std::abs(a.x) + std::abs(a.y)) * (std::abs(b.x) + std::abs(b.y));
}

/// Returns whether `ray` lies in the beam from `a` anticlockwise to `b` (less than half a turn wide).
bool in_beam(const Vec2d& a, const Vec2d& b, const Vec2d& ray) {
  return cross(a, ray) >= -slack(a, ray) && cross(ray, b) >= -slack(b, ray) && (dot(a, ray) > 0 || dot(b, ray) > 0);
}

/// Returns the angle anticlockwise from `a` to `b`, in (−π, π].
double angle_between(const Vec2d& a, const Vec2d& b) { return std::atan2(cross(a, b), dot(a, b)); }

double walls_apart(const Boundary& b, int i, int j) {
  const Wall &p = b.walls[static_cast<std::size_t>(i)], &r = b.walls[static_cast<std::size_t>(j)];
  const auto apart = [](const Vec2d& at, const Wall& w) {
    const Vec2d d = w.to - w.from;
    return norm(at - w.from - d * std::clamp(dot(at - w.from, d) / dot(d, d), 0.0, 1.0));
  };
  return std::min({apart(p.from, r), apart(p.to, r), apart(r.from, p), apart(r.to, p)});
}

}  // namespace

Unfolding::Unfolding(const SearchRequest& request, const Options& options)
    : request_(request),
      options_(options),
      longest_(request.speed.high * request.speed.high / (2 * least_deceleration(request.puzzle().physics))) {
  for (int i = 0; i < static_cast<int>(request.problem->boundary.walls.size()); ++i)
    mirrors_ = mirrors_ && restitution_of(i) == 1;
  const CushionRule& rule = request.cushions();
  const long images = 2L * (rule.max + 1L) * (rule.max + 1L) - 2L * rule.min * rule.min;
  if (request.route)
    follow_route();
  else if (request.puzzle().table.is_rectangle() && mirrors_ && !options.keep_routes && images <= most_images)
    lattice();
  else
    add({});
}

std::optional<Image> Unfolding::next() {
  while (!turns_.empty() && (candidates_.empty() || turns_.top().distance < candidates_.top().distance)) {
    const std::size_t nearest = turns_.top().node;
    turns_.pop();
    if (++visited_ > most_images) {
      whole_ = false;
      turns_ = {};
      break;
    }
    visit(nodes_[nearest]);
  }
  if (candidates_.empty()) return {};
  Image c = candidates_.top();
  candidates_.pop();
  c.angle = wrap_angle(std::atan2(c.ray.y, c.ray.x));
  return c;
}

void Unfolding::add(const Node& node) {
  nodes_.push_back(node);
  nodes_.back().self = static_cast<int>(nodes_.size()) - 1;
  turns_.push({node.distance, nodes_.size() - 1});
}

Route Unfolding::route(const Image& c) const {
  if (request_.route) return *request_.route;
  Route out;
  for (int i = c.node; i >= 0 && nodes_[static_cast<std::size_t>(i)].last >= 0;
       i = nodes_[static_cast<std::size_t>(i)].parent)
    out.push_back(
        {0,
         request_.problem->boundary.walls[static_cast<std::size_t>(nodes_[static_cast<std::size_t>(i)].last)].contact});
  std::reverse(out.begin(), out.end());
  return out;
}

void Unfolding::visit(Node node) {
  const CushionRule& rule = request_.cushions();
  if (node.bounces >= rule.min) propose(node);
  if (node.bounces == rule.max) return;
  for (int wall = 0; wall < static_cast<int>(request_.problem->boundary.walls.size()); ++wall)
    if (auto next = restitution_of(wall) == 0 ? std::nullopt : child(node, wall)) {
      if (next->length <= longest_)
        add(*next);
      else
        ++too_long_;
    }
}

void Unfolding::propose(const Node& node) {
  for (std::size_t i = 0; i < request_.problem->aim_points.size(); ++i)
    if (const auto c = candidate(node, i)) candidates_.push(*c);
}

std::optional<Image> Unfolding::candidate(const Node& node, std::size_t i) const {
  const AimPoint& aim_point = request_.problem->aim_points[i];
  if (!request_.route && (node.closed || is_beside(node, aim_point))) return {};
  const Vec2d& ball = request_.puzzle().ball.at;
  const Vec2d ray = node.image.apply(on_exact_line(aim_point, node.image, ball)) - ball;
  const double distance = norm(ray);
  if (!(distance > 0) || !std::isfinite(distance)) return {};
  if (request_.problem->in_vertex() && !leads_over_table(ball, ray)) return {};
  if (is_point(aim_point) && !leads_over_table(aim_point.at, -node.image.back(ray))) return {};
  const bool passes = !node.closed && (node.open || in_beam(node.from, node.to, ray));
  Image c{0, node.bounces, std::max(0.0, distance - aim_point.capture()), 0, 0, i, node.self, ray};
  if (!node.closed && !(passes && options_.keep_routes)) find_window(node, aim_point, c);
  const bool only_part = options_.parts && c.low < c.high;
  return passes || only_part || request_.route ? std::optional(c) : std::nullopt;
}

/// Returns whether a pocket captures before a cushion through it is met, so that no path to it ends in a bounce there.
bool Unfolding::is_point(const AimPoint& aim_point) const {
  return aim_point.drops() && aim_point.reach <= tolerance::point_pocket * request_.problem->boundary.diagonal;
}

/// Returns whether a little step from a place leads over the table.
bool Unfolding::leads_over_table(const Vec2d& from, const Vec2d& way) const {
  return request_.problem->boundary.clearance(from + way * (little_way * request_.problem->boundary.diagonal /
                                                            norm(way))) >= -request_.problem->boundary.touch;
}

/// Returns whether no ray of the beam reaches any part of the target, nor an exact line of it. Sums of coordinates
/// stand for lengths.
bool Unfolding::is_beside(const Node& node, const AimPoint& aim_point) const {
  if (node.open) return false;
  const Vec2d middle = node.image.apply(aim_point.at) - request_.puzzle().ball.at;
  const double covers = aim_point.reach * (mirrors_ ? 1 : 2 * node.image.stretch());
  const auto outside = [&](const Vec2d& edge, double across) {
    return across < -covers * (std::abs(edge.x) + std::abs(edge.y)) - slack(edge, middle);
  };
  return outside(node.from, cross(node.from, middle)) || outside(node.to, cross(middle, node.to));
}

/// Finds the aims beside a candidate's that are in the beam and may reach some part of the target.
void Unfolding::find_window(const Node& node, const AimPoint& aim_point, Image& c) const {
  const Vec2d middle = node.image.apply(aim_point.at) - request_.puzzle().ball.at;
  const double distance = norm(middle);
  // Twice the mean stretch bounds the largest one, so this bounds the image of the target.
  const double covers = aim_point.reach * (mirrors_ ? 1 : 2 * node.image.stretch()) / distance;
  const double half = covers < 1 ? std::asin(covers) : radians(180),
               turned = c.ray == middle ? 0 : angle_between(c.ray, middle);
  double low = -half, high = half;
  if (!node.open && half < radians(90)) {
    // The centre's ray may leave the beam while part of the target is still inside.
    const double begin = angle_between(middle, node.from), end = begin + angle_between(node.from, node.to);
    low = high = 0;
    for (const double turn : {0.0, radians(-360)}) {
      const double from = std::max(-half, begin + turn), to = std::min(half, end + turn);
      if (from < to) low = from, high = to;
    }
  }
  if (low < high) c.low = turned + low, c.high = turned + high;
}

Affine Unfolding::through(const Affine& image, int wall) const {
  const Wall& w = request_.problem->boundary.walls[static_cast<std::size_t>(wall)];
  const double k = 1 + 1 / restitution_of(wall);
  const Vec2d n = w.normal;
  // image ∘ (x -> x − k (n·x − d) n)
  const double xx = 1 - k * n.x * n.x, xy = -k * n.x * n.y, yy = 1 - k * n.y * n.y;
  Affine out{image.xx * xx + image.xy * xy, image.xx * xy + image.xy * yy, image.yx * xx + image.yy * xy,
             image.yx * xy + image.yy * yy};
  out.shift = image.apply(n * (k * w.offset));
  return out;
}

double Unfolding::restitution_of(int wall) const {
  const RailCushion* const rail = request_.problem->boundary.own_cushion(Contact::rail(wall));
  if (!rail || !rail->restitution) return options_.restitution;
  const double shared = restitution(request_.puzzle().physics).at_rest;
  return rail->restitution->at_rest * (shared > 0 ? options_.restitution / shared : 1);
}

double Unfolding::apart(int i, int j) {
  if (i < 0 || i == j) return 0;
  const std::size_t walls = request_.problem->boundary.walls.size();
  if (apart_.empty()) apart_.assign(walls * walls, -1);
  double& known = apart_[static_cast<std::size_t>(i) * walls + static_cast<std::size_t>(j)];
  if (known < 0) known = walls_apart(request_.problem->boundary, i, j);
  return known;
}

std::optional<Unfolding::Node> Unfolding::child(const Node& node, int wall) {
  if (wall == node.last) return {};
  const auto& walls = request_.problem->boundary.walls;
  const Wall& w = walls[static_cast<std::size_t>(wall)];
  if (node.open && request_.problem->touches(w.contact)) {
    // The ball bounces before it moves, so all aims are left. Between two cushions it comes back to the first only if
    // they meet in an acute angle.
    if (request_.problem->in_vertex()) return {};
    if (wall == node.before && dot(w.normal, walls[static_cast<std::size_t>(node.last)].normal) >= 0) return {};
    return beyond(node, wall);
  }
  if (dot(w.to - w.from, w.along) < 0) return {};  // the ball does not fit there
  if (node.last >= 0) {
    // There is no path beyond the line of the cushion just left.
    const Wall& left = walls[static_cast<std::size_t>(node.last)];
    const double behind = request_.problem->boundary.touch;
    if (dot(left.normal, w.from) - left.offset < behind && dot(left.normal, w.to) - left.offset < behind) return {};
  }
  const Vec2d ball = request_.puzzle().ball.at;
  Vec2d a = node.image.apply(w.from) - ball, b = node.image.apply(w.to) - ball;
  if (node.flipped) std::swap(a, b);
  if (!(cross(a, b) > 0)) return {};  // seen from behind, or edge-on
  Vec2d from = a, to = b;
  if (!node.open) {
    if (in_beam(a, b, node.from)) from = node.from;
    if (in_beam(a, b, node.to)) to = node.to;
    if (!in_beam(node.from, node.to, from) || !in_beam(node.from, node.to, to)) return {};
  }
  Node next = beyond(node, wall);
  next.from = from;
  next.to = to;
  next.open = false;
  next.distance = std::max(node.distance, std::sqrt(square_to_segment({}, a, b)));
  // Neighbouring cushions meet in a corner, so the cushion two back counts as well.
  next.length_before = node.length;
  next.length = std::max(node.length + apart(node.last, wall), node.length_before + apart(node.before, wall));
  if (mirrors_) next.length = std::max(next.length, next.distance);
  return next;
}

Unfolding::Node Unfolding::beyond(const Node& node, int wall) const {
  Node next = node;
  next.image = through(node.image, wall);
  next.bounces = node.bounces + 1;
  next.before = node.last;
  next.last = wall;
  next.parent = node.self;
  next.flipped = !node.flipped;
  return next;
}

void Unfolding::follow_route() {
  Node node;
  for (const Meeting& meeting : *request_.route) {
    const Wall* const line = request_.problem->boundary.line(meeting.with);
    if (!line) return;  // a vertex has no line of reflection
    const auto wall = static_cast<int>(line - request_.problem->boundary.walls.data());
    if (restitution_of(wall) == 0) return;
    std::optional<Node> next;
    if (!node.closed) next = child(node, wall);
    if (!next) {
      next = beyond(node, wall);
      next->closed = true;
    }
    node = *next;
  }
  propose(node);
}

void Unfolding::lattice() {
  const auto& walls = request_.problem->boundary.walls;
  const double x0 = walls[3].from.x, y0 = walls[0].from.y;
  const double width = walls[1].from.x - x0, height = walls[2].from.y - y0;
  // Along one side even images are shifted and odd ones mirrored.
  const auto sign = [](int i) { return i % 2 == 0 ? 1.0 : -1.0; };
  const auto shift = [](int i, double size, double x) { return i % 2 == 0 ? i * size : (i + 1) * size + 2 * x; };
  std::vector<Image> found;
  const auto add = [&](int i, int j, std::size_t k) {
    Node node;
    node.image = {sign(i), 0, 0, sign(j), {shift(i, width, x0), shift(j, height, y0)}};
    node.bounces = std::abs(i) + std::abs(j);
    if (const auto c = candidate(node, k)) found.push_back(*c);
  };
  const CushionRule& rule = request_.cushions();
  for (std::size_t k = 0; k < request_.problem->aim_points.size(); ++k)
    for (int n = rule.min; n <= rule.max; ++n)
      for (int i = -n; i <= n; ++i) {
        const int j = n - std::abs(i);
        add(i, j, k);
        if (j != 0) add(i, -j, k);
      }
  candidates_ = decltype(candidates_){Farther{}, std::move(found)};
}

}  // namespace bankshot::planning
