// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/study_repository.h"

#include "assessment/domain/ids.h"
#include "db/repository/base/field_digest.h"
#include "db/repository/base/learning_events.h"
#include "db/repository/base/row_columns.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr auto kAllocation = rowColumns<AllocationEntry>(
    "allocation",
    "id, design_id, sequence, enrolment_id, group_id, number_in_group, covariates_json, counts_before_json,"
    " scores_json, draw_before, draw_after, enrolled_by, allocated_by, software_version, override_reason,"
    " allocated_utc_us, demonstration, previous_hash, record_hash",
    &AllocationEntry::id, &AllocationEntry::designId, &AllocationEntry::sequence,
    &AllocationEntry::enrolmentId, &AllocationEntry::groupId, &AllocationEntry::numberInGroup,
    &AllocationEntry::covariatesJson, &AllocationEntry::countsBeforeJson, &AllocationEntry::scoresJson,
    &AllocationEntry::drawBefore, &AllocationEntry::drawAfter, &AllocationEntry::enrolledBy,
    &AllocationEntry::allocatedBy, &AllocationEntry::softwareVersion,
    OrNull{&AllocationEntry::overrideReason}, &AllocationEntry::allocatedUtc_us,
    &AllocationEntry::demonstration, &AllocationEntry::previousHash, &AllocationEntry::recordHash);

constexpr auto kCentre = rowColumns<Centre>("centre", "id, name, created_utc_us, demonstration", &Centre::id,
                                            &Centre::name, &Centre::createdUtc_us, &Centre::demonstration);

constexpr auto kImport = rowColumns<StudyImport>(
    "study_import",
    "id, cohort_id, layout, source, content_hash, earlier_json, signed_by, imported_by, imported_utc_us",
    &StudyImport::id, &StudyImport::cohortId, &StudyImport::layout, &StudyImport::source,
    &StudyImport::contentHash, &StudyImport::earlierJson, OrNull{&StudyImport::signedBy},
    &StudyImport::importedBy, &StudyImport::importedUtc_us);

constexpr auto kExposure = rowColumns<Exposure>(
    "exposure", "id, enrolment_id, phase_id, kind, started_utc_us, duration_us, recorded_by, demonstration",
    &Exposure::id, &Exposure::enrolmentId, OrNull{&Exposure::phaseId}, &Exposure::kind,
    &Exposure::startedUtc_us, &Exposure::duration_us, &Exposure::recordedBy, &Exposure::demonstration);

using Deviation = ProtocolDeviation;
constexpr auto kDeviation = rowColumns<Deviation>(
    "deviation",
    "id, cohort_id, enrolment_id, kind, description, happened_utc_us, reported_by, reported_utc_us,"
    " demonstration",
    &Deviation::id, &Deviation::cohortId, OrNull{&Deviation::enrolmentId}, &Deviation::kind,
    OrNull{&Deviation::description}, &Deviation::happenedUtc_us, &Deviation::reportedBy,
    &Deviation::reportedUtc_us, &Deviation::demonstration);

}  // namespace

std::string allocationHash(const AllocationEntry& record) {
  FieldDigest digest("torsio allocation 1");
  digest.add(record.previousHash).add(record.id).add(record.designId).add(record.sequence);
  digest.add(record.enrolmentId).add(record.groupId).add(record.numberInGroup).add(record.covariatesJson);
  digest.add(record.countsBeforeJson).add(record.scoresJson).add(record.drawBefore).add(record.drawAfter);
  digest.add(record.enrolledBy).add(record.allocatedBy).add(record.softwareVersion);
  digest.add(record.overrideReason).add(record.allocatedUtc_us).add(record.demonstration ? 1 : 0);
  return digest.hex();
}

void StudyRepository::setCentre(const Centre& centre) {
  Transaction transaction(connection_);
  connection_.execute("DELETE FROM centre");
  connection_.prepare(kCentre.insert()).execute(kCentre.values(centre));
  transaction.commit();
}

