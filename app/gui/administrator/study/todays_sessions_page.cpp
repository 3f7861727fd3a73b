// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/todays_sessions_page.h"

#include <algorithm>
#include <utility>

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/study/call_bar.h"
#include "app/gui/administrator/study/day_plan_dialog.h"
#include "app/gui/administrator/study/deviations_dialog.h"
#include "app/gui/base/background.h"
#include "app/gui/base/page.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/access/database_away.h"
#include "app/services/people/waiting_requests.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/study/station_state.h"

namespace torsio::gui {

namespace {

constexpr int kReadAgain_ms = 10'000;
constexpr int kReadCalls_ms = 2'000;   // while a trainee is at the arm
constexpr int kRoomForStations = 860;  // page height that fits the stations and enough of the board
const QString kStationsKey = QStringLiteral("today/stations");

constexpr int kStationsFrame = 74;  // height of summary, headings, borders
constexpr int kStationHeight = 32;
constexpr std::size_t kMaxStations = 4;

}  // namespace

TodaysSessionsPage::TodaysSessionsPage(ShellContext& shell)
    : Page(shell),
      clock_(new QTimer(this)),
      heading_(new PageHeading(this)),
      waiting_(named(linkButton(this), "requestsWait")),
      cohort_(named(new QComboBox(this), "cohort")),
      summary_(new QLabel(this)),
      callBar_(new CallBar(shell, this)),
      table_(named(new DataTable(QStringLiteral("run-day"), this), "table")),
      alerts_(new AlertPanel(this)),
      stationsLine_(new FoldLine(this)),
      stations_(named(new DataTable(QStringLiteral("run-day-stations"), this), "stations")),
      reader_(new Background(this)),
      plan_(named(new QPushButton(this), "planDay")),
      print_(named(new QPushButton(this), "print")),
      callList_(new QAction(this)),
      sheets_(new QAction(this)),
      typeIn_(named(new QAction(this), "typeSheets")),
      reminders_(new QAction(this)),
      call_(listButton(table_)),
      time_(listButton(table_)),
      swap_(listButton(table_)),
      deviation_(listButton(table_)),
      deviations_(listButton(table_)),
      state_(listButton(table_)) {
  heading_->addAction(plan_);
  connect(plan_, &QPushButton::clicked, this, &TodaysSessionsPage::planDay);
  auto* paper = new QMenu(print_);
  paper->addActions({callList_, sheets_, typeIn_, reminders_});
  print_->setMenu(paper);
  heading_->addAction(print_);
  connect(callList_, &QAction::triggered, this, &TodaysSessionsPage::printCallList);
  connect(sheets_, &QAction::triggered, this, &TodaysSessionsPage::printSheets);
  connect(typeIn_, &QAction::triggered, this, &TodaysSessionsPage::typeSheets);
  connect(reminders_, &QAction::triggered, this, &TodaysSessionsPage::copyReminders);
  QHBoxLayout* choices = rowOf();
  cohortLabel_ = addField(choices, cohort_);
  choices->addSpacing(2 * kSpace);
  choices->addWidget(summary_, 1);
  cohort_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addWidget(waiting_, 0, Qt::AlignLeft);
  waiting_->setProperty("caution", true);
  connect(waiting_, &QPushButton::clicked, this, [this] { this->shell().open(PageId::kUsers); });
  column->addLayout(choices);
  column->addWidget(callBar_);
  stationsLine_->label()->setObjectName(QStringLiteral("stationsLine"));
  stations_->filter().hide();
  column->addWidget(alerts_);
  column->addWidget(table_, 1);
  column->addWidget(stationsLine_);
  column->addWidget(stations_);

  clock_->setInterval(kReadAgain_ms);
  connect(clock_, &QTimer::timeout, this, &TodaysSessionsPage::refresh);
  connect(swap_, &QPushButton::clicked, this, &TodaysSessionsPage::swap);
  connect(cohort_, &QComboBox::currentIndexChanged, this, &TodaysSessionsPage::read);
  connect(callBar_, &CallBar::changed, this, &TodaysSessionsPage::read);
  connect(call_, &QPushButton::clicked, this, [this] {
    if (const DayBoardRow* row = current()) {
      callBar_->call(row->enrolmentId);
    }
  });
  connect(table_, &DataTable::currentChanged, this, &TodaysSessionsPage::showButtons);
  connect(time_, &QPushButton::clicked, this, &TodaysSessionsPage::logTime);
  connect(deviation_, &QPushButton::clicked, this, &TodaysSessionsPage::reportDeviation);
  connect(deviations_, &QPushButton::clicked, this, [this] {
    attempt(this->shell(), [this] { DeviationsDialog(this->shell(), chosenId(cohort_), this).exec(); });
    read();
  });
  connect(state_, &QPushButton::clicked, this, &TodaysSessionsPage::changeState);
  connect(stationsLine_, &FoldLine::toggled, this, [this](bool open) {
    QSettings().setValue(kStationsKey, open);
    showStations();
  });
  retranslate();
}

void TodaysSessionsPage::enter(const QVariant&) {
  stationsLine_->setOpen(QSettings().value(kStationsKey, height() >= kRoomForStations).toBool());
  attempt(shell(), [&] {
    fillCohorts(cohort_, shell().session(), CohortFirst::kOfToday);
    read();
    clock_->start();
  });
}

bool TodaysSessionsPage::leave() {
  clock_->stop();
  return true;
}

void TodaysSessionsPage::read() {
  if (shell().databaseAway()) {
    return;  // the window has shown the error
  }
  const bool good = attempt(shell(), [&] {
    const std::string cohort = chosenId(cohort_);
    board_ = cohort.empty() ? std::nullopt : std::optional(dayBoard(shell().session(), cohort));
    calls_ = cohort.empty() ? std::vector<CalledCase>{} : calledCases(shell().session(), cohort);
    callBar_->setCohort(cohort, board_ ? board_->occasions : Occasions{});
    showContent();
    showWaiting(waitingRequests(shell().session()).toConfirm);
  });
  if (!good) {
    clock_->stop();  // a single message instead of one every few seconds
  }
}

void TodaysSessionsPage::refresh() {
  if (holdsButton(*this) || reader_->working() || shell().databaseAway()) {
    return;
  }
  struct Read {
    std::vector<CohortRow> cohorts{};
    std::size_t toConfirm = 0;
    std::optional<DayBoard> board{};
    std::vector<CalledCase> calls{};
  };
  const std::string cohort = chosenId(cohort_);
  reader_->run(
      shell().session().key(),
      [cohort](SessionContext& own) {
        Read read{.cohorts = cohorts(own), .toConfirm = waitingRequests(own).toConfirm};
        if (!cohort.empty()) {
          own.beginCall();
          read.board = dayBoard(own, cohort);
          own.beginCall();
          read.calls = calledCases(own, cohort);
        }
        return read;
      },
      [this, cohort](Read read) {
        if (cohort != chosenId(cohort_) || holdsButton(*this)) {
          return;  // another cohort was chosen meanwhile, or the next refresh shows it
        }
        if (!underMouse()) {
          showWaiting(read.toConfirm);  // not while it would move something under the pointer
        }
        if (!cohort_->view()->isVisible()) {
          fillCohorts(cohort_, std::move(read.cohorts), CohortFirst::kOfToday);
        }
        if (cohort != chosenId(cohort_)) {
          return this->read();  // the first cohort has come, or the chosen one has gone
        }
        board_ = std::move(read.board);
        calls_ = std::move(read.calls);
        showContent();
      },
      [this](const std::exception_ptr& problem) {
        if (saysDatabaseAway(problem)) {
          return;  // the window shows the error; the next refresh tries again
        }
        clock_->stop();  // a single message instead of one every few seconds
        shell().report(problem);
      });
}

void TodaysSessionsPage::showWaiting(std::size_t toConfirm) {
  toConfirm_ = toConfirm;
  const QString words = toQString(toConfirmWords(toConfirm));
  waiting_->setText(words);
  waiting_->setVisible(!words.isEmpty());
}

void TodaysSessionsPage::customEvent(QEvent* event) {
  if (event->type() == databaseAnsweredEvent()) {
    clock_->start();
    read();
  }
}

QString TodaysSessionsPage::nowText(const DayBoardRow& row) const {
  if (row.state == EnrolmentState::kWithdrawn) {
    return tr("withdrew");
  }
  if (row.done) {
    return tr("all phases done");
  }
  if (row.phaseLabel.empty()) {
    return row.groupCode.empty()   ? tr("no group yet")
           : board_->hasCurriculum ? tr("no set times")
                                   : tr("no curriculum");
  }
  return toQString(row.phaseLabel);
}

Cell TodaysSessionsPage::sheetsCell(const DayBoardRow& row) const {
  const std::size_t missing = row.allSheetsMissing();
  QStringList called;
  for (const OccasionSheets& one : row.calledSheets) {
    called << tr("Called for %1, sheets missing: %2").arg(occasionName(one.occasion)).arg(one.missing);
  }
  const Text sheets = sheetsText(row);
  return {sheets.empty() ? QStringLiteral("\u2013") : toQString(sheets), static_cast<qlonglong>(missing),
          called.join(QLatin1Char('\n'))};
}

Cell TodaysSessionsPage::slotCell(const DayBoardRow& row) const {
  if (!row.slot) {
    return {QStringLiteral("\u2013"), QVariant(static_cast<qlonglong>(0))};
  }
  const QString when =
      tr("%1 \u00B7 %2").arg(slotTime(row.slot->startsUtc_us, locale()), toQString(row.slot->place));
  return {row.overdue ? tr("! %1, overdue").arg(when) : when,
          QVariant(static_cast<qlonglong>(row.slot->startsUtc_us))};
}

void TodaysSessionsPage::showContent() {
  std::vector<Row> rows;
  std::size_t running = 0;
  std::size_t done = 0;
  std::size_t sheets = 0;
  if (board_) {
    for (const DayBoardRow& row : board_->rows) {
      running += row.runningTrialId.empty() ? 0 : 1;
      done += row.done ? 1 : 0;
      sheets += row.allSheetsMissing();
      const bool open = !row.done && !row.phaseLabel.empty() && row.state != EnrolmentState::kWithdrawn;
      rows.push_back({toQString(row.enrolmentId),
                      {{toQString(row.traineeCode)},
                       {orDash(row.groupCode), {}, toQString(row.armLabel)},
                       {nowText(row)},
                       {open ? clockTime(row.progress.left_us) : QStringLiteral("\u2013"),
                        static_cast<qlonglong>(open ? row.progress.left_us : -1)},
                       {open ? clockTime(row.progress.restLeft_us) : QStringLiteral("\u2013"),
                        static_cast<qlonglong>(open ? row.progress.restLeft_us : -1)},
                       {row.runningTrialId.empty() ? QStringLiteral("\u2013")
                                                   : tr("records at %1").arg(toQString(row.station))},
                       {occasionName(row.occasionDue)},
                       sheetsCell(row),
                       {row.deviations == 0 ? QStringLiteral("\u2013") : QString::number(row.deviations),
                        static_cast<qlonglong>(row.deviations)},
                       slotCell(row)}});
    }
  }
  table_->setRows(std::move(rows));
  summary_->setToolTip(
      tr("Sheets due and missing: of the occasions that have been reached. Scoring counts those of all "
         "occasions, also of those still to come."));
  summary_->setText(board_ ? tr("%1 recording now \u00b7 %2 of %3 done \u00b7 sheets due and missing: %4")
                                 .arg(running)
                                 .arg(done)
                                 .arg(board_->rows.size())
                                 .arg(sheets)
                           : QString());
  table_->setEmptyText(cohort_->count() == 0
                           ? tr("Nothing to run yet. Go through the pages at the left in their order: Roster "
                                "(bring people in), "
                                "Curricula, Cohorts, Allocation, Scoring.")
                           : tr("Nobody is enrolled in this cohort yet. Enrol trainees under Cohorts."));
  callBar_->showCalls(calls_);
  clock_->setInterval(callsGoOn() ? kReadCalls_ms : kReadAgain_ms);
  alerts_->showAlerts(board_ ? dayAlerts(*board_) : std::vector<DayAlert>{});
  showStations();
  showButtons();
}

bool TodaysSessionsPage::callsGoOn() const {
  return std::any_of(calls_.begin(), calls_.end(),
                     [](const CalledCase& called) { return !called.call.endedUtc_us; });
}

const DayBoardRow* TodaysSessionsPage::current() const {
  if (!board_) {
    return nullptr;
  }
  const std::string id = table_->currentId().toStdString();
  const auto found = std::find_if(board_->rows.begin(), board_->rows.end(),
                                  [&](const DayBoardRow& row) { return row.enrolmentId == id; });
  return found == board_->rows.end() ? nullptr : &*found;
}

void TodaysSessionsPage::showButtons() {
  const DayBoardRow* row = current();
  call_->setEnabled(row != nullptr && row->state != EnrolmentState::kWithdrawn);
  time_->setEnabled(row != nullptr);
  swap_->setEnabled(row != nullptr && row->state != EnrolmentState::kWithdrawn && board_->rows.size() > 1);
  deviation_->setEnabled(board_.has_value());
  deviations_->setEnabled(board_.has_value());
  state_->setEnabled(row != nullptr);
  state_->setText(row != nullptr && row->state == EnrolmentState::kWithdrawn ? tr("&Back in\u2026")
                                                                             : tr("&Withdraw\u2026"));
}

void TodaysSessionsPage::retranslate() {
  plan_->setText(tr("Plan the da&y\u2026"));
  print_->setText(tr("On &paper"));
  callList_->setText(tr("Print the call list\u2026"));
  sheets_->setText(tr("Print sheets for the raters\u2026"));
  sheets_->setToolTip(tr("Of the chosen trainee; without one, of everybody whose scoring is due"));
  typeIn_->setText(tr("Type sheets in\u2026"));
  reminders_->setText(tr("Copy the outstanding sheets"));
  heading_->setTexts(
      tr("Today's sessions"),
      tr("Who is doing what, what is left, which sheets are missing, and whether the devices are fit."));
  cohortLabel_->setText(tr("&Cohort"));
  showWaiting(toConfirm_);
  callBar_->retranslate();
  call_->setText(tr("Call to the arm"));
  time_->setText(tr("&Log time\u2026"));
  swap_->setText(tr("Swap t&urns\u2026"));
  stationsLine_->retranslate();
  alerts_->retranslate();
  stations_->setColumns({{tr("Station")},
                         {tr("Now")},
                         {tr("Trainee")},
                         {tr("Phase")},
                         {tr("For"), true},
                         {tr("Last seen")},
                         {tr("Version")},
                         {tr("Device")},
                         {tr("Device check")}});
  deviation_->setText(tr("&Deviation\u2026"));
  deviations_->setText(tr("&Noted\u2026"));
  deviations_->setToolTip(tr("All deviations of this cohort"));
  table_->setColumns({{tr("Trainee")},
                      {tr("Group")},
                      {tr("Now at")},
                      {tr("Time left"), true},
                      {tr("Rest left"), true},
                      {tr("Station")},
                      {tr("Scoring due")},
                      {tr("Sheets missing"), true, true},
                      {tr("Deviations"), true, true},
                      {tr("Planned")}});
  showContent();
}

QString TodaysSessionsPage::checkText(const StationDevice& device) const {
  if (device.device.empty()) {
    return QStringLiteral("\u2013");
  }
  const QDateTime checked = QDateTime::fromMSecsSinceEpoch(device.checkedUtc_us / 1000);
  const QDateTime now = QDateTime::fromMSecsSinceEpoch(board_->asOfUtc_us / 1000);
  if (!device.light) {
    return tr("\u25CB not checked yet");
  }
  if (checked.date() != now.date()) {
    return tr("\u25CB not checked today, last on %1").arg(dateText(checked.date(), locale()));
  }
  const QString time = locale().toString(checked.time(), QLocale::ShortFormat);
  switch (*device.light) {
    case Light::kGreen:
      return tr("\u2713 fit at %1").arg(time);
    case Light::kAmber:
      return tr("! practice only at %1: %2").arg(time, toQString(device.problem));
    case Light::kRed:
      break;
  }
  return tr("\u2717 not fit at %1: %2").arg(time, toQString(device.problem));
}

void TodaysSessionsPage::showStations() {
  std::vector<Row> rows;
  int recording = 0;
  int lost = 0;
  if (board_) {
    for (const StationState& station : board_->stations) {
      const bool silent = board_->asOfUtc_us - station.heartbeatUtc_us > kStationSilence_us;
      const bool records = !station.trialId.empty() && !station.ended;
      recording += records && !silent ? 1 : 0;
      lost += silent ? 1 : 0;
      const StationDevice device = storedDevice(station);
      const QString check = checkText(device);
      rows.push_back(
          {toQString(station.station),
           {{toQString(station.station)},
            {silent    ? tr("! does not answer")
             : records ? tr("\u25CF records")
                       : tr("\u25CB free")},
            {records ? toQString(station.traineeCode) : QStringLiteral("\u2013")},
            {records && !station.phaseLabel.empty() ? toQString(Text(station.phaseLabel))
                                                    : QStringLiteral("\u2013")},
            {records ? clockTime(board_->asOfUtc_us - station.startedUtc_us) : QStringLiteral("\u2013")},
            timeCell(station.heartbeatUtc_us),
            {orDash(station.softwareVersion)},
            {device.device.empty() ? orDash({}) : toQString(device.device)},
            {check, {}, check}}});
    }
  }
  const bool some = !rows.empty();
  stationsLine_->setText(tr("Stations: %1 \u00b7 recording: %2 \u00b7 not answering: %3")
                             .arg(rows.size())
                             .arg(recording)
                             .arg(lost));
  stations_->setFixedHeight(kStationsFrame + kStationHeight * static_cast<int>(std::clamp<std::size_t>(
                                                                  rows.size(), 1, kMaxStations)));
  stations_->setRows(std::move(rows));
  stations_->setVisible(some && stationsLine_->isOpen());
  stationsLine_->setVisible(some);
}

}  // namespace torsio::gui
