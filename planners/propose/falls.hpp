// SPDX-License-Identifier: MIT
//
// Last balls that met their aim point at another speed than asked, by a route that leads to no root: rolling along a
// rail into a pocket, say. They are brought to that speed as they are. For contact_windows.cpp.
#pragma once

#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "planners/propose/chain_path.hpp"
#include "planners/search_result.hpp"

namespace bankshot::planning::propose {

class Falls {
 public:
  /// The arguments must outlive this.
  Falls(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, ChainPath& path,
        std::string_view step)
      : request_(request), budget_(budget), found_(found), path_(path), step_(step) {}

  void remember(const Fall& fall) { falls_[fall.route].push_back(fall); }
  /// Brings falls to the speed asked, first those that arrived nearly so. Routes in `made` are left out. Forgets all
  /// falls.
  void bring_to_speed(const std::set<Route>& made);

 private:
  SearchRequest to_bring() const;
  bool keep(const Launch& launch, int bounces);
  bool beside(const Fall& fall);
  bool by_replays(const SearchRequest& brought, const Fall& fall);
  double turn_of(const Fall& fall);

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  ChainPath& path_;
  std::string_view step_;
  std::map<Route, std::vector<Fall>> falls_{};
};

}  // namespace bankshot::planning::propose
