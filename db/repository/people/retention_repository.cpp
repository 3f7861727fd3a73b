// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/retention_repository.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "assessment/domain/ids.h"
#include "db/repository/base/id_source.h"
#include "db/repository/base/row_columns.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::array<std::string_view, 4> kCategories{kRetainTrainee, kRetainRater, kRetainLeft,
                                                      kRetainWithdrawn};
constexpr std::int64_t kLongest_days = 36'500;

/// State and creation; whether trainee and rater; kActivityTimes times of activity; since when consent to the
/// record is withdrawn.
constexpr int kActivityTimes = 6;
constexpr const char* kPeople =
    "SELECT p.id, p.code, p.state, p.created_utc_us,"
    " (SELECT count(*) FROM trainee t WHERE t.person_id = p.id),"
    " (SELECT count(*) FROM rater r WHERE r.person_id = p.id),"
    " (SELECT max(t.started_utc_us) FROM trial t WHERE t.trainee_id = p.id),"
    " (SELECT max(e.enrolled_utc_us) FROM enrolment e WHERE e.trainee_id = p.id),"
    " (SELECT max((SELECT max(m.submitted_utc_us) FROM training_mark m WHERE m.enrolment_id = e.id))"
    "  FROM enrolment e WHERE e.trainee_id = p.id),"
    " (SELECT max(m.submitted_utc_us) FROM training_mark m WHERE m.rater_id = p.id),"
    " (SELECT max(v.submitted_utc_us) FROM evaluation_rater r JOIN evaluation_mark v"
    "  ON v.campaign_id = r.campaign_id AND v.rater_id = r.rater_id WHERE r.rater_id = p.id),"
    " (SELECT max(c.decided_utc_us) FROM consent c WHERE c.person_id = p.id),"
    " (SELECT c.decided_utc_us FROM consent c WHERE c.person_id = p.id AND c.purpose = 'training_record'"
    "  AND c.granted = FALSE AND NOT EXISTS (SELECT 1 FROM consent n WHERE n.person_id = c.person_id"
    "  AND n.purpose = c.purpose AND n.sequence > c.sequence))"
    " FROM person p WHERE p.state <> 'erased' AND p.demonstration = FALSE ORDER BY p.code";

constexpr const char* kHolds =
    "SELECT person_id, kind, until_utc_us, reason, decided_by, decided_utc_us FROM retention_hold";

/// One row of kPeople.
struct Activity {
  PersonId personId;
  std::string code;
  bool left = false;
  std::int64_t last_us = 0;
  bool trainee = false;
  bool rater = false;
  std::optional<std::int64_t> withdrawn_us{};
};

Activity activityOf(RowReader& row) {
  Activity activity{.personId = row.text(),
                    .code = row.text(),
                    .left = row.text() == "left",
                    .last_us = row.int64(),
                    .trainee = row.int64() > 0,
                    .rater = row.int64() > 0};
  for (int time = 0; time < kActivityTimes; ++time) {
    activity.last_us = std::max(activity.last_us, row.int64());
  }
  activity.withdrawn_us = row.maybeInt64();
  return activity;
}

/// Returns the start of the retention period in a category; empty: does not apply.
std::optional<std::int64_t> since(const Activity& activity, std::string_view category) {
  if (category == kRetainWithdrawn) {
    return activity.withdrawn_us;
  }
  const bool counts = (category == kRetainTrainee && activity.trainee) ||
                      (category == kRetainRater && activity.rater) ||
                      (category == kRetainLeft && activity.left);
  return counts ? std::optional(activity.last_us) : std::nullopt;
}

RetentionHold holdOf(RowReader& row) {
  return {.personId = row.text(),
          .kind = readTerm<HoldKind>(row),
          .untilUtc_us = row.maybeInt64(),
          .reason = row.text(),
          .decidedBy = row.text(),
          .decidedUtc_us = row.int64()};
}

/// Returns the newest decision about each person who has one.
std::map<std::string, RetentionHold> newestHolds(Connection& connection) {
  std::map<std::string, RetentionHold> newest;
  for (RetentionHold& hold :
       selectAll(connection, std::string(kHolds) + " ORDER BY person_id, sequence", {}, holdOf)) {
    PersonId personId = hold.personId;
    newest.insert_or_assign(std::move(personId), std::move(hold));
  }
  return newest;
}

bool holdsAt(const RetentionHold& hold, std::int64_t utc_us) {
  return hold.kind == HoldKind::kLock ||
         (hold.kind == HoldKind::kExtend && hold.untilUtc_us.value_or(0) > utc_us);
}

}  // namespace

