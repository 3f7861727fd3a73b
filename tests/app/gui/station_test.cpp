// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee's way through the station with real widgets: from a locked module to the trend, on the offscreen
// platform.
#include <atomic>
#include <memory>
#include <semaphore>
#include <utility>
#include <vector>

#include <QApplication>
#include <QCheckBox>
#include <QDir>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/look/theme.h"
#include "app/gui/shell/shell_context.h"
#include "app/gui/station/debrief_page.h"
#include "app/gui/station/debrief_plot.h"
#include "app/gui/station/live_scene.h"
#include "app/gui/station/run_page.h"
#include "app/gui/station/station_desk.h"
#include "app/gui/station/station_pages.h"
#include "app/gui/station/station_words.h"
#include "app/gui/station/transcript_page.h"
#include "app/gui/station/trend_page.h"
#include "app/session/assets.h"
#include "app/session/care/station_line.h"
#include "db/repository/station_repository.h"
#include "db/repository/trial_repository.h"
#include "sim/base/error.h"
#include "sim/device/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "tests/app/gui/bar_view.h"
#include "tests/app/session/training_centre.h"

namespace torsio::gui {
namespace {

using torsio::testing::deviceWith;
using torsio::testing::kMinute_us;
using torsio::testing::kSecond_us;
using torsio::testing::TrainingCentre;

constexpr int kPatience_ms = 20'000;

template <typename Condition>
bool soon(const Condition& done) {
  QElapsedTimer waited;
  waited.start();
  while (!done() && waited.elapsed() < kPatience_ms)
    QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
  return done();
}

/// What a test does to the haptic device, and sees of it.
struct Wire {
  std::atomic<bool> unplugged{false};
  Vec3 lastForce_N{1.0, 1.0, 1.0};
};

/// The practised hand as a device that can be unplugged.
class Wired final : public HapticDevice {
 public:
  Wired(std::shared_ptr<Wire> wire, const ScriptedHandOptions& hand)
      : wire_(std::move(wire)), hand_(std::make_unique<ScriptedHand>(hand)) {}
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override {
    return hand_->capabilities();
  }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override {
    DeviceSample sample = hand_->read(time_us);
    if (wire_->unplugged) sample.status |= kDeviceLost;
    return sample;
  }
  void write(const ForceCommand& command) noexcept override {
    wire_->lastForce_N = command.force_N;
    hand_->write(command);
  }

 private:
  std::shared_ptr<Wire> wire_;
  std::unique_ptr<ScriptedHand> hand_;
};

ScriptedHandOptions practised(const Scene& scene, double target_rad) {
  ScriptedHandOptions hand;
  hand.task = handTask(scene);
  hand.task.targetAngle_rad = target_rad;
  hand.profile = {.initialSkill = 1.0, .finalSkill = 1.0, .learningTime_min = 1.0};
  hand.duration_s = 60.0;
  return hand;
}

/// A shell without a frame: it shows the page that a page asks for, as the desk does.
class Station {
 public:
  explicit Station(TrainingCentre& centre)
      : centre_(centre), shell_(centre.workplace(), assetsFolder(), ThemeKind::kLight) {
    StationDesk& desk = StationDesk::of(shell_);
    desk.loader = testing::loadBar;
    desk.realTime = false;
    desk.clock = clock;
    desk.probe = [this] { return deviceWith(light); };
    desk.openDevice = [](const Scene& scene, double target_rad) -> std::unique_ptr<HapticDevice> {
      return std::make_unique<ScriptedHand>(practised(scene, target_rad));
    };
    QObject::connect(&shell_, &ShellContext::pageWanted, &shell_,
                     [this](const QString& id, const QVariant& argument) { open(id, argument); });
    QObject::connect(&shell_, &ShellContext::failed, &shell_,
                     [this](const QString& happened) { problems << happened; });
    QObject::connect(&shell_, &ShellContext::noticed, &shell_,
                     [this](const QString& sentence) { notices << sentence; });
  }
  ~Station() { shell_.waitForJobs(); }

