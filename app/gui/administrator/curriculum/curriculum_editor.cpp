// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/curriculum/curriculum_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/curriculum/curriculum_parts.h"
#include "app/gui/administrator/curriculum/exercise_editor.h"
#include "app/gui/administrator/curriculum/group_editor.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/study/curriculum_content.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr double kDefaultStep_min = 20.0;  // paper section 6: before, after 20 and after 40 minutes

std::vector<PlannedOccasion>::iterator pointOf(CurriculumVersion& content, const std::string& code) {
  return std::find_if(content.plannedOccasions.begin(), content.plannedOccasions.end(),
                      [&](const PlannedOccasion& point) { return point.code == code; });
}

/// Finds the position for an occasion: before all later ones of the study.
std::vector<PlannedOccasion>::iterator placeOf(CurriculumVersion& content, const Occasions& occasions,
                                               std::size_t point) {
  for (std::size_t later = point + 1; later < occasions.size(); ++later) {
    const auto at = pointOf(content, occasions.at(later).code);
    if (at != content.plannedOccasions.end()) {
      return at;
    }
  }
  return content.plannedOccasions.end();
}

/// Returns the training time of the longest arm; without arms, more than anybody trains.
double longestTraining_min(const CurriculumVersion& content) {
  double longest_min = content.arms.empty() ? kMaxMinutes : 0.0;
  for (const StudyArm& arm : content.arms) {
    double arm_min = 0.0;
    for (const TrainingPhase& phase : arm.phases) {
      arm_min += static_cast<double>(phase.duration_us) / kMicrosecondsOfMinute;
    }
    longest_min = std::max(longest_min, arm_min);
  }
  return longest_min;
}

}  // namespace

CurriculumEditor::CurriculumEditor(std::filesystem::path assets, QWidget* parent)
    : QTabWidget(parent),
      assets_(std::move(assets)),
      exercises_(new ExerciseEditor(assets_, content_)),
      groups_(new GroupEditor(content_)),
      pointsText_(sentence(nullptr)),
      addOccasion_(named(new QPushButton, "addOccasion")),
      problemList_(new QListWidget) {
  addTab(exercises_, QString());
  addTab(groups_, QString());
  addTab(pointsTab(), QString());
  problemList_->setWordWrap(true);
  addTab(problemList_, QString());
  for (QWidget* part : {static_cast<QWidget*>(exercises_), static_cast<QWidget*>(groups_)}) {
    part->layout()->setContentsMargins(0, kSpace, 0, 0);
  }
  connect(exercises_, &ExerciseEditor::edited, this, [this] {
    groups_->fill();  // refreshes the exercise names in phases
    changed();
  });
  connect(groups_, &GroupEditor::edited, this, &CurriculumEditor::changed);
  retranslate();
}

QWidget* CurriculumEditor::pointsTab() {
  auto* page = new QWidget;
  QVBoxLayout* column = columnOf(page, {0, 2 * kSpace, 0, 0}, 2 * kSpace);
  column->addWidget(pointsText_);
  pointGrid_ = new QGridLayout;
  pointGrid_->setSpacing(kSpace);
  pointGrid_->setColumnStretch(2, 1);
  column->addLayout(pointGrid_);
  column->addWidget(addOccasion_, 0, Qt::AlignLeft);
  column->addStretch(1);
  connect(addOccasion_, &QPushButton::clicked, this, &CurriculumEditor::occasionWanted);
  return page;
}

void CurriculumEditor::addPointRow(std::size_t point) {
  PointRow row{new QCheckBox, numberField(0.0, kMaxMinutes, 1), sentence(nullptr, false)};
  setLook(row.hint, "caution", true);
  row.after->setMinimumWidth(24 * kSpace);
  pointGrid_->addWidget(row.wanted, static_cast<int>(point), 0);
  pointGrid_->addWidget(row.after, static_cast<int>(point), 1);
  pointGrid_->addWidget(row.hint, static_cast<int>(point), 2);
  connect(row.wanted, &QCheckBox::toggled, this, [this, point] { takePoint(point); });
  connect(row.after, &QDoubleSpinBox::valueChanged, this, [this, point] { takePoint(point); });
  points_.push_back(row);
}

