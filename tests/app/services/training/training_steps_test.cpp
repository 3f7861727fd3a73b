// SPDX-License-Identifier: GPL-3.0-or-later

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "app/services/recording/competence.h"
#include "app/services/recording/competence_service.h"
#include "app/services/recording/recorded_run.h"
#include "app/services/training/attempts.h"
#include "app/services/training/debrief.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/run_session.h"
#include "app/services/training/transcript.h"
#include "app/services/training/trend.h"
#include "assessment/attempt/trial_digest.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "db/repository/trial/digest_repository.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/record/sample_codec.h"
#include "sim/servo/replay_trial.h"
#include "tests/app/support/training_centre.h"
#include "tests/support/refusal.h"

namespace torsio {

namespace {

using testing::refusalCode;

TrainingCentre::Setup twoPhases() {
  TrainingCentre::Setup setup;
  setup.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual 1 min", .duration_us = kMinute_us},
                  {.kind = PhaseKind::kReal, .label = "real 1 min", .duration_us = kMinute_us}};
  setup.restAllowance_us = 30 * kSecond_us;
  return setup;
}

TEST(NextSteps, StatesWhatIsOpenWhatIsLockedAndWhy) {
  TrainingCentre centre;

  const NextSteps steps = nextSteps(centre.session(), centre.person());

  ASSERT_EQ(steps.modules.size(), 3U);
  EXPECT_EQ(steps.cohortName, "Autumn course");
  EXPECT_EQ(steps.modules[0].state, StepState::kOpen);
  EXPECT_EQ(steps.modules[1].state, StepState::kLocked);
  EXPECT_EQ(steps.modules[1].missing, std::vector<std::string>{"Quarter turn, first"});
  EXPECT_EQ(steps.modules[0].unlocks, std::vector<std::string>{"Quarter turn, second"});
  ASSERT_TRUE(steps.next);
  EXPECT_EQ(*steps.next, 0U);
  EXPECT_TRUE(steps.recordingAllowed);
}

TEST(NextSteps, AModuleIsMasteredByEnoughGoodAttemptsInARow) {
  TrainingCentre centre;
  centre.attempt("first", "practice", 1.0);
  NextSteps steps = nextSteps(centre.session(), centre.person());
  EXPECT_EQ(steps.modules[0].state, StepState::kOpen);
  EXPECT_EQ(steps.modules[0].rules[0].streak, 1);
  ASSERT_TRUE(steps.modules[0].last);
  EXPECT_GE(steps.modules[0].last->twists, 1);

  centre.attempt("first", "practice", 1.0);
  steps = nextSteps(centre.session(), centre.person());

  EXPECT_EQ(steps.modules[0].state, StepState::kMastered);
  EXPECT_EQ(steps.modules[1].state, StepState::kOpen);
  EXPECT_EQ(*steps.next, 1U);
}

TEST(NextSteps, PracticeAtAGradedModuleDoesNotCount) {
  TrainingCentre centre;
  for (int i = 0; i < 2; ++i) {
    centre.attempt("first", "practice", 1.0);
  }
  centre.attempt("second", "practice", 1.0);
  NextSteps steps = nextSteps(centre.session(), centre.person());
  EXPECT_EQ(steps.modules[1].state, StepState::kOpen);
  EXPECT_EQ(steps.modules[1].attempts, 0);
  EXPECT_EQ(steps.modules[1].attemptsLeft, 3);

  centre.attempt("second", "graded", 1.0);
  steps = nextSteps(centre.session(), centre.person());
  EXPECT_EQ(steps.modules[1].state, StepState::kMastered);
  EXPECT_EQ(steps.modules[1].attemptsLeft, 2);
}

TEST(NextSteps, AttemptsCanBeUsedUp) {
  TrainingCentre centre;
  for (int i = 0; i < 2; ++i) {
    centre.attempt("first", "practice", 1.0);
  }
  // Too short for a single twist: no target reached.
  for (int i = 0; i < 3; ++i) {
    centre.attempt("second", "graded", 1.0, 0.5);
  }

  const NextSteps steps = nextSteps(centre.session(), centre.person());

  EXPECT_EQ(steps.modules[1].state, StepState::kUsedUp);
  EXPECT_EQ(steps.modules[1].attemptsLeft, 0);
  EXPECT_EQ(steps.modules[2].state, StepState::kLocked);
  EXPECT_EQ(refusalCode([&] {
              const MonotonicClock clock;
              RunSession(centre.session(), {centre.module("second"), true, deviceWith(Light::kGreen)}, clock);
            }),
            ErrorCode::kBadParameter);
}

TEST(NextSteps, IsForTheActorOnly) {
  TrainingCentre centre;
  const std::string first = centre.person();
  const std::string trial = centre.attempt("first", "practice", 1.0);
  centre.become("T-02");

  EXPECT_EQ(refusalCode([&] { static_cast<void>(nextSteps(centre.session(), first)); }),
            ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(debrief(centre.session(), trial, "no assets here")); }),
            ErrorCode::kPermission);
  centre.become("chief");
  EXPECT_EQ(refusalCode([&] { static_cast<void>(nextSteps(centre.session(), centre.person())); }),
            ErrorCode::kPermission);
}