  void open(const QString& id, const QVariant& argument = {}) {
    if (page && !page->leave()) return;
    for (const PageEntry& entry : stationPages()) {
      if (entry.id != id) continue;
      // The page that asked is still in its slot.
      if (page) page.release()->deleteLater();
      page.reset(entry.make(shell_));
      pageId = id;
      page->retranslate();
      page->resize(1366, 768);
      page->enter(argument);
      shell_.waitForJobs();
      return;
    }
    FAIL() << "no page " << id.toStdString();
  }
  template <typename W>
  W* find(const char* name) {
    W* found = page->findChild<W*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name << " on " << pageId.toStdString();
    return found;
  }
  void press(const char* name) { find<QPushButton>(name)->click(); }
  [[nodiscard]] QString allText() const {
    QStringList texts;
    for (const QLabel* label : page->findChildren<QLabel*>()) texts << label->text();
    return texts.join(QLatin1Char('\n'));
  }
  RunPage& run() { return static_cast<RunPage&>(*page); }
  /// Opens a run of the first module with this device.
  void openRun(bool graded, const StationDesk::DeviceOpener& open) {
    StationDesk& desk = StationDesk::of(shell_);
    desk.openDevice = open;
    desk.moduleId = centre_.module("first");
    desk.graded = graded;
    desk.readiness = deviceWith(Light::kGreen);
    this->open(QStringLiteral("station.run"));
  }
  /// Time goes by for the hand and for the clock of the run.
  void train(std::int64_t span_us) {
    ASSERT_TRUE(soon([&] { return !run().fetchesDevice(); }));
    for (std::int64_t t = 0; t < span_us; t += kSecond_us) {
      if (LiveRun* live = run().scene().controller().run(); live != nullptr && live->recorded()) {
        const std::int64_t first = live->loop().ticks();
        for (std::int64_t tick = 0; tick < 1000; ++tick) live->loop().tick((first + tick) * 1000);
        live->pump();
      }
      clock->advance_us(kSecond_us);
      centre_.passTime_us(kSecond_us);
      run().tick();
      if (pageId != QStringLiteral("station.run")) return;
    }
  }

  std::shared_ptr<ManualClock> clock = std::make_shared<ManualClock>();
  Light light = Light::kGreen;
  QStringList problems;
  QStringList notices;
  std::unique_ptr<Page> page;
  QString pageId;
  ShellContext& shell() { return shell_; }

 private:
  TrainingCentre& centre_;
  ShellContext shell_;
};

TEST(Station, WhatTheDeviceCheckFoundStandsOnTheBoardOfTheDay) {
  TrainingCentre centre;
  Station station(centre);
  StationLine line({centre.locator(), "station 1", centre.workplace().actor()});
  station.shell().setLine(&line);
  station.light = Light::kRed;

  station.open(QStringLiteral("station.device"));

  ASSERT_TRUE(line.settled(std::chrono::milliseconds(kPatience_ms)));
  const StationDevice shown = storedDevice(StationRepository(centre.connection()).find("station 1").value());
  EXPECT_EQ(shown.device.str(), "Scripted hand");
  EXPECT_EQ(shown.light, Light::kRed);
  EXPECT_EQ(shown.problem.str(), "scripted");
  EXPECT_EQ(shown.checkedUtc_us, centre.workplace().now_us());
  station.shell().setLine(nullptr);
}

TEST(StationPages, AGradedRunFromTheLockedModuleToTheTrend) {
  TrainingCentre::Setup setup;
  setup.phases = {{.kind = "virtual", .label = "virtual 40 s", .duration_us = 40 * kSecond_us}};
  TrainingCentre centre(setup);
  for (int i = 0; i < 2; ++i) centre.attempt("first", "practice", 1.0);
  Station station(centre);

  station.open(QStringLiteral("station.next"));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("First master: Quarter turn, second")));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Mastered")));
  station.press("begin");

  ASSERT_EQ(station.pageId, QStringLiteral("station.device"));
  EXPECT_EQ(station.find<QLabel>("verdict")->text(), QStringLiteral("Ready"));
  station.press("goOn");

