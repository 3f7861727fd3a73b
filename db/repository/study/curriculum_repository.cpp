// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/curriculum_repository.h"

#include <algorithm>
#include <map>
#include <utility>

#include "assessment/domain/ids.h"
#include "db/connection/db_error.h"
#include "db/repository/base/row_columns.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

const TrainingModule* moduleWithId(const CurriculumVersion& version, const std::string& id) {
  const auto found = std::find_if(version.modules.begin(), version.modules.end(),
                                  [&](const TrainingModule& module) { return module.id == id; });
  return found == version.modules.end() ? nullptr : &*found;
}

/// Repeatedly removes modules without remaining prerequisites; whatever stays is part of a cycle.
void checkPrerequisites(const CurriculumVersion& version) {
  std::map<ModuleId, std::vector<ModuleId>> open;
  for (const TrainingModule& module : version.modules) {
    for (const ModuleId& id : module.requires_) {
      if (moduleWithId(version, id) == nullptr) {
        refuse(Text::tr("requires a module that is not in this version"), module.code,
               Text::tr("Choose prerequisites from the same version"));
      }
    }
    open[module.id] = module.requires_;
  }
  for (std::size_t before = 0; before != open.size();) {
    before = open.size();
    std::erase_if(open, [&](const auto& entry) {
      return std::none_of(entry.second.begin(), entry.second.end(),
                          [&](const ModuleId& id) { return open.contains(id); });
    });
  }
  if (!open.empty()) {
    refuse(Text::tr("prerequisites run in a circle"), moduleWithId(version, open.begin()->first)->code,
           Text::tr("Remove one of them"));
  }
}

void insertModules(Connection& connection, const CurriculumVersion& version) {
  Statement insert = connection.prepare(
      insertInto("module",
                 "id, version_id, position, code, title, scene_id, pattern_id, mode,"
                 " target_angle_rad, tolerance_rad, hold_us, least_twists, max_force_n, max_torque_nm,"
                 " attempt_limit"));
  std::int64_t position = 0;
  for (const TrainingModule& module : version.modules) {
    insert.execute({module.id, version.id, ++position, module.code, module.title, module.sceneId,
                    module.patternId, storedText(module.mode), module.targetAngle_rad, module.tolerance_rad,
                    module.hold_us, module.leastTwists, module.maxForce_N, module.maxTorque_Nm,
                    module.attemptLimit});
  }
  Statement prerequisite =
      connection.prepare(insertInto("module_prerequisite", "module_id, requires_module_id"));
  Statement mastery = connection.prepare(
      insertInto("mastery_rule", "module_id, metric, comparison, threshold, unit, consecutive"));
  for (const TrainingModule& module : version.modules) {
    for (const ModuleId& id : module.requires_) {
      prerequisite.execute({module.id, id});
    }
    for (const MasteryCriterion& rule : module.mastery) {
      mastery.execute({module.id, rule.metric, rule.comparison, rule.threshold, rule.unit, rule.consecutive});
    }
  }
}

void insertArms(Connection& connection, const CurriculumVersion& version) {
  Statement arm = connection.prepare(insertInto(
      "curriculum_arm", "id, version_id, number, code, label, rest_allowance_us, rest_splittable"));
  Statement phase = connection.prepare(
      insertInto("curriculum_phase", "id, arm_id, position, kind, label, duration_us, module_id"));
  std::int64_t number = 0;
  for (const StudyArm& part : version.arms) {
    arm.execute(
        {part.id, version.id, ++number, part.code, part.label, part.restAllowance_us, part.restSplittable});
    std::int64_t position = 0;
    for (const TrainingPhase& step : part.phases) {
      phase.execute({step.id, part.id, ++position, storedText(step.kind), step.label, step.duration_us,
                     textOrNull(step.moduleId)});
    }
  }
  Statement point =
      connection.prepare(insertInto("curriculum_occasion", "version_id, occasion, after_exposure_us"));
  for (const PlannedOccasion& part : version.plannedOccasions) {
    point.execute({version.id, part.code, part.afterExposure_us});
  }
}

