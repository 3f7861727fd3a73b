// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/study/call_bar.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/study/day_plan_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/study/day_board.h"
#include "assessment/domain/ids.h"

namespace torsio::gui {

namespace {

constexpr int kCodeWidth = 140;
constexpr int kRoomWidth = 160;
constexpr std::size_t kLinesSeen = 4;  // before they scroll
const QString kRoomKey = QStringLiteral("today/room");

}  // namespace

CallBar::CallBar(ShellContext& shell, QWidget* parent)
    : QWidget(parent),
      shell_(shell),
      code_(named(new QLineEdit(this), "callCode")),
      occasion_(named(new QComboBox(this), "callOccasion")),
      room_(named(new QLineEdit(this), "callRoom")),
      call_(named(primaryButton(this), "call")),
      refused_(named(sentence(this, false), "callRefused")),
      lines_(nullptr),
      scroll_(named(new QScrollArea(this), "calls")),
      more_(named(linkButton(this), "allCalls")) {
  code_->setFixedWidth(kCodeWidth);
  room_->setFixedWidth(kRoomWidth);
  room_->setText(QSettings().value(kRoomKey).toString());
  occasion_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  QVBoxLayout* column = columnOf(this, {});
  QHBoxLayout* row = rowOf();
  codeLabel_ = addField(row, code_);
  roomLabel_ = addField(row, room_);
  occasionLabel_ = addField(row, occasion_);
  row->addWidget(call_);
  row->addWidget(refused_, 1);  // beside the button, so that nothing moves under the pointer
  setLook(refused_, "caution", true);
  column->addLayout(row);
  auto* ground = new QWidget;
  lines_ = new QGridLayout(ground);
  lines_->setContentsMargins(0, 0, 0, 0);
  lines_->setVerticalSpacing(kSpace);
  lines_->setColumnStretch(0, 1);
  scroll_->setWidget(ground);
  scroll_->setWidgetResizable(true);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  QHBoxLayout* calls = rowOf();
  calls->addWidget(scroll_, 1);
  calls->addWidget(more_, 0, Qt::AlignTop);
  column->addLayout(calls);
  connect(more_, &QPushButton::clicked, this, [this] {
    open_ = !open_;
    fold();
  });
  fold();
  connect(code_, &QLineEdit::returnPressed, this, &CallBar::callTyped);
  connect(call_, &QPushButton::clicked, this, &CallBar::callTyped);
  connect(room_, &QLineEdit::editingFinished, this,
          [this] { QSettings().setValue(kRoomKey, room_->text().trimmed()); });
}

void CallBar::setCohort(const CohortId& cohortId, const Occasions& occasions) {
  const QString before = occasion_->currentData().toString();
  cohortId_ = cohortId;
  occasion_->clear();
  occasion_->addItem(tr("what is due"), QString());
  for (const Occasion& occasion : occasions) {
    occasion_->addItem(occasionName(occasion), toQString(occasion.code));
  }
  occasion_->setCurrentIndex(std::max(0, occasion_->findData(before)));
  setEnabled(!cohortId_.empty());
}

void CallBar::callTyped() {
  const std::string typed = code_->text().trimmed().toStdString();
  if (typed.empty()) {
    code_->setFocus();
    return;
  }
  refused_->clear();
  attempt(shell_, [&] { orSayWhyNot([&] { call(enrolmentWithCode(shell_.session(), cohortId_, typed)); }); });
  code_->selectAll();
  code_->setFocus();
}

/// Shows here why a call was refused, and leaves other errors to the caller.
void CallBar::orSayWhyNot(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kBadData) {
      throw;
    }
    refused_->setText(
        tr("%1. %2").arg(capitalised(toQString(error.happenedText())), toQString(error.remedyText())));
  }
}

void CallBar::call(const EnrolmentId& enrolmentId) {
  CallRequest request{.cohortId = cohortId_,
                      .enrolmentId = enrolmentId,
                      .occasionCode = occasion_->currentData().toString().toStdString(),
                      .room = room_->text().trimmed().toStdString()};
  refused_->clear();
  const auto act = [&] {
    if (request.room.empty()) {
      room_->setFocus();
      shell_.notify(tr("Enter the room of the real arm."));
      return;
    }
    const CallCheck check = checkCall(shell_.session(), request);
    if (check.objection) {
      const std::optional<std::string> reason =
          askReason(this, tr("Call anyway"),
                    tr("%1, and \"%2\" is to be scored. Why now? It is noted as a deviation.")
                        .arg(toQString(*check.objection), occasionName(check.occasion)));
      if (!reason) {
        return;
      }
      request.reason = *reason;
    }
    callTrainee(shell_.session(), request);
    code_->clear();
    Q_EMIT changed();
  };
  attempt(shell_, [&] { orSayWhyNot(act); });
}