TEST(NextSteps, ValuesAreMeasuredOnceAndStoredWithTheTrial) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", 1.0);
  const Attempt first = attemptOf(centre, trial);
  const auto kept = DigestRepository(centre.connection()).ofTrial(trial, kMetricsVersion);

  const Attempt again = attemptOf(centre, trial);

  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(DigestRepository(centre.connection()).ofTrial(trial, kMetricsVersion), kept);
  EXPECT_EQ(again.values, first.values);
  EXPECT_EQ(again.twists, first.twists);
  EXPECT_EQ(again.onTarget, first.onTarget);
  EXPECT_GT(kept.front().measures.values.size(), 10U);
}

TEST(RunSession, NeedsConsentAndADeviceThatIsGoodEnough) {
  TrainingCentre centre({.consent = false});
  const ManualClock clock;
  const auto begin = [&](bool graded, Light light) {
    RunSession(centre.session(), {centre.module("first"), graded, deviceWith(light)}, clock);
  };
  EXPECT_EQ(refusalCode([&] { begin(false, Light::kGreen); }), ErrorCode::kPermission);
  decideOwnConsent(centre.session(), "training_record", true, "1");

  EXPECT_NO_THROW(begin(true, Light::kGreen));
  EXPECT_NO_THROW(begin(false, Light::kAmber));
  EXPECT_EQ(refusalCode([&] { begin(true, Light::kAmber); }), ErrorCode::kDevice);
  EXPECT_EQ(refusalCode([&] { begin(true, Light::kRed); }), ErrorCode::kDevice);
  EXPECT_EQ(refusalCode([&] {
              RunSession(centre.session(), {centre.module("first"), false, DeviceReadiness{}}, clock);
            }),
            ErrorCode::kDevice);
}

TEST(RunSession, LocksAreEnforcedByTheServiceToo) {
  TrainingCentre centre;
  const ManualClock clock;
  EXPECT_EQ(refusalCode([&] {
              RunSession(centre.session(), {centre.module("second"), true, deviceWith(Light::kGreen)}, clock);
            }),
            ErrorCode::kBadParameter);
  EXPECT_EQ(refusalCode([&] {
              RunSession(centre.session(), {"no such module", true, deviceWith(Light::kGreen)}, clock);
            }),
            ErrorCode::kBadParameter);
}

