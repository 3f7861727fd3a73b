// SPDX-License-Identifier: GPL-3.0-or-later
// A database that hangs must neither block the window nor lose recordings.
#include "app/services/recording/station_writer.h"

#include <algorithm>
#include <condition_variable>
#include <iostream>
#include <mutex>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/base/assets.h"
#include "app/services/recording/recorded_run.h"
#include "app/services/recording/unstored_trials.h"
#include "app/services/training/run_session.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/station_state.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/station_repository.h"
#include "sim/core/error.h"
#include "sim/record/recorder.h"
#include "sim/record/trial.h"
#include "sim/record/trial_file.h"
#include "sim/scene/scene.h"
#include "tests/app/support/training_centre.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

using namespace std::chrono_literals;

constexpr auto kLong = 20s;  // much longer than a busy machine needs
constexpr LinePatience kQuick{.again = 20ms, .heartbeat = 20ms, .silence = 30ms, .farewell = 50ms};

/// Simulates a server that stops answering, and answers again.
class Gate {
 public:
  void close() { set(false); }
  void open() { set(true); }
  void pass() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return open_; });
  }

 private:
  void set(bool open) {
    const std::lock_guard lock(mutex_);
    open_ = open;
    changed_.notify_all();
  }
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = true;
};

template <typename Condition>
bool soon(const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + kLong;
  while (!condition() && std::chrono::steady_clock::now() < end) {
    std::this_thread::yield();
  }
  return condition();
}

SessionKey keyOf(const TrainingCentre& centre, const Actor& actor) {
  return {centre.locator(), "line", actor};
}

/// Returns the station "line" from the record's board.
std::optional<StationState> lineOnTheBoard(TrainingCentre& centre) {
  const std::vector<StationState> board = StationRepository(centre.connection()).board();
  const auto found = std::find_if(board.begin(), board.end(),
                                  [](const StationState& station) { return station.station == "line"; });
  return found == board.end() ? std::nullopt : std::optional(*found);
}

TEST(StationWriter, ShowsTheUserAndWritesInOrder) {
  TrainingCentre centre;
  const Actor trainee = centre.session().actor();
  std::vector<int> order;
  StationWriter line(keyOf(centre, trainee), kQuick);

  for (int i = 0; i < 3; ++i) {
    line.write([&order, i](SessionContext&) { order.push_back(i); });
  }

  ASSERT_TRUE(line.settled(kLong));
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(line.answers());
  EXPECT_EQ(lineOnTheBoard(centre)->userId, trainee.userId);
  line.leave();
  EXPECT_FALSE(lineOnTheBoard(centre).has_value());
}

TEST(StationWriter, ShowsTheDeviceAndKeepsItsCheckWhenTheNextUserSignsIn) {
  TrainingCentre centre;
  StationWriter line(keyOf(centre, centre.session().actor()), kQuick);
  const auto shown = [&] {
    EXPECT_TRUE(line.settled(kLong));
    return storedDevice(lineOnTheBoard(centre).value());
  };
  EXPECT_TRUE(shown().device.empty());  // not a training station yet
  line.showDevice(uncheckedDevice({}, false));
  EXPECT_EQ(shown(), uncheckedDevice({}, false));
  DeviceReadiness readiness = deviceWith(Light::kAmber);
  readiness.haptic = true;
  readiness.findings.push_back(
      {"rate", Light::kAmber, Text::verbatim("%1; 1000 Hz are wanted", Text::verbatim("950 Hz")), ""});
  readiness.findings.front().light = Light::kGreen;
  const StationDevice checked = stationDevice(readiness, 42);
  EXPECT_EQ(checked.problem.str(), "950 Hz; 1000 Hz are wanted");

  line.showDevice(checked);
  line.showDevice(uncheckedDevice(Text::verbatim("Touch"), true));  // the next trainee opens the page

  EXPECT_EQ(shown(), checked);
  line.signIn({});
  EXPECT_EQ(shown(), checked);
}

