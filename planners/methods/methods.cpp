// SPDX-License-Identifier: MIT
#include "planners/methods/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "planners/methods/nlopt.hpp"

namespace bankshot::planning::methods {
namespace {

constexpr std::array own{
    Method{{"auto", "the cheapest sure step first: images, then maps of aim and speed, a global search last"},
           automatic},
    Method{{.name = "image",
            .summary = "exact aims by unfolding the table, without spin; complete without reflex vertices",
            .bends = false},
           image},
    Method{{"sweep", "maps every aim (with spin: every aim and speed) and bisects; finds all sequences"}, sweep},
    Method{{"ceres", "Levenberg-Marquardt with dual numbers along a locked cushion sequence"}, ceres},
};

}  // namespace

std::span<const Method> all() {
  static const std::vector<Method> list = [] {
    std::vector<Method> both(own.begin(), own.end());
    both.insert(both.end(), nlopt_methods().begin(), nlopt_methods().end());
    return both;
  }();
  return list;
}

const Method& find(const std::string& name) {
  const std::span<const Method> list = all();
  const auto it = std::find_if(list.begin(), list.end(), [&](const Method& m) { return m.info.name == name; });
  if (it != list.end()) return *it;
  std::string known;
  for (const Method& m : list) known += fmt::format("{}{}", known.empty() ? "" : ", ", m.info.name);
  throw InvalidInput("", fmt::format("\"{}\" is no planner; known are {}", name, known));
}

}  // namespace bankshot::planning::methods
