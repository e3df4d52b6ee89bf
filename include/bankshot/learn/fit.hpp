// SPDX-License-Identifier: MIT
//
// Learns a table from recorded shots: the coefficients of its physics, and how each shot was launched.
//   const Fit fit = bankshot::fit(recordings);
//   fit.physics                 // replaces the physics of a puzzle
//   fit.parameters[0].error     // standard error of the fitted value
// Method: least squares over all samples of all shots, solved by Ceres. Paths follow the cushions that they met
// (simulate/locked.hpp), with exact derivatives by launches and coefficients. The loss is robust until outliers are
// identified.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bankshot/scene/recording.hpp"

namespace bankshot {

struct FitWish {
  /// Names of the fitted parameters (see `fit_names()`); empty: all coefficients of the physics, without tilt and
  /// camera.
  std::vector<std::string> free{};
  /// Cushion model: a key of contact/cushion_registry.hpp. "any" takes the one that predicts left-out shots best, of
  /// those that the registry lets a fit try. Empty keeps the recordings' own.
  std::string model{};
  /// Dependence of the cushions' restitution and of the rolling friction on speed; `square` is for restitution only.
  enum class BySpeed { as_given, constant, linear, square };
  BySpeed restitution = BySpeed::as_given, rolling = BySpeed::as_given;
  int holdout = 0;       ///< number of shots that are left out at a time and predicted
  bool predict = false;  ///< if `holdout` is 0: predict shots from the fit to all shots
  int threads = 1;
  std::function<void(double)> progress{};  ///< receives the completed share, from 0 to 1
};

/// A coefficient that the recordings identify.
struct FittedCoefficient {
  std::string name;
  double value;
  double error;                                ///< one standard error
  std::vector<std::string> correlated_with{};  ///< coefficients with |correlation| above 0.9
};

/// A coefficient that the recordings do not identify; it keeps its start value.
struct HeldCoefficient {
  std::string name;
  double value;
  std::vector<std::string> like{};  ///< coefficients whose change has the same effect
};

/// The estimated launch of one recorded shot.
struct FittedShot {
  std::string id;
  double start = 0;  ///< s; time of the launch by the recording's clock
  Vec2d at{};        ///< m; position of the cue ball before the launch
  Launch launch{};
  LaunchSpin spin{};
  double rms = 0;  ///< m; distance from the observations, without outliers
  int samples = 0, outliers = 0, cushions = 0;
  int unexplained = 0;              ///< samples after a contact that a fit cannot follow
  std::vector<double> distances{};  ///< m; for each sample of each track in order
  std::vector<char> counted{};      ///< for each sample: it is neither an outlier nor unexplained
};

/// The prediction of a shot whose launch was fitted to its first part, up to 0.25 s after its first bounce.
struct Prediction {
  std::string id;
  double rms;   ///< m; error over the remaining samples
  int samples;  ///< number of remaining samples
};

/// The score of one cushion model.
struct ModelScore {
  std::string model;
  double fitted, predicted;  ///< m; medians of the shots' rms
};

struct Fit {
  Physics physics{};
  double camera_scale = 1;
  Vec2d camera_offset{};  ///< m
  std::vector<FittedCoefficient> parameters{};
  std::vector<double> covariance{};  ///< of `parameters`, row by row
  std::vector<HeldCoefficient> held{};
  std::vector<FittedShot> shots{};
  double sigma = 0;  ///< m; standard deviation of one coordinate of one sample
  std::vector<Prediction> predictions{};
  std::vector<ModelScore> models{};  ///< the models that were tried
  std::string model{};               ///< the chosen one of `models`
  long simulations = 0, restarts = 0;
  double seconds = 0;  ///< wall-clock time of the fit to all shots, without the fits that leave shots out
};

/// Returns the names of all parameters that can be fitted, as `FitWish::free` takes them.
std::vector<std::string> fit_names(const Physics& physics);

/// Fits all recordings together. They must have the same physics model; the coefficients start from those of the first
/// recording. Throws InvalidInput if there is nothing to fit.
Fit fit(std::span<const Recording> recordings, const FitWish& wish = {});

/// Returns the median rms [m] of shots with at least this many cushions, or of predictions with at least one sample; 0
/// if there are none.
double median_rms(std::span<const FittedShot> shots, int least_cushions = 0);
double median_rms(std::span<const Prediction> predictions);

/// Returns a text that says which coefficients the recordings identify and which they do not.
std::string message_of(const Fit& fit);

/// Returns the `fit` document as one line of JSON.
std::string to_json(const Fit& fit);
/// Returns its physics alone, as JSON for the key "physics" of a puzzle.
std::string physics_of(const Fit& fit);

}  // namespace bankshot
