// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/demonstration/demonstration_curriculum.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "app/services/study/curriculum_content.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr const char* kTemplate = "paper-three-arms";
constexpr std::uint64_t kCurriculumStream = 0x63'7572'7269'6375ULL;
constexpr std::uint64_t kExposureStream = 0x65'7870'6f73'75ULL;
constexpr std::int64_t kStudyHour_us = 3'600'000'000;
constexpr std::int64_t kStudyDay_us = 24 * kStudyHour_us;
constexpr std::int64_t kTraineesADay = 6;

bool rests(const DemonstrationTrainee& trainee) {
  return trainee.number % 2 == 0;
}

CurriculumTemplate templateOf(const std::filesystem::path& assets, const std::string& templateId) {
  for (CurriculumTemplate& found : curriculumTemplates(assets)) {
    if (found.id == templateId) {
      return std::move(found);
    }
  }
  throw Error(ErrorCode::kFileMissing, Text::tr("there is no such curriculum"), templateId,
              Text::tr("Repair the installation"));
}

/// Replaces the template's exercise by the one that the simulated trainees do.
void fitTo(TrainingModule& module, const Scene& training) {
  module.title = training.title + ": " + training.pattern.title;
  module.sceneId = training.id;
  module.patternId = training.pattern.id;
  module.targetAngle_rad = training.pattern.targetAngle_rad;
  module.tolerance_rad = training.pattern.tolerance_rad;
  module.maxForce_N = training.pattern.forceLimit_N;
  module.maxTorque_Nm = training.pattern.torqueLimit_Nm;
}

}  // namespace

CurriculumVersion storeDemonstrationCurriculum(Connection& connection, const DemonstrationStudy& study,
                                               const Scene& training, const std::filesystem::path& assets,
                                               std::uint64_t seed, std::int64_t utc_us) {
  SeededIdSource ids(seed ^ kCurriculumStream);
  const CurriculumTemplate paper = templateOf(assets, kTemplate);
  const CurriculumId id = ids.newUuid();
  CurriculumRepository curricula(connection);
  curricula.addCurriculum({id, paper.title + " (demonstration)", paper.description, utc_us, true});
  CurriculumVersion version = paper.content;
  version.id = ids.newUuid();
  version.curriculumId = id;
  version.note = "as the demonstration followed it";
  version.createdUtc_us = utc_us;
  fitTo(version.modules.front(), training);
  version = withIds(std::move(version), ids);
  curricula.addVersion(version, kDemonstrationName);
  curricula.moveTo(version.id, CurriculumState::kRunning, kDemonstrationName, utc_us);
  curricula.assign(study.cohortId, version.id);
  return version;
}

CurriculumVersion storeDemonstrationTemplate(Connection& connection, IdSource& ids,
                                             const std::filesystem::path& assets,
                                             const std::string& templateId, std::vector<StudyArm> arms,
                                             std::int64_t utc_us) {
  const CurriculumTemplate found = templateOf(assets, templateId);
  CurriculumRepository curricula(connection);
  const CurriculumId id = ids.newUuid();
  curricula.addCurriculum({id, found.title + " (demonstration)", found.description, utc_us, true});
  CurriculumVersion version = found.content;
  version.id = ids.newUuid();
  version.curriculumId = id;
  version.createdUtc_us = utc_us;
  version.arms = std::move(arms);
  version.plannedOccasions.clear();
  version = withIds(std::move(version), ids);
  curricula.addVersion(version, kDemonstrationName);
  curricula.moveTo(version.id, CurriculumState::kRunning, kDemonstrationName, utc_us);
  return version;
}

std::vector<DemonstrationTrainee> inOrderOfComing(std::vector<DemonstrationTrainee> trainees) {
  std::sort(trainees.begin(), trainees.end(),
            [](const DemonstrationTrainee& a, const DemonstrationTrainee& b) {
              return std::pair(a.number, a.group) < std::pair(b.number, b.group);
            });
  return trainees;
}