QString CallBar::lineText(const CalledCase& called, const QString& codes) const {
  const QString who = tr("case %1 \u00B7 %2 \u00B7 %3 \u00B7 %4")
                          .arg(toQString(called.caseLabel), toQString(called.traineeCode),
                               occasionName(called.occasion), toQString(Text(called.call.room)));
  QString text = (called.call.endedUtc_us ? tr("! Late: %1") : tr("\u25CF Called: %1")).arg(who);
  text +=
      tr(": ") + tr("%1 of %n sheet(s) in", nullptr, static_cast<int>(called.asked)).arg(called.submitted);
  if (const Text missing = missingText(called, codes.toStdString()); !missing.empty()) {
    text += tr("; ") + toQString(missing);
  }
  return text;
}

void CallBar::copyReminder(const CalledCase& called) {
  attempt(shell_, [&] {
    QGuiApplication::clipboard()->setText(toQString(reminderText(called)));
    noteCopiedReminder(shell_.session(), cohortId_, called);
    shell_.notify(tr("Copied: paste it into a message to these raters."));
  });
}

void CallBar::addLine(int row, const CalledCase& called) {
  QLabel* text = named(sentence(this, false), "calledCase");
  text->setText(lineText(called, firstFew(listOf(called.missing))));
  text->setToolTip(lineText(called, toQString(missingCodes(called))));
  setLook(text, "caution", called.call.endedUtc_us.has_value());
  auto* copy = new QPushButton(tr("Copy reminder"), this);
  copy->setVisible(!called.missing.empty());
  connect(copy, &QPushButton::clicked, this, [this, called] { copyReminder(called); });
  auto* wrong = new QPushButton(tr("Wrong person\u2026"), this);
  auto* end = named(new QPushButton(tr("End call"), this), "endCall");
  const LiveCallId id = called.call.id;
  connect(end, &QPushButton::clicked, this, [this, id] {
    attempt(shell_, [&] { endCall(shell_.session(), cohortId_, id); });
    Q_EMIT changed();
  });
  connect(wrong, &QPushButton::clicked, this, [this, id, code = called.traineeCode] {
    const std::optional<std::string> reason =
        askReason(this, tr("Withdraw the call"),
                  tr("Somebody other than %1 was at the arm: the sheets are closed again; what was typed is "
                     "kept for the next call.")
                      .arg(toQString(code)));
    if (!reason) {
      return;
    }
    attempt(shell_, [&] { cancelCall(shell_.session(), cohortId_, id, *reason); });
    Q_EMIT changed();
  });
  const bool open = !called.call.endedUtc_us;
  wrong->setVisible(open);
  wrong->setEnabled(called.mayCancel);
  wrong->setToolTip(called.mayCancel
                        ? QString()
                        : tr("A sheet is in: if it was the wrong person, end the call and report "
                             "a deviation."));
  end->setVisible(open);
  int column = 0;
  for (QWidget* part : {static_cast<QWidget*>(text), static_cast<QWidget*>(copy),
                        static_cast<QWidget*>(wrong), static_cast<QWidget*>(end)}) {
    lines_->addWidget(part, row, column++);
    shown_.push_back(part);
  }
}

void CallBar::showCalls(const std::vector<CalledCase>& calls) {
  QStringList lines;
  for (const CalledCase& called : calls) {
    lines << toQString(called.call.id) + lineText(called, toQString(missingCodes(called)));
  }
  if (lines == lineTexts_) {
    return;  // buttons are not rebuilt under a finger
  }
  calls_ = calls;
  lineTexts_ = lines;
  refused_->clear();
  for (QWidget* part : shown_) {
    part->hide();
    part->deleteLater();
  }
  shown_.clear();
  for (std::size_t i = 0; i < calls.size(); ++i) {
    addLine(static_cast<int>(i), calls[i]);
  }
  fold();
}

