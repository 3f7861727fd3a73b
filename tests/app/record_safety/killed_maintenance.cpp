// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/record_safety/killed_maintenance.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>

#include <gtest/gtest.h>

#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/backup.h"
#include "db/migrations/migrations.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/file_io.h"
#include "tests/db/sample_record.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr long kInstants = 3;   // default for TORSIO_KILL_INSTANTS
constexpr long kEachAgain = 3;  // the same command runs again after one in this many instants ...
constexpr long kAgain = 20;     // ... or after fewer, so that it runs at most this many times

std::string lineOf(const std::vector<std::string>& arguments) {
  std::string line;
  for (const std::string& argument : arguments) {
    line += " '" + argument + "'";
  }
  return line;
}

/// TORSIO_KILL_PART=K/N: only every N-th of the instants, starting with the K-th (0 to N - 1), so that
/// several programs can share the work.
struct Part {
  long first = 0;
  long of = 1;
};

Part partOfInstants() {
  const char* text = std::getenv("TORSIO_KILL_PART");
  Part part;
  if (text != nullptr && std::strchr(text, '/') != nullptr) {
    part.first = std::atol(text);
    part.of = std::max(1L, std::atol(std::strchr(text, '/') + 1));
  }
  return part;
}

}  // namespace

std::string personIn(Connection& connection) {
  Statement row = connection.prepare("SELECT min(id) FROM person");
  row.execute();
  return row.step() ? row.text(0) : "";
}

bool isSound(Connection& connection) {
  return integrityFindings(connection).empty() && verifyAuditTrail(connection).empty();
}

void CutOffMaintenance::SetUp() {
  DatabaseTest::SetUp();
  if (IsSkipped()) {
    return;
  }
  const ::testing::TestInfo& test = *::testing::UnitTest::GetInstance()->current_test_info();
  folder_ = emptyFolder(std::string(test.test_suite_name()) + "-" + test.name() +
                        (onPostgresql() ? "-server" : ""));
  makeRecord("record.sqlite", "real");
}

void CutOffMaintenance::makeRecord(const std::string& name, const std::string& prefix) const {
  Connection connection = openRecord(file(name), OpenMode::kCreate, {.softwareVersion = "test"});
  const FullRecord rows(connection, prefix, false);
  SettingRepository(connection).set("two_people", "no", kSampleTime_us);
  connection.execute("UPDATE app_user SET state = ?",
                     {"disabled"});  // the owner of the file alone may do all
}

ProgramRun CutOffMaintenance::run(const std::vector<std::string>& arguments, const char* program) const {
  return runProgram(program, lineOf(arguments), folder_);
}

void CutOffMaintenance::cutOffEverywhere(const CutOff& cut, const char* fault, const char* variable,
                                         const std::function<void(const FaultyRun&)>& judge) const {
  cut.before();
  int code = -1;
  const long all = countInstants(cut.arguments, folder_, code, cut.program);
  ASSERT_EQ(code, 0) << run(cut.arguments, cut.program).err;
  ASSERT_GT(all, 0) << "nothing of it can be cut off";
  cut.after();
  const long wanted = std::min({all, cut.atMost, instantsOf(variable, kInstants)});
  const long eachAgain = std::max(kEachAgain, wanted / kAgain);
  const Part part = partOfInstants();
  for (long i = part.first; i < wanted && !HasFailure(); i += part.of) {
    const long instant = 1 + i * all / wanted;
    SCOPED_TRACE("instant " + std::to_string(instant) + " of " + std::to_string(all));
    cut.before();
    judge(runWithFault(cut.arguments, fault + std::to_string(instant), cut.program, file(".said")));
    cut.after();
    if (i % eachAgain == 0 && !HasFailure() && !cut.done()) {
      const ProgramRun again = run(cut.arguments, cut.program);
      EXPECT_EQ(again.code, 0) << again.err;
      cut.after();
    }
  }
  std::cout << "  " << (wanted - part.first + part.of - 1) / part.of << " of " << all << " instants\n";
  cut.before();
  const ProgramRun last = run(cut.arguments, cut.program);
  EXPECT_EQ(last.code, 0) << "at the end: " << last.err;
  cut.after();
}