void RetentionRepository::setRule(const RetentionRule& rule) {
  if (std::find(kCategories.begin(), kCategories.end(), rule.category) == kCategories.end()) {
    refuseParameter(Text::tr("there is no such category of records"), rule.category,
                    Text::tr("Use trainee, rater, left or consent_withdrawn"));
  }
  if (rule.keep_days < 1 || rule.keep_days > kLongest_days) {
    refuseParameter(Text::tr("records are kept for one day at least and a hundred years at most"),
                    Text::tr("%1: %2 {day|days}", rule.category, rule.keep_days),
                    Text::tr("Enter 1 to 36500"));
  }
  connection_.execute(insertInto("retention_rule", "category, keep_days, basis, changed_utc_us") +
                          " ON CONFLICT (category) DO UPDATE SET keep_days = excluded.keep_days, basis ="
                          " excluded.basis, changed_utc_us = excluded.changed_utc_us",
                      {rule.category, rule.keep_days, rule.basis, rule.changedUtc_us});
}

void RetentionRepository::removeRule(const std::string& category) {
  connection_.execute("DELETE FROM retention_rule WHERE category = ?", {category});
}

std::vector<RetentionRule> RetentionRepository::rules() const {
  return selectAll(connection_,
                   "SELECT category, keep_days, basis, changed_utc_us FROM retention_rule ORDER BY category",
                   {}, [](RowReader& row) {
                     return RetentionRule{row.text(), row.int64(), row.text(), row.int64()};
                   });
}

void RetentionRepository::addHold(const RetentionHold& hold) {
  connection_.execute(
      "INSERT INTO retention_hold (person_id, sequence, kind, until_utc_us, reason, decided_by, "
      "decided_utc_us)"
      " VALUES (?, (SELECT COALESCE(MAX(h.sequence), 0) + 1 FROM retention_hold h WHERE h.person_id = ?),"
      " ?, ?, ?, ?, ?)",
      {hold.personId, hold.personId, storedText(hold.kind), hold.untilUtc_us, hold.reason, hold.decidedBy,
       hold.decidedUtc_us});
}

std::vector<RetentionItem> RetentionRepository::due(std::int64_t utc_us) const {
  const std::vector<RetentionRule> all = rules();
  std::vector<RetentionItem> items;
  if (all.empty()) {
    return items;
  }
  for (const Activity& activity : selectAll(connection_, kPeople, {}, activityOf)) {
    std::optional<RetentionItem> item;
    for (const RetentionRule& rule : all) {
      const std::optional<std::int64_t> from_us = since(activity, rule.category);
      if (!from_us) {
        continue;
      }
      const std::int64_t due_us = *from_us + rule.keep_days * kDay_us;
      if (due_us > utc_us || (item && item->dueUtc_us <= due_us)) {
        continue;
      }
      item = {.personId = activity.personId,
              .code = activity.code,
              .category = rule.category,
              .basis = rule.basis,
              .sinceUtc_us = *from_us,
              .dueUtc_us = due_us};
    }
    if (item) {
      items.push_back(std::move(*item));
    }
  }
  const std::map<std::string, RetentionHold> decided = newestHolds(connection_);
  for (RetentionItem& item : items) {
    const auto newest = decided.find(item.personId);
    if (newest == decided.end()) {
      continue;
    }
    item.hold = newest->second;
    item.held = holdsAt(newest->second, utc_us);
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const RetentionItem& a, const RetentionItem& b) { return a.dueUtc_us < b.dueUtc_us; });
  return items;
}

void RequestRepository::add(const PersonRequest& request) {
  connection_.execute(insertInto("person_request", "id, person_id, kind, asked_utc_us"),
                      {request.id, request.personId, storedText(request.kind), request.askedUtc_us});
}

void RequestRepository::answer(const std::string& requestId, PersonRequestAnswer answer,
                               const std::string& reason, std::int64_t utc_us) {
  const std::int64_t changed = connection_.execute(
      "UPDATE person_request SET answer = ?, answer_reason = ?, answered_utc_us = ?"
      " WHERE id = ? AND answer IS NULL",
      {storedText(answer), textOrNull(reason), utc_us, requestId});
  if (changed != 1) {
    refuse(Text::tr("this request was answered already"), requestId, Text::tr("Read the list again"));
  }
}

std::vector<PersonRequest> RequestRepository::all() const {
  return selectAll(
      connection_,
      "SELECT r.id, r.person_id, r.kind, r.asked_utc_us, r.answer, r.answer_reason,"
      " r.answered_utc_us, p.code FROM person_request r JOIN person p ON p.id = r.person_id"
      " ORDER BY r.asked_utc_us DESC, r.id",
      {}, [](RowReader& row) {
        PersonRequest request{row.text(), row.text(), readTerm<PersonRequestKind>(row), row.int64()};
        request.answer = readMaybeTerm<PersonRequestAnswer>(row);
        request.reason = row.text();
        request.answeredUtc_us = row.maybeInt64().value_or(0);
        request.personCode = row.text();
        return request;
      });
}

}  // namespace torsio
