// SPDX-License-Identifier: MIT
#include "planners/methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace bankshot::planning::methods {
namespace {

constexpr std::array everything{
    Method{{"auto", BANKSHOT_NLOPT ? "images, refined where paths are no straight lines; then sweep; nlopt-direct last"
                                   : "images, refined where paths are no straight lines; then sweep"},
           automatic},
    Method{{"image", "exact aims by unfolding the table; complete without reflex vertices"}, image},
    Method{{"sweep", "maps every aim (with spin: every aim and speed) and bisects; finds all sequences"}, sweep},
    Method{{"ceres", "Levenberg-Marquardt with dual numbers along a locked cushion sequence"}, ceres},
    Method{{"nlopt-bobyqa", "local search without derivatives from the images (NLopt BOBYQA)"}, nlopt_bobyqa},
    Method{{"nlopt-sbplx", "the same by subspaces of simplices (NLopt SBPLX)"}, nlopt_sbplx},
    Method{{"nlopt-slsqp", "from the images along a locked sequence, dual-number gradient (NLopt SLSQP)"}, nlopt_slsqp},
    Method{{"nlopt-direct", "global search over aim and speed (NLopt DIRECT-L)"}, nlopt_direct},
    Method{{"nlopt-crs", "the same by controlled random search (NLopt CRS2)"}, nlopt_crs},
    Method{{"nlopt-mlsl", "the same by many local searches (NLopt MLSL with BOBYQA)"}, nlopt_mlsl},
};
/// Without NLopt the six of it are not there.
constexpr std::span<const Method> list(everything.data(), everything.size() - (BANKSHOT_NLOPT ? 0 : 6));

}  // namespace

std::span<const Method> all() { return list; }

const Method& find(const std::string& name) {
  const auto it = std::find_if(list.begin(), list.end(), [&](const Method& m) { return m.info.name == name; });
  if (it != list.end()) return *it;
  std::string known;
  for (const Method& m : list) known += fmt::format("{}{}", known.empty() ? "" : ", ", m.info.name);
  throw InvalidInput("", fmt::format("\"{}\" is no planner; known are {}", name, known));
}

}  // namespace bankshot::planning::methods
