// SPDX-License-Identifier: MIT
//
// One recorded shot in a fit: its observations, and how far the path of a launch with some coefficients is from them.
// Ceres evaluates it as a cost function of two blocks, the launch and the coefficients.
#pragma once

#include <ceres/cost_function.h>

#include <list>
#include <memory>
#include <vector>

#include "planners/learn/unknowns.hpp"
#include "planners/learn/way.hpp"

namespace bankshot::planning {

/// The observations of a shot and their weights; set by the fit, read by the cost.
struct Seen {
  /// `noise`: used if the recording gives none.
  Seen(const Recording& recording, double noise);

  const Recording& recording;
  Stand stand;
  std::vector<std::vector<char>> outlier;  ///< for each sample of each track
  double noise;                            ///< m; standard error of one coordinate of a sample
  double sigma;                            ///< m; as `noise`, but larger if the physics cannot follow the shot
  double last = 0;                         ///< s; time of the latest sample
  double bounced = forever;                ///< s; when the cue ball was first seen to turn back at a straight cushion

  LaunchUnknowns launch{};
  /// Prior of the launch: expected values and standard deviations; forever if nothing is known.
  LaunchUnknowns expected{}, spread{};
  std::vector<Told> told{};  ///< for each track
  double window = forever;   ///< s; later samples are ignored
  bool left_out = false;     ///< this shot does not teach the coefficients
  double robust = 0;         ///< in sigmas: distances count as squares up to this, linearly beyond; 0: always squares

  /// Counts the samples of a track, from its first on, in the window and before a contact that fits do not follow.
  std::size_t followed(std::size_t track) const;
  int samples_used() const;
};

/// Distances of the path from the observed places, in sigmas. There are two for each sample used, two for each place of
/// rest, then one for each unknown of the launch with a prior.
class SeenCost : public ceres::CostFunction {
 public:
  /// All three arguments must outlive it. `names` and `physics` may not change.
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

/// Returns the observed minus the computed place [m] of every sample, used or not, track by track.
std::vector<std::vector<Vec2d>> misses(const Seen& seen, const Common& common);

}  // namespace bankshot::planning