std::optional<Centre> StudyRepository::centre() const {
  return selectFirst(connection_, kCentre.select("c") + " FROM centre c", {}, kCentre);
}

void StudyRepository::addCohort(const Cohort& cohort, std::span<const StudyGroup> groups) {
  Transaction transaction(connection_);
  connection_.execute(
      insertInto("cohort", "id, name, description, created_utc_us, demonstration, equivalence_margin"),
      {cohort.id, cohort.name, cohort.description, cohort.createdUtc_us, cohort.demonstration,
       cohort.equivalenceMargin});
  Statement insert = connection_.prepare(insertInto("training_group", "id, cohort_id, number, code, label"));
  for (const StudyGroup& group : groups) {
    insert.execute({group.id, cohort.id, group.number, group.code, group.label});
  }
  transaction.commit();
}

std::vector<Cohort> StudyRepository::cohorts() const {
  return selectAll(
      connection_,
      "SELECT c.id, c.name, c.description, c.created_utc_us, c.demonstration, c.curriculum_version_id,"
      " COALESCE((SELECT s.state FROM cohort_state s WHERE s.cohort_id = c.id ORDER BY s.sequence DESC"
      " LIMIT 1), CASE WHEN EXISTS (SELECT 1 FROM enrolment e WHERE e.cohort_id = c.id AND (e.group_id IS"
      " NOT NULL OR EXISTS (SELECT 1 FROM trial t WHERE t.enrolment_id = e.id) OR EXISTS (SELECT 1 FROM"
      " exposure x WHERE x.enrolment_id = e.id))) THEN 'running' ELSE 'draft' END) AS state, "
      "c.equivalence_margin"
      " FROM cohort c ORDER BY c.created_utc_us, c.name",
      {}, [](RowReader& row) {
        return Cohort{row.text(),
                      row.text(),
                      row.text(),
                      row.int64(),
                      row.boolean(),
                      row.text(),
                      readTerm<CohortState>(row),
                      row.maybeReal()};
      });
}

void StudyRepository::renameCohort(const CohortId& cohortId, const std::string& name) {
  connection_.execute("UPDATE cohort SET name = ? WHERE id = ?", {name, cohortId});
}

void StudyRepository::setCohortState(const CohortId& cohortId, CohortState state, const std::string& reason,
                                     const std::string& changedBy, std::int64_t utc_us) {
  connection_.execute(
      "INSERT INTO cohort_state (cohort_id, sequence, state, reason, changed_by, changed_utc_us)"
      " VALUES (?, (SELECT COALESCE(MAX(s.sequence), 0) + 1 FROM cohort_state s WHERE s.cohort_id = ?),"
      " ?, ?, ?, ?)",
      {cohortId, cohortId, storedText(state), reason, changedBy, utc_us});
}

void StudyRepository::addStatement(const StudyStatement& statement) {
  connection_.execute(
      "INSERT INTO study_statement (cohort_id, item, sequence, statement, stated_by, stated_utc_us)"
      " VALUES (?, ?, (SELECT COALESCE(MAX(s.sequence), 0) + 1 FROM study_statement s WHERE s.cohort_id = ?"
      " AND s.item = ?), ?, ?, ?)",
      {statement.cohortId, storedText(statement.item), statement.cohortId, storedText(statement.item),
       statement.statement, statement.statedBy, statement.statedUtc_us});
}

StudyStatements StudyRepository::statements(const CohortId& cohortId) const {
  StudyStatements newest;
  Statement row = connection_.prepare(
      "SELECT item, statement FROM study_statement WHERE cohort_id = ? ORDER BY item, sequence");
  row.execute({cohortId});
  while (row.step()) {
    RowReader read(row);
    const auto item = readTerm<StudyItem>(read);
    newest[item] = read.text();
  }
  std::erase_if(newest, [](const auto& one) { return one.second.empty(); });
  return newest;
}

