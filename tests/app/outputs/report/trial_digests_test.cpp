// SPDX-License-Identifier: GPL-3.0-or-later
// Digests of recordings: measured once, on every core, and stored.
#include "app/services/recording/trial_digests.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/recording/kept_digests.h"
#include "assessment/attempt/trial_digest.h"
#include "assessment/catalogue/quantity.h"
#include "db/connection/connection.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/record/sample_codec.h"
#include "tests/app/outputs/report/small_study.h"

namespace torsio {
namespace {

using testing::record;
using testing::SmallStudy;

TEST(TrialDigests, AreMeasuredOnceAndReadBackBitForBit) {
  SmallStudy study;
  record(study, "first", 100);
  record(study, "second", 70);
  SessionContext& session = study.centre.as("statistician");

  const std::vector<TrialSummaryRow> measured = study.digests.ofCohort(session, study.request.cohortId);
  TrialDigests later(study.centre.assets());
  const std::vector<TrialSummaryRow> kept = later.ofCohort(session, study.request.cohortId);

  EXPECT_EQ(study.digests.measured(), 2U);
  EXPECT_EQ(later.measured(), 0U);
  ASSERT_EQ(kept.size(), 2U);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(kept[i].trialId, measured[i].trialId);
    EXPECT_EQ(kept[i].trainee, measured[i].trainee);
    EXPECT_EQ(kept[i].phase, measured[i].phase);
    EXPECT_EQ(kept[i].model, measured[i].model);
    EXPECT_EQ(kept[i].minutes, measured[i].minutes);
    EXPECT_EQ(kept[i].samples, measured[i].samples);
    EXPECT_EQ(kept[i].twists, 1);
    EXPECT_EQ(kept[i].twistsOnTarget, measured[i].twistsOnTarget);
    EXPECT_EQ(kept[i].meanAbsoluteError_deg, measured[i].meanAbsoluteError_deg);
    EXPECT_EQ(kept[i].peakTorque_Nm, measured[i].peakTorque_Nm);
    EXPECT_EQ(kept[i].peakForce_N, measured[i].peakForce_N);
    EXPECT_EQ(kept[i].lateTicks, 3);
    EXPECT_EQ(kept[i].contentHash, measured[i].contentHash);
    EXPECT_EQ(kept[i].attempts, measured[i].attempts);
  }
}

TEST(TrialDigests, OfOtherFormulaVersionsAreKeptAndMeasuredAgain) {
  SmallStudy study;
  record(study, "first", 100);
  TrialDigest older{
      .trialId = "first", .formulaVersion = kMetricsVersion - 1, .contentHash = "hash of first"};
  DigestRepository(study.centre.connection()).add({&older, 1});

  const auto digests = study.digests.ofCohort(study.centre.as("statistician"), study.request.cohortId);

  EXPECT_EQ(study.digests.measured(), 1U);
  EXPECT_EQ(digests.at(0).twists, 1);
  EXPECT_EQ(DigestRepository(study.centre.connection())
                .ofCohort(study.request.cohortId, kMetricsVersion - 1)
                .size(),
            1U);
}

TEST(TrialDigests, AreRestoredBitForBitWithTheirRules) {
  SmallStudy study;
  record(study, "first", 100);
  DigestRepository repository(study.centre.connection());
  TrialDigest free;
  free.trialId = "first";
  free.formulaVersion = kMetricsVersion;
  free.tolerance_rad = 0.1;
  free.contentHash = "hash of first";
  free.measures.twists = {{1.0 / 3.0, true}, {20.0, false}};
  free.measures.values = {{Quantity::kPeakForce, 0.1 + 0.2}, {Quantity::kSparc, -1.4}};
  TrialDigest limited = free;
  limited.forceLimit_N = 0.0;  // a limit of zero differs from no limit
  limited.torqueLimit_Nm = 0.5;
  const std::vector<TrialDigest> both{free, limited};

  repository.add(both);
  repository.add(both);

  EXPECT_THAT(repository.ofTrial("first", kMetricsVersion), ::testing::UnorderedElementsAreArray(both));
}

TEST(TrialDigests, OfARecordingWithOtherContentAreIgnored) {
  SmallStudy study;
  record(study, "first", 100);
  TrialDigest other{.trialId = "first", .formulaVersion = kMetricsVersion, .contentHash = "of another"};
  other.tolerance_rad = 1.0;
  DigestRepository(study.centre.connection()).add({&other, 1});

  (void)study.digests.ofCohort(study.centre.as("statistician"), study.request.cohortId);

  EXPECT_EQ(study.digests.measured(), 1U);
}

TEST(TrialDigests, OfManyRecordingsMatchThoseOfOneCoreInOrder) {
  constexpr std::size_t kRecordings = 300;  // more than are stored, read and measured at a time
  SmallStudy study;
  Transaction together(study.centre.connection());
  for (std::size_t i = 0; i < kRecordings; ++i) {
    record(study, "r" + std::to_string(1000 + i), 20 + i % 170);
  }
  together.commit();
  SessionContext& session = study.centre.as("statistician");
  std::vector<std::string> told;

  const std::vector<TrialSummaryRow> rows = study.digests.ofCohort(
      session, study.request.cohortId, [&told](const Progress& now) { told.push_back(now.step.str()); });

  EXPECT_EQ(study.digests.measured(), kRecordings);
  ASSERT_EQ(rows.size(), kRecordings);
  EXPECT_EQ(told.front(), "Reading recording 1 of 300");
  EXPECT_GT(told.size(), 3U);
  const DigestRepository kept(study.centre.connection());
  const TrialRepository trials(study.centre.connection());
  for (std::size_t i = 0; i < kRecordings; ++i) {
    const std::string id = "r" + std::to_string(1000 + i);
    EXPECT_EQ(rows[i].trialId, id);
    const Trial trial = trials.load(id);
    const AttemptRules rules = ExerciseRules(study.centre.assets()).ofPattern("forearm", "pronation");
    const AttemptMeasures alone = measureAttempt(trial.header, decodeTrial(trial), rules);
    EXPECT_THAT(kept.ofTrial(id, kMetricsVersion),
                ::testing::ElementsAre(keptDigest(trial, alone, rules, testing::kStudyTime_us)));
  }
}

TEST(TrialDigests, AnUnreadableRecordingStopsTheReportButKeepsWhatWasMeasured) {
  SmallStudy study;
  Transaction together(study.centre.connection());
  for (std::size_t i = 0; i < 300; ++i) {
    record(study, "r" + std::to_string(1000 + i), 50);
  }
  record(study, "r2000", 50, "{}", false);
  together.commit();

  EXPECT_THROW((void)study.digests.ofCohort(study.centre.as("statistician"), study.request.cohortId), Error);

  EXPECT_EQ(
      DigestRepository(study.centre.connection()).ofCohort(study.request.cohortId, kMetricsVersion).size(),
      256U);
}

}  // namespace
}  // namespace torsio