TEST(RunSession, ATrialHasItsContext) {
  TrainingCentre centre(twoPhases());
  const ManualClock clock;
  RunSession runSession(centre.session(), {centre.module("first"), true, deviceWith(Light::kGreen)}, clock);
  runSession.start();

  const RecordingSpec recording = runSession.newTrial();

  EXPECT_EQ(recording.traineeCode, "T-01");
  EXPECT_EQ(recording.phaseLabel, "virtual 1 min");
  EXPECT_EQ(recording.context.moduleId, centre.module("first"));
  EXPECT_EQ(recording.context.phaseId, runSession.run().phase().phaseId);
  EXPECT_EQ(recording.context.attemptMode, AttemptMode::kGraded);
  EXPECT_EQ(recording.context.enrolmentId, centre.enrolment());
  EXPECT_FALSE(recording.context.host.name.empty());
  EXPECT_EQ(runSession.trials(), std::vector<TrialId>{recording.trialId});
}

TEST(RunSession, LogsTheTimeOfEveryPhaseAndTheRest) {
  TrainingCentre centre(twoPhases());
  ManualClock clock;
  RunSession runSession(centre.session(), {centre.module("first"), false, deviceWith(Light::kGreen)}, clock);
  const auto pass = [&](std::int64_t span_us) {
    for (std::int64_t t = 0; t < span_us; t += kSecond_us) {
      clock.advance_us(kSecond_us);
      centre.passTime_us(kSecond_us);
      static_cast<void>(runSession.advance());
    }
  };
  runSession.start();
  pass(40 * kSecond_us);
  ASSERT_TRUE(runSession.rest());
  pass(10 * kSecond_us);
  static_cast<void>(runSession.resume());
  pass(20 * kSecond_us);
  EXPECT_EQ(runSession.run().state(), RunState::kHandOver);
  static_cast<void>(runSession.resume());
  pass(kMinute_us);
  EXPECT_TRUE(runSession.run().over());

  std::map<ExposureKind, std::int64_t> dose_us;
  for (const Exposure& exposure : StudyRepository(centre.connection()).exposures(centre.cohort().id)) {
    dose_us[exposure.kind] += exposure.duration_us;
  }
  EXPECT_EQ(dose_us[ExposureKind::kVirtual], kMinute_us);
  EXPECT_EQ(dose_us[ExposureKind::kReal], kMinute_us);
  EXPECT_EQ(dose_us[ExposureKind::kRest], 10 * kSecond_us);
  const NextSteps steps = nextSteps(centre.session(), centre.person());
  EXPECT_TRUE(steps.allPhasesDone);
  EXPECT_FALSE(steps.next);
}

TEST(RunSession, AnEarlyStopKeepsTheTimeAndIsReportedToTheStudy) {
  TrainingCentre centre(twoPhases());
  ManualClock clock;
  {
    RunSession runSession(centre.session(), {centre.module("first"), false, deviceWith(Light::kGreen)},
                          clock);
    runSession.start();
    clock.advance_us(9 * kSecond_us);
    runSession.stop("called to the ward");
  }
  const NextSteps steps = nextSteps(centre.session(), centre.person());
  EXPECT_EQ(steps.plan.phases[0].done_us, 9 * kSecond_us);
  const auto deviations = StudyRepository(centre.connection()).deviations(centre.cohort().id);
  ASSERT_EQ(deviations.size(), 1U);
  EXPECT_EQ(deviations[0].kind, "phase cut short");
  EXPECT_EQ(deviations[0].description, "called to the ward");

  // The next run continues where this one ended.
  RunSession later(centre.session(), {centre.module("first"), false, deviceWith(Light::kGreen)}, clock);
  EXPECT_EQ(later.run().remainingInPhase_us(), 51 * kSecond_us);
}

TEST(RunSession, MouseAndKeyboardAreForPracticeUnlessTheCentreAllowsGrading) {
  TrainingCentre centre;
  EXPECT_EQ(pointerReadiness(gradesWithMouse(centre.session())).light(), Light::kAmber);
  SettingRepository(centre.connection()).set("graded_with_mouse", "yes", 0);
  EXPECT_EQ(pointerReadiness(gradesWithMouse(centre.session())).light(), Light::kGreen);
}

