// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/demonstration/demonstration_desk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/services/recording/recorded_run.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/mark.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/call_repository.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/random.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::int64_t kWorking_us = 150'000'000;
constexpr const char* kRecordedPoint = "mid";
constexpr const char* kLivePoint = "post";
constexpr const char* kRoom = "Skills lab (demonstration)";
constexpr std::uint64_t kCallStream = 0x6361'6c6cULL;
constexpr int kReferenceRuns = 2;

std::string numbered(const std::string& prefix, int number) {
  return prefix + (number < 10 ? "0" : "") + std::to_string(number);
}

/// Returns a unique label without meaning: a number and a letter.
std::string caseLabel(int rater, int number) {
  constexpr std::string_view kLetters = "ACDEFHJKLMNPRTUVWXY";
  const auto at = static_cast<std::size_t>(rater) * 7 + static_cast<std::size_t>(number) * 5;
  return std::to_string(2 + (number * 3 + rater) % 8) + kLetters[at % kLetters.size()];
}

/// Creates the desks one by one.
class DeskMaker {
 public:
  DeskMaker(Connection& connection, IdSource& ids, const Scene& scene,
            const DemonstrationDeskOptions& options)
      : connection_(connection), ids_(ids), scene_(scene), options_(options), random_(options.seed) {}

  DemonstrationDesk make() {
    for (const Rater& rater : PeopleRepository(connection_).raters()) {
      if (rater.person.code.starts_with("R-")) {
        desk_.raterIds.push_back(rater.person.id);
      }
    }
    if (desk_.raterIds.empty()) {
      refuse(Text::tr("there are no demonstration physicians"), Text::tr("the record"),
             Text::tr("Make the demonstration people first"));
    }
    addRubric();
    addTrainees();
    addAssignments();
    addCalls();
    addReferenceRuns();
    for (std::size_t rater = 0; rater < desk_.raterIds.size(); ++rater) {
      submitSheets(rater);
    }
    addCampaign();
    return desk_;
  }

 private:
  void addRubric() {
    RubricRepository rubrics(connection_);
    RubricRevision rubric = demonstrationRubric();
    rubric.id = ids_.newUuid();
    rubric.rubricId = ids_.newUuid();
    rubric.createdBy = "demonstration";
    rubric.createdUtc_us = options_.utc_us;
    rubrics.addRubric(rubric.rubricId, "Twist on the arm (demonstration)", options_.utc_us, true);
    rubrics.addRevision(rubric);
    desk_.rubricRevisionId = rubric.id;
    rubric_ = rubric;
  }

  void addTrainees() {
    StudyRepository study(connection_);
    desk_.cohortId = ids_.newUuid();
    const std::vector<StudyGroup> groups{{ids_.newUuid(), desk_.cohortId, 1, "G1", "40 min virtual"}};
    study.addCohort({desk_.cohortId, std::string(Text::tr("Second intake (demonstration)").english()),
                     "Simulated trainees, scored from recordings", options_.utc_us, true},
                    groups);
    std::vector<Trainee> trainees;
    std::vector<Enrolment> enrolments;
    for (int i = 1; i <= options_.cases; ++i) {
      Trainee trainee;
      trainee.person.id = ids_.newUuid();
      trainee.person.code = numbered("S-", i);
      trainee.person.sex = i % 2 == 0 ? "male" : "female";
      trainee.person.createdUtc_us = options_.utc_us;
      trainee.person.demonstration = true;
      Enrolment enrolment;
      enrolment.id = ids_.newUuid();
      enrolment.cohortId = desk_.cohortId;
      enrolment.traineeId = trainee.person.id;
      enrolment.enrolledUtc_us = options_.utc_us;
      enrolment.demonstration = true;
      enrolments.push_back(enrolment);
      trainees.push_back(trainee);
    }
    PeopleRepository(connection_).addTrainees(trainees);
    study.enrol(enrolments);
    for (int i = 0; i < options_.cases; ++i) {
      const auto at = static_cast<std::size_t>(i);
      enrolmentIds_.push_back(enrolments[at].id);
      trialIds_.push_back(record(trainees[at].person.code, enrolments[at].id, 200 + i, 4.0 * i));
    }
  }

  std::string record(const std::string& code, const EnrolmentId& enrolmentId, int person,
                     double practised_min) {
    ScriptedTrial trial;
    trial.recording = {.trialId = ids_.newUuid(),
                       .traineeCode = code,
                       .phaseLabel = code.empty() ? "reference run" : "virtual 0-20 min",
                       .startedUtc_us = options_.utc_us,
                       .demonstration = true,
                       .context = {.station = "demonstration", .enrolmentId = enrolmentId}};
    trial.personSeed = options_.seed + static_cast<std::uint64_t>(person);
    trial.trialSeed = trial.personSeed;
    trial.duration_s = options_.trial_s;
    trial.practisedBefore_min = practised_min;
    TrialRepository repository(connection_, trial.recording.context);
    recordScriptedTrial(scene_, trial, repository);
    return trial.recording.trialId;
  }

