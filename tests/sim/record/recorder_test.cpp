// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/record/recorder.h"

#include <filesystem>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/record/trial.h"
#include "sim/record/trial_file.h"
#include "tests/sim/record/samples.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

TrialHeader someHeader() {
  TrialHeader header;
  header.trialId = "6f1c0e52-0001";
  header.traineeCode = "T-07";
  header.sceneId = "forearm";
  header.drive = TwistDrive::kRoll;
  header.targetAngle_rad = 1.5;
  header.deviceLimits.maxForce_N = 7.5;
  header.demonstration = true;
  return header;
}

/// Refuses as many calls as it is told to, then takes everything.
class StubbornSink final : public TrialSink {
 public:
  explicit StubbornSink(int refusals) : refusals_(refusals) {}
  void begin(const TrialHeader& header) override {
    mayRefuse();
    kept.begin(header);
  }
  void append(const TrialChunk& chunk) override {
    mayRefuse();
    kept.append(chunk);
  }
  void finish(const TrialSummary& summary) override {
    mayRefuse();
    kept.finish(summary);
    finished = true;
  }
  /// From now on nothing is taken.
  void close() { refusals_ = 1'000'000; }

  MemoryTrialSink kept;
  bool finished = false;

 private:
  void mayRefuse() {
    if (refusals_ > 0) {
      --refusals_;
      throw Error(ErrorCode::kDatabase, Text::verbatim("the database is locked"), Text::verbatim("test"),
                  Text::verbatim("Try again"));
    }
  }
  int refusals_;
};

class RecorderTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / (std::string("torsio_recorder_") +
                                          ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  RecorderOptions options() const { return {.spillFolder = folder}; }
  void push(std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      ASSERT_TRUE(ring.push(samples[i]));
    }
  }

  fs::path folder;
  std::vector<Sample> samples = twistSamples(3'500);
  SpscRing<Sample> ring{kRecordingRing};
  MemoryTrialSink sink;
};

