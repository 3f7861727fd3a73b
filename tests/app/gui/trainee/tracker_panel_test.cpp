// SPDX-License-Identifier: GPL-3.0-or-later
// A phase on the real arm, with a tracker made of OpenIGTLink's own classes on the instrument.
#include "app/gui/trainee/tracker_panel.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include <QLineEdit>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/connectors/tracker/tracker_choice.h"
#include "app/gui/trainee/debrief_page.h"
#include "app/services/recording/kept_digests.h"
#include "app/services/training/attempts.h"
#include "assessment/attempt/foreign_measures.h"
#include "assessment/catalogue/quantity.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/clock.h"
#include "sim/core/foreign_recording.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/support/fake_tracker.h"

namespace torsio::gui {
namespace {

using torsio::testing::FakeTracker;
using torsio::testing::kSecond_us;
using torsio::testing::TrainingCentre;

constexpr std::int64_t kRealTime_us = 60 * kSecond_us;
constexpr int kRecorded = 100;

TrainingCentre::Setup onTheRealArm() {
  TrainingCentre::Setup setup;
  setup.phases = {{.kind = PhaseKind::kReal, .label = "real 1 min", .duration_us = kRealTime_us}};
  return setup;
}

/// Poses at 100 Hz on a line at 0.1 m/s, with a separate clock in step with the station's: a busy machine
/// sends a pose late, but with the right time stamp.
class Line {
 public:
  explicit Line(FakeTracker& tracker) : tracker_(tracker) {}

  /// Sends the next poses one after another, each at its time.
  void send(int count) {
    for (const int end = next_ + count; next_ < end; ++next_, ++sent_) {
      std::this_thread::sleep_for(std::chrono::microseconds(began_us_ + next_ * kEvery_us - clock_.now_us()));
      ASSERT_TRUE(tracker_.sendTransform("NeedleToReference", {static_cast<double>(next_), 0.0, 0.0},
                                         kItsTime_us + next_ * kEvery_us));
    }
  }
  /// Skips the poses whose time has passed.
  void skip() { next_ = std::max(next_, static_cast<int>((clock_.now_us() - began_us_) / kEvery_us) + 2); }
  void leaveOut(int count) { next_ += count; }
  [[nodiscard]] int sent() const { return sent_; }
  [[nodiscard]] int leftOut() const { return next_ - sent_; }

