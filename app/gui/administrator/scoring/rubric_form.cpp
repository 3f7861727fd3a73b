// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/scoring/rubric_form.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/administrator/base/ordered_list.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/study/rubric_service.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr std::array<int, 4> kDefaultSteps{1, 2, 4, 10};  // steps per point
constexpr double kMaxPoints = 1000.0;
constexpr double kMaxWeight = 100.0;
constexpr double kMilli = 1000.0;
constexpr int kMarkWidth = 90;
constexpr int kMinAnchorLines_px = 130;

QString shownPoints(std::int64_t steps, const ScoreScale& scale) {
  return QLocale().toString(pointsFromSteps(steps, scale), 'g', 6);
}

}  // namespace

ScaleFields::ScaleFields(const QString& name, QWidget* parent)
    : QWidget(parent), from_(new QDoubleSpinBox), to_(new QDoubleSpinBox), step_(new QComboBox) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kSpace);
  fromLabel_ = addField(row, from_);
  toLabel_ = addField(row, to_);
  stepLabel_ = addField(row, step_);
  row->addStretch(1);
  from_->setObjectName(name + QStringLiteral(".from"));
  to_->setObjectName(name + QStringLiteral(".to"));
  step_->setObjectName(name + QStringLiteral(".step"));
  step_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  for (QDoubleSpinBox* field : {from_, to_}) {
    field->setRange(-kMaxPoints, kMaxPoints);
    field->setDecimals(1);
    connect(field, &QDoubleSpinBox::valueChanged, this, &ScaleFields::edited);
  }
  connect(step_, &QComboBox::currentIndexChanged, this, &ScaleFields::edited);
  retranslate();
}

void ScaleFields::retranslate() {
  nameField(fromLabel_, tr("&From"));
  nameField(toLabel_, tr("&to"));
  nameField(stepLabel_, tr("in &steps of"));
}

void ScaleFields::setScale(const ScoreScale& scale) {
  const QSignalBlocker quiet(this);
  step_->clear();
  std::vector<int> steps(kDefaultSteps.begin(), kDefaultSteps.end());
  const auto own = static_cast<int>(scale.stepsPerPoint);
  if (std::find(steps.begin(), steps.end(), own) == steps.end()) {
    steps.push_back(own);
  }
  for (const int one : steps) {
    step_->addItem(QLocale().toString(1.0 / one, 'g', 4), one);
  }
  step_->setCurrentIndex(step_->findData(own));
  from_->setValue(pointsFromSteps(scale.lo, scale));
  to_->setValue(pointsFromSteps(scale.hi, scale));
}

ScoreScale ScaleFields::scale() const {
  const int steps = std::max(1, step_->currentData().toInt());
  return {.lo = std::llround(from_->value() * steps),
          .hi = std::llround(to_->value() * steps),
          .stepsPerPoint = steps};
}

void ScaleFields::setReadOnly(bool readOnly) {
  from_->setReadOnly(readOnly);
  to_->setReadOnly(readOnly);
  step_->setEnabled(!readOnly);
}