void StudyRepository::addImport(const StudyImport& import) {
  connection_.prepare(kImport.insert()).execute(kImport.values(import));
}

std::vector<StudyImport> StudyRepository::imports(const CohortId& cohortId) const {
  return selectAll(
      connection_,
      kImport.select("i") + " FROM study_import i WHERE i.cohort_id = ? ORDER BY i.imported_utc_us, i.id",
      {cohortId}, kImport);
}

std::int64_t StudyRepository::importedTrials(const CohortId& cohortId) const {
  return selectFirst(connection_,
                     "SELECT count(*) FROM study_import i JOIN trial t ON t.import_id = i.id"
                     " WHERE i.cohort_id = ?",
                     {cohortId}, readInt64)
      .value_or(0);
}

Cohort StudyRepository::cohort(const CohortId& cohortId) const {
  for (Cohort& one : cohorts()) {
    if (one.id == cohortId) {
      return std::move(one);
    }
  }
  refuse(Text::tr("there is no such cohort"), cohortId, Text::tr("Choose one from the list"));
}

std::vector<StudyGroup> StudyRepository::groups(const CohortId& cohortId) const {
  return selectAll(connection_,
                   "SELECT id, cohort_id, number, code, label, arm_id FROM training_group WHERE cohort_id = ?"
                   " ORDER BY number",
                   {cohortId}, [](RowReader& row) {
                     return StudyGroup{row.text(), row.text(), row.int64(),
                                       row.text(), row.text(), row.text()};
                   });
}

void StudyRepository::enrol(std::span<const Enrolment> enrolments) {
  std::vector<std::string> ids;
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(
      insertInto("enrolment",
                 "id, cohort_id, trainee_id, group_id, number_in_group, state, enrolled_utc_us,"
                 " demonstration"));
  for (const Enrolment& enrolment : enrolments) {
    insert.execute({enrolment.id, enrolment.cohortId, enrolment.traineeId, textOrNull(enrolment.groupId),
                    enrolment.numberInGroup == 0 ? Value() : Value(enrolment.numberInGroup),
                    storedText(enrolment.state), enrolment.enrolledUtc_us, enrolment.demonstration});
    ids.push_back(enrolment.id);
  }
  noteLearningEvents(connection_, LearningEventKind::kRegistered, ids);
  transaction.commit();
}

std::vector<Enrolment> StudyRepository::enrolments(const CohortId& cohortId) const {
  return selectAll(
      connection_,
      "SELECT e.id, e.cohort_id, e.trainee_id, e.group_id, e.number_in_group, e.state, e.enrolled_utc_us,"
      " e.demonstration, p.code, g.code FROM enrolment e JOIN person p ON p.id = e.trainee_id"
      " LEFT JOIN training_group g ON g.id = e.group_id WHERE e.cohort_id = ?"
      " ORDER BY COALESCE(g.number, 0), COALESCE(e.number_in_group, 0), p.code",
      {cohortId}, [](RowReader& row) {
        return Enrolment{.id = row.text(),
                         .cohortId = row.text(),
                         .traineeId = row.text(),
                         .groupId = row.text(),
                         .numberInGroup = row.int64(),
                         .state = readTerm<EnrolmentState>(row),
                         .enrolledUtc_us = row.int64(),
                         .demonstration = row.boolean(),
                         .traineeCode = row.text(),
                         .groupCode = row.text()};
      });
}

void StudyRepository::setEnrolmentState(const EnrolmentId& enrolmentId, EnrolmentState state) {
  connection_.execute("UPDATE enrolment SET state = ? WHERE id = ?", {storedText(state), enrolmentId});
}

