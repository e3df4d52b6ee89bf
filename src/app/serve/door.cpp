// SPDX-License-Identifier: MIT
#include "app/serve/door.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace bankshot::app::serve {

bool is_loopback(const std::string& host) { return host == "localhost" || host == "::1" || host.starts_with("127."); }

Door::Door(const std::string& host, const std::vector<std::string>& names, int port) {
  std::vector<std::string> hosts{host};
  hosts.insert(hosts.end(), names.begin(), names.end());
  if (is_loopback(host)) hosts.insert(hosts.end(), {"localhost", "127.0.0.1", "::1"});
  for (const std::string& name : hosts) {
    const std::string shown = name.find(':') == std::string::npos ? name : '[' + name + ']';
    names_.push_back(fmt::format("{}:{}", shown, port));
    if (port == 80) names_.push_back(shown);
  }
}

std::string Door::refuses(const std::string& host, const std::string& origin) const {
  const auto known = [&](const std::string& name) { return std::ranges::find(names_, name) != names_.end(); };
  if (!known(host)) return "this server is not called \"" + host + "\"; --allow-host adds a name";
  if (!origin.empty() && origin != "http://" + host) return "pages of " + origin + " may not ask this server";
  return "";
}

}  // namespace bankshot::app::serve
