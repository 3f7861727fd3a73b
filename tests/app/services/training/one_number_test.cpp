// SPDX-License-Identifier: GPL-3.0-or-later
// Report, debrief, trend, mastery, metrics, transcript and export show the same number for the same run,
// equal to the one that the recording was generated with.
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "app/outputs/report/report_data.h"
#include "app/services/recording/trial_playback.h"
#include "app/services/training/debrief.h"
#include "app/services/training/transcript.h"
#include "app/services/training/trend.h"
#include "assessment/attempt/trial_digest.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/study/protocol_terms.h"
#include "assessment/results/cohort_csv.h"
#include "db/connection/connection.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/random.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/app/support/training_centre.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

constexpr std::uint64_t kRunSeed = 20251122;
constexpr int kRecordings = 200;
constexpr double kTolerance_deg = 5.0;  // of the centre's modules

/// Values that a recording was generated with.
struct Truth {
  std::int64_t completed = 0;
  std::int64_t onTarget = 0;
  std::int64_t unfinished = 0;
  double errorSum_deg = 0.0;
};

/// A random recording: time stamps with jitter, some not increasing, short and long gaps, targets that change
/// before and during a twist, touches, twists that are turned back, slip past the target, lose their device
/// or are cut off by the end.
class RandomRecording {
 public:
  RandomRecording(std::uint64_t stream, double firstTarget_deg)
      : random_(Random::forStream(kRunSeed, stream)), target_deg_(firstTarget_deg) {
    jitters_ = chance(0.8);
    const int twists = whole(1, 5);
    idle(whole(50, 300));
    for (int i = 0; i < twists; ++i) {
      if (chance(0.3)) {
        setTarget(between(30.0, 120.0));
      }
      if (chance(0.2)) {
        touch();
      }
      const bool last = i + 1 == twists;
      twist(last && chance(0.4));
    }
    if (chance(0.1)) {
      samples_[samples_.size() / 2].device.time_us = samples_.front().device.time_us;
    }
  }

  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
  [[nodiscard]] const Truth& truth() const { return truth_; }

 private:
  double between(double low, double high) { return low + (high - low) * random_.uniform(); }
  int whole(int low, int high) { return low + static_cast<int>(random_.uniform() * (high - low + 1)); }
  bool chance(double share) { return random_.uniform() < share; }

