// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/main_window.h"

#include <iostream>
#include <utility>

#include <QApplication>
#include <QCloseEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/base/clock_time.h"
#include "app/gui/base/job_panel.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/shell/dialog_lock.h"
#include "app/gui/shell/lock_panel.h"
#include "app/gui/shell/password_panel.h"
#include "app/gui/shell/shortcut_sheet.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/gui/shell/trouble_panel.h"
#include "app/services/recording/station_writer.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

/// Enter presses the button that has the keyboard, as it does in dialogs. True: it was one.
bool pressedByEnter(const QWidget& window, QObject* watched, const QEvent& event) {
  if (event.type() != QEvent::KeyPress) {
    return false;
  }
  const auto& key = static_cast<const QKeyEvent&>(event);
  const bool enter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
  const bool plain = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  auto* button = qobject_cast<QAbstractButton*>(watched);
  const bool pressable =
      qobject_cast<QPushButton*>(watched) != nullptr || qobject_cast<QToolButton*>(watched) != nullptr;
  if (!enter || !plain || key.isAutoRepeat() || !pressable || button->window() != &window) {
    return false;
  }
  button->click();
  return true;
}

}  // namespace

MainWindow::MainWindow(const ShellSetup& setup)
    : setup_(setup),
      preferences_(setup.remember),
      idle_(setup.clock != nullptr ? *setup.clock : machineClock_, setup.idle.value_or(IdleLimits{})),
      mayClose_(!setup.kiosk),
      idleWarning_(new QLabel(this)),
      awayBanner_(new QLabel(this)),
      visit_(new VisitBar(this)),
      stack_(new QStackedWidget(this)) {
  setWindowTitle(QStringLiteral("Torsio"));
  setObjectName(QStringLiteral("shell"));
  setAutoFillBackground(true);
  // Without a smallest size of its own the window grows with what a page shows for a moment, beyond the
  // screen, and stays there.
  setMinimumSize(640, 400);
  resize(1366, 768);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  idleWarning_->setObjectName(QStringLiteral("idleWarning"));
  idleWarning_->setAlignment(Qt::AlignCenter);
  idleWarning_->hide();
  column->addWidget(idleWarning_);
  awayBanner_->setObjectName(QStringLiteral("databaseAway"));
  awayBanner_->setAlignment(Qt::AlignCenter);
  awayBanner_->setWordWrap(true);
  awayBanner_->hide();
  column->addWidget(awayBanner_);
  visit_->hide();
  column->addWidget(visit_);
  connect(visit_, &VisitBar::wanted, this, &MainWindow::visit);
  column->addWidget(stack_);
  SceneView::prepareWindow(*this);
  applyChoices({});
  createPanels();
  createKeys();
  retranslate();
  qApp->installEventFilter(this);
  connect(&second_, &QTimer::timeout, this, &MainWindow::watchIdleness);
  connect(&second_, &QTimer::timeout, this, &MainWindow::heartbeat);
  second_.start(1000);
  restoreGeometry(preferences_.layout(QStringLiteral("window")).toByteArray());
}

MainWindow::~MainWindow() {
  qApp->removeEventFilter(this);
  delete desk_;  // before the session that it works at
}

SessionKey MainWindow::key() const {
  SessionKey key;
  key.locator = setup_.locator.toStdString();
  key.station = setup_.station;
  return key;
}