RubricForm::RubricForm(QWidget* parent)
    : QWidget(parent),
      label_(named(new QLineEdit, "label")),
      scale_(new ScaleFields(QStringLiteral("row"))),
      weight_(ranged(named(new QDoubleSpinBox, "weight"), 0.0, kMaxWeight)),
      anchors_(named(new QTableWidget(0, 2), "anchors")),
      addAnchor_(named(new QPushButton(tr("Add an a&nchor")), "addAnchor")),
      removeAnchor_(named(new QPushButton(tr("Remove the anc&hor")), "removeAnchor")),
      overall_(new ScaleFields(QStringLiteral("overall"))) {
  rows_ = new OrderedList(QStringLiteral("criteria"), rowForm(), this);
  rows_->setListName(tr("Criteria"));
  rows_->retranslate();
  QVBoxLayout* column = columnOf(this, {}, kSpace);
  column->addWidget(rows_, 1);
  addHint(column, RubricField::kRows);
  auto* overall = new QGroupBox(tr("Overall mark"), this);
  auto* inside = new QVBoxLayout(overall);
  inside->addWidget(overall_);
  addHint(inside, RubricField::kOverall);
  column->addWidget(overall);
  connect(rows_, &OrderedList::chosen, this, &RubricForm::showRow);
  connect(rows_, &OrderedList::addWanted, this, &RubricForm::addRow);
  connect(rows_, &OrderedList::removeWanted, this, [this] {
    if (const std::optional<int> at = rows_->removeChosen(revision_.rows)) {
      showLines(*at);
      Q_EMIT edited();
    }
  });
  connect(rows_, &OrderedList::moveWanted, this, [this](int by) {
    if (const std::optional<int> at = rows_->moveChosen(revision_.rows, by)) {
      showLines(*at);
      Q_EMIT edited();
    }
  });
  connect(label_, &QLineEdit::textEdited, this, &RubricForm::takeRow);
  connect(scale_, &ScaleFields::edited, this, &RubricForm::takeRow);
  connect(weight_, &QDoubleSpinBox::valueChanged, this, &RubricForm::takeRow);
  connect(anchors_, &QTableWidget::itemChanged, this, &RubricForm::takeRow);
  connect(addAnchor_, &QPushButton::clicked, this, &RubricForm::addAnchor);
  connect(removeAnchor_, &QPushButton::clicked, this, &RubricForm::removeAnchor);
  connect(overall_, &ScaleFields::edited, this, [this] {
    if (!filling_) {
      revision_.overall = overall_->scale();
      Q_EMIT edited();
    }
  });
}

QWidget* RubricForm::rowForm() {
  auto* form = new QWidget;
  auto* column = new QVBoxLayout(form);
  column->setSpacing(kSpace);
  nameField(addField(column, label_), tr("&Criterion"));
  addHint(column, RubricField::kLabel);
  column->addWidget(scale_);
  addHint(column, RubricField::kScale);
  weight_->setDecimals(2);
  weight_->setSingleStep(0.5);
  weight_->setToolTip(tr(
      "In the mean of the criteria, which the coded tables show beside the overall mark; 0 leaves it out"));
  QHBoxLayout* row = rowOf();
  nameField(addField(row, weight_), tr("&Weight"));
  row->addStretch(1);
  column->addLayout(row);
  addHint(column, RubricField::kWeight);
  anchors_->setHorizontalHeaderLabels({tr("Mark"), tr("What it means")});
  anchors_->horizontalHeader()->setStretchLastSection(true);
  anchors_->setColumnWidth(0, kMarkWidth);
  anchors_->verticalHeader()->hide();
  anchors_->setMinimumHeight(kMinAnchorLines_px);
  anchors_->setSelectionBehavior(QAbstractItemView::SelectRows);
  anchors_->setWordWrap(true);
  nameField(addField(column, anchors_), tr("&Anchors"));
  auto* tools = new QHBoxLayout;
  tools->addWidget(addAnchor_);
  tools->addWidget(removeAnchor_);
  tools->addStretch(1);
  column->addLayout(tools);
  addHint(column, RubricField::kAnchors);
  return form;
}

void RubricForm::addHint(QBoxLayout* column, RubricField field) {
  QLabel* hint = fieldHint();
  column->addWidget(hint);
  hints_.emplace_back(field, hint);
}

std::vector<RubricProblem> RubricForm::showProblems() {
  std::vector<RubricProblem> elsewhere = rubricProblems(revision_);
  const int chosen = rows_->row();
  for (const auto& [field, hint] : hints_) {
    QStringList lines;
    std::erase_if(elsewhere, [&, field = field](const RubricProblem& problem) {
      const bool whole = field == RubricField::kOverall || field == RubricField::kRows;
      if (problem.field != field || (!whole && static_cast<int>(problem.row) != chosen)) {
        return false;
      }
      lines << translatedLine(Error(ErrorCode::kBadParameter, problem.what, problem.where, problem.remedy));
      return true;
    });
    sayHint(hint, lines.join(QLatin1Char('\n')));
  }
  return elsewhere;
}

void RubricForm::setRevision(const RubricRevision& revision) {
  revision_ = revision;
  filling_ = true;
  overall_->setScale(revision_.overall);
  filling_ = false;
  showLines(0);
}