TEST(StationDevice, AnInvalidProblemIsEmpty) {
  StationState state;
  for (const char* json : {"", "7", "[", "[7]", "{}"}) {
    state.deviceJson = json;
    EXPECT_TRUE(storedDevice(state).device.empty()) << json;
  }
  state.deviceJson = R"(["%1 of %2 at %3, %4",["a"],["b %1",["c"]],["d"],["e"]])";
  EXPECT_EQ(storedDevice(state).device.str(), "a of b c at d, e");
  EXPECT_FALSE(storedDevice(state).light.has_value());
}

TEST(StationWriter, EachWriteUsesTheUserSignedInWhenItWasQueued) {
  TrainingCentre centre;
  const Actor trainee = centre.session().actor();
  std::string who;
  StationWriter line(keyOf(centre, trainee), kQuick);

  line.write([&who](SessionContext& own) { who = own.actor().userId; });
  line.signIn({});

  ASSERT_TRUE(line.settled(kLong));
  EXPECT_EQ(who, trainee.userId);
}

TEST(StationWriter, AHangingServerBlocksNobodyAndPendingWritesFollowLater) {
  TrainingCentre centre;
  const SessionKey key = keyOf(centre, centre.session().actor());
  Gate gate;
  gate.close();
  std::atomic<int> written{0};
  {
    StationWriter line(
        [&gate, key] {
          gate.pass();
          return std::make_unique<SessionContext>(key);
        },
        kQuick);

    for (int i = 0; i < 3; ++i) {
      line.write([&written](SessionContext&) { ++written; });
    }
    EXPECT_TRUE(soon([&] { return !line.answers(); }));
    EXPECT_EQ(line.waiting(), 3U);
    EXPECT_EQ(written.load(), 0);

    gate.open();
    ASSERT_TRUE(line.settled(kLong));
    EXPECT_TRUE(line.answers());
    EXPECT_EQ(written.load(), 3);
  }
}

TEST(StationWriter, AnUnreachableServerIsRetriedAndARejectedWriteIsDropped) {
  TrainingCentre centre;
  const SessionKey key = keyOf(centre, centre.session().actor());
  std::atomic<bool> away{true};
  std::atomic<int> tries{0};
  StationWriter line(
      [&away, &tries, key] {
        ++tries;
        if (away) {
          throw DbError(DbFault::kUnreachable, "", Text::verbatim("away"), Text::verbatim("server"), "");
        }
        return std::make_unique<SessionContext>(key);
      },
      kQuick);
  line.write(
      [](SessionContext&) { throw Error(ErrorCode::kPermission, Text::verbatim("not allowed"), "", ""); });
  bool second = false;
  line.write([&second](SessionContext&) { second = true; });
  EXPECT_TRUE(soon([&] { return tries > 2 && !line.answers(); }));

  away = false;

  ASSERT_TRUE(line.settled(kLong));
  EXPECT_EQ(line.refused(), 1U);
  EXPECT_TRUE(second);
}

TEST(StationWriter, EndsInTimeEvenIfTheServerNeverAnswers) {
  TrainingCentre centre;
  const SessionKey key = keyOf(centre, centre.session().actor());
  const auto gate = std::make_shared<Gate>();
  gate->close();
  const auto ended = std::make_shared<std::atomic<bool>>(false);
  const auto begun = std::chrono::steady_clock::now();
  {
    StationWriter line(
        [gate, ended]() -> std::unique_ptr<SessionContext> {
          gate->pass();
          *ended = true;
          throw DbError(DbFault::kUnreachable, "", Text::verbatim("away"), Text::verbatim("server"), "");
        },
        kQuick);
    EXPECT_TRUE(soon([&] { return !line.answers(); }));
    line.leave();
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begun, kLong);
  gate->open();
  EXPECT_TRUE(soon([&] { return ended->load(); }));
}