void MainWindow::createPanels() {
  trouble_ = new TroublePanel(this);
  firstRun_ = new FirstRunPanel(setup_.locator, this);
  signIn_ = new SignInPanel(this);
  password_ = new PasswordPanel(this);
  lock_ = new LockPanel(this);
  const std::initializer_list<std::pair<QWidget*, const char*>> panels{{trouble_, "trouble"},
                                                                       {firstRun_, "first run"},
                                                                       {signIn_, "sign-in"},
                                                                       {password_, "password"},
                                                                       {lock_, "lock"}};
  for (const auto& [panel, name] : panels) {
    panel->setObjectName(QLatin1String(name));
    stack_->addWidget(panel);
  }
  trouble_->setTheme(theme(theme_));
  connect(trouble_, &TroublePanel::retryWanted, this, &MainWindow::openDatabase);
  connect(trouble_, &TroublePanel::otherDatabaseWanted, this, &MainWindow::enterFirstRun);
  connect(firstRun_, &FirstRunPanel::languageWanted, this, [this](Language language) {
    firstRunLanguage_ = language;
    chooseLanguage(language);
  });
  connect(firstRun_, &FirstRunPanel::chosen, this, &MainWindow::setUp);
  connect(firstRun_, &FirstRunPanel::done, this, &MainWindow::enterDesk);
  connect(firstRun_, &FirstRunPanel::lookRoundWanted, this, &MainWindow::lookRound);
  connect(&firstRun_->job(), &JobPanel::cancelled, this, [this] { setUpCancelled_->store(true); });
  connect(signIn_, &SignInPanel::passwordGiven, this, &MainWindow::tryPassword);
  connect(signIn_, &SignInPanel::pinGiven, this, &MainWindow::tryPin);
  connect(signIn_, &SignInPanel::codeGiven, this, &MainWindow::tryCode);
  connect(signIn_, &SignInPanel::languageWanted, this, &MainWindow::chooseLanguage);
  connect(signIn_, &SignInPanel::guestChosen, this, &MainWindow::enterAsGuest);
  connect(password_, &PasswordPanel::chosen, this, &MainWindow::changePassword);
  connect(password_, &PasswordPanel::givenUp, this, [this] {
    if (desk_ != nullptr) {
      show(desk_);
    } else {
      enterSignIn();
    }
  });
  dialogLock_ = new DialogLock(this);
  for (LockPanel* lock : {lock_, &dialogLock_->panel()}) {
    connect(lock, &LockPanel::passwordGiven, this, &MainWindow::unlock);
    connect(lock, &LockPanel::signOutWanted, this, [this] { signOutBeyondDialogs({}); });
  }
  connect(&background_, &Background::workingChanged, this, [this](bool working) {
    signIn_->setWorking(working);
    password_->setWorking(working);
    firstRun_->setWorking(working);
    lock_->setWorking(working);
    dialogLock_->panel().setWorking(working);
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
  connect(signIn_, &SignInPanel::leaveKioskWanted, this, &MainWindow::leaveKiosk);
  signIn_->setKiosk(setup_.kiosk);
}

void MainWindow::toggleFullScreen() {
  if (!setup_.kiosk) {
    setWindowState(windowState() ^ Qt::WindowFullScreen);
  }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::Wheel:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
      idle_.activity();
      break;
    default:
      break;
  }
  return pressedByEnter(*this, watched, *event) || QWidget::eventFilter(watched, event);
}

void MainWindow::watchIdleness() {
  const bool watched = desk_ != nullptr && stack_->currentWidget() == desk_;
  const bool busy = !watched || desk_->busy();
  if (busy != idle_.busy()) {
    idle_.setBusy(busy);  // each call begins the count anew
  }
  const IdleState state = idle_.state();
  idleWarning_->setVisible(watched && state == IdleState::kWarning);
  if (!watched) {
    return;
  }
  if (state == IdleState::kWarning) {
    const QString left = clockTimeLeft(idle_.untilLock_us());
    const bool ends = setup_.kiosk || session_->actor().practiceOnly || lookedAt_ || simulated_;
    idleWarning_->setText(
        ends ? tr("Still there? You will be signed out in %1. Press any key to stay").arg(left)
             : tr("Still there? The screen will be locked in %1. Press any key to stay").arg(left));
  } else if (state == IdleState::kLocked) {
    idle_.unlock();  // the lock panel is the lock; the guard counts anew once it is open
    const bool ends = setup_.kiosk || session_->actor().practiceOnly || lookedAt_ || simulated_;
    if (ends) {
      signOutBeyondDialogs(tr("You were signed out because nobody was here"));
    } else {
      lock();
    }
  }
}

void MainWindow::show(QWidget* panel) {
  stack_->setCurrentWidget(panel);
  visit_->setVisible(lookedAt_ != nullptr && panel == desk_);
}

void MainWindow::start() {
  if (const QString chosen = preferences_.database(); !chosen.isEmpty()) {
    setup_.locator = chosen;
  }
  openDatabase();
}

void MainWindow::heartbeat() {
  if (!line_) {
    return;
  }
  line_->signIn(session_->actor());
  showAnswers(line_->answers());
  if (const std::size_t refused = line_->refused(); refused != refusedTold_) {
    refusedTold_ = refused;
    if (refused > 0 && desk_ != nullptr) {
      desk_->context().notify(
          tr("The database permanently refused %Ln entries of this station. Please tell its administrator",
             nullptr, static_cast<int>(refused)));
    }
  }
}

void MainWindow::showAnswers(bool answers) {
  const bool running = desk_ != nullptr && desk_->busy();
  awayBanner_->setVisible(!answers);
  if (!answers) {
    awayBanner_->setText(running ? tr("The database does not answer. Your run continues; it is kept on this "
                                      "computer and stored as soon as the database answers")
                                 : tr("The database does not answer. Torsio tries again by itself; what is "
                                      "stored is safe"));
    if (const std::size_t waiting = line_ ? line_->waiting() : 0; waiting > 0) {
      awayBanner_->setText(tr("%1. Waiting to be stored: %2").arg(awayBanner_->text()).arg(waiting));
    }
    settleDue_ = true;
  }
  answered_ = answers && (answered_ || reconnect());
  if (answers && settleDue_ && !running && !background_.working()) {
    settleAgain();
  }
}

/// The connection of the pages was lost with the server. False: it is away again, or never was back; the next
/// heartbeat that is answered tries anew.
bool MainWindow::reconnect() {
  try {
    session_->reconnect();
  } catch (...) {
    return false;
  }
  if (desk_ != nullptr) {
    desk_->databaseAnswered();
  }
  return true;
}

std::optional<LeftHead> MainWindow::forgetActor() {
  if (!session_ || session_->actor().userId.empty()) {
    return std::nullopt;
  }
  if (lookedAt_) {
    session_->setActor({});
    return std::nullopt;
  }
  const bool administrator = session_->actor().hasRole("administrator");
  try {
    if (line_ && !line_->answers()) {
      line_->write([](SessionContext& own) { torsio::signOut(own); });
      session_->setActor({});
    } else {
      torsio::signOut(*session_);
    }
  } catch (...) {
    session_->setActor({});  // the audit trail cannot be written; nobody stays signed in for that
    return std::nullopt;
  }
  if (!administrator) {
    return std::nullopt;
  }
  if (line_ && !line_->answers()) {
    return LeftHead{.trouble = Text::tr("The database does not answer")};
  }
  try {
    return headOnLeaving(session_->connectionWithoutRight(), session_->now_us());
  } catch (const Error& error) {
    return LeftHead{.trouble = error.happenedText()};
  }
}

bool MainWindow::staysSilent(const LeftHead& head) {
  if (!head.witness.empty()) {
    std::cerr << "torsio: the head of the audit trail was added to " << head.witness.string() << ": "
              << head.line << "\n";
  }
  return head.trouble.empty() || qGuiApp->isSavingSession();  // a computer that goes off waits for nobody
}

void MainWindow::tellHead(const std::optional<LeftHead>& head) {
  if (!head) {
    return;
  }
  if (head->line.empty()) {
    signIn_->say(tr("The head of the audit trail was not kept: %1").arg(toQString(head->trouble)), true);
    return;
  }
  signIn_->tellHead(*head);
}

QString MainWindow::userId() const {
  return session_ ? toQString(session_->actor().userId) : QString();
}

void MainWindow::retranslate() {
  idleWarning_->setAccessibleName(tr("Warning of the idle lock"));
  awayBanner_->setAccessibleName(tr("State of the database"));
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
  }
  QWidget::changeEvent(event);
}