TEST(RunSession, NoSoundIsPlayedAtALimitUnlessTheCentreWantsIt) {
  TrainingCentre centre;
  EXPECT_FALSE(soundsAtLimit(centre.session()));
  SettingRepository(centre.connection()).set("sound_at_limit", "yes", 0);
  EXPECT_TRUE(soundsAtLimit(centre.session()));
}

// Registered competence designs: who may register them, whom they apply to, and the default.

constexpr double kExpertSkill = 1.0;

/// Signs in a user who may edit curricula.
SessionContext& asAdministrator(TrainingCentre& centre) {
  const UserId id = "the administrator";
  AccessRepository access(centre.connection(), PasswordCost::kTest);
  const auto users = access.users();
  if (std::none_of(users.begin(), users.end(), [&](const UserAccount& user) { return user.id == id; })) {
    access.addUser({.id = id, .login = "admin", .roles = {"administrator"}}, "a long enough password");
  }
  centre.session().setActor({.userId = id, .login = "admin", .roles = {"administrator"}});
  return centre.session();
}

CompetenceDesign stricter(TrainingCentre& centre) {
  CompetenceDesign design;
  design.moduleId = centre.module("first");
  design.inadequate = 0.4;
  design.attempts = 50;
  return design;
}

TEST(CompetenceDesigns, ApplyToTraineesWhoStartAfterTheirRegistration) {
  TrainingCentre centre;
  centre.attempt("first", "practice", kExpertSkill);  // T-01 starts before
  centre.passTime_us(kMinute_us);
  const CompetenceDesign stored = registerCompetence(asAdministrator(centre), stricter(centre));
  EXPECT_EQ(stored.version, 1);
  EXPECT_EQ(stored.limit, 11.25);
  EXPECT_EQ(stored.dependenceRuns, 0);  // too few runs to estimate how they depend on each other
  EXPECT_DOUBLE_EQ(stored.tolerance_rad, radians(5.0));
  centre.passTime_us(kMinute_us);

  centre.become("T-01");
  const CompetenceVerdict before =
      trend(centre.session(), centre.person(), centre.module("first")).competence;
  EXPECT_EQ(before.design.version, 0);
  const std::string rule = competenceRuleText(before).str();
  EXPECT_NE(rule.find("Default competence rule"), std::string::npos);
  EXPECT_NE(
      rule.find("at least 1 twist, four in five of all twists released within 5.0 degrees (tolerance of "
                "the exercise), a force of at most 6.00 N"),
      std::string::npos)
      << rule;
  centre.become("T-02");
  const CompetenceVerdict shown = trend(centre.session(), centre.person(), centre.module("first")).competence;
  EXPECT_EQ(shown.design, stored);  // even before the first attempt
  centre.attempt("first", "practice", kExpertSkill);
  const Transcript paper = transcript(centre.session(), centre.person());
  EXPECT_EQ(paper.modules.front().competence.design, stored);
  EXPECT_EQ(paper.modules.front().competence.planned.attempts, 50);
  EXPECT_EQ(paper.modules.front().competence.errors.attempts, 1);
}

