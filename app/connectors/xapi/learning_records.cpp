// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/xapi/learning_records.h"

#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/base/stored_sentence.h"
#include "db/connection/connection.h"
#include "db/repository/base/learning_events.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::int64_t kMaxShown = 1'000;

void noteDone(const SessionContext& session, const char* what, std::int64_t count) {
  noteSetting(session, kLearningSetting, nullptr, {{what, count}});
}

}  // namespace

LearningRecordsView learningRecords(SessionContext& session) {
  session.require(Operation::kSettingsEdit);
  const LearningRepository outbox(session.connection());
  LearningRecordsView view;
  view.settings = lrsSettings(session);
  view.hasKey = stationLrsKey().has_value();
  view.counts = outbox.counts();
  view.trouble = readSentence(outbox.newestError());
  for (LearningEvent& event : outbox.inState(LearningEventState::kDead, kMaxShown)) {
    Text answer = readSentence(event.answer);
    view.dead.push_back({std::move(event), std::move(answer)});
  }
  return view;
}

std::int64_t retryLearningRecords(SessionContext& session) {
  session.require(Operation::kSettingsEdit);
  Transaction transaction(session.connection());
  const std::int64_t dead = LearningRepository(session.connection()).retryAll();
  noteDone(session, "retried", dead);
  transaction.commit();
  return dead;
}

std::int64_t dropLearningRecords(SessionContext& session) {
  session.require(Operation::kSettingsEdit);
  Transaction transaction(session.connection());
  const std::int64_t dead = LearningRepository(session.connection()).dropRefused();
  noteDone(session, "dropped", dead);
  transaction.commit();
  return dead;
}

LrsDelivery sendLearningRecords(SessionContext& session) {
  session.require(Operation::kReportExportCoded);
  const std::optional<LrsIdentity> identity = lrsIdentity(session.connection());
  if (!identity || !identity->settings.on) {
    refuse(Text::tr("the centre sends no learning records"), Text(),
           Text::tr("Turn it on under Learning records, or by torsio xapi set --on"));
  }
  const std::optional<LrsKey> key = stationLrsKey();
  if (!key) {
    refuse(Text::tr("this station has no key of the learning record store"), identity->settings.endpoint,
           Text::tr("Set it under Learning records, or by torsio xapi key --user NAME"));
  }
  LrsClient store(identity->settings.endpoint, *key);
  return deliverLearningRecords(session.connection(), *identity, store, [&] { return session.now_us(); });
}

}  // namespace torsio
