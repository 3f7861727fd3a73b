// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/main_window.h"

#include <initializer_list>
#include <utility>

#include <QApplication>
#include <QCloseEvent>
#include <QShortcut>
#include <QStackedWidget>
#include <QThread>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/shell/banners.h"
#include "app/gui/shell/entrance.h"
#include "app/gui/shell/founding.h"
#include "app/gui/shell/help_dialogs.h"
#include "app/gui/shell/password_panel.h"
#include "app/gui/shell/problem_panel.h"
#include "app/gui/shell/rail.h"
#include "app/gui/shell/screen_lock.h"
#include "app/gui/shell/settling.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/gui/shell/simulated_desks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/window_events.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/access/station_name.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/recording/station_writer.h"
#include "assessment/domain/people/account.h"
#include "sim/core/time_units.h"

namespace torsio::gui {

namespace {

/// A kiosk is in a dark room; other places follow the desktop, from the first page on.
ThemeKind usualTheme(const ShellSetup& setup) {
  return setup.kiosk || setup.systemIsDark ? ThemeKind::kDark : ThemeKind::kLight;
}

/// Of a desk that nobody else's data are on, and that is deleted when it is left.
constexpr IdleLimits kVisitLimits{.warn_us = 29 * kMinute_us, .lock_us = 30 * kMinute_us};

}  // namespace

MainWindow::MainWindow(const ShellSetup& setup)
    : setup_(setup),
      preferences_(setup.remember),
      appearance_(preferences_, setup.theme, usualTheme(setup)),
      record_(setup_),
      mayClose_(!setup.kiosk),
      away_(new AwayBanner([this] { return reconnect(); }, this)),
      moved_(new QLabel(this)),
      stack_(new QStackedWidget(this)) {
  pressButtonsByEnter(*this);
  // After it, so that the key that presses a button counts as activity: later filters are called first.
  idle_ = new IdleWarning(setup.clock, setup.idle.value_or(IdleLimits{}), this);
  setWindowTitle(QStringLiteral("Torsio"));
  setObjectName(QStringLiteral("shell"));
  setAutoFillBackground(true);
  // Without a minimum size, the window permanently grows with any page's momentary content, beyond the
  // screen.
  setMinimumSize(640, 400);
  resize(1366, 768);
  auto* column = bareLayout<QVBoxLayout>(this, 0);
  connect(idle_, &IdleWarning::timeIsUp, this, [this] {
    if (endsWhenLeft()) {
      signOutBeyondDialogs(tr("You were signed out because nobody was here"));
    } else {
      lock();
    }
  });
  moved_->setObjectName(QStringLiteral("movedRecord"));
  moved_->setWordWrap(true);
  moved_->setTextFormat(Qt::PlainText);
  moved_->hide();
  connect(away_, &AwayBanner::moved, this, [this](const Text& notice) {
    moved_->setText(toQString(notice));
    moved_->setVisible(!notice.empty());
  });
  connect(away_, &AwayBanner::refused, this, [this](int entries) {
    if (desk_ != nullptr) {
      desk_->context().notify(
          tr("The database permanently refused %Ln entries of this station. Please tell its administrator",
             nullptr, entries));
    }
  });
  SceneView::prepareWindow(*this);
  appearance_.apply({});
  createPanels();
  for (QWidget* part : std::initializer_list<QWidget*>{&simulated_->bar(), moved_, stack_}) {
    column->addWidget(part);
  }
  createKeys();
  connect(&second_, &QTimer::timeout, this, &MainWindow::watchIdleness);
  connect(&second_, &QTimer::timeout, this, &MainWindow::heartbeat);
  second_.start(1000);
  restoreGeometry(preferences_.layout(QStringLiteral("window")).toByteArray());
}

MainWindow::~MainWindow() {
  delete desk_;  // before its session
}

SignInPanel& MainWindow::signIn() const {
  return entrance_->signIn();
}

void MainWindow::createPanels() {
  trouble_ = new TroublePanel(this);
  founding_ = new Founding(background_, record_, setup_, this);
  entrance_ = new Entrance(background_, record_, this);
  lock_ = new ScreenLock(background_, this);
  settling_ = new Settling(background_, record_, setup_, this);
  simulated_ = new SimulatedDesks(record_, *founding_, this);
  simulated_->bar().hide();
  const std::initializer_list<std::pair<QWidget*, const char*>> panels{{trouble_, "trouble"},
                                                                       {&founding_->panel(), "first run"},
                                                                       {&signIn(), "sign-in"},
                                                                       {&entrance_->password(), "password"},
                                                                       {lock_->panel(), "lock"}};
  for (const auto& [panel, name] : panels) {
    panel->setObjectName(QLatin1String(name));
    stack_->addWidget(panel);
  }
  trouble_->setTheme(theme(appearance_.themeKind()));
  connect(&appearance_, &Appearance::themeChanged, trouble_,
          [this](ThemeKind kind) { trouble_->setTheme(theme(kind)); });
  connect(trouble_, &TroublePanel::retryWanted, this, &MainWindow::openDatabase);
  connect(trouble_, &TroublePanel::otherDatabaseWanted, this, &MainWindow::enterFirstRun);
  connectFounding();
  connectSettling();
  connect(&signIn(), &SignInPanel::languageWanted, this, &MainWindow::chooseLanguage);
  connectEntrance();
  connect(lock_, &ScreenLock::opened, this, [this] { show(desk_); });
  connect(lock_, &ScreenLock::signOutWanted, this, [this] { signOutBeyondDialogs({}); });
  connect(&background_, &Background::workingChanged, this, [this](bool working) {
    entrance_->setWorking(working);
    founding_->panel().setWorking(working);
    lock_->setWorking(working);
  });
}

void MainWindow::connectFounding() {
  const FirstRunPanel* panel = &founding_->panel();
  connect(panel, &FirstRunPanel::languageWanted, this, [this](Language language) {
    firstRunLanguage_ = language;
    chooseLanguage(language);
  });
  connect(panel, &FirstRunPanel::done, this, &MainWindow::enterDesk);
  connect(panel, &FirstRunPanel::lookRoundWanted, simulated_, &SimulatedDesks::lookRound);
  connect(founding_, &Founding::founded, this, &MainWindow::begin);
  connect(founding_, &Founding::foundThere, this, [this](const QString& locator) {
    keepFirstRun(locator);
    openDatabase();
  });
  connect(founding_, &Founding::failed, simulated_, &SimulatedDesks::end);
  connect(&simulated_->bar(), &VisitBar::wanted, this, [this](VisitedDesk desk) {
    if (desk_ != nullptr && desk_->mayLeave()) {
      simulated_->visit(desk, desk_->context());
    }
  });
  connect(simulated_, &SimulatedDesks::wanted, this, &MainWindow::enterDeskAs);
}

void MainWindow::connectSettling() {
  connect(settling_, &Settling::ended, this, [this](const QString& said, bool trouble) {
    if (!said.isEmpty()) {
      signIn().say(said, trouble);
    }
    startLine();
  });
  connect(settling_, &Settling::stored, this, [this] {
    if (desk_ != nullptr) {
      desk_->context().notify(tr("The database answers again, and what was kept meanwhile is stored"));
    }
  });
  connect(settling_, &Settling::dueChanged, away_, &AwayBanner::setSettleDue);
  connect(away_, &AwayBanner::settleWanted, settling_, &Settling::again);
}

void MainWindow::connectEntrance() {
  connect(entrance_, &Entrance::entered, this, &MainWindow::enterDesk);
  connect(entrance_, &Entrance::passwordWanted, this, [this] { show(&entrance_->password()); });
  connect(entrance_, &Entrance::passwordChanged, this, [this] {
    show(desk_);
    desk_->context().notify(tr("The new password is now in use"));
  });
  connect(&entrance_->password(), &PasswordPanel::givenUp, this, [this] {
    if (desk_ != nullptr) {
      show(desk_);
    } else {
      enterSignIn();
    }
  });
  connect(entrance_, &Entrance::kioskEnded, this, [this] {
    mayClose_ = true;
    close();
  });
}

void MainWindow::createKeys() {
  const auto key = [this](const QKeySequence& keys, auto act) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, act);
  };
  const auto sheet = [this] { ShortcutSheet(desk_, this).exec(); };
  key(Qt::Key_F1, sheet);
  key(QKeySequence(QStringLiteral("?")), sheet);
  key(Qt::Key_F11, [this] { toggleFullScreen(); });
  key(Qt::CTRL | Qt::ALT | Qt::Key_L, [this] { lock(); });
  signIn().setKiosk(setup_.kiosk);
}

