// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/remarks_page.h"

#include <algorithm>
#include <memory>

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
#include "app/gui/trainee/remark_words.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
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
  auto* field = new QDoubleSpinBox(parent);
  field->setRange(row.lowest - std::max(row.step, 0.5), row.highest);
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
  auto* row = new QHBoxLayout;
  row->setSpacing(2 * kSpace);
  list_ = new QListWidget(this);
  list_->setFixedWidth(kListWidth);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setWordWrap(true);
  row->addWidget(list_);
  right_ = new QWidget(this);
  auto* column = new QVBoxLayout(right_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2 * kSpace);
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
         "answers a question of yours."));
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
    auto* read = linkButton(remarks_);
    read->setObjectName(QStringLiteral("read"));
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
    auto* field = new QLineEdit(remarks_);
    field->setObjectName(QStringLiteral("reply"));
    field->setPlaceholderText(tr("Write a reply"));
    field->setAccessibleName(tr("Reply"));
    auto* send = new QPushButton(tr("Reply"), remarks_);
    send->setObjectName(QStringLiteral("send"));
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
  auto* keep = primaryButton(marks_);
  keep->setObjectName(QStringLiteral("selfScore"));
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

}  // namespace torsio::gui
