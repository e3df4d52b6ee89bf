// SPDX-License-Identifier: MIT
//
// Learns a table from recorded shots: the coefficients of its physics, and how each shot was launched.
//   const Fit fit = bankshot::fit(recordings);
//   fit.physics                 // takes the place of a puzzle's
//   fit.parameters[0].error     // standard error of what was fitted
// Least squares over all samples of all shots: paths are followed along the cushions that they met
// (simulate/locked.hpp) with exact derivatives by launches and coefficients, and a robust loss until outliers are
// known; Ceres solves.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bankshot/scene/recording.hpp"

namespace bankshot {

struct FitWish {
  /// Names of what is fitted (`fit_names()`); empty: all that the physics has, without tilt and camera.
  std::vector<std::string> free{};
  /// Cushions after mirror, han2005, mathavan2010 or stronge; "any": han2005 or stronge, which predicts best what was
  /// left out. Empty: the recordings' own.
  std::string model{};
  /// How the cushions' restitution and the rolling friction (which has no square) depend on speed.
  enum class BySpeed { as_given, constant, linear, square };
  BySpeed restitution = BySpeed::as_given, rolling = BySpeed::as_given;
  int holdout = 0;       ///< so many shots are left out at a time, and predicted
  bool predict = false;  ///< with `holdout` 0, from what all shots taught
  int threads = 1;
  std::function<void(double)> progress{};  ///< the share that is done
};

/// One that the recordings told.
struct FittedCoefficient {
  std::string name;
  double value;
  double error;                                ///< one standard error
  std::vector<std::string> correlated_with{};  ///< those it is hard to tell apart from: |correlation| above 0.9
};

/// One that they did not: it stays where it was.
struct HeldCoefficient {
  std::string name;
  double value;
  std::vector<std::string> like{};  ///< those whose change looks the same
};

/// How one recorded shot was played, as far as its track tells.
struct FittedShot {
  std::string id;
  double start = 0;  ///< s, by the recording's clock
  Vec2d at{};        ///< m, where the ball stood
  Launch launch{};
  LaunchSpin spin{};
  double rms = 0;  ///< m, distance from where it was seen, over all samples but outliers
  int samples = 0, outliers = 0, cushions = 0;
  int unexplained = 0;              ///< samples after a contact that fits do not follow
  std::vector<double> distances{};  ///< m, of each sample of each track in order
  std::vector<char> counted{};      ///< whether it did: neither an outlier nor unexplained
};

/// What became of a shot whose launch was fitted on its first part, up to 0.25 s after its first bounce.
struct Prediction {
  std::string id;
  double rms;   ///< m, over the rest
  int samples;  ///< of the rest
};

/// How well one kind of cushion does.
struct ModelScore {
  std::string model;
  double fitted, predicted;  ///< m, medians of the shots' rms
};

struct Fit {
  Physics physics{};
  double camera_scale = 1;
  Vec2d camera_offset{};  ///< m
  std::vector<FittedCoefficient> parameters{};
  std::vector<double> covariance{};  ///< of the parameters, row by row
  std::vector<HeldCoefficient> held{};
  std::vector<FittedShot> shots{};
  double sigma = 0;  ///< m, of one coordinate of one sample
  std::vector<Prediction> predictions{};
  std::vector<ModelScore> models{};  ///< that were tried
  std::string model{};               ///< of these, the one that was taken
  long simulations = 0, restarts = 0;
  double seconds = 0;  ///< by the clock on the wall, that learning from all shots took: without what was left out
};

/// What may be fitted, as `FitWish::free` names it.
std::vector<std::string> fit_names(const Physics& physics);

/// All recordings have the same physics model; what they say of its coefficients beyond the first is not looked at.
/// Throws InvalidInput where there is nothing to fit.
Fit fit(std::span<const Recording> recordings, const FitWish& wish = {});

/// Medians of the rms [m]: of shots with so many cushions at least, and of predictions that had something to predict. 0
/// of none.
double median_rms(std::span<const FittedShot> shots, int least_cushions = 0);
double median_rms(std::span<const Prediction> predictions);

/// Said plainly: what the recordings told and what they could not.
std::string message_of(const Fit& fit);

/// The `fit` document, one line.
std::string to_json(const Fit& fit);
/// Its physics alone, as JSON that a puzzle's "physics" may be.
std::string physics_of(const Fit& fit);

}  // namespace bankshot
