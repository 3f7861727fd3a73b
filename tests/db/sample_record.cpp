// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/db/sample_record.h"

#include <map>
#include <ostream>
#include <set>
#include <span>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/demonstration_data.h"
#include "db/repository/system/schema_tables.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/random.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"

namespace torsio {

namespace {

/// Formats "T-07"; up to three digits.
std::string numbered(std::string prefix, int number) {
  if (number < 10) {
    prefix += "0";
  }
  prefix += std::to_string(number);
  return prefix;
}

}  // namespace

SampleRecord::SampleRecord(Connection& connection, int traineeCount) {
  PeopleRepository people(connection);
  people.addRaterClasses(std::vector<SeniorityClass>{{"intern", "interns", 1},
                                                     {"deputy_chief", "deputy chief physicians", 2},
                                                     {"chief", "chief physicians", 3}});
  for (int i = 1; i <= traineeCount; ++i) {
    Trainee trainee;
    trainee.person = {.id = ids.newUuid(),
                      .code = numbered("T-", i),
                      .sex = i % 2 == 0 ? "male" : "female",
                      .level = "graduate",
                      .experience = "",
                      .age_years = 24,
                      .state = PersonState::kActive,
                      .createdUtc_us = kSampleTime_us,
                      .demonstration = true};
    trainee.handedness = "right";
    trainees.push_back(trainee);
  }
  for (int i = 1; i <= 2; ++i) {
    Rater chief;
    chief.person.id = ids.newUuid();
    chief.person.code = numbered("C-", i);
    chief.person.createdUtc_us = kSampleTime_us;
    chief.person.demonstration = true;
    chief.classCode = "chief";
    chiefs.push_back(chief);
  }
  people.addTrainees(trainees);
  people.addRaters(chiefs);

  cohort = {ids.newUuid(), "Autumn", "two arms", kSampleTime_us, true};
  groups = {{ids.newUuid(), cohort.id, 1, "G1", "40 min virtual"},
            {ids.newUuid(), cohort.id, 2, "G2", "20 min virtual, 20 min real"}};
  StudyRepository study(connection);
  study.addCohort(cohort, groups);
  for (const Trainee& trainee : trainees) {
    Enrolment enrolment;
    enrolment.id = ids.newUuid();
    enrolment.cohortId = cohort.id;
    enrolment.traineeId = trainee.person.id;
    enrolment.enrolledUtc_us = kSampleTime_us;
    enrolment.demonstration = true;
    enrolments.push_back(enrolment);
  }
  study.enrol(enrolments);
}

TrialHeader sampleHeader(const TrialId& trialId, const std::string& traineeCode) {
  TrialHeader header;
  header.trialId = trialId;
  header.traineeCode = traineeCode;
  header.sceneId = "forearm";
  header.patternId = "pronation";
  header.organHash = "0a1b";
  header.parameterHash = "2c3d";
  header.parametersJson = R"({"ridges":36})";
  header.deviceModel = "Phantom Omni";
  header.deviceLimits = {3.0, 0.8, 400.0, {-0.1, -0.2, -0.3}, {0.1, 0.2, 1.0 / 3.0}};
  header.softwareVersion = "0.1.0";
  header.phaseLabel = "virtual 0-20 min";
  header.drive = TwistDrive::kRoll;
  header.targetAngle_rad = 1.0 / 3.0;
  header.forceScale = 0.7;
  header.tickPeriod_us = 1001;
  header.startedUtc_us = kSampleTime_us;
  header.demonstration = true;
  return header;
}

TrialChunk sampleChunk(std::int64_t index, std::size_t size) {
  TrialChunk chunk;
  chunk.index = index;
  chunk.firstTick = 1000 * index;
  chunk.samples = 1000;
  chunk.digest = std::string("d").append(std::to_string(index));
  chunk.outputDigest = std::string("o").append(std::to_string(index));
  Random random = Random::forStream(7, static_cast<std::uint64_t>(index));
  for (std::size_t i = 0; i < size; ++i) {
    chunk.bytes.push_back(static_cast<std::byte>(random.bounded(256)));
  }
  return chunk;
}

Trial sampleTrial() {
  Trial trial;
  trial.header = sampleHeader("11111111-1111-4111-8111-111111111111", "T-01");
  TrialChunk chunk = sampleChunk(0, 300);
  chunk.digest = chunkDigest(chunk);
  trial.chunks.push_back(chunk);
  trial.summary.samples = chunk.samples;
  trial.summary.contentHash = contentHash(trial);
  return trial;
}

namespace {

/// Columns with rules that generated values would violate; "table.column" before "column".
const std::map<std::string, Value> kRuled{{"kind", "virtual"},
                                          {"state", "active"},
                                          {"retention_hold.kind", "lock"},
                                          {"record_copy.kind", "backup"},
                                          {"curriculum_state.state", "running"},
                                          {"person_request.kind", "export"},
                                          {"roster_import.kind", "trainees"},
                                          {"invitation.expires_utc_us", std::int64_t{2}},
                                          {"invitation.state", "revoked"},
                                          {"learning_event.kind", "rested"},
                                          {"learning_event.state", "delivered"},
                                          {"person_request.answer", "declined"},
                                          {"consent.form", "screen"},
                                          {"consent.signed_utc_us", Value()},
                                          {"cohort_state.state", "running"},
                                          {"study_statement.item", "registration"},
                                          {"trial_remark.purpose", "remark"},
                                          {"reply_to", Value()},
                                          {"remark_revision.version", std::int64_t{2}},
                                          {"until_utc_us", Value()},
                                          {"server_session.until_utc_us", std::int64_t{1}},
                                          {"decision", "keep"},
                                          {"duty_request.act", "erase"},
                                          {"duty_decision.decision", "confirmed"},
                                          {"signature.object_kind", "training_mark"},
                                          {"signature.meaning", "scored"},
                                          {"comparison", "at_most"},
                                          {"device_light", "amber"},
                                          {"assessment_run.campaign_id", Value()},
                                          {"not_assessable_reason", Value()},
                                          {"amend_reason", Value()}};

/// Tables that stay empty or are filled by migrations.
const std::set<std::string> kLeftAlone{"password_pepper", "erasure_gate",   "audit_entry", "row_seal",
                                       "seal_salt",       "role",           "operation",   "role_operation",
                                       "occasion",        "consent_purpose"};

std::map<std::string, std::string> typesOf(Connection& connection, const std::string& table) {
  std::map<std::string, std::string> types;
  Statement row = connection.prepare(
      connection.engine() == Engine::kSqlite
          ? "SELECT name, lower(type) FROM pragma_table_info(?)"
          : "SELECT a.attname, format_type(a.atttypid, -1) FROM pg_attribute a"
            " JOIN pg_class t ON t.oid = a.attrelid JOIN pg_namespace n ON n.oid = t.relnamespace"
            " WHERE n.nspname = current_schema() AND t.relname = ? AND a.attnum > 0");
  row.execute({table});
  while (row.step()) {
    types[row.text(0)] = row.text(1);
  }
  return types;
}

Value madeUp(const std::string& type, const std::string& text, bool demonstration) {
  if (type == "bigint") {
    return 1;
  }
  if (type == "double precision") {
    return 0.1;
  }
  if (type == "boolean") {
    return demonstration;
  }
  if (type == "blob" || type == "bytea") {
    return Blob{std::byte{7}, std::byte{0}, std::byte{255}};
  }
  return text;
}

class Filler {
 public:
  Filler(Connection& connection, std::string prefix, bool demonstration)
      : connection_(connection), prefix_(std::move(prefix)), demonstration_(demonstration) {
    for (const DemonstrationRows& rows : demonstrationRows(connection)) {
      conditions_[rows.table] = rows.condition;
    }
  }

