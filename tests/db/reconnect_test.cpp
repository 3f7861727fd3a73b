// SPDX-License-Identifier: GPL-3.0-or-later
// The server closes a connection during a trial: the recorder's sink reconnects, and nothing is lost or
// duplicated. PostgreSQL only.

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "assessment/domain/rating/mark.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/clock.h"
#include "sim/record/content_hash.h"
#include "sim/record/recorder.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {

namespace {

class ReconnectTest : public SampleTest {
 protected:
  void SetUp() override {
    if (!onPostgresql()) {
      GTEST_SKIP() << "SQLite has no server that could go away";
    }
    DatabaseTest::SetUp();
  }

  void TearDown() override {
    if (onPostgresql() && !role_.empty()) {
      open().executeVerbatim("DROP ROLE " + role_);
    }
    DatabaseTest::TearDown();
  }

  /// The same database with another user, so that the server can identify the connection to close.
  std::string locatorToLose() {
    const std::string whole = locator();
    const std::size_t at = whole.find('@');
    role_.assign("r").append(whole, whole.rfind("t_") + 1, std::string::npos);
    open().executeVerbatim("CREATE ROLE " + role_ + " SUPERUSER LOGIN PASSWORD 'lost'");
    std::string other = "postgresql://";
    return other.append(role_).append(":lost").append(whole, at, std::string::npos);
  }

  void endConnection(Connection& connection) const {
    Statement end =
        connection.prepare("SELECT pg_terminate_backend(pid, 5000) FROM pg_stat_activity WHERE usename = ?");
    end.execute({role_});
    int ended = 0;
    while (end.step()) {
      ended += end.boolean(0) ? 1 : 0;
    }
    ASSERT_EQ(ended, 1);
  }

  static Sample sampleAt(std::int64_t tick) {
    Sample sample;
    sample.tick = tick;
    return sample;
  }

 private:
  std::string role_;
};

TEST_F(ReconnectTest, ATrialSurvivesALostConnectionAtEveryStep) {
  const std::string id = sample().ids.newUuid();
  OwnConnectionTrialSink sink(locatorToLose(), {"station-1", sample().enrolments[0].id});

  sink.begin(sampleHeader(id, "T-01"));
  for (std::int64_t i = 0; i < 6; ++i) {
    if (i % 2 == 1) {
      endConnection(connection());
    }
    sink.append(sampleChunk(i, 500));
  }
  endConnection(connection());
  sink.finish({6000, 0, 0, TrialOutcome::kCompleted, "hash"});

  const Trial trial = TrialRepository(connection()).load(id);
  ASSERT_EQ(trial.chunks.size(), 6U);
  for (std::int64_t i = 0; i < 6; ++i) {
    EXPECT_EQ(trial.chunks[static_cast<std::size_t>(i)].bytes, sampleChunk(i, 500).bytes);
  }
  EXPECT_EQ(trial.summary.contentHash, "hash");
  EXPECT_EQ(AuditRepository(connection()).entries({.objectKind = AuditObject::kTrial}).size(), 1U);
}

TEST_F(ReconnectTest, ARecordingLosesNoSampleAndNeedsNoFile) {
  const TrialHeader header = sampleHeader(sample().ids.newUuid(), "T-01");
  SpscRing<Sample> ring(kRecordingRing);
  OwnConnectionTrialSink sink(locatorToLose(), {"station-1", ""});
  Recorder recorder(ring, sink, header);

  std::int64_t tick = 0;
  for (int second = 0; second < 5; ++second) {
    for (int i = 0; i < 1000; ++i) {
      ASSERT_TRUE(ring.push(sampleAt(tick++)));
    }
    recorder.pump();
    if (second == 2) {
      endConnection(connection());
    }
  }
  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, 0);

  EXPECT_FALSE(result.spillFile.has_value());
  EXPECT_EQ(result.problem, "");
  EXPECT_EQ(result.summary.refusedSamples, 0);
  const Trial trial = TrialRepository(connection()).load(header.trialId);
  EXPECT_EQ(trial.summary.samples, 5000);
  verifyContent(trial);
}

TEST_F(ReconnectTest, AMarkCanBeSubmittedAgainOverANewConnection) {
  SubmittedMark mark;
  mark.id = sample().ids.newUuid();
  mark.enrolmentId = sample().enrolments[0].id;
  mark.raterId = sample().chiefs[0].person.id;
  mark.occasionCode = "pre";
  mark.score_steps = 73;
  mark.submittedUtc_us = kSampleTime_us;
  {
    Connection lost = openRecord(locatorToLose(), OpenMode::kReadWrite);
    RatingRepository(lost).submit(std::span(&mark, 1));  // stored, but the answer is lost
    endConnection(connection());
    EXPECT_EQ(faultFrom([&] { RatingRepository(lost).submit(std::span(&mark, 1)); }), DbFault::kUnreachable);
  }

  Connection again = openWithSchema();
  RatingRepository(again).submit(std::span(&mark, 1));

  EXPECT_EQ(RatingRepository(connection()).marks(sample().cohort.id).size(), 1U);
  EXPECT_TRUE(verifyAuditTrail(connection()).empty());
}

