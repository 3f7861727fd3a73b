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

/// Whose files are read.
enum class ForeignLayout {
  kJigsaws,    ///< 76 numbers a line, no header, no time; GRS in a meta file
  kRosma,      ///< a header with blanks behind its commas, no time; columns are found by name
  kPerkTutor,  ///< XML lines of transforms with time stamps
  kCsv,        ///< a table under a header; the map names its columns
};

/// "jigsaws", "rosma", "perktutor", "csv". Throws Error{kUsage} for another word.
[[nodiscard]] ForeignLayout foreignLayout(const std::string& word);

/// How a rotation is written down. Named by the map, never guessed: each turns a vector from the frame of the
/// instrument to the frame of the recording.
enum class RotationForm { kNone, kQuaternionWxyz, kQuaternionXyzw, kMatrixRows, kMatrixColumns };
/// How many numbers it takes: 0, 4 or 9.
[[nodiscard]] std::size_t numbersOf(RotationForm form) noexcept;
/// As the map names it: "quaternion wxyz".
[[nodiscard]] std::string rotationName(RotationForm form);

/// What the closed and the open jaw read, in the numbers of the file.
struct ForeignGrip {
  std::string column{};  ///< csv: name of the column
  double open = 0.0;
  double closed = 0.0;  ///< not `open`
};

struct ForeignGroup {
  std::string code{};
  std::string label{};
};
/// Somebody as the source calls them.
struct ForeignPerson {
  std::string name{};
  std::string group{};  ///< code of a ForeignGroup
  std::string level{};
};
struct ForeignRater {
  std::string name{};
  std::string classCode{};  ///< of the record: "intern", "deputy_chief", "chief"
};
struct ForeignRecording {
  std::filesystem::path file{};  ///< absolute, or as the folder of the map says
  std::string name{};            ///< of the file, as marks call it
  std::string person{};
  std::string task{};
  std::string phase{};
  std::string occasion{};  ///< label; empty: nobody gave it a mark
  std::optional<std::int64_t> startedUtc_us{};
};
struct ForeignMark {
  std::string recording{};  ///< ForeignRecording::name
  std::string rater{};
  std::int64_t steps = 0;
};

/// What the files do not say of themselves.
struct ForeignMap {
  std::string name{};         ///< of the map's file, for messages
  std::string contentHash{};  ///< BLAKE2b-256 of the map's file
  std::string cohort{};
  std::string description{};
  std::string source{};  ///< where the data are from and under which licence
  std::string frame{};   ///< axes and origin, in words
  std::string unit{};    ///< "m", "cm" or "mm"
  double metresPerUnit = 1.0;
  RotationForm rotation = RotationForm::kNone;
  std::optional<double> rate_Hz{};  ///< empty: the file has times
  std::string timeColumn{};         ///< csv
  double usPerTime = 0.0;
  std::string instrument{};  ///< arm or device that is read; empty for csv
  std::array<std::string, 3> position{};
  std::vector<std::string> rotationColumns{};
  std::optional<ForeignGrip> grip{};
  bool leavesGaps = false;  ///< lines without a pose are left out; else they are refused
  std::vector<ForeignGroup> groups{};
  std::vector<ForeignPerson> people{};
  std::vector<ForeignRater> raters{};
  std::vector<ForeignRecording> recordings{};
  ScoreScale scale{};
  std::vector<ForeignMark> marks{};
};

/// Reads a map (docs/exchange.md) and the marks that it points to. Throws Error: kFileMissing,
/// kFileUnreadable; kBadData that names file, place and rule for what is missing, unknown, out of range or
/// does not fit together.
[[nodiscard]] ForeignMap readForeignMap(const std::filesystem::path& file, ForeignLayout layout);

}  // namespace torsio
