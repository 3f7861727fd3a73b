// SPDX-License-Identifier: GPL-3.0-or-later
// Time stamps (RFC 3161) of heads, by an authority that runs `openssl ts`: whatever it answers, heads are
// kept.
#include "app/services/maintenance/stamped_heads.h"

#include <chrono>
#include <fstream>

#include <QByteArray>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/time_stamp.h"
#include "assessment/domain/people/account.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"
#include "tests/app/cli/program.h"
#include "tests/app/record_safety/stamp_server.h"
#include "tests/db/sample_record.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using Fault = StampServer::Fault;

/// A record whose centre names an authority, and an administrator.
class StampedHeads : public ::testing::Test {
 protected:
  static constexpr const char* kPassword = "four walls and a lamp";
  static constexpr int kVerifyFailed = static_cast<int>(ErrorCode::kVerifyFailed);

  StampedHeads()
      : folder_(emptyFolder(std::string("stamps-") +
                            ::testing::UnitTest::GetInstance()->current_test_info()->name())),
        server_(folder_) {
    Connection connection = openRecord(file("record.sqlite"), OpenMode::kCreate, {.softwareVersion = "test"});
    const FullRecord rows(connection, "real", false);
    AccessRepository access(connection, PasswordCost::kTest);
    access.addUser({.id = "u-office", .login = "office", .roles = {"administrator"}}, kPassword);
    access.setPassword("u-office", access.sealPassword("office", kPassword), false);
    std::ofstream(file("password")) << kPassword << "\n";
  }
  void nameAuthority() const {
    const ProgramRun set = run("audit authority" + database() + signIn() + " --address " + server_.address() +
                               " --certificate " + server_.root());
    ASSERT_EQ(set.code, 0) << set.err;
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string database() const { return " --database " + file("record.sqlite"); }
  [[nodiscard]] std::string signIn() const { return " --login office --password-fd 3 3<" + file("password"); }
  [[nodiscard]] ProgramRun run(const std::string& arguments) const { return runTorsio(arguments, folder_); }
  [[nodiscard]] ProgramRun head() const {
    return run("audit head" + database() + " --witness " + file("heads"));
  }
  [[nodiscard]] ProgramRun verified(const std::string& more = "") const {
    return run("audit verify" + database() + " --witness " + file("heads") + more);
  }
  [[nodiscard]] StampAuthority authority() const { return {server_.address(), readFile(server_.root())}; }
  void write(const std::vector<std::string>& lines, const std::string& end = "\n") const {
    std::ofstream out(file("heads"), std::ios::binary);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      out << lines[i] << (i + 1 < lines.size() ? "\n" : end);
    }
  }

  fs::path folder_;
  StampServer server_;
};

TEST_F(StampedHeads, SayFromWhenOnTheTrailExistedAndOpensslSaysTheSame) {
  nameAuthority();
  ASSERT_EQ(head().code, 0);
  ASSERT_EQ(head().code, 0);

  const ProgramRun whole = verified();
  EXPECT_EQ(whole.code, 0) << whole.out << whole.err;
  EXPECT_NE(whole.out.find("The trail demonstrably existed up to entry "), std::string::npos) << whole.out;
  EXPECT_NE(whole.out.find(", says Stamps of the test"), std::string::npos) << whole.out;
  const ProgramRun json = verified(" --json");
  EXPECT_EQ(nlohmann::json::parse(json.out).at("proven").size(), 2U) << json.out;

  const std::vector<std::string> lines = headsOf(file("heads"));
  ASSERT_EQ(lines.size(), 4U);
  std::ofstream(file("head"), std::ios::binary) << lines[0];
  std::ofstream(file("stamp"), std::ios::binary)
      << QByteArray::fromBase64(QByteArray::fromStdString(lines[1].substr(lines[1].rfind(' ') + 1)))
             .toStdString();
  const ProgramRun theirs = runProgram(
      "openssl", "ts -verify -data " + file("head") + " -in " + file("stamp") + " -CAfile " + server_.root(),
      folder_);
  EXPECT_EQ(theirs.code, 0) << theirs.out << theirs.err;
}

TEST_F(StampedHeads, ABrokenStrangeOrMissingStampIsNamed) {
  nameAuthority();
  ASSERT_EQ(head().code, 0);
  ASSERT_EQ(head().code, 0);
  const std::vector<std::string> lines = headsOf(file("heads"));

  std::vector<std::string> changed = lines;
  char& one = changed[1][changed[1].size() - 100];
  one = one == 'A' ? 'B' : 'A';
  write(changed);
  const ProgramRun broken = verified();
  EXPECT_EQ(broken.code, kVerifyFailed);
  EXPECT_NE(broken.out.find("time stamp"), std::string::npos) << broken.out;

  write({lines[2], lines[1]});
  const ProgramRun strange = verified();
  EXPECT_EQ(strange.code, kVerifyFailed);
  EXPECT_NE(strange.out.find("its checkpoint is missing, or was changed"), std::string::npos) << strange.out;

  write({lines[0], lines[1], lines[2]});
  const ProgramRun missing = verified();
  EXPECT_EQ(missing.code, 0) << "the authority may have been away";
  EXPECT_NE(missing.out.find("1 checkpoint has no time stamp"), std::string::npos) << missing.out;

  write({lines[0], lines[1].substr(0, lines[1].size() - 8)}, "");  // killed while it was written
  EXPECT_EQ(verified().code, 0);
  ASSERT_EQ(head().code, 0);
  EXPECT_EQ(headsOf(file("heads")).size(), 3U) << "the cut line is gone";

  write(lines);
  const ProgramRun other = verified(" --certificate " + server_.otherRoot());
  EXPECT_EQ(other.code, kVerifyFailed);
  EXPECT_NE(other.out.find("an authority that this centre does not trust"), std::string::npos) << other.out;
}

