// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <gtest/gtest.h>

#include "app/gui/trainee/live_scene.h"
#include "app/gui/trainee/run_page.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/station_pages.h"
#include "app/gui/widgets/child.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "tests/app/gui/support/bar_view.h"
#include "tests/app/gui/support/watched_shell.h"
#include "tests/app/support/training_centre.h"

namespace torsio::gui {

/// Returns a fully practised hand.
inline ScriptedHandOptions practised(const Scene& scene, double target_rad) {
  ScriptedHandOptions hand;
  hand.task = handTask(scene);
  hand.task.targetAngle_rad = target_rad;
  hand.profile = {.initialSkill = 1.0, .finalSkill = 1.0, .learningTime_min = 1.0};
  hand.duration_s = 60.0;
  return hand;
}

/// A shell without a frame: shows the page that a page requests, like the desk.
class Station {
 public:
  explicit Station(torsio::testing::TrainingCentre& centre) : centre_(centre), watched_(centre.session()) {
    StationDesk& desk = *desk_;
    desk.loader = testing::loadBar;
    desk.realTime = false;
    desk.clock = clock;
    desk.probe = [this] { return torsio::testing::deviceWith(light); };
    desk.openDevice = [](const Scene& scene, double target_rad) -> std::unique_ptr<HapticDevice> {
      return std::make_unique<ScriptedHand>(practised(scene, target_rad));
    };
    QObject::connect(&shell(), &ShellContext::pageWanted,
                     [this](PageId id, const QVariant& argument) { open(id, argument); });
  }
  /// Pages are destroyed before their shell, including previous ones whose scene is still loading.
  ~Station() {
    page.reset();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    shell().waitForJobs();
  }

  void open(PageId id, const QVariant& argument = {}) {
    if (page && !page->leave()) {
      return;
    }
    for (const PageEntry& entry : stationPages(desk_)) {
      if (entry.id != id) {
        continue;
      }
      // The requesting page is still in its slot.
      if (page) {
        page.release()->deleteLater();
      }
      page.reset(entry.make(shell()));
      pageId = id;
      page->retranslate();
      page->resize(1366, 768);
      page->enter(argument);
      shell().waitForJobs();
      return;
    }
    FAIL() << "no page " << pageText(id).toStdString();
  }
  template <typename W>
  W* find(const char* name) {
    W* found = page->findChild<W*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name << " on " << pageText(pageId.value()).toStdString();
    return found;
  }
  void press(const char* name) { find<QPushButton>(name)->click(); }
  [[nodiscard]] QString allText() const {
    QStringList texts;
    for (const QLabel* label : page->findChildren<QLabel*>()) {
      texts << label->text();
    }
    for (const QAbstractButton* button : page->findChildren<QAbstractButton*>()) {
      texts << button->text();
    }
    return texts.join(QLatin1Char('\n'));
  }
  RunPage& run() { return static_cast<RunPage&>(*page); }
  /// Opens a run of the first module with this device.
  void openRun(bool graded, const StationDesk::DeviceOpener& open) {
    StationDesk& desk = *desk_;
    desk.openDevice = open;
    desk.moduleId = centre_.module("first");
    desk.graded = graded;
    desk.readiness = torsio::testing::deviceWith(Light::kGreen);
    this->open(PageId::kRun);
  }
  /// Advances the time of hand and run.
  void train(std::int64_t span_us) {
    ASSERT_TRUE(testing::eventually([&] { return !run().fetchesDevice(); }));
    for (std::int64_t t = 0; t < span_us; t += torsio::testing::kSecond_us) {
      if (RecordedRun* live = child<LiveScene>(run(), "scene").controller().run();
          live != nullptr && live->recorded()) {
        live->step(ticksIn(1.0));
      }
      clock->advance_us(torsio::testing::kSecond_us);
      centre_.passTime_us(torsio::testing::kSecond_us);
      run().tick();
      if (pageId != PageId::kRun) {
        return;
      }
    }
  }

  std::shared_ptr<ManualClock> clock = std::make_shared<ManualClock>();
  Light light = Light::kGreen;
  std::optional<PageId> pageId;
  ShellContext& shell() { return watched_.shell(); }
  StationDesk& desk() { return *desk_; }

 private:
  torsio::testing::TrainingCentre& centre_;
  testing::WatchedShell watched_;
  std::shared_ptr<StationDesk> desk_ = std::make_shared<StationDesk>();

 public:
  QStringList& problems = watched_.failures;
  QStringList& notices = watched_.notices;
  std::unique_ptr<Page> page;
};

}  // namespace torsio::gui
