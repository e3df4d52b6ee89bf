// SPDX-License-Identifier: MIT
#include "app/batch/part_record.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "app/files.hpp"
#include "app/gzip.hpp"
#include "io/json/document.hpp"
#include "io/json/reader.hpp"

namespace bankshot::app::batch {
namespace {

Json json_of(const ReadMark& m) { return {{"lines", m.lines}, {"bytes", m.bytes}, {"crc", m.crc}}; }

ReadMark mark_of(const Reader& r) {
  return {r.need("lines").count(), r.need("bytes").count(), static_cast<std::uint32_t>(r.need("crc").count())};
}

std::optional<long> whole_number(std::string_view text) {
  long n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(n) : std::nullopt;
}

std::optional<long> variable(const std::string& name) {
  const char* const value = std::getenv(name.c_str());
  return value ? whole_number(value) : std::nullopt;
}

/// Flushes a file's bytes, or a folder's names, to disk; returns false if that fails.
bool settle(const std::string& path) {
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool settled = fsync(fd) == 0;
  const int error = errno;
  close(fd);
  errno = error;
  return settled;
}

Part of_scheduler() {
  if (const auto id = variable("SLURM_ARRAY_TASK_ID"), count = variable("SLURM_ARRAY_TASK_COUNT"); id && count) {
    const long first = variable("SLURM_ARRAY_TASK_MIN").value_or(0),
               last = variable("SLURM_ARRAY_TASK_MAX").value_or(first + *count - 1);
    if (first != 0 || last != *count - 1)
      throw FileError(fmt::format(
          "--part: of a Slurm array that is not 0-N the parts are not known; say how many: --part {}/N", *id));
    return {*id, *count};
  }
  for (const std::string launcher : {"OMPI_COMM_WORLD_", "PMI_"})
    if (const auto rank = variable(launcher + "RANK"), size = variable(launcher + "SIZE"); rank && size)
      return {*rank, *size};
  throw FileError("--part: no scheduler says which part this is; give it as --part K/N, K from 0 to N - 1");
}

}  // namespace

ReadMark measured(const std::string& path) {
  ByteReader in(path);
  ReadMark m;
  for (std::string_view piece; !(piece = in.next()).empty();) {
    m.lines += std::count(piece.begin(), piece.end(), '\n');
    m.bytes += static_cast<long>(piece.size());
    m.crc = checksum(m.crc, piece.data(), piece.size());
  }
  return m;
}

void put_in_place(const std::string& from, const std::string& to) {
  if (!settle(from) || std::rename(from.c_str(), to.c_str()) != 0)
    throw WriteError(fmt::format("{}: cannot be written: {}", to, std::strerror(errno)));
  const auto folder = std::filesystem::path(to).parent_path();
  // Not every file system can sync a folder; then it does so in its own time.
  settle(folder.empty() ? "." : folder.string());
}

void write_part(const std::string& output, const PartRecord& r) {
  const Json j{{"bankshot", BANKSHOT_VERSION},
               {"part", r.part.k},
               {"of", r.part.n},
               {"flags", r.flags},
               {"from", json_of(r.from)},
               {"to", json_of(r.to)},
               {"output", json_of(r.output)},
               {"invalid", r.invalid}};
  const std::string path = PartRecord::path_for(output), partial = path + ".partial";
  write_file(partial, j.dump() + "\n");
  put_in_place(partial, path);
}

std::optional<PartRecord> read_part(const std::string& output) {
  const std::string path = PartRecord::path_for(output);
  if (!std::filesystem::exists(path)) return {};
  const std::string text = read_file(path);
  try {
    const Json json = parse_document(text);
    const Reader r(json);
    if (const std::string version = r.need("bankshot").text(); version != BANKSHOT_VERSION)
      r.need("bankshot").fail("another version of bankshot made this part");
    PartRecord record{{r.need("part").count(), r.need("of").count()},
                      r.need("flags").text(),
                      mark_of(r.need("from")),
                      mark_of(r.need("to")),
                      mark_of(r.need("output")),
                      r.need("invalid").count()};
    return record;
  } catch (const InvalidInput& e) {
    throw FileError(complaint(path, e));
  }
}

bool is_whole(const std::string& output, const PartRecord& r) try {
  return std::filesystem::exists(output) && r.output.lines == r.to.lines - r.from.lines && measured(output) == r.output;
} catch (const FileError&) {
  return false;  // a gzip file that was cut off
}

Part part_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  Part part;
  if (text.empty()) {
    part = of_scheduler();
  } else {
    const auto k = whole_number(std::string_view(text).substr(0, slash));
    const auto n = slash == std::string::npos ? std::nullopt : whole_number(std::string_view(text).substr(slash + 1));
    if (!k || !n) throw FileError(fmt::format("--part: \"{}\" is not K/N, such as 0/64", text));
    part = {*k, *n};
  }
  constexpr long most = 1000000;
  if (!(part.n >= 1 && part.n <= most && part.k >= 0 && part.k < part.n))
    throw FileError(
        fmt::format("--part: {}/{} is no part: K is from 0 to N - 1, and N at most {}", part.k, part.n, most));
  return part;
}

}  // namespace bankshot::app::batch
