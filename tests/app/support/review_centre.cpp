// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/review_centre.h"

#include <algorithm>
#include <cmath>

#include "app/services/recording/recorded_run.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {

namespace {

constexpr const char* kPassword = "a long enough password";
constexpr const char* kPhase = "virtual 20-40 min";
constexpr const char* kGroupLabel = "40 min virtual";
const char* const kSurnames[] = {"Zhangwei", "Limeihua",  "Oyelaran", "Brunnhuber", "Castellanos",
                                 "Dubrovin", "Einarsson", "Fujimori", "Goldstein",  "Haverkamp"};

const Scene& bar() {
  static const Scene kBar = barScene();
  return kBar;
}

std::string physicianLogin(std::size_t index) {
  return "physician" + std::to_string(index);
}

}  // namespace

ReviewCentre::ReviewCentre(const Setup& setup) : TestRecord(20251121, setup.locator) {
  Transaction transaction(connection());
  addPeople(setup);
  addTrials(setup);
  addAssignments(setup);
  if (setup.live && setup.called) {
    callAll();
  }
  transaction.commit();
}

ReviewCentre::ReviewCentre(const std::filesystem::path& folder) : TestRecord(folder) {}

void ReviewCentre::addPeople(const Setup& setup) {
  addChiefClass("chief physicians");
  StudyRepository study(connection());
  const Cohort cohort{ids().newUuid(), "Autumn intake", "", kReviewTime_us, false, {}};
  const StudyGroup group{ids().newUuid(), cohort.id, 1, "G1", kGroupLabel, {}};
  study.addCohort(cohort, std::span(&group, 1));
  for (int i = 0; i < setup.trainees; ++i) {
    traineeCodes_.push_back("TR-4" + std::to_string(100 + i));
    Enrolment enrolment;
    enrolment.traineeId = addTrainee(traineeCodes_.back());
    PeopleRepository(connection())
        .setIdentity({enrolment.traineeId, kSurnames[i % 10], std::string(kSurnames[i % 10]) + "@example.org",
                      "staff-" + std::to_string(7000 + i)});
    enrolment.id = ids().newUuid();
    enrolment.cohortId = cohort.id;
    enrolment.enrolledUtc_us = kReviewTime_us;
    study.enrol(std::span(&enrolment, 1));
    enrolmentIds_.push_back(enrolment.id);
  }
  for (int i = 0; i < setup.raters; ++i) {
    addUser(physicianLogin(static_cast<std::size_t>(i)), addChief("CH-" + std::to_string(100 + i)), "rater",
            kPassword);
  }
  addUser("office", {}, "administrator", kPassword);
}

void ReviewCentre::addTrials(const Setup& setup) {
  const Scene& scene = setup.scene != nullptr ? *setup.scene : bar();
  for (std::size_t i = 0; i < enrolmentIds_.size(); ++i) {
    ScriptedTrial trial;
    trial.recording = {.trialId = ids().newUuid(),
                       .traineeCode = traineeCodes_[i],
                       .phaseLabel = kPhase,
                       .startedUtc_us = kReviewTime_us,
                       .context = {.station = "station-7", .enrolmentId = enrolmentIds_[i]}};
    trial.personSeed = 40 + i;
    trial.trialSeed = 40 + i;
    trial.duration_s = setup.trial_s;
    TrialRepository repository(connection(), trial.recording.context);
    recordScriptedTrial(scene, trial, repository);
    trialIds_.push_back(trial.recording.trialId);
  }
}

void ReviewCentre::callAll() {
  std::vector<LiveCall> calls;
  for (const EnrolmentId& enrolmentId : enrolmentIds_) {
    const std::int64_t called_us = kReviewTime_us + static_cast<std::int64_t>(calls.size()) * 60'000'000;
    calls.push_back(
        {ids().newUuid(), enrolmentId, "post", "room 1", "office", called_us, called_us + 1, false});
  }
  CallRepository(connection()).add(calls);
}

