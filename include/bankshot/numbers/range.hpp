// SPDX-License-Identifier: MIT
#pragma once

namespace bankshot {

/// A closed range; `[a, a]` fixes the value.
struct Range {
  double low, high;
  bool fixed() const { return low == high; }
  bool contains(double v) const { return low <= v && v <= high; }
};

}  // namespace bankshot
