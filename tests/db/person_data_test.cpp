// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/person_data.h"

#include <algorithm>
#include <set>

#include "assessment/domain/people/account.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

/// Contained in every free text about the person, so that a search finds whatever an erase missed.
const std::string kMarker = "Wilhelmina";

class PersonDataTest : public DatabaseTest {
 protected:
  static std::vector<std::string> tables(Connection& connection) {
    std::vector<std::string> names;
    Statement row = connection.prepare(
        onPostgresql()
            ? "SELECT tablename FROM pg_tables WHERE schemaname = current_schema() ORDER BY tablename"
            : "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%'"
              " ORDER BY name");
    row.execute();
    while (row.step()) {
      names.push_back(row.text(0));
    }
    return names;
  }

  /// Tables with the marker in a text column.
  static std::vector<std::string> tablesWithMarker(Connection& connection) {
    std::vector<std::string> found;
    for (const std::string& table : tables(connection)) {
      Statement row = connection.prepare("SELECT * FROM " + table);
      row.execute();
      bool here = false;
      while (row.step()) {
        for (int column = 0; column < row.columnCount(); ++column) {
          const Value value = row.value(column);
          const auto* text = std::get_if<std::string>(&value.storage());
          here = here || (text != nullptr && text->find(kMarker) != std::string::npos);
        }
      }
      if (here) {
        found.push_back(table);
      }
    }
    return found;
  }

  /// Two trainees with a name, a user, consent, a recording, a mark with comment, a draft, a deviation.
  struct Full {
    explicit Full(Connection& connection) : sample(connection, 2) {
      for (std::size_t i = 0; i < 2; ++i) {
        fill(connection, i);
      }
    }
    void fill(Connection& connection, std::size_t i) {
      const std::string person = sample.trainees[i].person.id;
      const std::string text = i == 0 ? kMarker : "somebody else";
      PeopleRepository people(connection);
      people.setIdentity({person, text, text + "@example.org", text});
      people.recordConsent({person, "video", true, "1", kSampleTime_us, "admin", true});
      AccessRepository(connection, PasswordCost::kTest)
          .addUser({.id = sample.ids.newUuid(), .login = text, .personId = person, .roles = {"trainee"}},
                   "a long enough sentence");
      Trial trial;
      trial.header = sampleHeader(sample.ids.newUuid(), sample.trainees[i].person.code);
      trial.chunks = {sampleChunk(0, 200)};
      trial.chunks[0].digest = chunkDigest(trial.chunks[0]);
      trial.summary = {1000, 0, 0, TrialOutcome::kCompleted, contentHash(trial)};
      TrialRepository trials(connection, {"s", sample.enrolments[i].id});
      trials.import(trial);
      trialIds.push_back(trial.header.trialId);
      SubmittedMark mark;
      mark.id = sample.ids.newUuid();
      mark.enrolmentId = sample.enrolments[i].id;
      mark.raterId = sample.chiefs[0].person.id;
      mark.occasionCode = "pre";
      mark.score_steps = 73;
      mark.comment = text + " did well";
      mark.submittedUtc_us = kSampleTime_us;
      RatingRepository(connection).submit(std::span(&mark, 1));
      StudyRepository(connection)
          .addDeviation({sample.ids.newUuid(), sample.cohort.id, sample.enrolments[i].id, "late",
                         text + " missed the tram", kSampleTime_us, "admin", kSampleTime_us, true});
      addDraft(connection, i, text);
    }
    void addDraft(Connection& connection, std::size_t i, const std::string& text) {
      SheetRepository sheets(connection);
      if (i == 0) {
        RubricRepository rubrics(connection);
        rubrics.addRubric("rubric", "Twist", kSampleTime_us, true);
        RubricRevision revision{.id = "revision", .rubricId = "rubric"};
        revision.overall = {10, 100, 10};
        revision.rows = {{"time", "time", {10, 100, 10}, {}}};
        rubrics.addRevision(revision);
      }
      Assignment assignment{.id = sample.ids.newUuid()};
      assignment.raterId = sample.chiefs[1].person.id;
      assignment.enrolmentId = sample.enrolments[i].id;
      assignment.occasionCode = "mid";
      assignment.rubricRevisionId = "revision";
      assignment.caseLabel = std::to_string(i);
      sheets.assign(std::span(&assignment, 1));
      sheets.saveDraft(assignment.id, {.comment = text, .rows = {{"time", 50, ""}}});
    }
    SampleRecord sample;
    std::vector<TrialId> trialIds;
  };

  static void erase(Connection& connection, const Full& full) {
    erasePerson(connection, full.sample.trainees[0].person.id, "admin", "on request", kSampleTime_us + 9);
  }
};