void ReviewCentre::addAssignments(const Setup& setup) {
  SheetRepository sheets(connection());
  const std::string rubric = ids().newUuid();
  RubricRepository rubrics(connection());
  rubrics.addRubric(rubric, "Twist", kReviewTime_us, false);
  RubricRevision revision{.id = ids().newUuid(), .rubricId = rubric};
  revision.overall = {10, 100, 10};
  revision.rows = {
      {"time", "Training time", {10, 100, 10}, {{10, "very slow"}, {100, "as an expert"}}},
      {"accuracy", "Operational accuracy", {10, 100, 10}, {{10, "misses"}, {100, "holds the angle"}}}};
  revision.createdBy = "office";
  revision.createdUtc_us = kReviewTime_us;
  rubrics.addRevision(revision);
  rubricRevisionId_ = revision.id;
  // The recorded cases, then the live ones of each occasion.
  std::vector<std::string> occasions(1, "mid");
  if (setup.live) {
    occasions.insert(occasions.end(), setup.liveOccasions.begin(), setup.liveOccasions.end());
  }
  std::vector<Assignment> assignments;
  const std::size_t trainees = enrolmentIds_.size();
  for (std::size_t rater = 0; rater < static_cast<std::size_t>(setup.raters); ++rater) {
    for (std::size_t k = 0; k < occasions.size() * trainees; ++k) {
      const bool live = k >= trainees;
      if (!live && std::count(occasions.begin() + 1, occasions.end(), occasions.front()) > 0) {
        continue;  // scored live instead
      }
      const std::size_t trainee = live ? k % trainees : (k + rater) % trainees;
      Assignment one;
      one.id = ids().newUuid();
      one.raterId = raterId(rater);
      one.enrolmentId = enrolmentIds_[trainee];
      one.occasionCode = occasions[k / trainees];
      one.trialId = live ? TrialId() : trialIds_[trainee];
      one.rubricRevisionId = rubricRevisionId_;
      one.caseLabel = std::to_string(k + 2) + std::string(1, "CFHKMPRTWX"[rater % 10]);
      one.position = static_cast<std::int64_t>(k);
      one.dueUtc_us =
          kReviewTime_us + (setup.dueByTrainee ? 1 + static_cast<std::int64_t>(trainee) : 3) * kReviewDay_us;
      one.assignedBy = "office";
      one.assignedUtc_us = kReviewTime_us;
      assignments.push_back(one);
    }
  }
  sheets.assign(assignments);
}

std::unique_ptr<SessionContext> ReviewCentre::physician(std::size_t index) {
  return sessionOf("desk-1", actorOf(physicianLogin(index)));
}

std::unique_ptr<SessionContext> ReviewCentre::administrator() {
  return sessionOf("office-1", actorOf("office"));
}

void ReviewCentre::addTwoModels(bool recorded, const std::vector<std::string>& orders) {
  Campaign campaign;
  campaign.id = "campaign";
  campaign.name = "Two models";
  campaign.instrument = paperInstrument();
  campaign.instrument.classes = {{"chief", "chief physicians", 1000}};
  campaign.models = {{"PM", "proposed-model", "K", 1}, {"FEM", "finite-elements", "M", 2}};
  for (std::size_t i = 0; recorded && i < campaign.models.size(); ++i) {
    campaign.models[i].trialId = trialIds_.at(i);
  }
  for (std::size_t i = 0; i < orders.size(); ++i) {
    campaign.raters.push_back({raterId(i), "chief", orders[i]});
  }
  EvaluationRepository(connection()).addCampaign(campaign);
}

CohortId ReviewCentre::cohortId() {
  return CohortId(selectFirst(connection(), "SELECT id FROM cohort", {}, readText).value());
}

RaterId ReviewCentre::raterId(std::size_t index) {
  return actorOf(physicianLogin(index)).personId;
}

std::vector<AssignmentId> ReviewCentre::cases(std::size_t index, bool live) {
  std::vector<AssignmentId> ids;
  for (const QueueEntry& entry : SheetRepository(connection()).queue(raterId(index))) {
    if (entry.trialId.empty() == live) {
      ids.push_back(entry.assignmentId);
    }
  }
  return ids;
}

AssignmentId ReviewCentre::caseAbout(std::size_t index, std::size_t trainee) {
  DeskRepository desk(connection());
  for (const AssignmentId& id : cases(index)) {
    if (desk.assignment(id)->trialId == trialIds_.at(trainee)) {
      return id;
    }
  }
  return {};
}

std::vector<std::string> ReviewCentre::secrets() {
  std::vector<std::string> found{kPhase,         kGroupLabel, "Autumn intake", "20-40",
                                 "after 20 min", "station-7", "staff-70"};
  for (const Trainee& trainee : PeopleRepository(connection()).trainees()) {
    found.push_back(trainee.person.code);
    found.push_back(trainee.person.id);
    if (const auto identity = PeopleRepository(connection()).identity(trainee.person.id)) {
      found.push_back(identity->fullName);
    }
  }
  for (const TrialListing& trial : TrialRepository(connection()).list()) {
    found.push_back(trial.trialId);
    found.push_back(trial.trialId.text().substr(0, 8));
    if (trial.summary) {
      found.push_back(trial.summary->contentHash.substr(0, 8));
    }
  }
  for (const std::string& id : enrolmentIds_) {
    found.push_back(id);
  }
  return found;
}

Sheet reviewSheet(double time, double accuracy, double overall) {
  const auto steps = [](double points) { return static_cast<std::int64_t>(std::lround(points * 10.0)); };
  Sheet sheet;
  sheet.overall_steps = steps(overall);
  sheet.rows = {{"time", steps(time), ""}, {"accuracy", steps(accuracy), ""}};
  return sheet;
}

Sheet changedSheet(std::int64_t version, double time, double accuracy, double overall) {
  Sheet sheet = reviewSheet(time, accuracy, overall);
  sheet.revision = version;
  return sheet;
}

}  // namespace torsio
