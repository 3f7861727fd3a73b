// SPDX-License-Identifier: GPL-3.0-or-later
// While the database is unreachable, the recorder writes files; the station's next start stores them in the
// record before it closes anything as interrupted.
#include "app/services/recording/station_start.h"

#include <string>

#include <gtest/gtest.h>

#include "app/services/access/station_name.h"
#include "app/services/base/build_info.h"
#include "app/services/recording/recording_spec.h"
#include "app/services/recording/station_writer.h"
#include "app/services/recording/unstored_trials.h"
#include "app/services/training/run_session.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/id_source.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/station_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/content_hash.h"
#include "sim/record/recorder.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial_file.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"
#include "tests/app/support/training_centre.h"
#include "tests/support/stored_rows.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

/// A simulated machine: Linux with one graphics card.
class Machine {
 public:
  Machine() : root_(fs::temp_directory_path() / ("torsio-host-" + SystemIdSource().newUuid())) {}
  ~Machine() {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  void file(const std::string& name, const std::string& text) const {
    ensureFolder((root_ / name).parent_path());
    writeFileAtomically(root_ / name, text);
  }
  [[nodiscard]] const fs::path& root() const { return root_; }

 private:
  fs::path root_;
};

class StationStartTest : public ::testing::Test {
 protected:
  StationStartTest() : centre_(setup()) {}

  static TrainingCentre::Setup setup() {
    TrainingCentre::Setup setup;
    setup.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual 10 min", .duration_us = 10 * kMinute_us}};
    return setup;
  }

  /// Returns the specification of a run at this station.
  RecordingSpec newRecording() {
    const ManualClock clock;
    RunSession runSession(centre_.session(), {centre_.module("first"), true, deviceWith(Light::kGreen)},
                          clock);
    runSession.start();
    return runSession.newTrial();
  }

  static ScriptedHand hand() {
    ScriptedHandOptions options;
    options.task = handTask(trainingBar());
    options.duration_s = 60.0;
    return ScriptedHand(options);
  }

  /// Returns the recorder's header for such a recording.
  static TrialHeader headerOf(const RecordingSpec& spec) {
    return headerFor(trainingBar(), hand().capabilities(), spec);
  }

  /// Records `seconds` of a scripted hand into `sink`, passing on each complete second. Without `finish`, the
  /// program dies at the end. The recorder has no patience, so that its file begins with the first second.
  std::optional<RecordingResult> record(const RecordingSpec& spec, TrialSink& sink, int seconds,
                                        bool finish) {
    ScriptedHand device = hand();
    SpscRing<Sample> ring(kRecordingRing);
    Recorder recorder(ring, sink, headerOf(spec), {.attempts = 1, .spillFolder = folder()});
    ServoLoop servo({.device = &device, .scene = &trainingBar(), .recording = &ring}, {});
    for (std::int64_t tick = 0; tick < seconds * 1000; ++tick) {
      servo.tick(tick * kTickPeriod_us);
      if (tick % 1000 == 999) {
        recorder.pump();
      }
    }
    if (!finish) {
      return std::nullopt;
    }
    return recorder.finish(TrialOutcome::kCompleted, 0);
  }

  /// Records while the database cannot be opened.
  std::optional<RecordingResult> recordWithoutDatabase(const RecordingSpec& spec, int seconds, bool finish) {
    const fs::path database = centre_.locator();
    const fs::path aside = database.string() + ".away";
    const std::unique_ptr<TrialSink> sink = recordingSink(centre_.locator(), spec.context, folder());
    fs::rename(database, aside);
    std::optional<RecordingResult> result = record(spec, *sink, seconds, finish);
    fs::rename(aside, database);
    return result;
  }

