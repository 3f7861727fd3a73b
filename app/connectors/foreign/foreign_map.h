// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// Supported sources.
enum class ForeignLayout {
  kJigsaws,    ///< 76 numbers per line, no header, no time; GRS in a meta file
  kRosma,      ///< a header with spaces after its commas, no time; columns are found by name
  kPerkTutor,  ///< XML lines of time-stamped transforms
  kCsv,        ///< a table with a header; the map names its columns
  kParquet,    ///< a table in Parquet; the map names its columns
};

/// Returns whether the map names the columns.
[[nodiscard]] inline bool namesColumns(ForeignLayout layout) noexcept {
  return layout == ForeignLayout::kCsv || layout == ForeignLayout::kParquet;
}

/// Parses "jigsaws", "rosma", "perktutor", "csv" or "parquet". Throws Error{kUsage} for another word.
[[nodiscard]] ForeignLayout foreignLayout(const std::string& word);

/// Notation of a rotation, which takes a vector from the instrument's frame to that of the recording. The map
/// states it; it is never guessed.
enum class RotationForm { kNone, kQuaternionWxyz, kQuaternionXyzw, kMatrixRows, kMatrixColumns };
/// Count of numbers: 0, 4 or 9.
[[nodiscard]] std::size_t numbersOf(RotationForm form) noexcept;
/// Returns the name used in maps: "quaternion wxyz".
[[nodiscard]] std::string rotationName(RotationForm form);

/// Readings of the closed and of the open jaw, in the file's own numbers.
struct ForeignGrip {
  std::string column{};  ///< of a table: column name
  double open = 0.0;
  double closed = 0.0;  ///< differs from `open`
};

struct ForeignGroup {
  std::string code{};
  std::string label{};
};
/// A person under the name that the source uses.
struct ForeignPerson {
  std::string name{};
  std::string group{};  ///< code of a ForeignGroup
  std::string level{};
};
struct ForeignRater {
  std::string name{};
  std::string classCode{};  ///< in this record: "intern", "deputy_chief", "chief"
};
struct ForeignRecording {
  std::filesystem::path file{};           ///< absolute, or relative to the map's folder
  std::string name{};                     ///< by which marks refer to it: the file's, "FILE#3" for an episode
  std::optional<std::int64_t> episode{};  ///< its rows in a table with several, as in LeRobot
  std::string person{};
  std::string task{};
  std::string phase{};
  std::string occasion{};  ///< label; empty: it has no marks
  std::optional<std::int64_t> startedUtc_us{};
};
struct ForeignMark {
  std::string recording{};  ///< ForeignRecording::name
  std::string rater{};
  std::int64_t steps = 0;
};

/// What the files do not contain.
struct ForeignMap {
  std::string name{};         ///< of the map file, for messages
  std::string contentHash{};  ///< BLAKE2b-256 of the map file
  std::string cohort{};
  std::string description{};
  std::string source{};  ///< origin and licence of the data
  std::string frame{};   ///< axes and origin, in words
  std::string unit{};    ///< "m", "cm" or "mm"
  double metresPerUnit = 1.0;
  bool unitConfirmed = false;  ///< although the movements would fit another unit better
  RotationForm rotation = RotationForm::kNone;
  std::optional<double> rate_Hz{};  ///< empty: the file contains times
  std::string timeColumn{};         ///< of a table only
  std::string timeUnit{};           ///< "s", "ms", "us" or "ns"; of timeColumn
  double timeUnit_s = 0.0;          ///< the same in seconds
  bool timeConfirmed = false;       ///< although the times would fit another unit better
  std::string instrument{};         ///< arm or device to read; empty for a table
  std::array<std::string, 3> position{};
  std::vector<std::string> rotationColumns{};
  std::optional<ForeignGrip> grip{};
  bool leavesGaps = false;  ///< skip lines without a pose instead of refusing them
  std::vector<ForeignGroup> groups{};
  std::vector<ForeignPerson> people{};
  std::vector<ForeignRater> raters{};
  std::vector<ForeignRecording> recordings{};
  ScoreScale scale{};
  bool scaleConfirmed = false;  ///< although the marks use hardly any of it
  std::vector<ForeignMark> marks{};
};

/// Reads a map (docs/exchange.md) and the marks that it refers to. Throws Error: kFileMissing,
/// kFileUnreadable; kBadData, with file, place and rule, if something is missing, unknown, out of range or
/// inconsistent.
[[nodiscard]] ForeignMap readForeignMap(const std::filesystem::path& file, ForeignLayout layout);

}  // namespace torsio
