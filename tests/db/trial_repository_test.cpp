// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/trial/trial_repository.h"

#include <span>
#include <thread>

#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/id_source.h"
#include "db/repository/base/seals.h"
#include "db/repository/base/stored_term.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/trial/station_repository.h"
#include "sim/core/error.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/db/sample_record.h"

namespace torsio {
namespace {

/// Does not compile if TrialHeader gains a field: schema, kInsertTrial, headerOf and this test then need it,
/// too.
void expectSameHeader(const TrialHeader& a, const TrialHeader& b) {
  const auto& [id, code, scene, pattern, organ, parameterHash, parameters, device, limits, software, phase,
               drive, target, scale, period, started, demonstration, model, seed] = a;
  EXPECT_EQ(id, b.trialId);
  EXPECT_EQ(code, b.traineeCode);
  EXPECT_EQ(scene, b.sceneId);
  EXPECT_EQ(pattern, b.patternId);
  EXPECT_EQ(organ, b.organHash);
  EXPECT_EQ(parameterHash, b.parameterHash);
  EXPECT_EQ(parameters, b.parametersJson);
  EXPECT_EQ(device, b.deviceModel);
  EXPECT_EQ(limits, b.deviceLimits);
  EXPECT_EQ(software, b.softwareVersion);
  EXPECT_EQ(phase, b.phaseLabel);
  EXPECT_EQ(drive, b.drive);
  EXPECT_EQ(target, b.targetAngle_rad);
  EXPECT_EQ(scale, b.forceScale);
  EXPECT_EQ(period, b.tickPeriod_us);
  EXPECT_EQ(started, b.startedUtc_us);
  EXPECT_EQ(demonstration, b.demonstration);
  EXPECT_EQ(model, b.model);
  EXPECT_EQ(seed, b.seed);  // blinded copies only: never stored
}

void expectSameChunk(const TrialChunk& a, const TrialChunk& b) {
  EXPECT_EQ(a.index, b.index);
  EXPECT_EQ(a.firstTick, b.firstTick);
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(a.bytes, b.bytes);
  EXPECT_EQ(a.digest, b.digest);
  EXPECT_EQ(a.outputDigest, b.outputDigest);
}

class TrialRepositoryTest : public SampleTest {
 protected:
  /// Records `chunks` seconds; `cut`: without finishing.
  static void record(TrialSink& sink, const TrialHeader& header, std::int64_t chunks, bool cut = false) {
    sink.begin(header);
    for (std::int64_t i = 0; i < chunks; ++i) {
      sink.append(sampleChunk(i, 500));
    }
    if (!cut) {
      sink.finish({1000 * chunks, 3, 2, TrialOutcome::kCompleted, "hash"});
    }
  }
};

TEST_F(TrialRepositoryTest, ReturnsATrialBitForBit) {
  const TrialHeader header = sampleHeader(sample().ids.newUuid(), "T-01");
  TrialRepository trials(connection(), {"station-1", sample().enrolments[0].id});

  record(trials, header, 3);

  Connection other = open();
  const Trial trial = TrialRepository(other).load(header.trialId);
  expectSameHeader(trial.header, header);
  ASSERT_EQ(trial.chunks.size(), 3U);
  for (std::int64_t i = 0; i < 3; ++i) {
    expectSameChunk(trial.chunks[static_cast<std::size_t>(i)], sampleChunk(i, 500));
  }
  EXPECT_EQ(trial.summary.samples, 3000);
  EXPECT_EQ(trial.summary.refusedSamples, 3);
  EXPECT_EQ(trial.summary.lateTicks, 2);
  EXPECT_EQ(trial.summary.outcome, TrialOutcome::kCompleted);
  EXPECT_EQ(trial.summary.contentHash, "hash");
}

TEST_F(TrialRepositoryTest, StoresAndSealsTheServosTiming) {
  TrialRepository trials(connection(), {"station-1", sample().enrolments[0].id});
  const TrialHeader uneven = sampleHeader(sample().ids.newUuid(), "T-01");
  const TrialHeader scripted = sampleHeader(sample().ids.newUuid(), "T-01");
  const ServoHealth health{.priority = false, .memory = true, .skippedTicks = 12, .forceCuts = 3};

  record(trials, scripted, 1);
  record(trials, uneven, 1, true);
  trials.finish({.samples = 1000, .contentHash = "hash", .health = health});

  EXPECT_EQ(trials.load(uneven.trialId).summary.health, health);
  EXPECT_FALSE(trials.load(scripted.trialId).summary.health.has_value());
  StationRepository stations(connection());
  stations.heartbeat({.station = "station-1", .heartbeatUtc_us = 1});
  stations.heartbeat({.station = "station-2", .heartbeatUtc_us = 1});
  EXPECT_EQ(stations.board().at(0).lastHealth, health);
  EXPECT_EQ(stations.board().at(0).lastTicks, 1000);
  EXPECT_FALSE(stations.board().at(1).lastHealth.has_value());
  const auto sealOf = [&] {
    return trialHashes(connection(), std::span(&uneven.trialId, 1)).at(uneven.trialId);
  };
  const std::string seal = sealOf();
  connection().executeVerbatim(onPostgresql() ? "DROP TRIGGER trial_end_append_only ON trial_end"
                                              : "DROP TRIGGER trial_end_no_UPDATE");
  for (const char* const change : {"force_cuts = 2", "skipped_ticks = 11", "real_time_priority = TRUE"}) {
    Transaction undone(connection());
    connection().executeVerbatim(std::string("UPDATE trial_end SET ") + change + " WHERE force_cuts = 3");
    EXPECT_NE(sealOf(), seal) << change;
  }
}

TEST_F(TrialRepositoryTest, RecordsAnonymousPractice) {
  SeededIdSource ids(1);
  const TrialHeader header = sampleHeader(ids.newUuid(), "");
  TrialRepository trials(connection(), {"station-1", ""});

  record(trials, header, 1);

  expectSameHeader(trials.find(header.trialId).value(), header);
}

TEST_F(TrialRepositoryTest, RejectsAnUnknownTrainee) {
  SeededIdSource ids(1);
  TrialRepository trials(connection());

  const Refusal refusal = refusalFrom([&] { trials.begin(sampleHeader(ids.newUuid(), "T-77")); });

  EXPECT_EQ(refusal.code, ErrorCode::kBadData);
  EXPECT_NE(refusal.text.find("T-77"), std::string::npos);
  EXPECT_TRUE(trials.list().empty());
}

TEST_F(TrialRepositoryTest, FindsOnlyTheInterruptedTrialsOfItsStation) {
  const std::string mine = sample().ids.newUuid();
  const std::string theirs = sample().ids.newUuid();
  const std::string done = sample().ids.newUuid();
  {
    Connection recorder = open();
    TrialRepository first(recorder, {"station-1", ""});
    TrialRepository second(recorder, {"station-2", ""});
    TrialRepository third(recorder, {"station-1", ""});
    record(first, sampleHeader(mine, "T-01"), 2, true);
    record(second, sampleHeader(theirs, "T-01"), 2, true);
    record(third, sampleHeader(done, "T-01"), 2);
  }
  TrialRepository trials(connection());

  const std::vector<TrialListing> found = trials.unfinished("station-1");

  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].trialId, mine);
  EXPECT_FALSE(found[0].summary.has_value());
  const Trial cut = trials.load(mine);
  EXPECT_EQ(cut.chunks.size(), 2U);
  EXPECT_EQ(cut.summary.samples, 2000);
  EXPECT_EQ(cut.summary.outcome, TrialOutcome::kInterrupted);