  ASSERT_EQ(station.pageId, QStringLiteral("station.briefing"));
  station.press("start");

  ASSERT_EQ(station.pageId, QStringLiteral("station.run"));
  ASSERT_TRUE(soon([&] { return station.run().busy(); }));
  EXPECT_TRUE(station.run().session()->graded());
  EXPECT_EQ(station.find<QLabel>("countdown")->text(), QStringLiteral("00:40"));
  EXPECT_FALSE(station.find<QLabel>("cue")->isVisibleTo(station.page.get()));  // no help in a graded run
  EXPECT_FALSE(station.page->leave());
  station.train(15 * kSecond_us);
  EXPECT_EQ(station.find<QLabel>("countdown")->text(), QStringLiteral("00:25"));
  station.train(kMinute_us);  // hard stop

  ASSERT_EQ(station.pageId, QStringLiteral("station.debrief"));
  auto& debrief = static_cast<DebriefPage&>(*station.page);
  EXPECT_FALSE(debrief.debrief().twists.empty());
  EXPECT_EQ(debrief.debrief().mode, "graded");
  EXPECT_NEAR(debrief.debrief().duration_s, 40.0, 0.1);
  EXPECT_EQ(debrief.debrief().moduleTitle, "Quarter turn, second");
  station.press("trend");

