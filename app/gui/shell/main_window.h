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
class SignInPanel;
class TroublePanel;
class VisitBar;
struct FirstRunChoice;
struct LookRound;
enum class VisitedDesk;

/// The program's window. It shows one thing at a time: trouble with the record, the first run, the way in
/// (Entrance), the desk of whoever signed in, or its lock (ScreenLock), and decides what follows what.
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
  [[nodiscard]] LanguageSwitch& languageSwitch() noexcept { return language_; }

  /// Refused while the desk is busy or a page has something unfinished.
  bool signOut(const QString& reason = {});
  /// Hides the desk until its owner's password is given; never while a run goes on.
  bool lock();
  void chooseLanguage(Language language);
  void chooseTheme(ThemeKind kind);
  /// About once a second: warns of the idle lock, and locks. Tests call it themselves.
  void watchIdleness();
  /// About once a second: tells the line to the database who is here, says calmly when it does not answer,
  /// and puts in order what had to wait once it does. Waits for nothing.
  void heartbeat();
  /// Null until the recordings of earlier starts are settled.
  [[nodiscard]] StationWriter* line() noexcept { return record_.line(); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  [[nodiscard]] SignInPanel& signIn() const;
  void createPanels();
  void connectFounding();
  void connectEntrance();
  void createKeys();
  void toggleFullScreen();
  void show(QWidget* panel);

  void openDatabase();
  void settle();
  void settleAgain();
  void startLine();
  bool reconnect();
  void changeRecord(const RecordChange& change);

  void enterFirstRun();
  /// A centre has been set up.
  void begin(const FirstRunChoice& choice, const std::vector<StartAccount>& accounts);
  /// A centre is set up, or found, there: from now on this station remembers what is chosen.
  void keepFirstRun(const QString& locator);
  /// A record of simulated people in a folder of its own, for whoever is only curious.
  void lookRound(VisitedDesk desk);
  /// Removes that record; nothing of it stays, nor of what was chosen meanwhile.
  void endLookRound();

  void enterSignIn();
  void enterDesk();
  void openDesk();
  void leaveDesk();
  void tellKept();
  [[nodiscard]] bool endsWhenLeft() const;
  /// Signs out once the dialogs that stand open have been given up.
  void signOutBeyondDialogs(const QString& reason);
  /// As OpenRecord::signOut(); whoever looked round leaves no head.
  std::optional<LeftHead> forgetActor();
  void tellHead(const std::optional<LeftHead>& head);
  /// Whether the window may close on it. Says on standard error where the head was kept.
  [[nodiscard]] static bool staysSilent(const LeftHead& head);

  /// In place of the administrator who is signed in; signing out leads to the sign-in.
  void enterAsSimulated(SimulatedRole role);
  /// Whoever looks round goes to another desk, as a simulated person or as themselves.
  void visit(VisitedDesk desk);
  /// The desk of an actor, once the events that led to it are over.
  void enterDeskAs(const Actor& actor, bool simulated, const QString& sentence);

  void applyChoices(const QString& userId);
  [[nodiscard]] QString userId() const;

  ShellSetup setup_;
  Preferences preferences_;
  LanguageSwitch language_;
  Background background_;
  QTimer second_;
  std::unique_ptr<LookRound> lookRound_;      ///< its record outlives the session
  std::optional<Language> firstRunLanguage_;  ///< that was chosen before a centre was set up
  OpenRecord record_;
  bool simulated_ = false;    ///< an administrator looks at a simulated person's desk
  bool filesClosed_ = false;  ///< files that others could read were looked for since the start
  std::vector<Text> kept_;    ///< recordings that could not be stored; told until somebody signs in
  bool mayClose_ = true;
  ThemeKind theme_ = ThemeKind::kLight;
  QString centre_;
  bool cardsOpen_ = false;  ///< the kiosk takes cards, as the centre chose when the record was opened
  IdleWarning* idle_;
  AwayBanner* away_;
  VisitBar* visit_;
  QStackedWidget* stack_;
  TroublePanel* trouble_ = nullptr;
  Founding* founding_ = nullptr;
  Entrance* entrance_ = nullptr;
  ScreenLock* lock_ = nullptr;
  int deskLevel_ = 0;  ///< of event loops, while no dialog waits for an answer
  Desk* desk_ = nullptr;
};

}  // namespace torsio::gui
