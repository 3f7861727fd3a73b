// SPDX-License-Identifier: GPL-3.0-or-later
// A record is set up from a file of answers, and its people sign in.
#include "app/services/installation/unattended_setup.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <unistd.h>

#include <QByteArray>
#include <QtGlobal>
#include <gtest/gtest.h>

#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/access/invitations.h"
#include "app/services/access/station_record.h"
#include "app/services/access/two_people.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOwnPassword = "a sentence of my own";
constexpr const char* kTraineeRoster = "external_id,full_name\n4711,Ada Lovelace\n4712,Grace Hopper\n";
constexpr const char* kRaterRoster = "external_id,full_name,rater_class\n900,Emil Theodor Kocher,chief\n";

class UnattendedSetup : public ::testing::Test {
 protected:
  UnattendedSetup() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    writeFileAtomically(folder_ / "trainees.csv", std::string(kTraineeRoster));
    writeFileAtomically(folder_ / "raters.csv", std::string(kRaterRoster));
  }
  ~UnattendedSetup() override { fs::remove_all(folder_); }
  void answer(const std::string& text) const { writeFileAtomically(file(), text); }
  [[nodiscard]] fs::path file() const { return folder_ / "answers.conf"; }
  [[nodiscard]] std::string record() const { return (folder_ / "record.sqlite").string(); }
  [[nodiscard]] SetUpRecord setUp() const { return setUpRecord(record(), file()); }
  [[nodiscard]] SessionContext session() const {
    return SessionContext(SessionKey{.locator = record(), .station = "station"});
  }
  const fs::path folder_ = fs::temp_directory_path() / ("torsio-setup-" + std::to_string(getpid()));
};

constexpr const char* kWholeCentre =
    "centre = University Hospital Nanjing  # a comment\n"
    "centre.code = UHN\n"
    "language = zh_CN\n"
    "administrator = m.keller\n"
    "account = b.chen administrator\n"
    "account = c.diaz allocator, statistician\n"
    "roster.trainees = trainees.csv\n"
    "roster.raters = raters.csv\n"
    "roster.accounts = yes\n";

TEST_F(UnattendedSetup, SetsUpTheCentreWithItsPeopleAndTheFirstAdministratorSignsIn) {
  answer(kWholeCentre);

  const SetUpRecord made = setUp();

  EXPECT_EQ(made.code, "UHN");
  EXPECT_EQ(made.trainees, 2U);
  EXPECT_EQ(made.raters, 1U);
  ASSERT_EQ(made.accounts.size(), 6U);
  EXPECT_EQ(made.accounts[0].login, "m.keller");
  const std::string start = made.accounts[0].startPassword;
  SessionContext own = session();
  EXPECT_EQ(centreSign(own.connectionWithoutRight()).name, "University Hospital Nanjing");
  EXPECT_EQ(centreSign(own.connectionWithoutRight()).language, "zh_CN");
  EXPECT_EQ(signIn(own, "m.keller", start).outcome, SignIn::kMustChange) << "a start password is changed";
  EXPECT_EQ(changeOwnPassword(own, {"m.keller", start, kOwnPassword}).outcome, SignIn::kOk);
  EXPECT_TRUE(own.actor().hasRole(kAdministratorRole));
  EXPECT_EQ(openRequests(own).size(), 2U) << "roles of c.diaz and the rater's password need a second person";
}

TEST_F(UnattendedSetup, TheSecondAdministratorConfirmsWhatTheFirstAskedFor) {
  answer(kWholeCentre);
  const SetUpRecord made = setUp();
  const StartAccount& second = made.accounts[1];
  const StartAccount& third = made.accounts[2];
  EXPECT_EQ(second.part, PasswordPart::kWhole);
  EXPECT_EQ(third.part, PasswordPart::kFirstHalf);

  SessionContext own = session();
  EXPECT_EQ(changeOwnPassword(own, {"b.chen", second.startPassword, kOwnPassword}).outcome, SignIn::kOk);
  std::string password = third.startPassword;
  for (const OpenRequest& request : openRequests(own)) {
    if (request.shown == "c.diaz") {
      password += "-" + confirmRequest(own, request.request.id);
    }
  }

  EXPECT_EQ(signIn(own, "c.diaz", password).outcome, SignIn::kMustChange);
}

