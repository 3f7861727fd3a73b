// SPDX-License-Identifier: GPL-3.0-or-later
// A learning record store that misbehaves in every way known from the specification or networks: nothing is
// lost, duplicated or blocked.
#include "app/connectors/xapi/lrs_delivery.h"

#include <chrono>
#include <optional>
#include <set>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/connectors/xapi/learning_records.h"
#include "app/connectors/xapi/learning_statement.h"
#include "db/repository/base/learning_events.h"
#include "tests/app/connectors/xapi/xapi_centre.h"

namespace torsio {
namespace {

using testing::TestLrs;
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
  centre.store().become(Fault::kRefuses);
  centre.enrol("T-01");
  EXPECT_EQ(centre.deliver().dead, 1);
  EXPECT_EQ(dropLearningRecords(centre.asAdministrator()), 1);
  EXPECT_EQ(centre.counts().dead, 0);
  EXPECT_EQ(centre.store().stored().size(), 3U);
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
