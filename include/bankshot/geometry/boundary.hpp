// SPDX-License-Identifier: MIT
//
// The region where the centre of a ball of radius R can be. It is built once per scene and consists of:
//   walls    each segment moved inwards by R: n·r >= offset
//   tips     each bend with R added to its radius, such as a corner that points into the table
//   pockets  capture circles
//   balls    other balls at rest: a centre at the touching distance (scene/body.hpp) touches one
//   jaws     the jaws of each pocket, if the table has them. A centre beyond a wall's line is between the jaws of some
//            pocket and meets only those, the pocket and other balls.
// Each part stores its contact (contact.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "bankshot/geometry/contact.hpp"
#include "bankshot/geometry/obstacle.hpp"
#include "bankshot/scene/ball.hpp"

namespace bankshot {

struct Wall {
  Vec2d normal;   ///< unit, into the table
  double offset;  ///< n·r of a touching centre
  Vec2d along;    ///< unit, the cushion's direction
  double begin;   ///< `begin` and `end`: along·r of the cushion's two ends
  double end;
  Vec2d from, to;  ///< ends of the line of touching centres; reversed if no centre can touch
  Contact contact{};
};

struct Circle {
  Vec2d centre;
  double radius;
  Contact contact{};
  Contact before{}, after{};  ///< for a tip: the walls that it joins, tangent to both
  Vec2d middle{};             ///< unit vector to the middle of its arc; 0 for a whole circle
  double least = -1;          ///< cosine of half the arc that `covers` tests, enlarged against rounding
  double extent = -1;         ///< cosine of half the exact arc

  /// Returns true if a centre on the circle touches the existing arc.
  template <class N>
  bool covers(const Vec2<N>& at) const {
    return !(dot(middle, at - to<N>(centre)) < N(least) * radius);
  }
};

/// The jaws of one pocket.
struct JawWalls {
  std::array<Circle, 2> tips;
  std::array<Wall, 2> facings;
  bool faced = true;  ///< the jaws have facings
};

struct Boundary {
  std::vector<Wall> walls;  ///< whole rails; with jaws, a ball meets them only outside the breaks
  std::vector<Circle> tips;
  std::vector<Circle> pockets;
  std::vector<Circle> balls{};     ///< other balls, at rest
  std::vector<JawWalls> jaws{};    ///< in the order of pockets; empty if the table has no jaws
  std::vector<RailCushion> own{};  ///< own coefficients of each wall's cushion; empty if no cushion has any
  Body body;                       ///< of the ball for which this boundary was built
  double diagonal = 0;             ///< m; of the table's bounding box
  double extent = 0;               ///< m; diagonal or largest coordinate, the scale of rounding errors of positions
  double touch = 0;                ///< m; a centre this far beyond a cushion line still touches it
  bool strictly_convex = true;     ///< the whole table lies on one side of every wall's line

  /// The balls `others` are at rest on the table, except the numbers in `except`. Simulations in which all balls move
  /// (simulate/many_balls.hpp) pass none.
  Boundary(const Table& table, const Body& body, std::span<const Ball> others = {}, std::span<const int> except = {});

  /// Returns true if every obstacle is straight, pocket jaws aside. Aims then follow from mirror images.
  bool unfolds() const { return unfolds_; }

  /// Returns the line of a contact; null if it has none.
  const Wall* line(Contact contact) const {
    if (contact.kind == ContactKind::rail) return &walls[static_cast<std::size_t>(contact.index)];
    return contact.kind == ContactKind::jaw ? facing(contact) : nullptr;
  }
  /// Returns the rim of a round contact; null for a straight one and for a corner that does not point into the table.
  const Circle* rim(Contact contact) const {
    if (contact.kind == ContactKind::pocket) return &pockets[static_cast<std::size_t>(contact.index)];
    if (contact.kind == ContactKind::jaw) return tip(contact);
    for (const Circle& c : contact.kind == ContactKind::ball ? balls : tips)
      if (c.contact == contact) return &c;
    return nullptr;
  }
  /// Returns the own coefficients of a contact's cushion; null if it has none.
  const RailCushion* own_cushion(Contact contact) const {
    if (own.empty() || contact.kind != ContactKind::rail) return nullptr;
    const RailCushion& rail = own[static_cast<std::size_t>(contact.index)];
    return rail.any() ? &rail : nullptr;
  }
  /// Returns the unit vector away from a contact, into the table, for a centre at `at`; 0 if there is no such contact.
  template <class T>
  Vec2<T> normal(Contact contact, const Vec2<T>& at) const {
    if (const Wall* const w = line(contact)) return to<T>(w->normal);
    const Circle* const c = rim(contact);
    if (!c) return {T(0), T(0)};
    const Vec2<T> out = at - to<T>(c->centre);
    return out / norm(out);
  }
  /// Returns the pocket whose mouth interrupts a wall at this place along it; -1 if the wall is whole there.
  int break_at(const Wall& wall, double along) const {
    if (jaws.empty()) return -1;
    for (const Breach& b : breaks_[static_cast<std::size_t>(wall.contact.index)])
      if (along > b.begin && along < b.end) return b.pocket;
    return -1;
  }
  /// Returns the ends of the uninterrupted part of a wall around this place along it.
  std::pair<double, double> whole_around(const Wall& wall, double along) const {
    std::pair<double, double> out{wall.begin, wall.end};
    for (const Breach& b : breaks_[static_cast<std::size_t>(wall.contact.index)]) {
      if (b.end <= along) out.first = std::max(out.first, b.end);
      if (b.begin >= along) out.second = std::min(out.second, b.begin);
    }
    return out;
  }
  /// Returns the pocket between whose jaws a centre lies; -1 if it is on the table.
  template <class N>
  int between_jaws(const Vec2<N>& at) const {
    if (jaws.empty()) return -1;
    for (const Wall& w : walls)
      if (dot(w.normal, at) - N(w.offset) < N(touch))
        if (const int pocket = break_at(w, static_cast<double>(dot(w.along, at))); pocket >= 0) return pocket;
    return -1;
  }
  /// Returns the signed distance [m] from a ball's edge, its centre at `at`, to the nearest cushion; negative if it
  /// overlaps a cushion or is off the table.
  double clearance(const Vec2d& at) const;
  /// Returns the distance [m] from `point` to the nearest possible position of the centre.
  double distance_to_centres(const Vec2d& point) const;
  /// Returns the pocket in whose capture circle a centre lies, or null. Point pockets are ignored.
  const Circle* pocket_around(const Vec2d& at) const;
  /// Moves a centre that is at most `most` [m] beyond rails, jaws or vertices back to touch them; any other stays.
  Vec2d moved_inside(Vec2d at, double most) const;

 private:
  /// An interruption of a wall by a pocket's mouth [m along the wall].
  struct Breach {
    double begin, end;
    int pocket;
  };
  const Wall* facing(Contact jaw) const;
  const Circle* tip(Contact jaw) const;
  void open(const Table& table, const std::vector<JawPieces>& jaw_pieces);

  std::vector<Segment> segments_;              ///< nose lines, not moved by R
  std::vector<Bend> bends_{};                  ///< tips of jaws, not moved by R
  std::vector<Vec2d> outline_;                 ///< corners of the inside; bends are cut short
  std::vector<std::vector<Breach>> breaks_{};  ///< for each wall
  bool unfolds_ = true;
};

}  // namespace bankshot