TEST_F(StampedHeads, AWrongClockIsRevealed) {
  nameAuthority();
  const std::string future = [&] {
    Connection connection = openRecord(file("record.sqlite"), OpenMode::kReadOnly);
    return anchoredHead(connection, {}, utcNow_us() + 400 * kDay_us);
  }();
  write({future, stampedBy(authority(), future)});

  const ProgramRun early = verified();
  EXPECT_EQ(early.code, 0) << early.out;
  EXPECT_NE(early.out.find("the clock of the station was wrong"), std::string::npos) << early.out;
}

struct Hostile {
  Fault fault;
  const char* said;
};

TEST_F(StampedHeads, WhateverTheAuthorityAnswersIsToldInTimeAndLosesNothing) {
  nameAuthority();
  ASSERT_EQ(head().code, 0);  // what kOldAnswer repeats
  const std::vector<Hostile> cases{
      {Fault::kRefuses, "the authority gave no time stamp"},
      {Fault::kOldAnswer, ""},  // another text and another nonce: either is told
      {Fault::kOtherText, "the time stamp is of another text"},
      {Fault::kOtherAuthority, "an authority that this centre does not trust"},
      {Fault::kBroken, "answered with the status 500"},
      {Fault::kRedirects, "answered with the status 302"},
      {Fault::kPage, "the answer is no time stamp"},
      {Fault::kEmpty, "the answer is no time stamp"},
      {Fault::kHalf, "gave no answer"},
      {Fault::kHangsUp, "gave no answer"},
      {Fault::kSlow, "gave no answer"},
      {Fault::kEndless, "gave no answer"},
      {Fault::kEndlessHead, "gave no answer"},
  };
  for (const auto& [fault, said] : cases) {
    SCOPED_TRACE(static_cast<int>(fault));
    server_.become(fault);
    const std::int64_t before = server_.sent_bytes();
    const auto begin = std::chrono::steady_clock::now();
    std::string told;
    try {
      (void)stampedBy(authority(), "torsio-head 1 7 abc 1 - -", std::chrono::seconds(2));
    } catch (const Error& error) {
      told = error.what();
    }
    const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::cout << "  " << static_cast<int>(fault) << ": " << took_s << " s, " << server_.sent_bytes() - before
              << " bytes: " << told << "\n";
    EXPECT_FALSE(told.empty());
    EXPECT_NE(told.find(said), std::string::npos) << told;
    EXPECT_EQ(told.find('\x1b'), std::string::npos);
    EXPECT_LT(took_s, 4.0);
    EXPECT_LT(server_.sent_bytes() - before, 16 << 20);
  }

  server_.become(Fault::kOtherAuthority);
  const ProgramRun refused = head();
  EXPECT_EQ(refused.code, kVerifyFailed) << refused.err;
  EXPECT_TRUE(refused.out.starts_with("torsio-head 1 ")) << "the head is printed, and kept";
  EXPECT_EQ(headsOf(file("heads")).size(), 3U);
  EXPECT_EQ(verified().code, 0);
}

TEST_F(StampedHeads, AnAuthorityIsNamedByWhoMayChangeSettingsAndOnlyWithACertificate) {
  const std::string set = "audit authority" + database();
  EXPECT_EQ(run(set + " --address http://stamps.example.org --certificate " + server_.root()).code,
            static_cast<int>(ErrorCode::kUsage))
      << "nobody signed in";
  EXPECT_EQ(
      run(set + signIn() + " --address http://stamps.example.org --certificate " + file("password")).code,
      static_cast<int>(ErrorCode::kBadData));
  EXPECT_EQ(run(set + signIn() + " --address http://stamps.example.org --certificate /dev/zero").code,
            static_cast<int>(ErrorCode::kFileUnreadable));
  EXPECT_EQ(run(set + signIn() + " --address ftp://x --certificate " + server_.root()).code,
            static_cast<int>(ErrorCode::kBadParameter));
  EXPECT_EQ(run(set).out, "Time stamps: none\n");
  EXPECT_EQ(run(set + signIn()).out, "Time stamps: none\n") << "without a choice it shows";
  nameAuthority();
  EXPECT_EQ(run(set + signIn()).out, "Time stamps: from " + server_.address() + "\n");
  EXPECT_EQ(run(set).out, "Time stamps: from " + server_.address() + "\n") << "it is still there";
  EXPECT_EQ(run(set + signIn() + " --off").code, 0);
  EXPECT_EQ(run(set).out, "Time stamps: none\n");
  EXPECT_EQ(head().code, 0);
  EXPECT_EQ(headsOf(file("heads")).size(), 1U) << "no authority, no stamp";
}

}  // namespace
}  // namespace torsio