  void fill(const SchemaTable& table) {
    if (kLeftAlone.contains(table.name) || hasOne(table.name)) {
      return;
    }
    const std::map<std::string, std::string> types = typesOf(connection_, table.name);
    std::map<std::string, Value> values;
    for (const TableColumn& column : table.columns) {
      std::string text = prefix_;
      text.append(" ").append(column.name);
      values[column.name] = madeUp(types.at(column.name), text, demonstration_);
    }
    if (table.name == "sign_in_failure") {
      values["bucket"] = static_cast<std::int64_t>(prefix_.front());  // the key is a single number
    }
    if (table.name == "consent_version") {
      values["number"] = static_cast<std::int64_t>(prefix_.front());  // unique apart from the key
    }
    for (const TableReference& reference : table.references) {
      refer(reference, values);
    }
    std::vector<Value> row;
    std::string marks;
    for (const TableColumn& column : table.columns) {
      const auto exact = kRuled.find(std::string(table.name).append(".").append(column.name));
      const auto general = kRuled.find(column.name);
      row.push_back(exact != kRuled.end()     ? exact->second
                    : general != kRuled.end() ? general->second
                                              : values[column.name]);
      marks += marks.empty() ? "?" : ", ?";
    }
    connection_.prepare("INSERT INTO " + table.name + " (" + table.columnList() + ") VALUES (" + marks + ")")
        .execute(row);
  }

