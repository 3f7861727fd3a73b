// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/learning_records_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"

namespace torsio::gui {

namespace {

constexpr QSize kLearningSize(820, 640);

}  // namespace

LearningRecordsDialog::LearningRecordsDialog(ShellContext& shell, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      on_(new QCheckBox(tr("Send learning &records (xAPI)"), this)),
      endpoint_(new QLineEdit(this)),
      homePage_(new QLineEdit(this)),
      user_(new QLineEdit(this)),
      secret_(secretField(this)),
      key_(sentence(this)),
      state_(sentence(this, false)),
      dead_(new DataTable(QStringLiteral("deadLetters"), this)),
      send_(new QPushButton(tr("Send &now"), this)),
      retry_(new QPushButton(tr("&Try all again"), this)),
      drop_(new QPushButton(tr("&Give up the refused"), this)) {
  setObjectName(QStringLiteral("learningRecords"));
  setWindowTitle(tr("Learning records"));
  resize(kLearningSize);
  on_->setObjectName(QStringLiteral("lrsOn"));
  endpoint_->setObjectName(QStringLiteral("lrsEndpoint"));
  homePage_->setObjectName(QStringLiteral("lrsHomePage"));
  user_->setObjectName(QStringLiteral("lrsUser"));
  secret_->setObjectName(QStringLiteral("lrsSecret"));
  key_->setObjectName(QStringLiteral("lrsKeyText"));
  state_->setObjectName(QStringLiteral("lrsState"));
  dead_->setObjectName(QStringLiteral("deadLetters"));
  send_->setObjectName(QStringLiteral("lrsSend"));
  retry_->setObjectName(QStringLiteral("lrsRetry"));
  drop_->setObjectName(QStringLiteral("lrsDrop"));
  build();
  read();
}

void LearningRecordsDialog::build() {
  QLabel* words = sentence(this, false);
  words->setText(tr(
      "The learning system of the centre hears of enrolments, runs, passes and failures, rests and remarks "
      "that were read, under opaque accounts, of trainees who have agreed to it. What happened before "
      "this was turned on is not told."));
  endpoint_->setPlaceholderText(QStringLiteral("https://lrs.example.org/xapi"));
  homePage_->setPlaceholderText(QStringLiteral("https://skills.example.org"));
  auto* form = new QFormLayout;
  form->addRow(tr("&Address of the learning record store"), endpoint_);
  form->addRow(tr("Home &page of the accounts"), homePage_);
  auto* keyRow = new QHBoxLayout;
  auto* set = new QPushButton(tr("Set the &key"), this);
  set->setObjectName(QStringLiteral("lrsSetKey"));
  set->setAutoDefault(false);
  user_->setPlaceholderText(tr("name"));
  secret_->setPlaceholderText(tr("secret"));
  user_->setAccessibleName(tr("Name of the key"));
  secret_->setAccessibleName(tr("Secret of the key"));
  keyRow->addWidget(user_, 1);
  keyRow->addWidget(secret_, 1);
  keyRow->addWidget(set);
  form->addRow(tr("Key of this station"), keyRow);
  auto* keepButton = new QPushButton(tr("&Save"), this);
  keepButton->setObjectName(QStringLiteral("lrsKeep"));
  keepButton->setProperty("primary", true);
  keepButton->setDefault(true);
  dead_->setColumns({{tr("What")}, {tr("When")}, {tr("Tries"), true}, {tr("What the store said")}});
  dead_->setEmptyText(tr("Nothing was refused."));
  auto* buttons = new QDialogButtonBox(this);
  for (QPushButton* button : {send_, retry_, drop_, keepButton}) {
    buttons->addButton(button, QDialogButtonBox::ActionRole);
  }
  buttons->addButton(tr("C&lose"), QDialogButtonBox::RejectRole);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(words);
  column->addWidget(on_);
  column->addLayout(form);
  column->addWidget(key_);
  column->addWidget(state_);
  column->addWidget(dead_, 1);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &LearningRecordsDialog::reject);
  connect(keepButton, &QPushButton::clicked, this, &LearningRecordsDialog::keep);
  connect(set, &QPushButton::clicked, this, &LearningRecordsDialog::keepKey);
  connect(send_, &QPushButton::clicked, this, &LearningRecordsDialog::sendNow);
  connect(retry_, &QPushButton::clicked, this, &LearningRecordsDialog::retry);
  connect(drop_, &QPushButton::clicked, this, &LearningRecordsDialog::drop);
}

void LearningRecordsDialog::read() {
  attempt(shell_, [this] {
    const LearningRecordsView view = learningRecords(shell_.session());
    on_->setChecked(view.settings.on);
    endpoint_->setText(toQString(view.settings.endpoint));
    homePage_->setText(toQString(view.settings.homePage));
    showView(view);
  });
}

void LearningRecordsDialog::showView(const LearningRecordsView& view) {
  key_->setText(view.hasKey
                    ? tr("This station has a key and sends. The key lies in a file of this account, never in "
                         "the record.")
                    : tr("This station has no key and sends nothing. One station with a key is enough."));
  QString state = tr("Waiting: %1, delivered: %2, refused for good: %3")
                      .arg(view.counts.waiting)
                      .arg(view.counts.delivered)
                      .arg(view.counts.dead);
  if (!view.trouble.empty()) {
    state += QLatin1Char('\n') + tr("! What waits was not taken: %1").arg(toQString(view.trouble));
  }
  state_->setText(state);
  setLook(state_, "caution", !view.trouble.empty() || view.counts.dead > 0);
  std::vector<Row> rows;
  for (const auto& [event, answer] : view.dead) {
    const QString what = toQString(labelOf(event.kind));
    rows.push_back({QString::number(rows.size()),
                    {{what},
                     timeCell(event.happenedUtc_us),
                     {QString::number(event.tries), static_cast<qlonglong>(event.tries)},
                     {toQString(answer)}}});
  }
  dead_->setRows(std::move(rows));
  send_->setEnabled(view.settings.on && view.hasKey && view.counts.waiting > 0);
  retry_->setEnabled(view.counts.waiting + view.counts.dead > 0);
  drop_->setEnabled(view.counts.dead > 0);
}

void LearningRecordsDialog::keep() {
  attempt(shell_, [this] {
    setLrsSettings(shell_.session(), {.on = on_->isChecked(),
                                      .endpoint = endpoint_->text().trimmed().toStdString(),
                                      .homePage = homePage_->text().trimmed().toStdString()});
    shell_.notify(on_->isChecked() ? tr("Saved. Events are sent from now on") : tr("Saved. Nothing is sent"));
    showView(learningRecords(shell_.session()));
  });
}

void LearningRecordsDialog::keepKey() {
  attempt(shell_, [this] {
    setStationLrsKey({user_->text().trimmed().toStdString(), secret_->text().toStdString()});
    user_->clear();
    secret_->clear();
    showView(learningRecords(shell_.session()));
  });
}

void LearningRecordsDialog::sendNow() {
  shell_.run(
      this, tr("Sending learning records"),
      [](SessionContext& session, const ProgressCallback&) { (void)sendLearningRecords(session); },
      [this] { read(); });
}

void LearningRecordsDialog::retry() {
  attempt(shell_, [this] {
    (void)retryLearningRecords(shell_.session());
    showView(learningRecords(shell_.session()));
  });
}

void LearningRecordsDialog::drop() {
  attempt(shell_, [this] {
    (void)dropLearningRecords(shell_.session());
    showView(learningRecords(shell_.session()));
  });
}

}  // namespace torsio::gui