void CutOffMaintenance::killEverywhere(const CutOff& cut) const {
  cutOffEverywhere(cut, "TORSIO_FAULT_KILL_AT=", "TORSIO_KILL_INSTANTS", [this](const FaultyRun& ended) {
    EXPECT_TRUE(ended.killed || ended.code == 0) << ended.code << ": " << readFile(file(".said"));
  });
}

void CutOffMaintenance::lookEverywhere(const CutOff& cut, const std::function<void()>& look) const {
  cut.before();
  int code = -1;
  const long all = countInstants(cut.arguments, folder_, code, cut.program);
  ASSERT_EQ(code, 0) << run(cut.arguments, cut.program).err;
  cut.before();
  const long every = std::max(1L, all / instantsOf("TORSIO_KILL_INSTANTS", kInstants));
  long looked = 0;
  const FaultyRun ended = runWithStops(
      cut.arguments, every,
      [&] {
        ++looked;
        SCOPED_TRACE("instant " + std::to_string(looked * every) + " of " + std::to_string(all));
        if (!HasFailure()) {
          look();
        }
      },
      cut.program);
  std::cout << "  stopped at " << looked << " of " << all << " instants\n";
  EXPECT_EQ(ended.code, 0);
  EXPECT_GT(looked, 0);
  cut.after();
}

void CutOffMaintenance::fillDiskEverywhere(const CutOff& cut) const {
  cutOffEverywhere(cut, "TORSIO_FAULT_FULL_AT=", "TORSIO_FULL_DISK_INSTANTS", [this](const FaultyRun& ended) {
    EXPECT_FALSE(ended.killed);
    std::ifstream in(file(".said"));
    std::string said;
    std::string last;
    for (std::string line; std::getline(in, line);) {
      said += line + "\n";
      last = line;
    }
    if (ended.code == 0) {
      return;  // a failed skippable operation
    }
    const auto is = [&ended](ErrorCode code) { return ended.code == static_cast<int>(code); };
    EXPECT_TRUE(is(ErrorCode::kFileUnwritable) || is(ErrorCode::kDatabase)) << ended.code << ": " << said;
    EXPECT_TRUE(last.starts_with("torsio: ")) << said;
    EXPECT_NE(last.find(". "), std::string::npos) << "no word of what to do: " << said;
  });
}

void CutOffMaintenance::emptySchema(const std::string& address) const {
  Connection server = open();
  const std::string schema = parseLocator(address).schema;
  if (numberFrom(server, "SELECT count(*) FROM pg_tables WHERE schemaname = '" + schema + "'") == 0) {
    return;
  }
  server.executeVerbatim("SET client_min_messages = warning");
  server.executeVerbatim("DROP SCHEMA " + schema + " CASCADE");
  server.executeVerbatim("CREATE SCHEMA " + schema);
}

std::string CutOffMaintenance::addressWithoutPassword() const {
  Locator server = parseLocator(locator());
  std::ofstream(file("pgpass")) << server.host << ":" << server.port << ":*:" << server.user << ":"
                                << server.password << "\n";
  fs::permissions(file("pgpass"), fs::perms::owner_read | fs::perms::owner_write);
  setenv("PGPASSFILE", file("pgpass").c_str(), 1);
  server.password.clear();
  server.parameters.push_back(kPatient);
  return addressOf(server);
}

void CutOffMaintenance::expectWholeRecord() const {
  Connection record = openRecord(file("record.sqlite"), OpenMode::kReadWrite);
  EXPECT_TRUE(isSound(record));
  EXPECT_TRUE(personIn(record).starts_with("real"));
}

void CutOffMaintenance::expectNothingHalf() const {
  for (const auto& entry : fs::directory_iterator(folder_)) {
    EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry.path();
  }
}

}  // namespace torsio
