// SPDX-License-Identifier: GPL-3.0-or-later
// An hour of recording takes at most 60 MB in the database: extrapolated from a scripted hand on the
// demonstration's arm, recorded at 1 kHz through recorder and sink into a real file.
#include <iostream>

#include <gtest/gtest.h>

#include "app/services/base/assets.h"
#include "app/services/recording/pipeline.h"
#include "app/services/recording/unstored_trials.h"
#include "db/connection/connection.h"
#include "sim/scene/scene.h"
#include "tests/app/support/training_centre.h"

namespace torsio {
namespace {

constexpr double kStretch_s = 40.0;  // two twists of the scripted hand with approach and rest
constexpr double kHour_s = 3600.0;
constexpr double kLargestHour_bytes = 60e6;

/// Returns the size of all database pages, including those in the write-ahead log.
double size_bytes(Connection& connection) {
  const auto number = [&connection](const char* sql) {
    Statement row = connection.prepare(sql);
    row.execute();
    return row.step() ? static_cast<double>(row.int64(0)) : 0.0;
  };
  return number("PRAGMA page_count") * number("PRAGMA page_size");
}

TEST(RecordingSize, AnHourTakesAtMostSixtyMegabytes) {
  testing::TrainingCentre centre;
  SceneRequest request;
  request.assets = assetsFolder();
  request.id = "forearm";
  const Scene scene = loadScene(request);
  ScriptedTrial trial;
  trial.recording = {.trialId = centre.session().ids().newUuid(),
                     .traineeCode = "T-01",
                     .startedUtc_us = testing::kCentreTime_us,
                     .context = {.station = "station 1"}};
  trial.duration_s = kStretch_s;
  const double before = size_bytes(centre.connection());
  const std::unique_ptr<TrialSink> sink =
      recordingSink(centre.locator(), trial.recording.context, centre.folder());

  const TrialSummary summary = recordScriptedTrial(scene, trial, *sink);

  const double hour_bytes = (size_bytes(centre.connection()) - before) * kHour_s / kStretch_s;
  std::cout << "an hour of recording: " << hour_bytes / 1e6 << " MB\n";
  EXPECT_EQ(summary.samples, static_cast<std::int64_t>(kStretch_s * 1e3));
  EXPECT_LE(hour_bytes, kLargestHour_bytes);
  EXPECT_GT(hour_bytes, kLargestHour_bytes / 100.0);  // the samples were really stored
}

}  // namespace
}  // namespace torsio
