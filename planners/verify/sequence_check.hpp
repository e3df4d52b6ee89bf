// SPDX-License-Identifier: MIT
//
// Checks that a ball meets the cushions asked, in order.
#pragma once

#include <utility>
#include <vector>

#include "bankshot/simulate/event.hpp"

namespace bankshot::planning {

/// Compares the bounces with the cushions asked; two at one instant match in either order.
class SequenceCheck {
 public:
  explicit SequenceCheck(const std::vector<Contact>* wanted) : wanted_(wanted) {}

  bool accepts(int k, const Event& e) {
    if (!wanted_) return true;
    const auto at = [&](int i) { return (*wanted_)[static_cast<std::size_t>(i)]; };
    if (swapped_) return e.same_instant && std::exchange(swapped_, {}) == e.contact;
    if (at(k) == e.contact) return true;
    if (k + 1 < static_cast<int>(wanted_->size()) && at(k + 1) == e.contact) {
      swapped_ = at(k);
      return true;
    }
    return false;
  }
  /// Returns whether a swap still waits for its second bounce.
  bool open() const { return bool(swapped_); }

 private:
  const std::vector<Contact>* wanted_;
  Contact swapped_;
};

}  // namespace bankshot::planning
