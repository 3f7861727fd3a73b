// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/scoring/cohort_inputs.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/base/build_info.h"
#include "app/services/scoring/stored_allocation.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/audit_terms.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr const char* kChiefClass = "chief";

/// Returns the latest design, and whether its allocation can be replayed once the seed is revealed.
CohortAllocation checkedAllocation(StudyRepository& study, const CohortId& cohortId) {
  const std::vector<LockedDesign> designs = study.designs(cohortId);
  CohortAllocation shown;
  if (designs.empty()) {
    return shown;
  }
  const LockedDesign& stored = designs.back();
  shown.method = stored.algorithm;
  shown.version = stored.algorithmVersion;
  shown.generator = stored.generator;
  shown.commitment = stored.seedCommitment;
  shown.sealed = stored.seed.empty();
  shown.lockedUtc_us = stored.lockedUtc_us;
  const std::vector<AllocationEntry> records = study.allocations(stored.id);
  const std::vector<Enrolment> enrolments = study.enrolments(cohortId);
  shown.enrolledBeforeLock = std::count_if(enrolments.begin(), enrolments.end(), [&](const Enrolment& one) {
    return one.enrolledUtc_us <= stored.lockedUtc_us;
  });
  for (const AllocationEntry& record : records) {
    shown.allocatedBeforeLock += record.allocatedUtc_us < stored.lockedUtc_us ? 1 : 0;
    shown.movedByHand += record.overrideReason.empty() ? 0 : 1;
  }
  const auto [end, error] =
      std::from_chars(stored.seed.data(), stored.seed.data() + stored.seed.size(), shown.seed);
  if (error != std::errc() || end != stored.seed.data() + stored.seed.size()) {
    return shown;
  }

  shown.replayed = repeatedDraw(study, stored, stored.seed, stored.salt).sound;
  return shown;
}

std::string loginOf(Connection& connection, const std::string& user) {
  for (const UserAccount& one : AccessRepository(connection).users()) {
    if (one.id.text() == user) {
      return one.login;
    }
  }
  return user;
}

/// Returns where a cohort came from that was imported before schema 3, as the audit trail says.
std::optional<CohortOrigin> olderOriginOf(Connection& connection, const CohortId& cohortId) {
  const std::vector<AuditEntry> entries =
      AuditRepository(connection).entries({.objectKind = AuditObject::kCohort, .objectId = cohortId.text()});
  const auto found = std::find_if(entries.begin(), entries.end(), [](const AuditEntry& entry) {
    return entry.action == storedText(AuditAction::kTrialImport);
  });
  if (found == entries.end()) {
    return std::nullopt;
  }
  const nlohmann::json what = nlohmann::json::parse(found->newJson, nullptr, false);
  CohortOrigin origin;
  origin.importedBy = loginOf(connection, found->actor);
  origin.importedUtc_us = found->atUtc_us;
  if (what.is_object()) {
    origin.layout = what.value("layout", "");
    origin.source = what.value("source", "");
    origin.contentHash = what.value("hash", "");
  }
  return origin;
}

/// Returns where an imported cohort came from; empty: it was made here.
std::optional<CohortOrigin> originOf(Connection& connection, const CohortId& cohortId) {
  const std::vector<StudyImport> imports = StudyRepository(connection).imports(cohortId);
  if (imports.empty()) {
    return olderOriginOf(connection, cohortId);
  }
  const StudyImport& import = imports.front();
  CohortOrigin origin{.layout = import.layout,
                      .source = import.source,
                      .contentHash = import.contentHash,
                      .importedBy = loginOf(connection, import.importedBy),
                      .importedUtc_us = import.importedUtc_us,
                      .signedBy = import.signedBy};
  const nlohmann::json earlier = nlohmann::json::parse(import.earlierJson, nullptr, false);
  if (earlier.is_array()) {
    for (const nlohmann::json& step : earlier) {
      if (step.is_object()) {
        origin.earlier.push_back(step.value("source", "") + " (" + step.value("layout", "") + ")");
      }
    }
  }
  for (const SubmittedMark& mark : RatingRepository(connection).marks(cohortId)) {
    origin.marks += mark.importId.empty() ? 0 : 1;
  }
  origin.recordings = StudyRepository(connection).importedTrials(cohortId);
  return origin;
}

