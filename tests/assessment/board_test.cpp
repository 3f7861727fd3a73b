// SPDX-License-Identifier: GPL-3.0-or-later
// What the first page must and must not say of cohorts that something is wrong with.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/results/cohort_report.h"
#include "assessment/results/received_training.h"
#include "assessment/results/same_marks.h"
#include "assessment/results/study_analysis.h"
#include "assessment/scoring/demonstration_marks.h"
#include "tests/support/demonstration_cohort.h"
#include "tests/support/strange_cohorts.h"

namespace torsio {
namespace {

using testing::enteredTwice;
using ::testing::HasSubstr;
using testing::kNoPlanSaid;
using testing::kTwiceSaid;
using ::testing::Not;
using testing::soundCohort;
using testing::StrangeCohort;

std::string page(const CohortInputs& in) {
  return testing::firstPageOf(cohortReport(in));
}

void expectSaid(const std::vector<StrangeCohort>& cohorts) {
  for (const StrangeCohort& strange : cohorts) {
    const std::string said = page(strange.cohort);
    for (const std::string& sentence : strange.says) {
      EXPECT_THAT(said, HasSubstr(sentence)) << strange.name;
    }
    for (const std::string& sentence : strange.neverSays) {
      EXPECT_THAT(said, Not(HasSubstr(sentence))) << strange.name;
    }
    testing::expectWellSaid(strange.cohort);
  }
}

TEST(FirstPage, IsReadForFortyStrangeCohorts) {
  EXPECT_GE(testing::strangeAllocations().size() + testing::strangeTrainings().size() +
                testing::strangePeople().size() + testing::strangeMarks().size(),
            40U);
}

TEST(FirstPage, SaysHowTheGroupsWereMadeAndWhetherTheyWereAlike) {
  expectSaid(testing::strangeAllocations());
}

TEST(FirstPage, SaysWhichTrainingWasPlannedAndWhichWasReceived) {
  expectSaid(testing::strangeTrainings());
}

TEST(FirstPage, SaysWhoIsMissingOrThereTwice) {
  expectSaid(testing::strangePeople());
}

TEST(FirstPage, SaysWhatIsWrongWithTheMarks) {
  expectSaid(testing::strangeMarks());
}

TEST(FirstPage, APageWithoutNamesNamesNobody) {
  for (const std::vector<StrangeCohort>& cohorts :
       {testing::strangeTrainings(), testing::strangePeople(), testing::strangeMarks()}) {
    for (const StrangeCohort& strange : cohorts) {
      CohortInputs in = strange.cohort;
      in.identity = ReportIdentity::kAggregated;
      const std::string said = page(in);
      for (const CohortTrainee& trainee : in.trainees) {
        EXPECT_THAT(said, Not(HasSubstr(trainee.code))) << strange.name;
      }
    }
  }
}

TEST(FirstPage, ReservationsComeInOrderOfWhatTheyStandAgainst) {
  CohortInputs in = enteredTwice(0);
  in.equivalenceMargin.reset();
  in.sites = {"D1", "D2"};
  in.trainees[0].withdrew = in.trainees[1].withdrew = in.trainees[2].withdrew = true;
  for (std::size_t i = 3; i < 9; ++i) {
    in.trainees[i].withdrew = true;
  }
  std::string order;
  const ReportModel report = cohortReport(in);
  for (const ReportParagraph& paragraph : report.sections.front().paragraphs) {
    if (paragraph.reservation) {
      order += paragraph.str() + "\n";
    }
  }
  std::size_t at = 0;
  for (const char* one : {kTwiceSaid, "centres were pooled", "trainees withdrew", kNoPlanSaid}) {
    const std::size_t found = order.find(one);
    ASSERT_NE(found, std::string::npos) << one << "\n" << order;
    EXPECT_GE(found, at) << one;
    at = found;
  }
}

/// How many simulated cohorts of the demonstration's design are said to contain somebody twice, of `cohorts`.
int falseAlarms(int cohorts, std::size_t raters, std::size_t occasions) {
  const CohortInputs shape = testing::demonstrationCohort();
  int alarms = 0;
  for (int seed = 1; seed <= cohorts; ++seed) {
    DemonstrationPeople people{{{}, {}, {}}, {}, {}};
    std::vector<std::string> trainees;
    std::vector<std::size_t> groupOf;
    for (const CohortTrainee& trainee : shape.trainees) {
      people.groups[trainee.group].push_back(trainee.code);
      trainees.push_back(trainee.code);
      groupOf.push_back(trainee.group);
    }
    for (std::size_t r = 0; r < raters; ++r) {
      people.raters.push_back("R" + std::to_string(100 + r));
    }
    std::vector<OccasionMarks> marks(occasions);
    for (OccasionMarks& at : marks) {
      at.marks.assign(trainees.size(), std::vector<std::optional<double>>(raters));
      for (std::size_t r = 0; r < raters; ++r) {
        at.present.push_back(r);
      }
    }
    for (const TrainingMark& mark :
         demonstrationTrainingMarks(shape.trainingScale, people, static_cast<std::uint64_t>(seed))) {
      if (mark.occasion < occasions) {
        const auto i = std::find(trainees.begin(), trainees.end(), mark.trainee) - trainees.begin();
        const auto r =
            std::find(people.raters.begin(), people.raters.end(), mark.rater) - people.raters.begin();
        marks[mark.occasion].marks[static_cast<std::size_t>(i)][static_cast<std::size_t>(r)] =
            pointsFromSteps(mark.steps, shape.trainingScale);
      }
    }
    for (OccasionMarks& at : marks) {
      IncompleteRatings byRater(raters);
      for (std::size_t r = 0; r < raters; ++r) {
        for (const std::vector<std::optional<double>>& row : at.marks) {
          byRater[r].push_back(row[r]);
        }
      }
      at.reliability = incompleteReliability(byRater, groupOf);
    }
    alarms += traineesMarkedAlike(trainees, marks).empty() ? 0 : 1;
  }
  return alarms;
}

TEST(SameMarks, NobodyIsSaidToBeThereTwiceInTwoHundredSimulatedCohorts) {
  EXPECT_EQ(falseAlarms(200, 10, 3), 0);
  EXPECT_EQ(falseAlarms(200, 5, 3), 0);
  EXPECT_LE(falseAlarms(200, 10, 1), 10);  // one in twenty
  EXPECT_LE(falseAlarms(200, 3, 2), 10);
}

TEST(ReceivedTraining, NothingNotedIsNoTraining) {
  CohortInputs in = soundCohort();
  in.doses.erase(in.doses.begin());
  const std::vector<ReceivedTraining> found = receivedTraining(in);
  ASSERT_EQ(found.size(), 30U);
  EXPECT_EQ(found[0].received, Received::kNothing);
  EXPECT_EQ(found[1].received, Received::kAsPlanned);
}

TEST(FirstPage, SaysThatSeveralCentresWerePooledAndWhatIsNotShown) {
  CohortInputs in = testing::demonstrationCohort();
  EXPECT_THAT(page(in), Not(HasSubstr("centres were pooled")));
  in.sites = {"D1", "D2"};
  EXPECT_THAT(page(in),
              HasSubstr("The data of 2 centres were pooled (D1, D2). No analysis takes account of the "
                        "centre"));
}

}  // namespace
}  // namespace torsio
