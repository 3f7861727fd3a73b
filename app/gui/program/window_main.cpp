// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/program/window_main.h"

#include <cstdio>
#include <optional>

#include <QApplication>
#include <QCommandLineParser>
#include <QPalette>
#include <QScreen>
#include <QStandardPaths>

#include "app/gui/base/translated_text.h"
#include "app/gui/practice/simulator_window.h"
#include "app/gui/program/all_pages.h"
#include "app/gui/program/option_refusal.h"
#include "app/gui/program/screenshot.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/widgets/icons.h"
#include "app/outputs/charts/typeface.h"
#include "app/services/access/first_run.h"
#include "app/services/base/assets.h"
#include "app/services/base/build_info.h"
#include "app/services/recording/unstored_trials.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

struct WindowOptions {
  SceneRequest scene;
  std::optional<ThemeKind> theme;
  std::optional<ScreenshotRequest> screenshot;
  std::optional<double> rateOver_s;
  bool simulator = false;  ///< an organ or a picture was asked for
  bool kiosk = false;
  QString database;
};

double numberOf(const QCommandLineParser& parser, const QString& option) {
  bool sound = false;
  const double value = parser.value(option).toDouble(&sound);
  if (!sound || !std::isfinite(value)) {
    refuseOption(Text::tr("'%1' is not a number", parser.value(option).toStdString()), "--" + option,
                 Text::tr("Write it like 90 or 22.5"));
  }
  return value;
}

QSize sizeOf(const QString& text) {
  const QStringList parts = text.split(QLatin1Char('x'));
  const QSize size = parts.size() == 2 ? QSize(parts[0].toInt(), parts[1].toInt()) : QSize();
  if (size.width() < 320 || size.height() < 240 || size.width() > 7680 || size.height() > 4320) {
    refuseOption(Text::tr("'%1' is not a size", text.toStdString()), QStringLiteral("--size"),
                 Text::tr("Write it like 1280x800; 320x240 to 7680x4320"));
  }
  return size;
}

/// One of a few words.
QString wordOf(const QCommandLineParser& parser, const QString& option, const QStringList& words) {
  const QString word = parser.value(option);
  if (!words.contains(word)) {
    refuseOption(Text::tr("'%1' is not known", word.toStdString()), "--" + option,
                 Text::tr("Use one of: %1", words.join(QStringLiteral(", ")).toStdString()));
  }
  return word;
}

bool looksLikeFile(const QString& organ) {
  return organ.contains(QLatin1Char('/')) || organ.contains(QLatin1Char('\\')) ||
         organ.contains(QLatin1Char('.'));
}

SceneRequest sceneOf(const QCommandLineParser& parser) {
  SceneRequest scene;
  scene.assets = assetsFolder();
  const QString organ = parser.value(QStringLiteral("organ"));
  if (looksLikeFile(organ)) {
    scene.organFile = toPath(organ);
  } else if (!organ.isEmpty()) {
    scene.id = organ.toStdString();
  }
  const QString unit = wordOf(parser, QStringLiteral("organ-unit"), {"mm", "cm", "m"});
  scene.organScale_m = unit == QLatin1String("mm") ? 0.001 : (unit == QLatin1String("cm") ? 0.01 : 1.0);
  scene.pattern = parser.value(QStringLiteral("pattern")).toStdString();
  if (parser.isSet(QStringLiteral("formulation"))) {
    const QString word = wordOf(parser, QStringLiteral("formulation"), {"paper", "saint-venant"});
    scene.formulation = word == QLatin1String("paper") ? Formulation::kPaper : Formulation::kSaintVenant;
  }
  return scene;
}