  ASSERT_EQ(station.pageId, QStringLiteral("station.trend"));
  EXPECT_EQ(static_cast<TrendPage&>(*station.page).trend().points.size(), 1U);
  EXPECT_EQ(station.find<QLabel>("level")->text(), QStringLiteral("2 more runs until a level is shown"));
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST(StationPages, NothingIsRecordedBeforeTheTraineeAgrees) {
  TrainingCentre::Setup setup;
  setup.consent = false;
  TrainingCentre centre(setup);
  Station station(centre);
  station.open(QStringLiteral("station.next"));
  station.press("begin");

  ASSERT_EQ(station.pageId, QStringLiteral("station.consent"));
  EXPECT_FALSE(station.find<QPushButton>("agree")->isEnabled());
  station.page->findChild<QCheckBox*>()->setChecked(true);
  station.press("agree");

  EXPECT_EQ(station.pageId, QStringLiteral("station.device"));
  EXPECT_TRUE(hasOwnConsent(centre.workplace(), "training_record"));
}

TEST(StationPages, AmberAllowsPracticeOnlyAndRedNothing) {
  TrainingCentre centre;
  for (int i = 0; i < 2; ++i) centre.attempt("first", "practice", 1.0);
  Station station(centre);
  station.light = Light::kAmber;
  station.open(QStringLiteral("station.next"));
  station.press("begin");
  EXPECT_FALSE(station.find<QPushButton>("goOn")->isEnabled());
  station.press("practise");
  EXPECT_EQ(station.pageId, QStringLiteral("station.briefing"));
  EXPECT_FALSE(StationDesk::of(station.shell()).graded);

  station.light = Light::kRed;
  station.open(QStringLiteral("station.device"));
  EXPECT_FALSE(station.find<QPushButton>("goOn")->isEnabled());
  EXPECT_EQ(station.find<QLabel>("verdict")->text(), QStringLiteral("Not ready"));
}

TEST(StationPages, RestStopsTheClockAndTheRealArmFollowsByItself) {
  TrainingCentre::Setup setup;
  setup.phases = {{.kind = "virtual", .label = "virtual 1 min", .duration_us = kMinute_us},
                  {.kind = "real", .label = "real 1 min", .duration_us = kMinute_us}};
  setup.restAllowance_us = 30 * kSecond_us;
  TrainingCentre centre(setup);
  Station station(centre);
  StationDesk::of(station.shell()).moduleId = centre.module("first");
  StationDesk::of(station.shell()).readiness = deviceWith(Light::kGreen);
  station.open(QStringLiteral("station.run"));
  ASSERT_TRUE(soon([&] { return station.run().busy(); }));
  station.train(20 * kSecond_us);
  EXPECT_TRUE(station.find<QLabel>("cue")->isVisibleTo(station.page.get()));  // practice helps

  station.press("rest");
  EXPECT_EQ(station.run().session()->run().state(), RunState::kResting);
  station.train(10 * kSecond_us);
  EXPECT_EQ(station.find<QLabel>("countdown")->text(), QStringLiteral("00:40"));
  station.press("goOn");
  EXPECT_FALSE(station.find<QPushButton>("rest")->isEnabled());  // one rest, not to be split
  station.train(40 * kSecond_us);
  EXPECT_EQ(station.run().session()->run().state(), RunState::kHandOver);
  station.press("goOn");
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Train on the real arm")));
  station.train(2 * kMinute_us);

  EXPECT_EQ(station.pageId, QStringLiteral("station.debrief"));
  const NextSteps steps = nextSteps(centre.workplace(), centre.person());
  EXPECT_TRUE(steps.allPhasesDone);
  EXPECT_EQ(attemptsOf(centre.workplace(), centre.person()).size(), 2U);  // the rest cut the recording in two
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST(StationPages, TheRunFitsTheSmallestScreenWithoutScrolling) {
  TrainingCentre::Setup setup;
  setup.phases = {{.kind = "virtual", .label = "virtual 40 s", .duration_us = 40 * kSecond_us},
                  {.kind = "real", .label = "real 40 s", .duration_us = 40 * kSecond_us}};
  setup.restAllowance_us = 20 * kSecond_us;
  TrainingCentre centre(setup);
  Station station(centre);
  applyTheme(*qApp, theme(ThemeKind::kLight));
  StationDesk::of(station.shell()).moduleId = centre.module("first");
  StationDesk::of(station.shell()).readiness = deviceWith(Light::kGreen);

  station.open(QStringLiteral("station.run"));
  ASSERT_TRUE(soon([&] { return station.run().busy(); }));
  station.page->resize(1146, 650);  // what the rail and the bars leave of 1366 x 768
  station.page->show();
  station.find<QLabel>("cue")->setText(QStringLiteral("Nearly there. Slow down."));
  QApplication::processEvents();

  EXPECT_EQ(station.page->size(), QSize(1146, 650));
  EXPECT_TRUE(station.find<QLabel>("cue")->isVisible());
  EXPECT_EQ(station.page->findChild<QScrollArea*>()->verticalScrollBar()->maximum(), 0);
}

/// The device is unplugged, and everybody gets to know.
void unplug(Station& station, Wire& wire) {
  wire.unplugged = true;
  LiveRun* live = station.run().scene().controller().run();
  const std::int64_t first = live->loop().ticks();
  for (std::int64_t tick = 0; tick < 20; ++tick) live->loop().tick((first + tick) * 1000);
  live->pump();
  station.run().scene().frame(0.016);
}

/// Outcomes of what is stored, in any order.
std::vector<TrialOutcome> outcomes(TrainingCentre& centre) {
  std::vector<TrialOutcome> all;
  for (const TrialListing& trial : TrialRepository(centre.connection()).list())
    if (trial.summary) all.push_back(trial.summary->outcome);
  return all;
}

TEST(StationPages, AGradedRunThatLosesItsDeviceEndsWithoutForceAndCostsNoAttempt) {
  TrainingCentre centre;
  Station station(centre);
  const auto wire = std::make_shared<Wire>();
  station.openRun(true, [wire](const Scene& scene, double target_rad) {
    return std::make_unique<Wired>(wire, practised(scene, target_rad));
  });
  ASSERT_TRUE(soon([&] { return station.run().busy(); }));
  station.train(5 * kSecond_us);

  unplug(station, *wire);

  EXPECT_EQ(norm(wire->lastForce_N), 0.0);
  EXPECT_EQ(station.run().session(), nullptr);
  EXPECT_FALSE(station.run().busy());
  ASSERT_EQ(station.problems.size(), 1);
  EXPECT_EQ(station.problems[0], QStringLiteral("The haptic device was lost: the graded run has ended"));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("No run goes on")));
  EXPECT_EQ(outcomes(centre), std::vector<TrialOutcome>{TrialOutcome::kInterrupted});
  EXPECT_FALSE(StationDesk::of(station.shell()).readiness.has_value());  // to be checked anew
  const NextSteps steps = nextSteps(centre.workplace(), centre.person());
  EXPECT_EQ(stepOf(steps, centre.module("first")).attempts, 0);
}