TrainingModule moduleOf(RowReader& row) {
  return {.id = row.text(),
          .code = row.text(),
          .title = row.text(),
          .sceneId = row.text(),
          .patternId = row.text(),
          .mode = readTerm<AttemptMode>(row),
          .targetAngle_rad = row.real(),
          .tolerance_rad = row.real(),
          .hold_us = row.int64(),
          .leastTwists = row.int64(),
          .maxForce_N = row.maybeReal(),
          .maxTorque_Nm = row.maybeReal(),
          .attemptLimit = row.maybeInt64(),
          .requires_ = {},
          .mastery = {}};
}

MasteryCriterion masteryRuleOf(RowReader& row) {
  return {row.text(), row.text(), row.real(), row.text(), row.int64()};
}

std::vector<TrainingModule> modulesOf(Connection& connection, const CurriculumVersionId& versionId) {
  std::vector<TrainingModule> modules =
      selectAll(connection,
                "SELECT id, code, title, scene_id, pattern_id, mode, target_angle_rad, tolerance_rad,"
                " hold_us, least_twists, max_force_n, max_torque_nm, attempt_limit FROM module"
                " WHERE version_id = ?"
                " ORDER BY position",
                {versionId}, moduleOf);
  Statement prerequisites = connection.prepare(
      "SELECT p.requires_module_id FROM module_prerequisite p JOIN module r ON r.id = p.requires_module_id"
      " WHERE p.module_id = ? ORDER BY r.position");
  Statement mastery = connection.prepare(
      "SELECT metric, comparison, threshold, unit, consecutive FROM mastery_rule WHERE module_id = ?"
      " ORDER BY metric");
  for (TrainingModule& module : modules) {
    prerequisites.execute({module.id});
    module.requires_ = readRows(prerequisites, readId<ModuleId>);
    mastery.execute({module.id});
    module.mastery = readRows(mastery, masteryRuleOf);
  }
  return modules;
}

TrainingPhase phaseOf(RowReader& row) {
  return {row.text(), readTerm<PhaseKind>(row), row.text(), row.int64(), row.text()};
}

std::vector<StudyArm> armsOf(Connection& connection, const CurriculumVersionId& versionId) {
  std::vector<StudyArm> arms = selectAll(
      connection,
      "SELECT id, code, label, rest_allowance_us, rest_splittable FROM curriculum_arm WHERE version_id = ?"
      " ORDER BY number",
      {versionId}, [](RowReader& row) {
        return StudyArm{row.text(), row.text(), row.text(), row.int64(), row.boolean(), {}};
      });
  Statement phases = connection.prepare(
      "SELECT id, kind, label, duration_us, module_id FROM curriculum_phase WHERE arm_id = ?"
      " ORDER BY position");
  for (StudyArm& arm : arms) {
    phases.execute({arm.id});
    arm.phases = readRows(phases, phaseOf);
  }
  return arms;
}

std::vector<PlannedOccasion> plannedOccasionsOf(Connection& connection,
                                                const CurriculumVersionId& versionId) {
  return selectAll(connection,
                   "SELECT p.occasion, p.after_exposure_us FROM curriculum_occasion p"
                   " JOIN occasion o ON o.code = p.occasion WHERE p.version_id = ?"
                   " ORDER BY p.after_exposure_us, o.position",
                   {versionId}, [](RowReader& row) {
                     return PlannedOccasion{row.text(), row.int64()};
                   });
}

}  // namespace

void CurriculumRepository::addCurriculum(const Curriculum& curriculum) {
  connection_.execute(insertInto("curriculum", "id, name, description, created_utc_us, demonstration"),
                      {curriculum.id, curriculum.name, curriculum.description, curriculum.createdUtc_us,
                       curriculum.demonstration});
}

std::vector<Curriculum> CurriculumRepository::curricula() const {
  return selectAll(
      connection_,
      "SELECT id, name, description, created_utc_us, demonstration FROM curriculum ORDER BY name", {},
      [](RowReader& row) {
        return Curriculum{row.text(), row.text(), row.text(), row.int64(), row.boolean()};
      });
}

