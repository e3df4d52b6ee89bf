// SPDX-License-Identifier: MIT
//
// Learns from all shots together what they say of the table, for a given physics model.
#pragma once

#include <functional>

#include "planners/learn/outliers.hpp"

namespace bankshot::planning {

struct Asked {
  Physics base;
  std::vector<std::string> names;  ///< names of the coefficients
  int threads = 1;
};

struct Learnt {
  Common common;
  Shots shots{};
  std::vector<HeldCoefficient> held{};
  double noise = 0;     ///< m, of one coordinate of a sample
  double off = 0;       ///< m; standard deviation of the residuals, from their median
  bool astray = false;  ///< `off` is clearly more than the noise: the laws cannot follow the shots
};

/// `progress` gets the share that is done.
Learnt learn(const Recordings& recordings, const Asked& asked, Spent& work,
             const std::function<void(double)>& progress);

}  // namespace bankshot::planning
