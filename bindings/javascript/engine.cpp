// SPDX-License-Identifier: MIT
//
// The answers of src/service for JavaScript: the engine of the npm package, and of a page without a server. It is
// built only by emscripten.
#include <emscripten.h>

#include <cstring>

#include "service/answers.hpp"

namespace bankshot::service {
namespace {

/// Answers a request. It cannot be cancelled; the caller can end its worker instead.
Reply reply_to(std::string_view path, const Query& query, const std::string& body) {
  const std::atomic<bool> never{false};
  const std::atomic<const char*> why{""};
  const Limit limit{never, why};
  if (path == "solve") return solve(query, body, limit);
  if (path == "simulate") return simulate(query, body);
  if (path == "map") return map(query, body, limit);
  if (path == "launches") return launches(query, body, limit);
  if (path == "generate") return generate(query);
  if (path == "tables") return tables(query);
  if (path == "schema") return schema(query);
  if (path == "version") return {200, BANKSHOT_VERSION};
  return refusal(404, "", "the engine has no " + std::string(path));
}

}  // namespace
}  // namespace bankshot::service

/// Returns the status, a line break and the body; the caller frees the text.
extern "C" EMSCRIPTEN_KEEPALIVE char* bankshot_ask(const char* path, const char* query, const char* body) {
  using namespace bankshot::service;
  const Reply reply = reply_to(path, query_of(query, '\n'), body);
  return strdup((std::to_string(reply.status) + '\n' + reply.body).c_str());
}