  [[nodiscard]] fs::path folder() const { return centre_.folder() / "unstored"; }
  StationStart settle() { return settleStation(centre_.session(), folder()); }
  /// Makes the files look untouched for a long time.
  void letFilesRest() const {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder())) {
      fs::last_write_time(entry, fs::last_write_time(entry) - std::chrono::minutes(1));
    }
  }
  std::int64_t logged_us() {
    std::int64_t total_us = 0;
    for (const Exposure& exposure : StudyRepository(centre_.connection()).exposures(centre_.cohort().id)) {
      total_us += exposure.duration_us;
    }
    return total_us;
  }
  std::optional<AuditEntry> note(const std::string& action) {
    const std::vector<AuditEntry> entries =
        AuditRepository(centre_.connection()).entries({.objectKind = AuditObject::kTrial});
    for (const AuditEntry& entry : entries) {
      if (entry.action == action) {
        return entry;
      }
    }
    return std::nullopt;
  }

  TrainingCentre centre_;
};

TEST_F(StationStartTest, ARecordingFromAFileCountsAsWithoutTheFailure) {
  const RecordingSpec spec = newRecording();
  const std::optional<RecordingResult> result = recordWithoutDatabase(spec, 4, true);
  ASSERT_TRUE(result->spillFile.has_value());
  EXPECT_EQ(result->spillFile->parent_path(), folder());

  const StationStart start = settle();

  ASSERT_EQ(start.trials.size(), 1U);
  EXPECT_TRUE(start.kept.empty());
  EXPECT_TRUE(start.trials[0].fromFile);
  EXPECT_EQ(start.trials[0].exposureAdded_us, 4 * kSecond_us);
  EXPECT_EQ(logged_us(), 4 * kSecond_us);
  TrialRepository trials(centre_.connection());
  EXPECT_EQ(trials.context(spec.trialId), spec.context);
  const Trial stored = trials.load(spec.trialId);
  EXPECT_EQ(stored.summary.outcome, TrialOutcome::kCompleted);
  EXPECT_NO_THROW(verifyContent(stored));
  EXPECT_FALSE(fs::exists(*result->spillFile));
  EXPECT_TRUE(note("trial.import").has_value());
  EXPECT_TRUE(verifyAuditTrail(centre_.connection()).empty());
}

TEST_F(StationStartTest, TheFileIsStoredBeforeTheTrialIsClosedAsInterrupted) {
  const RecordingSpec spec = newRecording();
  TrialRepository(centre_.connection(), spec.context).begin(headerOf(spec));  // then the database became
                                                                              // unreachable
  ASSERT_TRUE(recordWithoutDatabase(spec, 3, true)->spillFile.has_value());
  centre_.passTime_us(kMinute_us);

  const StationStart start = settle();

  ASSERT_EQ(start.trials.size(), 1U);
  EXPECT_EQ(start.trials[0].trial.summary->outcome, TrialOutcome::kCompleted);
  EXPECT_EQ(start.trials[0].trial.summary->samples, 3'000);
  EXPECT_FALSE(note("trial.close_interrupted").has_value());
}

TEST_F(StationStartTest, ATruncatedFileIsStoredAsInterruptedOnceItIsNoLongerWritten) {
  const RecordingSpec spec = newRecording();
  recordWithoutDatabase(spec, 3, false);

  EXPECT_TRUE(settle().trials.empty());  // somebody may still be writing
  letFilesRest();
  const std::vector<RecoveredTrial> found = recoverInterrupted(centre_.session(), folder());

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].trialId, spec.trialId);
  EXPECT_EQ(found[0].moduleId, centre_.module("first"));
  EXPECT_EQ(found[0].recorded_s, 3.0);
  EXPECT_EQ(found[0].exposureAdded_s, 3.0);
  EXPECT_TRUE(fs::is_empty(folder()));
}

/// Its poses are not ticks of the simulator, and time on the real arm has its own clock.
TEST_F(StationStartTest, AnInterruptedTrackerRecordingAddsNoSimulatorTime) {
  RecordingSpec spec = newRecording();
  spec.context.moduleId = {};
  spec.context.attemptMode.reset();
  TrialHeader header = headerOf(spec);
  header.sceneId = std::string(kForeignScene);
  header.tickPeriod_us = 20'000;
  std::vector<Sample> samples(1'000);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].tick = static_cast<std::int64_t>(i);
    samples[i].device.time_us = samples[i].tick * header.tickPeriod_us;
  }
  {
    TrialRepository trials(centre_.connection(), spec.context);
    trials.begin(header);
    trials.append(encodeChunk(0, samples));
  }
  centre_.passTime_us(utcNow_us() - kCentreTime_us + kMinute_us);

  const StationStart start = settleStation(centre_.session(), folder());

  ASSERT_EQ(start.trials.size(), 1U);
  EXPECT_EQ(start.trials[0].trial.summary.value().outcome, TrialOutcome::kInterrupted);
  EXPECT_EQ(start.trials[0].exposureAdded_us, 0);
}

