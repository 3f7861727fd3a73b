// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/training_centre.h"

#include <stdexcept>

#include "app/services/recording/recorded_run.h"
#include "assessment/domain/ids.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/angle.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {

namespace {

constexpr const char* kTrainingPassword = "a long enough password";

TrainingModule moduleOf(const std::string& id, const std::string& code, const std::string& mode,
                        std::int64_t inARow, const TrainingCentre::Setup& setup) {
  TrainingModule module;
  module.id = id;
  module.code = code;
  module.title = "Quarter turn, " + code;
  module.sceneId = setup.sceneId;
  module.patternId = setup.patternId;
  module.mode = fromStoredText<AttemptMode>(mode).value();
  module.targetAngle_rad = trainingBar().pattern.targetAngle_rad;
  module.tolerance_rad = radians(5.0);
  module.maxForce_N = 6.0;  // a quarter turn of the bar needs 4 N; the device saturates at 3.3 N
  module.leastTwists = setup.leastTwists;
  module.hold_us = setup.hold_us;
  module.mastery = setup.mastery;
  if (module.mastery.empty()) {
    module.mastery.push_back(
        {.metric = "twist.on_target", .threshold = 0.5, .unit = "1", .consecutive = inARow});
  }
  return module;
}

}  // namespace

const Scene& trainingBar() {
  static const Scene kBar = barScene();
  return kBar;
}

DeviceReadiness deviceWith(Light light) {
  DeviceReadiness readiness;
  readiness.device = Text::verbatim("Scripted hand");
  readiness.haptic = true;  // as if it had motors
  readiness.findings.push_back({"connected", light, Text::verbatim("scripted"), ""});
  return readiness;
}

TrainingCentre::TrainingCentre(const Setup& setup) : TestRecord(20251121) {
  fill(setup);
  become("T-01");
}

TrainingCentre::TrainingCentre(const std::filesystem::path& folder) : TestRecord(folder) {}

void TrainingCentre::fill(const Setup& setup) {
  PeopleRepository people(connection());
  StudyRepository studies(connection());
  studies.setCentre({ids().newUuid(), "Skills laboratory", now_us(), false});
  addChiefClass("chief physician");
  const std::vector<TraineeId> trainees{addTrainee("T-01", setup.simulated),
                                        addTrainee("T-02", setup.simulated)};
  const RaterId chief = addChief("R-01");
  addUser("T-01", trainees[0], "trainee", kTrainingPassword);
  addUser("T-02", trainees[1], "trainee", kTrainingPassword);
  addUser("chief", chief, "rater", kTrainingPassword);

  CurriculumVersion version;
  version.id = ids().newUuid();
  version.curriculumId = ids().newUuid();
  version.createdUtc_us = now_us();
  version.modules.push_back(moduleOf(ids().newUuid(), "first", "practice", 2, setup));
  version.modules.push_back(moduleOf(ids().newUuid(), "second", "graded", 1, setup));
  version.modules.push_back(moduleOf(ids().newUuid(), "third", "graded", 1, setup));
  version.modules[1].requires_ = {version.modules[0].id};
  version.modules[1].attemptLimit = 3;
  version.modules[2].requires_ = {version.modules[1].id};
  StudyArm arm;
  arm.id = ids().newUuid();
  arm.code = "G1";
  arm.label = "virtual, then real arm";
  arm.restAllowance_us = setup.restAllowance_us;
  arm.restSplittable = setup.restSplittable;
  for (TrainingPhase phase : setup.phases) {
    phase.id = ids().newUuid();
    arm.phases.push_back(phase);
  }
  version.arms.push_back(arm);
  CurriculumRepository curricula(connection());
  curricula.addCurriculum({version.curriculumId, "Twist basics", "", now_us(), false});
  curricula.addVersion(version, "office");
  curricula.moveTo(version.id, CurriculumState::kRunning, "office", now_us());

  const CohortId cohortId = ids().newUuid();
  const StudyGroup group{ids().newUuid(), cohortId, 1, "G1", arm.label};
  studies.addCohort({cohortId, "Autumn course", "", now_us(), false}, {&group, 1});
  curricula.assign(cohortId, version.id);
  std::vector<Enrolment> enrolments;
  for (std::size_t i = 0; i < trainees.size(); ++i) {
    Enrolment enrolment;
    enrolment.id = ids().newUuid();
    enrolment.cohortId = cohortId;
    enrolment.traineeId = trainees[i];
    enrolment.enrolledUtc_us = now_us();
    if (!setup.phases.empty()) {
      enrolment.groupId = group.id;
      enrolment.numberInGroup = static_cast<std::int64_t>(i) + 1;
    }
    enrolments.push_back(enrolment);
    if (setup.consent) {
      people.recordConsent({.personId = trainees[i],
                            .purpose = "training_record",
                            .granted = true,
                            .textVersion = "1",
                            .decidedUtc_us = now_us(),
                            .recordedBy = "office"});
    }
  }
  studies.enrol(enrolments);
}