TEST(StationPages, PracticeThatLosesItsDeviceGoesOnWithTheMouse) {
  TrainingCentre centre;
  Station station(centre);
  const auto wire = std::make_shared<Wire>();
  station.openRun(false, [wire](const Scene& scene, double target_rad) {
    return std::make_unique<Wired>(wire, practised(scene, target_rad));
  });
  ASSERT_TRUE(soon([&] { return station.run().busy(); }));
  station.train(5 * kSecond_us);

  unplug(station, *wire);

  EXPECT_EQ(norm(wire->lastForce_N), 0.0);
  ASSERT_FALSE(station.notices.empty());
  EXPECT_EQ(station.notices.back(),
            QStringLiteral("The haptic device was lost. You go on with mouse and keyboard"));
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
  EXPECT_TRUE(station.run().busy());
  station.train(2 * kSecond_us);
  EXPECT_EQ(station.run().scene().controller().mode(), SimulationController::Mode::kRecording);
  EXPECT_EQ(outcomes(centre), std::vector<TrialOutcome>{TrialOutcome::kInterrupted});
}

TEST(StationPages, TheClockWaitsForTheDeviceAndTheWindowDoesNot) {
  TrainingCentre::Setup setup;
  setup.phases = {{.kind = "virtual", .label = "virtual 1 min", .duration_us = kMinute_us}};
  setup.restAllowance_us = 30 * kSecond_us;
  TrainingCentre centre(setup);
  Station station(centre);
  auto gate = std::make_shared<std::binary_semaphore>(0);
  station.openRun(true, [gate](const Scene& scene, double target_rad) {
    gate->acquire();  // a driver that takes its time
    return std::make_unique<ScriptedHand>(practised(scene, target_rad));
  });
  ASSERT_TRUE(soon([&] { return station.run().fetchesDevice(); }));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Getting the haptic device ready")));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Your time has not begun yet")));
  EXPECT_FALSE(station.run().busy());
  station.clock->advance_us(5 * kSecond_us);
  gate->release();
  ASSERT_TRUE(soon([&] { return station.run().busy(); }));
  EXPECT_EQ(station.find<QLabel>("countdown")->text(), QStringLiteral("01:00"));
  station.train(10 * kSecond_us);

  // After a rest it is opened again; that takes nothing from the training either.
  station.press("rest");
  station.train(5 * kSecond_us);
  station.press("goOn");
  ASSERT_TRUE(station.run().fetchesDevice());
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Your training clock stands still")));
  for (int i = 0; i < 4; ++i) {
    station.clock->advance_us(kSecond_us);
    station.run().tick();
  }
  gate->release();
  station.train(kSecond_us);

  EXPECT_EQ(station.find<QLabel>("countdown")->text(), QStringLiteral("00:49"));
  EXPECT_EQ(station.run().scene().controller().mode(), SimulationController::Mode::kRecording);
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST(StationPages, WaitingForTheDeviceCanBeGivenUp) {
  TrainingCentre centre;
  Station station(centre);
  auto gate = std::make_shared<std::binary_semaphore>(0);
  auto given = std::make_shared<std::atomic<int>>(0);
  station.openRun(true, [gate, given](const Scene& scene, double target_rad) {
    gate->acquire();
    ++*given;
    return std::make_unique<ScriptedHand>(practised(scene, target_rad));
  });
  ASSERT_TRUE(soon([&] { return station.run().fetchesDevice(); }));

  gate->release();  // it arrives while nobody waits any more
  station.press("goOn");

  EXPECT_EQ(station.pageId, QStringLiteral("station.next"));
  EXPECT_TRUE(soon([&] { return given->load() == 1; }));
  EXPECT_TRUE(outcomes(centre).empty());
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST(StationPages, AGradedRunDoesNotBeginWithADeviceThatCannotBeOpened) {
  TrainingCentre centre;
  Station station(centre);
  station.openRun(true, [](const Scene&, double) -> std::unique_ptr<HapticDevice> {
    throw Error(ErrorCode::kDevice, "the device does not answer", "port 1", "Check its cable");
  });

  ASSERT_TRUE(soon([&] { return !station.problems.empty(); }));

  EXPECT_EQ(station.problems[0],
            QStringLiteral("The haptic device is not ready: the graded run did not begin"));
  EXPECT_EQ(station.run().session(), nullptr);
  EXPECT_TRUE(outcomes(centre).empty());
  EXPECT_FALSE(StationDesk::of(station.shell()).readiness.has_value());
}

TEST(StationPages, ARunThatWasCutOffIsShownAsInterrupted) {
  TrainingCentre centre;
  {
    Station station(centre);
    StationDesk::of(station.shell()).moduleId = centre.module("first");
    StationDesk::of(station.shell()).readiness = deviceWith(Light::kGreen);
    station.open(QStringLiteral("station.run"));
    ASSERT_TRUE(soon([&] { return station.run().busy(); }));
    station.train(5 * kSecond_us);
    // Everything goes without a word, as when the power fails; tests/app/session kills a real program.
  }
  centre.passTime_us(utcNow_us() - torsio::testing::kCentreTime_us + kMinute_us);
  Station station(centre);

  station.open(QStringLiteral("station.next"));

  EXPECT_TRUE(station.allText().contains(QStringLiteral("was interrupted")))
      << station.allText().toStdString();
  EXPECT_EQ(nextSteps(centre.workplace(), centre.person()).interrupted.size(), 1U);
}

TEST(StationPages, AWeaknessLeadsToItsSeconds) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", 0.1, 30.0);
  const Debrief told = torsio::debrief(centre.workplace(), trial, {}, &torsio::testing::trainingBar());
  ASSERT_FALSE(told.weaknesses.empty());
  DebriefPlot plot;
  plot.setDebrief(told);
  const Seconds all = plot.range();

  plot.show(told.weaknesses[0].when);

  EXPECT_LT(plot.range().to_s - plot.range().from_s, all.to_s - all.from_s);
  EXPECT_LE(plot.range().from_s, told.weaknesses[0].when.from_s);
  EXPECT_GE(plot.range().to_s, told.weaknesses[0].when.to_s - 1e-9);
  plot.showAll();
  EXPECT_DOUBLE_EQ(plot.range().to_s, told.duration_s);
}

