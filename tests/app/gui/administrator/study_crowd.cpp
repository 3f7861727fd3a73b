// SPDX-License-Identifier: GPL-3.0-or-later
// The marks of a whole study by the demonstration's rule, and the numbers that follow from them.
#include "tests/app/gui/administrator/study_crowd.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "app/services/people/people_service.h"
#include "app/services/study/campaign_service.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "tests/app/support/cohort_numbers.h"

namespace torsio::gui::testing {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMarkSeed = 5;
constexpr std::size_t kEvaluationMarks = 40U * 3 * 9;  // raters, models, indices

}  // namespace

Crowd crowdOf(AdministratorDesk& office, const CohortId& cohortId, const std::vector<std::string>& chiefs) {
  Crowd crowd;
  crowd.people.groups.resize(3);
  crowd.people.raters = chiefs;
  for (const Enrolment& enrolment : enrolments(office.centre.as("allocator"), cohortId)) {
    crowd.people.groups.at(static_cast<std::size_t>(enrolment.groupCode.back() - '1'))
        .push_back(enrolment.traineeCode);
    crowd.codeOf[enrolment.id] = enrolment.traineeCode;
  }
  for (const PersonRow& person : torsio::people(office.centre.as("administrator"))) {
    if (person.rater) {
      crowd.idOf[person.person.code] = person.person.id;
    }
  }
  crowd.people.raterClasses.resize(3);
  const std::vector<std::string> classes{"intern", "deputy_chief", "chief"};
  for (const CampaignRow::Rater& rater : campaigns(office.centre.session()).front().raters) {
    crowd.people
        .raterClasses[static_cast<std::size_t>(std::find(classes.begin(), classes.end(), rater.classCode) -
                                               classes.begin())]
        .push_back(rater.code);
  }
  return crowd;
}

void submitSheets(StudyCentre& centre, const CohortId& cohortId, const Crowd& crowd) {
  SheetRepository sheets(centre.connection());
  std::map<std::string, std::string> codeOfRater;
  for (const auto& [code, id] : crowd.idOf) {
    codeOfRater[id] = code;
  }
  std::map<std::tuple<std::string, std::string, std::size_t>, std::int64_t> marks;
  for (const TrainingMark& mark : demonstrationTrainingMarks({10, 100, 10}, crowd.people, kMarkSeed)) {
    marks[{mark.trainee, mark.rater, mark.occasion}] = mark.steps;
  }
  const std::map<std::string, std::size_t> occasions{{"pre", 0}, {"mid", 1}, {"post", 2}};
  for (const AssignmentStatus& status : sheets.assignments(cohortId)) {
    const Assignment& one = status.assignment;
    Sheet sheet;
    sheet.overall_steps = marks.at(
        {crowd.codeOf.at(one.enrolmentId), codeOfRater.at(one.raterId), occasions.at(one.occasionCode)});
    const RubricRevision rubric =
        RubricRepository(centre.connection()).revision(one.rubricRevisionId).value();
    for (const RubricLine& row : rubric.rows) {
      sheet.rows.push_back({row.code, row.scale.lo, ""});
    }
    sheets.submit(one.id, centre.session().ids().newUuid(), sheet, "", centre.session().now_us());
  }
}

void submitEvaluationMarks(AdministratorDesk& office, const Crowd& crowd) {
  const Campaign campaign = campaigns(office.centre.session()).front().campaign;
  std::vector<std::string> models;
  for (const CampaignModel& model : campaign.models) {
    models.push_back(model.code);
  }
  std::vector<EvaluationMark> marks;
  for (const EvaluationRating& rating :
       demonstrationEvaluationMarks(campaign.instrument, crowd.people, models, kMarkSeed)) {
    if (!rating.steps) {
      continue;
    }
    marks.push_back({.id = office.centre.session().ids().newUuid(),
                     .raterId = crowd.idOf.at(rating.rater),
                     .modelCode = rating.model,
                     .indexNumber = static_cast<std::int64_t>(rating.index + 1),
                     .score_steps = *rating.steps,
                     .submittedUtc_us = office.centre.session().now_us()});
  }
  EXPECT_EQ(marks.size(), kEvaluationMarks);
  EvaluationRepository(office.centre.connection()).submit(campaign.id, marks);
}

void expectNumbersOfTheCommandLine(const fs::path& table, const Crowd& crowd, const fs::path& folder) {
  const CohortNumbers report(table);
  expectEvaluationOfTheCommand(report, folder);

  std::map<std::pair<std::string, std::string>, std::int64_t> last;  // by trainee and rater, as in the report
  for (const TrainingMark& mark : demonstrationTrainingMarks({10, 100, 10}, crowd.people, kMarkSeed)) {
    if (mark.occasion == 2 && mark.group == 0) {
      last[{mark.trainee, mark.rater}] = mark.steps;
    }
  }
  std::string marks = "target,rater,score\n";
  for (const auto& [who, steps] : last) {
    marks += who.first + "," + who.second + "," + std::to_string(steps / 10) + "." +
             std::to_string(steps % 10) + "\n";
  }
  expectAgreementOfTheCommand(report, marks, folder);
}

}  // namespace torsio::gui::testing
