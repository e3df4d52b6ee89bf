// SPDX-License-Identifier: MIT
//
// Where the centre of a ball of radius R can be: the table seen by that ball, made once a scene.
//   walls    each cushion moved inwards by R: n·r >= offset
//   tips     reflex vertices, which a ball meets as an arc of radius R
//   pockets  capture circles
// A *contact* is a number: i < walls.size() is cushion i, walls.size() + i is vertex i.
#pragma once

#include <string>
#include <vector>

#include "bankshot/scene/table.hpp"

namespace bankshot {

struct Wall {
  Vec2d normal;   ///< unit, into the table
  double offset;  ///< n·r of a centre that touches
  Vec2d along;    ///< unit, the cushion's direction
  double begin;   ///< along·r of the cushion's two ends
  double end;
  Vec2d from, to;  ///< the ends of the line of centres that touch; reversed if none can
};

struct Circle {
  Vec2d centre;
  double radius;
  int contact;  ///< the contact's number (tips), the pocket's number (pockets)
};

struct Boundary {
  std::vector<Wall> walls;
  std::vector<Circle> tips;
  std::vector<Circle> pockets;
  double radius = 0;
  double diagonal = 0;
  double extent = 0;            ///< m; diagonal or largest coordinate: what positions are rounded in units of
  double touch = 0;             ///< m; a centre this far beyond a cushion line still touches it
  bool strictly_convex = true;  ///< every line of a wall bounds the whole table

  Boundary(const Table& table, double radius);

  int vertex_contact(int vertex) const { return static_cast<int>(walls.size()) + vertex; }
  bool is_wall(int contact) const { return contact < static_cast<int>(walls.size()); }
  const Wall& wall(int contact) const { return walls[static_cast<std::size_t>(contact)]; }
  /// The arc of a vertex; null where the vertex is not reflex.
  const Circle* tip(int contact) const {
    for (const Circle& c : tips)
      if (c.contact == contact) return &c;
    return nullptr;
  }
  /// Unit vector away from a contact, into the table, for a centre at `at`; 0 where there is no such contact.
  template <class T>
  Vec2<T> normal(int contact, const Vec2<T>& at) const {
    if (is_wall(contact)) return to<T>(wall(contact).normal);
    const Circle* const c = tip(contact);
    if (!c) return {T(0), T(0)};
    const Vec2<T> out = at - to<T>(c->centre);
    return out / norm(out);
  }
  /// Distance a centre at `at` is inside the allowed region (negative: outside it).
  double clearance(const Vec2d& at) const;
  /// Distance from `point` to the nearest place where the centre can be.
  double distance_to_centres(const Vec2d& point) const;
};

/// The name of a contact in puzzles and answers: the cushion's, or v<i>.
std::string contact_name(const Table& table, int contact);

}  // namespace bankshot