TEST(StationPages, TheTranscriptIsAPdf) {
  TrainingCentre centre;
  centre.attempt("first", "practice", 1.0);
  Station station(centre);
  station.open(QStringLiteral("station.transcript"));
  const std::filesystem::path file = centre.folder() / "transcript.pdf";

  static_cast<TranscriptPage&>(*station.page).writePdf(file);

  EXPECT_GT(std::filesystem::file_size(file), 2'000U);
}

TEST(StationPages, EveryPageCanBeEnteredByABeginner) {
  TrainingCentre centre;
  Station station(centre);
  for (const char* id : {"station.next", "station.debrief", "station.trend", "station.remarks",
                         "station.transcript", "station.device", "station.consent"}) {
    station.open(QLatin1String(id));
    EXPECT_TRUE(station.problems.empty()) << id << ": " << station.problems.join('\n').toStdString();
  }
}

TEST(StationWords, RoundCountdownsUpSoThatZeroIsTheEnd) {
  EXPECT_EQ(StationWords::clock(0), QStringLiteral("00:00"));
  EXPECT_EQ(StationWords::clock(1), QStringLiteral("00:01"));
  EXPECT_EQ(StationWords::clock(20 * kMinute_us), QStringLiteral("20:00"));
}

}  // namespace
}  // namespace torsio::gui
