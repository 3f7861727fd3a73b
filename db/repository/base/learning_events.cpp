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

}  // namespace torsio