void StudyRepository::lockDesign(const LockedDesign& design) {
  Transaction transaction(connection_);
  connection_.execute(
      insertInto("allocation_design",
                 "id, cohort_id, algorithm, algorithm_version, parameters_json, generator, seed_commitment,"
                 " locked_utc_us, demonstration"),
      {design.id, design.cohortId, design.algorithm, design.algorithmVersion, design.parametersJson,
       design.generator, design.seedCommitment, design.lockedUtc_us, design.demonstration});
  connection_.execute(insertInto("allocation_seed", "design_id, seed, salt"),
                      {design.id, design.seed, design.salt});
  transaction.commit();
}

void StudyRepository::revealSeed(const DesignId& designId, std::int64_t utc_us) {
  connection_.execute("UPDATE allocation_seed SET revealed_utc_us = ? WHERE design_id = ?",
                      {utc_us, designId});
}

std::string StudyRepository::sealedSeed(const DesignId& designId) const {
  return selectFirst(connection_, "SELECT seed FROM allocation_seed WHERE design_id = ?", {designId},
                     readText)
      .value_or("");
}

std::string StudyRepository::sealedSalt(const DesignId& designId) const {
  return selectFirst(connection_, "SELECT salt FROM allocation_seed WHERE design_id = ?", {designId},
                     readText)
      .value_or("");
}

std::vector<LockedDesign> StudyRepository::designs(const CohortId& cohortId) const {
  return selectAll(
      connection_,
      "SELECT d.id, d.cohort_id, d.algorithm, d.algorithm_version, d.parameters_json, d.generator,"
      " d.seed_commitment, s.seed, s.salt, d.locked_utc_us, d.demonstration FROM allocation_design d"
      " LEFT JOIN allocation_seed s ON s.design_id = d.id AND s.revealed_utc_us IS NOT NULL"
      " WHERE d.cohort_id = ? ORDER BY d.locked_utc_us, d.id",
      {cohortId}, [](RowReader& row) {
        return LockedDesign{.id = row.text(),
                            .cohortId = row.text(),
                            .algorithm = row.text(),
                            .algorithmVersion = row.text(),
                            .parametersJson = row.text(),
                            .generator = row.text(),
                            .seedCommitment = row.text(),
                            .seed = row.text(),
                            .salt = row.text(),
                            .lockedUtc_us = row.int64(),
                            .demonstration = row.boolean()};
      });
}

std::vector<AllocationEntry> StudyRepository::allocate(std::span<const AllocationEntry> records) {
  std::vector<AllocationEntry> stored;
  Transaction transaction(connection_);
  Statement last = connection_.prepare(
      "SELECT sequence, record_hash FROM allocation WHERE design_id = ? ORDER BY sequence DESC LIMIT 1");
  Statement insert = connection_.prepare(kAllocation.insert());
  Statement move = connection_.prepare("UPDATE enrolment SET group_id = ?, number_in_group = ? WHERE id = ?");
  for (AllocationEntry record : records) {
    last.execute({record.designId});
    std::int64_t sequence = 0;
    record.previousHash.clear();
    while (last.step()) {
      RowReader row(last);
      sequence = row.int64();
      record.previousHash = row.text();
    }
    if (record.sequence != sequence + 1) {
      refuse(Text::tr("allocation number %1 does not follow %2", record.sequence, sequence),
             Text::tr("allocation"), Text::tr("Read the list again and repeat"));
    }
    record.recordHash = allocationHash(record);
    insert.execute(kAllocation.values(record));
    move.execute({record.groupId, record.numberInGroup, record.enrolmentId});
    stored.push_back(std::move(record));
  }
  transaction.commit();
  return stored;
}

std::vector<AllocationEntry> StudyRepository::allocations(const DesignId& designId) const {
  return selectAll(connection_,
                   kAllocation.select("a") + " FROM allocation a WHERE a.design_id = ? ORDER BY a.sequence",
                   {designId}, kAllocation);
}