void CallBar::fold() {
  const std::size_t seen = std::clamp<std::size_t>(open_ ? calls_.size() : 1, 1, kLinesSeen);
  scroll_->setFixedHeight(static_cast<int>(seen) * (call_->sizeHint().height() + kSpace));
  scroll_->setVerticalScrollBarPolicy(open_ ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
  scroll_->verticalScrollBar()->setValue(0);
  scroll_->setVisible(!calls_.empty());
  more_->setVisible(calls_.size() > 1);
  const auto late = std::count_if(calls_.begin(), calls_.end(), [](const CalledCase& called) {
    return called.call.endedUtc_us.has_value();
  });
  more_->setText(open_ ? tr("Show one") : tr("Show all (%1, late: %2)").arg(calls_.size()).arg(late));
}

void CallBar::retranslate() {
  nameField(codeLabel_, tr("Call to the real &arm"));
  nameField(roomLabel_, tr("R&oom"));
  nameField(occasionLabel_, tr("&for"));
  code_->setPlaceholderText(tr("code or scan"));
  call_->setText(tr("Call"));
  if (occasion_->count() > 0) {
    occasion_->setItemText(0, tr("what is due"));
  }
  lineTexts_.clear();  // includes the buttons' texts
  showCalls(std::vector<CalledCase>(calls_));
}

namespace {

constexpr qsizetype kAlertsSeen = 4;  // before the list scrolls

struct AlertWords {
  Q_DECLARE_TR_FUNCTIONS(AlertPanel)
};

/// Returns the number of alerts of a kind, in words; kinds in order of urgency.
QString countText(DayAlert::Kind kind, std::size_t count) {
  using Kind = DayAlert::Kind;
  switch (kind) {
    case Kind::kTrialOpen:
      return AlertWords::tr("recordings cut off: %1").arg(count);
    case Kind::kStationSilent:
      return AlertWords::tr("stations that do not answer: %1").arg(count);
    case Kind::kDeviceUnfit:
      return AlertWords::tr("devices not fit: %1").arg(count);
    case Kind::kServoUneven:
      return AlertWords::tr("uneven runs: %1").arg(count);
    case Kind::kSlotOverdue:
      return AlertWords::tr("overdue: %1").arg(count);
    case Kind::kRestTooLong:
      return AlertWords::tr("rests too long: %1").arg(count);
    case Kind::kSheetsMissing:
      return AlertWords::tr("sheets due and missing: %1").arg(count);
    case Kind::kNoGroup:
      return AlertWords::tr("without a group: %1").arg(count);
  }
  return {};
}

}  // namespace

AlertPanel::AlertPanel(QWidget* parent)
    : QWidget(parent), line_(new FoldLine(this)), scroll_(new QScrollArea(this)), lines_(new QLabel) {
  setObjectName(QStringLiteral("alertPanel"));
  line_->label()->setObjectName(QStringLiteral("alertCounts"));
  lines_->setObjectName(QStringLiteral("alerts"));
  lines_->setTextFormat(Qt::PlainText);
  lines_->setWordWrap(true);
  lines_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  setLook(line_->label(), "caution", true);
  setLook(lines_, "caution", true);
  scroll_->setWidget(lines_);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  QVBoxLayout* column = columnOf(this, {}, kSpace);
  column->addWidget(line_);
  column->addWidget(scroll_);
  connect(line_, &FoldLine::toggled, scroll_, &QWidget::setVisible);
  hide();
}

QString AlertPanel::textOf(const DayAlert& alert) const {
  const QString since = alert.kind == DayAlert::Kind::kSlotOverdue ? slotTime(alert.sinceUtc_us, locale())
                                                                   : shownTime(alert.sinceUtc_us, locale());
  return toQString(alertText(alert, since.toStdString(), Text(occasionName(alert.occasion).toStdString())));
}

void AlertPanel::showAlerts(const std::vector<DayAlert>& alerts) {
  QStringList lines;
  std::vector<std::pair<DayAlert::Kind, std::size_t>> kinds;
  for (const DayAlert& alert : alerts) {
    lines << QStringLiteral("\u26A0 ") + textOf(alert);
    auto known =
        std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.first == alert.kind; });
    if (known == kinds.end()) {
      known = kinds.insert(kinds.end(), {alert.kind, 0});
    }
    known->second += std::max<std::size_t>(alert.count, 1);
  }
  QStringList counts;
  for (const auto& [kind, count] : kinds) {
    counts << countText(kind, count);
  }
  line_->setText(lines.size() == 1 ? lines.front()
                                   : QStringLiteral("\u26A0 ") + counts.join(QStringLiteral(" \u00B7 ")));
  line_->setFoldable(lines.size() > 1);
  scroll_->setVisible(line_->isOpen() && lines.size() > 1);
  if (const QString text = lines.join(QLatin1Char('\n')); text != lines_->text()) {
    lines_->setText(text);  // keeps the scroll position while nothing changes
  }
  scroll_->setFocusPolicy(lines.size() > kAlertsSeen ? Qt::StrongFocus : Qt::NoFocus);
  scroll_->setAccessibleName(AlertWords::tr("What needs attention"));
  const auto seen = static_cast<int>(std::clamp<qsizetype>(lines.size(), 1, kAlertsSeen));
  scroll_->setFixedHeight(seen * lines_->fontMetrics().lineSpacing() + kSpace);
  setVisible(!lines.isEmpty());
}

void AlertPanel::retranslate() {
  line_->retranslate();
}

}  // namespace torsio::gui
