// SPDX-License-Identifier: GPL-3.0-or-later
// Which events enter the outbox, and what the statements contain and never contain.
#include "app/connectors/xapi/learning_records.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/connectors/xapi/learning_statement.h"
#include "app/services/recording/competence.h"
#include "db/repository/base/learning_events.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/person_data.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "sim/core/error.h"
#include "tests/app/connectors/xapi/xapi_centre.h"

namespace torsio {
namespace {

using testing::TestLrs;

Exposure restOf(const std::string& enrolment, const std::string& id) {
  return {.id = id,
          .enrolmentId = enrolment,
          .kind = ExposureKind::kRest,
          .startedUtc_us = kCentreTime_us,
          .duration_us = 3 * kMinute_us,
          .recordedBy = "office"};
}

/// A physician's remark on a trial, of which T-01 reads the first and the latest version.
void remarkAndRead(XapiCentre& centre, const std::string& trial) {
  RemarkRepository remarks(centre.connection());
  const std::string chief = PeopleRepository(centre.connection()).raters().front().person.id;
  const RemarkId remark = "11111111-1111-4111-8111-111111111111";
  remarks.add({.id = remark,
               .trialId = trial,
               .author = chief,
               .authorPersonId = chief,
               .purpose = "remark",
               .text = "let go more gently",
               .createdUtc_us = kCentreTime_us});
  for (const std::int64_t version : {1, 2}) {
    remarks.markRead({.remarkId = remark,
                      .version = version,
                      .reader = centre.centre().session().actor().userId,
                      .readerPersonId = centre.person("T-01"),
                      .readUtc_us = kCentreTime_us + version * kMinute_us});
  }
}

nlohmann::json statementWith(const std::vector<TestLrs::Stored>& stored, const std::string& verb) {
  for (const TestLrs::Stored& one : stored) {
    nlohmann::json statement = nlohmann::json::parse(one.bytes);
    if (statement["verb"]["display"]["en"] == verb) {
      return statement;
    }
  }
  return {};
}

TEST(LearningRecords, EachEventIsSentOnceInOrderAndAnonymously) {
  XapiCentre centre;
  centre.turnOn();
  const std::string enrolment = centre.enrol("T-01");
  const std::string trial = centre.run();
  const Exposure rest = restOf(centre.centre().enrolment(), "22222222-2222-4222-8222-222222222222");
  StudyRepository(centre.connection()).addExposures({&rest, 1});
  remarkAndRead(centre, trial);

  const LrsDelivery done = centre.deliver();

  EXPECT_EQ(done.delivered, 6);
  EXPECT_EQ(done.dead + done.later + done.forgotten, 0);
  const std::vector<TestLrs::Stored> stored = centre.store().stored();
  EXPECT_TRUE(centre.store().complaints().empty()) << centre.store().complaints().front();
  ASSERT_EQ(stored.size(), 6U);
  std::set<std::string> verbs;
  std::set<std::string> accounts;
  std::string before;
  for (const TestLrs::Stored& one : stored) {
    const nlohmann::json statement = nlohmann::json::parse(one.bytes);
    verbs.insert(statement["verb"]["display"]["en"]);
    accounts.insert(statement["actor"]["account"]["name"]);
    EXPECT_LE(before, statement["timestamp"].get<std::string>());
    before = statement["timestamp"];
    for (const std::string& secret : {std::string("T-01"), centre.person("T-01").text(), enrolment, trial,
                                      rest.id.text(), std::string("G1"), std::string("gently")}) {
      EXPECT_EQ(one.bytes.find(secret), std::string::npos) << secret << " in " << one.bytes;
    }
  }
  EXPECT_EQ(verbs,
            (std::set<std::string>{"registered", "launched", "completed", "passed", "experienced", "read"}));
  EXPECT_EQ(accounts.size(), 1U);
  EXPECT_EQ(statementWith(stored, "experienced")["result"]["duration"], "PT180.00S");
  EXPECT_EQ(statementWith(stored, "completed")["result"]["duration"], "PT12.00S");
  EXPECT_EQ(statementWith(stored, "registered")["object"]["definition"]["name"]["und"], "Spring course 1");
  EXPECT_EQ(statementWith(stored, "read")["timestamp"], "2025-11-21T08:01:00.000000Z");

  EXPECT_EQ(centre.deliver().delivered, 0);
  EXPECT_EQ(centre.store().posted().size(), 6U);
  EXPECT_EQ(centre.counts().delivered, 6);
}

TEST(LearningRecords, APassIncludesTheErrorRatesOfCompetence) {
  XapiCentre centre;
  centre.turnOn();
  centre.run(1.0);
  centre.run(0.0);
  const auto module = CurriculumRepository(centre.connection()).module(centre.centre().module("first"));
  ExerciseRules rules;
  const CompetenceVerdict verdict =
      competenceOf(centre.connection(), "T-01", *module, rules, centre.centre().session().now_us());

  centre.deliver();

  const std::vector<TestLrs::Stored> stored = centre.store().stored();
  const nlohmann::json passed = statementWith(stored, "passed");
  const nlohmann::json failed = statementWith(stored, "failed");
  ASSERT_TRUE(passed.is_object());
  ASSERT_TRUE(failed.is_object());
  EXPECT_EQ(passed["result"]["success"], true);
  EXPECT_EQ(failed["result"]["success"], false);
  EXPECT_LT(failed["result"]["score"]["scaled"].get<double>(), 0.8);
  EXPECT_GE(passed["result"]["score"]["scaled"].get<double>(), 0.8);
  const nlohmann::json& first = passed["result"]["extensions"];
  const nlohmann::json& second = failed["result"]["extensions"];
  const std::string base = kXapiExtensions;
  EXPECT_EQ(second[base + "false-pass-rate"], verdict.errors.falsePass);
  EXPECT_EQ(second[base + "false-fail-rate"], verdict.errors.falseFail);
  EXPECT_EQ(second[base + "within-attempts"], verdict.errors.attempts);
  EXPECT_EQ(second[base + "attempts"], verdict.attempts);
  EXPECT_EQ(second[base + "able"], isAble(verdict.level));
  EXPECT_LT(first[base + "attempts"].get<int>(), second[base + "attempts"].get<int>())
      << "what was known after that run, not after later ones";
}

TEST(LearningRecords, NothingIsStoredUnlessTheCentreSendsAndThePersonConsents) {
  XapiCentre centre;
  centre.enrol("T-01");
  EXPECT_TRUE(centre.outbox().empty()) << "off unless somebody turned it on";
  centre.turnOn();
  centre.enrol("T-02");
  EXPECT_TRUE(centre.outbox().empty()) << "T-02 was not asked";
  centre.decide("T-02", true);
  centre.enrol("T-02");
  EXPECT_EQ(centre.outbox().size(), 1U);
  centre.decide("T-02", false);
  centre.enrol("T-02");
  EXPECT_EQ(centre.outbox().size(), 1U) << "the newest decision counts";

  const LrsDelivery done = centre.deliver();

  EXPECT_EQ(done.forgotten, 1) << "withdrawn before it was sent";
  EXPECT_TRUE(centre.outbox().empty());
  EXPECT_TRUE(centre.store().posted().empty());
  setLrsSettings(centre.asAdministrator(), {});
  centre.enrol("T-01");
  EXPECT_TRUE(centre.outbox().empty()) << "turned off";
}

TEST(LearningRecords, AreWrittenWithTheEventOrNotAtAll) {
  XapiCentre centre;
  centre.turnOn();
  {
    const Transaction given(centre.connection());
    centre.enrol("T-01");
    EXPECT_EQ(centre.outbox().size(), 1U);
  }
  EXPECT_TRUE(centre.outbox().empty()) << "the enrolment was taken back";
  const std::string trial = centre.run();
  ASSERT_EQ(centre.outbox().size(), 3U);
  const std::string judged = statementId(centre.outbox().front());
  centre.run();
  EXPECT_EQ(centre.outbox().size(), 6U);
  std::set<std::string> ids;
  for (const LearningEvent& event : centre.outbox()) {
    ids.insert(statementId(event));
  }
  EXPECT_EQ(ids.size(), 6U);
  EXPECT_TRUE(ids.contains(judged));
}

TEST(LearningRecords, DemonstrationAndAnonymousFreePracticeAreNotSent) {
  XapiCentre centre;
  centre.turnOn();
  Exposure simulated = restOf(centre.centre().enrolment(), "33333333-3333-4333-8333-333333333333");
  simulated.demonstration = true;
  Exposure training = restOf(centre.centre().enrolment(), "44444444-4444-4444-8444-444444444444");
  training.kind = ExposureKind::kReal;
  StudyRepository(centre.connection()).addExposures(std::vector{simulated, training});
  EXPECT_TRUE(centre.outbox().empty());
}

TEST(LearningRecords, AnErasedPersonLeavesNothingInTheOutbox) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  centre.deliver();
  centre.enrol("T-01");
  ASSERT_EQ(centre.outbox().size(), 2U);
  erasePerson(centre.connection(), centre.person("T-01"), "office", "asked for it", kCentreTime_us);
  EXPECT_TRUE(centre.outbox().empty());
}

TEST(LrsSettings, RejectUnencryptedEndpointsAndKeepAccountsWhenTheyChange) {
  XapiCentre centre;
  SessionContext& office = centre.asAdministrator();
  EXPECT_EQ(lrsSettings(office), LrsSettings{});
  const auto refused = [&](const LrsSettings& settings) {
    try {
      setLrsSettings(centre.asAdministrator(), settings);
    } catch (const Error& error) {
      return error.code() == ErrorCode::kBadParameter;
    }
    return false;
  };
  const std::string home = "https://skills.example.org";
  EXPECT_TRUE(refused({true, "", home}));
  EXPECT_TRUE(refused({true, "http://lrs.example.org/xapi", home}));
  EXPECT_TRUE(refused({true, "ftp://lrs.example.org/xapi", home}));
  EXPECT_TRUE(refused({true, "https://user:secret@lrs.example.org/xapi", home}));
  EXPECT_TRUE(refused({true, "https://lrs.example.org/xapi", "skills"}));
  EXPECT_FALSE(refused({true, "https://lrs.example.org/xapi", home}));
  const std::string name = accountName(lrsIdentity(centre.connection()).value(), centre.person("T-01"));
  EXPECT_NE(name, accountName(lrsIdentity(centre.connection()).value(), centre.person("T-02")));
  EXPECT_FALSE(refused({false, "https://other.example.org/xapi", home}));
  EXPECT_EQ(accountName(lrsIdentity(centre.connection()).value(), centre.person("T-01")), name);
  centre.centre().become("T-01");
  EXPECT_THROW((void)lrsSettings(centre.centre().session()), Error);
}

TEST(LrsSettings, TheKeyIsInAFileOfTheAccountAndNotInTheRecord) {
  XapiCentre centre;
  EXPECT_FALSE(stationLrsKey());
  EXPECT_THROW((void)sendLearningRecords(centre.asAdministrator()), Error);
  centre.turnOn();
  const std::optional<LrsKey> key = stationLrsKey();
  ASSERT_TRUE(key);
  EXPECT_EQ(key->user, TestLrs::kUser);
  EXPECT_EQ(key->secret, TestLrs::kSecret);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(centre.centre().folder())) {
    std::ifstream file(entry.path(), std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    EXPECT_EQ(bytes.str().find(TestLrs::kSecret), std::string::npos) << entry.path();
  }
  EXPECT_THROW(setStationLrsKey({"a:b", "c"}), Error);
  EXPECT_THROW(setStationLrsKey({"a", ""}), Error);
  EXPECT_EQ(stationLrsKey()->secret, TestLrs::kSecret) << "what was refused changed nothing";
  setStationLrsKey({});
  EXPECT_FALSE(stationLrsKey());
}

}  // namespace
}  // namespace torsio
