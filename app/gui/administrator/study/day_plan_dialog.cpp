// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/day_plan_dialog.h"

#include <map>
#include <utility>

#include <QAction>
#include <QDateEdit>
#include <QDateTime>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QTimeEdit>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/printed_sheets.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/study/day_plan.h"
#include "sim/core/time_units.h"

namespace torsio::gui {

namespace {

constexpr int kDefaultSlot_min = 60;
constexpr int kLongestSlot_min = 600;
constexpr int kLongestPause_min = 240;
constexpr int kFirstHour = 9;
constexpr int kStep_min = 15;  // slots begin at quarters of an hour

std::int64_t utcOf(const QDateTime& time) {
  return time.toMSecsSinceEpoch() * 1000;
}

QDateTime timeOf(std::int64_t utc_us) {
  return QDateTime::fromMSecsSinceEpoch(utc_us / 1000);
}

/// Returns the default start of the first slot: in the morning, or today at the next quarter of an hour if
/// there is one.
QTime defaultFirstSlot(QDate day, const QDateTime& now) {
  const QTime morning(kFirstHour, 0);
  if (day != now.date() || now.time() <= morning) {
    return morning;
  }
  const int minutes = now.time().hour() * 60 + now.time().minute();
  const QTime next = QTime(0, 0).addSecs(60 * (minutes / kStep_min + 1) * kStep_min);
  return next > now.time() ? next : morning;
}

}  // namespace

QString slotTime(std::int64_t utc_us, const QLocale& locale) {
  const QDateTime time = timeOf(utc_us);
  const QString hour = locale.toString(time.time(), QLocale::ShortFormat);
  return time.date() == QDate::currentDate()
             ? hour
             : QStringLiteral("%1 %2").arg(dateText(time.date(), locale), hour);
}

DayPlanDialog::DayPlanDialog(ShellContext& shell, const CohortId& cohortId, Trainees trainees,
                             const QStringList& places, const QStringList& others, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      cohortId_(cohortId),
      trainees_(std::move(trainees)),
      day_(named(new QDateEdit(timeOf(shell.session().now_us()).date(), this), "planDate")),
      first_(named(new QTimeEdit(defaultFirstSlot(day_->date(), timeOf(shell.session().now_us())), this),
                   "planFirst")),
      minutes_(ranged(named(new QSpinBox(this), "planMinutes"), 1, kLongestSlot_min)),
      pause_(ranged(named(new QSpinBox(this), "planPause"), 0, kLongestPause_min)),
      places_(named(new QLineEdit(this), "planPlaces")),
      more_(named(new QPushButton(this), "planMore")),
      offered_(new QMenu(more_)),
      outlook_(named(sentence(this, false), "planOutlook")),
      plan_(named(new QPushButton(this), "planAdd")),
      table_(named(new DataTable(QStringLiteral("day-plan"), this), "planSlots")),
      remove_(named(listButton(table_), "planRemove")),
      print_(named(listButton(table_), "planPrint")) {
  build(places, others);
  read();
}

void DayPlanDialog::build(const QStringList& places, const QStringList& others) {
  setObjectName(QStringLiteral("dayPlan"));
  setWindowTitle(tr("Plan of the day"));
  resize(820, 620);
  day_->setCalendarPopup(true);
  minutes_->setValue(kDefaultSlot_min);
  minutes_->setSuffix(tr(" min"));
  pause_->setSuffix(tr(" min"));
  plan_->setText(tr("&Add %n trainee(s) to the plan", nullptr, static_cast<int>(trainees_.size())));
  remove_->setText(tr("&Remove"));
  print_->setText(tr("&Print\u2026"));
  auto* words = sentence(this);
  words->setText(
      tr("Trainees come in the order of the board, as many at a time as there are places. Swapping turns on "
         "the board swaps slots, too; people who have not begun five minutes after the start are shown as "
         "overdue."));
  auto* form = new QFormLayout;
  form->addRow(tr("&Day"), day_);
  form->addRow(tr("&First slot begins at"), first_);
  form->addRow(tr("&Each takes"), minutes_);
  form->addRow(tr("Pa&use between two"), pause_);
  auto* placesLabel = new QLabel(tr("Stations and roo&ms, with commas"), this);
  placesLabel->setBuddy(places_);
  form->addRow(placesLabel, placesRow(places, others));
  auto* row = new QHBoxLayout;
  row->addWidget(outlook_, 1);
  row->addWidget(plan_);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(words);
  column->addLayout(form);
  column->addLayout(row);
  column->addWidget(table_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  table_->setColumns({{tr("From")}, {tr("Until")}, {tr("Place")}, {tr("Trainee")}});
  table_->setEmptyText(tr("Nobody is planned for this day yet."));
  connect(buttons, &QDialogButtonBox::rejected, this, &DayPlanDialog::reject);
  suggested_ = first_->time();
  showAsDate(day_);
  connect(day_, &QDateEdit::dateChanged, this, &DayPlanDialog::read);
  connect(day_, &QDateEdit::dateChanged, this, &DayPlanDialog::suggestFirst);
  connect(day_, &QDateEdit::dateChanged, this, &DayPlanDialog::showOutlook);
  connect(first_, &QTimeEdit::timeChanged, this, &DayPlanDialog::showOutlook);
  connect(minutes_, &QSpinBox::valueChanged, this, &DayPlanDialog::showOutlook);
  connect(pause_, &QSpinBox::valueChanged, this, &DayPlanDialog::showOutlook);
  connect(places_, &QLineEdit::textChanged, this, &DayPlanDialog::showOutlook);
  connect(places_, &QLineEdit::textChanged, this, &DayPlanDialog::offerPlaces);
  connect(plan_, &QPushButton::clicked, this, &DayPlanDialog::plan);
  connect(remove_, &QPushButton::clicked, this, &DayPlanDialog::remove);
  connect(print_, &QPushButton::clicked, this, &DayPlanDialog::askPrint);
  connect(table_, &DataTable::currentChanged, this,
          [this](const QString& id) { remove_->setEnabled(!id.isEmpty()); });
  remove_->setEnabled(false);
  offerPlaces();
  showOutlook();
}

/// Returns the field of places with buttons for further ones.
QLayout* DayPlanDialog::placesRow(const QStringList& places, const QStringList& others) {
  places_->setText(places.join(QStringLiteral(", ")));
  places_->setPlaceholderText(tr("Station 1, Station 2, Room 3"));
  more_->setText(tr("Add a&nother"));
  more_->setMenu(offered_);
  more_->setAutoDefault(false);  // Enter in a field plans the day
  for (const QString& place : places + others) {
    QAction* action = offered_->addAction(QString(place).replace(QLatin1Char('&'), QStringLiteral("&&")));
    action->setData(place);
    connect(action, &QAction::triggered, this, [this, place] {
      places_->setText((namedPlaces() << place).join(QStringLiteral(", ")));
      places_->setFocus();
    });
  }
  auto* row = new QHBoxLayout;
  row->addWidget(places_, 1);
  row->addWidget(more_);
  return row;
}

QStringList DayPlanDialog::namedPlaces() const {
  QStringList places;
  for (const QString& place : places_->text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    if (!place.trimmed().isEmpty()) {
      places << place.trimmed();
    }
  }
  return places;
}

void DayPlanDialog::offerPlaces() {
  const QStringList named = namedPlaces();
  bool some = false;
  for (QAction* place : offered_->actions()) {
    place->setVisible(!named.contains(place->data().toString()));
    some = some || place->isVisible();
  }
  more_->setVisible(some);
}

void DayPlanDialog::suggestFirst() {
  if (first_->time() != suggested_) {
    return;  // the user has set the time
  }
  suggested_ = defaultFirstSlot(day_->date(), timeOf(shell_.session().now_us()));
  first_->setTime(suggested_);
}

void DayPlanDialog::showOutlook() {
  const auto side = static_cast<std::size_t>(namedPlaces().size());
  if (trainees_.empty() || side == 0) {
    outlook_->setText(trainees_.empty() ? QString() : tr("Name at least one place."));
    plan_->setEnabled(false);
    return;
  }
  const auto rounds = static_cast<int>((trainees_.size() + side - 1) / side);
  const QDateTime first(day_->date(), first_->time());
  const QDateTime last = first.addSecs(60LL * (rounds * minutes_->value() + (rounds - 1) * pause_->value()));
  const bool fits = last <= day_->date().addDays(1).startOfDay();
  const bool past = utcOf(first) < shell_.session().now_us();
  const QString end = locale().toString(last.time(), QLocale::ShortFormat);
  outlook_->setText(
      !fits ? tr("! That would take longer than this day: name more places, or choose fewer trainees.")
      : past
          ? tr("! The last slot ends at %1. The first slot has already begun; absent trainees are overdue.")
                .arg(end)
          : tr("The last slot ends at %1.").arg(end));
  setLook(outlook_, "caution", !fits || past);
  plan_->setEnabled(fits);
}

void DayPlanDialog::read() {
  const QDate day = day_->date();
  attempt(shell_, [&] {
    slots_ =
        daySlots(shell_.session(), cohortId_, utcOf(day.startOfDay()), utcOf(day.addDays(1).startOfDay()));
  });
  std::vector<Row> rows;
  for (const DaySlot& slot : slots_) {
    rows.push_back({toQString(slot.id),
                    {{locale().toString(timeOf(slot.startsUtc_us).time(), QLocale::ShortFormat),
                      static_cast<qlonglong>(slot.startsUtc_us)},
                     {locale().toString(timeOf(slot.endsUtc_us()).time(), QLocale::ShortFormat),
                      static_cast<qlonglong>(slot.endsUtc_us())},
                     {toQString(slot.place)},
                     {toQString(slot.traineeCode)}}});
  }
  table_->setRows(std::move(rows));
  print_->setEnabled(!slots_.empty());
}

void DayPlanDialog::plan() {
  DayPlanRequest request{.cohortId = cohortId_};
  for (const auto& [id, code] : trainees_) {
    request.enrolmentIds.push_back(id);
  }
  for (const QString& place : namedPlaces()) {
    request.places.push_back(place.toStdString());
  }
  request.firstUtc_us = utcOf(QDateTime(day_->date(), first_->time()));
  request.duration_us = minutes_->value() * kMinute_us;
  request.pause_us = pause_->value() * kMinute_us;
  attempt(shell_, [&] { (void)planDay(shell_.session(), request); });
  read();
}

void DayPlanDialog::remove() {
  std::vector<DaySlotId> ids;
  for (const QString& id : table_->selectedIds()) {
    ids.emplace_back(id.toStdString());
  }
  attempt(shell_, [&] { removeSlots(shell_.session(), cohortId_, ids); });
  read();
}

void DayPlanDialog::print(const std::filesystem::path& file) const {
  std::map<QString, QString> byPlace;
  for (const DaySlot& slot : slots_) {
    byPlace[toQString(slot.place)] +=
        QStringLiteral("<tr><td>%1 \u2013 %2</td><td><b>%3</b></td><td>____________</td></tr>")
            .arg(locale().toString(timeOf(slot.startsUtc_us).time(), QLocale::ShortFormat),
                 locale().toString(timeOf(slot.endsUtc_us()).time(), QLocale::ShortFormat),
                 toQString(slot.traineeCode).toHtmlEscaped());
  }
  const QString title = tr("Plan of %1").arg(locale().toString(day_->date(), QLocale::LongFormat));
  QString html = QStringLiteral("<h2>%1</h2>").arg(title);
  for (const auto& [place, rows] : byPlace) {
    html += QStringLiteral(
                "<h3>%1</h3><table cellpadding='6' width='100%'><tr><th align='left'>%2</th>"
                "<th align='left'>%3</th><th align='left'>%4</th></tr>%5</table>")
                .arg(place.toHtmlEscaped(), tr("Time"), tr("Trainee"), tr("Began at"), rows);
  }
  printHtml(html, title, QPageLayout::Portrait, file);
}

void DayPlanDialog::askPrint() {
  const QString file =
      askFileToSave(this, tr("Print the plan"), tr("Plan %1.pdf").arg(day_->date().toString(Qt::ISODate)),
                    tr("PDF (*.pdf)"));
  if (!file.isEmpty()) {
    attempt(shell_, [&] { print(toPath(file)); });
  }
}

}  // namespace torsio::gui