void MainWindow::toggleFullScreen() {
  if (!setup_.kiosk) {
    setWindowState(windowState() ^ Qt::WindowFullScreen);
  }
}

void MainWindow::watchIdleness() {
  const bool watched = desk_ != nullptr && stack_->currentWidget() == desk_;
  idle_->watch(watched, watched && desk_->staysOpen(),
               watched && endsWhenLeft() ? IdleWarning::End::kSignOut : IdleWarning::End::kLock);
}

/// Returns whether leaving this desk signs out instead of locking, because there is nothing to return to.
bool MainWindow::endsWhenLeft() const {
  return setup_.kiosk || record_.session()->actor().practiceOnly || simulated_->active();
}

void MainWindow::show(QWidget* panel) {
  stack_->setCurrentWidget(panel);
  simulated_->bar().setVisible(simulated_->lookingRound() && panel == desk_);
}

void MainWindow::start() {
  if (const QString chosen = preferences_.database(); !chosen.isEmpty() && setup_.recordSetBy.empty()) {
    record_.setLocator(chosen);
  }
  openDatabase();
}

void MainWindow::heartbeat() {
  if (record_.line() != nullptr) {
    record_.line()->signIn(record_.session()->actor());
    away_->follow(*record_.line(), desk_ != nullptr && desk_->busy());
    if (desk_ != nullptr && record_.line()->hasTwin() != twinTold_ && !desk_->busy()) {
      twinTold_ = record_.line()->hasTwin();
      if (twinTold_) {
        desk_->context().tell([station = record_.session()->station()] {
          return TranslatedError{toQString(twinWords(station)), toQString(twinRemedy()), {}};
        });
      }
    }
  }
}

