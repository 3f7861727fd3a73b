// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/program/screenshots.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include <QApplication>
#include <QElapsedTimer>
#include <QPixmap>
#include <QTemporaryDir>

#include "app/gui/practice/simulator_window.h"
#include "app/gui/program/window_main.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/shell/first_run_panel.h"
#include "app/gui/shell/password_panel.h"
#include "app/gui/shell/screen_lock.h"
#include "app/gui/shell/second_factor_dialog.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/gui/simulator/posed_states.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/picture.h"
#include "app/outputs/charts/typeface.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/base/assets.h"
#include "app/services/demonstration/demonstration_people.h"
#include "assessment/domain/people/account.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

namespace {

constexpr int kSettle_ms = 250;
constexpr int kScreenPatience_ms = 60'000;
constexpr std::int64_t kSceneFrames = 3;
constexpr const char* kCentre = "Skills laboratory";
constexpr const char* kAdministrator = "administrator";

struct Shot {
  QString name;
  QString file;
};

void settle(QWidget& window) {
  QElapsedTimer waited;
  waited.start();
  const auto scenes = window.findChildren<SceneView*>();
  std::map<SceneView*, std::int64_t> before;
  for (SceneView* scene : scenes) {
    before[scene] = scene->framesDrawn();
  }
  const auto drawn = [&] {
    for (const auto& [scene, frames] : before) {
      if (!scene->isVisible() || !SceneView::platformCanRender()) {
        continue;
      }
      scene->redraw();
      if (scene->framesDrawn() < frames + kSceneFrames) {
        return false;
      }
    }
    return true;
  };
  while (waited.elapsed() < kScreenPatience_ms && (waited.elapsed() < kSettle_ms || !drawn())) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  }
}

/// Takes the requested screens in all languages, themes and sizes.
class Photographer {
 public:
  explicit Photographer(const ScreenshotsRequest& request) : request_(request) {}

  [[nodiscard]] bool wants(const QString& name) const {
    return request_.only.isEmpty() || name.contains(request_.only);
  }

  /// `make` builds the screen as the child of a window; called once per language and theme.
  void take(const QString& name, const std::function<std::unique_ptr<QWidget>(ThemeKind, Language)>& make) {
    if (!wants(name)) {
      return;
    }
    for (const Language language : request_.languages) {
      language_.choose(language);
      for (const ThemeKind kind : request_.themes) {
        applyTheme(*qApp, theme(kind));
        const std::unique_ptr<QWidget> window = make(kind, language);
        for (const QSize& size : request_.sizes) {
          photograph(*window, name, language, kind, size);
        }
      }
    }
    if (request_.progress) {
      request_.progress({name.toStdString(), 0.0, -1.0});
    }
  }

  void photograph(QWidget& window, const QString& name, Language language, ThemeKind kind,
                  const QSize& size) {
    window.resize(size);
    window.show();
    settle(window);
    if (request_.look) {
      request_.look(name, window);
      return;
    }
    const QString file = QStringLiteral("%1-%2-%3-%4x%5.png")
                             .arg(name, languageCode(language),
                                  kind == ThemeKind::kDark ? QStringLiteral("dark") : QStringLiteral("light"))
                             .arg(size.width())
                             .arg(size.height());
    writePicture(window.grab().toImage(), request_.out / file.toStdString());
    shots_.push_back({name, file});
  }

  [[nodiscard]] const std::vector<Shot>& shots() const { return shots_; }

 private:
  const ScreenshotsRequest& request_;
  LanguageSwitch language_;
  std::vector<Shot> shots_;
};

/// Demonstration users who sign in for screenshots.
class Cast {
 public:
  Cast(const std::string& locator, const std::filesystem::path& assets, const ProgressCallback& progress)
      : locator_(locator) {
    SessionContext session(key());
    FirstRun first;
    first.centre = kCentre;
    first.login = kAdministrator;
    first.password = randomStartPassword();
    first.demonstration = true;
    const std::vector<StartAccount> accounts = performFirstRun(
        session, first, [&](SessionContext& own) { return addDemonstration(own, assets, progress); });
    actors_["administrator"] = session.actor();
    setCentreSetting<kPanelWaits>(session, false);  // the physician's queue is open, and so are discrepancies
    for (const StartAccount& account : accounts) {
      const SignInAnswer answer =
          changeOwnPassword(session, {account.login, account.startPassword, randomStartPassword()});
      actors_[account.role] = answer.actor;
    }
  }

