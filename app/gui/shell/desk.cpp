// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/desk.h"

#include <algorithm>
#include <exception>
#include <utility>

#include <QActionGroup>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/base/awaits_calls.h"
#include "app/gui/base/background.h"
#include "app/gui/base/job_panel.h"
#include "app/gui/base/page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/banners.h"
#include "app/gui/shell/problem_panel.h"
#include "app/gui/shell/rail.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/window_events.h"
#include "app/services/access/access_service.h"
#include "app/services/access/signing.h"
#include "app/services/maintenance/retention.h"
#include "app/services/people/waiting_requests.h"

namespace torsio::gui {

namespace {

constexpr int kReadWaiting_ms = 20'000;
constexpr int kJobStretch = 3;  // of the free room in the header

QToolButton* headerButton(QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setIconSize({20, 20});
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

/// Focuses the first field of a page that has not chosen one.
void focusInto(QWidget& page) {
  if (QWidget* chosen = page.focusWidget(); chosen != nullptr && chosen->isVisibleTo(&page)) {
    chosen->setFocus(Qt::OtherFocusReason);
    return;
  }
  for (QWidget* widget = page.nextInFocusChain(); widget != &page; widget = widget->nextInFocusChain()) {
    const bool takes = (widget->focusPolicy() & Qt::TabFocus) != 0 && widget->isEnabled();
    if (takes && widget->isVisibleTo(&page) && page.isAncestorOf(widget)) {
      widget->setFocus(Qt::OtherFocusReason);
      return;
    }
  }
}

/// Returns the group (training, review, administration) of an actor's home page.
std::size_t homeGroup(const Actor& actor) {
  switch (homeOf(actor)) {
    case Home::kReview:
      return 1;
    case Home::kAdministrator:
      return 2;
    case Home::kStation:
      break;
  }
  return 0;
}

}  // namespace

Desk::Desk(SessionContext& session, const DeskSetup& setup, QWidget* parent)
    : QWidget(parent),
      context_(session, setup.assets, setup.theme),
      setup_(setup),
      reader_(new Background(this)) {
  auto* row = bareLayout<QHBoxLayout>(this, 0);
  createRail(setup.groups());
  row->addWidget(rail_);
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  column->addWidget(createHeader());
  column->addWidget(createBody(), 1);
  row->addLayout(column, 1);
  connectContext();
  setLanguage(setup.language);
  followLanguage(this, [this] { retranslate(); });
  applyColours(setup.theme);
  auto* clock = new QTimer(this);
  connect(clock, &QTimer::timeout, this, &Desk::readWaiting);
  clock->start(kReadWaiting_ms);
}

bool Desk::event(QEvent* event) {
  if (event->type() == QEvent::WindowActivate) {
    readWaiting();  // a dialog has closed, or the user is back
  }
  return QWidget::event(event);
}

void Desk::readWaiting() {
  const bool counts = entries_.contains(PageId::kUsers) || entries_.contains(PageId::kRoster);
  if (!counts || busy() || reader_->working() || context_.databaseAway()) {
    return;
  }
  reader_->run(
      context_.session().key(), [](SessionContext& own) { return waitingRequests(own); },
      [this](const WaitingRequests& waiting) {
        rail_->setWaiting(PageId::kUsers, waiting.toConfirm);
        rail_->setWaiting(PageId::kRoster, waiting.ofPeople);
      },
      [](const std::exception_ptr&) {});  // the window shows outages; the next reading tries again
}

Desk::~Desk() {
  context_.cancelJobs();
  disconnect(&context_, nullptr, this, nullptr);
  // Pages refer to the context, so they are deleted first, regardless of the widget tree.
  for (const auto& [id, page] : made_) {
    delete page;
  }
}

bool Desk::allowed(PageId id) {
  const PageFacts& facts = factsOf(id);
  return context_.may(facts.needs) && (!facts.alsoNeeds || context_.may(*facts.alsoNeeds));
}

void Desk::createRail(const std::vector<PageGroup>& groups) {
  std::vector<RailGroup> shown;
  const std::size_t own = homeGroup(context_.session().actor());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    RailGroup group{groups[g].title, {}};
    for (const PageEntry& entry : groups[g].pages) {
      if (!allowed(entry.id)) {
        continue;
      }
      entries_.emplace(entry.id, entry);
      const QString icon = QString::fromLatin1(factsOf(entry.id).icon);
      if (icon.isEmpty()) {
        continue;
      }
      group.items.push_back({entry.id, icon});
      if (!home_ && g == own) {
        home_ = entry.id;
      }
    }
    if (group.items.empty()) {
      continue;
    }
    // The user's own group comes first.
    shown.insert(g == own ? shown.begin() : shown.end(), std::move(group));
  }
  order_.clear();
  for (const RailGroup& group : shown) {
    for (const RailItem& item : group.items) {
      order_.push_back(item.id);
    }
  }
  // An allocator has only one page.
  if (entries_.contains(PageId::kAllocation) && context_.may(Operation::kAllocationRun) &&
      !context_.may(Operation::kStudySetup)) {
    home_ = PageId::kAllocation;
  }
  if (!home_ && !order_.empty()) {
    home_ = order_.front();
  }
  rail_ = new Rail(shown, this);
  connect(rail_, &Rail::chosen, this, [this](PageId id) { open(id); });
}

QWidget* Desk::createHeader() {
  auto* header = new QFrame(this);
  header->setObjectName(QStringLiteral("header"));
  auto* row = new QHBoxLayout(header);
  row->setContentsMargins(3 * kSpace, kSpace, kSpace, kSpace);
  row->setSpacing(kSpace);
  title_ = new QLabel(header);
  title_->setProperty("heading", true);
  practiceSign_ = new QLabel(header);
  practiceSign_->setProperty("caution", true);
  practiceSign_->setVisible(context_.session().actor().practiceOnly);
  centre_ = new QLabel(setup_.centre, header);
  centre_->setProperty("quiet", true);
  row->addWidget(title_);
  row->addSpacing(kSpace);
  row->addWidget(practiceSign_);
  // In the header, so that the page neither shrinks nor moves under the pointer.
  job_ = new JobPanel(header, JobPanel::Place::kHeader);
  row->addStrut(job_->sizeHint().height());
  row->addStretch(1);
  row->addWidget(job_, kJobStretch);
  row->addWidget(centre_);
  row->addSpacing(kSpace);
  language_ = headerButton(header);
  theme_ = headerButton(header);
  help_ = headerButton(header);
  user_ = headerButton(header);
  signOut_ = headerButton(header);
  language_->setPopupMode(QToolButton::InstantPopup);
  language_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  user_->setPopupMode(QToolButton::InstantPopup);
  user_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  signOut_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  languages_ = new QMenu(language_);
  auto* group = new QActionGroup(languages_);
  for (const Language language : {Language::kEnglish, Language::kSimplifiedChinese}) {
    QAction* action = languages_->addAction(languageName(language));
    action->setCheckable(true);
    action->setData(static_cast<int>(language));
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, language] { Q_EMIT languageWanted(language); });
  }
  language_->setMenu(languages_);
  userMenu_ = new QMenu(user_);
  user_->setMenu(userMenu_);
  for (QToolButton* button : {language_, theme_, help_, user_, signOut_}) {
    row->addWidget(button);
  }
  connect(theme_, &QToolButton::clicked, this, [this] {
    Q_EMIT themeWanted(context_.themeKind() == ThemeKind::kDark ? ThemeKind::kLight : ThemeKind::kDark);
  });
  connect(help_, &QToolButton::clicked, this, &Desk::shortcutsWanted);
  connect(signOut_, &QToolButton::clicked, this, &Desk::signOutWanted);
  return header;
}