// Somebody who cut the device at the second miss was declared competent in 93 %: the runs did not count.
TEST(Competence, AnInterruptedRunHasFailedUntilItIsExcused) {
  TrainingCentre centre;
  centre.attempt("first", "practice", kExpertSkill);
  const std::string cut =
      centre.attempt("first", "practice", kExpertSkill, 12.0, {}, 0.0, TrialOutcome::kInterrupted);
  const auto verdict = [&] {
    centre.become("T-01");
    return trend(centre.session(), centre.person(), centre.module("first")).competence;
  };
  EXPECT_EQ(verdict().attempts, 2U);
  EXPECT_EQ(verdict().failed, 1U);
  EXPECT_THROW(excuseRun(centre.session(), cut, "power cut"), Error);  // a trainee

  SessionContext& session = asAdministrator(centre);
  const std::vector<InterruptedRun> runs = interruptedRuns(session, centre.module("first"));
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].trialId, cut);
  EXPECT_EQ(runs[0].trainee, "T-01");
  EXPECT_THROW(excuseRun(session, cut, ""), Error);  // no reason
  excuseRun(session, cut, "power cut");
  EXPECT_THROW(excuseRun(session, cut, "again"), Error);
  EXPECT_TRUE(interruptedRuns(session, centre.module("first")).at(0).excused);
  EXPECT_EQ(interruptedRuns(session, centre.module("first")).at(0).reason, "power cut");
  EXPECT_EQ(verdict().attempts, 1U);
  EXPECT_EQ(verdict().failed, 0U);
  asAdministrator(centre);
  EXPECT_THROW(excuseRun(session, runs[0].trialId.text() + "x", "none"), Error);
}

TEST(Competence, AnInterruptedRunEndsAStreakUnlessItIsExcused) {
  TrainingCentre centre;
  const auto streak = [&] {
    centre.become("T-01");
    const auto module = CurriculumRepository(centre.connection()).module(centre.module("first"));
    return ruleProgress(*module, attemptsOf(centre.session(), centre.person(), module->id)).at(0).streak;
  };
  centre.attempt("first", "practice", kExpertSkill);
  ASSERT_EQ(streak(), 1);
  const std::string cut =
      centre.attempt("first", "practice", kExpertSkill, 12.0, {}, 0.0, TrialOutcome::kInterrupted);
  EXPECT_EQ(streak(), 0);
  excuseRun(asAdministrator(centre), cut, "the cable");
  EXPECT_EQ(streak(), 1);
}

TEST(CompetenceDesigns, AreRefusedToTraineesAndIfTheyMissTheirErrorRates) {
  TrainingCentre centre;
  EXPECT_THROW((void)registerCompetence(centre.session(), stricter(centre)), Error);
  SessionContext& session = asAdministrator(centre);
  CompetenceDesign weak = stricter(centre);
  weak.inadequate = 0.2;  // two thirds of the competent would fail
  EXPECT_THROW((void)registerCompetence(session, weak), Error);
  CompetenceDesign chosen = stricter(centre);
  chosen.source = ToleranceSource::kChosen;
  chosen.tolerance_rad = radians(3.0);
  EXPECT_THROW((void)registerCompetence(session, chosen), Error);  // no reason
  chosen.reason = "as agreed in the house";
  EXPECT_EQ(registerCompetence(session, chosen).version, 1);
  CompetenceDesign nowhere = stricter(centre);
  nowhere.moduleId = "nowhere";
  EXPECT_THROW((void)registerCompetence(session, nowhere), Error);
  session.beginCall();
  const std::vector<ExerciseDesigns> all = competenceDesigns(session);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].registered.size(), 1U);
  EXPECT_TRUE(all[1].registered.empty());
  session.beginCall();
  EXPECT_THROW((void)expertTolerance_deg(session, centre.module("first"), centre.cohort().id), Error);
}

constexpr double kBeginner = 0.1;
constexpr double kExpert = 1.0;

TEST(ExpertRun, IsOneTwistThatReachesTheTargetAndReplaysBitForBit) {
  const Trial trial = expertRun(trainingBar(), trainingBar().pattern.targetAngle_rad);
  const std::vector<Sample> samples = decodeTrial(trial);

  const auto farthest = std::max_element(
      samples.begin(), samples.end(),
      [](const Sample& a, const Sample& b) { return a.response.angle_rad < b.response.angle_rad; });
  EXPECT_NEAR(farthest->response.angle_rad, trainingBar().pattern.targetAngle_rad, radians(5.0));
  EXPECT_EQ(trial.header.phaseLabel, kExpertPhase);
  EXPECT_EQ(trial.summary.outcome, TrialOutcome::kCompleted);
  EXPECT_TRUE(replayTrial(trainingBar(), trial).identical());
}

