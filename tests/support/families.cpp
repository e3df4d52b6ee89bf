// SPDX-License-Identifier: MIT
#include "support/families.hpp"

#include <algorithm>

#include "support/family_makers.hpp"

namespace bankshot::test {
namespace {

template <Family family>
Made early(Random& r, Model model, int bounces) {
  return random_puzzle(r, family, model, bounces);
}

constexpr NamedFamily all_families[] = {
    {"uniform", "rectangles of many sizes, six pockets or none", early<Family::uniform>},
    {"discrete", "grid positions, angles that are multiples of 15 degrees, exact corners", early<Family::discrete>},
    {"convex", "random convex polygons", early<Family::convex>},
    {"reflex", "random polygons with vertices pulled in", early<Family::reflex>},
    {"arrive-range", "a range of arrival speeds with bounds on aim, speed or both", make::arrive_range},
    {"spin-range", "ranges of top, side, masse, wide or narrow, half with an aim window (always spin)",
     make::spin_range},
    {"both-bounds", "aim and speed bounded at once, 1e-6 to 0.1 around the shot", make::both_bounds},
    {"slow-friction", "rolling friction that grows with speed, passed at 0.1 m/s or less (always spin)",
     make::slow_friction},
    {"frozen", "the ball on a cushion or in a corner, aimed anywhere, also into it", make::frozen},
    {"rail-hugging", "targets 1e-5 to 1e-3 m off the line of centres at a cushion", make::rail_hugging},
    {"hexagon", "regular and nearly regular polygons of 5 to 8 cushions", make::hexagon},
    {"on-line", "targets exactly on a line of centres at a cushion, or in a corner", make::on_line},
    {"budgets", "budgets of 0 to 3000 simulations, which may end the search but never be exceeded", make::budgets,
     false},
    {"obstacles", "one to eight balls that the shot passes by, some by a nanometre", make::obstacles},
    {"kicks", "the first contact with another ball, at the cut and speed that it had", make::kicks},
    {"pots", "another ball sent into a pocket", make::pots},
    {"banks", "another ball sent into a pocket by one to three cushions", make::banks},
    {"kick-pots", "off one or two cushions onto a ball that falls", make::kick_pots},
    {"kick-banks", "one cushion or two, and as many of the other ball, into a pocket", make::kick_banks},
    {"sent-to-rest", "another ball sent to rest at a point, up to three cushions each", make::sent_to_rest},
    {"combinations", "a ball sent on that sends one or two more on", make::combinations},
    {"caroms", "off one ball onto another", make::caroms},
    {"sent-past", "another ball sent into a pocket, past a point or to rest there", make::sent_past},
    {"slender", "rectangles of 10 to 1", make::slender},
    {"sizes", "tables of 2 mm to 1 km, some shifted by up to 1e4 m", make::sizes},
    {"triangles", "triangles with angles from 12 degrees", make::triangles},
    {"shapes", "L, U and star shapes", make::shapes},
    {"edge-pockets", "polygons with pockets on their edges", make::edge_pockets},
    {"extremes", "restitution 0.3 to 1, cushion friction 0 to 5, nose 1.02 to 1.6 R, draw 2.4, side 1.2, masse 2",
     make::extremes},
    {"many-cushions", "6 to 12 cushions", make::many_cushions},
    {"fast", "launches at 10 to 30 m/s", make::fast},
};

}  // namespace

std::span<const NamedFamily> named_families() { return all_families; }

const NamedFamily* find_family(std::string_view name) {
  const auto found =
      std::find_if(std::begin(all_families), std::end(all_families), [&](const auto& f) { return f.name == name; });
  return found == std::end(all_families) ? nullptr : found;
}

}  // namespace bankshot::test
