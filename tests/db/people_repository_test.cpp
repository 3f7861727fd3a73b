// SPDX-License-Identifier: GPL-3.0-or-later

#include "db/repository/people/people_repository.h"

#include <regex>
#include <set>

#include "assessment/domain/people/account.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/consent.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/people/retention.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/person_data.h"
#include "db/repository/people/retention_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {

namespace {

class PeopleRepositoryTest : public SampleTest {
 protected:
  PeopleRepository people() { return PeopleRepository(connection()); }
};

TEST_F(PeopleRepositoryTest, ReturnsTraineesAsStored) {
  const SampleRecord sample(connection(), 3);

  const std::vector<Trainee> trainees = people().trainees();

  ASSERT_EQ(trainees.size(), 3U);
  const Person& person = trainees[1].person;
  EXPECT_EQ(person.id, sample.trainees[1].person.id);
  EXPECT_EQ(person.code, "T-02");
  EXPECT_EQ(person.sex, "male");
  EXPECT_EQ(person.level, "graduate");
  EXPECT_EQ(person.experience, "");
  EXPECT_EQ(person.age_years, 24);
  EXPECT_EQ(person.state, PersonState::kActive);
  EXPECT_EQ(person.createdUtc_us, kSampleTime_us);
  EXPECT_TRUE(person.demonstration);
  EXPECT_EQ(trainees[1].handedness, "right");
}

TEST_F(PeopleRepositoryTest, KeepsRatersOrderedByClass) {
  people().makeRater(sample().trainees[0].person.id, "intern");  // interns use the simulator and rate it

  const std::vector<Rater> raters = people().raters();
  ASSERT_EQ(raters.size(), 3U);
  EXPECT_EQ(raters[0].person.code, "T-01");
  EXPECT_EQ(raters[0].classCode, "intern");
  EXPECT_EQ(raters[2].person.code, "C-02");
  EXPECT_EQ(people().findRater("C-01")->classCode, "chief");
  EXPECT_FALSE(people().findRater("C-09").has_value());
  EXPECT_EQ(people().raterClasses().size(), 3U);
}

TEST_F(PeopleRepositoryTest, StoresNobodyOfARosterWithADuplicateCode) {
  std::vector<Trainee> roster(2);
  roster[0].person = {.id = sample().ids.newUuid(), .code = "T-50"};
  roster[1].person = {.id = sample().ids.newUuid(), .code = "T-01"};

  EXPECT_EQ(faultFrom([&] { people().addTrainees(roster); }), DbFault::kUnique);

  EXPECT_EQ(people().trainees().size(), 1U);
}

TEST_F(PeopleRepositoryTest, RefusesUnknownClassesAndSexes) {
  EXPECT_EQ(faultFrom([&] { people().makeRater(sample().trainees[0].person.id, "wizard"); }),
            DbFault::kForeignKey);
  std::vector<Trainee> odd(1);
  odd[0].person = {.id = sample().ids.newUuid(), .code = "T-60", .sex = "yes"};
  EXPECT_EQ(faultFrom([&] { people().addTrainees(odd); }), DbFault::kCheck);
}

TEST_F(PeopleRepositoryTest, KeepsNamesApartFromTheCodedRecord) {
  const SampleRecord sample(connection(), 2);
  const std::string id = sample.trainees[0].person.id;

  people().setIdentity({id, "Änne Müller", "", "S-123"});

  EXPECT_EQ(people().identity(id)->fullName, "Änne Müller");
  EXPECT_EQ(people().identity(id)->externalId, "S-123");
  EXPECT_FALSE(people().identity(sample.trainees[1].person.id).has_value());
  EXPECT_EQ(faultFrom([&] {
              people().setIdentity({sample.trainees[1].person.id, "Somebody", "", "S-123"});
            }),
            DbFault::kUnique);
}

TEST_F(PeopleRepositoryTest, NeverChangesAPseudonym) {
  const SampleRecord sample(connection(), 1);

  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE person SET code = ?", {"T-99"}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE person SET demonstration = ?", {false}); }),
            DbFault::kAppendOnly);
  EXPECT_EQ(connection().execute("UPDATE person SET state = ? WHERE code = ?", {"left", "T-01"}), 1);
}