  EXPECT_TRUE(
      trials.closeInterrupted("station-1", kSampleTime_us).empty());  // its last second is more recent
  const std::vector<TrialListing> closed = trials.closeInterrupted("station-1", INT64_MAX);

  ASSERT_EQ(closed.size(), 1U);
  EXPECT_EQ(closed[0].summary->samples, 2000);
  EXPECT_TRUE(trials.unfinished("station-1").empty());
  EXPECT_EQ(trials.unfinished("station-2").size(), 1U);
  EXPECT_EQ(trials.load(mine).summary.outcome, TrialOutcome::kInterrupted);
}

TEST_F(TrialRepositoryTest, ListsTheNewestFirstWithFilters) {
  SampleRecord sample(connection(), 2);
  std::vector<std::string> ids;
  for (int i = 0; i < 4; ++i) {
    TrialHeader header = sampleHeader(sample.ids.newUuid(), i % 2 == 0 ? "T-01" : "T-02");
    header.startedUtc_us += i;
    header.sceneId = i < 2 ? "forearm" : "stomach";
    ids.push_back(header.trialId);
    TrialRepository trials(connection(), {"s", sample.enrolments[static_cast<std::size_t>(i % 2)].id});
    record(trials, header, 1, i == 3);
  }
  TrialRepository trials(connection());

  EXPECT_EQ(trials.list().size(), 4U);
  EXPECT_EQ(trials.list()[0].trialId, ids[3]);
  EXPECT_EQ(trials.list()[1].summary->samples, 1000);
  const std::vector<TrialListing> first = trials.list({.traineeCode = "T-01"});
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[0].trialId, ids[2]);
  EXPECT_EQ(trials.list({.traineeCode = "T-01", .sceneId = "forearm"}).at(0).trialId, ids[0]);
  EXPECT_EQ(trials.list({.enrolmentId = sample.enrolments[1].id}).size(), 2U);
  EXPECT_EQ(trials.list({.limit = 1, .offset = 1}).at(0).trialId, ids[2]);
}