  [[nodiscard]] std::unique_ptr<SessionContext> sessionOf(const QString& role) const {
    const auto actor = actors_.find(role.toStdString());
    if (actor == actors_.end()) {
      throw Error(ErrorCode::kBadParameter, Text::tr("the demonstration has nobody with this role"),
                  role.toStdString(), Text::tr("Use trainee, rater or administrator"));
    }
    auto session = std::make_unique<SessionContext>(key());
    session->setActor(actor->second);
    return session;
  }

 private:
  [[nodiscard]] SessionKey key() const {
    SessionKey key;
    key.locator = locator_;
    key.station = "Station 1";
    return key;
  }
  std::string locator_;
  std::map<std::string, Actor> actors_;
};

/// Wraps a panel in its own window.
template <typename Panel>
std::unique_ptr<QWidget> windowOf(std::unique_ptr<Panel> panel) {
  panel->setAutoFillBackground(true);
  return panel;
}

void takePanels(Photographer& photographer) {
  photographer.take(QStringLiteral("sign-in"), [](ThemeKind, Language) {
    auto panel = std::make_unique<SignInPanel>();
    panel->setCentre(QString::fromLatin1(kCentre));
    return windowOf(std::move(panel));
  });
  photographer.take(QStringLiteral("first-run"), [](ThemeKind, Language language) {
    auto panel = std::make_unique<FirstRunPanel>(QStringLiteral("/var/lib/torsio/torsio.sqlite"), Text());
    panel->setLanguage(language);
    return windowOf(std::move(panel));
  });
  photographer.take(QStringLiteral("new-password"), [](ThemeKind, Language) {
    auto panel = std::make_unique<PasswordPanel>();
    panel->begin(QStringLiteral("demo.trainee"), QStringLiteral("-"), true, false);
    return windowOf(std::move(panel));
  });
  photographer.take(QStringLiteral("second-factor"), [](ThemeKind, Language) {
    const SecondFactorOffer offer{
        .secret = "GEZDGNBVGY3TQOJQGEZDGNBVGY3TQOJQ",
        .uri = "otpauth://totp/Torsio:demo?secret=GEZDGNBVGY3TQOJQGEZDGNBVGY3TQOJQ&issuer=Torsio"};
    return windowOf(std::make_unique<SecondFactorDialog>(
        offer,
        SecondFactorDialog::tr("The centre asks you for a second factor: signing in takes your password and "
                               "a code from your phone."),
        true, [](const std::string&, const std::string&) { return std::vector<std::string>(); }));
  });
  photographer.take(QStringLiteral("locked"), [](ThemeKind, Language) {
    auto panel = std::make_unique<LockPanel>();
    panel->begin(QStringLiteral("demo.trainee"));
    return windowOf(std::move(panel));
  });
}

/// Takes organs that come twisted, each in its successive states, in free practice. Only when asked for by
/// name, because they are many.
void takeUntwistings(Photographer& photographer, const ScreenshotsRequest& request) {
  if (request.only.isEmpty()) {
    return;
  }
  constexpr const char* kPattern = "detorse";
  for (const std::string& id : sceneIds(request.assets)) {
    const std::vector<std::string> patterns = patternIds(request.assets, id);
    if (std::find(patterns.begin(), patterns.end(), kPattern) == patterns.end()) {
      continue;
    }
    SceneRequest scene;
    scene.assets = request.assets;
    scene.id = id;
    scene.pattern = kPattern;
    std::optional<LoadedScene> loaded;
    for (const auto& [state, stateName] : kUntwistingStates) {
      const QString name =
          QStringLiteral("untwisting-%1-%2").arg(QString::fromStdString(id), QLatin1String(stateName));
      if (photographer.wants(name) && !loaded) {
        loaded = loadSceneForView(scene);
      }
      const UntwistingState wanted = state;
      photographer.take(name, [&, wanted](ThemeKind kind, Language) -> std::unique_ptr<QWidget> {
        WindowSetup setup;
        setup.assets = request.assets;
        setup.theme = kind;
        setup.remember = false;
        auto window = std::make_unique<SimulatorWindow>(setup);
        window->show();
        window->controller().adopt(scene, *loaded);
        window->controller().freeze(untwistingState(*loaded->scene, wanted));
        return window;
      });
    }
  }
}