TEST_F(StationStartTest, AFileThatConflictsWithTheRecordIsKeptAndReported) {
  const RecordingSpec spec = newRecording();
  const fs::path file = *recordWithoutDatabase(spec, 3, true)->spillFile;
  TrialRepository trials(centre_.connection(), spec.context);
  trials.begin(headerOf(spec));
  ASSERT_EQ(trials.closeInterrupted("station 1", INT64_MAX).size(), 1U);  // another program was faster

  const StationStart start = settle();

  EXPECT_TRUE(start.trials.empty());
  ASSERT_EQ(start.kept.size(), 1U);
  EXPECT_NE(start.kept[0].str().find("already stored with different content"), std::string::npos)
      << start.kept[0];
  EXPECT_NE(start.kept[0].str().find("Its file is kept: " + file.string()), std::string::npos)
      << start.kept[0];
  EXPECT_TRUE(fs::exists(file));
  EXPECT_EQ(trials.load(spec.trialId).summary.samples, 0);
  EXPECT_FALSE(note("trial.import").has_value());
}

TEST_F(StationStartTest, ADamagedFileIsKeptAndTheOthersAreStored) {
  const RecordingSpec damaged = newRecording();
  const fs::path file = *recordWithoutDatabase(damaged, 2, true)->spillFile;
  std::string bytes = readFile(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  writeFileAtomically(file, bytes);
  ASSERT_TRUE(recordWithoutDatabase(newRecording(), 2, true)->spillFile.has_value());

  const StationStart start = settle();

  EXPECT_EQ(start.trials.size(), 1U);
  ASSERT_EQ(start.kept.size(), 1U);
  EXPECT_NE(start.kept[0].str().find("stays where it is"), std::string::npos) << start.kept[0];
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(StationStartTest, FilesOfAnotherDatabaseAreSkipped) {
  TrainingCentre other;
  const RecordingSpec spec = newRecording();
  const std::unique_ptr<TrialSink> sink =
      recordingSink((centre_.folder() / "elsewhere.sqlite").string(), spec.context, folder());
  const fs::path file = *record(spec, *sink, 2, true)->spillFile;

  const StationStart start = settle();

  EXPECT_TRUE(start.trials.empty());
  EXPECT_TRUE(start.kept.empty());
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(StationStartTest, NobodyNeedsToBeSignedInAndThisIsAudited) {
  const RecordingSpec spec = newRecording();
  ASSERT_TRUE(recordWithoutDatabase(spec, 2, true)->spillFile.has_value());
  centre_.session().setActor({});

  ASSERT_EQ(settle().trials.size(), 1U);

  EXPECT_EQ(note("trial.import")->actor, "torsio");
}

TEST_F(StationStartTest, ARunAppearsOnTheBoardUntilItEnds) {
  ManualClock clock;
  RunSession runSession(centre_.session(), {centre_.module("first"), true, deviceWith(Light::kGreen)}, clock);
  const auto second = [&] {
    clock.advance_us(kSecond_us);
    centre_.passTime_us(kSecond_us);
    static_cast<void>(runSession.advance());
  };

  runSession.start();
  EXPECT_EQ(stationOnBoard(centre_.connection(), "station 1")->trialId, "");
  EXPECT_EQ(stationOnBoard(centre_.connection(), "station 1")->userId, centre_.session().actor().userId);
  EXPECT_EQ(stationOnBoard(centre_.connection(), "station 1")->softwareVersion, softwareVersion());
  const RecordingSpec spec = runSession.newTrial();
  second();
  EXPECT_EQ(stationOnBoard(centre_.connection(), "station 1")->trialId,
            "");  // the recorder has not started it yet
  TrialRepository(centre_.connection(), spec.context).begin(headerOf(spec));
  second();
  EXPECT_EQ(stationOnBoard(centre_.connection(), "station 1")->trialId, spec.trialId);
  const std::int64_t first_us = stationOnBoard(centre_.connection(), "station 1")->heartbeatUtc_us;
  for (int i = 0; i < 25; ++i) {
    second();
  }
  EXPECT_EQ(stationOnBoard(centre_.connection(), "station 1")->heartbeatUtc_us, first_us + 2 * kHeartbeat_us);
  runSession.stop("power");
  EXPECT_EQ(stationOnBoard(centre_.connection(), "station 1")->trialId, "");
}

TEST_F(StationStartTest, AStationThatIsClosedDownLeavesTheBoard) {
  StationHeartbeat heartbeat(centre_.session());
  heartbeat.send();
  ASSERT_TRUE(stationOnBoard(centre_.connection(), "station 1").has_value());

  heartbeat.leave();

  EXPECT_FALSE(stationOnBoard(centre_.connection(), "station 1").has_value());
}

TEST_F(StationStartTest, ACopyThatIsTheSameStationAtTheSameTimeIsNoticed) {
  StationHeartbeat one(centre_.session());
  StationHeartbeat copy(centre_.session());
  const auto beat = [&](StationHeartbeat& station) {
    centre_.passTime_us(kHeartbeat_us);
    station.send();
  };
  beat(one);
  beat(one);
  EXPECT_FALSE(one.hasTwin());
  beat(copy);
  EXPECT_FALSE(copy.hasTwin()) << "whatever was there before it started may be its own past";

  beat(one);
  EXPECT_TRUE(one.hasTwin());
  beat(copy);
  EXPECT_TRUE(copy.hasTwin());

  copy.leave();
  centre_.passTime_us(3 * kStationSilence_us);
  beat(one);
  EXPECT_FALSE(one.hasTwin()) << "it has gone";
}

TEST_F(StationStartTest, EveryRecordingNamesItsMachine) {
  const RecordingSpec spec = newRecording();
  EXPECT_EQ(spec.context.host, thisHost());
  EXPECT_FALSE(spec.context.host.name.empty());
  EXPECT_FALSE(spec.context.host.os.empty());
  EXPECT_FALSE(spec.context.host.cpu.empty());
  TrialHeader practice = headerOf(spec);
  practice.trialId = SystemIdSource().newUuid();
  practice.traineeCode.clear();

  recordingSink(centre_.locator(), stationContext())->begin(practice);

  const std::optional<TrialContext> context = TrialRepository(centre_.connection()).context(practice.trialId);
  EXPECT_EQ(context->host, thisHost());
  EXPECT_EQ(context->station, stationName());
  EXPECT_TRUE(context->enrolmentId.empty());
}

TEST(RecordingHost, ReadsProcessorAndGraphicsCardFromSystemFiles) {
  const Machine machine;
  machine.file("proc/cpuinfo", "processor\t: 0\nmodel\t\t: 85\nmodel name\t: Some Processor 3 GHz\n");
  machine.file("sys/class/drm/card0/device/uevent", "DRIVER=i915\nPCI_ID=8086:3E92\n");

  EXPECT_EQ(thisHost(machine.root()).cpu.rfind("Some Processor 3 GHz, ", 0), 0U)
      << thisHost(machine.root()).cpu;
  EXPECT_EQ(thisHost(machine.root()).gpu, "i915 8086:3E92");
  machine.file("proc/driver/nvidia/gpus/0000:01:00.0/information", "Model: \t\t Some Card 4000\nIRQ: 1\n");
  EXPECT_EQ(thisHost(machine.root()).gpu, "Some Card 4000");
}

TEST(RecordingHost, LeavesUnknownValuesEmpty) {
  const Machine machine;

  EXPECT_TRUE(thisHost(machine.root()).gpu.empty());
  EXPECT_FALSE(thisHost(machine.root()).cpu.empty());
}

}  // namespace
}  // namespace torsio