TEST_F(UnattendedSetup, AFirstAdministratorWithALinkChoosesThePassword) {
  answer(
      "centre = Clinic\nadministrator = chief\nadministrator.first-sign-in = link\n"
      "browser-address = https://desk.example.org\n");

  const SetUpRecord made = setUp();

  EXPECT_TRUE(made.link.starts_with("https://desk.example.org/join#")) << made.link;
  EXPECT_TRUE(made.accounts.empty()) << "a link is the only way in";
  SessionContext own = session();
  const std::string secret = made.link.substr(made.link.find('#') + 1);
  EXPECT_EQ(acceptInvitation(own, secret, "", kOwnPassword).outcome, SignIn::kOk);
  EXPECT_TRUE(own.actor().hasRole(kAdministratorRole));
  EXPECT_EQ(acceptInvitation(own, secret, "", kOwnPassword).outcome, SignIn::kWrong) << "once";
}

TEST_F(UnattendedSetup, ACentreIsSetUpOnce) {
  answer("centre = Clinic\nadministrator = chief\n");
  (void)setUp();
  const std::string before = readFile(record());

  const Error again = testing::refusal([this] { return setUp(); });

  testing::expectError(again, ErrorCode::kPermission, {"belongs to a centre already"});
  EXPECT_EQ(readFile(record()), before);
}

TEST_F(UnattendedSetup, EachFaultNamesItsLineAndWhatToWriteAndLeavesNoRecord) {
  const std::string centre = "centre = Clinic\nadministrator = chief\n";
  writeFileAtomically(folder_ / "twice.csv", std::string("external_id,full_name\n1,Ada\n1,Grace\n"));
  const struct {
    std::string text;
    const char* place;
    const char* says;
  } faults[] = {
      {"administrator = chief\n", "answers.conf: \"centre\" is missing", "Add a line centre = ..."},
      {"centre = Clinic\n", "\"administrator\" is missing", "Add a line administrator = ..."},
      {centre + "languge = en\n", "answers.conf, line 3", "Did you mean language?"},
      {centre + "language = fr\n", "answers.conf, line 3", "Write en or zh_CN"},
      {centre + "centre = Other\n", "answers.conf, line 3", "already set in line 1"},
      {centre + "centre.code = lower\n", "answers.conf, line 3", "capital Latin letters"},
      {"centre = Clinic\nadministrator = a\u200bb\n", "answers.conf, line 2", "the sign-in name"},
      {centre + "administrator.first-sign-in = mail\n", "answers.conf, line 3", "Write password or link"},
      {centre + "administrator.first-sign-in = link\n", "answers.conf, line 3", "browser-address = "},
      {centre + "browser-address = http://desk\n", "answers.conf, line 3", "Write it as https://"},
      {centre + "account = b.chen\n", "answers.conf, line 3", "has no role"},
      {centre + "account = b.chen boss\n", "answers.conf, line 3", "administrator, allocator, statistician"},
      {centre + "account = CHIEF administrator\n", "answers.conf, line 3", "looks like chief"},
      {centre + "roster.trainees = nowhere.csv\n", "answers.conf, line 3", "nowhere.csv"},
      {centre + "roster.trainees = twice.csv\n", "twice.csv, line 3", ""},
      {centre + "roster.accounts = perhaps\n", "answers.conf, line 3", "Write yes or no"},
  };
  for (const auto& fault : faults) {
    answer(fault.text);
    for (const Error& refused : {testing::refusal([this] { return setUp(); }), testing::refusal([this] {
                                   tryAnswers(file());
                                   return 0;
                                 })}) {
      testing::expectError(refused, ErrorCode::kBadData, {fault.place, fault.says});
    }
    EXPECT_FALSE(fs::exists(record())) << fault.text;
  }
}

// The record that the window would open, in a folder that a new account does not have yet.
TEST_F(UnattendedSetup, AnAccountWithoutAnyDataGetsTheRecordOfItsWindow) {
  answer("centre = Clinic\nadministrator = chief\n");
  const QByteArray before = qgetenv("XDG_DATA_HOME");
  qputenv("XDG_DATA_HOME", QByteArray::fromStdString((folder_ / "data").string()));

  EXPECT_NO_THROW((void)setUpRecord(stationRecord().locator, file()));

  EXPECT_TRUE(fs::exists(stationRecord().locator)) << stationRecord().locator;
  before.isNull() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", before);
}

TEST_F(UnattendedSetup, TryingWritesNothing) {
  answer(kWholeCentre);

  tryAnswers(file());

  const auto entries = fs::recursive_directory_iterator(folder_);
  EXPECT_FALSE(std::any_of(begin(entries), end(entries), [](const fs::directory_entry& one) {
    return one.path().extension() == ".sqlite";
  }));
}

TEST(SetupAnswers, WhatTheGuideListsIsWhatTheProgramKnows) {
  const std::string guide = readFile(TORSIO_SOURCE_DIR "/docs/deployment.md");
  for (const FileKey& key : kAnswerKeys) {
    EXPECT_NE(guide.find("| `" + std::string(key.name) + "` | "), std::string::npos) << key.name;
  }
}

}  // namespace
}  // namespace torsio
