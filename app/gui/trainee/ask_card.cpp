// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/ask_card.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "assessment/domain/ids.h"

namespace torsio::gui {

AskCard::AskCard(ShellContext& shell, QWidget* parent)
    : Card(QString(), parent),
      shell_(shell),
      whomLabel_(new QLabel(this)),
      whom_(new QComboBox(this)),
      text_(new QLineEdit(this)),
      ask_(new QPushButton(this)),
      list_(new QVBoxLayout) {
  ask_->setObjectName(QStringLiteral("ask"));
  text_->setObjectName(QStringLiteral("question"));
  whom_->setObjectName(QStringLiteral("whom"));
  whomLabel_->setBuddy(whom_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kSpace);
  row->addWidget(whomLabel_);
  row->addWidget(whom_);
  row->addWidget(text_, 1);
  row->addWidget(ask_);
  content()->addLayout(row);
  list_->setSpacing(kSpace / 2);
  content()->addLayout(list_);
  ask_->setEnabled(false);
  connect(text_, &QLineEdit::textChanged, this,
          [this](const QString& now) { ask_->setEnabled(!now.trimmed().isEmpty()); });
  connect(ask_, &QPushButton::clicked, this, &AskCard::ask);
  connect(text_, &QLineEdit::returnPressed, this, &AskCard::ask);
  hide();
}

void AskCard::setRun(const TrialId& trialId) {
  trialId_ = trialId;
  desk_ = trialId.empty() ? QuestionDesk{} : questionDesk(shell_.session(), trialId);
  whom_->clear();
  for (const AskablePhysician& physician : desk_.physicians) {
    whom_->addItem(toQString(physician.name), toQString(physician.raterId));
    if (physician.lastAsked) {
      whom_->setCurrentIndex(whom_->count() - 1);
    }
  }
  text_->clear();
  setVisible(desk_.mayAsk || !desk_.questions.empty());
  for (QWidget* widget : std::initializer_list<QWidget*>{whomLabel_, whom_, text_, ask_}) {
    widget->setVisible(desk_.mayAsk);
  }
  fill();
}

void AskCard::setMoment(double at_s) {
  at_s_ = at_s;
  ask_->setText(tr("As&k about %1").arg(clockTenths(at_s)));
}

void AskCard::ask() {
  if (!desk_.mayAsk || text_->text().trimmed().isEmpty()) {
    return;
  }
  attempt(shell_, [&] {
    const double at_s = at_s_;
    const QString name = whom_->currentText();
    askPhysician(shell_.session(), trialId_, at_s, whom_->currentData().toString().toStdString(),
                 text_->text().trimmed().toStdString());
    setRun(trialId_);
    shell_.notify(tr("Sent to %1: %2").arg(name, clockTenths(at_s)));
    Q_EMIT asked(at_s);
  });
}

void AskCard::addQuestion(const OwnQuestion& question) {
  auto* head = plainLabel(this, "quiet");
  const QString moment = clockTenths(question.at_s);
  const QString physician = toQString(question.physician);
  head->setText(question.answered
                    ? (question.answerEditedUtc_us != 0 ? tr("%1  \u00b7  %2 answered on %3, edited since")
                                                        : tr("%1  \u00b7  %2 answered on %3"))
                          .arg(moment, physician, shownTime(question.answeredUtc_us))
                    : tr("%1  \u00b7  with %2, waiting for %3")
                          .arg(moment, physician,
                               StationLabels::waited(shell_.session().now_us() - question.askedUtc_us)));
  list_->addWidget(head);
  if (!question.text.empty()) {
    auto* text = plainLabel(this, "quiet");
    text->setText(tr("You: %1").arg(toQString(question.text)));
    list_->addWidget(text);
  }
  if (!question.answered) {
    return;
  }
  auto* answer = plainLabel(this);
  answer->setText(toQString(question.answer));
  list_->addWidget(answer);
}

void AskCard::fill() {
  emptyLayout(list_);
  for (const OwnQuestion& question : desk_.questions) {
    addQuestion(question);
  }
}

void AskCard::retranslate() {
  setTitle(tr("Ask a physician about this moment"));
  whomLabel_->setText(tr("T&o"));
  whom_->setAccessibleName(tr("Physician"));
  text_->setPlaceholderText(tr("What do you want to know?"));
  text_->setAccessibleName(tr("Question"));
  setMoment(at_s_);
  fill();
}

}  // namespace torsio::gui