void RubricForm::setReadOnly(bool readOnly) {
  readOnly_ = readOnly;
  rows_->setReadOnly(readOnly);
  label_->setReadOnly(readOnly);
  scale_->setReadOnly(readOnly);
  overall_->setReadOnly(readOnly);
  weight_->setReadOnly(readOnly);
  anchors_->setEditTriggers(readOnly ? QAbstractItemView::NoEditTriggers
                                     : QAbstractItemView::DoubleClicked | QAbstractItemView::AnyKeyPressed |
                                           QAbstractItemView::EditKeyPressed);
  addAnchor_->setEnabled(!readOnly);
  removeAnchor_->setEnabled(!readOnly);
}

void RubricForm::showLines(int row) {
  QStringList lines;
  for (const RubricLine& line : revision_.rows) {
    lines << (line.label.empty() ? tr("(no name)") : toQString(line.label));
  }
  rows_->setLines(lines, row);
  showRow();
}

void RubricForm::showRow() {
  const RubricLine* line = rows_->chosenOf(revision_.rows);
  filling_ = true;
  label_->setText(line == nullptr ? QString() : toQString(line->label));
  weight_->setValue(line == nullptr ? 0.0 : static_cast<double>(line->weight_milli) / kMilli);
  if (line != nullptr) {
    scale_->setScale(line->scale);
  }
  showAnchors(line == nullptr ? RubricLine{} : *line);
  filling_ = false;
  Q_EMIT shown();
}

void RubricForm::showAnchors(const RubricLine& line) {
  anchors_->setRowCount(0);
  for (const RubricAnchor& anchor : line.anchors) {
    const int at = anchors_->rowCount();
    anchors_->insertRow(at);
    anchors_->setItem(at, 0, new QTableWidgetItem(shownPoints(anchor.score_steps, line.scale)));
    anchors_->setItem(at, 1, new QTableWidgetItem(toQString(anchor.meaning)));
  }
  anchors_->resizeRowsToContents();
}

void RubricForm::takeRow() {
  RubricLine* line = rows_->chosenOf(revision_.rows);
  if (filling_ || line == nullptr) {
    return;
  }
  line->label = label_->text().trimmed().toStdString();
  line->scale = scale_->scale();
  line->weight_milli = std::llround(weight_->value() * kMilli);
  line->anchors.clear();
  for (int i = 0; i < anchors_->rowCount(); ++i) {
    if (anchors_->item(i, 0) == nullptr || anchors_->item(i, 1) == nullptr) {
      continue;
    }
    const double points = QLocale().toDouble(anchors_->item(i, 0)->text());
    line->anchors.push_back({std::llround(points * static_cast<double>(line->scale.stepsPerPoint)),
                             anchors_->item(i, 1)->text().trimmed().toStdString()});
  }
  rows_->setCurrentLine(line->label.empty() ? tr("(no name)") : toQString(line->label));
  Q_EMIT edited();
}

void RubricForm::addRow() {
  RubricLine added{.label = tr("New criterion").toStdString()};
  added.code = codeForCriterion(revision_, added.label);
  added.scale = revision_.overall;
  revision_.rows.push_back(std::move(added));
  showLines(static_cast<int>(revision_.rows.size()) - 1);
  label_->setFocus();
  label_->selectAll();
  Q_EMIT edited();
}

void RubricForm::addAnchor() {
  RubricLine* line = rows_->chosenOf(revision_.rows);
  if (line == nullptr) {
    return;
  }
  std::int64_t steps = line->scale.hi;
  const auto taken = [line](std::int64_t at) {
    return std::any_of(line->anchors.begin(), line->anchors.end(),
                       [at](const RubricAnchor& anchor) { return anchor.score_steps == at; });
  };
  while (steps > line->scale.lo && taken(steps)) {
    --steps;
  }
  line->anchors.push_back({steps, tr("what this mark means").toStdString()});
  showRow();
  Q_EMIT edited();
  anchors_->setCurrentCell(anchors_->rowCount() - 1, 1);
}

void RubricForm::removeAnchor() {
  if (rows_->chosenOf(revision_.rows) == nullptr || anchors_->currentRow() < 0) {
    return;
  }
  anchors_->removeRow(anchors_->currentRow());
  takeRow();
}

}  // namespace torsio::gui