QWidget* Desk::createBody() {
  auto* body = new QWidget(this);
  auto* column = bareLayout<QVBoxLayout>(body, 0);
  problem_ = new ProblemPanel(body);
  problem_->floatAtTop();
  stack_ = new QStackedWidget(body);
  column->addWidget(stack_, 1);
  toast_ = new Toast(body);
  return body;
}

void Desk::connectContext() {
  connect(&context_, &ShellContext::pageWanted, this,
          [this](PageId id, const QVariant& argument) { open(id, argument); });
  connect(&context_, &ShellContext::noticed, toast_, &Toast::say);
  connect(&context_, &ShellContext::problemMet, problem_, &ProblemPanel::tell);
  connect(&context_, &ShellContext::themeChanged, this, &Desk::applyColours);
  connect(&context_, &ShellContext::jobStarted, this, [this](const QString& title) {
    centre_->hide();  // its place is needed
    job_->begin(title);
  });
  connect(&context_, &ShellContext::jobMoved, job_, &JobPanel::move);
  connect(&context_, &ShellContext::jobEnded, this, [this] {
    if (!context_.working()) {
      job_->end();
      centre_->show();
    }
  });
  connect(job_, &JobPanel::cancelled, this, [this] { context_.cancelJobs(); });
}

Page* Desk::pageFor(PageId id) {
  if (const auto found = made_.find(id); found != made_.end()) {
    return found->second;
  }
  Page* page = entries_.at(id).make(context_);
  page->setObjectName(pageText(id));
  page->retranslate();
  page->applyTheme(theme(context_.themeKind()));
  stack_->addWidget(page);
  made_.emplace(id, page);
  return page;
}

