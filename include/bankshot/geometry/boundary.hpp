// SPDX-License-Identifier: MIT
//
// Where the centre of a ball of radius R can be: the table seen by that ball, made once a scene.
//   walls    each segment moved inwards by R: n·r >= offset
//   tips     each bend with R added to its radius: a corner that points into the table is one
//   pockets  capture circles
//   balls    others that stand on the table: a centre at the touching distance (scene/body.hpp) touches one
//   jaws     of a table with jaws, those of each pocket: a centre beyond a wall's line is between some pocket's jaws,
//            and meets nothing but them
// Each knows which contact it is (contact.hpp).
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
  double offset;  ///< n·r of a centre that touches
  Vec2d along;    ///< unit, the cushion's direction
  double begin;   ///< along·r of the cushion's two ends
  double end;
  Vec2d from, to;  ///< the ends of the line of centres that touch; reversed if none can
  Contact contact{};
};

struct Circle {
  Vec2d centre;
  double radius;
  Contact contact{};
  Contact before{}, after{};  ///< of a tip: the walls that it joins, tangent to both
  Vec2d middle{};             ///< of its extent; 0 where it is whole
  double least = -1;          ///< cosine of half its extent, and a little more
  double extent = -1;         ///< cosine of half its extent

  /// Whether a centre on the circle touches the part that is there.
  template <class N>
  bool covers(const Vec2<N>& at) const {
    return !(dot(middle, at - to<N>(centre)) < N(least) * radius);
  }
};

/// Of one pocket.
struct JawWalls {
  std::array<Circle, 2> tips;
  std::array<Wall, 2> facings;
  bool faced = true;  ///< there are facings
};

struct Boundary {
  std::vector<Wall> walls;  ///< whole rails; where there are jaws a ball meets them only outside `breaks`
  std::vector<Circle> tips;
  std::vector<Circle> pockets;
  std::vector<Circle> balls{};     ///< at rest
  std::vector<JawWalls> jaws{};    ///< in the order of pockets; empty without
  std::vector<RailCushion> own{};  ///< of each wall; empty where no cushion has anything of its own
  Body body;                       ///< of the ball that sees it
  double diagonal = 0;
  double extent = 0;            ///< m; diagonal or largest coordinate: what positions are rounded in units of
  double touch = 0;             ///< m; a centre this far beyond a cushion line still touches it
  bool strictly_convex = true;  ///< every line of a wall bounds the whole table

  /// `others` stand on the table, but for these numbers. Where all move (simulate/many_balls.hpp) there are none.
  Boundary(const Table& table, const Body& body, std::span<const Ball> others = {}, std::span<const int> except = {});

  /// All that balls bounce off and that lies in the open is straight: aims follow from images.
  bool unfolds() const { return unfolds_; }

  /// The line of a contact; null where it has none.
  const Wall* line(Contact contact) const {
    if (contact.kind == ContactKind::rail) return &walls[static_cast<std::size_t>(contact.index)];
    return contact.kind == ContactKind::jaw ? facing(contact) : nullptr;
  }
  /// The rim of a contact that is round; null where it is not, or is no corner that points into the table.
  const Circle* rim(Contact contact) const {
    if (contact.kind == ContactKind::pocket) return &pockets[static_cast<std::size_t>(contact.index)];
    if (contact.kind == ContactKind::jaw) return tip(contact);
    for (const Circle& c : contact.kind == ContactKind::ball ? balls : tips)
      if (c.contact == contact) return &c;
    return nullptr;
  }
  /// What the cushion of a contact has of its own; null where that is nothing.
  const RailCushion* own_cushion(Contact contact) const {
    if (own.empty() || contact.kind != ContactKind::rail) return nullptr;
    const RailCushion& rail = own[static_cast<std::size_t>(contact.index)];
    return rail.any() ? &rail : nullptr;
  }
  /// Unit vector away from a contact, into the table, for a centre at `at`; 0 where there is no such contact.
  template <class T>
  Vec2<T> normal(Contact contact, const Vec2<T>& at) const {
    if (const Wall* const w = line(contact)) return to<T>(w->normal);
    const Circle* const c = rim(contact);
    if (!c) return {T(0), T(0)};
    const Vec2<T> out = at - to<T>(c->centre);
    return out / norm(out);
  }
  /// The pocket between whose jaws a wall is interrupted at this place along it; -1: there the wall is whole.
  int break_at(const Wall& wall, double along) const {
    if (jaws.empty()) return -1;
    for (const Breach& b : breaks_[static_cast<std::size_t>(wall.contact.index)])
      if (along > b.begin && along < b.end) return b.pocket;
    return -1;
  }
  /// The ends of the part of a wall that is whole around this place along it.
  std::pair<double, double> whole_around(const Wall& wall, double along) const {
    std::pair<double, double> out{wall.begin, wall.end};
    for (const Breach& b : breaks_[static_cast<std::size_t>(wall.contact.index)]) {
      if (b.end <= along) out.first = std::max(out.first, b.end);
      if (b.begin >= along) out.second = std::min(out.second, b.begin);
    }
    return out;
  }
  /// The pocket between whose jaws a centre is; -1 where it is on the table.
  template <class N>
  int between_jaws(const Vec2<N>& at) const {
    if (jaws.empty()) return -1;
    for (const Wall& w : walls)
      if (dot(w.normal, at) - N(w.offset) < N(touch))
        if (const int pocket = break_at(w, static_cast<double>(dot(w.along, at))); pocket >= 0) return pocket;
    return -1;
  }
  /// Distance a centre at `at` is inside what cushions leave to it (negative: outside that).
  double clearance(const Vec2d& at) const;
  /// Distance from `point` to the nearest place where the centre can be.
  double distance_to_centres(const Vec2d& point) const;
  /// The pocket in whose capture circle a centre lies; null where there is none. A point pocket holds no ball.
  const Circle* pocket_around(const Vec2d& at) const;
  /// A centre that is at most `most` [m] beyond rails, jaws or vertices, back where it touches them; any other stays.
  Vec2d moved_inside(Vec2d at, double most) const;

 private:
  /// m along a wall.
  struct Breach {
    double begin, end;
    int pocket;
  };
  const Wall* facing(Contact jaw) const;
  const Circle* tip(Contact jaw) const;
  void open(const Table& table, const std::vector<JawPieces>& jaw_pieces);

  std::vector<Segment> segments_;              ///< where they are, not moved
  std::vector<Bend> bends_{};                  ///< the tips of jaws, not moved
  std::vector<Vec2d> outline_;                 ///< the corners of what is inside, up to the bends
  std::vector<std::vector<Breach>> breaks_{};  ///< of each wall
  bool unfolds_ = true;
};

}  // namespace bankshot
