// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "app/connectors/foreign/foreign_map.h"
#include "sim/core/pose.h"

namespace torsio {

/// A parsed line of a recording.
struct ForeignPose {
  std::int64_t time_us = 0;  ///< since the first line, increasing
  std::int64_t place = 0;    ///< 0, 1, 2 ...; gaps skip numbers
  Pose pose;                 ///< metres and unit quaternion, in the file's frame
  double grip = 0.0;         ///< 0 open .. 1 closed; 0 if the map does not describe the jaw
};

/// Summary of a file.
struct ForeignFile {
  std::int64_t lines = 0;      ///< number of poses
  std::int64_t period_us = 0;  ///< of the stated rate, otherwise the mean between two lines
  std::string contentHash{};   ///< BLAKE2b-256 of the file
};

/// Reads a recording line by line and passes each pose with its line number (from 1; in Parquet its row) to
/// `take`. Throws Error:
/// kFileMissing, kFileUnreadable; kBadData, with file, line and rule, for missing columns or numbers, text,
/// NaN, invalid rotations, times that do not increase, fewer than two lines. Exceptions of `take` pass
/// through.
ForeignFile readForeignMotion(const ForeignMap& map, ForeignLayout layout, const ForeignRecording& recording,
                              const std::function<void(const ForeignPose&, std::size_t line)>& take);

}  // namespace torsio
