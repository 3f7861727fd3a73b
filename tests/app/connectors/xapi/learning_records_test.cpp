// SPDX-License-Identifier: GPL-3.0-or-later
// Which events enter the outbox, and what the statements contain and never contain. A learning record store
// that misbehaves in every way known from the specification or networks: nothing is lost, duplicated or
// blocked.

#include "app/connectors/xapi/learning_records.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/connectors/xapi/learning_statement.h"
#include "app/connectors/xapi/lrs_delivery.h"
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

using Fault = TestLrs::Fault;

constexpr std::chrono::milliseconds kShort{400};

/// A store that accepts nothing for a while.
struct Away {
  const char* name;
  Fault fault;
};

class LrsFault : public ::testing::TestWithParam<Away> {};

TEST_P(LrsFault, LosesAndDuplicatesNothing) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  centre.enrol("T-01");
  centre.store().become(GetParam().fault);

  const bool silent = GetParam().fault == Fault::kHangs;
  const LrsDelivery first = silent ? centre.deliver(kShort) : centre.deliver();

  EXPECT_TRUE(first.stopped);
  EXPECT_EQ(first.delivered, 0);
  EXPECT_EQ(first.later, 1) << "one try tells that the store takes nothing";
  EXPECT_EQ(centre.counts().waiting, 2);
  EXPECT_FALSE(LearningRepository(centre.connection()).newestError().empty());
  const std::string kept = [&] {
    for (const LearningEvent& event : centre.outbox()) {
      if (!event.statement.empty()) {
        return event.statement;
      }
    }
    return std::string();
  }();
  EXPECT_FALSE(kept.empty());

  centre.store().become(Fault::kNone);
  centre.waitLong();
  const LrsDelivery second = centre.deliver();

  EXPECT_EQ(second.delivered, 2);
  EXPECT_EQ(centre.counts().delivered, 2);
  EXPECT_EQ(centre.counts().dead, 0);
  ASSERT_EQ(centre.store().stored().size(), 2U);
  EXPECT_TRUE(centre.store().complaints().empty());
  const auto stored = centre.store().stored();
  EXPECT_TRUE(stored[0].bytes == kept || stored[1].bytes == kept) << "the same bytes again";
  std::set<std::string> texts;
  for (const std::string& text : centre.store().posted()) {
    texts.insert(text);
  }
  EXPECT_EQ(texts.size(), 2U);
}

INSTANTIATE_TEST_SUITE_P(Every, LrsFault,
                         ::testing::Values(Away{"DropsBefore", Fault::kDropsBefore},
                                           Away{"DropsAfter", Fault::kDropsAfter},
                                           Away{"Hangs", Fault::kHangs}, Away{"Busy", Fault::kBusy},
                                           Away{"Broken", Fault::kBroken}, Away{"TooMany", Fault::kTooMany},
                                           Away{"Page", Fault::kPage}, Away{"Redirects", Fault::kRedirects},
                                           Away{"Nowhere", Fault::kNowhere}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(LrsDelivery, ARejectedKeyStopsTheQueueAndIsReported) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  setStationLrsKey({TestLrs::kUser, "an old secret"});

  EXPECT_TRUE(centre.deliver().stopped);

  EXPECT_NE(learningRecords(centre.asAdministrator()).trouble.str().find("the key is refused: HTTP 401"),
            std::string::npos);
  setStationLrsKey({TestLrs::kUser, TestLrs::kSecret});
  EXPECT_EQ(retryLearningRecords(centre.asAdministrator()), 0);
  EXPECT_EQ(centre.deliver().delivered, 1) << "at once, after the key was mended";
}

TEST(LrsDelivery, AKnownStatementCountsAsDeliveredHoweverTheStoreFormatsIt) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  centre.store().become(Fault::kDropsAfter);
  centre.deliver();
  ASSERT_EQ(centre.store().stored().size(), 1U) << "kept, and the answer lost";
  centre.store().become(Fault::kNotReadable);
  centre.waitLong();
  const LrsDelivery unread = centre.deliver();
  EXPECT_EQ(unread.later, 1) << "409, and not readable yet: neither delivered nor refused";
  EXPECT_FALSE(unread.stopped);
  centre.store().become(Fault::kAlwaysConflicts);
  centre.waitLong();

  EXPECT_EQ(centre.deliver().delivered, 1);

  EXPECT_EQ(centre.counts().waiting, 0);
  EXPECT_EQ(centre.store().stored().size(), 1U);
}

TEST(LrsDelivery, ADifferentStatementUnderTheIdIsADeadLetter) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  const std::string id = statementId(centre.outbox().front());
  nlohmann::json other{{"id", id}, {"verb", {{"id", "http://adlnet.gov/expapi/verbs/failed"}}}};
  centre.store().put(id, other.dump());

  const LrsDelivery done = centre.deliver();

  EXPECT_EQ(done.dead, 1);
  const LearningRecordsView view = learningRecords(centre.asAdministrator());
  ASSERT_EQ(view.dead.size(), 1U);
  EXPECT_NE(view.dead[0].answer.str().find("another statement"), std::string::npos);
  centre.waitLong();
  EXPECT_EQ(centre.deliver().dead, 0) << "not tried again by itself";
}

TEST(LrsDelivery, OneRejectedStatementBlocksNoOther) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  centre.enrol("T-01");
  centre.enrol("T-01");
  centre.store().refuse("Spring course 2");

  const LrsDelivery done = centre.deliver();

  EXPECT_EQ(done.delivered, 2);
  EXPECT_EQ(done.dead, 1);
  EXPECT_FALSE(done.stopped);
  const LearningRecordsView view = learningRecords(centre.asAdministrator());
  EXPECT_EQ(view.dead.at(0).answer.str(), "HTTP 400 this statement does not please");
  centre.store().refuse("");
  EXPECT_EQ(retryLearningRecords(centre.asAdministrator()), 1);
  EXPECT_EQ(centre.deliver().delivered, 1);
  EXPECT_EQ(centre.store().stored().size(), 3U);
}

