// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/trainee/station_pages.h"

#include <algorithm>
#include <vector>

#include <QCoreApplication>
#include <QElapsedTimer>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/briefing_page.h"
#include "app/gui/trainee/consent_page.h"
#include "app/gui/trainee/debrief_page.h"
#include "app/gui/trainee/debrief_plot.h"
#include "app/gui/trainee/device_check_page.h"
#include "app/gui/trainee/live_scene.h"
#include "app/gui/trainee/next_step_page.h"
#include "app/gui/trainee/remarks_page.h"
#include "app/gui/trainee/run_page.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/transcript_page.h"
#include "app/gui/trainee/trend_page.h"
#include "app/gui/widgets/child.h"
#include "app/services/base/assets.h"
#include "app/services/demonstration/demonstration_station.h"
#include "app/services/training/attempts.h"
#include "sim/core/contracts.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"

namespace torsio::gui {

namespace {

template <typename P>
PageEntry entry(PageId id) {
  return {id, [](ShellContext& shell) -> Page* { return new P(shell); }};
}

/// Returns the entry of a page that uses the station's desk.
template <typename P>
PageEntry entry(PageId id, const std::shared_ptr<StationDesk>& desk) {
  return {id, [desk](ShellContext& shell) -> Page* {
            desk->announce(shell.line());
            return new P(shell, *desk);
          }};
}

}  // namespace

std::vector<PageEntry> stationPages(const std::shared_ptr<StationDesk>& desk) {
  return {entry<NextStepPage>(PageId::kNextStep, desk),
          entry<DebriefPage>(PageId::kDebrief, desk),
          entry<TrendPage>(PageId::kTrend),
          entry<RemarksPage>(PageId::kRemarks),
          entry<TranscriptPage>(PageId::kTranscript),
          entry<DeviceCheckPage>(PageId::kDeviceCheck, desk),
          entry<ConsentPage>(PageId::kConsent),
          entry<BriefingPage>(PageId::kBriefing, desk),
          entry<RunPage>(PageId::kRun, desk)};
}

// Pages in meaningful states for screenshots, with the demonstration cohort.

namespace {

constexpr int kPatience_ms = 30'000;
constexpr double kPartOfTheWay = 0.7;
constexpr double kHand_s = 60.0;
constexpr double kExpertAt = 0.45;  // fraction of the replay

DemonstrationStation laidOut(SessionContext& session) {
  return storeDemonstrationStation(session.connectionWithoutRight(), session.ids(), assetsFolder(),
                                   session.now_us());
}

template <typename Condition>
void waitFor(const Condition& done) {
  QElapsedTimer waited;
  waited.start();
  while (!done() && waited.elapsed() < kPatience_ms) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  }
}

QVariant nothing(SessionContext& session) {
  static_cast<void>(laidOut(session));
  return {};
}

QVariant later(SessionContext& session) {
  static_cast<void>(laidOut(session));
  return QStringLiteral("later");
}

/// Makes the choice that a trainee would have made before.
void choose(ShellContext& shell, StationDesk& desk) {
  const NextSteps steps = nextSteps(shell.session(), shell.session().actor().personId);
  if (steps.next) {
    desk.moduleId = steps.modules[*steps.next].module.id;
  }
  desk.graded = false;
  desk.readiness = pointerReadiness(true);
}

void showBriefing(Page& page) {
  auto& briefing = static_cast<BriefingPage&>(page);
  choose(briefing.context(), briefing.desk());
  briefing.enter({});
  SimulationController& controller = child<LiveScene>(briefing, "scene").controller();
  waitFor([&] { return controller.playback() != nullptr; });
  if (controller.playback() == nullptr) {
    return;
  }
  controller.playback()->setPlaying(false);
  controller.playback()->seek_us(
      static_cast<std::int64_t>(kExpertAt * static_cast<double>(controller.playback()->duration_us())));
}

std::unique_ptr<HapticDevice> practisedHand(const Scene& scene, double target_rad) {
  ScriptedHandOptions hand;
  hand.task = handTask(scene, target_rad);
  hand.profile = {.initialSkill = 1.0, .finalSkill = 1.0, .learningTime_min = 1.0};
  hand.duration_s = kHand_s;
  return std::make_unique<ScriptedHand>(hand);
}

void showRun(Page& page) {
  auto& run = static_cast<RunPage&>(page);
  choose(run.context(), run.desk());
  run.desk().openDevice = practisedHand;
  run.enter({});
  SimulationController& controller = child<LiveScene>(run, "scene").controller();
  waitFor([&] {
    const double target_rad = controller.target_rad();
    return run.busy() && controller.state().response.angle_rad / target_rad > kPartOfTheWay;
  });
}

void showFinding(Page& page) {
  auto& debrief = static_cast<DebriefPage&>(page);
  waitFor([&] { return !debrief.debrief().trialId.empty(); });
  if (!debrief.debrief().weaknesses.empty()) {
    child<DebriefPlot>(debrief, "plot").show(debrief.debrief().weaknesses.front().when);
  }
}

/// Returns the last organ that the trainee untwisted; in the demonstration, everybody who signs in has one.
QVariant untwisting(SessionContext& session) {
  static_cast<void>(laidOut(session));
  const std::vector<Attempt> attempts = attemptsOf(session, session.actor().personId);
  const auto last = std::find_if(attempts.rbegin(), attempts.rend(), [](const Attempt& attempt) {
    return attempt.values.contains(Quantity::kUntwisted);
  });
  TORSIO_EXPECTS(last != attempts.rend());
  return toQString(last->trialId);
}

ScreenEntry screen(const char* name, PageId page, std::function<QVariant(SessionContext&)> argument,
                   std::function<void(Page&)> prepare = {}) {
  return {.name = QLatin1String(name),
          .role = QStringLiteral("trainee"),
          .pageId = page,
          .argument = std::move(argument),
          .prepare = std::move(prepare)};
}

}  // namespace

std::vector<ScreenEntry> stationScreens() {
  return {screen("station-next-step", PageId::kNextStep, nothing),
          screen("station-device-check", PageId::kDeviceCheck, nothing),
          screen("station-consent", PageId::kConsent, nothing),
          screen("station-briefing", PageId::kBriefing, later, showBriefing),
          screen("station-run", PageId::kRun, later, showRun),
          screen(
              "station-debrief", PageId::kDebrief,
              [](SessionContext& session) -> QVariant { return toQString(laidOut(session).newestTrialId); },
              showFinding),
          screen("station-debrief-untwisting", PageId::kDebrief, untwisting),
          screen(
              "station-trend", PageId::kTrend,
              [](SessionContext& session) -> QVariant { return toQString(laidOut(session).firstModuleId); },
              [](Page& page) { static_cast<TrendPage&>(page).chooseQuantity(Quantity::kTime); }),
          screen("station-remarks", PageId::kRemarks, nothing),
          screen("station-transcript", PageId::kTranscript, nothing)};
}

}  // namespace torsio::gui
