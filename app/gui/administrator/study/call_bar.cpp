// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/call_bar.h"

#include <algorithm>
#include <utility>

#include <QClipboard>
#include <QComboBox>
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
#include "app/gui/administrator/base/study_labels.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/study/open_sheets.h"
#include "assessment/domain/ids.h"

namespace torsio::gui {

namespace {

constexpr int kCodeWidth = 140;
constexpr int kRoomWidth = 160;
constexpr std::size_t kLinesSeen = 4;  // before they scroll
const QString kRoomKey = QStringLiteral("today/room");

QString joined(const std::vector<std::string>& codes) {
  return listOf(codes).join(QStringLiteral(", "));
}

}  // namespace

CallBar::CallBar(ShellContext& shell, QWidget* parent)
    : QWidget(parent),
      shell_(shell),
      codeLabel_(nullptr),
      code_(new QLineEdit(this)),
      occasionLabel_(nullptr),
      occasion_(new QComboBox(this)),
      roomLabel_(nullptr),
      room_(new QLineEdit(this)),
      call_(primaryButton(this)),
      lines_(nullptr),
      scroll_(new QScrollArea(this)),
      more_(linkButton(this)) {
  code_->setObjectName(QStringLiteral("callCode"));
  room_->setObjectName(QStringLiteral("callRoom"));
  call_->setObjectName(QStringLiteral("call"));
  occasion_->setObjectName(QStringLiteral("callOccasion"));
  code_->setFixedWidth(kCodeWidth);
  room_->setFixedWidth(kRoomWidth);
  room_->setText(QSettings().value(kRoomKey).toString());
  occasion_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  row->setSpacing(kSpace);
  codeLabel_ = addField(row, code_);
  roomLabel_ = addField(row, room_);
  occasionLabel_ = addField(row, occasion_);
  row->addWidget(call_);
  row->addStretch(1);
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
  scroll_->setObjectName(QStringLiteral("calls"));
  more_->setObjectName(QStringLiteral("allCalls"));
  auto* calls = new QHBoxLayout;
  calls->setSpacing(kSpace);
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
  attempt(shell_, [&] { call(enrolmentWithCode(shell_.session(), cohortId_, typed)); });
  code_->selectAll();
  code_->setFocus();
}

void CallBar::call(const EnrolmentId& enrolmentId) {
  CallRequest request{.cohortId = cohortId_,
                      .enrolmentId = enrolmentId,
                      .occasionCode = occasion_->currentData().toString().toStdString(),
                      .room = room_->text().trimmed().toStdString()};
  attempt(shell_, [&] {
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
  });
}

QString CallBar::lineText(const CalledCase& called, const QString& missing) const {
  const QString who = tr("case %1 \u00B7 %2 \u00B7 %3 \u00B7 %4")
                          .arg(toQString(called.caseLabel), toQString(called.traineeCode),
                               occasionName(called.occasion), toQString(Text(called.call.room)));
  QString text = (called.call.endedUtc_us ? tr("! Late: %1") : tr("\u25CF Called: %1")).arg(who);
  text +=
      tr(": ") + tr("%1 of %n sheet(s) in", nullptr, static_cast<int>(called.asked)).arg(called.submitted);
  if (!missing.isEmpty()) {
    text += tr("; ") + tr("missing: %1").arg(missing);
  }
  return text;
}

void CallBar::copyReminder(const CalledCase& called) {
  attempt(shell_, [&] {
    std::vector<Reminder> reminded;
    for (Reminder& one : reminders(shell_.session(), cohortId_)) {
      std::erase_if(one.sheets, [&](const SheetAwaited& sheet) {
        return !sheet.live || sheet.caseLabel != called.caseLabel;
      });
      if (!one.sheets.empty()) {
        reminded.push_back(std::move(one));
      }
    }
    QGuiApplication::clipboard()->setText(tr("Please submit your sheet of case %1 in Torsio (Live sheet): %2")
                                              .arg(toQString(called.caseLabel), joined(called.missing)));
    noteReminders(shell_.session(), reminded, ReminderWay::kCopied);
    shell_.notify(tr("Copied: paste it into a message to these raters."));
  });
}

void CallBar::addLine(int row, const CalledCase& called) {
  QLabel* text = sentence(this, false);
  text->setText(lineText(called, firstFew(listOf(called.missing))));
  text->setToolTip(lineText(called, joined(called.missing)));
  text->setObjectName(QStringLiteral("calledCase"));
  setLook(text, "caution", called.call.endedUtc_us.has_value());
  auto* copy = new QPushButton(tr("Copy reminder"), this);
  copy->setVisible(!called.missing.empty());
  connect(copy, &QPushButton::clicked, this, [this, called] { copyReminder(called); });
  auto* wrong = new QPushButton(tr("Wrong person\u2026"), this);
  auto* end = new QPushButton(tr("End call"), this);
  end->setObjectName(QStringLiteral("endCall"));
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
    lines << toQString(called.call.id) + lineText(called, joined(called.missing));
  }
  if (lines == lineTexts_) {
    return;  // buttons are not rebuilt under a finger
  }
  calls_ = calls;
  lineTexts_ = lines;
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

}  // namespace torsio::gui
