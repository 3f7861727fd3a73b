// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/physician/questions_card.h"

#include <algorithm>

#include <QDialog>
#include <QDialogButtonBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/debrief_plot.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/review/case_remarks.h"
#include "assessment/domain/ids.h"

namespace torsio::gui {

namespace {

constexpr double kRound_s = 5.0;  // before and after the moment
constexpr std::size_t kShown = 3;
constexpr std::size_t kShownAnswers = 2;
constexpr std::int64_t kAnswersListed_us = 7LL * 24 * 3600 * 1'000'000;
constexpr int kAnswerHeight = 90;

}  // namespace

QuestionsCard::QuestionsCard(ShellContext& shell, QWidget* parent)
    : Card(QString(), parent), shell_(shell), list_(new QVBoxLayout) {
  list_->setSpacing(kSpace / 2);
  content()->addLayout(list_);
  hide();
}

void QuestionsCard::read() {
  questions_ = questionsToMe(shell_.session());
  answered_.clear();
  const std::int64_t since_us = shell_.session().now_us() - kAnswersListed_us;
  for (const PhysicianQuestion& question : questions_) {
    if (question.answeredUtc_us > since_us && answered_.size() < kShownAnswers) {
      answered_.push_back(question);
    }
  }
  std::erase_if(questions_, [](const PhysicianQuestion& question) { return question.answered; });
  setVisible(!questions_.empty() || !answered_.empty());
  fill();
}

void QuestionsCard::fill() {
  setTitle(questions_.size() > kShown ? tr("Trainees ask you: %1").arg(questions_.size())
           : questions_.empty()       ? tr("Your last answers to trainees")
                                      : tr("Trainees ask you"));
  emptyLayout(list_);
  for (std::size_t i = 0; i < std::min(kShown, questions_.size()); ++i) {
    const PhysicianQuestion& question = questions_[i];
    auto* row = new QHBoxLayout;
    auto* words = sentence(this, false);
    const QString waits = StationLabels::waited(shell_.session().now_us() - question.askedUtc_us);
    words->setText(tr("%1, %2, at %3: waiting for %4")
                       .arg(toQString(question.trainee), toQString(Text(question.moduleTitle)),
                            clockTenths(question.at_s), waits));
    auto* look = named(new QPushButton(tr("Answer\u2026"), this), "answerQuestion");
    look->setAccessibleName(tr("Answer %1").arg(toQString(question.trainee)));
    connect(look, &QPushButton::clicked, this, [this, id = question.id] { open(id); });
    row->addWidget(words, 1);
    row->addWidget(look);
    list_->addLayout(row);
  }
  for (const PhysicianQuestion& question : answered_) {
    addAnswer(question);
  }
}

void QuestionsCard::addAnswer(const PhysicianQuestion& question) {
  auto* words = new RemarkWords(this);
  words->setWords(toQString(question.answer), question.answerEditedUtc_us, question.earlierAnswers, true);
  words->setLead(tr("You answered %1").arg(toQString(question.trainee)));
  connect(words, &RemarkWords::edited, this, [this, id = question.id](const QString& text) {
    attempt(shell_, [&] {
      editAnswer(shell_.session(), id, text.toStdString());
      read();
    });
  });
  list_->addWidget(words);
}

void QuestionsCard::open(const RemarkId& questionId) {
  const auto found = std::find_if(questions_.begin(), questions_.end(),
                                  [&](const PhysicianQuestion& one) { return one.id == questionId; });
  if (found == questions_.end()) {
    return;
  }
  shell_.run(
      this, tr("Opening the run"),
      [questionId](SessionContext& own, const ProgressCallback&) { return questionedRun(own, questionId); },
      [this, question = *found](const Debrief& run) { show(question, run); });
}

void QuestionsCard::show(const PhysicianQuestion& question, const Debrief& run) {
  QDialog dialog(this);
  dialog.setObjectName(QStringLiteral("answerDialog"));
  dialog.setWindowTitle(tr("A question from %1").arg(toQString(question.trainee)));
  auto* column = new QVBoxLayout(&dialog);
  column->setSpacing(kSpace);
  auto* head = sentence(&dialog, false);
  head->setText(question.text.empty()
                    ? tr("%1 asks about this moment of \u201c%2\u201d.")
                          .arg(toQString(question.trainee), toQString(Text(question.moduleTitle)))
                    : toQString(question.text));
  column->addWidget(head);
  auto* plot = new DebriefPlot(&dialog);
  plot->setTheme(theme(shell_.themeKind()));
  plot->setDebrief(run);
  plot->show({std::max(0.0, question.at_s - kRound_s), std::min(run.duration_s, question.at_s + kRound_s)});
  plot->retranslate();
  column->addWidget(plot, 1);
  auto* text = new QPlainTextEdit(&dialog);
  text->setTabChangesFocus(true);
  text->setMaximumHeight(kAnswerHeight);
  auto* label = new QLabel(&dialog);
  label->setBuddy(text);
  nameField(label, tr("Your &answer; the trainee sees that it is yours"));
  column->addWidget(label);
  column->addWidget(text);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, &dialog);
  auto* send = buttons->addButton(tr("&Send"), QDialogButtonBox::AcceptRole);
  send->setEnabled(false);
  connect(text, &QPlainTextEdit::textChanged, send,
          [send, text] { send->setEnabled(!text->toPlainText().trimmed().isEmpty()); });
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  column->addWidget(buttons);
  dialog.resize(860, 560);
  text->setFocus();
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  attempt(shell_, [&] {
    answerQuestion(shell_.session(), question.id, text->toPlainText().trimmed().toStdString());
    shell_.notify(tr("Your answer was sent to %1").arg(toQString(question.trainee)));
    read();
  });
}

void QuestionsCard::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    fill();
  }
  Card::changeEvent(event);
}

namespace {

constexpr std::size_t kShownReplies = 3;

}  // namespace

RepliesCard::RepliesCard(ShellContext& shell, QWidget* parent)
    : Card(QString(), parent), shell_(shell), list_(new QVBoxLayout) {
  list_->setSpacing(kSpace / 2);
  content()->addLayout(list_);
  hide();
}

void RepliesCard::read() {
  const std::vector<RemarkReply> replies = repliesToMe(shell_.session());
  setVisible(!replies.empty());
  setTitle(replies.size() > kShownReplies ? tr("Answers to your remarks: %1").arg(replies.size())
                                          : tr("Answers to your remarks"));
  emptyLayout(list_);
  for (std::size_t i = 0; i < std::min(kShownReplies, replies.size()); ++i) {
    const RemarkReply& reply = replies[i];
    auto* row = new QHBoxLayout;
    auto* words = sentence(this, false);
    words->setText(tr("%1 (you wrote: %2)").arg(toQString(reply.text), toQString(reply.remark)));
    auto* done = named(new QPushButton(tr("Read"), this), "readReply");
    connect(done, &QPushButton::clicked, this, [this, id = reply.id, version = reply.version] {
      attempt(shell_, [&] {
        markReplyRead(shell_.session(), id, version);
        read();
      });
    });
    row->addWidget(words, 1);
    row->addWidget(done, 0, Qt::AlignTop);
    list_->addLayout(row);
  }
}

void RepliesCard::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && !isHidden()) {
    attempt(shell_, [this] { read(); });
  }
  Card::changeEvent(event);
}

}  // namespace torsio::gui