TEST_F(TrialRepositoryTest, RecordedDataAreImmutable) {
  TrialRepository trials(connection());
  const std::string id = sample().ids.newUuid();
  record(trials, sampleHeader(id, "T-01"), 2);

  for (const std::string table : {"trial", "trial_chunk", "trial_end"}) {
    EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM " + table); }), DbFault::kAppendOnly)
        << table;
  }
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE trial_chunk SET bytes = ?", {Blob{}}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE trial SET organ_hash = ?", {""}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE trial_end SET outcome = ?", {"interrupted"}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(trials.load(id).chunks.size(), 2U);
}

TEST_F(TrialRepositoryTest, ReplacingARowIsAChangeToo) {
  if (onPostgresql()) {
    GTEST_SKIP() << "REPLACE is a word of SQLite";
  }
  TrialRepository trials(connection());
  record(trials, sampleHeader(sample().ids.newUuid(), "T-01"), 1);

  EXPECT_EQ(faultFrom([&] {
              connection().execute(
                  "INSERT OR REPLACE INTO trial_chunk SELECT trial_id, chunk_index, 7,"
                  " sample_count, digest, output_digest, stored_utc_us, bytes FROM trial_chunk");
            }),
            DbFault::kAppendOnly);
}

TEST_F(TrialRepositoryTest, StoresRepeatedDataOnceAfterALostAnswer) {
  const TrialHeader header = sampleHeader(sample().ids.newUuid(), "T-01");
  const TrialSummary summary{1000, 3, 2, TrialOutcome::kCompleted, "hash"};
  const TrialContext context{"station-1", sample().enrolments[0].id};
  TrialRepository(connection(), context).begin(header);

  TrialRepository again(connection(), context);
  again.begin(header);
  again.append(sampleChunk(0, 100));
  again.append(sampleChunk(0, 100));
  again.finish(summary);
  TrialRepository late(connection(), context);
  late.resume(header.trialId);
  late.finish(summary);

  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM trial"), 1);
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM trial_chunk"), 1);
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM trial_end"), 1);
  EXPECT_EQ(AuditRepository(connection()).count(0), 1);
}

