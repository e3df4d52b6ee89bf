// SPDX-License-Identifier: MIT
#include "app/serve/server.hpp"

#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <thread>

#include "app/files.hpp"
#include "app/serve/desk.hpp"
#include "app/serve/door.hpp"
#include "app/serve/listener.hpp"
#include "app/serve/page.hpp"
#include "service/answers.hpp"

namespace bankshot::app::serve {

using service::Limit;
using service::Query;
using service::refusal;
using service::Reply;
namespace {

constexpr std::size_t largest_body = 1 << 20;         // bytes
constexpr std::size_t most_of_a_connection = 100000;  // requests
constexpr const char* page_header = "Bankshot-Page";

Query query_of(const httplib::Request& request) { return {request.params.begin(), request.params.end()}; }

void put(httplib::Response& response, const Reply& reply) {
  response.status = reply.status;
  if (reply.status == 503) response.set_header("Retry-After", "1");
  if (reply.status != 200) return response.set_content(reply.body, reply.type);
  // The body is sent in pieces: httplib would compress a whole one with brotli's slowest level, over a second per
  // megabyte.
  const auto piece = [body = reply.body](std::size_t from, std::size_t length, httplib::DataSink& sink) {
    return sink.write(body.data() + from, length);
  };
  response.set_content_provider(reply.body.size(), reply.type, piece);
}

/// Refuses a request whose body was not read to its end. The connection closes, since the rest would be taken for the
/// next request.
void unread(httplib::Response& response, Connection& client, std::size_t body) {
  if (client.cut() && response.status != 413) response.status = 408;  // 413: httplib refused it by its Content-Length
  if (body > largest_body) response.status = 413;
  client.cut_off();
  response.set_header("Connection", "close");
}

/// The page's policy; `framed`: other pages may hold it in a frame.
std::string policy(bool framed) {
  return std::string(
             "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
             "connect-src 'self'; base-uri 'none'; form-action 'none'") +
         (framed ? "" : "; frame-ancestors 'none'");
}

std::string words_of(int status) {
  switch (status) {
    case 404:
      return "there is nothing here; POST to /api/solve, /api/simulate, /api/map, /api/launches or /api/generate, GET "
             "/api/tables or "
             "/api/schema";
    case 408:
      return "the request took too long to arrive";
    case 413:
      return fmt::format("the body is larger than {} bytes", largest_body);
    case 414:
      return "the address is too long";
    default:
      return "this is no request that the server understands";
  }
}

}  // namespace

struct Server::Parts {
  ServerOptions options;
  Listener http;
  Desk desk;
  std::unique_ptr<Door> door{};

  explicit Parts(const ServerOptions& o)
      : options(o),
        http(o.connections, o.patience),
        desk(o.at_once > 0 ? o.at_once : std::max(1, static_cast<int>(std::thread::hardware_concurrency())), o.waiting,
             o.time_limit) {}

  void limits() {
    http.set_payload_max_length(largest_body);
    http.set_keep_alive_timeout(static_cast<time_t>(options.patience.idle.count()));  // clients are told this value
    http.set_keep_alive_max_count(most_of_a_connection);
    http.set_tcp_nodelay(true);
    // Sets SO_REUSEADDR only; httplib's default, SO_REUSEPORT, lets two servers listen at one port.
    http.set_socket_options([](int socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    http.set_default_headers({{"X-Content-Type-Options", "nosniff"},
                              {"Referrer-Policy", "no-referrer"},
                              {"Cross-Origin-Resource-Policy", "same-origin"},
                              {"Cache-Control", "no-store"},
                              {"Content-Security-Policy", policy(false)}});
  }

  void refusals() {
    http.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      using enum httplib::Server::HandlerResponse;
      if (Listener::no_room()) {
        put(response, refusal(503, "", "too many connections; come back in a second"));
        return Handled;
      }
      const std::string why = door->refuses(request.get_header_value("Host"), request.get_header_value("Origin"));
      if (why.empty()) return Unhandled;
      put(response, refusal(403, "", why));
      return Handled;
    });
    http.set_error_handler([](const httplib::Request&, httplib::Response& response) {
      if (response.body.empty()) put(response, refusal(response.status, "", words_of(response.status)));
    });
    http.set_exception_handler(
        [](const httplib::Request&, httplib::Response& response, const std::exception_ptr& thrown) {
          try {
            std::rethrow_exception(thrown);
          } catch (const std::exception& e) {
            put(response, refusal(500, "", e.what()));
          }
        });
  }

  /// Serves a path whose answers take time: a request waits for its turn and is stopped at the time limit.
  template <class Answer>
  void work(const char* path, const Answer& answer) {
    // The body is read here: httplib would take a body declared as a form, which curl -d sends, for flags.
    http.Post(path, [this, answer](const httplib::Request& request, httplib::Response& response,
                                   const httplib::ContentReader& read) {
      std::string body;
      const auto more = [&](const char* bytes, std::size_t n) {
        body.append(bytes, n);
        return body.size() <= largest_body;  // httplib limits neither chunked nor compressed bodies
      };
      Connection& client = Listener::here();
      if (!read(more)) return unread(response, client, body.size());
      const auto mine = desk.begin(request.get_header_value(page_header), [&] { return client.gone(); });
      if (!mine) return put(response, refusal(503, "", "the server is busy; come back in a second"));
      put(response, answer(query_of(request), body, Limit{mine->stop, mine->why}));
    });
  }

  void rooms() {
    work("/api/solve", service::solve);
    work("/api/map", service::map);
    work("/api/launches", service::launches);
    work("/api/simulate",
         [](const Query& query, const std::string& body, const Limit&) { return service::simulate(query, body); });
    work("/api/generate",
         [](const Query& query, const std::string&, const Limit&) { return service::generate(query); });
    http.Get("/api/tables", [](const httplib::Request& request, httplib::Response& response) {
      put(response, service::tables(query_of(request)));
    });
    http.Get("/api/schema", [](const httplib::Request& request, httplib::Response& response) {
      put(response, service::schema(query_of(request)));
    });
    for (const PageFile& file : page_files())
      http.Get(std::string(file.path), [file](const httplib::Request& request, httplib::Response& response) {
        put(response, {200, std::string(file.bytes), std::string(file.type)});
        if (!request.has_param("embed")) return;
        // httplib would send both the default header and this one, and the stricter of two policies holds.
        response.headers.erase("Content-Security-Policy");
        response.set_header("Content-Security-Policy", policy(true));
      });
  }

  void bind() {
    if (options.port == 0)
      options.port = http.bind_to_any_port(options.host);
    else if (!http.bind_to_port(options.host, options.port))
      options.port = -1;
    if (options.port < 0)
      throw FileError(
          fmt::format("cannot listen at {}: the port is taken, or this machine has no such address", options.host));
    http.let_many_wait();
    door = std::make_unique<Door>(options.host, options.names, options.port);
  }
};

Server::Server(const ServerOptions& options) : parts_(std::make_unique<Parts>(options)) {
  parts_->limits();
  parts_->refusals();
  parts_->rooms();
  parts_->bind();
}

Server::~Server() = default;

int Server::port() const { return parts_->options.port; }

std::string Server::url() const {
  const std::string& host = parts_->options.host;
  return fmt::format("http://{}:{}/", host.find(':') == std::string::npos ? host : '[' + host + ']', port());
}

void Server::run() { parts_->http.listen_after_bind(); }

void Server::stop() {
  parts_->desk.stop_all();
  parts_->http.stop();
}

}  // namespace bankshot::app::serve