/// Returns the planned minutes in phases of one kind.
double plannedMinutes(const StudyArm& arm, PhaseKind kind) {
  double minutes = 0.0;
  for (const TrainingPhase& phase : arm.phases) {
    minutes += phase.kind == kind ? static_cast<double>(phase.duration_us) / kMinute_us : 0.0;
  }
  return minutes;
}

/// Adds the groups with their arms' plans.
void addGroups(Connection& connection, const CohortId& cohortId, const std::vector<StudyGroup>& groups,
               CohortInputs& inputs) {
  const CurriculumVersionId versionId = StudyRepository(connection).cohort(cohortId).curriculumVersionId;
  const std::optional<CurriculumVersion> version =
      versionId.empty() ? std::nullopt : CurriculumRepository(connection).version(versionId);
  for (const StudyGroup& group : groups) {
    CohortGroup shown{
        Text::tr("Group %1", group.number), group.label, std::nullopt, std::nullopt, group.code, {}};
    if (version) {
      for (const StudyArm& arm : version->arms) {
        if (arm.id == group.armId) {
          shown.plannedVirtual_min = plannedMinutes(arm, PhaseKind::kVirtual);
          shown.plannedReal_min = plannedMinutes(arm, PhaseKind::kReal);
          shown.arm = arm.label;
        }
      }
    }
    inputs.groups.push_back(std::move(shown));
  }
}

/// Adds training times, rests and deviations.
void addTimes(StudyRepository& study, const CohortId& cohortId, CohortInputs& inputs) {
  std::map<std::string, std::string> codeOf;
  for (const Enrolment& enrolment : study.enrolments(cohortId)) {
    codeOf[enrolment.id] = enrolment.traineeCode;
  }
  std::map<std::string, CohortDose> doses;
  for (const Exposure& exposure : study.exposures(cohortId)) {
    CohortDose& dose = doses[codeOf[exposure.enrolmentId]];
    const double minutes = static_cast<double>(exposure.duration_us) / kMinute_us;
    (exposure.kind == ExposureKind::kRest   ? dose.rest_min
     : exposure.kind == ExposureKind::kReal ? dose.real_min
                                            : dose.virtual_min) += minutes;
  }
  for (auto& [code, dose] : doses) {
    dose.trainee = code;
    inputs.rests += dose.rest_min > 0.0 ? 1 : 0;
    inputs.doses.push_back(std::move(dose));
  }
  for (const ProtocolDeviation& deviation : study.deviations(cohortId)) {
    inputs.deviations.push_back(
        {deviation.happenedUtc_us,
         deviation.enrolmentId.empty() ? std::string() : codeOf[deviation.enrolmentId], deviation.kind,
         deviation.description, deviation.id});
  }
}

/// Converts a scoring sheet to points and texts.
ReportedSheet reported(const RubricRevision& revision, const std::string& name) {
  ReportedSheet sheet{name, revision.number, {}};
  for (const RubricLine& line : revision.rows) {
    ReportedCriterion criterion{line.code,
                                line.label,
                                pointsFromSteps(line.scale.lo, line.scale),
                                pointsFromSteps(line.scale.hi, line.scale),
                                static_cast<double>(line.weight_milli) / 1000.0,
                                {}};
    for (const RubricAnchor& anchor : line.anchors) {
      criterion.anchors.push_back({pointsFromSteps(anchor.score_steps, line.scale), anchor.meaning});
    }
    sheet.criteria.push_back(std::move(criterion));
  }
  return sheet;
}

