// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/curriculum_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include "app/gui/administrator/curriculum_parts.h"
#include "app/gui/administrator/exercise_editor.h"
#include "app/gui/administrator/group_editor.h"
#include "app/gui/administrator/office_parts.h"
#include "app/gui/administrator/study_words.h"
#include "app/gui/base/spoken.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "sim/base/error.h"

namespace torsio::gui {

namespace {

constexpr std::array<const char*, 3> kPointCodes{"pre", "mid", "post"};
constexpr std::array<double, 3> kUsualMinutes{0.0, 20.0, 40.0};  // paper section 6
constexpr double kMostMinutes = 100'000.0;

std::vector<StoredScoringPoint>::iterator pointOf(StoredCurriculumVersion& content, const char* code) {
  return std::find_if(content.scoringPoints.begin(), content.scoringPoints.end(),
                      [&](const StoredScoringPoint& point) { return point.code == code; });
}

/// Where a point belongs among those that are there: before all that come later in the study.
std::vector<StoredScoringPoint>::iterator placeOf(StoredCurriculumVersion& content, std::size_t point) {
  for (std::size_t later = point + 1; later < kPointCodes.size(); ++later)
    if (const auto at = pointOf(content, kPointCodes[later]); at != content.scoringPoints.end()) return at;
  return content.scoringPoints.end();
}

}  // namespace

CurriculumEditor::CurriculumEditor(std::filesystem::path assets, QWidget* parent)
    : QTabWidget(parent),
      assets_(std::move(assets)),
      exercises_(new ExerciseEditor(assets_, content_)),
      groups_(new GroupEditor(content_)),
      pointsText_(sentence(nullptr)),
      problemList_(new QListWidget) {
  addTab(exercises_, QString());
  addTab(groups_, QString());
  addTab(pointsTab(), QString());
  problemList_->setWordWrap(true);
  addTab(problemList_, QString());
  for (QWidget* part : {static_cast<QWidget*>(exercises_), static_cast<QWidget*>(groups_)})
    part->layout()->setContentsMargins(0, kSpace, 0, 0);
  connect(exercises_, &ExerciseEditor::edited, this, [this] {
    groups_->fill();  // phases name exercises
    changed();
  });
  connect(groups_, &GroupEditor::edited, this, &CurriculumEditor::changed);
  retranslate();
}

QWidget* CurriculumEditor::pointsTab() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 2 * kSpace, 0, 0);
  column->setSpacing(2 * kSpace);
  column->addWidget(pointsText_);
  auto* grid = new QGridLayout;
  grid->setSpacing(kSpace);
  grid->setColumnStretch(2, 1);
  for (std::size_t i = 0; i < kPoints; ++i) {
    wanted_[i] = new QCheckBox;
    after_[i] = numberField(0.0, kMostMinutes, 1);
    after_[i]->setMinimumWidth(24 * kSpace);
    const int row = static_cast<int>(i);
    grid->addWidget(wanted_[i], row, 0);
    grid->addWidget(after_[i], row, 1);
    connect(wanted_[i], &QCheckBox::toggled, this, [this, i] { takePoint(i); });
    connect(after_[i], &QDoubleSpinBox::valueChanged, this, [this, i] { takePoint(i); });
  }
  column->addLayout(grid);
  column->addStretch(1);
  return page;
}

void CurriculumEditor::setContent(const StoredCurriculumVersion& content) {
  content_ = content;
  exercises_->select(0);
  groups_->select(0);
  fillPoints();
  judge();
}

void CurriculumEditor::setReadOnly(bool readOnly) {
  exercises_->setReadOnly(readOnly);
  groups_->setReadOnly(readOnly);
  widget(2)->setEnabled(!readOnly);
}

void CurriculumEditor::fillPoints() {
  filling_ = true;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const auto point = pointOf(content_, kPointCodes[i]);
    const bool wanted = point != content_.scoringPoints.end();
    wanted_[i]->setChecked(wanted);
    after_[i]->setEnabled(wanted);
    after_[i]->setValue(wanted ? static_cast<double>(point->afterExposure_us) / kMicrosecondsOfMinute
                               : kUsualMinutes[i]);
  }
  filling_ = false;
}

void CurriculumEditor::takePoint(std::size_t point) {
  if (filling_) return;
  const char* code = kPointCodes[point];
  auto stored = pointOf(content_, code);
  after_[point]->setEnabled(wanted_[point]->isChecked());
  if (!wanted_[point]->isChecked()) {
    if (stored != content_.scoringPoints.end()) content_.scoringPoints.erase(stored);
  } else {
    if (stored == content_.scoringPoints.end())
      stored = content_.scoringPoints.insert(placeOf(content_, point), StoredScoringPoint{code, 0});
    stored->afterExposure_us = std::llround(after_[point]->value() * kMicrosecondsOfMinute);
  }
  changed();
}

void CurriculumEditor::changed() {
  judge();
  Q_EMIT edited();
}

void CurriculumEditor::judge() {
  problems_ = curriculumProblems(content_, assets_);
  problemList_->clear();
  for (const CurriculumProblem& problem : problems_)
    problemList_->addItem(
        tr("%1 %2. %3.").arg(spoken(problem.where), spoken(problem.what), spoken(problem.remedy)));
  if (problems_.empty()) problemList_->addItem(tr("\u2713 Nothing is missing: this can be published."));
  setTabText(3, problems_.empty() ? tr("Check: complete")
                                  : tr("Check: %n to mend", nullptr, static_cast<int>(problems_.size())));
}

void CurriculumEditor::retranslate() {
  setTabText(0, tr("Exercises"));
  setTabText(1, tr("Groups and phases"));
  setTabText(2, tr("Scoring points"));
  pointsText_->setText(
      tr("When the raters score everybody, counted in minutes of training (rest does not "
         "count). The paper scores before, after 20 and after 40 minutes."));
  for (std::size_t i = 0; i < kPoints; ++i) {
    wanted_[i]->setText(scoringPointName(kPointCodes[i]));
    after_[i]->setPrefix(tr("after "));
    after_[i]->setSuffix(tr(" min"));
    after_[i]->setAccessibleName(tr("Minutes of training before: %1").arg(scoringPointName(kPointCodes[i])));
  }
  exercises_->retranslate();
  groups_->retranslate();
  problemList_->setAccessibleName(tr("What is still to mend"));
  judge();
}

}  // namespace torsio::gui
