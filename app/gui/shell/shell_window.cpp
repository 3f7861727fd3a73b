// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/shell_window.h"

#include <utility>

#include <QApplication>
#include <QCloseEvent>
#include <QInputDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "app/gui/scene/scene_view.h"
#include "app/gui/shell/about_box.h"
#include "app/gui/shell/credentials_dialog.h"
#include "app/gui/shell/job_panel.h"
#include "app/gui/shell/lock_panel.h"
#include "app/gui/shell/password_panel.h"
#include "app/gui/shell/rail.h"
#include "app/gui/shell/shortcut_sheet.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/gui/shell/spoken.h"
#include "app/gui/shell/trouble_panel.h"
#include "app/session/access/first_run.h"
#include "app/session/care/demonstration_removal.h"
#include "app/session/care/station_start.h"
#include "sim/base/clock.h"
#include "sim/base/error.h"

namespace torsio::gui {

namespace {

QString said(const std::exception_ptr& problem) {
  try {
    std::rethrow_exception(problem);
  } catch (const Error& error) {
    return spokenLine(error);
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
}

/// Enter presses the button that has the keyboard, as it does in dialogs. True: it was one.
bool pressedByEnter(const QWidget& window, QObject* watched, const QEvent& event) {
  if (event.type() != QEvent::KeyPress) return false;
  const auto& key = static_cast<const QKeyEvent&>(event);
  const bool enter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
  const bool plain = (key.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  auto* button = qobject_cast<QAbstractButton*>(watched);
  const bool pressable =
      qobject_cast<QPushButton*>(watched) != nullptr || qobject_cast<QToolButton*>(watched) != nullptr;
  if (!enter || !plain || key.isAutoRepeat() || !pressable || button->window() != &window) return false;
  button->click();
  return true;
}

}  // namespace

ShellWindow::ShellWindow(const ShellSetup& setup)
    : setup_(setup),
      preferences_(setup.remember),
      idle_(setup.clock != nullptr ? *setup.clock : machineClock_, setup.idle),
      mayClose_(!setup.kiosk),
      idleWarning_(new QLabel(this)),
      stack_(new QStackedWidget(this)) {
  setWindowTitle(QStringLiteral("Torsio"));
  setObjectName(QStringLiteral("shell"));
  setAutoFillBackground(true);
  resize(1366, 768);
  // Without a smallest size of its own the window grows with what a page shows for a moment, beyond the
  // screen, and stays there.
  setMinimumSize(640, 400);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  idleWarning_->setObjectName(QStringLiteral("idleWarning"));
  idleWarning_->setAlignment(Qt::AlignCenter);
  idleWarning_->hide();
  column->addWidget(idleWarning_);
  column->addWidget(stack_);
  SceneView::prepareWindow(*this);
  applyChoices({}, true);
  createPanels();
  createKeys();
  retranslate();
  qApp->installEventFilter(this);
  connect(&second_, &QTimer::timeout, this, &ShellWindow::watchIdleness);
  connect(&second_, &QTimer::timeout, this, &ShellWindow::beat);
  second_.start(1000);
  restoreGeometry(preferences_.layout(QStringLiteral("window")).toByteArray());
}

ShellWindow::~ShellWindow() {
  qApp->removeEventFilter(this);
  delete desk_;  // before the workplace that it works at
}

WorkplaceKey ShellWindow::key() const {
  WorkplaceKey key;
  key.locator = setup_.locator.toStdString();
  key.station = setup_.station;
  return key;
}

void ShellWindow::createPanels() {
  trouble_ = new TroublePanel(this);
  firstRun_ = new FirstRunPanel(setup_.locator, this);
  signIn_ = new SignInPanel(this);
  password_ = new PasswordPanel(this);
  lock_ = new LockPanel(this);
  for (QWidget* panel : std::initializer_list<QWidget*>{trouble_, firstRun_, signIn_, password_, lock_}) {
    stack_->addWidget(panel);
  }
  trouble_->setTheme(theme(theme_));
  connect(trouble_, &TroublePanel::retryWanted, this, &ShellWindow::openDatabase);
  connect(trouble_, &TroublePanel::otherDatabaseWanted, this, &ShellWindow::enterFirstRun);
  connect(firstRun_, &FirstRunPanel::languageWanted, this, &ShellWindow::chooseLanguage);
  connect(firstRun_, &FirstRunPanel::chosen, this, &ShellWindow::setUp);
  connect(firstRun_, &FirstRunPanel::done, this, &ShellWindow::enterDesk);
  connect(signIn_, &SignInPanel::passwordGiven, this, &ShellWindow::tryPassword);
  connect(signIn_, &SignInPanel::pinGiven, this, &ShellWindow::tryPin);
  connect(signIn_, &SignInPanel::languageWanted, this, &ShellWindow::chooseLanguage);
  connect(signIn_, &SignInPanel::guestChosen, this, &ShellWindow::enterAsGuest);
  connect(password_, &PasswordPanel::chosen, this, &ShellWindow::changePassword);
  connect(password_, &PasswordPanel::givenUp, this, [this] {
    if (desk_ != nullptr) {
      show(desk_);
    } else {
      enterSignIn();
    }
  });
  connect(lock_, &LockPanel::passwordGiven, this, &ShellWindow::unlock);
  connect(lock_, &LockPanel::signOutWanted, this, [this] {
    if (!signOut()) lock_->say(tr("Something is unfinished here. Only its owner can sign out"));
  });
  connect(&background_, &Background::workingChanged, this, [this](bool working) {
    signIn_->setWorking(working);
    password_->setWorking(working);
    firstRun_->setWorking(working);
    lock_->setWorking(working);
  });
}

void ShellWindow::createKeys() {
  const auto key = [this](const QKeySequence& keys, auto act) {
    connect(new QShortcut(keys, this), &QShortcut::activated, this, act);
  };
  const auto sheet = [this] { ShortcutSheet(desk_, this).exec(); };
  key(Qt::Key_F1, sheet);
  key(QKeySequence(QStringLiteral("?")), sheet);
  key(Qt::Key_F11, [this] { toggleFullScreen(); });
  key(Qt::CTRL | Qt::ALT | Qt::Key_L, [this] { lock(); });
  connect(signIn_, &SignInPanel::leaveKioskWanted, this, &ShellWindow::leaveKiosk);
  signIn_->setKiosk(setup_.kiosk);
}

void ShellWindow::toggleFullScreen() {
  if (!setup_.kiosk) setWindowState(windowState() ^ Qt::WindowFullScreen);
}

/// Only somebody who may change the centre's settings gets out of the kiosk.
void ShellWindow::leaveKiosk() {
  CredentialsDialog dialog(tr("Leave kiosk mode"),
                           tr("An administrator ends the kiosk with name and password."), this);
  if (dialog.exec() != QDialog::Accepted) return;
  background_.run(
      [this, key = key(), login = dialog.login(), password = dialog.password()]() -> Background::Finish {
        Workplace own(key);
        const SignInAnswer answer = torsio::signIn(own, login.toStdString(), password.toStdString());
        const bool may = answer.outcome == SignIn::kOk && own.may(Operation::kSettingsEdit);
        if (answer.outcome == SignIn::kOk) torsio::signOut(own);
        return [this, may] {
          if (!may) {
            signIn_->say(tr("Only an administrator can end the kiosk"), true);
            return;
          }
          mayClose_ = true;
          close();
        };
      },
      [this](const std::exception_ptr& problem) { signIn_->say(said(problem), true); });
}

bool ShellWindow::eventFilter(QObject* watched, QEvent* event) {
  if (pressedByEnter(*this, watched, *event)) return true;
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
  return QWidget::eventFilter(watched, event);
}

void ShellWindow::watchIdleness() {
  const bool watched = desk_ != nullptr && stack_->currentWidget() == desk_;
  const bool busy = !watched || desk_->busy();
  if (busy != idle_.busy()) idle_.setBusy(busy);  // each call begins the count anew
  const IdleState state = idle_.state();
  idleWarning_->setVisible(watched && state == IdleState::kWarning);
  if (!watched) return;
  if (state == IdleState::kWarning) {
    const std::int64_t left_s = (idle_.untilLock_us() + 999'999) / 1'000'000;
    const bool ends = setup_.kiosk || workplace_->actor().practiceOnly;
    idleWarning_->setText(
        ends ? tr("Nobody here? You will be signed out in %1 s. Press any key to stay").arg(left_s)
             : tr("Nobody here? The screen will be locked in %1 s. Press any key to stay").arg(left_s));
  } else if (state == IdleState::kLocked) {
    idle_.unlock();  // the lock panel is the lock; the guard counts anew once it is open
    const bool ends = setup_.kiosk || workplace_->actor().practiceOnly;
    if (!ends || !signOut(tr("You were signed out because nobody was here"))) lock();
  }
}

void ShellWindow::show(QWidget* panel) {
  stack_->setCurrentWidget(panel);
}

QString ShellWindow::screen() const {
  const QWidget* shown = stack_->currentWidget();
  const std::pair<const QWidget*, const char*> names[] = {{trouble_, "trouble"}, {firstRun_, "first run"},
                                                          {signIn_, "sign-in"},  {password_, "password"},
                                                          {lock_, "lock"},       {desk_, "desk"}};
  for (const auto& [panel, name] : names) {
    if (panel == shown) return QLatin1String(name);
  }
  return {};
}

void ShellWindow::start() {
  if (const QString chosen = preferences_.database(); !chosen.isEmpty()) setup_.locator = chosen;
  openDatabase();
}

void ShellWindow::openDatabase() {
  pulse_.reset();
  try {
    workplace_ = std::make_unique<Workplace>(key());
    workplace_->setPasswordCost(setup_.passwordCost);
    if (needsFirstRun(workplace_->connection())) {
      enterFirstRun();
      return;
    }
    const CentreSign sign = centreSign(workplace_->connection());
    centre_ = QString::fromStdString(sign.name);
    if (!preferences_.language({})) {
      if (const auto language = languageOf(QString::fromStdString(sign.language))) chooseLanguage(*language);
    }
    enterSignIn();
    settle();
  } catch (...) {
    trouble_->tell(std::current_exception());
    show(trouble_);
  }
}

/// Recordings that wait in files can take long to store; until then nobody signs in.
void ShellWindow::settle() {
  background_.run(
      [this, key = key(),
       folder = setup_.unstored.empty() ? unstoredFolder() : setup_.unstored]() -> Background::Finish {
        Workplace own(key);
        const StationStart start = settleStation(own, folder);
        return [this, kept = start.kept] {
          kept_ = kept;
          if (!kept_.empty()) signIn_->say(spokenLines(kept_), true);
          pulse_.emplace(*workplace_);
          beat();
        };
      },
      [this](const std::exception_ptr& problem) {
        signIn_->say(said(problem), true);
        pulse_.emplace(*workplace_);
      });
}

void ShellWindow::beat() {
  if (pulse_ && (desk_ == nullptr || !desk_->busy())) pulse_->beat();
}

void ShellWindow::tellKept() {
  if (kept_.empty() || workplace_->actor().practiceOnly) return;
  Q_EMIT desk_->context().failed(
      tr("%n recording(s) of this station could not be stored", nullptr, static_cast<int>(kept_.size())),
      tr("The files are kept. Please show this to your administrator"), spokenLines(kept_));
  kept_.clear();
}

void ShellWindow::enterFirstRun() {
  firstRun_->setLanguage(language_.present());
  show(firstRun_);
}

void ShellWindow::setUp(const FirstRunChoice& choice) {
  if (!QUrl(choice.locator).password().isEmpty()) {
    firstRun_->say(
        tr("Leave the password out of the address; it would stand in a settings file. Put it into .pgpass"));
    return;
  }
  setup_.locator = choice.locator;
  pulse_.reset();
  workplace_.reset();
  firstRun_->job().begin(tr("Setting up the centre"));
  background_.run(
      [this, choice, key = key()]() -> Background::Finish {
        Workplace own(key);
        own.setPasswordCost(setup_.passwordCost);
        if (!needsFirstRun(own.connection())) {
          return [this, choice] {  // a centre is there already: its people sign in
            firstRun_->job().end();
            preferences_.setDatabase(choice.locator);
            openDatabase();
          };
        }
        const auto accounts =
            performFirstRun(own, choice.first, setup_.assets, [this](const Progress& progress) {
              QMetaObject::invokeMethod(this, [this, progress] {
                firstRun_->job().move(spoken(progress.step), progress.fraction, progress.remaining_s);
              });
            });
        return [this, actor = own.actor(), choice, accounts] {
          firstRun_->job().end();
          workplace_ = std::make_unique<Workplace>(this->key());
          workplace_->setPasswordCost(setup_.passwordCost);
          workplace_->setActor(actor);
          pulse_.emplace(*workplace_);
          centre_ = QString::fromStdString(choice.first.centre);
          preferences_.setDatabase(choice.locator);
          firstRun_->showAccounts(accounts);
        };
      },
      [this](const std::exception_ptr& problem) {
        firstRun_->job().end();
        firstRun_->say(said(problem));
      });
}

void ShellWindow::enterSignIn() {
  applyChoices({}, true);
  signIn_->setCentre(centre_);
  signIn_->clear();
  show(signIn_);
}

void ShellWindow::tryPassword(const QString& login, const QString& password) {
  background_.run(
      [this, key = key(), login, password]() -> Background::Finish {
        Workplace own(key);
        const SignInAnswer answer = torsio::signIn(own, login.toStdString(), password.toStdString());
        return [this, answer, login, password] { took(answer, login, password); };
      },
      [this](const std::exception_ptr& problem) { signIn_->say(said(problem), true); });
}

void ShellWindow::tryPin(const QString& login, const QString& pin) {
  background_.run(
      [this, key = key(), login, pin]() -> Background::Finish {
        Workplace own(key);
        const SignInAnswer answer = signInForPractice(own, login.toStdString(), pin.toStdString());
        return [this, answer, login] { took(answer, login, {}); };
      },
      [this](const std::exception_ptr& problem) { signIn_->say(said(problem), true); });
}

void ShellWindow::took(const SignInAnswer& answer, const QString& login, const QString& password) {
  switch (answer.outcome) {
    case SignIn::kOk:
      workplace_->setActor(answer.actor);
      enterDesk();
      break;
    case SignIn::kMustChange:
      password_->begin(login, password, true);
      show(password_);
      break;
    case SignIn::kWrong:
      signIn_->say(tr("Name and password do not fit together. Please try again"), true);
      break;
    case SignIn::kWait:
      signIn_->waitUntil(answer.waitUntilUtc_us, workplace_->now_us());
      break;
    case SignIn::kDisabled:
      signIn_->say(tr("This account is switched off. Ask your administrator"), true);
      break;
  }
}

void ShellWindow::enterAsGuest() {
  Actor guest;
  guest.practiceOnly = true;
  workplace_->setActor(guest);
  enterDesk();
}

void ShellWindow::changePassword(const QString& login, const QString& oldPassword,
                                 const QString& newPassword) {
  background_.run(
      [this, key = key(), login, oldPassword, newPassword]() -> Background::Finish {
        Workplace own(key);
        own.setPasswordCost(setup_.passwordCost);
        const SignInAnswer answer =
            changeOwnPassword(own, login.toStdString(), oldPassword.toStdString(), newPassword.toStdString());
        return [this, answer, login] {
          if (desk_ == nullptr) {
            took(answer, login, {});
            return;
          }
          show(desk_);
          desk_->context().notify(tr("The new password is in force"));
        };
      },
      [this](const std::exception_ptr& problem) { password_->say(said(problem)); });
}

void ShellWindow::unlock(const QString& password) {
  background_.run(
      [this, key = key(), login = workplace_->actor().login, password]() -> Background::Finish {
        Workplace own(key);
        const SignInAnswer answer = torsio::signIn(own, login, password.toStdString());
        return [this, answer] {
          if (answer.outcome == SignIn::kOk && answer.actor.userId == workplace_->actor().userId) {
            show(desk_);
          } else if (answer.outcome == SignIn::kWait) {
            const std::int64_t left_s = (answer.waitUntilUtc_us - workplace_->now_us()) / 1'000'000 + 1;
            lock_->say(tr("Too many wrong tries. Please wait %1 s").arg(left_s));
          } else {
            lock_->say(tr("That is not the password. Please try again"));
          }
        };
      },
      [this](const std::exception_ptr& problem) { lock_->say(said(problem)); });
}

QString ShellWindow::userId() const {
  return workplace_ ? QString::fromStdString(workplace_->actor().userId) : QString();
}

void ShellWindow::enterDesk() {
  leaveDesk();
  const bool station = homeOf(workplace_->actor()) == Home::kStation;
  applyChoices(userId(), station);
  openDesk();
  tellKept();
}

void ShellWindow::openDesk() {
  DeskSetup setup;
  setup.assets = setup_.assets;
  setup.centre = centre_;
  setup.language = language_.present();
  setup.theme = theme_;
  setup.kiosk = setup_.kiosk;
  setup.groups = setup_.groups;
  desk_ = new Desk(*workplace_, setup, this);
  stack_->addWidget(desk_);
  connect(desk_, &Desk::signOutWanted, this, [this] { signOut(); });
  connect(desk_, &Desk::lockWanted, this, &ShellWindow::lock);
  connect(desk_, &Desk::languageWanted, this, &ShellWindow::chooseLanguage);
  connect(desk_, &Desk::themeWanted, this, &ShellWindow::chooseTheme);
  connect(desk_, &Desk::pinWanted, this, &ShellWindow::choosePin);
  connect(desk_, &Desk::shortcutsWanted, this, [this] { ShortcutSheet(desk_, this).exec(); });
  connect(desk_, &Desk::aboutWanted, this, [this] { showAboutBox(this); });
  connect(desk_, &Desk::demonstrationRemovalWanted, this, &ShellWindow::removeDemonstration);
  // Later, since the page that asks for it dies with the desk.
  connect(&desk_->context(), &ShellContext::recordChangeWanted, this, [this](const RecordChange& change) {
    QTimer::singleShot(0, this, [this, change] { changeRecord(change); });
  });
  connect(desk_, &Desk::passwordChangeWanted, this, [this] {
    password_->begin(QString::fromStdString(workplace_->actor().login), {}, false);
    show(password_);
  });
  desk_->rail().setNarrow(preferences_.layout(QStringLiteral("rail_narrow")).toBool());
  connect(&desk_->rail(), &Rail::narrowChanged, this,
          [this](bool narrow) { preferences_.setLayout(QStringLiteral("rail_narrow"), narrow); });
  show(desk_);
  desk_->openHome();
}

void ShellWindow::leaveDesk() {
  if (desk_ == nullptr) return;
  stack_->removeWidget(desk_);
  delete desk_;
  desk_ = nullptr;
}

bool ShellWindow::signOut(const QString& reason) {
  if (desk_ != nullptr && !desk_->mayLeave()) return false;
  leaveDesk();
  try {
    torsio::signOut(*workplace_);
  } catch (...) {
    workplace_->setActor({});  // the audit trail cannot be written; nobody stays signed in for that
  }
  enterSignIn();
  if (!reason.isEmpty()) signIn_->say(reason, false);
  return true;
}

bool ShellWindow::lock() {
  if (desk_ == nullptr || stack_->currentWidget() != desk_ || desk_->busy()) return false;
  if (workplace_->actor().practiceOnly) return signOut();  // nothing to come back to
  lock_->begin(QString::fromStdString(workplace_->actor().login));
  show(lock_);
  return true;
}

void ShellWindow::choosePin() {
  bool entered = false;
  const QString pin = QInputDialog::getText(this, tr("PIN for practice"),
                                            tr("At least four digits. With it you practise at a station; "
                                               "nothing is recorded.\nLeave it empty to remove it."),
                                            QLineEdit::Password, {}, &entered);
  if (!entered) return;
  try {
    setOwnPin(*workplace_, pin.toStdString());
    desk_->context().notify(pin.isEmpty() ? tr("The PIN was removed") : tr("The PIN is in force"));
  } catch (...) {
    desk_->context().report(std::current_exception());
  }
}

void ShellWindow::removeDemonstration() {
  try {
    const DemonstrationSize size = demonstrationSize(*workplace_);
    if (size.rows == 0) {
      desk_->context().notify(tr("There is no demonstration data"));
      return;
    }
    const QLocale locale;
    QMessageBox question(QMessageBox::Question, tr("Remove demonstration data"),
                         tr("Remove %1 simulated people, %2 trials and %3 marks?")
                             .arg(locale.toString(static_cast<qlonglong>(size.people)),
                                  locale.toString(static_cast<qlonglong>(size.trials)),
                                  locale.toString(static_cast<qlonglong>(size.marks))),
                         QMessageBox::Cancel, this);
    question.setInformativeText(tr("Your own data stay as they are. This cannot be undone."));
    const QAbstractButton* remove = question.addButton(tr("Remove"), QMessageBox::DestructiveRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    if (question.clickedButton() != remove) return;
    desk_->context().run(
        tr("Removing the demonstration"),
        [reason = tr("Removed from the user menu").toStdString()](Workplace& own, const ProgressCallback&) {
          static_cast<void>(removeDemonstrationData(own, reason));
        },
        [this] { desk_->context().notify(tr("The demonstration data were removed")); });
  } catch (...) {
    desk_->context().report(std::current_exception());
  }
}

void ShellWindow::changeRecord(const RecordChange& change) {
  leaveDesk();
  try {
    torsio::signOut(*workplace_);
  } catch (...) {
    workplace_->setActor({});  // as in signOut
  }
  if (pulse_) pulse_->leave();
  pulse_.reset();
  workplace_.reset();  // nobody has the record open now
  QString sentence = change.sentence;
  bool failed = false;
  try {
    if (change.swap) change.swap();
    if (!change.locator.isEmpty()) {
      setup_.locator = change.locator;
      preferences_.setDatabase(change.locator);
    }
  } catch (...) {
    sentence = said(std::current_exception());
    failed = true;
  }
  openDatabase();
  signIn_->say(sentence, failed);
}

void ShellWindow::retranslate() {
  idleWarning_->setAccessibleName(tr("Warning of the idle lock"));
}

void ShellWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void ShellWindow::applyChoices(const QString& user, bool station) {
  const auto language = preferences_.language(user);
  const auto stations = preferences_.language({});
  if (language || stations) language_.choose(language ? *language : *stations);
  // The station stands in a dark room; offices follow the desktop.
  const ThemeKind usual = station || setup_.systemIsDark ? ThemeKind::kDark : ThemeKind::kLight;
  const auto remembered = preferences_.themeKind(user);
  theme_ = setup_.theme.value_or(remembered.value_or(usual));
  applyTheme(*qApp, theme(theme_));
  if (trouble_ != nullptr) trouble_->setTheme(theme(theme_));
}

void ShellWindow::chooseLanguage(Language language) {
  language_.choose(language);
  preferences_.setLanguage(userId(), language);
  if (desk_ != nullptr) desk_->setLanguage(language);
}

void ShellWindow::chooseTheme(ThemeKind kind) {
  theme_ = kind;
  setup_.theme.reset();
  preferences_.setThemeKind(userId(), kind);
  applyTheme(*qApp, theme(kind));
  trouble_->setTheme(theme(kind));
  if (desk_ != nullptr) desk_->setThemeKind(kind);
}

void ShellWindow::closeEvent(QCloseEvent* event) {
  if (!mayClose_ || background_.working() || (desk_ != nullptr && !desk_->mayLeave())) {
    event->ignore();
    return;
  }
  preferences_.setLayout(QStringLiteral("window"), saveGeometry());
  leaveDesk();
  if (workplace_ && !workplace_->actor().userId.empty()) {
    try {
      torsio::signOut(*workplace_);
    } catch (...) {
      workplace_->setActor({});  // as in signOut
    }
  }
  if (pulse_) pulse_->leave();
  pulse_.reset();
  event->accept();
}

}  // namespace torsio::gui