void takePage(Photographer& photographer, const Cast& cast, const std::filesystem::path& assets,
              const ScreenEntry& screen) {
  const std::unique_ptr<SessionContext> session = cast.sessionOf(screen.role);
  photographer.take(screen.name, [&](ThemeKind kind, Language language) -> std::unique_ptr<QWidget> {
    DeskSetup setup;
    setup.assets = assets;
    setup.centre = QString::fromLatin1(kCentre);
    setup.language = language;
    setup.theme = kind;
    setup.groups = allPages;
    auto desk = std::make_unique<Desk>(*session, setup);
    desk->setAutoFillBackground(true);
    desk->show();
    desk->open(screen.pageId, screen.argument ? screen.argument(*session) : QVariant());
    desk->context().waitForJobs();
    settle(*desk);
    if (screen.prepare && desk->page() != nullptr) {
      screen.prepare(*desk->page());
    }
    desk->context().waitForJobs();
    return desk;
  });
}

void writeIndex(const std::filesystem::path& folder, const std::vector<Shot>& shots) {
  QString html = QStringLiteral(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Torsio: screens</title>\n"
      "<style>body{font-family:sans-serif;margin:2em}img{max-width:48%;border:1px solid "
      "#ccc;margin:4px}</style>"
      "</head><body>\n");
  QString last;
  for (const Shot& shot : shots) {
    if (shot.name != last) {
      html += QStringLiteral("<h2>%1</h2>\n").arg(shot.name.toHtmlEscaped());
    }
    last = shot.name;
    html += QStringLiteral("<a href=\"%1\"><img src=\"%1\" alt=\"%1\"></a>\n").arg(shot.file.toHtmlEscaped());
  }
  html += QStringLiteral("</body></html>\n");
  writeFileAtomically(folder / "index.html", html.toStdString());
}

}  // namespace

int takeAllScreenshots(const ScreenshotsRequest& request) {
  if (!request.look) {
    ensureFolder(request.out);
  }
  Photographer photographer(request);
  takePanels(photographer);
  takeUntwistings(photographer, request);
  std::vector<ScreenEntry> pages;
  std::vector<ScreenEntry> screens = allScreens();
  if (!request.look) {  // `look` may change the language
    const std::vector<ScreenEntry> dialogs = allDialogs();
    screens.insert(screens.end(), dialogs.begin(), dialogs.end());
  }
  for (const ScreenEntry& screen : screens) {
    if (photographer.wants(screen.name)) {
      pages.push_back(screen);
    }
  }
  const QTemporaryDir folder;
  if (!pages.empty()) {
    const Cast cast(folder.filePath(QStringLiteral("torsio.sqlite")).toStdString(), request.assets,
                    request.progress);
    for (const ScreenEntry& screen : pages) {
      takePage(photographer, cast, request.assets, screen);
    }
  }
  if (!request.look) {
    writeIndex(request.out, photographer.shots());
  }
  return static_cast<int>(photographer.shots().size());
}

void runScreenshots(ScreenshotsRequest request) {
  if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") &&
      qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  const std::unique_ptr<QApplication> application = makeWindowApplication();
  request.progress = [](const Progress& progress) {
    std::fprintf(stderr, "torsio: %s\n", progress.step.str().c_str());
  };
  const int written = takeAllScreenshots(request);
  std::printf("%d pictures in %s\n", written, request.out.string().c_str());
}

}  // namespace torsio::gui