TEST(Debrief, ShowsEarlierMeasuresNextToTheCurrentVerdict) {
  TrainingCentre centre;
  const TrialId trial = centre.attempt("first", "practice", kExpert);
  static_cast<void>(attemptOf(centre, trial));
  const DigestRepository digests(centre.connection());
  TrialDigest older = digests.ofTrial(trial, kMetricsVersion).at(0);
  const double judged_N = older.measures.values.at(Quantity::kPeakForce);
  older.formulaVersion = kMetricsVersion - 1;
  older.measures.values.at(Quantity::kPeakForce) = 0.88;  // what the device could render
  DigestRepository(centre.connection()).add({&older, 1});

  const Debrief told = debrief(centre.session(), trial, {}, &trainingBar());

  ASSERT_TRUE(told.earlier);
  EXPECT_EQ(told.earlier->version, kMetricsVersion - 1);
  EXPECT_EQ(told.earlier->peakForce_N, 0.88);
  EXPECT_TRUE(told.earlier->withinLimits);
  const auto force =
      std::find_if(told.verdict.checks.begin(), told.verdict.checks.end(),
                   [](const TargetCheck& check) { return check.quantity == Quantity::kPeakForce; });
  ASSERT_NE(force, told.verdict.checks.end());
  EXPECT_EQ(force->value, judged_N);
  EXPECT_GT(judged_N, 0.88);
}

TEST(Debrief, ShowsWhatWasReachedAndWhereToLook) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", kBeginner, 30.0);

  const Debrief told = debrief(centre.session(), trial, {}, &trainingBar());

  ASSERT_FALSE(told.twists.empty());
  EXPECT_EQ(told.moduleTitle, "Quarter turn, first");
  EXPECT_NEAR(told.duration_s, 30.0, 0.01);
  ASSERT_EQ(told.strengths.size(), 2U);
  ASSERT_EQ(told.weaknesses.size(), 2U);
  std::set<Quantity> metrics;
  for (const auto* list : {&told.strengths, &told.weaknesses}) {
    for (const DebriefFinding& finding : *list) {
      metrics.insert(finding.quantity);
      const TwistResult& twist = told.twists.at(finding.twist);
      EXPECT_GE(finding.when.from_s, twist.when.from_s - 0.5) << idOf(finding.quantity);
      EXPECT_LE(finding.when.to_s, twist.when.to_s + 0.5) << idOf(finding.quantity);
      EXPECT_LT(finding.when.from_s, finding.when.to_s) << idOf(finding.quantity);
    }
  }
  EXPECT_EQ(metrics.size(), 4U);  // no metric is both a strength and a weakness
  EXPECT_GE(told.strengths[0].merit, told.weaknesses[0].merit);
  EXPECT_LT(told.weaknesses[0].merit, 0.0);  // a beginner is worse than the expert in something
}

TEST(Debrief, StatesWhetherTheForceWasFelt) {
  const Trial led = expertRun(trainingBar(), trainingBar().pattern.targetAngle_rad);
  TrialHeader turned = led.header;
  turned.drive = TwistDrive::kRoll;  // mouse, game controller, puck: they turn on the spot without force
  const std::vector<Sample> samples = decodeTrial(led);

  EXPECT_TRUE(makeDebrief(led.header, samples, {}, nullptr).forceFelt);
  EXPECT_FALSE(makeDebrief(turned, samples, {}, nullptr).forceFelt);
}

TEST(Debrief, ShowsTheExpertsCurveAtEachGrip) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", kBeginner, 30.0);

  const Debrief told = debrief(centre.session(), trial, {}, &trainingBar());

  ASSERT_FALSE(told.expert.empty());
  EXPECT_DOUBLE_EQ(told.expert.time_s.front(), 0.0);
  EXPECT_EQ(told.grips_s.size(), told.twists.size());
  const double top = *std::max_element(told.expert.angle_rad.begin(), told.expert.angle_rad.end());
  EXPECT_NEAR(top, told.target_rad, told.tolerance_rad);
}

