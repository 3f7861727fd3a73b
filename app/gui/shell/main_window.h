// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QTimer>
#include <QWidget>

#include "app/gui/base/background.h"
#include "app/gui/base/language.h"
#include "app/gui/shell/open_record.h"
#include "app/gui/shell/preferences.h"
#include "app/gui/shell/shell_setup.h"
#include "app/services/access/access_service.h"

class QStackedWidget;

namespace torsio::gui {

class AwayBanner;
class Entrance;
class Founding;
class IdleWarning;
class ScreenLock;
class Settling;
class SignInPanel;
class SimulatedDesks;
class TroublePanel;
struct FirstRunChoice;

/// The program's window. Shows one of: trouble with the record, first run, sign-in (Entrance), the actor's
/// desk, or its lock (ScreenLock); decides what follows.
class MainWindow : public QWidget {
  Q_OBJECT

 public:
  explicit MainWindow(const ShellSetup& setup);
  ~MainWindow() override;

  /// Opens the database and shows the first screen.
  void start();
  [[nodiscard]] Desk* desk() noexcept { return desk_; }
  [[nodiscard]] SessionContext* session() noexcept { return record_.session(); }
  [[nodiscard]] Background& background() noexcept { return background_; }
  [[nodiscard]] LanguageSwitch& languageSwitch() noexcept { return appearance_.languageSwitch(); }

  /// Signs out. False: the desk is busy or a page is unfinished.
  bool signOut(const QString& reason = {});
  /// Hides the desk until its owner's password is given; signs guests and visitors out instead. False during
  /// a scored run.
  bool lock();
  void chooseLanguage(Language language);
  void chooseTheme(ThemeKind kind);
  /// Called about once a second, and by tests: warns of the idle lock, and locks.
  void watchIdleness();
  /// Called about once a second: passes the presence to the database writer, shows an outage, and catches up
  /// when the database answers again. Never blocks.
  void heartbeat();
  /// Returns the writer; null until the recordings of earlier starts are settled.
  [[nodiscard]] StationWriter* line() noexcept { return record_.line(); }

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  [[nodiscard]] SignInPanel& signIn() const;
  void createPanels();
  void connectFounding();
  void connectSettling();
  void connectEntrance();
  void createKeys();
  void toggleFullScreen();
  void show(QWidget* panel);

  void openDatabase();
  void startLine();
  bool reconnect();
  void changeRecord(const RecordChange& change);

  void enterFirstRun();
  /// Enters a newly set up centre.
  void begin(const FirstRunChoice& choice, const std::vector<StartAccount>& accounts);
  /// Called when a centre has been set up or found there: this station remembers settings from now on.
  void keepFirstRun(const QString& locator);

  void enterSignIn();
  void enterDesk();
  void openDesk();
  void leaveDesk();
  [[nodiscard]] bool endsWhenLeft() const;
  /// Signs out after the open dialogs have been rejected.
  void signOutBeyondDialogs(const QString& reason);
  /// Like OpenRecord::signOut(), but a visitor leaves no head.
  std::optional<LeftHead> forgetActor();

  /// Replaces the actor, after the present events have been processed; signing out leads to sign-in.
  void enterDeskAs(const Actor& actor, const QString& sentence);

  [[nodiscard]] QString userId() const;

  ShellSetup setup_;
  Preferences preferences_;
  Appearance appearance_;
  Background background_;
  QTimer second_;
  std::optional<Language> firstRunLanguage_;  ///< chosen before a centre was set up
  OpenRecord record_;
  bool mayClose_ = true;
  QString centre_;
  bool cardsOpen_ = false;  ///< the kiosk accepts cards (centre setting at opening)
  IdleWarning* idle_ = nullptr;
  AwayBanner* away_;
  QLabel* moved_;  ///< where the record went: a line of its own, because it stays
  QStackedWidget* stack_;
  TroublePanel* trouble_ = nullptr;
  Founding* founding_ = nullptr;
  Entrance* entrance_ = nullptr;
  Settling* settling_ = nullptr;
  SimulatedDesks* simulated_ = nullptr;  ///< its temporary record must outlive the session
  ScreenLock* lock_ = nullptr;
  bool twinTold_ = false;  ///< that somebody else is this station, too
  int deskLevel_ = 0;      ///< event loop level without open dialogs
  Desk* desk_ = nullptr;
};

}  // namespace torsio::gui