/// Reconnects the pages after the server was lost. False: it is away again; the next successful heartbeat
/// retries.
bool MainWindow::reconnect() {
  const bool back = record_.reconnect();
  if (back && desk_ != nullptr) {
    desk_->databaseAnswered();
  }
  return back;
}

void MainWindow::openDatabase() {
  record_.stopLine();
  try {
    if (!preferences_.database().isEmpty() && preferences_.database() == record_.locator()) {
      requireKnownRecord(record_.locator().toStdString());
    } else if (lookAtRecord(record_.locator().toStdString()) != RecordPlace::kCentre) {
      record_.close();
      enterFirstRun();
      return;
    }
    preferences_.keep(true);
    record_.open();
    if (!setup_.recordSetBy.empty()) {
      preferences_.setDatabase(record_.locator());  // from now on it must be there
    }
    const CentreSign sign = centreSign(record_.session()->connectionWithoutRight());
    centre_ = toQString(sign.name);
    cardsOpen_ = setup_.kiosk && centreSetting<kKioskCodes>(record_.session()->connectionWithoutRight());
    if (!preferences_.language({})) {
      if (const auto language = languageOf(toQString(sign.language))) {
        chooseLanguage(*language);
      }
    }
    enterSignIn();
    settling_->begin();
  } catch (...) {
    trouble_->tell(std::current_exception());
    show(trouble_);
  }
}

void MainWindow::startLine() {
  record_.startLine();
  away_->reset();
  if (desk_ != nullptr) {
    desk_->context().setLine(record_.line());
  }
  heartbeat();
}