bool Desk::open(PageId id, const QVariant& argument) {
  if (!entries_.contains(id)) {
    context_.notify(tr("You do not have access to this page"));
    return false;
  }
  if (id != currentId_ && current_ != nullptr) {
    if (busy()) {
      context_.notify(tr("A run is in progress. Finish or stop it first"));
      return false;
    }
    if (!current_->leave()) {
      return false;
    }
  }
  if (factsOf(id).needsDatabase && context_.databaseAway()) {
    context_.notify(tr("The database does not answer now. This page opens as soon as it does"));
    return false;
  }
  attempt(context_, [&] {
    Page* page = pageFor(id);
    current_ = page;
    currentId_ = id;
    stack_->setCurrentWidget(page);
    title_->setText(pageTitle(id));
    rail_->setCurrent(id);
    problem_->hide();
    page->enter(argument);
    // Not repeated for a page with its own title.
    const auto labels = page->findChildren<QLabel*>();
    title_->setHidden(std::any_of(labels.begin(), labels.end(), [page](const QLabel* label) {
      return label->property("heading").toBool() && label->isVisibleTo(page);
    }));
    focusInto(*page);
    readWaiting();
  });
  return currentId_ == id;
}

void Desk::openHome(const QString& lastPage) {
  const auto last =
      std::find_if(order_.begin(), order_.end(), [&lastPage](PageId id) { return pageText(id) == lastPage; });
  const bool administrator = homeOf(context_.session().actor()) == Home::kAdministrator;
  if (administrator && last != order_.end() && open(*last)) {
    return;
  }
  if (!home_ || open(*home_)) {
    return;
  }
  // The database failed at this very moment: rather a page without database than none.
  for (const PageId id : order_) {
    if (!factsOf(id).needsDatabase && open(id)) {
      return;
    }
  }
}

void Desk::databaseAnswered() {
  if (context_.property("toldAway").toBool()) {
    problem_->hide();
  }
  if (current_ != nullptr) {
    QEvent answered(databaseAnsweredEvent());
    QCoreApplication::sendEvent(current_, &answered);
  }
}

bool Desk::busy() const {
  return current_ != nullptr && current_->busy();
}

bool Desk::staysOpen() const {
  const auto* const waiting = dynamic_cast<const AwaitsCalls*>(current_);
  return busy() || (waiting != nullptr && waiting->callsGoOn());
}

bool Desk::mayLeave() {
  if (busy()) {
    context_.notify(tr("A run is in progress. Finish or stop it first"));
    return false;
  }
  if (context_.working()) {
    context_.notify(tr("Work is in progress. Wait for it, or cancel it"));
    return false;
  }
  return current_ == nullptr || current_->leave();
}

void Desk::setLanguage(Language language) {
  setup_.language = language;
  language_->setText(languageName(language));
  for (QAction* action : languages_->actions()) {
    action->setChecked(action->data().toInt() == static_cast<int>(language));
  }
}

void Desk::setThemeKind(ThemeKind kind) {
  context_.setThemeKind(kind);
}

void Desk::applyColours(ThemeKind kind) {
  const Theme& colours = theme(kind);
  rail_->setTheme(colours);
  problem_->setTheme(colours);
  language_->setIcon(icon(QStringLiteral("language"), colours));
  theme_->setIcon(icon(QStringLiteral("theme"), colours));
  help_->setIcon(icon(QStringLiteral("help"), colours));
  user_->setIcon(icon(QStringLiteral("user"), colours));
  signOut_->setIcon(icon(QStringLiteral("sign-out"), colours));
  for (const auto& [id, page] : made_) {
    page->applyTheme(colours);
  }
}

