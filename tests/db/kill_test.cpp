// SPDX-License-Identifier: GPL-3.0-or-later
// Kills a recording program at random instants: whatever it reported as stored must be there. The program is
// this one, restarted with --record. 20 instants, or TORSIO_KILL_INSTANTS.
#include <cstdlib>
#include <iostream>

#include <QCoreApplication>
#include <QProcess>
#include <gtest/gtest.h>

#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/rating/mark.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/backup.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/clock.h"
#include "sim/core/random.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

constexpr const char* kRecord = "--record";
constexpr std::size_t kChunkBytes = 20'000;  // about one second of samples, encoded

TrialChunk wholeChunk(std::int64_t index) {
  TrialChunk chunk = sampleChunk(index, kChunkBytes);
  chunk.digest = chunkDigest(chunk);
  return chunk;
}

/// Records chunks and submits marks endlessly, printing a line after each commit.
[[noreturn]] void recordForever(const std::string& locator) {
  Connection connection = openRecord(locator, OpenMode::kReadWrite);
  if (connection.engine() == Engine::kPostgresql) {
    connection.executeVerbatim("SET application_name = '" + parseLocator(locator).schema + "'");
  }
  PeopleRepository people(connection);
  SystemIdSource ids;
  TrialRepository trials(connection, {"killed", ""});
  trials.begin(sampleHeader(ids.newUuid(), "T-01"));
  SubmittedMark mark;
  mark.enrolmentId =
      StudyRepository(connection).enrolments(StudyRepository(connection).cohorts().at(0).id).at(0).id;
  mark.raterId = people.raters().at(0).person.id;
  mark.occasionCode = "pre";
  mark.score_steps = 50;
  const std::int64_t versions = static_cast<std::int64_t>(
      RatingRepository(connection).history(mark.enrolmentId, mark.raterId, "pre").size());
  for (std::int64_t i = 0;; ++i) {
    trials.append(wholeChunk(i));
    std::cout << "chunk\n" << std::flush;
    mark.id = ids.newUuid();
    mark.version = versions + i + 1;
    mark.amendReason = mark.version == 1 ? "" : "again";
    RatingRepository(connection).submit(std::span(&mark, 1));
    std::cout << "mark\n" << std::flush;
  }
}

struct Reported {
  std::int64_t chunks = 0;
  std::int64_t marks = 0;
};

class KillTest : public DatabaseTest {
 protected:
  static int runs() {
    const char* wanted = std::getenv("TORSIO_KILL_INSTANTS");
    return wanted == nullptr ? 20 : std::atoi(wanted);
  }

  /// Lets the program commit a few times, then kills it at a random moment, usually during a commit.
  Reported recordAndKill(Random& random) const {
    QProcess program;
    program.start(QCoreApplication::applicationFilePath(),
                  {QString::fromLatin1(kRecord), QString::fromStdString(locator())});
    const std::int64_t lines = 1 + static_cast<std::int64_t>(random.bounded(12));
    QByteArray said;
    while (said.count('\n') < lines && program.waitForReadyRead(30'000)) {
      said += program.readAllStandardOutput();
    }
    const MonotonicClock clock;
    const std::int64_t until_us = clock.now_us() + static_cast<std::int64_t>(random.bounded(3'000));
    while (clock.now_us() < until_us) {
    }
    program.kill();
    program.waitForFinished();
    said += program.readAllStandardOutput();
    EXPECT_EQ(program.exitStatus(), QProcess::CrashExit) << program.readAllStandardError().toStdString();
    return {said.count("chunk\n"), said.count("mark\n")};
  }

  /// A server may still execute what the killed program had sent: waits until that is finished.
  void waitForServer(Connection& connection) const {
    if (!onPostgresql()) {
      return;
    }
    const std::string still = "SELECT count(*) FROM pg_stat_activity WHERE application_name = '" +
                              parseLocator(locator()).schema + "'";
    const MonotonicClock clock;
    const std::int64_t until_us = clock.now_us() + 30'000'000;
    while (numberFrom(connection, still) > 0) {
      ASSERT_LT(clock.now_us(), until_us) << "the server goes on and on";
    }
  }
};

TEST_F(KillTest, NothingCommittedIsLostAndTheTrialIsFoundAsInterrupted) {
  {
    Connection connection = openWithSchema();
    const SampleRecord sample(connection, 1);
  }
  Random random(20251121);
  std::int64_t marksBefore = 0;
  std::int64_t chunksReported = 0;
  std::int64_t marksReported = 0;
  for (int run = 0; run < runs(); ++run) {
    const Reported reported = recordAndKill(random);

    Connection connection = openWithSchema();
    waitForServer(connection);
    EXPECT_TRUE(integrityFindings(connection).empty());
    TrialRepository trials(connection);
    const std::vector<TrialListing> closed = trials.closeInterrupted("killed", INT64_MAX);
    ASSERT_EQ(closed.size(), 1U);
    const Trial trial = trials.load(closed[0].trialId);
    // Everything reported is there, and at most one more commit whose report was lost.
    EXPECT_GE(static_cast<std::int64_t>(trial.chunks.size()), reported.chunks);
    EXPECT_LE(static_cast<std::int64_t>(trial.chunks.size()), reported.chunks + 1);
    verifyContent(trial);
    const std::int64_t marks = numberFrom(connection, "SELECT count(*) FROM training_mark") - marksBefore;
    EXPECT_GE(marks, reported.marks);
    EXPECT_LE(marks, reported.marks + 1);
    for (const AuditFinding& finding : verifyAuditTrail(connection)) {
      ADD_FAILURE() << finding.sequence << " " << finding.objectKind << " " << finding.objectId << " "
                    << finding.what;
    }
    marksBefore += marks;
    chunksReported += reported.chunks;
    marksReported += reported.marks;
  }
  std::cout << runs() << " kills, " << chunksReported << " seconds and " << marksReported
            << " marks had been reported as stored\n";
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  if (argc == 3 && std::string(argv[1]) == torsio::kRecord) {
    torsio::recordForever(argv[2]);
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