  void addAssignments() {
    std::vector<Assignment> assignments;
    for (std::size_t rater = 0; rater < desk_.raterIds.size(); ++rater) {
      for (int k = 0; k < 2 * options_.cases; ++k) {
        const int number = k % options_.cases;
        const bool live = k >= options_.cases;
        // A different order for each rater: the same cycle of cases with another start.
        const int shuffled = (number * 3 + static_cast<int>(rater)) % options_.cases;
        const auto at = static_cast<std::size_t>(live ? number : shuffled);
        Assignment one;
        one.id = ids_.newUuid();
        one.raterId = desk_.raterIds[rater];
        one.enrolmentId = enrolmentIds_[at];
        one.occasionCode = live ? kLivePoint : kRecordedPoint;
        one.trialId = live ? std::string() : trialIds_[at];
        one.rubricRevisionId = desk_.rubricRevisionId;
        one.caseLabel = live ? numbered("L", number + 1) : caseLabel(static_cast<int>(rater), number);
        one.position = k;
        one.dueUtc_us = options_.utc_us + (live ? 9 : 3 + number / 4) * kDay_us;
        one.assignedBy = "demonstration";
        one.assignedUtc_us = options_.utc_us;
        one.demonstration = true;
        if (rater == 0 && !live) {
          desk_.assignmentIds.push_back(one.id);
        }
        assignments.push_back(one);
      }
    }
    SheetRepository(connection_).assign(assignments);
    assignments_ = std::move(assignments);
  }

  /// Adds two calls to the real arm: a trainee whose sheets are overdue, and one who is there now.
  void addCalls() {
    constexpr std::int64_t kCall_us = 5 * 60 * 1'000'000LL;
    SeededIdSource ids(options_.seed ^ kCallStream);  // a separate stream, so that all other ids stay the
                                                      // same
    std::vector<LiveCall> calls;
    for (std::size_t i = 0; i < std::min<std::size_t>(2, enrolmentIds_.size()); ++i) {
      LiveCall call{.id = ids.newUuid(),
                    .enrolmentId = enrolmentIds_[i],
                    .occasionCode = kLivePoint,
                    .room = kRoom,
                    .calledBy = "demonstration",
                    .calledUtc_us = options_.utc_us + static_cast<std::int64_t>(i) * kCall_us};
      if (i == 0) {
        call.endedUtc_us = call.calledUtc_us + kCall_us;
      }
      calls.push_back(std::move(call));
    }
    CallRepository(connection_).add(calls);
  }

  void addReferenceRuns() {
    std::vector<ReferenceRun> runs;
    for (int i = 1; i <= kReferenceRuns; ++i) {
      ReferenceRun run;
      run.trialId = record("", "", 300 + i, i == 1 ? 2.0 : 80.0);
      run.position = i;
      run.rubricRevisionId = desk_.rubricRevisionId;
      run.panel_steps = i == 1 ? 41.0 : 76.0;
      run.panelRaters = 8;
      run.setBy = "demonstration";
      run.setUtc_us = options_.utc_us;
      run.demonstration = true;
      runs.push_back(run);
    }
    DeskRepository(connection_).addReferenceRuns(runs);
  }

  /// Generates the marks of one rater in half points: the trainee's ability, the rater's strictness and some
  /// noise.
  Sheet sheetFor(std::size_t trainee, std::size_t rater) {
    const double strictness = static_cast<double>(rater % 5) * 0.4 - 0.8 - (rater == 0 ? 0.9 : 0.0);
    const double ability = 4.0 + 0.45 * static_cast<double>(trainee);
    Sheet sheet;
    std::int64_t sum = 0;
    for (const RubricLine& row : rubric_.rows) {
      const double chance = 2.4 * random_.uniform() - 1.2;
      const double points = std::clamp(ability + strictness + chance, 1.0, 10.0);
      const auto steps = static_cast<std::int64_t>(std::lround(points * 2.0)) * 5;
      sheet.rows.push_back({row.code, std::clamp(steps, row.scale.lo, row.scale.hi), ""});
      sum += *sheet.rows.back().score_steps;
    }
    const std::int64_t mean = sum / static_cast<std::int64_t>(rubric_.rows.size());
    sheet.overall_steps = std::clamp((mean + 2) / 5 * 5, rubric_.overall.lo, rubric_.overall.hi);
    sheet.changedUtc_us = options_.utc_us;
    return sheet;
  }

