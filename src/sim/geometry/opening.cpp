// SPDX-License-Identifier: MIT
#include "bankshot/geometry/opening.hpp"

#include <cmath>

#include "bankshot/numbers/tolerances.hpp"

namespace bankshot {
namespace {

/// Adds the crossings of a wall's line of centres with the circle, relative to the circle's centre.
void add_crossings(const Wall& wall, const Circle& circle, double touch, std::vector<Vec2d>& out) {
  const double above = dot(wall.normal, circle.centre) - wall.offset;
  const double half2 = circle.radius * circle.radius - above * above;
  if (!(half2 > 0)) return;
  for (const double half : {std::sqrt(half2), -std::sqrt(half2)}) {
    const Vec2d at = wall.along * half - wall.normal * above;
    const double along = dot(wall.along, circle.centre + at);
    if (along >= wall.begin - touch && along <= wall.end + touch) out.push_back(at);
  }
}

void add_crossings(const Circle& tip, const Circle& circle, std::vector<Vec2d>& out) {
  const Vec2d to_tip = tip.centre - circle.centre;
  const double apart = norm(to_tip);
  if (!(apart > 0)) return;
  const double along = (apart * apart + circle.radius * circle.radius - tip.radius * tip.radius) / (2 * apart);
  const double half2 = circle.radius * circle.radius - along * along;
  if (!(half2 > 0)) return;
  const Vec2d u = to_tip / apart;
  for (const double half : {std::sqrt(half2), -std::sqrt(half2)}) {
    const Vec2d at = u * along + perpendicular(u) * half;
    if (tip.covers(circle.centre + at)) out.push_back(at);
  }
}

const JawWalls* jaws_of(const Boundary& boundary, const Circle& pocket) {
  return boundary.jaws.empty() ? nullptr : &boundary.jaws[static_cast<std::size_t>(pocket.contact.index)];
}

/// Returns a vector from a pocket with jaws towards the table; its length has no meaning.
Vec2d inwards(const JawWalls& jaws) { return jaws.tips[0].middle + jaws.tips[1].middle; }

OpeningTip seen(const Circle& tip, const Circle& pocket) {
  return {tip.centre - pocket.centre, tip.radius, tip.middle, tip.extent};
}

}  // namespace

bool Opening::covers(const Vec2d& ray) const {
  if (whole()) return true;
  if (cross(first, last) > 0) return cross(first, ray) >= 0 && cross(ray, last) >= 0;
  return !(cross(last, ray) > 0 && cross(ray, first) > 0);
}

double Opening::distance(const Vec2d& from_centre) const {
  if (covers(from_centre)) return std::abs(norm(from_centre) - radius);
  return std::min(norm(from_centre - first), norm(from_centre - last));
}

std::vector<Opening> openings(const Boundary& boundary, const Circle& pocket) {
  const Opening whole{pocket.radius};
  if (!(pocket.radius > tolerance::point_pocket * boundary.diagonal)) return {whole};
  std::vector<Vec2d> ends;
  for (const Wall& w : boundary.walls) add_crossings(w, pocket, boundary.touch, ends);
  for (const Circle& tip : boundary.tips) add_crossings(tip, pocket, ends);
  const JawWalls* const jaws = jaws_of(boundary, pocket);
  if (jaws) {
    for (const Circle& tip : jaws->tips) add_crossings(tip, pocket, ends);
    for (std::size_t i = 0; jaws->faced && i < 2; ++i) add_crossings(jaws->facings[i], pocket, boundary.touch, ends);
  }
  std::ranges::sort(ends, {}, [](const Vec2d& v) { return std::atan2(v.y, v.x); });
  std::vector<Opening> out;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Opening piece{pocket.radius, ends[i], ends[(i + 1) % ends.size()]};
    const Vec2d chord = piece.last - piece.first, apex = Vec2d{chord.y, -chord.x};
    if (piece.whole()) continue;
    const Vec2d middle = pocket.centre + apex * (pocket.radius / norm(apex));
    if (boundary.clearance(middle) < 0 || (jaws && dot(middle - pocket.centre, inwards(*jaws)) < 0)) continue;
    if (!out.empty() && out.back().last == piece.first)
      out.back().last = piece.last;
    else
      out.push_back(piece);
  }
  if (out.size() > 1 && out.back().last == out.front().first) {
    out.front().first = out.back().first;
    out.pop_back();
  }
  if (out.empty() && !jaws) return {whole};
  if (jaws)
    for (Opening& o : out) o.tips[0] = seen(jaws->tips[1], pocket), o.tips[1] = seen(jaws->tips[0], pocket);
  return out;
}

}  // namespace bankshot