  void add(ExercisePhase phase, double angle_deg, std::uint32_t status = kDeviceOk) {
    Sample sample;
    sample.tick = tick_;
    sample.device.time_us = 1000 * tick_ + (jitters_ ? whole(-300, 300) : 0);
    sample.device.status = status;
    sample.device.position = {static_cast<std::int32_t>(1000 * angle_deg), whole(0, 50), 0};
    sample.command = next_;
    sample.phase = phase;
    sample.response.angle_rad = radians(angle_deg);
    sample.response.torque_Nm = 0.004 * angle_deg;
    sample.response.force_N = {0.01 * angle_deg, between(0.0, 0.1), 0.0};
    sample.force_N = 0.5 * sample.response.force_N;  // what the device could render
    samples_.push_back(sample);
    next_ = {};
    ++tick_;
  }
  void idle(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      add(ExercisePhase::kTracking, 0.0);
    }
  }
  void skip(int ticks) { tick_ += ticks; }
  void setTarget(double target_deg) {
    target_deg_ = target_deg;
    next_ = {ServoCommand::Kind::kSetTarget, radians(target_deg)};
  }
  void touch() {
    for (int i = 0; i < 80; ++i) {
      add(ExercisePhase::kTwisting, 1.5 * i / 80.0);
    }
    back(1.5);
  }
  void back(double angle_deg) {
    const int ticks = whole(100, 300);
    for (int i = 0; i < ticks; ++i) {
      add(ExercisePhase::kReleased, angle_deg * std::exp(-0.03 * i));
    }
    idle(whole(20, 200));
  }

  /// Errors keep a distance from the tolerance, where the quantisation of stored angles would matter.
  double error_deg() {
    return (chance(0.5) ? 1.0 : -1.0) * (chance(0.6) ? between(0.1, 4.5) : between(5.5, 25.0));
  }

  void twist(bool cutOff) {
    const int turn = whole(200, 500);
    const int stay = whole(50, 500);
    const double error = error_deg();
    const double end_deg = chance(0.1) ? 1.0 : target_deg_ + error;
    const double top_deg = target_deg_ + std::max(0.0, error);
    for (int i = 1; i <= turn; ++i) {
      add(ExercisePhase::kTwisting, top_deg * i / turn);
    }
    if (chance(0.15)) {
      skip(whole(2, 19));  // short: interpolated by the metrics
    }
    if (chance(0.1)) {
      skip(whole(25, 200));  // long: makes the metrics of this twist undefined
    }
    if (chance(0.15)) {
      next_ = {ServoCommand::Kind::kSetTarget, radians(end_deg - error)};
      target_deg_ = end_deg - error;
    }
    for (int i = 1; i <= stay; ++i) {
      add(ExercisePhase::kTwisting, top_deg + (end_deg - top_deg) * i / stay);
    }
    if (cutOff) {
      ++truth_.unfinished;
      return;
    }
    letGo(end_deg);
  }

  void letGo(double end_deg) {
    const bool blind = chance(0.1);
    const bool lost = chance(0.1);
    if (blind) {
      skip(whole(25, 60));
    }
    if (blind || lost) {
      ++truth_.unfinished;
    } else {
      const double error = std::abs(end_deg - target_deg_);
      ++truth_.completed;
      truth_.onTarget += error <= kTolerance_deg ? 1 : 0;
      truth_.errorSum_deg += error;
    }
    if (lost) {
      add(ExercisePhase::kReleased, end_deg, kDeviceLost);
    }
    if (!blind && !lost && chance(0.2)) {
      setTarget(between(30.0, 120.0));  // too late for this twist
    }
    back(end_deg);
  }

  Random random_;
  double target_deg_;
  bool jitters_ = true;
  std::int64_t tick_ = 1;
  ServoCommand next_;
  std::vector<Sample> samples_;
  Truth truth_;
};

/// A centre with 200 recordings of one trainee at one module.
class OneNumber : public ::testing::Test {
 protected:
  OneNumber() : centre_(setup()) {
    AccessRepository(centre_.connection(), PasswordCost::kTest)
        .addUser({.id = "statistician", .login = "statistician", .roles = {"statistician"}},
                 "a long enough password");
    Transaction transaction(centre_.connection());
    for (int i = 0; i < kRecordings; ++i) {
      record(i);
    }
    transaction.commit();
  }

  static TrainingCentre::Setup setup() {
    TrainingCentre::Setup setup;  // with an arm, so that the report has a group
    setup.phases.push_back(
        {.kind = PhaseKind::kVirtual, .label = "virtual", .duration_us = 1'000'000'000'000});
    return setup;
  }

  void record(int number) {
    const double firstTarget_deg = 90.0;
    const RandomRecording random(static_cast<std::uint64_t>(number), firstTarget_deg);
    Trial trial;
    trial.header.trialId = "trial " + std::to_string(1000 + number);
    trial.header.traineeCode = "T-01";
    trial.header.sceneId = "bar";
    trial.header.patternId = "quarter";
    trial.header.phaseLabel = "virtual";
    trial.header.parametersJson = "{}";
    trial.header.targetAngle_rad = radians(firstTarget_deg);
    trial.header.startedUtc_us = kCentreTime_us + number * kMinute_us;
    trial.chunks.push_back(encodeChunk(0, random.samples()));
    trial.summary.samples = trial.chunks.front().samples;
    trial.summary.contentHash = contentHash(trial);
    TrialRepository sink(centre_.connection(), {.station = "station 1",
                                                .enrolmentId = centre_.enrolment(),
                                                .moduleId = centre_.module("first"),
                                                .attemptMode = AttemptMode::kPractice});
    sink.begin(trial.header);
    sink.append(trial.chunks.front());
    sink.finish(trial.summary);
    truths_[trial.header.trialId] = random.truth();
  }

  /// Signs in a user who may compute results and reads the report's inputs.
  CohortInputs report() {
    centre_.become("statistician");
    TrialDigests digests{std::filesystem::path()};
    CohortInputs inputs = reportInputs(centre_.session(), {.cohortId = centre_.cohort().id}, digests);
    centre_.become("T-01");
    return inputs;
  }