std::optional<std::int64_t> StudyRepository::firstBrokenAllocation(const DesignId& designId) const {
  std::string previous;
  std::int64_t sequence = 0;
  for (const AllocationEntry& record : allocations(designId)) {
    ++sequence;
    const bool fits = record.sequence == sequence && record.previousHash == previous &&
                      record.recordHash == allocationHash(record);
    if (!fits) {
      return sequence;
    }
    previous = record.recordHash;
  }
  return std::nullopt;
}

void StudyRepository::addExposures(std::span<const Exposure> exposures) {
  std::vector<std::string> rests;
  Transaction transaction(connection_);
  Statement insert = connection_.prepare(kExposure.insert());
  for (const Exposure& exposure : exposures) {
    insert.execute(kExposure.values(exposure));
    if (exposure.kind == ExposureKind::kRest) {
      rests.push_back(exposure.id);
    }
  }
  noteLearningEvents(connection_, LearningEventKind::kRested, rests);
  transaction.commit();
}

std::vector<Exposure> StudyRepository::exposures(const CohortId& cohortId) const {
  return selectAll(connection_,
                   kExposure.select("x") +
                       " FROM exposure x JOIN enrolment e ON e.id = x.enrolment_id WHERE e.cohort_id = ?"
                       " ORDER BY x.enrolment_id, x.started_utc_us, x.id",
                   {cohortId}, kExposure);
}

std::vector<Exposure> StudyRepository::exposuresOf(const EnrolmentId& enrolmentId) const {
  return selectAll(
      connection_,
      kExposure.select("x") + " FROM exposure x WHERE x.enrolment_id = ? ORDER BY x.started_utc_us, x.id",
      {enrolmentId}, kExposure);
}

std::vector<TrialId> StudyRepository::trialIds(const CohortId& cohortId) const {
  return selectAll(connection_,
                   "SELECT t.id FROM trial t JOIN enrolment e ON e.id = t.enrolment_id WHERE e.cohort_id = ?"
                   " ORDER BY t.started_utc_us, t.id",
                   {cohortId}, readId<TrialId>);
}

std::vector<RunningTrial> StudyRepository::runningTrials(const CohortId& cohortId) const {
  return selectAll(connection_,
                   "SELECT t.id, t.enrolment_id, t.station, t.phase_label, t.started_utc_us FROM trial t"
                   " JOIN enrolment e ON e.id = t.enrolment_id LEFT JOIN trial_end x ON x.trial_id = t.id"
                   " WHERE e.cohort_id = ? AND x.trial_id IS NULL ORDER BY t.started_utc_us DESC, t.id",
                   {cohortId}, [](RowReader& row) {
                     return RunningTrial{row.text(), row.text(), row.text(), row.text(), row.int64()};
                   });
}

std::vector<CohortId> StudyRepository::cohortsAtWork(std::int64_t fromUtc_us, std::int64_t toUtc_us) const {
  return selectAll(connection_,
                   "SELECT e.cohort_id FROM day_slot s JOIN enrolment e ON e.id = s.enrolment_id"
                   " WHERE s.starts_utc_us < ? AND s.starts_utc_us + s.duration_us > ?"
                   " UNION SELECT e.cohort_id FROM trial t JOIN enrolment e ON e.id = t.enrolment_id"
                   " LEFT JOIN trial_end x ON x.trial_id = t.id"
                   " WHERE x.trial_id IS NULL AND t.started_utc_us >= ? AND t.started_utc_us < ?",
                   {toUtc_us, fromUtc_us, fromUtc_us, toUtc_us}, readId<CohortId>);
}

void StudyRepository::addDeviation(const ProtocolDeviation& deviation) {
  connection_.prepare(kDeviation.insert()).execute(kDeviation.values(deviation));
}

std::vector<ProtocolDeviation> StudyRepository::deviations(const CohortId& cohortId) const {
  return selectAll(
      connection_,
      kDeviation.select("d") + " FROM deviation d WHERE d.cohort_id = ? ORDER BY d.happened_utc_us, d.id",
      {cohortId}, kDeviation);
}

}  // namespace torsio