ScreenshotRequest pictureOf(const QCommandLineParser& parser, const SceneRequest& scene) {
  ScreenshotRequest picture;
  picture.file = std::filesystem::path(parser.value(QStringLiteral("screenshot")).toStdString());
  picture.scene = scene;
  if (parser.isSet(QStringLiteral("angle"))) {
    picture.angle_rad = radians(numberOf(parser, QStringLiteral("angle")));
  }
  picture.size = sizeOf(parser.value(QStringLiteral("size")));
  picture.sceneOnly = parser.isSet(QStringLiteral("scene-only"));
  picture.lattice = parser.isSet(QStringLiteral("lattice"));
  picture.wireframe = parser.isSet(QStringLiteral("wireframe"));
  picture.shear = parser.isSet(QStringLiteral("shear"));
  picture.markers = parser.isSet(QStringLiteral("markers"));
  picture.ghost = parser.isSet(QStringLiteral("ghost"));
  picture.quality = wordOf(parser, QStringLiteral("quality"), {"fast", "fine"}) == QLatin1String("fast")
                        ? RenderQuality::kFast
                        : RenderQuality::kFine;
  picture.strip = parser.isSet(QStringLiteral("film-strip"));
  picture.sides = parser.isSet(QStringLiteral("six-sides"));
  picture.zoom = numberOf(parser, QStringLiteral("zoom"));
  picture.orbit_deg = numberOf(parser, QStringLiteral("orbit"));
  return picture;
}

void addOptions(QCommandLineParser& parser) {
  const auto add = [&parser](const char* name, const char* text, const char* value, const char* standard) {
    parser.addOption(QCommandLineOption(QLatin1String(name), QLatin1String(text), QLatin1String(value),
                                        QLatin1String(standard)));
  };
  add("organ", "Scene or mesh file", "ID|FILE", "");
  add("organ-unit", "Unit of the mesh file: mm, cm, m", "UNIT", "mm");
  add("pattern", "Twist pattern of the scene", "ID", "");
  add("formulation", "paper or saint-venant", "NAME", "");
  add("theme", "light or dark", "NAME", "");
  add("screenshot", "Write one picture and end", "FILE", "");
  add("angle", "Twist in the picture, degrees; the target of the pattern without it", "DEG", "");
  add("size", "Size of the window", "WxH", "1280x800");
  add("quality", "Of the picture: fast or fine", "NAME", "fine");
  add("orbit", "Turn of the camera about the organ, degrees", "DEG", "0");
  add("zoom", "Nearer by so many notches of the wheel", "NOTCHES", "0");
  add("frame-rate", "Measure frames per second and end", "SECONDS", "");
  add("database", "Database of this run instead of the station's", "FILE|URL", "");
  parser.addOption({QStringLiteral("kiosk"), QStringLiteral("Full screen at a station, nothing else")});
  parser.addOption(
      {QStringLiteral("film-strip"), QStringLiteral("Picture of the organ at 0, 30, 60 ... degrees")});
  parser.addOption({QStringLiteral("six-sides"),
                    QStringLiteral("Picture of the organ from six sides, at rest and at the angle")});
  parser.addOption({QStringLiteral("scene-only"), QStringLiteral("Picture without panels")});
  parser.addOption({QStringLiteral("lattice"), QStringLiteral("Show ridges and sections")});
  parser.addOption({QStringLiteral("shear"), QStringLiteral("Colour the tissue by shear stress")});
  parser.addOption({QStringLiteral("markers"), QStringLiteral("Show the marker points")});
  parser.addOption({QStringLiteral("ghost"), QStringLiteral("Show the pose to reach")});
  parser.addOption({QStringLiteral("wireframe"), QStringLiteral("Show edges")});
}

void refusePassword(const QString& address) {
  if (saysPassword(address.toStdString())) {
    refuseOption(Text::tr("a password in an address is seen by every user of this machine"),
                 QStringLiteral("--database"),
                 Text::tr("Leave it out, and write it to ~/.pgpass or a service file"));
  }
}