void CurriculumEditor::setOccasions(Occasions occasions) {
  if (std::equal(occasions.begin(), occasions.end(), occasions_.begin(), occasions_.end())) {
    return;
  }
  for (const PointRow& row : points_) {
    delete row.wanted;
    delete row.after;
    delete row.hint;
  }
  points_.clear();
  occasions_ = std::move(occasions);
  for (std::size_t i = 0; i < occasions_.size(); ++i) {
    addPointRow(i);
  }
  namePoints();
  fillPoints();
  judge();
}

void CurriculumEditor::setContent(const CurriculumVersion& content) {
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
  const double longest_min = longestTraining_min(content_);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const auto point = pointOf(content_, occasions_.at(i).code);
    const bool wanted = point != content_.plannedOccasions.end();
    points_[i].wanted->setChecked(wanted);
    points_[i].after->setEnabled(wanted);
    points_[i].after->setValue(wanted ? static_cast<double>(point->afterExposure_us) / kMicrosecondsOfMinute
                                      : std::min(longest_min, kDefaultStep_min * static_cast<double>(i)));
  }
  filling_ = false;
}

void CurriculumEditor::takePoint(std::size_t point) {
  if (filling_) {
    return;
  }
  const std::string& code = occasions_.at(point).code;
  const PointRow& row = points_[point];
  auto stored = pointOf(content_, code);
  row.after->setEnabled(row.wanted->isChecked());
  if (!row.wanted->isChecked()) {
    if (stored != content_.plannedOccasions.end()) {
      content_.plannedOccasions.erase(stored);
    }
  } else {
    if (stored == content_.plannedOccasions.end()) {
      stored =
          content_.plannedOccasions.insert(placeOf(content_, occasions_, point), PlannedOccasion{code, 0});
    }
    stored->afterExposure_us = std::llround(row.after->value() * kMicrosecondsOfMinute);
  }
  changed();
}

void CurriculumEditor::changed() {
  judge();
  Q_EMIT edited();
}

void CurriculumEditor::judge() {
  problems_ = curriculumProblems(content_, assets_, occasions_);
  problemList_->clear();
  for (const CurriculumProblem& problem : problems_) {
    problemList_->addItem(problemSentence(problem));
  }
  if (problems_.empty()) {
    problemList_->addItem(tr("\u2713 Nothing is missing: this can be published."));
  }
  setTabText(3, problems_.empty() ? tr("Check: complete")
                                  : tr("Check: %n to correct", nullptr, static_cast<int>(problems_.size())));
  showHints();
}

void CurriculumEditor::showHints() {
  exercises_->showProblems(problems_);
  groups_->showProblems(problems_);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    QStringList sentences;
    for (const CurriculumProblem& problem : problems_) {
      if (problem.spot.part == CurriculumSpot::Part::kOccasion && problem.spot.row == i) {
        sentences << problemSentence(problem);
      }
    }
    points_[i].hint->setText(sentences.join(QLatin1Char('\n')));
  }
}

void CurriculumEditor::retranslate() {
  setTabText(0, tr("Exercises"));
  setTabText(1, tr("Groups and phases"));
  setTabText(2, tr("Occasions"));
  pointsText_->setText(
      tr("When the raters score everybody, counted in minutes of training (rest does not "
         "count). The paper scores before, after 20 and after 40 minutes. A follow-up, weeks after the "
         "training, has the minutes of the occasion before it."));
  addOccasion_->setText(tr("Add an &occasion\u2026"));
  namePoints();
  exercises_->retranslate();
  groups_->retranslate();
  problemList_->setAccessibleName(tr("Still to be corrected"));
  judge();
}

void CurriculumEditor::namePoints() {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const QString name = occasionName(occasions_.at(i));
    points_[i].wanted->setText(name);
    points_[i].after->setPrefix(tr("after "));
    points_[i].after->setSuffix(tr(" min"));
    points_[i].after->setAccessibleName(tr("Minutes of training before: %1").arg(name));
  }
}

}  // namespace torsio::gui