std::vector<std::int64_t> demonstrationTimes(const CurriculumVersion& curriculum,
                                             const DemonstrationTrainee& trainee, std::int64_t utc_us) {
  const StudyArm& arm = curriculum.arms.at(trainee.group);
  const auto turn = static_cast<std::int64_t>((trainee.number - 1) * curriculum.arms.size() + trainee.group);
  std::int64_t at_us = utc_us + turn / kTraineesADay * kStudyDay_us + turn % kTraineesADay * kStudyHour_us;
  std::vector<std::int64_t> times;
  for (std::size_t i = 0; i < arm.phases.size(); ++i) {
    if (i == 1 && rests(trainee)) {
      at_us += arm.restAllowance_us;
    }
    times.push_back(at_us);
    at_us += arm.phases[i].duration_us;
  }
  times.push_back(at_us);
  return times;
}

DemonstrationPlace demonstrationPlace(const CurriculumVersion& curriculum,
                                      const DemonstrationTrainee& trainee, const std::string& phaseLabel,
                                      std::int64_t utc_us) {
  const std::vector<TrainingPhase>& phases = curriculum.arms.at(trainee.group).phases;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (phases[i].label == phaseLabel) {
      return {phases[i].moduleId, phases[i].id, demonstrationTimes(curriculum, trainee, utc_us).at(i)};
    }
  }
  return {};
}

void storeDemonstrationExposures(Connection& connection, const DemonstrationStudy& study,
                                 const CurriculumVersion& curriculum, std::uint64_t seed,
                                 std::int64_t utc_us) {
  SeededIdSource ids(seed ^ kExposureStream);
  std::vector<Exposure> exposures;
  for (const DemonstrationTrainee& trainee : study.trainees) {
    const StudyArm& arm = curriculum.arms.at(trainee.group);
    const std::vector<std::int64_t> times = demonstrationTimes(curriculum, trainee, utc_us);
    const auto spend = [&](const PhaseId& phaseId, ExposureKind kind, std::int64_t at_us,
                           std::int64_t duration_us) {
      exposures.push_back(
          {ids.newUuid(), trainee.enrolmentId, phaseId, kind, at_us, duration_us, kDemonstrationName, true});
    };
    for (std::size_t i = 0; i < arm.phases.size(); ++i) {
      if (i == 1 && rests(trainee) && arm.restAllowance_us > 0) {
        spend("", ExposureKind::kRest, times[i] - arm.restAllowance_us, arm.restAllowance_us);
      }
      spend(arm.phases[i].id, exposureIn(arm.phases[i].kind), times[i], arm.phases[i].duration_us);
    }
  }
  StudyRepository(connection).addExposures(exposures);
}

Text demonstrationTimeRule() {
  return Text::tr(
      "The times of training are those of the protocol, in full: one trainee an hour, six a day; every "
      "second "
      "trainee of a group takes the whole rest between the two halves.");
}