WindowOptions parse(const QStringList& arguments) {
  QCommandLineParser parser;
  addOptions(parser);
  if (!parser.parse(arguments)) {
    refuseOption(parser.errorText().remove(QLatin1Char('.')).toStdString(), QStringLiteral("command line"),
                 Text::tr("See torsio --help"));
  }
  if (!parser.positionalArguments().isEmpty()) {
    refuseOption(Text::tr("'%1' is no option", parser.positionalArguments().front().toStdString()),
                 QStringLiteral("command line"), Text::tr("See torsio --help"));
  }
  WindowOptions options;
  options.scene = sceneOf(parser);
  if (parser.isSet(QStringLiteral("theme"))) {
    const bool dark = wordOf(parser, QStringLiteral("theme"), {"light", "dark"}) == QLatin1String("dark");
    options.theme = dark ? ThemeKind::kDark : ThemeKind::kLight;
  }
  options.kiosk = parser.isSet(QStringLiteral("kiosk"));
  options.database = parser.value(QStringLiteral("database"));
  refusePassword(options.database);
  for (const char* option : {"organ", "pattern", "formulation", "screenshot", "frame-rate"}) {
    options.simulator = options.simulator || parser.isSet(QLatin1String(option));
  }
  if (parser.isSet(QStringLiteral("frame-rate"))) {
    options.rateOver_s = numberOf(parser, QStringLiteral("frame-rate"));
  }
  if (parser.isSet(QStringLiteral("screenshot")) || options.rateOver_s) {
    options.screenshot = pictureOf(parser, options.scene);
  }
  return options;
}

/// Qt ends the whole process when it finds no display; better to say so beforehand.
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

/// Asked before the application gets a palette of ours.
bool systemIsDark() {
  return QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
}

TrialRecording ownTrialFiles() {
  const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return trialFiles((data + QStringLiteral("/trials")).toStdString());
}

/// One picture, a rate, or the bare simulator with an organ of the user's choice: no record, no sign-in.
int runSimulator(const WindowOptions& options) {
  WindowSetup setup;
  setup.assets = options.scene.assets;
  setup.remember = !options.screenshot.has_value();
  const ThemeKind usual = setup.remember && systemIsDark() ? ThemeKind::kDark : ThemeKind::kLight;
  setup.theme = options.theme.value_or(usual);
  setup.recording = ownTrialFiles();
  if (options.rateOver_s) {
    const FrameRate rate = measureFrameRate(setup, *options.screenshot, *options.rateOver_s);
    std::printf("%.1f frames/s, %lld servo ticks, %lld late, slowest seen %.0f us\n", rate.frames_per_s,
                static_cast<long long>(rate.ticks), static_cast<long long>(rate.lateTicks),
                rate.slowestTick_us);
    return 0;
  }
  if (options.screenshot) {
    takeScreenshot(setup, *options.screenshot);
    return 0;
  }
  SimulatorWindow window(setup);
  window.show();
  window.controller().load(options.scene);
  return QApplication::exec();
}

int runShell(const WindowOptions& options) {
  ShellSetup setup;
  setup.assets = options.scene.assets;
  setup.station = stationName();
  setup.locator = options.database.isEmpty() ? toQString(defaultDatabase()) : options.database;
  setup.remember = options.database.isEmpty();
  setup.groups = allPages;
  setup.theme = options.theme;
  setup.systemIsDark = systemIsDark();
  setup.kiosk = options.kiosk;
  MainWindow window(setup);
  if (setup.kiosk) {
    window.showFullScreen();
  } else {
    // A window as large as the screen would lie under its own frame and the desktop's bars.
    const QSize room = window.QWidget::screen()->availableSize();
    if (window.width() >= room.width() || window.height() >= room.height()) {
      window.setWindowState(window.windowState() | Qt::WindowMaximized);
    }
    window.QWidget::show();
  }
  window.start();
  return QApplication::exec();
}

}  // namespace

int runWindow(int argc, char** argv) {
  requireAnyDisplay();
  SceneView::prepareGraphics();
  QApplication::setApplicationName(QStringLiteral("torsio"));
  QApplication::setApplicationDisplayName(QStringLiteral("Torsio"));
  QApplication::setOrganizationName(QStringLiteral("torsio"));
  QApplication::setApplicationVersion(toQString(softwareVersion()));
  QApplication application(argc, argv);
  useTypeface(application);
  QApplication::setWindowIcon(applicationIcon());
  const WindowOptions options = parse(QApplication::arguments());
  return options.simulator ? runSimulator(options) : runShell(options);
}

}  // namespace torsio::gui
