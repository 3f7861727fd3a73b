// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/demonstration/demonstration_curriculum.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/services/study/curriculum_content.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
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

}  // namespace torsio
