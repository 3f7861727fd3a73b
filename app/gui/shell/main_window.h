// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QStringList>
#include <QTimer>
#include <QWidget>

#include "app/gui/base/background.h"
#include "app/gui/base/language.h"
#include "app/gui/shell/desk.h"
#include "app/gui/shell/first_run_panel.h"
#include "app/gui/shell/preferences.h"
#include "app/gui/shell/visit_bar.h"
#include "app/services/access/access_service.h"
#include "app/services/access/first_run.h"
#include "app/services/access/idle_guard.h"
#include "app/services/base/progress.h"
#include "app/services/maintenance/station_anchor.h"
#include "app/services/recording/station_writer.h"
#include "assessment/domain/people/account.h"

class QLabel;
class QTemporaryDir;
class QStackedWidget;

namespace torsio::gui {

class DialogLock;
class LockPanel;
class PasswordPanel;
class ProblemPanel;
class SignInPanel;
class TroublePanel;

/// What the program's window needs from outside.
struct ShellSetup {
  std::filesystem::path assets;
  std::string station;
  QString locator;  ///< of the database; the station's choice of the first run overrides it
  std::function<std::vector<PageGroup>()> groups = [] { return std::vector<PageGroup>(); };
  std::optional<ThemeKind> theme;  ///< given on the command line; nothing: the user's, else the role's
  bool systemIsDark = false;
  bool kiosk = false;
  bool remember = true;
  std::optional<IdleLimits> idle;  ///< nothing: those of the centre
  const Clock* clock = nullptr;    ///< of the idle lock; null: the machine's
  PasswordCost passwordCost = PasswordCost::kModerate;
  LinePatience linePatience;
  /// Fills a record with simulated people; empty: the demonstration of the paper's protocol.
  std::function<std::vector<StartAccount>(SessionContext&, const ProgressCallback&)> simulatedPeople;
  std::chrono::milliseconds lessonsAgain = std::chrono::minutes(1);  ///< between two looks into the outbox
  std::filesystem::path unstored;  ///< where recordings wait for their database; empty: unstoredFolder()
};

/// The program's window: first run, sign-in, forced password change, the desk of whoever signed in, and the
/// lock. One of them is shown at a time. Passwords are checked off the GUI thread.
class MainWindow : public QWidget {
  Q_OBJECT

 public:
  explicit MainWindow(const ShellSetup& setup);
  ~MainWindow() override;

  /// Opens the database and shows the first screen.
  void start();
  [[nodiscard]] Desk* desk() noexcept { return desk_; }
  [[nodiscard]] SessionContext* session() noexcept { return session_.get(); }
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
  [[nodiscard]] StationWriter* line() noexcept { return line_.get(); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void createPanels();
  void createKeys();
  void show(QWidget* panel);
  void openDatabase();
  void setUp(const FirstRunChoice& choice);
  void enterFirstRun();
  /// A centre is set up, or found, there: from now on this station remembers what is chosen.
  void keepFirstRun(const QString& locator);
  /// A record of simulated people in a folder of its own, for whoever is only curious.
  void lookRound(VisitedDesk desk);
  /// Removes that record; nothing of it stays, nor of what was chosen meanwhile.
  void endLookRound();
  void enterSignIn();
  void settle();
  void settleAgain();
  void startLine();
  void showAnswers(bool answers);
  bool reconnect();
  /// Nobody is signed in any more. Returns the head of the audit trail when an administrator left; without a
  /// line where it cannot be read, and then why.
  std::optional<LeftHead> forgetActor();
  void tellHead(const std::optional<LeftHead>& head);
  /// Whether the window may close on it. Says on standard error where the head was kept.
  [[nodiscard]] static bool staysSilent(const LeftHead& head);
  void tellKept();
  void tryPassword(const QString& login, const QString& password);
  void tryPin(const QString& login, const QString& pin);
  void tryCode(const QString& code);
  void enterAsGuest();
  /// In place of the administrator who is signed in; signing out leads to the sign-in.
  void enterAsSimulated(SimulatedRole role);
  /// Whoever looks round goes to another desk, as a simulated person or as themselves.
  void visit(VisitedDesk desk);
  /// The desk of an actor, once the events that led to it are over.
  void enterDeskAs(const Actor& actor, bool simulated, const QString& sentence);
  void took(const SignInAnswer& answer, const QString& login, const QString& password);
  void changePassword(const QString& login, const QString& oldPassword, const QString& newPassword);
  void unlock(const QString& password);
  void sayLocked(const QString& sentence);
  /// Signs out once the dialogs that stand open have been given up.
  void signOutBeyondDialogs(const QString& reason);
  void enterDesk();
  void leaveDesk();
  void openDesk();
  void choosePin();
  void removeDemonstration();
  void changeRecord(const RecordChange& change);
  void toggleFullScreen();
  void leaveKiosk();
  void retranslate();
  void applyChoices(const QString& userId);
  [[nodiscard]] QString userId() const;
  [[nodiscard]] SessionKey key() const;

  ShellSetup setup_;
  Preferences preferences_;
  LanguageSwitch language_;
  Background background_;
  MonotonicClock machineClock_;
  IdleGuard idle_;
  QTimer second_;
  std::unique_ptr<QTemporaryDir> lookedAt_;  ///< the record of a look round; outlives its session
  QString lookedFrom_;                       ///< the locator before it
  Actor visitor_{};                          ///< who looks round, also while seen as a simulated person
  VisitedDesk visitedFirst_ = VisitedDesk::kAdministrator;
  std::optional<Language> firstRunLanguage_;  ///< that was chosen before a centre was set up
  std::unique_ptr<SessionContext> session_;
  std::unique_ptr<StationWriter> line_;
  std::shared_ptr<void> lessons_;  ///< an LrsWorker: learning records leave while the record is open
  std::size_t refusedTold_ = 0;
  bool simulated_ = false;    // an administrator looks at a simulated person's desk
  bool answered_ = true;      // the database, at the last heartbeat
  bool settleDue_ = false;    // recordings may have gone to files meanwhile
  bool filesClosed_ = false;  ///< files that others could read were looked for since the start
  std::vector<Text> kept_;    // recordings that could not be stored; told until somebody signs in
  std::shared_ptr<std::atomic<bool>> setUpCancelled_ = std::make_shared<std::atomic<bool>>(false);
  bool mayClose_ = true;
  ThemeKind theme_ = ThemeKind::kLight;
  QString centre_;
  bool cardsOpen_ = false;  // the kiosk takes cards, as the centre chose when the record was opened
  QLabel* idleWarning_;
  QLabel* awayBanner_;
  VisitBar* visit_;
  QStackedWidget* stack_;
  TroublePanel* trouble_ = nullptr;
  FirstRunPanel* firstRun_ = nullptr;
  SignInPanel* signIn_ = nullptr;
  PasswordPanel* password_ = nullptr;
  LockPanel* lock_ = nullptr;
  DialogLock* dialogLock_ = nullptr;
  int deskLevel_ = 0;  // of event loops, while no dialog waits for an answer
  Desk* desk_ = nullptr;
};

}  // namespace torsio::gui
