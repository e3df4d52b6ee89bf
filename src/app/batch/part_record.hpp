// SPDX-License-Identifier: MIT
//
// What is known of a part of a batch when it is done: a small file beside its output (SHOTS.jsonl.part) by which
// `merge` tells that all parts are of one batch, whole, and which are missing. Marks count from the beginning of the
// whole input, so that the end of one part is the beginning of the next.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/batch/lines.hpp"

namespace bankshot::app::batch {

struct PartRecord {
  Part part;
  std::string flags;  ///< that decide the answers
  ReadMark from, to;  ///< of the input
  ReadMark output;    ///< the answers: lines, bytes unpacked, checksum
  long invalid = 0;   ///< answers

  static std::string path_for(const std::string& output) { return output + ".part"; }
};

/// Lines, bytes and checksum of a file, unpacked.
ReadMark measured(const std::string& path);

/// In one step: it is there whole or not at all. Throws WriteError.
void write_part(const std::string& output, const PartRecord& record);
/// None where there is none; throws FileError where it cannot be understood.
std::optional<PartRecord> read_part(const std::string& output);

/// The output is all that the record says.
bool is_whole(const std::string& output, const PartRecord& record);

/// Moves a finished file to its name in one step, safely on disk. Throws WriteError.
void put_in_place(const std::string& from, const std::string& to);

/// "K/N", or from what a scheduler says where it is empty: SLURM_ARRAY_TASK_ID and _COUNT,
/// OMPI_COMM_WORLD_RANK and _SIZE, PMI_RANK and _SIZE. Throws FileError.
Part part_of(const std::string& text);

}  // namespace bankshot::app::batch
