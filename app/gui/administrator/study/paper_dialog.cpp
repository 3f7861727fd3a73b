// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/paper_dialog.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/sheet_check.h"

namespace torsio::gui {

namespace {

constexpr int kNumberWidth = 110;
constexpr int kWidth = 1080;
constexpr int kHeight = 660;

int decimalsOf(const ScoreScale& scale) {
  return static_cast<int>(std::ceil(std::log10(static_cast<double>(scale.stepsPerPoint))));
}

}  // namespace

PaperDialog::PaperDialog(ShellContext& shell, CohortId cohortId, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      cohortId_(std::move(cohortId)),
      table_(named(new DataTable(QStringLiteral("paper-sheets"), this), "cases")),
      title_(named(new QLabel(this), "cardTitle")),
      scroll_(new QScrollArea(this)),
      comment_(named(new QLineEdit(this), "comment")),
      keep_(named(primaryButton(this), "keep")) {
  setWindowTitle(tr("Marks on paper"));
  resize(kWidth, kHeight);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  auto* form = new QVBoxLayout;
  form->setSpacing(kSpace);
  form->addWidget(title_);
  form->addWidget(scroll_, 1);
  commentLabel_ = gui::addField(form, comment_);
  form->addWidget(keep_, 0, Qt::AlignRight);
  QHBoxLayout* halves = rowOf({}, 3 * kSpace);
  halves->addWidget(table_, 1);
  halves->addLayout(form, 1);
  QLabel* words = sentence(
      this, tr("Two people type each sheet, each for themselves; it counts when both are alike."), false);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(tr("C&lose"), QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(words);
  column->addLayout(halves, 1);
  column->addWidget(buttons);
  nameField(commentLabel_, tr("Co&mment on the paper"));
  keep_->setText(tr("&Save what I typed"));
  table_->setColumns({{tr("Case")}, {tr("Rater")}, {tr("Called")}, {tr("State")}});
  table_->setEmptyText(tr("No live sheet is missing. Sheets appear here once their trainee was called."));
  connect(table_, &DataTable::currentChanged, this, &PaperDialog::showForm);
  connect(keep_, &QPushButton::clicked, this, &PaperDialog::keep);
  read();
}

QString PaperDialog::stateText(const PaperCase& one) const {
  if (one.differs) {
    return tr("! typed twice, not alike");
  }
  if (one.byMe) {
    return tr("\u25D0 typed by you, waits for another");
  }
  return one.byOthers > 0 ? tr("\u25D0 typed once: type it again") : tr("\u25CB not typed yet");
}

void PaperDialog::read() {
  attempt(shell_, [&] {
    cases_ = paperCases(shell_.session(), cohortId_);
    std::vector<Row> rows;
    for (const PaperCase& one : cases_) {
      rows.push_back({toQString(one.assignmentId),
                      {{toQString(one.caseLabel)},
                       {toQString(one.raterCode)},
                       timeCell(one.calledUtc_us),
                       {stateText(one)}}});
    }
    table_->setRows(std::move(rows));
    showForm();
  });
}

void PaperDialog::addField(int row, const QString& label, const std::string& code, const ScoreScale& scale,
                           const SheetAnswer& typed, bool differs) {
  auto* grid = dynamic_cast<QGridLayout*>(scroll_->widget()->layout());
  const double step = 1.0 / static_cast<double>(scale.stepsPerPoint);
  const double lowest = pointsFromSteps(scale.lo, scale);
  auto* name = new QLabel(differs ? QStringLiteral("! ") + label : label, scroll_->widget());
  name->setTextFormat(Qt::PlainText);
  name->setWordWrap(true);
  setLook(name, "caution", differs);
  auto* mark = ranged(new QDoubleSpinBox(scroll_->widget()), lowest - step, pointsFromSteps(scale.hi, scale));
  mark->setObjectName(QStringLiteral("mark.") + toQString(code));
  mark->setAccessibleName(label);
  mark->setDecimals(decimalsOf(scale));
  mark->setSingleStep(step);
  mark->setSpecialValueText(QStringLiteral("\u2013"));
  mark->setFixedWidth(kNumberWidth);
  mark->setValue(typed.score_steps ? pointsFromSteps(*typed.score_steps, scale) : mark->minimum());
  auto* none = new QCheckBox(tr("cannot be assessed"), scroll_->widget());
  auto* reason = new QLineEdit(toQString(typed.notAssessableReason), scroll_->widget());
  reason->setPlaceholderText(tr("reason on the paper"));
  reason->setAccessibleName(tr("Reason: %1").arg(label));
  const auto follow = [mark, reason](bool checked) {
    mark->setEnabled(!checked);
    reason->setVisible(checked);
  };
  connect(none, &QCheckBox::toggled, reason, follow);
  none->setChecked(!typed.notAssessableReason.empty());
  follow(none->isChecked());
  grid->addWidget(name, 2 * row, 0);
  grid->addWidget(mark, 2 * row, 1);
  grid->addWidget(none, 2 * row, 2);
  grid->addWidget(reason, 2 * row + 1, 0, 1, 3);
  fields_.push_back({code, scale, mark, none, reason});
}

void PaperDialog::showForm() {
  chosen_ = table_->currentId().toStdString();
  form_.reset();
  fields_.clear();
  auto* inside = new QWidget(scroll_);
  auto* grid = new QGridLayout(inside);
  grid->setColumnStretch(0, 1);
  scroll_->setWidget(inside);  // deletes the previous widget
  if (!chosen_.empty()) {
    attempt(shell_, [&] { form_ = paperForm(shell_.session(), chosen_); });
  }
  keep_->setEnabled(form_.has_value());
  comment_->setEnabled(form_.has_value());
  comment_->setText(form_ ? toQString(form_->own.comment) : QString());
  if (!form_) {
    title_->setText(tr("Choose a sheet at the left"));
    return;
  }
  title_->setText(tr("Case %1, rater %2").arg(toQString(form_->caseLabel), toQString(form_->raterCode)));
  const auto differs = [&](const std::string& code) {
    return std::find(form_->differing.begin(), form_->differing.end(), code) != form_->differing.end();
  };
  int row = 0;
  for (const RubricLine& line : form_->rubric.rows) {
    SheetAnswer answer;
    for (const SheetRow& own : form_->own.rows) {
      if (own.code == line.code) {
        answer = {own.score_steps, own.notAssessableReason};
      }
    }
    addField(row++, toQString(Text(line.label)), line.code, line.scale, answer, differs(line.code));
  }
  addField(row++, tr("Overall mark"), kOverallRow, form_->rubric.overall,
           {form_->own.overall_steps, form_->own.notAssessableReason}, differs(kOverallRow));
  grid->setRowStretch(2 * row, 1);
}

Sheet PaperDialog::typed() const {
  Sheet sheet;
  sheet.comment = comment_->text().trimmed().toStdString();
  for (const Field& field : fields_) {
    SheetAnswer answer;
    if (field.none->isChecked()) {
      answer.notAssessableReason = field.reason->text().trimmed().toStdString();
    } else if (field.mark->value() > field.mark->minimum()) {
      answer.score_steps = std::llround(field.mark->value() * static_cast<double>(field.scale.stepsPerPoint));
    }
    if (field.code == kOverallRow) {
      sheet.overall_steps = answer.score_steps;
      sheet.notAssessableReason = answer.notAssessableReason;
    } else {
      sheet.rows.push_back({field.code, answer.score_steps, answer.notAssessableReason});
    }
  }
  return sheet;
}

void PaperDialog::keep() {
  attempt(shell_, [&] {
    switch (enterPaperSheet(shell_.session(), chosen_, typed())) {
      case PaperOutcome::kFirst:
        shell_.notify(tr("Saved. It counts once a second person has typed in the same marks."));
        break;
      case PaperOutcome::kDiffers:
        shell_.notify(
            tr("Not alike in the rows with a sign: look at the paper again. Nothing counts so far."));
        break;
      case PaperOutcome::kCounts:
        shell_.notify(tr("Alike: the sheet counts now."));
        break;
    }
    read();
  });
}

}  // namespace torsio::gui
