// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/learning_events.h"

#include "db/connection/row_reader.h"
#include "db/repository/base/stored_term.h"

namespace torsio {

namespace {

/// How to build an event of one kind.
struct EventSource {
  const char* object;
  const char* person;
  const char* time;  ///< SQL of its time
  const char* from;  ///< SQL of its tables and condition, with one `?`: the object
};

constexpr const char* kTrialEnd_us = "t.started_utc_us + x.sample_count * t.tick_period_us";
constexpr const char* kEndedTrial =
    "trial t JOIN trial_end x ON x.trial_id = t.id WHERE t.id = ? AND x.outcome = 'completed'"
    " AND t.demonstration = FALSE AND t.scene_id <> 'foreign'";

EventSource sourceOf(LearningEventKind kind) {
  switch (kind) {
    case LearningEventKind::kRegistered:
      return {"e.id", "e.trainee_id", "e.enrolled_utc_us",
              "enrolment e WHERE e.id = ? AND e.demonstration = FALSE"};
    case LearningEventKind::kLaunched:
      return {"t.id", "t.trainee_id", "t.started_utc_us",
              "trial t WHERE t.id = ? AND t.demonstration = FALSE AND t.scene_id <> 'foreign'"};
    case LearningEventKind::kCompleted:
    case LearningEventKind::kJudged:
      return {"t.id", "t.trainee_id", kTrialEnd_us, kEndedTrial};
    case LearningEventKind::kRested:
      return {"x.id", "e.trainee_id", "x.started_utc_us + x.duration_us",
              "exposure x JOIN enrolment e ON e.id = x.enrolment_id WHERE x.id = ? AND x.kind = 'rest'"
              " AND x.demonstration = FALSE"};
    case LearningEventKind::kRemarkRead:
      return {"r.remark_id", "t.trainee_id", "r.read_utc_us",
              "remark_receipt r JOIN trial_remark m ON m.id = r.remark_id JOIN trial t ON t.id = m.trial_id"
              " WHERE r.remark_id = ? AND r.reader_person_id = t.trainee_id AND m.purpose <> 'bookmark'"
              " AND m.demonstration = FALSE AND NOT EXISTS (SELECT 1 FROM remark_receipt o"
              " WHERE o.remark_id = r.remark_id AND o.reader_person_id = r.reader_person_id"
              " AND o.version < r.version)"};
    case LearningEventKind::kEnd:
      break;
  }
  return {"t.id", "NULL", "0", "trial t WHERE t.id = ?"};
}

std::string agrees(const std::string& person) {
  return "EXISTS (SELECT 1 FROM consent c WHERE c.person_id = " + person + " AND c.purpose = '" +
         kLearningConsent +
         "' AND c.granted = TRUE AND NOT EXISTS (SELECT 1 FROM consent n WHERE n.person_id = c.person_id"
         " AND n.purpose = c.purpose AND n.sequence > c.sequence))";
}

}  // namespace

void noteLearningEvents(Connection& connection, LearningEventKind kind,
                        std::span<const std::string> objectIds) {
  const bool sends = selectFirst(connection, "SELECT value FROM setting WHERE name = ?", {kLearningSetting},
                                 readText) == "yes";
  if (!sends || objectIds.empty()) {
    return;
  }
  const EventSource source = sourceOf(kind);
  Statement insert = connection.prepare(
      "INSERT INTO learning_event (kind, object_id, person_id, happened_utc_us, state, tries,"
      " next_try_utc_us) SELECT '" +
      std::string(storedText(kind)) + "', " + source.object + ", " + source.person + ", " + source.time +
      ", 'waiting', 0, 0 FROM " + source.from + " AND " + agrees(source.person) +
      " ON CONFLICT (kind, object_id) DO NOTHING");
  for (const std::string& id : objectIds) {
    insert.execute({id});
  }
}

bool agreesToLearningRecords(Connection& connection, const PersonId& personId) {
  return selectFirst(connection, "SELECT p.id FROM person p WHERE p.id = ? AND " + agrees("p.id"), {personId},
                     readText)
      .has_value();
}

namespace {

const std::string kSelectEvents =
    "SELECT kind, object_id, person_id, happened_utc_us, statement, state, tries, next_try_utc_us, answer,"
    " answered_utc_us FROM learning_event";
constexpr const char* kThisEvent = " WHERE kind = ? AND object_id = ?";

constexpr const char* kOfTrial =
    "SELECT t.enrolment_id, c.id, c.name, t.id, t.module_id, x.sample_count * t.tick_period_us";
constexpr const char* kAroundTrial =
    " LEFT JOIN enrolment e ON e.id = t.enrolment_id LEFT JOIN cohort c ON c.id = e.cohort_id"
    " LEFT JOIN trial_end x ON x.trial_id = t.id WHERE ";

std::string selectFacts(LearningEventKind kind) {
  switch (kind) {
    case LearningEventKind::kRegistered:
      return "SELECT e.id, c.id, c.name, NULL, NULL, 0 FROM enrolment e JOIN cohort c ON c.id = e.cohort_id"
             " WHERE e.id = ?";
    case LearningEventKind::kRested:
      return "SELECT e.id, c.id, c.name, NULL, NULL, x.duration_us FROM exposure x"
             " JOIN enrolment e ON e.id = x.enrolment_id JOIN cohort c ON c.id = e.cohort_id WHERE x.id = ?";
    case LearningEventKind::kRemarkRead:
      return std::string(kOfTrial) + " FROM trial_remark m JOIN trial t ON t.id = m.trial_id" + kAroundTrial +
             "m.id = ?";
    default:
      return std::string(kOfTrial) + " FROM trial t" + kAroundTrial + "t.id = ?";
  }
}

LearningEvent eventOf(RowReader& row) {
  return {.kind = readTerm<LearningEventKind>(row),
          .objectId = row.text(),
          .personId = row.text(),
          .happenedUtc_us = row.int64(),
          .statement = row.text(),
          .state = readTerm<LearningEventState>(row),
          .tries = row.int64(),
          .nextTryUtc_us = row.int64(),
          .answer = row.text(),
          .answeredUtc_us = row.int64()};
}

}  // namespace

std::vector<LearningEvent> LearningRepository::due(std::int64_t now_us, std::int64_t limit) const {
  return selectAll(
      connection_,
      kSelectEvents +
          " WHERE state = 'waiting' AND next_try_utc_us <= ? ORDER BY happened_utc_us, object_id,"
          " kind LIMIT ?",
      {now_us, limit}, eventOf);
}

bool LearningRepository::claim(const LearningEvent& event, std::int64_t until_us) {
  return connection_.execute(std::string("UPDATE learning_event SET next_try_utc_us = ?, tries = tries + 1") +
                                 kThisEvent + " AND state = 'waiting' AND next_try_utc_us = ?",
                             {until_us, storedText(event.kind), event.objectId, event.nextTryUtc_us}) == 1;
}

std::string LearningRepository::keepStatement(const LearningEvent& event, const std::string& statement) {
  Transaction transaction(connection_);
  connection_.execute(
      std::string("UPDATE learning_event SET statement = ?") + kThisEvent + " AND statement IS NULL",
      {statement, storedText(event.kind), event.objectId});
  const auto kept = selectFirst(connection_, std::string("SELECT statement FROM learning_event") + kThisEvent,
                                {storedText(event.kind), event.objectId}, readText);
  transaction.commit();
  return kept.value_or("");
}

std::optional<LearningFacts> LearningRepository::facts(const LearningEvent& event) const {
  return selectFirst(connection_, selectFacts(event.kind), {event.objectId}, [](RowReader& row) {
    return LearningFacts{row.text(), row.text(), row.text(), row.text(), row.text(), row.int64()};
  });
}

void LearningRepository::answered(const LearningEvent& event, LearningEventState state,
                                  const std::string& answer, std::int64_t now_us, std::int64_t nextTry_us) {
  connection_.execute(
      std::string(
          "UPDATE learning_event SET state = ?, answer = ?, answered_utc_us = ?, next_try_utc_us = ?") +
          kThisEvent,
      {storedText(state), answer, now_us, nextTry_us, storedText(event.kind), event.objectId});
}

void LearningRepository::setDelivered(const LearningEvent& event, const std::string& answer,
                                      std::int64_t now_us) {
  answered(event, LearningEventState::kDelivered, answer, now_us, now_us);
}

void LearningRepository::setRefused(const LearningEvent& event, const std::string& answer,
                                    std::int64_t now_us) {
  answered(event, LearningEventState::kDead, answer, now_us, now_us);
}

void LearningRepository::setRetry(const LearningEvent& event, const std::string& answer, std::int64_t now_us,
                                  std::int64_t nextTry_us) {
  answered(event, LearningEventState::kWaiting, answer, now_us, nextTry_us);
}

void LearningRepository::forget(const LearningEvent& event) {
  connection_.execute(std::string("DELETE FROM learning_event") + kThisEvent,
                      {storedText(event.kind), event.objectId});
}

LearningEventCounts LearningRepository::counts() const {
  LearningEventCounts counts;
  Statement statement = connection_.prepare("SELECT state, COUNT(*) FROM learning_event GROUP BY state");
  statement.execute();
  while (statement.step()) {
    RowReader row(statement);
    const auto state = readTerm<LearningEventState>(row);
    const std::int64_t count = row.int64();
    (state == LearningEventState::kWaiting     ? counts.waiting
     : state == LearningEventState::kDelivered ? counts.delivered
                                               : counts.dead) = count;
  }
  return counts;
}

std::vector<LearningEvent> LearningRepository::inState(LearningEventState state, std::int64_t limit) const {
  return selectAll(connection_,
                   kSelectEvents +
                       " WHERE state = ? ORDER BY COALESCE(answered_utc_us, 0) DESC, happened_utc_us,"
                       " object_id, kind LIMIT ?",
                   {storedText(state), limit}, eventOf);
}

std::string LearningRepository::newestError() const {
  return selectFirst(connection_,
                     "SELECT answer FROM learning_event WHERE state = 'waiting' AND answer IS NOT NULL"
                     " ORDER BY answered_utc_us DESC LIMIT 1",
                     {}, readText)
      .value_or("");
}

std::int64_t LearningRepository::retryAll() {
  Transaction transaction(connection_);
  const std::int64_t dead = connection_.execute(
      "UPDATE learning_event SET state = 'waiting', tries = 0, next_try_utc_us = 0 WHERE state = 'dead'");
  connection_.execute("UPDATE learning_event SET next_try_utc_us = 0, tries = 0 WHERE state = 'waiting'");
  transaction.commit();
  return dead;
}

std::int64_t LearningRepository::dropRefused() {
  return connection_.execute("DELETE FROM learning_event WHERE state = 'dead'");
}

}  // namespace torsio