 private:
  /// " WHERE ..." for rows of the current kind.
  [[nodiscard]] std::string ofKind(const std::string& table) const {
    const std::string& condition = conditions_.at(table);
    if (condition == "FALSE") {
      return "";
    }
    return demonstration_ ? " WHERE " + condition : " WHERE NOT (" + condition + ")";
  }

  bool hasOne(const std::string& table) {
    if (conditions_.at(table) == "FALSE") {
      Statement any = connection_.prepare("SELECT count(*) FROM " + table);
      any.execute();
      return any.step() && any.int64(0) > (demonstration_ ? 1 : 0);
    }
    Statement row = connection_.prepare("SELECT count(*) FROM " + table + ofKind(table));
    row.execute();
    return row.step() && row.int64(0) > 0;
  }

  void refer(const TableReference& reference, std::map<std::string, Value>& values) {
    std::string columns;
    for (const std::string& column : reference.parentColumns) {
      columns += (columns.empty() ? "" : ", ") + column;
    }
    Statement parent = connection_.prepare("SELECT " + columns + " FROM " + reference.parent +
                                           ofKind(reference.parent) + " ORDER BY " + columns + " LIMIT 1");
    parent.execute();
    while (parent.step()) {
      for (std::size_t i = 0; i < reference.columns.size(); ++i) {
        values[reference.columns[i]] = parent.value(static_cast<int>(i));
      }
    }
  }