TEST(StationWriter, ARunContinuesWhileTheServerHangsAndItsTimeIsLoggedAfterwards) {
  TrainingCentre centre(
      {.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual", .duration_us = 120 * kSecond_us}}});
  const SessionKey key = keyOf(centre, centre.session().actor());
  Gate gate;
  gate.close();
  StationWriter line(
      [&gate, key] {
        gate.pass();
        return std::make_unique<SessionContext>(key);
      },
      kQuick);
  line.signIn(key.actor);
  ManualClock clock;
  RunSession runSession(centre.session(), {centre.module("first"), true, deviceWith(Light::kGreen)}, clock,
                        &line);

  runSession.start();
  static_cast<void>(runSession.newTrial());
  for (int second = 0; second < 60; ++second) {
    clock.advance_us(kSecond_us);
    static_cast<void>(runSession.advance());
  }
  runSession.stop("enough");

  StudyRepository studies(centre.connection());
  EXPECT_TRUE(studies.exposures(centre.cohort().id).empty());
  gate.open();
  ASSERT_TRUE(line.settled(kLong));
  std::int64_t logged_us = 0;
  for (const Exposure& exposure : studies.exposures(centre.cohort().id)) {
    logged_us += exposure.duration_us;
  }
  EXPECT_EQ(logged_us, 60 * kSecond_us);
  EXPECT_EQ(studies.deviations(centre.cohort().id).size(), 1U);
  EXPECT_EQ(line.refused(), 0U);
}

/// Accepts chunks until its gate closes.
class GatedSink final : public TrialSink {
 public:
  GatedSink(std::shared_ptr<Gate> gate, std::shared_ptr<MemoryTrialSink> to)
      : gate_(std::move(gate)), to_(std::move(to)) {}
  void begin(const TrialHeader& header) override { to_->begin(header); }
  void append(const TrialChunk& chunk) override {
    gate_->pass();
    to_->append(chunk);
  }
  void finish(const TrialSummary& summary) override { to_->finish(summary); }

 private:
  std::shared_ptr<Gate> gate_;
  std::shared_ptr<MemoryTrialSink> to_;
};

TrialHeader headerOf(const TrialId& trialId) {
  TrialHeader header;
  header.trialId = trialId;
  return header;
}

TEST(TimedTrialSink, PassesOnCallsThatReturnInTime) {
  const auto kept = std::make_shared<MemoryTrialSink>();
  TimedTrialSink sink(std::make_unique<GatedSink>(std::make_shared<Gate>(), kept), {}, kLong);

  sink.begin(headerOf("one"));
  sink.finish(TrialSummary{});

  EXPECT_EQ(kept->trial().header.trialId, "one");
}

TEST(TimedTrialSink, ARecordingWithAHangingDatabaseGoesToAFileWithEverySample) {
  const auto gate = std::make_shared<Gate>();
  gate->close();
  const auto kept = std::make_shared<MemoryTrialSink>();
  const TemporaryFolder folder;
  TimedTrialSink sink(std::make_unique<GatedSink>(gate, kept), {folder.path(), "whose"}, 30ms);
  SpscRing<Sample> ring(kRecordingRing);
  Recorder recorder(ring, sink, headerOf("hung"));

  constexpr std::int64_t kSamples = 5'000;
  for (std::int64_t tick = 0; tick < kSamples; ++tick) {
    Sample sample;
    sample.tick = tick;
    ASSERT_TRUE(ring.push(sample));
    if (tick % 1000 == 999) {
      recorder.pump();
    }
  }
  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, 0);

  ASSERT_TRUE(result.spillFile.has_value());
  EXPECT_EQ(result.spillFile->parent_path(), folder.path());
  EXPECT_EQ(openTrialFile(*result.spillFile).context, "whose");
  EXPECT_EQ(result.summary.samples, kSamples);
  EXPECT_EQ(result.summary.refusedSamples, 0);
  gate->open();  // lets the abandoned thread end
}

// An hour of recording takes at most 60 MB in the database: extrapolated from a scripted hand on the
// demonstration's arm, recorded at 1 kHz through recorder and sink into a real file.

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
  TrainingCentre centre;
  SceneRequest request;
  request.assets = assetsFolder();
  request.id = "forearm";
  const Scene scene = loadScene(request);
  ScriptedTrial trial;
  trial.recording = {.trialId = centre.session().ids().newUuid(),
                     .traineeCode = "T-01",
                     .startedUtc_us = kCentreTime_us,
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
