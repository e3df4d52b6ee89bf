// SPDX-License-Identifier: MIT
#include "bankshot/plan/launch_map.hpp"

#include <cmath>

#include "io/json/writer.hpp"

namespace bankshot {
namespace {

void write_pair(JsonWriter& w, std::string_view key, double a, double b) {
  w.key(key), w.open('['), w.number(a), w.number(b), w.close(']');
}

/// Rounds to three decimals, which is enough for a picture.
double thousandth(double v) { return std::round(v * 1000) / 1000; }

}  // namespace

std::string to_json(const LaunchMap& map) {
  JsonWriter w;
  w.open('{');
  write_pair(w, "angle", degrees(map.grid.angle.low), degrees(map.grid.angle.high));
  write_pair(w, "speed", map.grid.speed.low, map.grid.speed.high);
  write_pair(w, "grid", map.grid.angles, map.grid.speeds);
  std::string made;
  for (const bool m : map.made) made += m ? '1' : '0';
  w.string("made", made);
  w.key("chance"), w.open('[');
  for (const double c : map.success) w.number(thousandth(c));
  w.close(']');
  w.close('}');
  return w.take();
}

}  // namespace bankshot