std::int64_t CurriculumRepository::saveDraft(const CurriculumId& curriculumId,
                                             const CurriculumDraftRow& draft) {
  Transaction transaction(connection_);
  const std::int64_t next = draft.revision + 1;
  // No row changes if revision 1 is inserted twice or the revision has moved on: somebody saved in between.
  const std::int64_t changed =
      draft.revision == 0
          ? connection_.execute(
                insertInto("curriculum_draft",
                           "curriculum_id, revision, content_json, changed_by, changed_utc_us") +
                    " ON CONFLICT (curriculum_id) DO NOTHING",
                {curriculumId, next, draft.contentJson, draft.changedBy, draft.changedUtc_us})
          : connection_.execute(
                "UPDATE curriculum_draft SET revision = ?, content_json = ?, changed_by = ?,"
                " changed_utc_us = ? WHERE curriculum_id = ? AND revision = ?",
                {next, draft.contentJson, draft.changedBy, draft.changedUtc_us, curriculumId,
                 draft.revision});
  if (changed != 1) {
    throw DbError(DbFault::kConflict, "UPDATE curriculum_draft",
                  Text::tr("somebody else saved this draft meanwhile"), connection_.location(),
                  Text::tr("Read the draft again and merge your changes"));
  }
  transaction.commit();
  return next;
}

std::optional<CurriculumDraftRow> CurriculumRepository::draft(const CurriculumId& curriculumId) const {
  return selectFirst(connection_,
                     "SELECT revision, content_json, changed_by, changed_utc_us FROM curriculum_draft"
                     " WHERE curriculum_id = ?",
                     {curriculumId}, [](RowReader& row) {
                       return CurriculumDraftRow{row.int64(), row.text(), row.text(), row.int64()};
                     });
}

void CurriculumRepository::addVersion(const CurriculumVersion& version, const std::string& createdBy) {
  checkPrerequisites(version);
  Transaction transaction(connection_);
  connection_.execute(
      insertInto("curriculum_version", "id, curriculum_id, number, note, created_utc_us"),
      {version.id, version.curriculumId, version.number, version.note, version.createdUtc_us});
  insertModules(connection_, version);
  insertArms(connection_, version);
  connection_.execute(
      "INSERT INTO curriculum_state (version_id, sequence, state, changed_by, changed_utc_us)"
      " VALUES (?, 1, 'draft', ?, ?)",
      {version.id, createdBy, version.createdUtc_us});
  transaction.commit();
}

std::optional<CurriculumVersion> CurriculumRepository::version(const CurriculumVersionId& versionId) const {
  return selectFirst(
      connection_,
      "SELECT id, curriculum_id, number, note, created_utc_us FROM curriculum_version WHERE id = ?",
      {versionId}, [&](RowReader& row) {
        return CurriculumVersion{.id = row.text(),
                                 .curriculumId = row.text(),
                                 .number = row.int64(),
                                 .note = row.text(),
                                 .createdUtc_us = row.int64(),
                                 .modules = modulesOf(connection_, versionId),
                                 .arms = armsOf(connection_, versionId),
                                 .plannedOccasions = plannedOccasionsOf(connection_, versionId),
                                 .state = stateOf(versionId).value_or(CurriculumState::kDraft)};
      });
}

std::optional<TrainingModule> CurriculumRepository::module(const ModuleId& moduleId) const {
  const auto versionId = selectFirst(connection_, "SELECT version_id FROM module WHERE id = ?", {moduleId},
                                     readId<CurriculumVersionId>);
  if (versionId) {
    for (TrainingModule& one : modulesOf(connection_, *versionId)) {
      if (one.id == moduleId) {
        return std::move(one);
      }
    }
  }
  return std::nullopt;
}

std::vector<CurriculumVersionId> CurriculumRepository::versionIds(const CurriculumId& curriculumId) const {
  return selectAll(connection_, "SELECT id FROM curriculum_version WHERE curriculum_id = ? ORDER BY number",
                   {curriculumId}, readId<CurriculumVersionId>);
}

std::optional<CurriculumState> CurriculumRepository::stateOf(const CurriculumVersionId& versionId) const {
  return selectFirst(connection_,
                     "SELECT state FROM curriculum_state WHERE version_id = ? ORDER BY sequence DESC LIMIT 1",
                     {versionId}, [](RowReader& row) { return readTerm<CurriculumState>(row); });
}