  AttemptMeasures byTheCommandLine(const TrialId& trialId) {
    const LoadedRun run = loadStoredRun(centre_.locator(), trialId);
    const std::vector<Sample> samples = decodeTrial(run.trial);
    return measureAttempt(measureTwists(run.trial.header, samples, run.rules));
  }

  TrainingCentre centre_;
  std::map<std::string, Truth> truths_;
};

double meanError_deg(const std::vector<TwistResult>& twists) {
  double sum = 0.0;
  for (const TwistResult& twist : twists) {
    sum += degrees(std::abs(twist.released_rad - twist.target_rad));
  }
  return sum / static_cast<double>(twists.size());
}

TEST_F(OneNumber, IsTheSameForTheSameRunWhereverItIsRead) {
  // Each way is the first to read some of the runs: who measures must not matter.
  for (const auto& [trialId, truth] : truths_) {
    if (trialId.back() == '1') {
      static_cast<void>(debrief(centre_.session(), trialId, "no assets here"));
    }
    if (trialId.back() == '2') {
      static_cast<void>(attemptOf(centre_, trialId));
    }
  }
  const CohortInputs reported = report();
  const Transcript paper = transcript(centre_.session(), centre_.person());
  const Trend way = trend(centre_.session(), centre_.person(), centre_.module("first"));
  std::map<std::string, TrialSummaryRow> rows;
  for (const TrialSummaryRow& row : reported.trials) {
    rows[row.trialId] = row;
  }
  std::map<std::string, TrendPoint> points;
  for (const TrendPoint& point : way.points) {
    points[point.trialId] = point;
  }
  std::map<std::string, Attempt> attempts;
  for (const Attempt& attempt : paper.modules.at(0).attempts) {
    attempts[attempt.trialId] = attempt;
  }
  ASSERT_EQ(rows.size(), truths_.size());
  Truth all;
  for (const auto& [trialId, truth] : truths_) {
    all.completed += truth.completed;
    all.onTarget += truth.onTarget;
    all.unfinished += truth.unfinished;
  }
  EXPECT_GT(all.unfinished, 100);
  EXPECT_GT(all.onTarget, 100);
  EXPECT_GT(all.completed - all.onTarget, 100);

  for (const auto& [trialId, truth] : truths_) {
    const TrialSummaryRow& row = rows.at(trialId);
    const Attempt& attempt = attempts.at(trialId);
    const AttemptMeasures typed = byTheCommandLine(trialId);
    EXPECT_EQ(row.twists, truth.completed) << trialId;
    EXPECT_EQ(row.twistsOnTarget, truth.onTarget) << trialId;
    EXPECT_EQ(row.unfinishedTwists, truth.unfinished) << trialId;
    EXPECT_EQ(attempt.twists, truth.completed) << trialId;
    EXPECT_EQ(attempt.onTarget, truth.onTarget) << trialId;
    EXPECT_EQ(attempt.unfinished, truth.unfinished) << trialId;
    EXPECT_EQ(std::ssize(typed.twists), truth.completed) << trialId;
    EXPECT_EQ(typed.values, attempt.values) << trialId;
    EXPECT_EQ(typed.meanAbsoluteError_deg, row.meanAbsoluteError_deg) << trialId;
    if (truth.completed > 0) {
      EXPECT_EQ(valueIn(typed.values, Quantity::kPeakTorque), row.peakTorque_Nm) << trialId;
      EXPECT_EQ(valueIn(typed.values, Quantity::kPeakForce), row.peakForce_N) << trialId;
    } else {
      EXPECT_FALSE(row.peakTorque_Nm || row.peakForce_N) << trialId;
    }
    EXPECT_EQ(static_cast<double>(typed.duration_us) / 60e6, row.minutes) << trialId;
    EXPECT_DOUBLE_EQ(attempt.duration_s / 60.0, row.minutes) << trialId;
    const auto share = attempt.values.find(Quantity::kOnTarget);
    EXPECT_EQ(points.at(trialId).value.has_value(), truth.completed > 0) << trialId;
    if (truth.completed == 0) {
      continue;
    }
    const auto completed = static_cast<double>(truth.completed);
    EXPECT_NEAR(*row.meanAbsoluteError_deg, truth.errorSum_deg / completed, 1e-4) << trialId;
    EXPECT_DOUBLE_EQ(share->second, static_cast<double>(truth.onTarget) / completed) << trialId;
    EXPECT_EQ(points.at(trialId).value, share->second) << trialId;
  }
}

