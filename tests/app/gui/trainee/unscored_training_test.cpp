// SPDX-License-Identifier: GPL-3.0-or-later
// Training before being scored: stopped, or noted with a reason, and explained.

#include <functional>
#include <string>

#include <QApplication>
#include <QDialogButtonBox>
#include <QInputDialog>
#include <QPushButton>
#include <QString>
#include <QTextBrowser>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/row_reader.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/servo_health.h"
#include "sim/core/spsc_ring.h"
#include "sim/record/recorder.h"
#include "sim/record/sample_codec.h"
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

namespace {

using torsio::testing::TrainingCentre;

/// Copies a trial as recorded by a busy computer: 50 ms of each twist are missing.
TrialId tornCopy(TrainingCentre& centre, const TrialId& trialId) {
  TrialRepository trials(centre.connection());
  const Trial trial = trials.load(trialId);
  TrialHeader header = trial.header;
  header.trialId = "00000000-0000-4000-8000-00000000707a";
  SpscRing<Sample> ring(kRecordingRing);
  TrialRepository sink(centre.connection(), {.station = "station 1",
                                             .enrolmentId = centre.enrolment(),
                                             .moduleId = centre.module("first"),
                                             .attemptMode = AttemptMode::kPractice});
  Recorder recorder(ring, sink, header);
  int gripped = 0;
  for (const Sample& sample : decodeTrial(trial)) {
    gripped = sample.phase == ExercisePhase::kTwisting ? gripped + 1 : 0;
    if (gripped > 100 && gripped <= 150) {
      continue;
    }
    EXPECT_TRUE(ring.push(sample));
    recorder.pump();
  }
  static_cast<void>(recorder.finish(TrialOutcome::kCompleted, 0, ServoHealth{true, true, 50, 1}));
  return header.trialId;
}

TEST(StationPages, TheDebriefSaysThatTheComputerWasTooBusyAndNotTheTraineesFault) {
  TrainingCentre centre({.mastery = {{.metric = "force.violations", .comparison = "at_most"}}});
  const TrialId whole = centre.attempt("first", "practice", 1.0);
  const TrialId torn = tornCopy(centre, whole);
  Station station(centre);
  station.desk().lastScene = borrowed(torsio::testing::trainingBar());

  station.open(PageId::kDebrief, toQString(whole));
  EXPECT_FALSE(station.allText().contains(QStringLiteral("too busy"))) << station.allText().toStdString();
  station.open(PageId::kDebrief, toQString(torn));

  const QString told = station.allText();
  EXPECT_TRUE(told.contains(QStringLiteral("Not judged: the computer was too busy"))) << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("This is not your fault"))) << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("Close other programs"))) << told.toStdString();
  EXPECT_FALSE(told.contains(QStringLiteral("Not passed yet"))) << told.toStdString();
  EXPECT_FALSE(told.contains(QStringLiteral("Too little of this run"))) << told.toStdString();

  station.open(PageId::kTrend, QString::fromStdString(centre.module("first")));
  const QString trend = station.page->findChild<DataTable*>()->asText();
  EXPECT_TRUE(trend.contains(QStringLiteral("Not judged"))) << trend.toStdString();
  EXPECT_FALSE(trend.contains(QStringLiteral("Not passed"))) << trend.toStdString();
  station.open(PageId::kTranscript);
  EXPECT_TRUE(station.page->findChild<QTextBrowser*>()->toPlainText().contains(QStringLiteral("not judged")));
}

}  // namespace

}  // namespace torsio::gui
