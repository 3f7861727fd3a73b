// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "app/services/base/progress.h"
#include "assessment/domain/ids.h"
#include "sim/scene/scene.h"

namespace torsio {

class Connection;
struct CohortInputs;

/// Twists in a phase that give everybody a learning curve, with some to spare.
inline constexpr std::size_t kDemonstrationTwists = 10;

/// What was written, for the last lines on the screen.
struct DemonstrationSummary {
  std::filesystem::path report;    ///< cohort.pdf
  std::filesystem::path table;     ///< cohort.csv
  std::filesystem::path database;  ///< torsio.sqlite
  std::int64_t trials = 0;
  std::int64_t samples = 0;
  std::int64_t twists = 0;
  double recorded_min = 0.0;  ///< simulated time
  TrialId firstTrialId;       ///< to try `torsio replay` with
};

struct DemonstrationOptions {
  std::filesystem::path out;  ///< folder; made if missing
  std::uint64_t seed = 1;
  /// One second of a simulated trial stands for this many seconds of training; 1: full length.
  std::int64_t shortening = 60;
  /// Twists in every phase on the simulator at least, whatever the shortening: 0 leaves it to the time. Eight
  /// are the fewest for a learning curve.
  std::size_t fewestTwists = 0;
  SceneRequest training;  ///< what the trainees twist
  SceneRequest example;   ///< a second organ, twisted once before the training
  /// Stamped on every row: a stated, invented date (2026-01-05 08:00 UTC), so that the same seed gives the
  /// same record, content hashes included.
  std::int64_t simulatedUtc_us = 1'767'600'000'000'000;
  std::int64_t createdUtc_us = 0;  ///< printed on the report
  ProgressCallback progress;       ///< may be empty
  /// Writes `report` and `table` of the summary; runDemonstration() needs it.
  std::function<void(const CohortInputs&, const DemonstrationSummary&)> writeReport;
};

/// The main job, end to end, through the same code as the real thing but on a manual clock: load the organs,
/// let simulated trainees twist them, record every tick, submit simulated marks, compute and store the
/// evaluation, write report and table. Same options, same numbers. Throws Error; then the record has not been
/// replaced.
DemonstrationSummary runDemonstration(const DemonstrationOptions& options);

/// Stores the people, trials and marks of a demonstration in an existing record, for a centre that wants data
/// to try things on. `options.out` is not used; no report is written. All or nothing. Throws Error, DbError.
DemonstrationSummary fillDemonstration(const DemonstrationOptions& options, Connection& connection);

}  // namespace torsio