void MainWindow::changeRecord(const RecordChange& change) {
  leaveDesk();
  const std::optional<LeftHead> head = forgetActor();
  record_.close();  // the record is closed now
  QString sentence = change.sentence;
  bool failed = false;
  try {
    if (change.swap) {
      change.swap();
    }
    if (!change.locator.isEmpty()) {
      record_.setLocator(change.locator);
      preferences_.setDatabase(change.locator);
      if (!setup_.recordSetBy.empty()) {
        sentence +=
            QStringLiteral(". ") + tr("Now have the record changed in %1").arg(toQString(setup_.recordSetBy));
      }
    }
  } catch (...) {
    sentence = problemSentence(std::current_exception());
    failed = true;
  }
  openDatabase();
  signIn().tellHead(head);
  signIn().say(sentence, failed);
}

/// Stores nothing before the last step, not even settings of this station.
void MainWindow::enterFirstRun() {
  preferences_.keep(false);
  founding_->panel().setLanguage(appearance_.languageSwitch().present());
  show(&founding_->panel());
}

void MainWindow::keepFirstRun(const QString& locator) {
  preferences_.keep(true);
  preferences_.setDatabase(locator);
  if (firstRunLanguage_) {
    preferences_.setLanguage({}, *firstRunLanguage_);
  }
}

void MainWindow::begin(const FirstRunChoice& choice, const std::vector<StartAccount>& accounts) {
  startLine();
  centre_ = toQString(choice.first.centre);
  if (!simulated_->lookingRound()) {
    keepFirstRun(choice.locator);
    founding_->panel().showAccounts(accounts);
    return;
  }
  const VisitedDesk first = simulated_->begin();
  enterDesk();
  desk_->context().notify(SimulatedDesks::visitorsSentence());
  if (first != VisitedDesk::kAdministrator) {
    simulated_->visit(first, desk_->context());
  }
}

void MainWindow::enterSignIn() {
  appearance_.apply({});
  signIn().setCentre(centre_);
  signIn().setCards(cardsOpen_);
  signIn().clear();
  show(&signIn());
}

void MainWindow::enterDesk() {
  leaveDesk();
  if (!setup_.idle) {
    idle_->setLimits(simulated_->lookingRound()
                         ? kVisitLimits
                         : centreIdleLimits(record_.session()->connectionWithoutRight()));
  }
  appearance_.apply(userId());
  openDesk();
  settling_->tellKept(desk_->context());
}

void MainWindow::openDesk() {
  DeskSetup setup;
  setup.assets = setup_.assets;
  setup.centre = simulated_->lookingRound() ? QString() : centre_;  // shown in the visitor's line instead
  setup.language = appearance_.languageSwitch().present();
  setup.theme = appearance_.themeKind();
  setup.kiosk = setup_.kiosk;
  setup.groups = setup_.groups;
  desk_ = new Desk(*record_.session(), setup, this);
  desk_->context().setLine(record_.line());
  desk_->setObjectName(QStringLiteral("desk"));
  stack_->addWidget(desk_);
  connect(desk_, &Desk::signOutWanted, this, [this] { signOut(); });
  connect(desk_, &Desk::lockWanted, this, &MainWindow::lock);
  connect(desk_, &Desk::languageWanted, this, &MainWindow::chooseLanguage);
  connect(desk_, &Desk::themeWanted, this, &MainWindow::chooseTheme);
  connect(desk_, &Desk::shortcutsWanted, this, [this] { ShortcutSheet(desk_, this).exec(); });
  connect(desk_, &Desk::aboutWanted, this, [this] { showAboutBox(this); });
  connect(desk_, &Desk::simulatedWanted, this, [this](SimulatedRole role) {
    if (desk_->mayLeave()) {
      simulated_->view(role, desk_->context());
    }
  });
  connect(desk_, &Desk::passwordChangeWanted, entrance_, &Entrance::changeOwnPassword);
  connect(desk_, &Desk::secondFactorWanted, this, [this] {
    attempt(desk_->context(), [this] {
      if (const QString done = entrance_->changeSecondFactor(); !done.isEmpty()) {
        desk_->context().notify(done);
      }
    });
  });
  // Deferred, because the requesting page is destroyed with the desk.
  connect(&desk_->context(), &ShellContext::recordChangeWanted, this, [this](const RecordChange& change) {
    QTimer::singleShot(0, this, [this, change] { changeRecord(change); });
  });
  desk_->rail().setNarrow(preferences_.layout(QStringLiteral("rail_narrow")).toBool());
  connect(&desk_->rail(), &Rail::narrowChanged, this,
          [this](bool narrow) { preferences_.setLayout(QStringLiteral("rail_narrow"), narrow); });
  show(desk_);
  deskLevel_ = QThread::currentThread()->loopLevel();
  desk_->openHome(preferences_.page(userId()));
}