TEST(Debrief, PassesAnExpertAndFailsATraineeWhoDidNothing) {
  TrainingCentre centre;
  const std::string good = centre.attempt("first", "practice", kExpert);
  const std::string idle = centre.attempt("first", "practice", kExpert, 0.5);

  const Debrief passed = debrief(centre.session(), good, {}, &trainingBar());
  const Debrief failed = debrief(centre.session(), idle, {}, &trainingBar());

  for (const TargetCheck& check : passed.verdict.checks) {
    EXPECT_TRUE(check.passed) << check.text();
  }
  EXPECT_TRUE(passed.verdict.passed());
  EXPECT_FALSE(failed.verdict.passed());
  EXPECT_TRUE(failed.twists.empty());
  EXPECT_TRUE(failed.strengths.empty());
  EXPECT_EQ(failed.verdict.checks.front().quantity, Quantity::kTargetsReached);
  EXPECT_FALSE(failed.verdict.checks.front().passed);
}

TEST(Debrief, ATwistCutOffByTheEndOfTheRunIsNotJudged) {
  Trial trial = expertRun(trainingBar(), trainingBar().pattern.targetAngle_rad);
  std::vector<Sample> samples = decodeTrial(trial);
  const auto gripped = std::find_if(samples.begin(), samples.end(), [](const Sample& sample) {
    return sample.response.angle_rad > 0.5 * trainingBar().pattern.targetAngle_rad;
  });
  samples.erase(gripped, samples.end());

  const Debrief told = makeDebrief(trial.header, samples, {}, &trial);
  const AttemptMeasures measures = measureAttempt(trial.header, samples, {.tolerance_rad = radians(5.0)});

  EXPECT_TRUE(told.twists.empty());
  EXPECT_TRUE(told.strengths.empty());
  EXPECT_EQ(told.unfinishedTwists, 1);
  EXPECT_TRUE(measures.twists.empty());
  EXPECT_EQ(measures.unfinished, 1);
}

TEST(Debrief, ReportsLostSamplesOnlyIfTheyBelongToATwist) {
  const Trial trial = expertRun(trainingBar(), trainingBar().pattern.targetAngle_rad);
  const std::vector<Sample> whole = decodeTrial(trial);
  const auto without = [&](double angle) {
    std::vector<Sample> torn = whole;
    const auto at = std::find_if(torn.begin(), torn.end(), [angle](const Sample& sample) {
      return sample.response.angle_rad > angle * trainingBar().pattern.targetAngle_rad;
    });
    torn.erase(at, at + 50);
    return torn;
  };
  std::vector<Sample> before = whole;  // the hand is still approaching
  before.erase(before.begin() + 10, before.begin() + 60);

  EXPECT_TRUE(makeDebrief(trial.header, without(0.5), {}, &trial).verdict.torn);
  EXPECT_FALSE(makeDebrief(trial.header, whole, {}, &trial).verdict.torn);
  EXPECT_FALSE(makeDebrief(trial.header, before, {}, &trial).verdict.torn) << "no twist was touched";
}

TEST(Debrief, MasteryCountsTheAttemptsUpToThisOne) {
  TrainingCentre centre;
  const std::string first = centre.attempt("first", "practice", kExpert);
  const std::string second = centre.attempt("first", "practice", kExpert);

  const auto streakOf = [&](const std::string& trial) {
    const Debrief told = debrief(centre.session(), trial, {}, &trainingBar());
    return told.verdict.checks.back();
  };

  EXPECT_EQ(streakOf(first).streak, 1);
  EXPECT_EQ(streakOf(second).streak, 2);
  EXPECT_EQ(streakOf(second).consecutive, 2);
}