/// Adds the sheets behind the latest marks, and their criteria.
void addCriteria(Connection& connection, const CohortId& cohortId, const TrainingResult& training,
                 const std::vector<StudyGroup>& groups, CohortInputs& inputs) {
  const RubricRepository rubrics(connection);
  std::map<RubricId, std::string> names;
  for (const Rubric& rubric : rubrics.rubrics()) {
    names[rubric.id] = rubric.name;
  }
  std::map<RubricRevisionId, std::size_t> sheetOf;
  std::map<std::pair<std::size_t, std::string>, std::pair<std::size_t, ScoreScale>> criterionOf;
  const auto sheetFor = [&](const RubricRevisionId& id) {
    const auto [known, added] = sheetOf.try_emplace(id, inputs.sheets.size());
    if (added) {
      const RubricRevision revision = rubrics.revision(id).value();
      for (std::size_t i = 0; i < revision.rows.size(); ++i) {
        criterionOf[{known->second, revision.rows[i].code}] = {i, revision.rows[i].scale};
      }
      inputs.sheets.push_back(reported(revision, names[revision.rubricId]));
      inputs.sheets.back().id = id;
    }
    return known->second;
  };
  const std::map<MarkId, std::vector<MarkRow>> answers = RatingRepository(connection).criteria(cohortId);
  for (const SubmittedMark& mark : training.submitted) {
    const auto rows = answers.find(mark.id);
    const std::optional<std::size_t> occasion = training.occasions.positionOf(mark.occasionCode);
    if (rows == answers.end() || mark.groupCode.empty() || !occasion) {
      continue;
    }
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const StudyGroup& one) { return one.code == mark.groupCode; });
    const std::size_t first = inputs.criterionMarks.size();
    for (const MarkRow& row : rows->second) {
      CriterionMark one{.trainee = mark.traineeCode,
                        .rater = mark.raterCode,
                        .group = static_cast<std::size_t>(group - groups.begin()),
                        .occasion = *occasion,
                        .sheet = sheetFor(row.rubricRevisionId),
                        .mark = mark.id};
      const auto& [criterion, scale] = criterionOf.at({one.sheet, row.rowCode});
      one.criterion = criterion;
      if (row.score_steps) {
        one.points = pointsFromSteps(*row.score_steps, scale);
      }
      inputs.criterionMarks.push_back(std::move(one));
    }
    std::sort(inputs.criterionMarks.begin() + static_cast<std::ptrdiff_t>(first), inputs.criterionMarks.end(),
              [](const CriterionMark& a, const CriterionMark& b) { return a.criterion < b.criterion; });
  }
}

/// Returns the class of Fig. 18: the chief physicians, or the class with the highest weight if there are
/// none.
std::size_t chiefClassOf(const EvaluationInstrument& instrument) {
  std::size_t most = 0;
  for (std::size_t c = 0; c < instrument.classes.size(); ++c) {
    if (instrument.classes[c].id == kChiefClass) {
      return c;
    }
    most = instrument.classes[c].weight_milli > instrument.classes[most].weight_milli ? c : most;
  }
  return most;
}

/// Returns the newest entry of the audit trail about an object with one of these actions.
std::optional<AuditEntry> newestOf(Connection& connection, AuditObject kind, const std::string& id,
                                   std::initializer_list<AuditAction> actions) {
  for (AuditEntry& entry : AuditRepository(connection).entries({.objectKind = kind, .objectId = id})) {
    if (std::any_of(actions.begin(), actions.end(),
                    [&](AuditAction action) { return entry.action == storedText(action); })) {
      return std::move(entry);
    }
  }
  return std::nullopt;
}

/// Returns whether another rater was asked in place of a withdrawn sheet's.
bool wasReassigned(Connection& connection, const AssignmentId& id) {
  const auto entry = newestOf(connection, AuditObject::kAssignment, id.text(),
                              {AuditAction::kAssignmentReassign, AuditAction::kAssignmentWithdraw});
  return entry && entry->action == storedText(AuditAction::kAssignmentReassign);
}

/// Returns when the state of an enrolment was last changed; 0: never.
std::int64_t lastStateChange_us(Connection& connection, const EnrolmentId& id) {
  const auto entry =
      newestOf(connection, AuditObject::kEnrolment, id.text(), {AuditAction::kEnrolmentSetState});
  return entry ? entry->atUtc_us : 0;
}

}  // namespace

Text sentenceOf(const SheetCount& sheets) {
  const Text in = Text::tr("%1 of %2 {sheet|sheets} that raters were asked for {is|are} in", sheets.submitted,
                           sheets.asked);
  return sheets.dropped == 0 ? in
                             : Text::tr("%1; %2 {was|were} withdrawn and not reassigned", in, sheets.dropped);
}