TEST_F(PersonDataTest, EveryTableHasExactlyOneRule) {
  Connection connection = openWithSchema();
  std::multiset<std::string> ruled;
  for (const PersonRule& rule : kPersonRules) {
    ruled.insert(std::string(rule.table));
  }

  const std::vector<std::string> names = tables(connection);

  for (const std::string& table : names) {
    EXPECT_EQ(ruled.count(table), 1U) << table;
  }
  EXPECT_EQ(ruled.size(), names.size());
}

TEST_F(PersonDataTest, EveryTableThatRefersToAPersonIsExported) {
  Connection connection = openWithSchema();
  const std::set<std::string> pointing{"person_id",    "trainee_id",       "rater_id",
                                       "enrolment_id", "author_person_id", "reader_person_id"};
  for (const PersonRule& rule : kPersonRules) {
    Statement row = connection.prepare("SELECT * FROM " + std::string(rule.table));
    row.execute();
    for (int column = 0; column < row.columnCount(); ++column) {
      EXPECT_FALSE(rule.condition.empty() && pointing.contains(row.columnName(column))) << rule.table;
    }
  }
}

TEST_F(PersonDataTest, ExportsEverythingAboutOnePersonOnly) {
  Connection connection = openWithSchema();
  const Full full(connection);

  const std::vector<PersonTable> data = exportPerson(connection, full.sample.trainees[0].person.id);

  std::set<std::string> names;
  for (const PersonTable& table : data) {
    names.insert(table.table);
    for (const std::vector<Value>& row : table.rows) {
      ASSERT_EQ(row.size(), table.columns.size());
      for (const Value& value : row) {
        const auto* text = std::get_if<std::string>(&value.storage());
        if (text == nullptr) {
          continue;
        }
        EXPECT_EQ(text->find("somebody else"), std::string::npos) << table.table;
        EXPECT_EQ(text->find("$argon2"), std::string::npos) << table.table;
      }
    }
  }
  for (const char* table : {"person", "person_identity", "trainee", "consent", "enrolment", "trial",
                            "trial_chunk", "trial_end", "training_mark", "deviation", "app_user", "user_role",
                            "mark_draft", "mark_draft_row", "assignment"}) {
    EXPECT_TRUE(names.contains(table)) << table;
  }
}

TEST_F(PersonDataTest, ErasingRemovesTheNameFromEveryTable) {
  Connection connection = openWithSchema();
  const Full full(connection);
  ASSERT_GE(tablesWithMarker(connection).size(), 5U);

  erase(connection, full);

  EXPECT_TRUE(tablesWithMarker(connection).empty()) << tablesWithMarker(connection).at(0);
  const Trainee left = PeopleRepository(connection).findTrainee("T-01").value();
  EXPECT_EQ(left.person.state, PersonState::kErased);
  EXPECT_EQ(left.person.sex, "");
  EXPECT_FALSE(left.person.age_years.has_value());
  EXPECT_TRUE(TrialRepository(connection).load(full.trialIds[0]).chunks.empty());
}

TEST_F(PersonDataTest, ErasingKeepsMarksAndEverybodyElse) {
  Connection connection = openWithSchema();
  const Full full(connection);

  erase(connection, full);

  const std::vector<SubmittedMark> marks = RatingRepository(connection).marks(full.sample.cohort.id);
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0].score_steps, 73);
  EXPECT_EQ(marks[0].comment, "");
  EXPECT_EQ(marks[1].comment, "somebody else did well");
  EXPECT_EQ(TrialRepository(connection).load(full.trialIds[1]).chunks.size(), 1U);
  EXPECT_EQ(PeopleRepository(connection).identity(full.sample.trainees[1].person.id)->fullName,
            "somebody else");
}

TEST_F(PersonDataTest, ErasingIsRecordedInTheAuditTrailWhichStillVerifies) {
  Connection connection = openWithSchema();
  const Full full(connection);

  erase(connection, full);

  AuditRepository audit(connection);
  const std::vector<AuditFinding> findings = verifyAuditTrail(connection);
  EXPECT_TRUE(findings.empty()) << findings.at(0).objectKind << ": " << findings.at(0).what;
  EXPECT_EQ(audit.entries().at(0).action, "person.erase");
  EXPECT_EQ(numberFrom(connection, "SELECT count(*) FROM erasure_gate"), 0);
  EXPECT_EQ(faultFrom([&] { connection.execute("DELETE FROM trial_chunk"); }), DbFault::kAppendOnly);
}

TEST_F(PersonDataTest, RefusesToEraseTwice) {
  Connection connection = openWithSchema();
  const Full full(connection);
  erase(connection, full);
  EXPECT_EQ(refusalFrom([&] { erase(connection, full); }).code, ErrorCode::kBadData);
  EXPECT_EQ(refusalFrom([&] { erasePerson(connection, "none", "admin", "", 0); }).code, ErrorCode::kBadData);
}

}  // namespace
}  // namespace torsio
