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

/// Twists per phase that are more than enough for a learning curve.
inline constexpr std::size_t kDemonstrationTwists = 10;

/// Results, for the last lines of output.
struct DemonstrationSummary {
  std::filesystem::path report;    ///< cohort.pdf
  std::filesystem::path table;     ///< cohort.csv
  std::filesystem::path database;  ///< torsio.sqlite
  std::int64_t trials = 0;
  std::int64_t samples = 0;
  std::int64_t twists = 0;
  double recorded_min = 0.0;  ///< simulated time
  TrialId firstTrialId;       ///< for trying `torsio replay`
};

struct DemonstrationOptions {
  std::filesystem::path out;  ///< folder; created if missing
  std::uint64_t seed = 1;
  /// One second of a simulated trial represents this many seconds of training; 1: full length.
  std::int64_t shortening = 60;
  /// Minimum twists per phase on the simulator, whatever the shortening; 0: as many as the time allows. A
  /// learning curve needs eight.
  std::size_t fewestTwists = 0;
  SceneRequest training;  ///< organ that the trainees twist
  SceneRequest example;   ///< a second organ, twisted once before the training
  /// Time of every row: a fixed, invented date (2026-01-05 08:00 UTC), so that the same seed gives the same
  /// record, including content hashes.
  std::int64_t simulatedUtc_us = 1'767'600'000'000'000;
  std::int64_t createdUtc_us = 0;  ///< printed on the report
  ProgressCallback progress;       ///< may be empty
  /// Writes `report` and `table` of the summary; required by runDemonstration().
  std::function<void(const CohortInputs&, const DemonstrationSummary&)> writeReport;
};

/// Runs the whole demonstration with production code on a manual clock: loads the organs, lets simulated
/// trainees twist them, records every tick, submits simulated marks, computes and stores the evaluation,
/// writes report and table. The same options give the same numbers. Throws Error; then the record has not
/// been replaced.
DemonstrationSummary runDemonstration(const DemonstrationOptions& options);

/// Stores people, trials and marks of a demonstration in an existing record, for a centre that wants to try
/// Torsio with data. Ignores `options.out`; writes no report. All or nothing. Throws Error, DbError.
DemonstrationSummary fillDemonstration(const DemonstrationOptions& options, Connection& connection);

}  // namespace torsio