void MainWindow::leaveDesk() {
  if (desk_ == nullptr) {
    return;
  }
  if (desk_->pageId()) {
    preferences_.setPage(userId(), pageText(*desk_->pageId()));
  }
  stack_->removeWidget(desk_);
  delete desk_;
  desk_ = nullptr;
}

bool MainWindow::signOut(const QString& reason) {
  if (desk_ != nullptr && !desk_->mayLeave()) {
    return false;
  }
  leaveDesk();
  const std::optional<LeftHead> head = forgetActor();
  if (simulated_->end()) {
    openDatabase();
    if (!reason.isEmpty() && stack_->currentWidget() == &founding_->panel()) {
      founding_->panel().say(tr("%1. The sample data have been deleted").arg(reason));
    }
    return true;
  }
  enterSignIn();
  if (!reason.isEmpty()) {
    signIn().say(reason, false);
  }
  signIn().tellHead(head);
  return true;
}

bool MainWindow::lock() {
  if (desk_ == nullptr || stack_->currentWidget() != desk_ || desk_->busy()) {
    return false;
  }
  if (record_.session()->actor().practiceOnly || simulated_->active()) {
    return signOut();  // nothing to return to
  }
  lock_->close(*record_.session(), record_.key());
  show(lock_->panel());
  return true;
}

void MainWindow::signOutBeyondDialogs(const QString& reason) {
  lock_->closeDialogs();
  if (QThread::currentThread()->loopLevel() > deskLevel_) {
    // The caller of an open dialog is still in its event loop and belongs to the desk: it must return first.
    QTimer::singleShot(0, this, [this, reason] { signOutBeyondDialogs(reason); });
    return;
  }
  if (desk_ == nullptr || signOut(reason)) {
    return;
  }
  if (stack_->currentWidget() == desk_) {
    lock();
  }
  lock_->say(tr("Something is unfinished here. Only its owner can sign out"));
}

std::optional<LeftHead> MainWindow::forgetActor() {
  if (simulated_->lookingRound() && record_.session() != nullptr) {
    record_.session()->setActor({});  // the audit trail is deleted with the folder
    return std::nullopt;
  }
  return record_.signOut();
}

void MainWindow::enterDeskAs(const Actor& actor, const QString& sentence) {
  // Deferred, because the requesting menu or page is destroyed with the desk.
  QTimer::singleShot(0, this, [this, actor, sentence] {
    if (desk_ == nullptr) {
      return;  // signed out meanwhile
    }
    leaveDesk();
    forgetActor();
    record_.session()->setActor(actor);
    enterDesk();
    desk_->context().notify(sentence);
  });
}

QString MainWindow::userId() const {
  return record_.session() != nullptr ? toQString(record_.session()->actor().userId) : QString();
}

void MainWindow::chooseLanguage(Language language) {
  appearance_.choose(userId(), language);
  if (desk_ != nullptr) {
    desk_->setLanguage(language);
  }
}

void MainWindow::chooseTheme(ThemeKind kind) {
  appearance_.choose(userId(), kind);
  if (desk_ != nullptr) {
    desk_->setThemeKind(kind);
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayClose_ || background_.working() || (desk_ != nullptr && !desk_->mayLeave())) {
    event->ignore();
    return;
  }
  preferences_.setLayout(QStringLiteral("window"), saveGeometry());
  leaveDesk();
  if (const std::optional<LeftHead> head = forgetActor(); head && !closesSilently(*head)) {
    enterSignIn();
    signIn().say(tr("Close the window once more, when you have read this"), true);
    signIn().tellHead(head);
    event->ignore();
    return;
  }
  record_.leave();
  event->accept();
}

}  // namespace torsio::gui
