// SPDX-License-Identifier: GPL-3.0-or-later
// Training before being scored: stopped, or noted with a reason, and explained.
#include <functional>
#include <string>

#include <QApplication>
#include <QDialogButtonBox>
#include <QInputDialog>
#include <QPushButton>
#include <QTimer>
#include <gtest/gtest.h>

#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/rubric.h"
#include "db/connection/row_reader.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/app/support/training_centre.h"

namespace torsio::gui {
namespace {

/// Asks ten chiefs for the live sheet of T-01 before training.
void askTenChiefsForFirstSheet(torsio::testing::TrainingCentre& centre) {
  std::vector<Rater> chiefs(10);
  std::vector<Assignment> sheets;
  centre.connection().execute(insertInto("curriculum_occasion", "version_id, occasion, after_exposure_us"),
                              {centre.cohort().curriculumVersionId, "pre", 0});
  SheetRepository repository(centre.connection());
  RubricRepository rubrics(centre.connection());
  rubrics.addRubric("rubric", "Twist", 1, false);
  rubrics.addRevision({.id = "revision", .rubricId = "rubric", .number = 1, .overall = {0, 100, 10}});
  for (std::size_t i = 0; i < chiefs.size(); ++i) {
    const std::string number = std::to_string(i + 11);
    chiefs[i].person = {.id = "chief-" + number, .code = "R-" + number, .createdUtc_us = 1};
    chiefs[i].classCode = "chief";
    sheets.push_back({.id = "sheet-" + number,
                      .raterId = chiefs[i].person.id,
                      .enrolmentId = centre.enrolment(),
                      .occasionCode = "pre",
                      .rubricRevisionId = "revision",
                      .caseLabel = "7L",
                      .position = 1,
                      .assignedBy = "office",
                      .assignedUtc_us = 1});
  }
  PeopleRepository(centre.connection()).addRaters(chiefs);
  repository.assign(sheets);
}

TEST(StationPages, TrainingBeforeAnySheetIsExplainedAndStartsOnlyWithANotedReason) {
  torsio::testing::TrainingCentre centre;
  askTenChiefsForFirstSheet(centre);
  Station station(centre);
  QStringList read;
  const auto begin = [&](const std::function<void(QInputDialog&)>& answer) {
    station.open(PageId::kNextStep);
    station.press("begin");
    if (station.pageId == PageId::kDeviceCheck) {  // once a day
      station.press("goOn");
    }
    QTimer::singleShot(0, [&read, answer] {
      auto* asked = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(asked, nullptr);
      read << asked->labelText();
      answer(*asked);
    });
    station.press("start");
  };
  const auto noted = [&] { return StudyRepository(centre.connection()).deviations(centre.cohort().id); };

  begin([](QInputDialog& asked) {
    QPushButton* anyway = asked.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    EXPECT_FALSE(anyway->isEnabled()) << "without a reason nothing begins";
    asked.setTextValue(QStringLiteral("   "));
    EXPECT_FALSE(anyway->isEnabled());
    asked.reject();
  });

  ASSERT_EQ(read.size(), 1);
  EXPECT_TRUE(read[0].contains(QStringLiteral("Only 0 of 10 sheet(s) for this occasion are in")))
      << read[0].toStdString();
  EXPECT_TRUE(testing::eventually([&] { return station.pageId == PageId::kNextStep; }));
  EXPECT_TRUE(noted().empty());
  EXPECT_TRUE(StudyRepository(centre.connection()).trialIds(centre.cohort().id).empty());

  begin([](QInputDialog& asked) {
    asked.setTextValue(QStringLiteral("the arm is out of order"));
    asked.accept();
  });

  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  ASSERT_EQ(noted().size(), 1U);
  EXPECT_EQ(noted()[0].kind, "trained before scoring");
  EXPECT_TRUE(noted()[0].description.ends_with("0 of 10 sheets were in: the arm is out of order"))
      << noted()[0].description;
  EXPECT_EQ(noted()[0].enrolmentId, centre.enrolment());
}

}  // namespace
}  // namespace torsio::gui