TEST_F(TrialRepositoryTest, RejectsTheSameIdWithOtherContent) {
  TrialHeader header = sampleHeader(sample().ids.newUuid(), "T-01");
  TrialRepository trials(connection());
  trials.begin(header);
  trials.append(sampleChunk(0, 100));
  trials.append(sampleChunk(1, 100));

  TrialChunk other = sampleChunk(0, 100);
  other.bytes[50] ^= std::byte{1};
  EXPECT_EQ(faultFrom([&] { trials.append(other); }), DbFault::kUnique);
  const Refusal refusal = refusalFrom([&] { trials.append(other); });
  EXPECT_NE(
      refusal.text.find("second 1 of trial " + header.trialId + " is already stored with different content"),
      std::string::npos)
      << refusal.text;
  trials.finish({2000, 0, 0, TrialOutcome::kCompleted, "hash"});
  TrialRepository late(connection());
  late.resume(header.trialId);
  EXPECT_EQ(faultFrom([&] {
              late.finish({2000, 0, 1, TrialOutcome::kCompleted, "hash"});
            }),
            DbFault::kUnique);
  header.sceneId = "stomach";
  TrialRepository another(connection());
  EXPECT_EQ(faultFrom([&] { another.begin(header); }), DbFault::kUnique);
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM trial_chunk"), 2);
}

/// A trial with valid digests, as in a spill file.
Trial wholeTrial(const std::string& id, std::int64_t chunks) {
  Trial trial;
  trial.header = sampleHeader(id, "T-01");
  for (std::int64_t i = 0; i < chunks; ++i) {
    trial.chunks.push_back(sampleChunk(i, 200));
    trial.chunks.back().digest = chunkDigest(trial.chunks.back());
  }
  trial.summary = {1000 * chunks, 0, 0, TrialOutcome::kCompleted, contentHash(trial)};
  return trial;
}

TEST_F(TrialRepositoryTest, AFileCompletesItsTrialInTheDatabase) {
  const Trial trial = wholeTrial(sample().ids.newUuid(), 3);
  TrialRepository recording(connection(), {"station-1", sample().enrolments[0].id});
  recording.begin(trial.header);
  recording.append(trial.chunks[0]);

  TrialRepository trials(connection(), {"station-2", ""});
  trials.import(trial);
  trials.import(trial);

  EXPECT_EQ(trials.load(trial.header.trialId).chunks.size(), 3U);
  EXPECT_EQ(trials.context(trial.header.trialId)->enrolmentId, sample().enrolments[0].id);
  EXPECT_EQ(AuditRepository(connection()).count(0), 1);
}

TEST_F(TrialRepositoryTest, AFileOfATrialClosedWithoutItIsRefused) {
  const Trial trial = wholeTrial(sample().ids.newUuid(), 3);
  TrialRepository recording(connection(), {"station-1", ""});
  recording.begin(trial.header);
  recording.append(trial.chunks[0]);
  TrialRepository trials(connection(), {"station-1", ""});
  ASSERT_EQ(trials.closeInterrupted("station-1", INT64_MAX).size(), 1U);

  EXPECT_EQ(faultFrom([&] { trials.import(trial); }), DbFault::kUnique);

  EXPECT_EQ(trials.load(trial.header.trialId).chunks.size(), 1U);
}

TEST_F(TrialRepositoryTest, StoresPurposeAndMachineOfATrial) {
  CurriculumRepository(connection()).addCurriculum({"c", "Twist", "", kSampleTime_us, true});
  CurriculumVersion version;
  version.id = "v";
  version.curriculumId = "c";
  TrainingModule module;
  module.id = "m";
  module.code = "M1";
  module.mode = AttemptMode::kGraded;
  module.tolerance_rad = 0.1;
  version.modules = {module};
  StudyArm arm;
  arm.id = "a";
  arm.code = "A1";
  arm.phases = {{"p", PhaseKind::kVirtual, "first", 60, "m"}};
  version.arms = {arm};
  CurriculumRepository(connection()).addVersion(version, "admin");
  const TrialContext context{.station = "station-1",
                             .enrolmentId = sample().enrolments[0].id,
                             .moduleId = "m",
                             .phaseId = "p",
                             .attemptMode = AttemptMode::kGraded,
                             .host = {"pc-7", "Debian 12", "Core i5", "Arc A380"}};
  const std::string id = sample().ids.newUuid();
  TrialRepository trials(connection(), context);

  record(trials, sampleHeader(id, "T-01"), 1);

  EXPECT_EQ(trials.context(id), context);
  EXPECT_FALSE(trials.context("none").has_value());
  const std::vector<TrialListing> found = trials.list({.moduleId = "m"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].phaseId, "p");
  EXPECT_EQ(found[0].attemptMode, AttemptMode::kGraded);
  EXPECT_TRUE(trials.list({.moduleId = "other"}).empty());
}

