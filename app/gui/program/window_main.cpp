// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/program/window_main.h"

#include <cstdio>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QCoreApplication>
#include <QPalette>
#include <QScreen>

#include "app/gui/administrator/administrator_pages.h"
#include "app/gui/base/language.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/physician/review_pages.h"
#include "app/gui/practice/compare_page.h"
#include "app/gui/practice/practice_page.h"
#include "app/gui/practice/simulator_window.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/station_pages.h"
#include "app/gui/widgets/icons.h"
#include "app/outputs/charts/typeface.h"
#include "app/services/access/first_run.h"
#include "app/services/access/station_name.h"
#include "app/services/access/station_record.h"
#include "app/services/base/assets.h"
#include "app/services/base/build_info.h"
#include "app/services/base/configuration.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/mesh/mesh_space.h"

namespace torsio::gui {

namespace {

QString named(const char* text) {
  return QCoreApplication::translate("Desk", text);
}

constexpr QSize kMaxSize(7680, 4320);

/// Options as typed.
struct WrittenWindow {
  WindowOptions options;
  std::string organ;
  std::string unit;  // empty: not given
  std::string formulation;
  std::string theme;
  std::string size = "1280x800";
  std::string quality = "fine";
  std::optional<double> angle_deg;
};

struct WrittenScreenshots {
  ScreenshotsRequest request;
  std::vector<std::string> sizes{"1366x768", "1920x1080"};
  std::vector<std::string> languages{"en", "zh_CN"};
  std::vector<std::string> themes{"light", "dark"};
  std::string only;
};

QSize sizeOf(const std::string& text, const QSize& smallest) {
  const QStringList parts = QString::fromStdString(text).split(QLatin1Char('x'));
  const QSize size = parts.size() == 2 ? QSize(parts[0].toInt(), parts[1].toInt()) : QSize();
  if (size != size.expandedTo(smallest).boundedTo(kMaxSize)) {
    throw CLI::ValidationError("--size", "'" + text + "' is not a size from " +
                                             std::to_string(smallest.width()) + "x" +
                                             std::to_string(smallest.height()) + " to 7680x4320");
  }
  return size;
}

ThemeKind themeOf(const std::string& name) {
  return name == "dark" ? ThemeKind::kDark : ThemeKind::kLight;
}

void refusePassword(const std::string& database) {
  if (saysPassword(database)) {
    throw Error(ErrorCode::kUsage, Text::tr("a password in an address is seen by every user of this machine"),
                Text::verbatim("--database"),
                Text::tr("Leave it out, and write it to ~/.pgpass or a service file"));
  }
}

WindowOptions windowOptions(const WrittenWindow& written) {
  WindowOptions options = written.options;
  refusePassword(options.database);
  SceneRequest& scene = options.picture.scene;
  scene.assets = assetsFolder();
  if (written.organ.find_first_of("/\\.") != std::string::npos) {
    scene.organFile = written.organ;
    scene.organScale_m = meshUnit_m(
        *scene.organFile, written.unit.empty() ? std::nullopt : std::optional(lengthUnit_m(written.unit)));
  } else if (!written.organ.empty()) {
    scene.id = written.organ;
  }
  if (!written.formulation.empty()) {
    scene.formulation = written.formulation == "paper" ? Formulation::kPaper : Formulation::kSaintVenant;
  }
  if (!written.theme.empty()) {
    options.theme = themeOf(written.theme);
  }
  if (written.angle_deg) {
    options.picture.angle_rad = radians(*written.angle_deg);
  }
  options.picture.size = sizeOf(written.size, {320, 240});
  options.picture.quality = written.quality == "fast" ? RenderQuality::kFast : RenderQuality::kFine;
  options.simulator = !written.organ.empty() || !scene.pattern.empty() || !written.formulation.empty() ||
                      !options.picture.file.empty() || options.frameRate_s;
  return options;
}

ScreenshotsRequest screenshotsRequest(const WrittenScreenshots& written) {
  ScreenshotsRequest request = written.request;
  request.assets = assetsFolder();
  request.only = QString::fromStdString(written.only);
  for (const std::string& size : written.sizes) {
    request.sizes.push_back(sizeOf(size, {640, 480}));
  }
  for (const std::string& code : written.languages) {
    request.languages.push_back(*languageOf(QString::fromStdString(code)));
  }
  for (const std::string& theme : written.themes) {
    request.themes.push_back(themeOf(theme));
  }
  return request;
}

void addPictureOptions(CLI::App& window, WrittenWindow& written) {
  ScreenshotRequest& picture = written.options.picture;
  window.add_option("--screenshot", picture.file, "Write one picture and end");
  window.add_option("--angle", written.angle_deg,
                    "Twist in the picture, degrees; default: the pattern's target");
  window.add_option("--size", written.size, "Size of the window, WxH")->capture_default_str();
  window.add_option("--quality", written.quality, "Of the picture")
      ->capture_default_str()
      ->check(CLI::IsMember({"fast", "fine"}));
  window.add_option("--orbit", picture.orbit_deg, "Turn of the camera about the organ, degrees")
      ->capture_default_str();
  window.add_option("--zoom", picture.zoom, "Nearer by so many notches of the wheel")->capture_default_str();
  window.add_flag("--film-strip", picture.strip, "Picture of the organ at 0, 30, 60 ... degrees");
  window.add_flag("--six-sides", picture.sides,
                  "Picture of the organ from six sides, at rest and at the angle");
  window.add_flag("--scene-only", picture.sceneOnly, "Picture without panels");
  window.add_flag("--lattice", picture.lattice, "Show ridges and sections");
  window.add_flag("--wireframe", picture.wireframe, "Show edges");
  window.add_flag("--shear", picture.shear, "Colour the tissue by shear stress");
  window.add_flag("--markers", picture.markers, "Show the marker points");
  window.add_flag("--ghost", picture.ghost, "Show the target pose");
}

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
  return trialFiles(dataFolder() / "trials");
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
  (void)makeStationName();  // else the name of the computer
  setup.station = stationName();
  if (const StationRecord record = stationRecord();
      options.database.empty() && record.origin == RecordOrigin::kConfigured) {
    setup.locator = toQString(record.locator);
    setup.recordSetBy = configuration().placeOf(kConfiguredRecord);
  } else {
    setup.locator = toQString(options.database.empty() ? usualRecord() : options.database);
  }
  setup.remember = options.database.empty();
  setup.groups = allPages;
  setup.theme = options.theme;
  setup.systemIsDark = systemIsDark();
  setup.kiosk = options.kiosk || configured(kConfiguredKiosk) == "yes";
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

std::vector<PageGroup> allPages() {
  const std::shared_ptr<StationDesk> desk = deskOfThisStation();
  std::vector<PageEntry> training = stationPages(desk);
  training.push_back(practicePage(desk));
  training.push_back(comparePage());
  return {{[] { return named(QT_TRANSLATE_NOOP("Desk", "Training")); }, training},
          {[] { return named(QT_TRANSLATE_NOOP("Desk", "Review")); }, reviewPages()},
          {[] { return named(QT_TRANSLATE_NOOP("Desk", "Administration")); }, administratorPages()}};
}

std::vector<ScreenEntry> allScreens() {
  std::vector<ScreenEntry> screens = stationScreens();
  for (const std::vector<ScreenEntry>& more :
       {practiceScreens(), organScreens(), compareScreens(), reviewScreens(), administratorScreens()}) {
    screens.insert(screens.end(), more.begin(), more.end());
  }
  return screens;
}

std::vector<ScreenEntry> allDialogs() {
  return administratorDialogs();
}

void addWindow(CLI::App& program) {
  auto written = std::make_shared<WrittenWindow>();
  WindowOptions& options = written->options;
  CLI::App* window = program.add_option_group("Window", "Without a command");
  window->add_flag("--kiosk", options.kiosk, "Full screen at a station, nothing else");
  window->add_option("--theme", written->theme, "Colours")->check(CLI::IsMember({"light", "dark"}));
  window->add_option("--database", options.database,
                     "File or address of the database of this run instead of the station's");
  window->add_option("--organ", written->organ, "Simulator only, with this scene or mesh file");
  window
      ->add_option("--organ-unit", written->unit,
                   "Unit of the mesh file; default: what the file says, else mm")
      ->check(CLI::IsMember({"m", "cm", "mm", "um"}));
  window->add_option("--pattern", options.picture.scene.pattern, "Twist pattern of the scene");
  window->add_option("--formulation", written->formulation, "Of the twist model")
      ->check(CLI::IsMember({"paper", "saint-venant"}));
  window->add_option("--frame-rate", options.frameRate_s,
                     "Measure frames per second for so many seconds and end");
  addPictureOptions(*window, *written);
  program.parse_complete_callback([&program, window, written] {
    if (program.get_subcommands().empty()) {
      runWindow(windowOptions(*written));
    } else if (window->count_all() > 0) {
      throw Error(ErrorCode::kUsage, Text::verbatim("options of the window stand before a command"),
                  program.get_subcommands().front()->get_name(), Text::verbatim("Leave them out"));
    }
  });
}

void addScreenshots(CLI::App& program) {
  auto written = std::make_shared<WrittenScreenshots>();
  CLI::App* command =
      program.add_subcommand("screenshots", "Pictures of every screen on the demonstration cohort");
  command->add_option("--out", written->request.out, "Folder for the pictures")->required();
  command->add_option("--size", written->sizes, "Sizes of the window, WxH,...")
      ->capture_default_str()
      ->delimiter(',');
  command->add_option("--language", written->languages, "Languages")
      ->capture_default_str()
      ->delimiter(',')
      ->check(CLI::IsMember({"en", "zh_CN"}));
  command->add_option("--theme", written->themes, "Themes")
      ->capture_default_str()
      ->delimiter(',')
      ->check(CLI::IsMember({"light", "dark"}));
  command->add_option("--only", written->only, "A part of the name");
  command->callback([written] { runScreenshots(screenshotsRequest(*written)); });
}

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