void CurriculumRepository::moveTo(const CurriculumVersionId& versionId, CurriculumState state,
                                  const std::string& changedBy, std::int64_t changedUtc_us) {
  Transaction transaction(connection_);
  const std::optional<CurriculumState> now = stateOf(versionId);
  const bool next = now && static_cast<int>(state) == static_cast<int>(*now) + 1;
  const bool again = now == CurriculumState::kClosed && state == CurriculumState::kRunning;
  if (!next && !again) {
    refuse(!now ? Text::tr("there is no such curriculum")
                : Text::tr("a curriculum that is %1 cannot become %2", storedText(*now), storedText(state)),
           versionId, Text::tr("Draft becomes running, running becomes closed, closed may run again"));
  }
  const std::int64_t last =
      selectFirst(connection_, "SELECT max(sequence) FROM curriculum_state WHERE version_id = ?", {versionId},
                  readInt64)
          .value_or(0);
  connection_.execute(
      insertInto("curriculum_state", "version_id, sequence, state, changed_by, changed_utc_us"),
      {versionId, last + 1, storedText(state), changedBy, changedUtc_us});
  transaction.commit();
}

void CurriculumRepository::assign(const CohortId& cohortId, const CurriculumVersionId& versionId) {
  Transaction transaction(connection_);
  if (stateOf(versionId) != CurriculumState::kRunning) {
    refuse(Text::tr("this version of the curriculum is not running"), versionId,
           Text::tr("Start it first, or choose another version"));
  }
  connection_.execute("UPDATE cohort SET curriculum_version_id = ? WHERE id = ?", {versionId, cohortId});
  connection_.execute(
      "UPDATE training_group SET arm_id = (SELECT a.id FROM curriculum_arm a WHERE a.version_id = ?"
      " AND a.number = training_group.number) WHERE cohort_id = ?",
      {versionId, cohortId});
  const std::optional<std::string> missing =
      selectFirst(connection_, "SELECT code FROM training_group WHERE cohort_id = ? AND arm_id IS NULL",
                  {cohortId}, readText);
  if (missing) {
    refuse(Text::tr("the curriculum has no arm for this group"), *missing,
           Text::tr("Give the curriculum as many arms as the cohort has groups"));
  }
  transaction.commit();
}

namespace {

using Design = CompetenceDesign;
constexpr auto kDesign = rowColumns<Design>(
    "competence_design",
    "module_id, version, registered_utc_us, tolerance_rad, tolerance_source, experts, adequate, inadequate,"
    " attempts, false_pass_most, false_fail_most, sum_limit, reason, session_correlation, lag_correlation,"
    " runs_per_session, dependence_runs, valid_days",
    &Design::moduleId, &Design::version, &Design::registeredUtc_us, &Design::tolerance_rad, &Design::source,
    &Design::experts, &Design::adequate, &Design::inadequate, &Design::attempts, &Design::falsePassMost,
    &Design::falseFailMost, &Design::limit, &Design::reason, &Design::sessionCorrelation,
    &Design::lagCorrelation, &Design::runsPerSession, &Design::dependenceRuns, OrNull{&Design::validDays});

}  // namespace

CompetenceDesign CompetenceRepository::add(CompetenceDesign design) {
  Transaction transaction(connection_);
  const std::vector<CompetenceDesign> before = ofModule(design.moduleId);
  design.version = before.empty() ? 1 : before.back().version + 1;
  connection_.prepare(kDesign.insert()).execute(kDesign.values(design));
  transaction.commit();
  return design;
}

std::vector<CompetenceDesign> CompetenceRepository::ofModule(const ModuleId& moduleId) const {
  std::vector<CompetenceDesign> designs = selectAll(
      connection_, kDesign.select("d") + " FROM competence_design d WHERE d.module_id = ? ORDER BY d.version",
      {moduleId}, kDesign);
  for (CompetenceDesign& design : designs) {
    if (design.runsPerSession == 0) {  // registered before schema 2
      const CompetenceDesign assumed;
      design.sessionCorrelation = assumed.sessionCorrelation;
      design.lagCorrelation = assumed.lagCorrelation;
      design.runsPerSession = assumed.runsPerSession;
    }
  }
  return designs;
}

}  // namespace torsio
