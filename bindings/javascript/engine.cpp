// SPDX-License-Identifier: MIT
//
// The server's answers, called from JavaScript: the engine of the npm package, and of a page that has no server. Built
// by emscripten alone.
#include <emscripten.h>

#include <cstring>

#include "app/serve/api.hpp"

namespace bankshot::app::serve {
namespace {

/// Nobody can stop it from outside: whoever asks ends its worker.
Reply reply_to(std::string_view path, const Query& query, const std::string& body) {
  const std::atomic<bool> never{false};
  const std::atomic<const char*> why{""};
  const Limit limit{never, why};
  if (path == "solve") return solve(query, body, limit);
  if (path == "simulate") return simulate(query, body);
  if (path == "map") return map(query, body, limit);
  if (path == "launches") return launches(query, body, limit);
  if (path == "tables") return tables(query);
  if (path == "schema") return schema(query);
  if (path == "version") return {200, BANKSHOT_VERSION};
  return refusal(404, "", "the engine has no " + std::string(path));
}

}  // namespace
}  // namespace bankshot::app::serve

/// The status, a line break and the body; the caller frees it.
extern "C" EMSCRIPTEN_KEEPALIVE char* bankshot_ask(const char* path, const char* query, const char* body) {
  using namespace bankshot::app::serve;
  const Reply reply = reply_to(path, query_of(query, '\n'), body);
  return strdup((std::to_string(reply.status) + '\n' + reply.body).c_str());
}
