// SPDX-License-Identifier: MIT
//
// What the server answers, without a word of HTTP: the documents of the command line, asked by paths and flags. An
// answer is the bytes that the command prints with the same flags.
#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bankshot::app::serve {

/// `?all&budget=500`: names as after `--`, and their values.
using Query = std::vector<std::pair<std::string, std::string>>;
/// Of "all&budget=500", each flag apart from the next by `between`.
Query query_of(std::string_view flags, char between);

struct Reply {
  int status = 200;
  std::string body, type = "application/json";
};

/// 400 and the like: `{"path": "/ball/at", "reason": "…"}`.
Reply refusal(int status, const std::string& path, const std::string& reason);

/// What ends a search from outside.
struct Limit {
  const std::atomic<bool>& stop;
  const std::atomic<const char*>& why;  ///< in words, once it stops
};
/// The flags of `solve` that answer in JSON. Stopped, it answers with what it has.
Reply solve(const Query& query, const std::string& body, const Limit& limit);
Reply simulate(const Query& query, const std::string& body);
/// `?grid=40,20`: a table, or with `svg` a picture.
Reply map(const Query& query, const std::string& body, const Limit& limit);
/// `?angle=30,40&speed=1,3&grid=80,40`: which launches make it, and how surely (launch_map.hpp).
Reply launches(const Query& query, const std::string& body, const Limit& limit);
/// The tables by name, as they are drawn.
Reply tables(const Query& query);
/// `?document=shot`: as `bankshot schema` prints it.
Reply schema(const Query& query);

}  // namespace bankshot::app::serve
