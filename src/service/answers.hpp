// SPDX-License-Identifier: MIT
//
// Answers to requests: JSON and options in, JSON or text out. The server and the bindings give them to others. An
// answer is the bytes that the command of the same name prints with the same options.
#pragma once

#include <atomic>
#include <string>

#include "service/options.hpp"

namespace bankshot::service {

struct Reply {
  int status = 200;
  std::string body, type = "application/json";
};

/// Returns a refusal with a status such as 400: `{"path": "/ball/at", "reason": "…"}`.
Reply refusal(int status, const std::string& path, const std::string& reason);

/// Lets another thread stop a search.
struct Limit {
  const std::atomic<bool>& stop;
  const std::atomic<const char*>& why;  ///< the reason in words, once stopped
};
/// Takes the options of `solve` and answers in JSON. A search that is stopped answers with what it has.
Reply solve(const Query& query, const std::string& body, const Limit& limit);
Reply simulate(const Query& query, const std::string& body);
/// Takes `?grid=40,20` and returns a table, or a picture with `svg`.
Reply map(const Query& query, const std::string& body, const Limit& limit);
/// Takes `?angle=30,40&speed=1,3&grid=80,40`; returns which launches make the shot, and how surely (launch_map.hpp).
Reply launches(const Query& query, const std::string& body, const Limit& limit);
/// Takes the options of `bankshot generate` without --count, and `?number=3`; returns that puzzle of its list.
Reply generate(const Query& query);
/// Returns the tables by name, with what is needed to draw them.
Reply tables(const Query& query);
/// Takes `?document=shot` and returns what `bankshot schema` prints.
Reply schema(const Query& query);

}  // namespace bankshot::service