TEST_F(TrialRepositoryTest, RejectsAnUnknownMode) {
  const auto modeOf = [&](const char* sql) {
    return selectFirst(connection(), sql, {}, [](RowReader& row) { return readMaybeTerm<AttemptMode>(row); });
  };

  EXPECT_EQ(modeOf("SELECT CAST('graded' AS TEXT)").value(), AttemptMode::kGraded);
  EXPECT_EQ(modeOf("SELECT CAST(NULL AS TEXT)").value(), std::nullopt);
  EXPECT_EQ(faultFrom([&] { (void)modeOf("SELECT CAST('sometimes' AS TEXT)"); }), DbFault::kCheck);
  EXPECT_THROW((void)modeOf("SELECT CAST('' AS TEXT)"), DbError);
}

TEST_F(TrialRepositoryTest, LoadsSeveralTrialsAtOnceLikeSingleOnes) {
  std::vector<TrialId> ids;
  for (int seconds : {2, 0, 3, 1}) {
    ids.emplace_back(sample().ids.newUuid());
    TrialRepository trials(connection(), {"station-1", ""});
    record(trials, sampleHeader(ids.back(), "T-01"), seconds, seconds == 3);
  }
  TrialLoader loader(connection());

  const std::vector<Trial> loaded = loader.load(ids);

  ASSERT_EQ(loaded.size(), ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Trial alone = loader.load(ids[i]);
    expectSameHeader(loaded[i].header, alone.header);
    EXPECT_EQ(loaded[i].header.trialId, ids[i]);
    ASSERT_EQ(loaded[i].chunks.size(), alone.chunks.size());
    for (std::size_t second = 0; second < alone.chunks.size(); ++second) {
      expectSameChunk(loaded[i].chunks[second], alone.chunks[second]);
    }
    EXPECT_EQ(loaded[i].summary.samples, alone.summary.samples);
    EXPECT_EQ(loaded[i].summary.outcome, alone.summary.outcome);
    EXPECT_EQ(loaded[i].summary.contentHash, alone.summary.contentHash);
  }
  EXPECT_EQ(loaded[2].summary.outcome, TrialOutcome::kInterrupted);
  EXPECT_TRUE(loader.load(std::span<const TrialId>()).empty());
  ids.insert(ids.begin() + 1, "none");
  EXPECT_EQ(refusalFrom([&] { (void)loader.load(ids); }).code, ErrorCode::kBadData);
}

TEST_F(TrialRepositoryTest, ThrowsForAnUnknownTrial) {
  EXPECT_EQ(refusalFrom([&] { (void)TrialRepository(connection()).load("none"); }).code, ErrorCode::kBadData);
  EXPECT_FALSE(TrialRepository(connection()).find("none").has_value());
}

TEST_F(TrialRepositoryTest, StoresAThousandSeconds) {
  const std::string id = sample().ids.newUuid();
  TrialRepository trials(connection());

  record(trials, sampleHeader(id, "T-01"), 1000);

  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM trial_chunk"), 1000);
  EXPECT_EQ(trials.load(id).summary.samples, 1'000'000);
}

TEST_F(TrialRepositoryTest, RecordsFromItsOwnThread) {
  const std::string id = sample().ids.newUuid();
  OwnConnectionTrialSink sink(locator(), {"station-1", ""});

  std::thread recorder([&] { record(sink, sampleHeader(id, "T-01"), 5); });
  recorder.join();

  EXPECT_EQ(TrialRepository(connection()).load(id).chunks.size(), 5U);
}

TEST_F(TrialRepositoryTest, ASinkDestroyedInAnotherThreadLeavesAnInterruptedTrial) {
  const TrialHeader header = sampleHeader(sample().ids.newUuid(), "T-01");
  {
    OwnConnectionTrialSink sink(locator(), {"station-1", ""});
    std::thread recorder([&] { record(sink, header, 2, true); });
    recorder.join();
  }
  EXPECT_EQ(TrialRepository(connection()).unfinished("station-1").size(), 1U);
}

}  // namespace
}  // namespace torsio
