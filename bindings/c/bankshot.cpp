// SPDX-License-Identifier: MIT
//
// The C interface (include/bankshot/bankshot.h): the answers of src/service, and many launches of one scene.
#include "bankshot/bankshot.h"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>

#include "bankshot/scene/json.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "bindings/many.hpp"
#include "bindings/verified.hpp"
#include "service/answers.hpp"

namespace service = bankshot::service;

struct bankshot_scene {
  bankshot::ShotRequest request;
};

namespace {

using bankshot::InvalidInput;

/// Copies a text for the caller, who frees it. Returns false if there is no memory.
bool hand_out(std::string_view text, bankshot_text* out) {
  if (!out) return true;
  out->length = 0;
  out->data = static_cast<char*>(std::malloc(text.size() + 1));
  if (!out->data) return false;
  std::memcpy(out->data, text.data(), text.size());
  out->data[text.size()] = '\0';
  out->length = text.size();
  return true;
}

std::string trouble(const std::string& path, const std::string& reason) {
  return service::refusal(400, path, reason).body;
}

/// Calls `f`, which returns a status and a text, and converts exceptions to a status.
template <class F>
bankshot_status guarded(bankshot_text* out, const F& f) noexcept {
  try {
    try {
      const auto [status, text] = f();
      return hand_out(text, out) ? status : BANKSHOT_NO_MEMORY;
    } catch (const InvalidInput& e) {
      return hand_out(trouble(e.path, e.what()), out) ? BANKSHOT_BAD_INPUT : BANKSHOT_NO_MEMORY;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& e) {
      return hand_out(trouble("", e.what()), out) ? BANKSHOT_BAD_INPUT : BANKSHOT_NO_MEMORY;
    }
  } catch (...) {
    if (out) *out = {nullptr, 0};
    return BANKSHOT_NO_MEMORY;
  }
}

service::Query query_of(const char* flags) { return service::query_of(flags ? flags : "", '&'); }

std::string text_of(const char* data, std::size_t length) {
  if (!data && length > 0) throw InvalidInput("", "there is no text at NULL");
  return {data ? data : "", length};
}

using Result = std::pair<bankshot_status, std::string>;

Result result_of(service::Reply reply) {
  return {reply.status == 200 ? BANKSHOT_DONE : BANKSHOT_BAD_INPUT, std::move(reply.body)};
}

/// Calls `f` without a way to cancel the search.
template <class F>
Result unhurried(const F& f) {
  const std::atomic<bool> never{false};
  const std::atomic<const char*> why{nullptr};
  return result_of(f(service::Limit{never, why}));
}

}  // namespace

int bankshot_abi_version() { return BANKSHOT_ABI_VERSION; }
const char* bankshot_version() { return BANKSHOT_VERSION; }

bankshot_status bankshot_solve(const char* puzzle, size_t length, const char* flags, bankshot_text* answer) {
  return guarded(answer, [&]() -> Result {
    Result r = unhurried(
        [&](const service::Limit& limit) { return service::solve(query_of(flags), text_of(puzzle, length), limit); });
    constexpr std::string_view solved = "\"status\":\"solved\"";
    if (r.first == BANKSHOT_DONE && r.second.find(solved) == std::string::npos) r.first = BANKSHOT_NOTHING;
    return r;
  });
}

bankshot_status bankshot_simulate(const char* shot, size_t length, const char* flags, bankshot_text* path) {
  return guarded(path, [&] { return result_of(service::simulate(query_of(flags), text_of(shot, length))); });
}

bankshot_status bankshot_map(const char* puzzle, size_t length, const char* flags, bankshot_text* map) {
  return guarded(map, [&] {
    return unhurried(
        [&](const service::Limit& limit) { return service::map(query_of(flags), text_of(puzzle, length), limit); });
  });
}

bankshot_status bankshot_verify(const char* puzzle, size_t puzzle_length, const char* answer, size_t answer_length,
                                bankshot_text* report) {
  return guarded(report, [&]() -> Result {
    auto [holds, text] = bankshot::bindings::verified(text_of(puzzle, puzzle_length), text_of(answer, answer_length));
    return {holds ? BANKSHOT_DONE : BANKSHOT_NOTHING, std::move(text)};
  });
}

bankshot_status bankshot_schema(const char* document, bankshot_text* schema) {
  return guarded(schema, [&] { return result_of(service::schema({{"document", document ? document : "puzzle"}})); });
}

void bankshot_free(char* data) { std::free(data); }

bankshot_scene* bankshot_scene_new(const char* shot, size_t length, bankshot_text* error) {
  bankshot_scene* scene = nullptr;
  const bankshot_status status = guarded(error, [&]() -> Result {
    scene = new bankshot_scene{bankshot::read_shot(text_of(shot, length))};
    return {BANKSHOT_DONE, ""};
  });
  if (status == BANKSHOT_DONE && error) bankshot_free(error->data), *error = {nullptr, 0};
  return scene;
}

void bankshot_scene_free(bankshot_scene* scene) { delete scene; }

bankshot_status bankshot_simulate_many(const bankshot_scene* scene, const bankshot_launch* launches, size_t count,
                                       bankshot_end* ends, int threads) {
  if (!scene || (count > 0 && (!launches || !ends))) return BANKSHOT_BAD_INPUT;
  return guarded(nullptr, [&]() -> Result {
    const std::atomic<bool> never{false};
    bankshot::bindings::simulate_many(scene->request, {launches, count}, ends, threads, never);
    return {BANKSHOT_DONE, ""};
  });
}