TEST_F(PeopleRepositoryTest, TheNewestConsentCounts) {
  const std::string id = sample().trainees[0].person.id;
  EXPECT_FALSE(people().hasConsent(id, "video"));

  people().recordConsent({id, "video", true, "2", kSampleTime_us, "admin", true});
  EXPECT_TRUE(people().hasConsent(id, "video"));
  EXPECT_FALSE(people().hasConsent(id, "research"));
  people().recordConsent({id, "video", false, "2", kSampleTime_us + 1, "admin", true});

  EXPECT_FALSE(people().hasConsent(id, "video"));
  const std::vector<ConsentDecision> decisions = people().consents(id);
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_TRUE(decisions[0].granted);
  EXPECT_EQ(decisions[1].textVersion, "2");
  EXPECT_EQ(faultFrom([&] {
              people().recordConsent({id, "selling", true, "1", 0, "admin", true});
            }),
            DbFault::kForeignKey);
  people().recordConsent(
      {id, "video", true, "3", kSampleTime_us + 2, "admin", true, ConsentForm::kPaper, kSampleTime_us - 7});
  EXPECT_EQ(people().consents(id).back().form, ConsentForm::kPaper);
  EXPECT_EQ(people().consents(id).back().signedUtc_us, kSampleTime_us - 7);
  EXPECT_EQ(people().consents(id).front().signedUtc_us, 0);
  EXPECT_EQ(faultFrom([&] { connection().execute("UPDATE consent SET granted = ?", {true}); }),
            DbFault::kAppendOnly);
}

/// Matches a UUID in lower case.
const std::regex kUuid("[0-9a-f]{8}-([0-9a-f]{4}-){3}[0-9a-f]{12}");

TEST(IdSource, GeneratesVersionFourUuids) {
  SystemIdSource system;
  const std::string id = system.newUuid();
  EXPECT_TRUE(std::regex_match(id, kUuid)) << id;
  EXPECT_EQ(id[14], '4');
  EXPECT_NE(id, system.newUuid());
}

TEST(IdSource, RepeatsTheIdsForASeed) {
  SeededIdSource first(1);
  SeededIdSource again(1);
  SeededIdSource other(2);
  const std::string id = first.newUuid();
  EXPECT_TRUE(std::regex_match(id, kUuid)) << id;
  EXPECT_EQ(id, again.newUuid());
  EXPECT_NE(id, other.newUuid());
}

}  // namespace

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
  std::multiset<std::string> ruled;
  for (const PersonRule& rule : kPersonRules) {
    ruled.insert(std::string(rule.table));
  }

  const std::vector<std::string> names = tables(connection());

  for (const std::string& table : names) {
    EXPECT_EQ(ruled.count(table), 1U) << table;
  }
  EXPECT_EQ(ruled.size(), names.size());
}

TEST_F(PersonDataTest, EveryTableThatRefersToAPersonIsExported) {
  const std::set<std::string> pointing{"person_id",    "trainee_id",       "rater_id",
                                       "enrolment_id", "author_person_id", "reader_person_id"};
  for (const PersonRule& rule : kPersonRules) {
    Statement row = connection().prepare("SELECT * FROM " + std::string(rule.table));
    row.execute();
    for (int column = 0; column < row.columnCount(); ++column) {
      EXPECT_FALSE(rule.condition.empty() && pointing.contains(row.columnName(column))) << rule.table;
    }
  }
}

TEST_F(PersonDataTest, ExportsEverythingAboutOnePersonOnly) {
  const Full full(connection());

  const std::vector<PersonTable> data = exportPerson(connection(), full.sample.trainees[0].person.id);

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
  const Full full(connection());
  ASSERT_GE(tablesWithMarker(connection()).size(), 5U);

  erase(connection(), full);

  EXPECT_TRUE(tablesWithMarker(connection()).empty()) << tablesWithMarker(connection()).at(0);
  const Trainee left = PeopleRepository(connection()).findTrainee("T-01").value();
  EXPECT_EQ(left.person.state, PersonState::kErased);
  EXPECT_EQ(left.person.sex, "");
  EXPECT_FALSE(left.person.age_years.has_value());
  EXPECT_TRUE(TrialRepository(connection()).load(full.trialIds[0]).chunks.empty());
}

TEST_F(PersonDataTest, ErasingKeepsMarksAndEverybodyElse) {
  const Full full(connection());

  erase(connection(), full);

  const std::vector<SubmittedMark> marks = RatingRepository(connection()).marks(full.sample.cohort.id);
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0].score_steps, 73);
  EXPECT_EQ(marks[0].comment, "");
  EXPECT_EQ(marks[1].comment, "somebody else did well");
  EXPECT_EQ(TrialRepository(connection()).load(full.trialIds[1]).chunks.size(), 1U);
  EXPECT_EQ(PeopleRepository(connection()).identity(full.sample.trainees[1].person.id)->fullName,
            "somebody else");
}

