// SPDX-License-Identifier: MIT
//
// One recorded shot in a fit: what was seen, and how far the path of a launch with some coefficients is from that.
// Ceres asks it as a cost function of two blocks, the launch and the coefficients.
#pragma once

#include <ceres/cost_function.h>

#include <list>
#include <memory>
#include <vector>

#include "planners/learn/unknowns.hpp"
#include "planners/learn/way.hpp"

namespace bankshot::planning {

/// What is seen of a shot and how much it weighs; kept by the fit, read by the cost.
struct Seen {
  /// `noise` where the recording says none.
  Seen(const Recording& recording, double noise);

  const Recording& recording;
  Stand stand;
  std::vector<std::vector<char>> outlier;  ///< of each sample of each track
  double noise;                            ///< m, how much one coordinate of a sample errs
  double sigma;                            ///< m: the same, larger where the physics cannot follow the shot
  double last = 0;                         ///< s, of the latest sample
  double bounced = forever;  ///< s, when the struck ball was first seen to turn back at a straight cushion

  LaunchUnknowns launch{};
  /// What is known of it beforehand, with its standard deviation; forever where nothing is.
  LaunchUnknowns expected{}, spread{};
  std::vector<Told> told{};  ///< of each track
  double window = forever;   ///< s: samples later than this are not looked at
  bool left_out = false;     ///< the coefficients are learnt from the others
  double robust = 0;         ///< in sigmas: distances count as squares up to this, linearly beyond; 0: always squares

  /// How many samples of a track, from its first on, lie in the window and before what fits do not follow.
  std::size_t followed(std::size_t track) const;
  int samples_used() const;
};

/// Distances of the shot's places from those seen, in sigmas: two for each sample used, two for each place of rest,
/// then one for each unknown of the launch of which something is known beforehand.
class SeenCost : public ceres::CostFunction {
 public:
  /// All three must outlive it. `names` and `physics` may not change.
  SeenCost(const Seen& seen, const std::vector<std::string>& names, const Physics& physics);

  bool Evaluate(const double* const* blocks, double* residuals, double** jacobians) const override;

 private:
  template <int N>
  void evaluate(Varying<N>& varying, const double* const* blocks, double* residuals, double** jacobians) const;

  const Seen& seen_;
  const std::vector<std::string>& names_;
  mutable Varying<launch_varies> launch_only_;
  mutable std::unique_ptr<Varying<all_vary>> all_;
};

using Shots = std::list<Seen>;

/// m, of every sample, used or not, for what the shot's launch and these coefficients say; track by track.
std::vector<std::vector<Vec2d>> misses(const Seen& seen, const Common& common);

}  // namespace bankshot::planning