TEST_F(OneNumber, IsTheSameInTheDebriefAndInItsMasteryCheck) {
  const CohortInputs reported = report();
  ASSERT_EQ(reported.trials.size(), truths_.size());

  for (const TrialSummaryRow& row : reported.trials) {
    if (row.trialId.text().back() != '3' && row.trialId.text().back() != '7') {
      continue;  // a debrief is slow
    }
    const Debrief told = debrief(centre_.session(), row.trialId, "no assets here");
    const auto passed =
        std::count_if(told.twists.begin(), told.twists.end(), [](const TwistResult& t) { return t.passed; });
    EXPECT_EQ(std::ssize(told.twists), row.twists) << row.trialId;
    EXPECT_EQ(passed, row.twistsOnTarget) << row.trialId;
    EXPECT_EQ(told.unfinishedTwists, row.unfinishedTwists) << row.trialId;
    EXPECT_DOUBLE_EQ(told.duration_s / 60.0, row.minutes) << row.trialId;
    ASSERT_EQ(told.verdict.checks.front().quantity, Quantity::kTargetsReached);
    EXPECT_EQ(told.verdict.checks.front().value, static_cast<double>(row.twistsOnTarget)) << row.trialId;
    const TargetCheck& mastery = told.verdict.checks.back();
    ASSERT_EQ(mastery.quantity, Quantity::kOnTarget);
    EXPECT_EQ(mastery.value.has_value(), row.twists > 0) << row.trialId;
    if (row.twists == 0) {
      continue;
    }
    EXPECT_DOUBLE_EQ(*mastery.value,
                     static_cast<double>(row.twistsOnTarget) / static_cast<double>(row.twists));
    EXPECT_NEAR(meanError_deg(told.twists), *row.meanAbsoluteError_deg, 1e-9) << row.trialId;
  }
}

TEST_F(OneNumber, IsTheSameInTheExportedTable) {
  const CohortInputs reported = report();
  std::map<std::string, std::map<std::string, std::string>> cells;  // by trial: statistic -> value
  std::map<std::string, std::string> block;
  for (const CohortCsvRow& row : cohortCsvRows(reported)) {
    if (row.section != "trial") {
      continue;
    }
    block[row.statistic] = row.value;
    if (row.statistic == "trial") {
      cells[row.value] = std::exchange(block, {});
    }
  }

  ASSERT_EQ(cells.size(), truths_.size());
  for (auto& [trialId, of] : cells) {
    const Truth& truth = truths_.at(trialId);
    EXPECT_EQ(of["twists"], std::to_string(truth.completed)) << trialId;
    EXPECT_EQ(of["twists_on_target"], std::to_string(truth.onTarget)) << trialId;
    EXPECT_EQ(of["twists_not_completed"], std::to_string(truth.unfinished)) << trialId;
  }
}

TEST_F(OneNumber, RunsMeasuredByOlderFormulasAreMeasuredAgain) {
  const TrialId trialId = truths_.begin()->first;
  const std::string hash = TrialRepository(centre_.connection()).load(trialId).summary.contentHash;
  TrialDigest older;
  older.trialId = trialId;
  older.formulaVersion = kMetricsVersion - 1;
  older.tolerance_rad = radians(kTolerance_deg);
  older.forceLimit_N = 4.0;
  older.contentHash = hash;
  older.measures.values = {{Quantity::kOnTarget, 0.123}};
  DigestRepository(centre_.connection()).add({&older, 1});

  const Attempt attempt = attemptOf(centre_, trialId);

  EXPECT_EQ(attempt.twists, truths_.at(trialId).completed);
  EXPECT_EQ(DigestRepository(centre_.connection()).ofTrial(trialId, kMetricsVersion).size(), 1U);
}

}  // namespace
}  // namespace torsio
