// SPDX-License-Identifier: MIT
//
// The record of a finished part of a batch: a small file beside its output (SHOTS.jsonl.part). From the records `merge`
// sees whether all parts belong to one batch and are complete, and which are missing. Marks count from the beginning of
// the whole input, so that the end of one part is the beginning of the next.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/batch/lines.hpp"

namespace bankshot::app::batch {

struct PartRecord {
  Part part;
  std::string flags;  ///< the flags that decide the answers
  ReadMark from, to;  ///< range of the input
  ReadMark output;    ///< the answers: lines, unpacked bytes, checksum
  long invalid = 0;   ///< number of invalid answers

  static std::string path_for(const std::string& output) { return output + ".part"; }
};

/// Returns the lines, unpacked bytes and checksum of a file.
ReadMark measured(const std::string& path);

/// Writes the record in one step: it is there completely or not at all. Throws WriteError.
void write_part(const std::string& output, const PartRecord& record);
/// Reads the record; none if there is no file. Throws FileError if it cannot be understood.
std::optional<PartRecord> read_part(const std::string& output);

/// Returns whether the output is exactly what the record says.
bool is_whole(const std::string& output, const PartRecord& record);

/// Moves a finished file to its name in one step, after syncing it to disk. Throws WriteError.
void put_in_place(const std::string& from, const std::string& to);

/// Reads "K/N". An empty text takes the part from the scheduler: SLURM_ARRAY_TASK_ID and _COUNT, OMPI_COMM_WORLD_RANK
/// and _SIZE, or PMI_RANK and _SIZE. Throws FileError.
Part part_of(const std::string& text);

}  // namespace bankshot::app::batch