  /// All raters submit the first four recorded cases of R-01; of the rest, R-01 has one draft.
  void submitSheets(std::size_t rater) {
    SheetRepository sheets(connection_);
    DeskRepository desk(connection_);
    int own = 0;
    for (const Assignment& one : assignments_) {
      if (one.raterId != desk_.raterIds[rater] || one.trialId.empty()) {
        continue;
      }
      const auto trainee = static_cast<std::size_t>(
          std::find(enrolmentIds_.begin(), enrolmentIds_.end(), one.enrolmentId) - enrolmentIds_.begin());
      Sheet sheet = sheetFor(trainee, rater);
      ++own;
      if (rater == 0 && own == 5) {
        sheet.overall_steps.reset();
        sheet.rows.pop_back();
        sheet.comment = "Steady grip; starts late.";
        sheets.saveDraft(one.id, sheet);
      }
      if (rater == 0 && own > 4) {
        continue;
      }
      const MarkId markId = ids_.newUuid();
      sheets.submit(one.id, markId, sheet, "", options_.utc_us);
      SheetViewing viewing;
      viewing.watched_permille = 1000;
      viewing.worked_us = kWorking_us + 4'000'000 * own;
      desk.sealViewing(one.id, markId, viewing);
    }
  }

  void addCampaign() {
    Campaign campaign;
    campaign.id = ids_.newUuid();
    campaign.name = std::string(Text::tr("Three tissue models, second reading (demonstration)").english());
    campaign.instrument = paperInstrument();
    for (std::size_t c = 0; c < kSeniorities.size(); ++c) {
      campaign.instrument.classes[c].id = kSeniorities[c].stored;
    }
    campaign.models = {{"PM", "proposed model (Kriging + membrane)", "K", 1},
                       {"FEM", "finite elements", "M", 2},
                       {"MSM", "mass-spring", "T", 3}};
    constexpr std::array<const char*, 3> kOrders{"FEM,PM,MSM", "MSM,FEM,PM", "PM,MSM,FEM"};
    for (std::size_t i = 0; i < desk_.raterIds.size(); ++i) {
      campaign.raters.push_back({desk_.raterIds[i], "chief", kOrders[i % kOrders.size()]});
    }
    campaign.createdUtc_us = options_.utc_us;
    campaign.demonstration = true;
    EvaluationRepository(connection_).addCampaign(campaign);
    desk_.campaignId = campaign.id;
  }

  Connection& connection_;
  IdSource& ids_;
  const Scene& scene_;
  const DemonstrationDeskOptions& options_;
  Random random_;
  DemonstrationDesk desk_;
  RubricRevision rubric_;
  std::vector<std::string> enrolmentIds_;
  std::vector<std::string> trialIds_;
  std::vector<Assignment> assignments_;
};

}  // namespace

RubricRevision demonstrationRubric() {
  const ScoreScale scale{.lo = 10, .hi = 100, .stepsPerPoint = 10};
  RubricRevision rubric;
  rubric.number = 1;
  rubric.note = "demonstration";
  rubric.overall = scale;
  const auto words = [](Phrase sentence) { return std::string(sentence.english()); };
  rubric.rows = {{"time",
                  words(Text::tr("Training time")),
                  scale,
                  {{10, words(Text::tr("Does not finish; long stops"))},
                   {50, words(Text::tr("Finishes with some waiting"))},
                   {100, words(Text::tr("Brisk, no idle moment"))}}},
                 {"proficiency",
                  words(Text::tr("Proficiency")),
                  scale,
                  {{10, words(Text::tr("Searches for the grip"))},
                   {50, words(Text::tr("Knows the steps, corrects often"))},
                   {100, words(Text::tr("Fluent, one movement"))}}},
                 {"accuracy",
                  words(Text::tr("Operational accuracy")),
                  scale,
                  {{10, words(Text::tr("Far from the angle, slips"))},
                   {50, words(Text::tr("Near the angle, wavers"))},
                   {100, words(Text::tr("Reaches and holds the angle"))}}},
                 {"tissue",
                  words(Text::tr("Care for the tissue")),
                  scale,
                  {{10, words(Text::tr("Pulls and jerks"))},
                   {50, words(Text::tr("Some force peaks"))},
                   {100, words(Text::tr("Soft build-up, soft release"))}}}};
  return rubric;
}

DemonstrationDesk storeDemonstrationDesk(Connection& connection, IdSource& ids, const Scene& scene,
                                         const DemonstrationDeskOptions& options) {
  Transaction transaction(connection);
  DemonstrationDesk desk = DeskMaker(connection, ids, scene, options).make();
  transaction.commit();
  return desk;
}

}  // namespace torsio
