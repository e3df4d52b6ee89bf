// SPDX-License-Identifier: MIT
//
// What all shots say of the table together, one physics model given.
#pragma once

#include <functional>

#include "planners/learn/outliers.hpp"

namespace bankshot::planning {

struct Asked {
  Physics base;
  std::vector<std::string> names;  ///< of the coefficients
  int threads = 1;
};

struct Learnt {
  Common common;
  Shots shots{};
  std::vector<HeldCoefficient> held{};
  double noise = 0;     ///< m, of one coordinate of a sample
  double off = 0;       ///< m, standard deviation of what is left over, as half of the samples have it
  bool astray = false;  ///< that is clearly more than the noise: the laws cannot follow the shots
};

/// `progress` is told the share that is done.
Learnt learn(const Recordings& recordings, const Asked& asked, Work& work, const std::function<void(double)>& progress);

}  // namespace bankshot::planning
