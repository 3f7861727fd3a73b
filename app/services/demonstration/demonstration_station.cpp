// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/demonstration/demonstration_station.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/services/demonstration/demonstration_curriculum.h"
#include "app/services/recording/recorded_run.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr const char* kStationTemplate = "first-steps";
constexpr double kAttempt_s = 20.0;
constexpr std::int64_t kBetween_us = 600'000'000;
constexpr std::size_t kFirstAttempts = 10;
constexpr std::size_t kSecondAttempts = 4;
constexpr double kPractisedPerAttempt_min = 2.0;
constexpr std::uint64_t kPersonSeed = 4;

/// Records simulated attempts at one module; returns the last trial.
std::string recordAttempts(Connection& connection, IdSource& ids, const std::filesystem::path& assets,
                           const TrainingModule& module, const EnrolmentId& enrolmentId,
                           const std::string& traineeCode, std::size_t count, double practised_min,
                           std::int64_t& utc_us) {
  SceneRequest request;
  request.assets = assets;
  request.id = module.sceneId;
  request.pattern = module.patternId;
  const Scene scene = loadScene(request);
  std::string last;
  std::vector<Exposure> exposures;
  for (std::size_t i = 0; i < count; ++i) {
    ScriptedTrial trial;
    last = ids.newUuid();
    trial.recording = {.trialId = last,
                       .traineeCode = traineeCode,
                       .phaseLabel = module.title,
                       .startedUtc_us = utc_us,
                       .demonstration = true,
                       .context = {.station = kDemonstrationName,
                                   .enrolmentId = enrolmentId,
                                   .moduleId = module.id,
                                   .attemptMode = module.mode}};
    trial.personSeed = kPersonSeed;
    trial.trialSeed = kPersonSeed + 17 * i + static_cast<std::uint64_t>(practised_min);
    trial.duration_s = kAttempt_s;
    trial.practisedBefore_min = practised_min + kPractisedPerAttempt_min * static_cast<double>(i);
    TrialRepository sink(connection, trial.recording.context);
    recordScriptedTrial(scene, trial, sink);
    exposures.push_back({.id = ids.newUuid(),
                         .enrolmentId = enrolmentId,
                         .kind = ExposureKind::kVirtual,
                         .startedUtc_us = utc_us,
                         .duration_us = std::llround(kAttempt_s * 1e6),
                         .recordedBy = kDemonstrationName,
                         .demonstration = true});
    utc_us += kBetween_us;
  }
  StudyRepository(connection).addExposures(exposures);
  return last;
}

void addRemark(Connection& connection, IdSource& ids, const TrialId& trialId, std::int64_t utc_us) {
  const std::vector<Rater> raters = PeopleRepository(connection).raters();
  const auto chief =
      std::find_if(raters.begin(), raters.end(), [](const Rater& r) { return r.classCode == "chief"; });
  if (chief == raters.end()) {
    return;
  }
  RemarkRepository(connection)
      .add({.id = ids.newUuid(),
            .trialId = trialId,
            .author = chief->person.id,
            .authorPersonId = chief->person.id,
            .purpose = "remark",
            .tick = 4'500,
            .time_us = 4'500'000,
            .text = "Good grip. Slow down in the last ten degrees, then you need no correction.",
            .createdUtc_us = utc_us,
            .demonstration = true});
}

/// Returns the stored cohort name; displayed in the window's language.
Text cohortOfStation() {
  return Text::tr("First steps (demonstration)");
}

}  // namespace

DemonstrationStation storeDemonstrationStation(Connection& connection, IdSource& ids,
                                               const std::filesystem::path& assets, std::int64_t utc_us) {
  DemonstrationStation station;
  StudyRepository studies(connection);
  PeopleRepository people(connection);
  std::vector<Trainee> trainees = people.trainees();
  std::erase_if(trainees, [](const Trainee& t) { return !t.person.demonstration; });
  if (trainees.empty()) {
    refuse(Text::tr("there are no simulated trainees"), Text::tr("demonstration"),
           Text::tr("Make the demonstration people first"));
  }
  const Person& person = trainees.front().person;
  station.personId = person.id;
  for (const Cohort& cohort : studies.cohorts()) {
    if (cohort.name != cohortOfStation().str()) {
      continue;
    }
    station.cohortId = cohort.id;
    const auto version = CurriculumRepository(connection).version(cohort.curriculumVersionId);
    if (version && !version->modules.empty()) {
      station.firstModuleId = version->modules.front().id;
    }
    for (const TrialListing& trial : TrialRepository(connection).list({.traineeCode = person.code})) {
      const bool own = trial.station == kDemonstrationName && !trial.moduleId.empty();
      if (own && station.newestTrialId.empty()) {
        station.newestTrialId = trial.trialId;
      }
    }
    return station;
  }
  Transaction transaction(connection);
  const CurriculumVersion version =
      storeDemonstrationTemplate(connection, ids, assets, kStationTemplate, {}, utc_us);
  station.cohortId = ids.newUuid();
  station.firstModuleId = version.modules.front().id;
  // After the other cohorts of the demonstration, whatever their times.
  std::int64_t newest_us = utc_us;
  for (const Cohort& cohort : studies.cohorts()) {
    newest_us = std::max(newest_us, cohort.createdUtc_us + 1);
  }
  studies.addCohort({station.cohortId, cohortOfStation().str(),
                     "A simulated trainee on the way through the first steps", newest_us, true},
                    {});
  CurriculumRepository(connection).assign(station.cohortId, version.id);
  const Enrolment enrolment{.id = ids.newUuid(),
                            .cohortId = station.cohortId,
                            .traineeId = person.id,
                            .enrolledUtc_us = utc_us,
                            .demonstration = true};
  studies.enrol({&enrolment, 1});
  people.recordConsent({.personId = person.id,
                        .purpose = "training_record",
                        .granted = true,
                        .textVersion = kDemonstrationName,
                        .decidedUtc_us = utc_us,
                        .recordedBy = kDemonstrationName,
                        .demonstration = true});
  std::int64_t at_us = utc_us - static_cast<std::int64_t>(kFirstAttempts + kSecondAttempts + 1) * kBetween_us;
  station.newestTrialId = recordAttempts(connection, ids, assets, version.modules.front(), enrolment.id,
                                         person.code, kFirstAttempts, 0.0, at_us);
  if (version.modules.size() > 1) {
    station.newestTrialId =
        recordAttempts(connection, ids, assets, version.modules[1], enrolment.id, person.code,
                       kSecondAttempts, kPractisedPerAttempt_min * kFirstAttempts, at_us);
  }
  addRemark(connection, ids, station.newestTrialId, at_us);
  transaction.commit();
  return station;
}

}  // namespace torsio
