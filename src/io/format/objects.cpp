// SPDX-License-Identifier: MIT
#include "io/format/objects.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "io/format/recording_keys.hpp"

namespace bankshot::format {
namespace {

constexpr const Object* all[] = {&puzzle,
                                 &shot,
                                 &answer,
                                 &recording,
                                 &play,
                                 &mouth,
                                 &pocket,
                                 &own_cushion,
                                 &rectangle,
                                 &preset,
                                 &polygon,
                                 &ideal,
                                 &rolling,
                                 &covariance,
                                 &cushion,
                                 &spins,
                                 &spin_physics,
                                 &friction_of_speed,
                                 &friction_of_slip,
                                 &restitution_of_speed,
                                 &rolling_balls,
                                 &ball_ball,
                                 &ball,
                                 &behind,
                                 &other,
                                 &to_point,
                                 &to_pocket,
                                 &to_ball,
                                 &then_point,
                                 &then_pocket,
                                 &then_ball,
                                 &carom,
                                 &rest_near,
                                 &leave_place,
                                 &leave_region,
                                 &leave_for,
                                 &leave_safe,
                                 &leave_against,
                                 &game,
                                 &count,
                                 &arrive,
                                 &noise,
                                 &budget,
                                 &launch_spin,
                                 &launch,
                                 &until,
                                 &answer_spin,
                                 &tip,
                                 &hit,
                                 &contact,
                                 &shot_leave,
                                 &spread,
                                 &sent,
                                 &arrival,
                                 &margin,
                                 &answer_shot,
                                 &next_ball,
                                 &placed,
                                 &planned,
                                 &plan,
                                 &error};

const Object* object(std::string_view name) {
  const auto it = std::find_if(std::begin(all), std::end(all), [&](const Object* o) { return o->name == name; });
  if (it == std::end(all)) throw std::logic_error("the format has no object " + std::string(name));
  return *it;
}

}  // namespace

std::vector<std::string_view> alternatives(std::string_view type) {
  constexpr std::string_view either = " | ";
  std::vector<std::string_view> out;
  std::size_t begin = 0;
  for (std::size_t i = 0, depth = 0; i < type.size(); ++i) {
    if (type[i] == '[') ++depth;
    if (type[i] == ']') --depth;
    if (depth > 0 || !type.substr(i).starts_with(either)) continue;
    out.push_back(type.substr(begin, i - begin));
    begin = i + either.size();
  }
  out.push_back(type.substr(begin));
  return out;
}

std::vector<const Object*> objects_of(std::string_view document) {
  std::vector<const Object*> found{object(document)};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const Key& key : found[i]->keys)
      for (const std::string_view type : alternatives(key.type)) {
        const auto open = type.find('{'), close = type.find('}');
        if (open == std::string_view::npos) continue;
        const Object* inner = object(type.substr(open + 1, close - open - 1));
        if (std::find(found.begin(), found.end(), inner) == found.end()) found.push_back(inner);
      }
  return found;
}

}  // namespace bankshot::format