namespace {

constexpr const char* kVolvulusTemplate = "volvulus";
constexpr const char* kGroupCode = "G1";
constexpr const char* kGroupLabel = "untwisting";
constexpr std::uint64_t kUntwistingStream = 0x75'6e74'7769'7374ULL;
constexpr std::int64_t kBetweenAttempts_us = 600'000'000;

/// A trainee's planned attempt, with its deliberate mistake.
struct PlannedUntwisting {
  std::size_t group;
  std::size_t number;  ///< within the group
  const char* module;
  double practisedBefore_min;
  std::size_t turnsLeftOut = 0;
  std::optional<double> closure{};
};

/// Jaw closure that presses the thin wall of the small bowel with 400 kPa: a bruise, no tear
/// (assets/scenes/small-bowel-loop.json: 6 N on 15 mm2, limits of the healthy wall 330 and 660 kPa).
constexpr double kTooTight = 1.0;

constexpr std::array<PlannedUntwisting, 7> kPlan{{{0, 1, "B1", 0.0},
                                                  {0, 1, "G1", 20.0},
                                                  {0, 2, "B1", 0.0, 1},
                                                  {0, 2, "B1", 20.0},
                                                  {1, 1, "B1", 0.0, 0, kTooTight},
                                                  {1, 3, "B1", 20.0},
                                                  {1, 3, "G1", 40.0, 1}}};

const DemonstrationTrainee& traineeOf(const DemonstrationStudy& study, const PlannedUntwisting& plan) {
  return *std::find_if(study.trainees.begin(), study.trainees.end(), [&](const DemonstrationTrainee& one) {
    return one.group == plan.group && one.number == plan.number;
  });
}

const TrainingModule& moduleOf(const CurriculumVersion& version, const std::string& code) {
  return *std::find_if(version.modules.begin(), version.modules.end(),
                       [&](const TrainingModule& module) { return module.code == code; });
}

/// Stores the cohort with its single group; returns enrolments by trainee code.
std::map<std::string, EnrolmentId> storeCohort(Connection& connection, IdSource& ids,
                                               const DemonstrationStudy& study,
                                               const CurriculumVersionId& versionId, std::int64_t utc_us) {
  StudyRepository studies(connection);
  const CohortId cohortId = ids.newUuid();
  const StudyGroup group{ids.newUuid(), cohortId, 1, kGroupCode, kGroupLabel};
  studies.addCohort({cohortId, std::string(Text::tr("Volvulus and torsion (demonstration)").english()),
                     "Simulated trainees who untwist organs that come twisted", utc_us + 1, true},
                    {&group, 1});
  CurriculumRepository(connection).assign(cohortId, versionId);
  std::map<std::string, TraineeId> people;
  for (const Trainee& trainee : PeopleRepository(connection).trainees()) {
    people[trainee.person.code] = trainee.person.id;
  }
  std::map<std::string, EnrolmentId> placed;
  std::vector<Enrolment> enrolments;
  for (const PlannedUntwisting& plan : kPlan) {
    const std::string& code = traineeOf(study, plan).code;
    if (placed.contains(code)) {
      continue;
    }
    const Enrolment enrolment{.id = ids.newUuid(),
                              .cohortId = cohortId,
                              .traineeId = people.at(code),
                              .groupId = group.id,
                              .numberInGroup = std::ssize(enrolments) + 1,
                              .enrolledUtc_us = utc_us,
                              .demonstration = true};
    placed[code] = enrolment.id;
    enrolments.push_back(enrolment);
  }
  studies.enrol(enrolments);
  return placed;
}

}  // namespace

std::vector<DemonstrationUntwisting> storeDemonstrationUntwisting(Connection& connection,
                                                                  const DemonstrationStudy& study,
                                                                  const std::filesystem::path& assets,
                                                                  std::uint64_t seed, std::int64_t utc_us) {
  SeededIdSource ids(seed ^ kUntwistingStream);
  StudyArm arm;
  arm.code = kGroupCode;
  arm.label = kGroupLabel;
  const CurriculumVersion version =
      storeDemonstrationTemplate(connection, ids, assets, kVolvulusTemplate, {arm}, utc_us);
  const std::map<std::string, EnrolmentId> enrolments =
      storeCohort(connection, ids, study, version.id, utc_us);
  std::vector<DemonstrationUntwisting> all;
  for (const PlannedUntwisting& plan : kPlan) {
    const DemonstrationTrainee& trainee = traineeOf(study, plan);
    const TrainingModule& module = moduleOf(version, plan.module);
    DemonstrationUntwisting one{
        .group = plan.group, .sceneId = module.sceneId, .patternId = module.patternId};
    one.trial.recording = {.trialId = ids.newUuid(),
                           .traineeCode = trainee.code,
                           .phaseLabel = module.title,
                           .startedUtc_us = utc_us + std::ssize(all) * kBetweenAttempts_us,
                           .demonstration = true,
                           .context = {.station = kDemonstrationName,
                                       .enrolmentId = enrolments.at(trainee.code),
                                       .moduleId = module.id,
                                       .attemptMode = module.mode}};
    one.trial.personSeed = seed + 1000 * (plan.group * 10 + plan.number);
    one.trial.trialSeed = one.trial.personSeed + 100 + all.size();
    one.trial.practisedBefore_min = plan.practisedBefore_min;
    one.trial.turnsLeftOut = plan.turnsLeftOut;
    one.trial.closure = plan.closure;
    all.push_back(std::move(one));
  }
  return all;
}

Text demonstrationUntwistingRule() {
  return Text::tr(
      "Four trainees also untwist organs that come twisted, as a cohort of their own that follows the "
      "curriculum "
      "\"Volvulus and torsion: untwist it\". Two of these hands stop a turn too early and one closes the jaw "
      "too "
      "tightly, by design.");
}

}  // namespace torsio
