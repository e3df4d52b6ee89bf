// SPDX-License-Identifier: MIT
//
// The quantities of a launch that a search may vary. To make another quantity an unknown (spin), it gets a name here,
// its difference and its step, and its column of derivatives in planners/start.hpp. No other code knows which
// quantities there are.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "planners/search_request.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning {

enum class Quantity { aim, speed };  ///< rad; ln of m/s

inline constexpr std::size_t most_unknowns = 2;

struct Unknown {
  Quantity what;
  double farthest;      ///< rad, or of ln speed; a search that goes farther from its start gives up
  double longest_step;  ///< in the same unit; longer steps are cut
};

/// A list of one to most_unknowns unknowns, in the order of the derivatives' columns.
class Unknowns {
 public:
  void add(const Unknown& u) { list_[size_++] = u; }
  std::size_t size() const { return size_; }
  const Unknown& operator[](std::size_t i) const { return list_[i]; }
  const Unknown* begin() const { return list_.data(); }
  const Unknown* end() const { return list_.data() + size_; }

 private:
  std::array<Unknown, most_unknowns> list_{};
  std::size_t size_ = 0;
};

/// Returns the difference of a quantity from one launch to another.
inline double difference(const Launch& from, const Launch& to, Quantity what) {
  return what == Quantity::aim ? to.angle - from.angle : std::log(to.speed / from.speed);
}

inline void move(Launch& launch, Quantity what, double step) {
  if (what == Quantity::aim)
    launch.angle += step;
  else
    launch.speed *= std::exp(step);
}

/// Returns the unknowns of a request, with the steps of a neighbourhood.
inline Unknowns unknowns_of(const SearchRequest& request, const Neighbourhood& near) {
  Unknowns out;
  out.add({Quantity::aim, near.far * near.step_aim, near.step_aim});
  if (!request.one_unknown()) out.add({Quantity::speed, near.far * near.step_speed, near.step_speed});
  return out;
}

}  // namespace bankshot::planning