SheetCount countSheets(Connection& connection, const CohortId& cohortId) {
  std::set<EnrolmentId> left;
  for (const Enrolment& enrolment : StudyRepository(connection).enrolments(cohortId)) {
    if (enrolment.state == EnrolmentState::kWithdrawn) {
      left.insert(enrolment.id);
    }
  }
  SheetCount count;
  for (const AssignmentStatus& sheet : SheetRepository(connection).assignments(cohortId)) {
    const bool withdrawn = sheet.state == SheetState::kWithdrawn;
    if (withdrawn &&
        (left.contains(sheet.assignment.enrolmentId) || wasReassigned(connection, sheet.assignment.id))) {
      continue;
    }
    ++count.asked;
    count.submitted += sheet.state == SheetState::kSubmitted ? 1 : 0;
    count.dropped += withdrawn ? 1 : 0;
  }
  return count;
}

CohortInputs cohortInputs(Connection& connection, const CohortId& cohortId, const CampaignResult& campaign,
                          const TrainingResult& training) {
  StudyRepository study(connection);
  CohortInputs inputs;
  if (const auto centre = study.centre()) {
    inputs.centre = centre->name;
  }
  inputs.imported = originOf(connection, cohortId);
  inputs.softwareVersion = softwareVersion();
  inputs.programHash = programHash();
  inputs.equivalenceMargin = study.cohort(cohortId).equivalenceMargin;
  inputs.statements = study.statements(cohortId);
  const std::vector<StudyGroup> groups = study.groups(cohortId);
  addGroups(connection, cohortId, groups, inputs);
  std::map<std::string, Trainee> trainees;
  for (Trainee& trainee : PeopleRepository(connection).trainees()) {
    trainees[trainee.person.code] = trainee;
  }
  for (const Enrolment& enrolment : study.enrolments(cohortId)) {
    const Person& person = trainees.at(enrolment.traineeCode).person;
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const StudyGroup& g) { return g.code == enrolment.groupCode; });
    if (group == groups.end()) {  // not allocated yet: excluded from the comparison
      inputs.notAllocated += enrolment.state == EnrolmentState::kWithdrawn ? 0 : 1;
      continue;
    }
    const bool withdrew = enrolment.state == EnrolmentState::kWithdrawn;
    inputs.trainees.push_back({person.code, static_cast<std::size_t>(group - groups.begin()), person.sex,
                               person.level, withdrew, enrolment.enrolledUtc_us,
                               withdrew ? lastStateChange_us(connection, enrolment.id) : 0});
  }
  inputs.allocation = checkedAllocation(study, cohortId);

  inputs.instrument = campaign.campaign.instrument;
  if (!campaign.classesMissing.empty()) {
    inputs.unfinishedEvaluation = {static_cast<std::int64_t>(campaign.ratings.size()),
                                   campaign.classesMissing, campaign.unscored};
  }
  if (!campaign.ratings.empty()) {  // without an evaluation there is no instrument
    inputs.ratings = groupRatings(inputs.instrument, campaign.ratings);
    inputs.chiefClass = chiefClassOf(inputs.instrument);
  }
  inputs.evaluations = campaign.models;
  const auto positionOf = [&](const std::string& code) {
    return std::find_if(campaign.campaign.models.begin(), campaign.campaign.models.end(),
                        [&](const CampaignModel& m) { return m.code == code; });
  };
  std::stable_sort(inputs.ratings.begin(), inputs.ratings.end(),
                   [&](const ModelRatings& a, const ModelRatings& b) {
                     return positionOf(a.model) < positionOf(b.model);
                   });

  inputs.trainingScale = training.scale;
  inputs.occasions = occasionTexts(training.occasions);
  inputs.scores = training.trainees;
  inputs.summaries = training.groups;
  inputs.trainingMarks = training.marks;
  inputs.notAssessable = training.notAssessable;
  inputs.markWays = training.ways;
  const SheetCount sheets = countSheets(connection, cohortId);
  inputs.sheetsAsked = sheets.asked;
  inputs.sheetsPresent = sheets.submitted;
  addCriteria(connection, cohortId, training, groups, inputs);
  inputs.evaluationRatersAsked = std::ssize(campaign.campaign.raters);
  for (const CampaignModel& model : campaign.campaign.models) {
    inputs.modelsHidden += !model.hiddenLabel.empty() && model.hiddenLabel != model.code ? 1 : 0;
  }
  addTimes(study, cohortId, inputs);
  std::set<std::string> raters;
  for (const TrainingMark& mark : training.marks) {
    raters.insert(mark.rater);
  }
  inputs.trainingRaters = raters.size();
  return inputs;
}

}  // namespace torsio