void Desk::retranslate() {
  const Actor& actor = context_.session().actor();
  language_->setToolTip(tr("Language"));
  language_->setAccessibleName(tr("Language"));
  theme_->setToolTip(tr("Light or dark colours"));
  theme_->setAccessibleName(theme_->toolTip());
  help_->setToolTip(tr("Keys and help (F1)"));
  help_->setAccessibleName(help_->toolTip());
  user_->setText(actor.userId.empty() ? tr("Guest") : toQString(actor.login));
  user_->setToolTip(tr("Your account"));
  user_->setAccessibleName(tr("Your account"));
  signOut_->setText(actor.userId.empty() ? tr("End") : tr("Sign out"));
  practiceSign_->setText(tr("Practice: nothing is recorded"));
  userMenu_->clear();
  if (!actor.practiceOnly && actor.passwordShownUtc_us != kNoPasswordToShow) {
    userMenu_->addAction(tr("Change password\u2026"), this, &Desk::passwordChangeWanted);
    userMenu_->addAction(tr("Second factor\u2026"), this, &Desk::secondFactorWanted);
    if (context_.may(Operation::kPractice)) {
      userMenu_->addAction(tr("PIN for practice\u2026"), this, &Desk::choosePin);
    }
    userMenu_->addAction(tr("Lock now"), QKeySequence(QStringLiteral("Ctrl+Alt+L")), this, &Desk::lockWanted);
    userMenu_->addSeparator();
  }
  if (!actor.practiceOnly && context_.may(Operation::kUserManage)) {
    userMenu_->addAction(tr("Enter as a simulated trainee"), this,
                         [this] { Q_EMIT simulatedWanted(SimulatedRole::kTrainee); });
    userMenu_->addAction(tr("Enter as a simulated physician"), this,
                         [this] { Q_EMIT simulatedWanted(SimulatedRole::kPhysician); });
  }
  if (!actor.practiceOnly && context_.may(Operation::kPersonErase)) {
    userMenu_->addAction(tr("Remove demonstration data\u2026"), this, &Desk::removeDemonstration);
    userMenu_->addSeparator();
  }
  userMenu_->addAction(tr("About Torsio"), this, &Desk::aboutWanted);
  rail_->retranslate();
  if (currentId_) {
    title_->setText(pageTitle(*currentId_));
  }
}

void Desk::choosePin() {
  bool entered = false;
  const QString pin = QInputDialog::getText(this, tr("PIN for practice"),
                                            tr("At least four digits. With it you practise at a station; "
                                               "nothing is recorded.\nLeave it empty to remove it."),
                                            QLineEdit::Password, {}, &entered);
  if (!entered) {
    return;
  }
  attempt(context_, [&] {
    setOwnPin(context_.session(), pin.toStdString());
    context_.notify(pin.isEmpty() ? tr("The PIN was removed") : tr("The PIN is now in use"));
  });
}

void Desk::removeDemonstration() {
  attempt(context_, [&] {
    const DemonstrationSize size = demonstrationSize(context_.session());
    if (size.rows == 0) {
      context_.notify(tr("There is no demonstration data"));
      return;
    }
    const QLocale locale;
    QMessageBox question(QMessageBox::Question, tr("Remove demonstration data"),
                         tr("Remove the simulated people (%1), their runs (%2) and marks (%3)?")
                             .arg(locale.toString(static_cast<qlonglong>(size.people)),
                                  locale.toString(static_cast<qlonglong>(size.trials)),
                                  locale.toString(static_cast<qlonglong>(size.marks))),
                         QMessageBox::Cancel, this);
    question.setInformativeText(tr("Your own data stay as they are. This cannot be undone."));
    const QAbstractButton* remove = question.addButton(tr("Remove"), QMessageBox::DestructiveRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    if (question.clickedButton() != remove) {
      return;
    }
    context_.run(
        this, tr("Removing the demonstration"),
        [reason = tr("Removed from the user menu").toStdString()](SessionContext& own,
                                                                  const ProgressCallback&) {
          static_cast<void>(removeDemonstrationData(own, reason));
        },
        [this] { context_.notify(tr("The demonstration data were removed")); });
  });
}

}  // namespace torsio::gui