TEST_F(PersonDataTest, ErasingIsRecordedInTheAuditTrailWhichStillVerifies) {
  const Full full(connection());

  erase(connection(), full);

  AuditRepository audit(connection());
  const std::vector<AuditFinding> findings = verifyAuditTrail(connection());
  EXPECT_TRUE(findings.empty()) << findings.at(0).objectKind << ": " << findings.at(0).what;
  EXPECT_EQ(audit.entries().at(0).action, "person.erase");
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM erasure_gate"), 0);
  EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM trial_chunk"); }), DbFault::kAppendOnly);
}

TEST_F(PersonDataTest, RefusesToEraseTwice) {
  const Full full(connection());
  erase(connection(), full);
  EXPECT_EQ(refusalFrom([&] { erase(connection(), full); }).code, ErrorCode::kBadData);
  EXPECT_EQ(refusalFrom([&] { erasePerson(connection(), "none", "admin", "", 0); }).code,
            ErrorCode::kBadData);
}

}  // namespace

namespace {

class RetentionRepositoryTest : public DatabaseTest {
 protected:
  RetentionRepository retention() { return RetentionRepository(connection()); }
  /// A real trainee "R-<n>", added on the sample day.
  static PersonId addTrainee(Connection& connection, const std::string& code,
                             PersonState state = PersonState::kActive) {
    Trainee trainee;
    trainee.person = {.id = "id of " + code, .code = code, .state = state, .createdUtc_us = kSampleTime_us};
    PeopleRepository(connection).addTrainees(std::span(&trainee, 1));
    return trainee.person.id;
  }
};

TEST_F(RetentionRepositoryTest, NobodyIsDueWithoutARuleOrBeforeTheTime) {
  addTrainee(connection(), "R-1");
  EXPECT_TRUE(retention().due(INT64_MAX / 2).empty());
  retention().setRule({kRetainTrainee, 30, "contract", 1});

  EXPECT_TRUE(retention().due(kSampleTime_us + 30 * kDay_us - 1).empty());
  const std::vector<RetentionItem> due = retention().due(kSampleTime_us + 30 * kDay_us);

  ASSERT_EQ(due.size(), 1U);
  EXPECT_EQ(due[0].code, "R-1");
  EXPECT_EQ(due[0].category, "trainee");
  EXPECT_EQ(due[0].basis, "contract");
  EXPECT_EQ(due[0].sinceUtc_us, kSampleTime_us);
  EXPECT_EQ(due[0].dueUtc_us, kSampleTime_us + 30 * kDay_us);
  EXPECT_FALSE(due[0].held);
}

TEST_F(RetentionRepositoryTest, ThePeriodStartsAtTheLastActivity) {
  retention().setRule({kRetainTrainee, 30, "contract", 1});
  addTrainee(connection(), "R-1");
  addTrainee(connection(), "R-2");
  TrialHeader header = sampleHeader("trial", "R-1");
  header.startedUtc_us = kSampleTime_us + 10 * kDay_us;
  header.demonstration = false;
  TrialRepository(connection()).begin(header);

  EXPECT_EQ(retention().due(kSampleTime_us + 39 * kDay_us).size(), 1U);
  const std::vector<RetentionItem> due = retention().due(kSampleTime_us + 40 * kDay_us);

  ASSERT_EQ(due.size(), 2U);
  EXPECT_EQ(due[0].code, "R-2");  // longest overdue first
  EXPECT_EQ(due[1].sinceUtc_us, kSampleTime_us + 10 * kDay_us);
}

TEST_F(RetentionRepositoryTest, AMarkOfAnyEnrolmentIsAnActivity) {
  SampleRecord sample(connection(), 0);
  retention().setRule({kRetainTrainee, 30, "contract", 1});
  addTrainee(connection(), "R-1");
  addTrainee(connection(), "R-2");
  const Enrolment enrolment{.id = "enrolment",
                            .cohortId = sample.cohort.id,
                            .traineeId = "id of R-1",
                            .enrolledUtc_us = kSampleTime_us};
  StudyRepository(connection()).enrol(std::span(&enrolment, 1));
  std::vector<SubmittedMark> marks;
  for (const auto& [point, day] : {std::pair("pre", 5), std::pair("post", 20), std::pair("mid", 10)}) {
    SubmittedMark mark;
    mark.id = sample.ids.newUuid();
    mark.enrolmentId = enrolment.id;
    mark.raterId = sample.chiefs[0].person.id;
    mark.occasionCode = point;
    mark.score_steps = 40;
    mark.submittedUtc_us = kSampleTime_us + day * kDay_us;
    marks.push_back(mark);
  }
  RatingRepository(connection()).submit(marks);

  const std::vector<RetentionItem> due = retention().due(kSampleTime_us + 50 * kDay_us);

  ASSERT_EQ(due.size(), 2U);
  EXPECT_EQ(due[0].code, "R-2");
  EXPECT_EQ(due[0].sinceUtc_us, kSampleTime_us);
  EXPECT_EQ(due[1].code, "R-1");
  EXPECT_EQ(due[1].sinceUtc_us, kSampleTime_us + 20 * kDay_us);
}

TEST_F(RetentionRepositoryTest, PeopleWhoLeftOrWithdrewAreDueByTheEarliestRule) {
  retention().setRule({kRetainTrainee, 400, "contract", 1});
  retention().setRule({kRetainLeft, 100, "contract", 1});
  retention().setRule({kRetainWithdrawn, 7, "consent", 1});
  addTrainee(connection(), "R-1", PersonState::kLeft);
  const std::string withdrew = addTrainee(connection(), "R-2");
  const std::string again = addTrainee(connection(), "R-3");
  PeopleRepository people(connection());
  people.recordConsent({withdrew, "training_record", false, "1", kSampleTime_us + kDay_us, "admin", false});
  people.recordConsent({again, "training_record", false, "1", kSampleTime_us, "admin", false});
  people.recordConsent({again, "training_record", true, "1", kSampleTime_us + kDay_us, "admin", false});

  const std::vector<RetentionItem> due = retention().due(kSampleTime_us + 100 * kDay_us);

  ASSERT_EQ(due.size(), 2U);
  EXPECT_EQ(due[0].code, "R-2");
  EXPECT_EQ(due[0].category, "consent_withdrawn");
  EXPECT_EQ(due[0].sinceUtc_us, kSampleTime_us + kDay_us);
  EXPECT_EQ(due[1].code, "R-1");
  EXPECT_EQ(due[1].category, "left");
}

TEST_F(RetentionRepositoryTest, AReviewerLocksExtendsAndReleases) {
  retention().setRule({kRetainTrainee, 30, "contract", 1});
  const std::string id = addTrainee(connection(), "R-1");
  const std::int64_t now_us = kSampleTime_us + 50 * kDay_us;
  const auto held = [&](std::int64_t at_us) { return retention().due(at_us).at(0).held; };

  retention().addHold({id, HoldKind::kExtend, now_us + 10 * kDay_us, "thesis", "admin", now_us});
  EXPECT_TRUE(held(now_us));
  EXPECT_FALSE(held(now_us + 10 * kDay_us));
  retention().addHold({id, HoldKind::kLock, {}, "appeal", "admin", now_us});
  EXPECT_TRUE(held(now_us + 1000 * kDay_us));
  EXPECT_EQ(retention().due(now_us).at(0).hold->reason, "appeal");
  retention().addHold({id, HoldKind::kRelease, {}, "appeal decided", "admin", now_us});
  EXPECT_FALSE(held(now_us));

  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM retention_hold"), 3);
  EXPECT_EQ(faultFrom([&] {
              retention().addHold({id, HoldKind::kExtend, {}, "", "admin", 1});
            }),
            DbFault::kCheck);
  EXPECT_EQ(faultFrom([&] {
              retention().addHold({id, HoldKind::kExtend, {}, "", "admin", 1});
            }),
            DbFault::kCheck);
  EXPECT_EQ(faultFrom([&] {
              retention().addHold({"none", HoldKind::kLock, {}, "", "admin", 1});
            }),
            DbFault::kForeignKey);
  EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM retention_hold"); }), DbFault::kAppendOnly);
}

TEST_F(RetentionRepositoryTest, SimulatedAndErasedPeopleAreNeverDue) {
  const SampleRecord simulated(connection(), 1);
  retention().setRule({kRetainTrainee, 1, "contract", 1});
  retention().setRule({kRetainRater, 1, "contract", 1});
  erasePerson(connection(), addTrainee(connection(), "R-1"), "admin", "asked", kSampleTime_us);

  EXPECT_TRUE(retention().due(kSampleTime_us + 1000 * kDay_us).empty());
}

TEST_F(RetentionRepositoryTest, RulesAreReplacedAndValidated) {
  retention().setRule({kRetainLeft, 30, "contract", 1});
  retention().setRule({kRetainLeft, 60, "law", 2});
  ASSERT_EQ(retention().rules().size(), 1U);
  EXPECT_EQ(retention().rules()[0].keep_days, 60);
  for (const RetentionRule& bad :
       {RetentionRule{"everything", 30, "", 1}, RetentionRule{kRetainLeft, 0, "", 1},
        RetentionRule{kRetainLeft, 40'000, "", 1}}) {
    EXPECT_EQ(refusalFrom([&] { retention().setRule(bad); }).code, ErrorCode::kBadParameter);
  }
  retention().removeRule(kRetainLeft);
  EXPECT_TRUE(retention().rules().empty());
}

}  // namespace

}  // namespace torsio