  Connection& connection_;
  std::string prefix_;
  bool demonstration_;
  std::map<std::string, std::string> conditions_;
};

void addPeople(Connection& connection, const FullRecord& record, const std::string& prefix,
               bool demonstration) {
  PeopleRepository people(connection);
  people.addRaterClasses(std::vector<SeniorityClass>{{prefix + " chief", "chiefs", 1}});
  Trainee trainee;
  trainee.person = {.id = record.traineeId,
                    .code = prefix + "-T",
                    .sex = "female",
                    .createdUtc_us = kSampleTime_us,
                    .demonstration = demonstration};
  people.addTrainees(std::span(&trainee, 1));
  Rater rater;
  rater.person = {.id = record.raterId,
                  .code = prefix + "-R",
                  .createdUtc_us = kSampleTime_us,
                  .demonstration = demonstration};
  rater.classCode = prefix + " chief";
  people.addRaters(std::span(&rater, 1));
}

void addCurriculum(Connection& connection, const std::string& prefix, bool demonstration) {
  CurriculumRepository curricula(connection);
  curricula.addCurriculum({prefix + " curriculum", prefix + " twists", "", kSampleTime_us, demonstration});
  CurriculumVersion version;
  version.id = prefix + " version";
  version.curriculumId = prefix + " curriculum";
  for (const char* code : {"M1", "M2"}) {
    TrainingModule module;
    module.id = prefix + " " + code;
    module.code = code;
    version.modules.push_back(module);
  }
  version.modules[1].requires_ = {version.modules[0].id};
  version.modules[1].mastery = {{"time", "at_most", 20.0, "s", 3}};
  StudyArm arm;
  arm.id = prefix + " arm";
  arm.code = "A";
  arm.phases = {{prefix + " phase", PhaseKind::kVirtual, "first", 60, version.modules[0].id}};
  version.arms = {arm};
  version.plannedOccasions = {{"pre", 0}};
  curricula.addVersion(version, "admin");
  CompetenceRepository(connection)
      .add({.moduleId = version.modules[1].id,
            .registeredUtc_us = kSampleTime_us,
            .reason = "as the board decided"});
}

void addTrialAndMark(Connection& connection, const FullRecord& record, const std::string& prefix,
                     bool demonstration) {
  StudyRepository study(connection);
  study.addCohort({.id = prefix + " cohort",
                   .name = prefix + " autumn",
                   .createdUtc_us = kSampleTime_us,
                   .demonstration = demonstration,
                   .equivalenceMargin = 0.5},
                  std::vector<StudyGroup>{{prefix + " group", prefix + " cohort", 1, "G1", "virtual"}});
  study.enrol(std::vector<Enrolment>{{.id = prefix + " enrolment",
                                      .cohortId = prefix + " cohort",
                                      .traineeId = record.traineeId,
                                      .demonstration = demonstration}});
  Trial trial;
  trial.header = sampleHeader(record.trialId, prefix + "-T");
  trial.header.demonstration = demonstration;
  for (std::int64_t i = 0; i < 2; ++i) {
    trial.chunks.push_back(sampleChunk(i, 300));
    trial.chunks.back().digest = chunkDigest(trial.chunks.back());
  }
  trial.summary = {2000, 0, 1, TrialOutcome::kCompleted, contentHash(trial)};
  TrialRepository(connection, {.station = "room", .enrolmentId = prefix + " enrolment"}).import(trial);

  SheetRepository sheets(connection);
  RubricRepository rubrics(connection);
  rubrics.addRubric(prefix + " rubric", prefix + " sheet", kSampleTime_us, demonstration);
  RubricRevision revision{.id = prefix + " revision", .rubricId = prefix + " rubric"};
  revision.overall = {10, 100, 10};
  revision.rows = {{"time", "time", {10, 100, 10}, {{10, "slow"}}}};
  rubrics.addRevision(revision);
  for (const char* point : {"pre", "mid"}) {
    Assignment assignment{.id = prefix + " " + point};
    assignment.raterId = record.raterId;
    assignment.enrolmentId = prefix + " enrolment";
    assignment.occasionCode = point;
    assignment.trialId = record.trialId;
    assignment.rubricRevisionId = prefix + " revision";
    assignment.caseLabel = point;
    assignment.demonstration = demonstration;
    sheets.assign(std::span(&assignment, 1));
  }
  const LiveCall call{.id = prefix + " call",
                      .enrolmentId = prefix + " enrolment",
                      .occasionCode = "post",
                      .room = prefix + " room",
                      .calledBy = prefix + " user",
                      .calledUtc_us = kSampleTime_us};
  CallRepository(connection).add(std::span(&call, 1));
  const Sheet sheet{.overall_steps = 73, .comment = prefix + " steady", .rows = {{"time", 60, ""}}};
  sheets.saveDraft(prefix + " mid", sheet);
  sheets.submit(prefix + " pre", prefix + " mark", sheet, "", kSampleTime_us);
}

void addEvaluation(Connection& connection, const FullRecord& record, const std::string& prefix,
                   bool demonstration) {
  Campaign campaign;
  campaign.id = prefix + " campaign";
  campaign.name = prefix + " evaluation";
  campaign.instrument = paperInstrument();
  campaign.instrument.classes = {{prefix + " chief", "chiefs", 1000}};
  campaign.models = {{"PM", "proposed model", "Y", 1}};
  campaign.raters = {{record.raterId, prefix + " chief", "PM"}};
  campaign.demonstration = demonstration;
  EvaluationRepository evaluations(connection);
  evaluations.addCampaign(campaign);
  EvaluationMark mark;
  mark.id = prefix + " evaluation mark";
  mark.raterId = record.raterId;
  mark.modelCode = "PM";
  mark.indexNumber = 1;
  mark.score_steps = 80;
  mark.demonstration = demonstration;
  evaluations.submit(campaign.id, std::span(&mark, 1));
}

}  // namespace

void PrintTo(const TableDigest& digest, std::ostream* out) {
  *out << digest.table << ": " << digest.rows << " rows, " << digest.hash.substr(0, 8);
}

FullRecord::FullRecord(Connection& connection, const std::string& prefix, bool demonstration)
    : traineeId(prefix + " trainee"), raterId(prefix + " rater"), trialId(prefix + " trial") {
  Transaction transaction(connection);
  addPeople(connection, *this, prefix, demonstration);
  addCurriculum(connection, prefix, demonstration);
  addTrialAndMark(connection, *this, prefix, demonstration);
  addEvaluation(connection, *this, prefix, demonstration);
  Filler filler(connection, prefix, demonstration);
  for (const SchemaTable& table : tablesInReferenceOrder(connection)) {
    filler.fill(table);
  }
  // The generated tombstone needs its entry.
  AuditRepository(connection)
      .append({.atUtc_us = kSampleTime_us,
               .actor = prefix + " user",
               .station = "office",
               .action = AuditAction::kPersonErase,
               .objectKind = AuditObject::kPerson,
               .objectId = raterId});
  transaction.commit();
}

namespace {

constexpr int kTraineesPerCohort = 50;
constexpr std::int64_t kVersions = 5;

std::vector<SubmittedMark> marksFor(SampleRecord& sample, const std::vector<Enrolment>& enrolments) {
  std::vector<SubmittedMark> marks;
  for (const Enrolment& enrolment : enrolments) {
    for (const Rater& chief : sample.chiefs) {
      for (std::int64_t version = 1; version <= kVersions; ++version) {
        SubmittedMark mark;
        mark.id = sample.ids.newUuid();
        mark.enrolmentId = enrolment.id;
        mark.raterId = chief.person.id;
        mark.occasionCode = "pre";
        mark.version = version;
        mark.amendReason = version == 1 ? "" : "again";
        mark.score_steps = 50;
        marks.push_back(mark);
      }
    }
  }
  return marks;
}

}  // namespace

std::string fillLargeRecord(Connection& connection, SampleRecord& sample) {
  StudyRepository study(connection);
  CohortId cohortId;
  for (int first = 0; first < kManyTrainees; first += kTraineesPerCohort) {
    Transaction transaction(connection);
    cohortId = sample.ids.newUuid();
    study.addCohort({cohortId, "cohort " + std::to_string(first), "", kSampleTime_us, true}, {});
    std::vector<Trainee> trainees;
    std::vector<Enrolment> enrolments;
    for (int i = 0; i < kTraineesPerCohort; ++i) {
      Trainee trainee;
      trainee.person.id = sample.ids.newUuid();
      trainee.person.code = "S-" + std::to_string(first + i);
      trainees.push_back(trainee);
      enrolments.push_back(
          {.id = sample.ids.newUuid(), .cohortId = cohortId, .traineeId = trainee.person.id});
    }
    PeopleRepository(connection).addTrainees(trainees);
    study.enrol(enrolments);
    RatingRepository(connection).submit(marksFor(sample, enrolments));
    transaction.commit();
  }
  return cohortId;
}

}  // namespace torsio
