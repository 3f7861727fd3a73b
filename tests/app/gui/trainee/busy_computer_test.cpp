// SPDX-License-Identifier: GPL-3.0-or-later
// What a trainee is told about a run that the computer was too busy to record completely.
#include <QString>
#include <QTextBrowser>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/study/curriculum.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/servo_health.h"
#include "sim/core/spsc_ring.h"
#include "sim/record/recorder.h"
#include "sim/record/sample_codec.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/app/support/training_centre.h"

namespace torsio::gui {
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
