// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/program/window_main.h"

#include <cstdio>

#include <QApplication>
#include <QPalette>
#include <QScreen>
#include <QStandardPaths>

#include "app/gui/base/translated_text.h"
#include "app/gui/practice/simulator_window.h"
#include "app/gui/program/all_pages.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/widgets/icons.h"
#include "app/outputs/charts/typeface.h"
#include "app/services/access/first_run.h"
#include "app/services/base/build_info.h"
#include "app/services/recording/unstored_trials.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

/// Reports a missing display before Qt would end the process.
void requireAnyDisplay() {
#if defined(Q_OS_UNIX) && !defined(Q_OS_MACOS)
  for (const char* variable : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
    if (!qEnvironmentVariableIsEmpty(variable)) {
      return;
    }
  }
  throw Error(
      ErrorCode::kDevice, Text::tr("there is no display"),
      Text::tr("DISPLAY and WAYLAND_DISPLAY are not set"),
      Text::tr("Start it on a desktop, or through xvfb-run; commands such as 'torsio demo' need no display"));
#endif
}

/// Must be called before the application gets our palette.
bool systemIsDark() {
  return QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
}

TrialRecording ownTrialFiles() {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return trialFiles((data + QStringLiteral("/trials")).toStdString());
}

/// Takes one picture, measures the frame rate, or runs the simulator alone with an organ of the user's
/// choice: no record, no sign-in.
void runSimulator(const WindowOptions& options) {
  WindowSetup setup;
  setup.assets = options.picture.scene.assets;
  setup.remember = options.picture.file.empty() && !options.frameRate_s;
  const ThemeKind usual = setup.remember && systemIsDark() ? ThemeKind::kDark : ThemeKind::kLight;
  setup.theme = options.theme.value_or(usual);
  setup.recording = ownTrialFiles();
  if (options.frameRate_s) {
    const FrameRate rate = measureFrameRate(setup, options.picture, *options.frameRate_s);
    std::printf("%.1f frames/s, %lld servo ticks, %lld late, slowest seen %.0f us\n", rate.frames_per_s,
                static_cast<long long>(rate.ticks), static_cast<long long>(rate.lateTicks),
                rate.slowestTick_us);
    return;
  }
  if (!options.picture.file.empty()) {
    takeScreenshot(setup, options.picture);
    return;
  }
  SimulatorWindow window(setup);
  window.show();
  window.controller().load(options.picture.scene);
  QApplication::exec();
}

void runShell(const WindowOptions& options) {
  ShellSetup setup;
  setup.assets = options.picture.scene.assets;
  setup.station = stationName();
  setup.locator = toQString(options.database.empty() ? defaultDatabase() : options.database);
  setup.remember = options.database.empty();
  setup.groups = allPages;
  setup.theme = options.theme;
  setup.systemIsDark = systemIsDark();
  setup.kiosk = options.kiosk;
  MainWindow window(setup);
  if (setup.kiosk) {
    window.showFullScreen();
  } else {
    // A window as large as the screen would be covered by its own frame and the desktop's bars.
    const QSize room = window.QWidget::screen()->availableSize();
    if (window.width() >= room.width() || window.height() >= room.height()) {
      window.setWindowState(window.windowState() | Qt::WindowMaximized);
    }
    window.QWidget::show();
  }
  window.start();
  QApplication::exec();
}

}  // namespace

std::unique_ptr<QApplication> makeWindowApplication() {
  static char name[] = "torsio";
  static char* arguments[] = {name, nullptr};
  static int count = 1;
  SceneView::prepareGraphics();
  QApplication::setApplicationName(QStringLiteral("torsio"));
  QApplication::setApplicationDisplayName(QStringLiteral("Torsio"));
  QApplication::setOrganizationName(QStringLiteral("torsio"));
  auto application = std::make_unique<QApplication>(count, arguments);
  useTypeface(*application);
  QApplication::setWindowIcon(applicationIcon());
  return application;
}

void runWindow(const WindowOptions& options) {
  requireAnyDisplay();
  const std::unique_ptr<QApplication> application = makeWindowApplication();
  QApplication::setApplicationVersion(toQString(softwareVersion()));
  options.simulator ? runSimulator(options) : runShell(options);
}

}  // namespace torsio::gui
