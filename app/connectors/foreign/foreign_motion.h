// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "app/connectors/foreign/foreign_map.h"
#include "sim/core/pose.h"

namespace torsio {

/// One line of a foreign recording, understood.
struct ForeignPose {
  std::int64_t time_us = 0;  ///< since the first line, rising
  std::int64_t place = 0;    ///< 0, 1, 2 ...; lines of gaps leave their numbers out
  Pose pose;                 ///< metres and unit quaternion, in the frame of the file
  double grip = 0.0;         ///< 0 open .. 1 closed; 0 where the map says nothing of the jaw
};

/// What was read of a file.
struct ForeignFile {
  std::int64_t lines = 0;      ///< poses
  std::int64_t period_us = 0;  ///< by the stated rate, else the mean distance of two lines
  std::string contentHash{};   ///< BLAKE2b-256 of the file
};

/// Reads one recording as the map says, line by line, and hands on each pose with its line (from 1). Throws
/// Error: kFileMissing, kFileUnreadable; kBadData that names file, line and rule for missing columns or
/// numbers, text, NaN, rotations that are none, times that do not rise, fewer than two lines. What `take`
/// throws is passed on.
ForeignFile readForeignMotion(const ForeignMap& map, ForeignLayout layout, const ForeignRecording& recording,
                              const std::function<void(const ForeignPose&, std::size_t line)>& take);

}  // namespace torsio
