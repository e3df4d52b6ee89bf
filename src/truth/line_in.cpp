// SPDX-License-Identifier: MIT
#include "truth/line_in.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/numbers/tolerances.hpp"

namespace bankshot::truth {
namespace {

/// The lines in one direction into a pocket.
class LineIn {
 public:
  LineIn(const Boundary& boundary, const Circle& rim, const Vec2d& heading)
      : boundary_(boundary), rim_(rim), u_(heading / norm(heading)), left_{-u_.y, u_.x} {}

  bool enters(double offset) const {
    const auto least = room(offset);
    return least && *least >= -boundary_.touch;
  }

  std::optional<double> room(double offset) const {
    if (!(std::abs(offset) <= rim_.radius)) return {};
    const double ahead = std::sqrt(std::max(rim_.radius * rim_.radius - offset * offset, 0.0));
    const Vec2d entry = rim_.centre + left_ * offset - u_ * ahead;
    const auto at = [&](double back) { return boundary_.clearance(entry - u_ * back); };
    if (boundary_.jaws.empty()) return at(0);
    double low = 0, high = 0;  // m; range of the distance back to the table
    for (const Wall& w : boundary_.walls) {
      const double inside = dot(w.normal, entry) - w.offset, slope = -dot(w.normal, u_);
      if (inside < 0 && !(slope > 0)) return {};
      if (inside < 0) high = std::max(high, -inside / slope);
    }
    constexpr int samples = 48, halvings = 60;
    double least = at(0), nearest = 0;
    for (int i = 1; i <= samples; ++i)
      if (const double r = at(high * i / samples); r < least) least = r, nearest = high * i / samples;
    low = std::max(0.0, nearest - high / samples), high = std::min(high, nearest + high / samples);
    for (int i = 0; i < halvings; ++i) {
      const double a = low + (high - low) * 0.4, b = low + (high - low) * 0.6;
      (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
    }
    return std::min(least, at(low));
  }

  /// Returns the offset of the last entering line from `in`, which enters, towards `out`.
  double last(double in, double out) const {
    constexpr int steps = 100;
    const double from = in, to = out;
    for (int i = 1; i <= steps; ++i) {
      out = from + (to - from) * i / steps;
      if (enters(out)) {
        in = out;
        continue;
      }
      for (double middle = (in + out) / 2; middle != in && middle != out; middle = (in + out) / 2)
        (enters(middle) ? in : out) = middle;
      return in;
    }
    return to;
  }

 private:
  const Boundary& boundary_;
  const Circle& rim_;
  Vec2d u_, left_;
};

}  // namespace

std::optional<double> room_of_line(const Boundary& boundary, const Circle& rim, const Vec2d& heading, double offset) {
  return LineIn(boundary, rim, heading).room(offset);
}

double exact_offset(const Boundary& boundary, const Circle& rim, const Vec2d& heading, double own) {
  if (rim.radius <= tolerance::point_pocket * boundary.diagonal) return 0;
  const LineIn line(boundary, rim, heading);
  constexpr int grid = 400;
  std::optional<double> in;
  const bool enters = line.enters(own);
  if (enters) in = own;
  for (int i = 0; i <= grid && !enters; ++i) {
    const double offset = rim.radius * (2.0 * i / grid - 1);
    if ((!in || std::abs(offset - own) < std::abs(*in - own)) && line.enters(offset)) in = offset;
  }
  if (!in) return NAN;
  const double low = line.last(*in, -rim.radius), high = line.last(*in, rim.radius), eighth = (high - low) / 8;
  return std::clamp(0.0, low + eighth, high - eighth);
}

}  // namespace bankshot::truth
