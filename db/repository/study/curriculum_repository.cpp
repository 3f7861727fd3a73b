// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/curriculum_repository.h"

#include <algorithm>
#include <map>

#include "sim/base/error.h"

namespace torsio {

namespace {

const StoredModule* moduleWithId(const StoredCurriculumVersion& version, const std::string& id) {
  const auto found = std::find_if(version.modules.begin(), version.modules.end(),
                                  [&](const StoredModule& module) { return module.id == id; });
  return found == version.modules.end() ? nullptr : &*found;
}

/// Takes away, again and again, the modules whose prerequisites are all gone; what stays runs in a circle.
void checkPrerequisites(const StoredCurriculumVersion& version) {
  std::map<std::string, std::vector<std::string>> open;
  for (const StoredModule& module : version.modules) {
    for (const std::string& id : module.requires_) {
      if (moduleWithId(version, id) == nullptr) {
        throw Error(ErrorCode::kBadData, "requires a module that is not in this version", module.code,
                    "Choose prerequisites from the same version");
      }
    }
    open[module.id] = module.requires_;
  }
  for (std::size_t before = 0; before != open.size();) {
    before = open.size();
    std::erase_if(open, [&](const auto& entry) {
      return std::none_of(entry.second.begin(), entry.second.end(),
                          [&](const std::string& id) { return open.contains(id); });
    });
  }
  if (!open.empty()) {
    throw Error(ErrorCode::kBadData, "prerequisites run in a circle",
                moduleWithId(version, open.begin()->first)->code, "Remove one of them");
  }
}

void insertModules(Connection& connection, const StoredCurriculumVersion& version) {
  Statement insert = connection.prepare(
      "INSERT INTO module (id, version_id, position, code, title, scene_id, pattern_id, exercise_kind, mode,"
      " target_angle_rad, tolerance_rad, hold_us, max_force_n, max_torque_nm, attempt_limit)"
      " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  std::int64_t position = 0;
  for (const StoredModule& module : version.modules) {
    insert.execute({module.id, version.id, ++position, module.code, module.title, module.sceneId,
                    module.patternId, module.exerciseKind, module.mode, module.targetAngle_rad,
                    module.tolerance_rad, module.hold_us, module.maxForce_N, module.maxTorque_Nm,
                    module.attemptLimit});
  }
  Statement prerequisite =
      connection.prepare("INSERT INTO module_prerequisite (module_id, requires_module_id) VALUES (?, ?)");
  Statement mastery = connection.prepare(
      "INSERT INTO mastery_rule (module_id, metric, comparison, threshold, unit, consecutive)"
      " VALUES (?, ?, ?, ?, ?, ?)");
  for (const StoredModule& module : version.modules) {
    for (const std::string& id : module.requires_) prerequisite.execute({module.id, id});
    for (const StoredMasteryRule& rule : module.mastery) {
      mastery.execute({module.id, rule.metric, rule.comparison, rule.threshold, rule.unit, rule.consecutive});
    }
  }
}

void insertArms(Connection& connection, const StoredCurriculumVersion& version) {
  Statement arm = connection.prepare(
      "INSERT INTO curriculum_arm (id, version_id, number, code, label, rest_allowance_us, rest_splittable)"
      " VALUES (?, ?, ?, ?, ?, ?, ?)");
  Statement phase = connection.prepare(
      "INSERT INTO curriculum_phase (id, arm_id, position, kind, label, duration_us, module_id)"
      " VALUES (?, ?, ?, ?, ?, ?, ?)");
  std::int64_t number = 0;
  for (const StoredArm& part : version.arms) {
    arm.execute(
        {part.id, version.id, ++number, part.code, part.label, part.restAllowance_us, part.restSplittable});
    std::int64_t position = 0;
    for (const StoredPhase& step : part.phases) {
      phase.execute(
          {step.id, part.id, ++position, step.kind, step.label, step.duration_us, textOrNull(step.moduleId)});
    }
  }
  Statement point = connection.prepare(
      "INSERT INTO curriculum_scoring_point (version_id, scoring_point, after_exposure_us) VALUES (?, ?, ?)");
  for (const StoredScoringPoint& part : version.scoringPoints) {
    point.execute({version.id, part.code, part.afterExposure_us});
  }
}

std::vector<StoredModule> modulesOf(Connection& connection, const std::string& versionId) {
  std::vector<StoredModule> modules;
  std::map<std::string, std::size_t> at;
  Statement row = connection.prepare(
      "SELECT id, code, title, scene_id, pattern_id, exercise_kind, mode, target_angle_rad, tolerance_rad,"
      " hold_us, max_force_n, max_torque_nm, attempt_limit FROM module WHERE version_id = ? ORDER BY "
      "position");
  row.execute({versionId});
  while (row.step()) {
    at[row.text(0)] = modules.size();
    modules.push_back({.id = row.text(0),
                       .code = row.text(1),
                       .title = row.text(2),
                       .sceneId = row.text(3),
                       .patternId = row.text(4),
                       .exerciseKind = row.text(5),
                       .mode = row.text(6),
                       .targetAngle_rad = row.real(7),
                       .tolerance_rad = row.real(8),
                       .hold_us = row.int64(9),
                       .maxForce_N = row.maybeReal(10),
                       .maxTorque_Nm = row.maybeReal(11),
                       .attemptLimit = row.maybeInt64(12)});
  }
  Statement prerequisite = connection.prepare(
      "SELECT p.module_id, p.requires_module_id FROM module_prerequisite p JOIN module m ON m.id = "
      "p.module_id"
      " JOIN module r ON r.id = p.requires_module_id WHERE m.version_id = ? ORDER BY r.position");
  prerequisite.execute({versionId});
  while (prerequisite.step()) modules[at[prerequisite.text(0)]].requires_.push_back(prerequisite.text(1));
  Statement mastery = connection.prepare(
      "SELECT r.module_id, r.metric, r.comparison, r.threshold, r.unit, r.consecutive FROM mastery_rule r"
      " JOIN module m ON m.id = r.module_id WHERE m.version_id = ? ORDER BY r.metric");
  mastery.execute({versionId});
  while (mastery.step()) {
    modules[at[mastery.text(0)]].mastery.push_back(
        {mastery.text(1), mastery.text(2), mastery.real(3), mastery.text(4), mastery.int64(5)});
  }
  return modules;
}

std::vector<StoredArm> armsOf(Connection& connection, const std::string& versionId) {
  std::vector<StoredArm> arms;
  Statement row = connection.prepare(
      "SELECT a.id, a.code, a.label, a.rest_allowance_us, a.rest_splittable, p.id, p.kind, p.label,"
      " p.duration_us, p.module_id FROM curriculum_arm a LEFT JOIN curriculum_phase p ON p.arm_id = a.id"
      " WHERE a.version_id = ? ORDER BY a.number, p.position");
  row.execute({versionId});
  while (row.step()) {
    if (arms.empty() || arms.back().id != row.text(0)) {
      arms.push_back({row.text(0), row.text(1), row.text(2), row.int64(3), row.boolean(4), {}});
    }
    if (row.isNull(5)) continue;
    arms.back().phases.push_back({row.text(5), row.text(6), row.text(7), row.int64(8), row.text(9)});
  }
  return arms;
}

std::vector<StoredScoringPoint> scoringPointsOf(Connection& connection, const std::string& versionId) {
  std::vector<StoredScoringPoint> points;
  Statement row = connection.prepare(
      "SELECT scoring_point, after_exposure_us FROM curriculum_scoring_point WHERE version_id = ?"
      " ORDER BY after_exposure_us, scoring_point");
  row.execute({versionId});
  while (row.step()) points.push_back({row.text(0), row.int64(1)});
  return points;
}

}  // namespace

void CurriculumRepository::addCurriculum(const StoredCurriculum& curriculum) {
  connection_.execute(
      "INSERT INTO curriculum (id, name, description, created_utc_us, demonstration) VALUES (?, ?, ?, ?, ?)",
      {curriculum.id, curriculum.name, curriculum.description, curriculum.createdUtc_us,
       curriculum.demonstration});
}

std::vector<StoredCurriculum> CurriculumRepository::curricula() {
  std::vector<StoredCurriculum> curricula;
  Statement row = connection_.prepare(
      "SELECT id, name, description, created_utc_us, demonstration FROM curriculum ORDER BY name");
  row.execute();
  while (row.step()) {
    curricula.push_back({row.text(0), row.text(1), row.text(2), row.int64(3), row.boolean(4)});
  }
  return curricula;
}

std::int64_t CurriculumRepository::saveDraft(const std::string& curriculumId, const StoredDraft& draft) {
  Transaction transaction(connection_);
  const std::int64_t next = draft.revision + 1;
  // Inserting revision 1 twice, or updating a revision that has moved on, changes no row: somebody was
  // faster.
  const std::int64_t changed =
      draft.revision == 0
          ? connection_.execute(
                "INSERT INTO curriculum_draft (curriculum_id, revision, content_json, changed_by,"
                " changed_utc_us) VALUES (?, ?, ?, ?, ?) ON CONFLICT (curriculum_id) DO NOTHING",
                {curriculumId, next, draft.contentJson, draft.changedBy, draft.changedUtc_us})
          : connection_.execute(
                "UPDATE curriculum_draft SET revision = ?, content_json = ?, changed_by = ?,"
                " changed_utc_us = ? WHERE curriculum_id = ? AND revision = ?",
                {next, draft.contentJson, draft.changedBy, draft.changedUtc_us, curriculumId,
                 draft.revision});
  if (changed != 1) {
    throw DbError(DbFault::kConflict, "UPDATE curriculum_draft", "somebody else saved this draft meanwhile",
                  connection_.location(), "Read the draft again and merge your changes");
  }
  transaction.commit();
  return next;
}

std::optional<StoredDraft> CurriculumRepository::draft(const std::string& curriculumId) {
  Statement row = connection_.prepare(
      "SELECT revision, content_json, changed_by, changed_utc_us FROM curriculum_draft"
      " WHERE curriculum_id = ?");
  row.execute({curriculumId});
  if (!row.step()) return std::nullopt;
  return StoredDraft{row.int64(0), row.text(1), row.text(2), row.int64(3)};
}

void CurriculumRepository::addVersion(const StoredCurriculumVersion& version, const std::string& createdBy) {
  checkPrerequisites(version);
  Transaction transaction(connection_);
  connection_.execute(
      "INSERT INTO curriculum_version (id, curriculum_id, number, note, created_utc_us) VALUES (?, ?, ?, ?, "
      "?)",
      {version.id, version.curriculumId, version.number, version.note, version.createdUtc_us});
  insertModules(connection_, version);
  insertArms(connection_, version);
  connection_.execute(
      "INSERT INTO curriculum_state (version_id, sequence, state, changed_by, changed_utc_us)"
      " VALUES (?, 1, 'draft', ?, ?)",
      {version.id, createdBy, version.createdUtc_us});
  transaction.commit();
}

std::optional<StoredCurriculumVersion> CurriculumRepository::version(const std::string& versionId) {
  Statement row = connection_.prepare(
      "SELECT id, curriculum_id, number, note, created_utc_us FROM curriculum_version WHERE id = ?");
  row.execute({versionId});
  if (!row.step()) return std::nullopt;
  return StoredCurriculumVersion{.id = row.text(0),
                                 .curriculumId = row.text(1),
                                 .number = row.int64(2),
                                 .note = row.text(3),
                                 .createdUtc_us = row.int64(4),
                                 .modules = modulesOf(connection_, versionId),
                                 .arms = armsOf(connection_, versionId),
                                 .scoringPoints = scoringPointsOf(connection_, versionId),
                                 .state = stateOf(versionId)};
}

std::vector<std::string> CurriculumRepository::versionIds(const std::string& curriculumId) {
  std::vector<std::string> ids;
  Statement row =
      connection_.prepare("SELECT id FROM curriculum_version WHERE curriculum_id = ? ORDER BY number");
  row.execute({curriculumId});
  while (row.step()) ids.push_back(row.text(0));
  return ids;
}

std::string CurriculumRepository::stateOf(const std::string& versionId) {
  Statement row = connection_.prepare(
      "SELECT state FROM curriculum_state WHERE version_id = ? ORDER BY sequence DESC LIMIT 1");
  row.execute({versionId});
  return row.step() ? row.text(0) : "";
}

void CurriculumRepository::moveTo(const std::string& versionId, const std::string& state,
                                  const std::string& changedBy, std::int64_t changedUtc_us) {
  static const std::map<std::string, std::pair<std::string, std::int64_t>> kNext{{"draft", {"running", 2}},
                                                                                 {"running", {"closed", 3}}};
  Transaction transaction(connection_);
  const std::string now = stateOf(versionId);
  const auto next = kNext.find(now);
  if (next == kNext.end() || next->second.first != state) {
    throw Error(ErrorCode::kBadData,
                now.empty() ? Text("there is no such curriculum")
                            : Text("a curriculum that is %1 cannot become %2", now, state),
                versionId, "Draft becomes running, running becomes closed");
  }
  connection_.execute(
      "INSERT INTO curriculum_state (version_id, sequence, state, changed_by, changed_utc_us)"
      " VALUES (?, ?, ?, ?, ?)",
      {versionId, next->second.second, state, changedBy, changedUtc_us});
  transaction.commit();
}

void CurriculumRepository::assign(const std::string& cohortId, const std::string& versionId) {
  Transaction transaction(connection_);
  if (stateOf(versionId) != "running") {
    throw Error(ErrorCode::kBadData, "this version of the curriculum is not running", versionId,
                "Start it first, or choose another version");
  }
  connection_.execute("UPDATE cohort SET curriculum_version_id = ? WHERE id = ?", {versionId, cohortId});
  connection_.execute(
      "UPDATE training_group SET arm_id = (SELECT a.id FROM curriculum_arm a WHERE a.version_id = ?"
      " AND a.number = training_group.number) WHERE cohort_id = ?",
      {versionId, cohortId});
  Statement missing =
      connection_.prepare("SELECT code FROM training_group WHERE cohort_id = ? AND arm_id IS NULL");
  missing.execute({cohortId});
  if (missing.step()) {
    throw Error(ErrorCode::kBadData, "the curriculum has no arm for this group", missing.text(0),
                "Give the curriculum as many arms as the cohort has groups");
  }
  transaction.commit();
}

}  // namespace torsio
