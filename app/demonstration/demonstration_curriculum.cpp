// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/demonstration/demonstration_curriculum.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/study/curriculum_content.h"
#include "app/study/curriculum_ids.h"
#include "assessment/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/base/error.h"
#include "sim/base/ids.h"

namespace torsio {

namespace {

constexpr const char* kTemplate = "paper-three-arms";
constexpr std::uint64_t kCurriculumStream = 0x63'7572'7269'6375ULL;
constexpr std::uint64_t kExposureStream = 0x65'7870'6f73'75ULL;

CurriculumTemplate templateOf(const std::filesystem::path& assets, const std::string& templateId) {
  for (CurriculumTemplate& found : curriculumTemplates(assets)) {
    if (found.id == templateId) {
      return std::move(found);
    }
  }
  throw Error(ErrorCode::kFileMissing, Text::tr("there is no such curriculum"), templateId,
              Text::tr("Repair the installation"));
}

/// What the simulated trainees twist, in place of the template's own exercise.
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

DemonstrationPlace demonstrationPlace(const CurriculumVersion& curriculum, std::size_t group,
                                      const std::string& phaseLabel) {
  for (const TrainingPhase& phase : curriculum.arms.at(group).phases) {
    if (phase.label == phaseLabel) {
      return {phase.moduleId, phase.id};
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
    std::int64_t at_us = utc_us;
    const auto spend = [&](const PhaseId& phaseId, ExposureKind kind, std::int64_t duration_us) {
      exposures.push_back(
          {ids.newUuid(), trainee.enrolmentId, phaseId, kind, at_us, duration_us, kDemonstrationName, true});
      at_us += duration_us;
    };
    for (std::size_t i = 0; i < arm.phases.size(); ++i) {
      if (i == 1 && trainee.number % 2 == 0 && arm.restAllowance_us > 0) {
        spend("", ExposureKind::kRest, arm.restAllowance_us);
      }
      spend(arm.phases[i].id, exposureIn(arm.phases[i].kind), arm.phases[i].duration_us);
    }
  }
  StudyRepository(connection).addExposures(exposures);
}

Text demonstrationTimeRule() {
  return Text::tr(
      "The times of training are those of the protocol, in full; every second trainee of a group takes the "
      "whole rest between the two halves.");
}

}  // namespace torsio