TEST(LrsDelivery, AStatementRefusedAloneIsSetAsideAfterManyTries) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  centre.store().become(Fault::kRefuses);
  int tries = 1;
  while (centre.deliver().dead == 0 && tries < 100) {
    EXPECT_EQ(centre.counts().waiting, 1);
    centre.waitLong();
    ++tries;
  }
  EXPECT_EQ(tries, 12);
  EXPECT_EQ(dropLearningRecords(centre.asAdministrator()), 1);
  EXPECT_EQ(centre.counts().dead, 0);
}

/// What concerns the sender, not the statement, must not cost any.
TEST(LrsDelivery, AStoreThatTakesNoneOfTheStatementsLosesNone) {
  for (const int status : {400, 402, 406, 412, 413, 415, 422, 425, 426, 431}) {
    XapiCentre centre;
    centre.turnOn();
    for (int i = 0; i < 5; ++i) {
      centre.enrol("T-01");
    }
    centre.store().answerWith(status);

    const LrsDelivery done = centre.deliver();

    EXPECT_TRUE(done.stopped) << status;
    EXPECT_EQ(done.dead, 0) << status;
    EXPECT_EQ(centre.counts().waiting, 5) << status;
    EXPECT_LE(centre.store().posted().size(), 3U) << status;
    EXPECT_NE(learningRecords(centre.asAdministrator()).trouble.str().find(std::to_string(status)),
              std::string::npos);
    centre.store().become(Fault::kNone);
    centre.waitLong();
    EXPECT_EQ(centre.deliver().delivered, 5) << status;
  }
}

TEST(LrsDelivery, SpeaksVersionTwoToAStoreThatKnowsNoOther) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  centre.enrol("T-01");
  centre.store().become(Fault::kVersionTwo);

  const LrsDelivery done = centre.deliver();

  EXPECT_EQ(done.delivered, 2);
  EXPECT_TRUE(centre.store().complaints().empty());
}

TEST(LrsDelivery, TwoStationsDoNotSendTheSameStatement) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  LearningRepository outbox(centre.connection());
  const std::int64_t now_us = centre.centre().session().now_us();
  const std::vector<LearningEvent> seenByBoth = outbox.due(now_us, 10);
  ASSERT_EQ(seenByBoth.size(), 1U);
  EXPECT_TRUE(outbox.claim(seenByBoth[0], now_us + kMinute_us));
  EXPECT_FALSE(outbox.claim(seenByBoth[0], now_us + kMinute_us));
  EXPECT_EQ(outbox.keepStatement(seenByBoth[0], "the first"), "the first");
  EXPECT_EQ(outbox.keepStatement(seenByBoth[0], "the second"), "the first");
  EXPECT_TRUE(outbox.due(now_us, 10).empty());
  EXPECT_EQ(outbox.due(now_us + kMinute_us, 10).size(), 1U) << "that station may have died";
}

TEST(LrsDelivery, RetryIntervalsGrowToSixHoursAndAreSpread) {
  const std::int64_t half_us = kMinute_us / 2;
  for (const std::int64_t tries : {1, 2, 3, 8, 12, 40, 1'000'000}) {
    const std::int64_t plain_us =
        std::min<std::int64_t>(half_us << std::min<std::int64_t>(tries - 1, 20), 360 * kMinute_us);
    const std::int64_t wait_us = waitBeforeNextTry_us(tries, "one");
    EXPECT_GE(wait_us, plain_us * 3 / 4) << tries;
    EXPECT_LE(wait_us, plain_us * 5 / 4) << tries;
  }
  EXPECT_NE(waitBeforeNextTry_us(5, "one"), waitBeforeNextTry_us(5, "two"));
  EXPECT_EQ(retryAfter_us("120", 0), 2 * kMinute_us);
  EXPECT_EQ(retryAfter_us("Fri, 21 Nov 2025 08:10:00 GMT", kCentreTime_us), 10 * kMinute_us);
  EXPECT_EQ(retryAfter_us("99999999", 0), 24 * 60 * kMinute_us);
  for (const char* none : {"", "soon", "-5", "Fri, 21 Nov 2024 08:10:00 GMT"}) {
    EXPECT_EQ(retryAfter_us(none, kCentreTime_us), 0) << none;
  }
}

TEST(LrsDelivery, ABusyStoreIsRetriedOnlyAfterTheTimeItRequests) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  centre.store().become(Fault::kTooMany);
  centre.deliver();
  centre.store().become(Fault::kNone);
  centre.centre().passTime_us(119 * kMinute_us);
  EXPECT_EQ(centre.deliver().delivered, 0);
  centre.centre().passTime_us(2 * kMinute_us);
  EXPECT_EQ(centre.deliver().delivered, 1);
}

TEST(LrsWorker, SendsInTheBackgroundAndAbandonsASilentStore) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  std::optional<LrsWorker> worker(std::in_place, centre.centre().session().key(),
                                  std::chrono::milliseconds(20));
  for (int i = 0; i < 1'500 && centre.counts().delivered == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(centre.counts().delivered, 1);
  centre.store().become(Fault::kHangs);
  centre.enrol("T-01");
  worker.reset();  // during a request or before it; either way it ends
  EXPECT_EQ(centre.counts().waiting, 1);
}

}  // namespace

}  // namespace torsio