TEST_F(ReconnectTest, AnUnreachableServerIsReportedWithinSeconds) {
  // given: an address without a listener
  const std::string away = "postgresql://torsio:none@127.0.0.1:1/none";
  OwnConnectionTrialSink sink(away, {"station-1", ""});
  const MonotonicClock clock;
  const std::int64_t start_us = clock.now_us();

  EXPECT_EQ(faultFrom([&] { sink.begin(sampleHeader("t", "")); }), DbFault::kUnreachable);

  constexpr std::int64_t kRing_us = 8'000'000;  // capacity of the recorder's ring
  EXPECT_LT(clock.now_us() - start_us, kRing_us);
}

}  // namespace

namespace {

namespace fs = std::filesystem;

/// The server of the suite, with a certificate for "localhost" (tests/support/start-postgres.sh).
class ServerTlsTest : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (!onPostgresql()) {
      GTEST_SKIP() << "an SQLite file has no TLS";
    }
    if (IsSkipped()) {
      return;
    }
    server_ = parseLocator(locator());
    authority_ = fs::temp_directory_path() / ("torsio-postgres-" + std::to_string(server_.port)) / "ca.crt";
    if (!fs::exists(authority_)) {
      GTEST_SKIP() << "the server was not started by tests/support/start-postgres.sh";
    }
  }

  [[nodiscard]] std::string with(const std::string& host,
                                 const std::vector<ServerParameter>& parameters) const {
    Locator server = server_;
    server.host = host;
    server.parameters = parameters;
    return addressOf(server);
  }
  /// Encryption of this connection as the server sees it; "ssl|application_name".
  [[nodiscard]] static std::string seen(const std::string& locator) {
    Connection connection = openDatabase(locator, OpenMode::kReadOnly);
    Statement row = connection.prepare(
        "SELECT s.ssl::text || '|' || a.application_name FROM pg_stat_ssl s JOIN pg_stat_activity a"
        " ON a.pid = s.pid WHERE s.pid = pg_backend_pid()");
    row.execute();
    return row.step() ? row.text(0) : "";
  }
  [[nodiscard]] static std::string refusal(const std::string& locator) {
    return refusalFrom([&] { (void)openDatabase(locator, OpenMode::kReadOnly); }).text;
  }

  Locator server_;
  fs::path authority_;
};

TEST_F(ServerTlsTest, VerifiesTheServerInFullAndRefusesAnotherName) {
  const std::string root = authority_.string();

  EXPECT_EQ(seen(with("localhost", {{"sslmode", "verify-full"}, {"sslrootcert", root}})), "true|torsio");
  EXPECT_EQ(seen(with("127.0.0.1", {{"sslmode", "verify-ca"}, {"sslrootcert", root}})), "true|torsio");
  const std::string wrong = refusal(with("127.0.0.1", {{"sslmode", "verify-full"}, {"sslrootcert", root}}));
  EXPECT_NE(wrong.find("127.0.0.1"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("localhost"), std::string::npos) << wrong;
}

TEST_F(ServerTlsTest, RejectsAnUnrelatedAuthority) {
  const TemporaryFolder folder;
  const fs::path other = folder.path() / "other.crt";
  ASSERT_EQ(std::system(("openssl req -x509 -newkey rsa:2048 -nodes -days 1 -subj /CN=other -keyout " +
                         (folder.path() / "other.key").string() + " -out " + other.string() + " 2>/dev/null")
                            .c_str()),
            0);

  const std::string wrong =
      refusal(with("localhost", {{"sslmode", "verify-full"}, {"sslrootcert", other.string()}}));

  EXPECT_NE(wrong.find("certificate"), std::string::npos) << wrong;
  const std::string none =
      refusal(with("localhost", {{"sslmode", "verify-full"}, {"sslrootcert", "/nowhere/ca.crt"}}));
  EXPECT_NE(none.find("/nowhere/ca.crt"), std::string::npos) << none;
}

TEST_F(ServerTlsTest, GoesWithoutTlsOnlyOnRequest) {
  EXPECT_EQ(seen(with("127.0.0.1", {{"sslmode", "disable"}, {"application_name", "room 7 'left'"}})),
            "false|room 7 'left'");
  EXPECT_EQ(seen(with("127.0.0.1", {{"sslmode", "require"}})), "true|torsio");
}

TEST_F(ServerTlsTest, TakesEverythingFromAServiceFileAndThePasswordFromItsOwnFile) {
  const TemporaryFolder folder;
  const fs::path service = folder.path() / "service.conf";
  const fs::path passwords = folder.path() / "pgpass";
  std::ofstream(service) << "[ward]\nhost=localhost\nport=" << server_.port << "\ndbname=" << server_.database
                         << "\nuser=" << server_.user
                         << "\nsslmode=verify-full\nsslrootcert=" << authority_.string()
                         << "\napplication_name=from the file\n";
  std::ofstream(passwords) << "*:*:*:*:" << server_.password << "\n";
  fs::permissions(passwords, fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_EQ(setenv("PGSERVICEFILE", service.c_str(), 1), 0);

  EXPECT_EQ(seen("postgresql:///?service=ward&passfile=" + passwords.string()), "true|from the file");

  const std::string none = refusal("postgresql:///?service=nobody");
  EXPECT_NE(none.find("nobody"), std::string::npos) << none;
  unsetenv("PGSERVICEFILE");
}

}  // namespace

}  // namespace torsio
