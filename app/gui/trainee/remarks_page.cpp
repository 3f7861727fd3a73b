// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/trainee/remarks_page.h"

#include <algorithm>
#include <memory>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "assessment/domain/ids.h"

namespace torsio::gui {

namespace {

constexpr int kListWidth = 280;

QString points(double value) {
  return numberText(value, 1);
}

/// Adds one's own mark, the physicians' mean and the gap to a line of the grid.
void addGapCells(QGridLayout& grid, int line, const ScoreGapRow& row, QWidget* parent) {
  const auto cell = [&](int column, const std::optional<double>& value, bool sign) {
    auto* label = new QLabel(parent);
    QString text = value ? points(*value) : QStringLiteral("\u2013");
    if (sign && value && *value > 0.0) {
      text.prepend(QLatin1Char('+'));
    }
    label->setText(text);
    grid.addWidget(label, line, column);
  };
  cell(1, row.own, false);
  cell(2, row.panel, false);
  cell(3, row.own && row.panel ? std::optional(*row.own - *row.panel) : std::nullopt, true);
}

/// Returns a field within the bounds of a row; one step below the scale means "not given yet".
QDoubleSpinBox* scoreField(const ScoreGapRow& row, QWidget* parent) {
  auto* field = ranged(new QDoubleSpinBox(parent), row.lowest - std::max(row.step, 0.5), row.highest);
  field->setSpecialValueText(QStringLiteral("\u2013"));
  field->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field->setSingleStep(std::max(row.step, 0.5));
  field->setDecimals(row.step < 0.99 ? 1 : 0);
  field->setValue(field->minimum());
  return field;
}

}  // namespace

RemarksPage::RemarksPage(ShellContext& context, QWidget* parent)
    : Page(context, parent), theme_(&theme(context.themeKind())) {
  const PageColumn page = pageColumn(this);
  heading_ = page.heading;
  empty_ = plainLabel(this, "quiet");
  page.column->addWidget(empty_);
  QHBoxLayout* row = rowOf({}, 2 * kSpace);
  list_ = new QListWidget(this);
  list_->setFixedWidth(kListWidth);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setWordWrap(true);
  row->addWidget(list_);
  right_ = new QWidget(this);
  QVBoxLayout* column = columnOf(right_, {}, 2 * kSpace);
  remarks_ = new Card(QString(), right_);
  threads_ = new QVBoxLayout;
  threads_->setSpacing(kSpace);
  remarks_->content()->addLayout(threads_);
  column->addWidget(remarks_);
  marks_ = new Card(QString(), right_);
  sheet_ = new QVBoxLayout;
  marks_->content()->addLayout(sheet_);
  column->addWidget(marks_);
  column->addStretch(1);
  row->addWidget(right_, 1);
  page.column->addLayout(row, 1);
  connect(list_, &QListWidget::currentRowChanged, this, [this] {
    fillRemarks();
    fillMarks();
  });
}

void RemarksPage::enter(const QVariant&) {
  readAll();
}

void RemarksPage::readAll() {
  attempt(shell(), [&] { all_ = ownRemarks(shell().session()); });
  retranslate();
}

const TrialRemarks* RemarksPage::chosen() const {
  const int row = list_->currentRow();
  return row >= 0 && static_cast<std::size_t>(row) < all_.size() ? &all_[static_cast<std::size_t>(row)]
                                                                 : nullptr;
}

void RemarksPage::retranslate() {
  heading_->setTexts(tr("What physicians wrote"),
                     tr("Each remark is linked to the moment of the run it is about."));
  empty_->setText(
      tr("No remarks yet. They appear here when the marks of a run have been released, or when a physician "
         "answers one of your questions."));
  remarks_->setTitle(tr("Remarks on this run"));
  marks_->setTitle(tr("Marks"));
  list_->setAccessibleName(tr("Runs with remarks"));
  fillList();
}

void RemarksPage::applyTheme(const Theme& theme) {
  theme_ = &theme;
  fillRemarks();
}

void RemarksPage::fillList() {
  const int before = std::max(0, list_->currentRow());
  list_->clear();
  for (const TrialRemarks& trial : all_) {
    const QString title =
        trial.moduleTitle.empty() ? toQString(trial.phaseLabel) : toQString(Text(trial.moduleTitle));
    const QString head = title.isEmpty() ? tr("Run") : title;
    const QString line =
        trial.unread > 0 ? tr("%1\n%2, %3 unread").arg(head, shownTime(trial.startedUtc_us)).arg(trial.unread)
                         : tr("%1\n%2").arg(head, shownTime(trial.startedUtc_us));
    list_->addItem(line);
  }
  const bool any = !all_.empty();
  empty_->setVisible(!any);
  list_->setVisible(any);
  right_->setVisible(any);
  if (any) {
    list_->setCurrentRow(std::min<int>(before, static_cast<int>(all_.size()) - 1));
  }
  fillRemarks();
  fillMarks();
}

void RemarksPage::change(const std::function<void(SessionContext&)>& action) {
  attempt(shell(), [&] { action(shell().session()); });
  readAll();
}

void RemarksPage::addRemark(const TraineeRemark& remark, bool reply) {
  auto* head = new QHBoxLayout;
  if (reply) {
    head->addSpacing(3 * kSpace);
  }
  auto* who = plainLabel(remarks_, "quiet");
  who->setText(remark.question ? tr("You asked, at %1").arg(clockTenths(remark.at_s))
               : remark.own    ? tr("You, %1").arg(shownTime(remark.writtenUtc_us))
               : reply         ? tr("Physician, %1").arg(shownTime(remark.writtenUtc_us))
                               : tr("Physician, at %1").arg(clockTenths(remark.at_s)));
  head->addWidget(who, 1);
  if (!remark.read) {
    auto* read = named(linkButton(remarks_), "read");
    read->setText(tr("Mark as read"));
    connect(read, &QPushButton::clicked, this, [this, id = remark.id, version = remark.version] {
      change([&](SessionContext& session) { markRemarkRead(session, id, version); });
    });
    head->addWidget(read);
  }
  if (!reply) {
    auto* look = linkButton(remarks_);
    look->setText(tr("Look at the run"));
    connect(look, &QPushButton::clicked, this,
            [this, id = remark.trialId] { shell().open(PageId::kDebrief, toQString(id)); });
    head->addWidget(look);
  }
  threads_->addLayout(head);
  auto* body = new QHBoxLayout;
  if (reply) {
    body->addSpacing(3 * kSpace);
  }
  auto* words = new RemarkWords(remarks_);
  words->setWords(remark.question && remark.text.empty() ? tr("About this moment") : toQString(remark.text),
                  remark.editedUtc_us, remark.earlier, remark.own && !remark.text.empty());
  connect(words, &RemarkWords::edited, this, [this, id = remark.id](const QString& text) {
    change([&](SessionContext& session) { editRemark(session, id, text.toStdString()); });
  });
  body->addWidget(words, 1);
  threads_->addLayout(body);
}

void RemarksPage::fillRemarks() {
  emptyLayout(threads_);
  const TrialRemarks* trial = chosen();
  if (trial == nullptr) {
    return;
  }
  for (const TraineeRemark& remark : trial->remarks) {
    addRemark(remark, false);
    for (const TraineeRemark& reply : remark.replies) {
      addRemark(reply, true);
    }
    auto* row = new QHBoxLayout;
    auto* field = named(new QLineEdit(remarks_), "reply");
    field->setPlaceholderText(tr("Write a reply"));
    field->setAccessibleName(tr("Reply"));
    auto* send = named(new QPushButton(tr("Reply"), remarks_), "send");
    send->setEnabled(false);
    connect(field, &QLineEdit::textChanged, send,
            [send](const QString& now) { send->setEnabled(!now.trimmed().isEmpty()); });
    connect(send, &QPushButton::clicked, this, [this, field, id = remark.id] {
      const std::string text = field->text().trimmed().toStdString();
      change([&](SessionContext& session) { (void)replyToRemark(session, id, text); });
    });
    row->addWidget(field, 1);
    row->addWidget(send);
    threads_->addLayout(row);
  }
}

void RemarksPage::fillMarks() {
  emptyLayout(sheet_);
  const TrialRemarks* trial = chosen();
  if (trial == nullptr) {
    return;
  }
  ScoreGap gap;
  if (!attempt(shell(), [&] { gap = scoreGap(shell().session(), trial->trialId); })) {
    return;
  }
  auto* hint = plainLabel(marks_, "quiet");
  hint->setText(
      !gap.selfScored ? tr("Score yourself first; then you see the physicians' marks.")
      : gap.raters > 0
          ? tr("Your own marks beside the mean of %n physician(s).", nullptr, static_cast<int>(gap.raters))
          : tr("Your marks are kept. The physicians' marks appear when they are released."));
  sheet_->addWidget(hint);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * kSpace);
  grid->setColumnStretch(4, 1);
  std::vector<ScoreGapRow> rows{gap.overall};
  rows.insert(rows.end(), gap.rows.begin(), gap.rows.end());
  auto fields = std::make_shared<std::vector<std::pair<std::string, QDoubleSpinBox*>>>();
  int line = 0;
  if (gap.selfScored) {
    const QString heads[] = {QString(), tr("You"), tr("Physicians"), tr("Gap")};
    for (int column = 0; column < 4; ++column) {
      auto* head = plainLabel(marks_, "quiet");
      head->setText(heads[column]);
      grid->addWidget(head, line, column);
    }
    ++line;
  }
  for (const ScoreGapRow& row : rows) {
    auto* name = new QLabel(row.code.empty() ? tr("Overall") : toQString(Text(row.label)), marks_);
    grid->addWidget(name, line, 0);
    if (!gap.selfScored) {
      QDoubleSpinBox* field = scoreField(row, marks_);
      field->setAccessibleName(name->text());
      name->setBuddy(field);
      fields->emplace_back(row.code, field);
      grid->addWidget(field, line, 1);
    } else {
      addGapCells(*grid, line, row, marks_);
    }
    ++line;
  }
  sheet_->addLayout(grid);
  if (gap.selfScored) {
    return;
  }
  auto* keep = named(primaryButton(marks_), "selfScore");
  keep->setText(tr("&Save my marks"));
  const auto given = [fields, keep] {
    keep->setEnabled(std::all_of(fields->begin(), fields->end(), [](const auto& field) {
      return field.second->value() > field.second->minimum();
    }));
  };
  for (const auto& [code, field] : *fields) {
    connect(field, &QDoubleSpinBox::valueChanged, keep, given);
  }
  given();
  connect(keep, &QPushButton::clicked, this, [this, fields, id = trial->trialId] {
    attempt(shell(), [&] {
      std::vector<SelfScoreRow> sheet;
      for (std::size_t i = 1; i < fields->size(); ++i) {
        sheet.push_back({(*fields)[i].first, (*fields)[i].second->value()});
      }
      selfScore(shell().session(), id, fields->front().second->value(), sheet);
    });
    fillMarks();
  });
  sheet_->addWidget(keep, 0, Qt::AlignLeft);
}

AskCard::AskCard(ShellContext& shell, QWidget* parent)
    : Card(QString(), parent),
      shell_(shell),
      whomLabel_(new QLabel(this)),
      whom_(named(new QComboBox(this), "whom")),
      text_(named(new QLineEdit(this), "question")),
      ask_(named(new QPushButton(this), "ask")),
      list_(new QVBoxLayout) {
  whomLabel_->setBuddy(whom_);
  QHBoxLayout* row = rowOf({whomLabel_, whom_});
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