// Twenty peaks are not close to twelve, although nothing else in the run was closer.
TEST(Debrief, CallsOnlyCloseResultsClose) {
  DebriefFinding finding{
      .quantity = Quantity::kSubMovements, .value = 20.0, .expert = 12.0, .merit = -0.45, .strength = true};
  EXPECT_NE(finding.text().str().find("closest to the expert"), std::string::npos);
  finding.value = 13.0;
  finding.merit = -0.07;
  EXPECT_NE(finding.text().str().find("close to the expert"), std::string::npos);
  finding.value = 8.0;
  finding.merit = 0.3;
  EXPECT_NE(finding.text().str().find("better than the expert"), std::string::npos);
}

TEST(Debrief, HasNoExpertIfTheOrganIsNoLongerAvailable) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", kExpert);

  const Debrief told = debrief(centre.session(), trial, centre.folder() / "no assets here");

  EXPECT_TRUE(told.expert.empty());
  EXPECT_TRUE(told.strengths.empty());
  EXPECT_FALSE(told.twists.empty());
}

TEST(Debrief, IsOnlyForTheTrainee) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", kExpert);
  centre.become("T-02");
  EXPECT_THROW(static_cast<void>(debrief(centre.session(), trial, {}, &trainingBar())), Error);
}

TEST(Debrief, StoresBookmarks) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", kExpert);
  addBookmark(centre.session(), trial, 2.5, "good grip");

  const Debrief told = debrief(centre.session(), trial, {}, &trainingBar());

  ASSERT_EQ(told.bookmarks.size(), 1U);
  EXPECT_DOUBLE_EQ(told.bookmarks[0].at_s, 2.5);
  EXPECT_EQ(told.bookmarks[0].text, "good grip");
  EXPECT_THROW(addBookmark(centre.session(), trial, -1.0, ""), Error);
}

TEST(Trend, ShowsEveryAttemptAndTheDistanceToTheThreshold) {
  TrainingCentre centre;
  centre.attempt("first", "practice", kExpert);
  centre.attempt("first", "practice", kExpert, 0.5);

  const Trend way = trend(centre.session(), centre.person(), centre.module("first"));

  ASSERT_EQ(way.points.size(), 2U);
  EXPECT_EQ(way.quantity, Quantity::kOnTarget);
  EXPECT_EQ(way.points[0].outcome, RunOutcome::kPassed);
  EXPECT_EQ(way.points[1].outcome, RunOutcome::kNotPassed);
  EXPECT_FALSE(way.points[1].value);  // no share without twists
  EXPECT_EQ(way.threshold, 0.5);
  ASSERT_TRUE(way.distance);
  EXPECT_LE(*way.distance, 0.0);
  EXPECT_EQ(way.competence.level, SkillLevel::kNotShown);
  EXPECT_EQ(way.competence.attempts, 2U);  // runs
  EXPECT_EQ(way.competence.attemptsUntilLevel, 36U);
  EXPECT_EQ(way.competence.design.version, 0);
  EXPECT_TRUE(way.curve.empty());
  EXPECT_FALSE(way.noCurveReason.empty());
}

TEST(Trend, FitsALearningCurveFromEightAttemptsOn) {
  TrainingCentre centre;
  for (int i = 0; i < 9; ++i) {
    centre.attempt("first", "practice", 1.0 - 0.9 * std::exp(-0.4 * i), 10.0);
  }

  const Trend way = trend(centre.session(), centre.person(), centre.module("first"), Quantity::kTime);

  EXPECT_TRUE(way.lowerIsBetter);
  ASSERT_FALSE(way.curve.empty()) << way.noCurveReason;
  EXPECT_GT(way.curve.front().value, way.curve.back().value);
  EXPECT_LE(way.curve.front().lower, way.curve.front().value);
}

}  // namespace

}  // namespace torsio