void TrainingCentre::become(const std::string& who) {
  session_->setActor(actorOf(who));
}

Cohort TrainingCentre::cohort() {
  return StudyRepository(connection()).cohorts().front();
}

std::string TrainingCentre::enrolment(const std::string& traineeCode) {
  for (const Enrolment& enrolment : StudyRepository(connection()).enrolments(cohort().id)) {
    if (enrolment.traineeCode == traineeCode) {
      return enrolment.id;
    }
  }
  return {};
}

std::string TrainingCentre::module(const std::string& code) {
  const auto version = CurriculumRepository(connection()).version(cohort().curriculumVersionId);
  for (const TrainingModule& module : version->modules) {
    if (module.code == code) {
      return module.id;
    }
  }
  return {};
}

std::string TrainingCentre::attempt(const std::string& moduleCode, const std::string& mode, double skill,
                                    double duration_s, const PhaseId& phaseId, double planned_s,
                                    TrialOutcome outcome) {
  const Scene& scene = trainingBar();
  ScriptedHandOptions hand;
  hand.task = handTask(scene);
  hand.profile = {.initialSkill = skill, .finalSkill = skill, .learningTime_min = 1.0};
  hand.duration_s = planned_s > 0.0 ? planned_s : duration_s;
  hand.seed = static_cast<std::uint64_t>(now_us());
  const RecordingSpec spec = recording(moduleCode, mode, phaseId);
  RecordedRun run(borrowed(scene), std::make_unique<ScriptedHand>(hand), spec,
                  std::make_shared<TrialRepository>(connection(), spec.context));
  run.step(ticksIn(duration_s));
  static_cast<void>(run.finish(outcome));
  passTime_us(ticksIn(duration_s) * kTickPeriod_us + kMinute_us);
  return spec.trialId;
}

RecordingSpec TrainingCentre::recording(const std::string& moduleCode, const std::string& mode,
                                        const PhaseId& phaseId) {
  return {.trialId = ids().newUuid(),
          .traineeCode = session_->actor().login,
          .startedUtc_us = now_us(),
          .context = {.station = "station 1",
                      .enrolmentId = enrolment(session_->actor().login),
                      .moduleId = module(moduleCode),
                      .phaseId = phaseId,
                      .attemptMode = fromStoredText<AttemptMode>(mode)}};
}

std::string TrainingCentre::untwist(const std::string& moduleCode, const std::string& mode,
                                    std::size_t turnsLeftOut) {
  static const Scene kTestis = [] {
    SceneRequest request;
    request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
    request.id = "testis";
    return loadScene(request);
  }();
  ScriptedTrial trial{.recording = recording(moduleCode, mode), .practisedBefore_min = 600.0};
  trial.turnsLeftOut = turnsLeftOut;
  TrialRepository sink(connection(), trial.recording.context);
  recordScriptedTrial(kTestis, trial, sink);
  passTime_us(kMinute_us);
  return trial.recording.trialId;
}

Attempt attemptOf(TrainingCentre& centre, const TrialId& trialId) {
  for (const Attempt& attempt : attemptsOf(centre.session(), centre.person())) {
    if (attempt.trialId == trialId) {
      return attempt;
    }
  }
  throw std::out_of_range(trialId.text());
}

}  // namespace torsio