 private:
  static constexpr std::int64_t kEvery_us = 10'000;
  static constexpr std::int64_t kItsTime_us = 1'700'000'000'000'000;
  FakeTracker& tracker_;
  MonotonicClock clock_;
  std::int64_t began_us_ = clock_.now_us();
  int next_ = 0;
  int sent_ = 0;
};

TEST(TrackerPanel, RecordsTheInstrumentInAPhaseOnTheRealArm) {
  TrainingCentre centre(onTheRealArm());
  FakeTracker tracker;
  Station station(centre);
  station.desk().tracker = TrackerPlace{.port = tracker.port()};
  station.desk().readiness = torsio::testing::deviceWith(Light::kGreen);

  station.open(PageId::kRun);
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Only training time is logged.")));
  ASSERT_TRUE(tracker.wait());
  Line line(tracker);
  line.send(25);
  const TrackerLink& link = *station.run().findChild<TrackerPanel*>()->link();
  bool recorded = false;
  ASSERT_TRUE(testing::eventually([&] {
    if (recorded) {
      return true;  // another pose would be alone in the recording
    }
    line.skip();
    line.send(1);  // a tracker is silent after two seconds without a message
    while (link.view().counts.received < line.sent()) {  // none in transit when the recording starts
      std::this_thread::yield();
    }
    station.run().tick();
    recorded = station.allText().contains(QStringLiteral("The instrument is seen, and recorded."));
    return recorded;
  }));
  line.skip();
  line.send(kRecorded / 2);
  line.leaveOut(3);
  line.send(kRecorded / 2);
  const QString counts = QStringLiteral("Poses: %1, missing: %2,").arg(line.sent()).arg(line.leftOut());
  ASSERT_TRUE(testing::eventually([&] {
    station.run().tick();
    return station.find<QLabel>("trackerCounts")->text().startsWith(counts);
  })) << station.find<QLabel>("trackerCounts")->text().toStdString();
  station.train(2 * kRealTime_us);

  EXPECT_EQ(station.pageId, PageId::kDebrief);
  ASSERT_TRUE(testing::eventually(
      [&] { return dynamic_cast<DebriefPage&>(*station.page).debrief().realArm.has_value(); }));
  const QString told = station.allText();
  EXPECT_TRUE(told.contains(QStringLiteral("The instrument was out of view 1 time, for 0.04 s in all")))
      << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("Path and idle time leave this time out"))) << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("Out of view: 0:00.5 to 0:00.5."))) << told.toStdString();
  EXPECT_FALSE(told.contains(QStringLiteral("No twist was finished"))) << told.toStdString();
  const std::vector<TrialListing> trials = TrialRepository(centre.connection()).list();
  ASSERT_EQ(trials.size(), 1U);
  const TrialListing& trial = trials[0];
  EXPECT_TRUE(isForeign(trial.sceneId));
  EXPECT_EQ(trial.traineeCode, nextSteps(centre.session(), centre.person()).traineeCode);
  EXPECT_FALSE(trial.phaseId.empty());
  EXPECT_TRUE(trial.moduleId.empty());  // not an attempt at a module
  EXPECT_TRUE(attemptsOf(centre.session(), centre.person()).empty());
  ASSERT_TRUE(trial.summary);
  EXPECT_EQ(trial.summary->outcome, TrialOutcome::kCompleted);
  EXPECT_EQ(trial.summary->samples, kRecorded);
  ExerciseRules rules;
  const TrialDigest digest = digestOf(centre.connection(), trial, rules, 0);
  EXPECT_GT(digest.measures.values.at(Quantity::kTipPath), 0.09);
  EXPECT_FALSE(digest.measures.values.contains(Quantity::kPeakForce));
  EXPECT_EQ(digest.measures.values.at(Quantity::kTimesUnseen), 1.0);
  EXPECT_NEAR(digest.measures.values.at(Quantity::kUnseen), 0.04, 0.001);
  const std::vector<RealArmRun> runs = realArmRuns(centre.session(), centre.person());
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].sentences, foreignSentences(digest.measures.values));
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST(TrackerPanel, ConnectsToTheGivenAddressAndRemembersIt) {
  const QTemporaryDir folder;
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
  TrainingCentre centre(onTheRealArm());
  FakeTracker tracker;
  Station station(centre);
  station.desk().readiness = torsio::testing::deviceWith(Light::kGreen);
  station.open(PageId::kRun);
  EXPECT_TRUE(station.allText().contains(QStringLiteral("No tracker")));

  station.find<QLineEdit>("trackerInstrument")->setText(QStringLiteral("NeedleToReference"));
  station.find<QSpinBox>("trackerPort")->setValue(tracker.port());
  station.press("trackerConnect");

  ASSERT_TRUE(tracker.wait());
  EXPECT_FALSE(station.find<QSpinBox>("trackerPort")->isEnabled());
  EXPECT_EQ(rememberedTracker().tracker,
            (TrackerPlace{.port = tracker.port(), .instrument = "NeedleToReference"}));
  ASSERT_TRUE(tracker.sendBytes("HTTP/1.1 400 Bad Request\r\n" + std::string(200, '-')));
  ASSERT_TRUE(testing::eventually([&] {
    station.run().tick();
    return station.find<QLabel>("trackerStatus")->text().contains(QStringLiteral("not OpenIGTLink"));
  }));
  station.press("trackerConnect");
  EXPECT_TRUE(station.find<QSpinBox>("trackerPort")->isEnabled());
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

}  // namespace
}  // namespace torsio::gui
