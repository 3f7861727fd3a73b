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
      on_(named(new QCheckBox(tr("Send learning &records (xAPI)"), this), "lrsOn")),
      endpoint_(named(new QLineEdit(this), "lrsEndpoint")),
      homePage_(named(new QLineEdit(this), "lrsHomePage")),
      user_(named(new QLineEdit(this), "lrsUser")),
      secret_(named(secretField(this), "lrsSecret")),
      key_(named(sentence(this), "lrsKeyText")),
      state_(named(sentence(this, false), "lrsState")),
      dead_(named(new DataTable(QStringLiteral("deadLetters"), this), "deadLetters")),
      send_(named(new QPushButton(tr("Send &now"), this), "lrsSend")),
      retry_(named(new QPushButton(tr("&Try all again"), this), "lrsRetry")),
      drop_(named(new QPushButton(tr("&Give up the refused"), this), "lrsDrop")) {
  setObjectName(QStringLiteral("learningRecords"));
  setWindowTitle(tr("Learning records"));
  resize(kLearningSize);
  build();
  read();
}

void LearningRecordsDialog::build() {
  QLabel* words = sentence(this, false);
  words->setText(
      tr("Enrolments, runs, passes and failures, rests and read remarks are sent to the centre's learning "
         "system, under opaque accounts, for trainees who agreed. Earlier events are not sent."));
  endpoint_->setPlaceholderText(QStringLiteral("https://lrs.example.org/xapi"));
  homePage_->setPlaceholderText(QStringLiteral("https://skills.example.org"));
  auto* form = new QFormLayout;
  form->addRow(tr("&Address of the learning record store"), endpoint_);
  form->addRow(tr("Home &page of the accounts"), homePage_);
  auto* keyRow = new QHBoxLayout;
  auto* set = named(new QPushButton(tr("Set the &key"), this), "lrsSetKey");
  set->setAutoDefault(false);
  user_->setPlaceholderText(tr("name"));
  secret_->setPlaceholderText(tr("secret"));
  user_->setAccessibleName(tr("Name of the key"));
  secret_->setAccessibleName(tr("Secret of the key"));
  keyRow->addWidget(user_, 1);
  keyRow->addWidget(secret_, 1);
  keyRow->addWidget(set);
  form->addRow(tr("Key of this station"), keyRow);
  auto* keepButton = named(new QPushButton(tr("&Save"), this), "lrsKeep");
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
  key_->setText(
      view.hasKey
          ? tr("This station has a key and sends. The key is in a file of this account, never in the record.")
          : tr("This station has no key and sends nothing. One station with a key is enough."));
  QString state = tr("Waiting: %1, delivered: %2, refused for good: %3")
                      .arg(view.counts.waiting)
                      .arg(view.counts.delivered)
                      .arg(view.counts.dead);
  if (!view.trouble.empty()) {
    state +=
        QLatin1Char('\n') + tr("! The learning system refused the entries: %1").arg(toQString(view.trouble));
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