TEST_F(RecorderTest, BatchesOneSecondAndHandsOnTheRestAtTheEnd) {
  Recorder recorder(ring, sink, someHeader(), options());
  push(0, 2'500);

  recorder.pump();
  const std::size_t afterPump = sink.trial().chunks.size();
  push(2'500, 3'500);
  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, 4);

  EXPECT_EQ(afterPump, 2U);
  ASSERT_EQ(sink.trial().chunks.size(), 4U);
  EXPECT_EQ(sink.trial().chunks[3].samples, 500);
  EXPECT_EQ(sink.trial().chunks[3].firstTick, 3'000);
  EXPECT_EQ(result.summary.samples, 3'500);
  EXPECT_EQ(result.summary.refusedSamples, 0);
  EXPECT_EQ(result.summary.lateTicks, 4);
  EXPECT_FALSE(result.spillFile.has_value());
  EXPECT_TRUE(result.problem.empty());
  const std::vector<Sample> back = decodeTrial(sink.trial());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(back[i], inStoredSteps(samples[i]));
  }
}

TEST_F(RecorderTest, SealsTheTrialWithAContentHashThatSeesEveryChange) {
  Recorder recorder(ring, sink, someHeader(), options());
  push(0, 3'500);
  (void)recorder.finish(TrialOutcome::kCompleted, 0);
  const Trial good = sink.trial();

  EXPECT_NO_THROW(verifyContent(good));
  Trial otherTrainee = good;
  otherTrainee.header.traineeCode = "T-08";
  Trial otherTarget = good;
  otherTarget.header.targetAngle_rad += 1e-12;
  Trial swapped = good;
  std::swap(swapped.chunks[0], swapped.chunks[1]);
  Trial shortened = good;
  shortened.chunks.pop_back();
  Trial damagedBytes = good;
  damagedBytes.chunks[2].bytes[100] ^= std::byte{4};
  Trial otherAnswers = good;
  otherAnswers.chunks[2].outputDigest[0] ^= 1;
  Trial miscounted = good;
  miscounted.summary.samples -= 1;
  for (const Trial& bad :
       {otherTrainee, otherTarget, swapped, shortened, damagedBytes, otherAnswers, miscounted}) {
    EXPECT_EQ(testing::refusal([&] { verifyContent(bad); }).code(), ErrorCode::kVerifyFailed);
  }
}

TEST_F(RecorderTest, CountsWhatTheRingRefused) {
  SpscRing<Sample> small(1'000);
  for (int i = 0; i < 5; ++i) {
    while (small.push(samples[0])) {
    }
  }
  Sample ignored;
  while (small.pop(ignored)) {
  }
  Recorder recorder(small, sink, someHeader(), options());
  int refused = 0;
  for (std::size_t i = 0; i < 1'200; ++i) {
    refused += small.push(samples[i]) ? 0 : 1;
  }

  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, 0);

  EXPECT_EQ(refused, 200);
  EXPECT_EQ(result.summary.refusedSamples, 200);
  EXPECT_EQ(result.summary.samples, 1'000);
}

TEST_F(RecorderTest, LeavesValidChunksWhenItIsKilledBeforeTheEnd) {
  {
    Recorder recorder(ring, sink, someHeader(), options());
    push(0, 2'700);
    recorder.pump();
  }

  EXPECT_EQ(sink.trial().summary.outcome, TrialOutcome::kInterrupted);
  EXPECT_EQ(decodeTrial(sink.trial()).size(), 2'000U);
}

TEST_F(RecorderTest, TriesAgainWhatTheSinkRefusedWithoutLossOrDouble) {
  StubbornSink stubborn(2);
  Recorder recorder(ring, stubborn, someHeader(), options());
  push(0, 3'500);

  recorder.pump();
  recorder.pump();
  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, 0);

  EXPECT_TRUE(stubborn.finished);
  EXPECT_EQ(decodeTrial(stubborn.kept.trial()).size(), 3'500U);
  EXPECT_FALSE(result.spillFile.has_value());
  EXPECT_NE(result.problem.find("locked"), std::string::npos);
}

TEST_F(RecorderTest, SpillsTheWholeTrialToAFileWhenTheSinkGivesUpHalfWay) {
  StubbornSink closing(0);
  Recorder recorder(ring, closing, someHeader(), options());
  push(0, 1'500);
  recorder.pump();
  closing.close();
  push(1'500, 3'500);
  for (int i = 0; i < 3; ++i) {
    recorder.pump();
  }
  EXPECT_TRUE(recorder.spilling());

  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, 0);

  ASSERT_TRUE(result.spillFile.has_value());
  const Trial trial = readTrialFile(*result.spillFile);
  EXPECT_NO_THROW(verifyContent(trial));
  EXPECT_EQ(decodeTrial(trial).size(), 3'500U);
  EXPECT_EQ(trial.header.traineeCode, "T-07");
  EXPECT_EQ(trial.header.deviceLimits, someHeader().deviceLimits);
  EXPECT_FALSE(fs::exists(temporaryBeside(*result.spillFile)));
  EXPECT_FALSE(closing.finished);
  EXPECT_EQ(closing.kept.trial().chunks.size(), 1U);
}

TEST_F(RecorderTest, SaysWhenNeitherSinkNorFileTakesTheTrial) {
  writeFileAtomically(folder, "a file where the folder should be");
  StubbornSink closed(1'000'000);
  Recorder recorder(ring, closed, someHeader(), options());
  push(0, 1'000);
  EXPECT_EQ(testing::refusal([&] { return recorder.finish(TrialOutcome::kCompleted, 0); }).code(),
            ErrorCode::kFileUnwritable);
}

TEST_F(RecorderTest, RecordsFromItsOwnThreadWithoutLosingASample) {
  const std::vector<Sample> many = twistSamples(40'000);
  SpscRing<Sample> wide(50'000);
  Recorder recorder(wide, sink, someHeader(), options());
  recorder.start();
  std::thread servo([&wide, &many] {
    for (const Sample& sample : many) {
      while (!wide.push(sample)) {
        std::this_thread::yield();
      }
    }
  });
  servo.join();

  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, 0);

  EXPECT_EQ(result.summary.samples, 40'000);
  EXPECT_EQ(recorder.samples(), 40'000);
  EXPECT_NO_THROW(verifyContent(sink.trial()));
  const std::vector<Sample> back = decodeTrial(sink.trial());
  ASSERT_EQ(back.size(), many.size());
  for (std::size_t i = 0; i < many.size(); ++i) {
    ASSERT_EQ(back[i].device, many[i].device);
  }
}

class TrialFile : public RecorderTest {
 protected:
  void SetUp() override {
    RecorderTest::SetUp();
    ensureFolder(folder);
    file = folder / "trial";
    TrialFileSink writer(file);
    Recorder recorder(ring, writer, someHeader(), options());
    push(0, 3'500);
    (void)recorder.finish(TrialOutcome::kCompleted, 2);
    bytes = readFile(file);
  }
  fs::path file;
  std::string bytes;
};

TEST_F(TrialFile, ReadsBackWhatWasRecorded) {
  const Trial trial = readTrialFile(file);

  EXPECT_NO_THROW(verifyContent(trial));
  EXPECT_EQ(trial.summary.lateTicks, 2);
  EXPECT_EQ(trial.header.drive, TwistDrive::kRoll);
  EXPECT_TRUE(trial.header.demonstration);
}

TEST_F(TrialFile, ReadsTheWholeRecordsOfAFileThatWasCutOffAnywhere) {
  for (std::size_t size = 0; size < bytes.size(); size += 61) {
    writeFileAtomically(file, bytes.substr(0, size));
    try {
      const Trial trial = readTrialFile(file);
      ASSERT_EQ(trial.summary.outcome, TrialOutcome::kInterrupted) << size;
      ASSERT_NO_THROW(verifyContent(trial)) << size;
    } catch (const Error& error) {
      ASSERT_LT(size, 1'000U) << error.what();  // before the first record was whole
    }
  }
}

TEST_F(TrialFile, RefusesRandomDamage) {
  Random random(6);
  for (int round = 0; round < 500; ++round) {
    std::string bad = bytes;
    bad[random.bounded(bad.size())] ^= static_cast<char>(1 + random.bounded(255));
    writeFileAtomically(file, bad);
    try {
      // A damaged length looks like a file cut off there: what comes before must still be sound.
      const Trial trial = readTrialFile(file);
      ASSERT_EQ(trial.summary.outcome, TrialOutcome::kInterrupted);
      ASSERT_NO_THROW(verifyContent(trial));
    } catch (const Error& error) {
      ASSERT_TRUE(error.code() == ErrorCode::kBadData || error.code() == ErrorCode::kFileUnreadable);
    }
  }
}

}  // namespace
}  // namespace torsio