void MainWindow::applyChoices(const QString& user) {
  const auto language = preferences_.language(user);
  const auto stations = preferences_.language({});
  if (language || stations) {
    language_.choose(language ? *language : *stations);
  }
  // A kiosk stands in a dark room; other places follow the desktop, from the first page on.
  const ThemeKind usual = setup_.kiosk || setup_.systemIsDark ? ThemeKind::kDark : ThemeKind::kLight;
  auto remembered = preferences_.themeKind(user);
  if (!remembered) {
    remembered = preferences_.themeKind({});
  }
  theme_ = setup_.theme.value_or(remembered.value_or(usual));
  applyTheme(*qApp, theme(theme_));
  if (trouble_ != nullptr) {
    trouble_->setTheme(theme(theme_));
  }
}

void MainWindow::chooseLanguage(Language language) {
  language_.choose(language);
  preferences_.setLanguage(userId(), language);
  if (desk_ != nullptr) {
    desk_->setLanguage(language);
  }
}

void MainWindow::chooseTheme(ThemeKind kind) {
  theme_ = kind;
  setup_.theme.reset();
  preferences_.setThemeKind(userId(), kind);
  applyTheme(*qApp, theme(kind));
  trouble_->setTheme(theme(kind));
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
  if (const std::optional<LeftHead> head = forgetActor(); head && !staysSilent(*head)) {
    enterSignIn();
    signIn_->say(tr("Close the window once more, when you have read this"), true);
    tellHead(head);
    event->ignore();
    return;
  }
  if (line_) {
    line_->leave();
  }
  line_.reset();
  lessons_.reset();
  event->accept();
}

}  // namespace torsio::gui
