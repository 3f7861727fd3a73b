// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/office/curriculum_editor.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/look/theme.h"
#include "app/gui/office/office_parts.h"
#include "app/gui/office/study_words.h"
#include "sim/base/error.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMinute_us = 60e6;
constexpr double kSecond_us = 1e6;

QDoubleSpinBox* numberField(double least, double most, int decimals, QWidget* parent) {
  auto* field = new QDoubleSpinBox(parent);
  field->setRange(least, most);
  field->setDecimals(decimals);
  return field;
}

/// Fields of a form in a narrow column beside a list.
QWidget* beside(QListWidget* list, std::initializer_list<QPushButton*> acts, QFormLayout* form) {
  auto* page = new QWidget;
  auto* left = new QVBoxLayout;
  left->addWidget(list, 1);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : acts) buttons->addWidget(button);
  buttons->addStretch(1);
  left->addLayout(buttons);
  auto* fields = new QWidget;
  fields->setLayout(form);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(fields);
  auto* row = new QHBoxLayout(page);
  row->setSpacing(2 * kSpace);
  row->addLayout(left, 2);
  row->addWidget(scroll, 3);
  return page;
}

void choose(QComboBox* box, const std::string& value) {
  if (box->findData(shown(value)) < 0) box->addItem(orDash(value), shown(value));
  box->setCurrentIndex(box->findData(shown(value)));
}

}  // namespace

CurriculumEditor::CurriculumEditor(std::filesystem::path assets, QWidget* parent)
    : QTabWidget(parent),
      assets_(std::move(assets)),
      exercises_(new QListWidget),
      addExercise_(new QPushButton),
      removeExercise_(new QPushButton),
      title_(new QLineEdit),
      scene_(new QComboBox),
      pattern_(new QComboBox),
      kind_(new QComboBox),
      mode_(new QComboBox),
      target_(numberField(-3600.0, 3600.0, 1, nullptr)),
      tolerance_(numberField(0.1, 90.0, 1, nullptr)),
      hold_(numberField(0.0, 600.0, 1, nullptr)),
      attempts_(new QSpinBox),
      after_(new QComboBox),
      metric_(new QComboBox),
      threshold_(numberField(-1e6, 1e6, 3, nullptr)),
      consecutive_(new QSpinBox),
      groups_(new QListWidget),
      groupLabel_(new QLineEdit),
      rest_(numberField(0.0, 240.0, 1, nullptr)),
      splittable_(new QCheckBox),
      phases_(new QTableWidget(0, 4)),
      addPhase_(new QPushButton),
      removePhase_(new QPushButton),
      points_(new QTableWidget(3, 2)),
      problemList_(new QListWidget) {
  addTab(exercisesTab(), QString());
  addTab(groupsTab(), QString());
  addTab(pointsTab(), QString());
  problemList_->setWordWrap(true);
  addTab(problemList_, QString());
  retranslate();
}

QLabel* CurriculumEditor::label(QFormLayout* form, QWidget* field) {
  auto* text = new QLabel;
  text->setBuddy(field);
  form->addRow(text, field);
  labels_.push_back(text);
  return text;
}

QWidget* CurriculumEditor::exercisesTab() {
  auto* form = new QFormLayout;
  form->setSpacing(kSpace);
  for (QWidget* field :
       std::initializer_list<QWidget*>{title_, scene_, pattern_, kind_, mode_, target_, tolerance_, hold_,
                                       attempts_, after_, metric_, threshold_, consecutive_})
    label(form, field);
  target_->setSuffix(QStringLiteral("\u00B0"));
  tolerance_->setSuffix(QStringLiteral("\u00B0"));
  hold_->setSuffix(QStringLiteral(" s"));
  attempts_->setRange(0, 10'000);
  consecutive_->setRange(1, 1000);
  for (QAbstractSpinBox* box : std::initializer_list<QAbstractSpinBox*>{target_, tolerance_, hold_, attempts_,
                                                                        threshold_, consecutive_, rest_})
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  for (const std::string& id : sceneIds(assets_)) scene_->addItem(shown(id), shown(id));
  connect(exercises_, &QListWidget::currentRowChanged, this, &CurriculumEditor::showExercise);
  connect(addExercise_, &QPushButton::clicked, this, &CurriculumEditor::addExercise);
  connect(removeExercise_, &QPushButton::clicked, this, &CurriculumEditor::removeExercise);
  connect(title_, &QLineEdit::textEdited, this, &CurriculumEditor::takeExercise);
  for (QComboBox* box : {scene_, pattern_, kind_, mode_, after_, metric_})
    connect(box, &QComboBox::activated, this, &CurriculumEditor::takeExercise);
  for (QDoubleSpinBox* box : {target_, tolerance_, hold_, threshold_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &CurriculumEditor::takeExercise);
  for (QSpinBox* box : {attempts_, consecutive_})
    connect(box, &QSpinBox::valueChanged, this, &CurriculumEditor::takeExercise);
  return beside(exercises_, {addExercise_, removeExercise_}, form);
}

QWidget* CurriculumEditor::groupsTab() {
  auto* form = new QFormLayout;
  form->setSpacing(kSpace);
  label(form, groupLabel_);
  label(form, rest_);
  form->addRow(QString(), splittable_);
  auto* phasesTitle = new QLabel;
  phasesTitle->setBuddy(phases_);
  labels_.push_back(phasesTitle);
  form->addRow(phasesTitle);
  form->addRow(phases_);
  auto* acts = new QHBoxLayout;
  acts->addWidget(addPhase_);
  acts->addWidget(removePhase_);
  acts->addStretch(1);
  form->addRow(acts);
  phases_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::Stretch);
  phases_->verticalHeader()->setVisible(false);
  phases_->verticalHeader()->setDefaultSectionSize(5 * kSpace);
  phases_->setColumnWidth(2, 10 * kSpace);
  phases_->setColumnWidth(3, 20 * kSpace);
  phases_->setMinimumHeight(170);
  phases_->setTabKeyNavigation(false);
  connect(groups_, &QListWidget::currentRowChanged, this, &CurriculumEditor::showGroup);
  connect(groupLabel_, &QLineEdit::textEdited, this, &CurriculumEditor::takeGroup);
  connect(rest_, &QDoubleSpinBox::valueChanged, this, &CurriculumEditor::takeGroup);
  connect(splittable_, &QCheckBox::toggled, this, &CurriculumEditor::takeGroup);
  connect(phases_, &QTableWidget::itemChanged, this, &CurriculumEditor::takeGroup);
  connect(addPhase_, &QPushButton::clicked, this, &CurriculumEditor::addPhase);
  connect(removePhase_, &QPushButton::clicked, this, &CurriculumEditor::removePhase);
  return beside(groups_, {}, form);
}

QWidget* CurriculumEditor::pointsTab() {
  points_->verticalHeader()->setVisible(false);
  points_->horizontalHeader()->setStretchLastSection(true);
  points_->setTabKeyNavigation(false);
  connect(points_, &QTableWidget::itemChanged, this, &CurriculumEditor::takePoints);
  return points_;
}

void CurriculumEditor::setContent(const StoredCurriculumVersion& content) {
  content_ = content;
  fillExercises();
  fillGroups();
  fillPoints();
  judge();
}

void CurriculumEditor::setReadOnly(bool readOnly) {
  for (int tab = 0; tab + 1 < count(); ++tab) widget(tab)->setEnabled(!readOnly);
}

StoredModule* CurriculumEditor::exercise() {
  const int row = exercises_->currentRow();
  return row >= 0 && row < std::ssize(content_.modules) ? &content_.modules[static_cast<std::size_t>(row)]
                                                        : nullptr;
}

StoredArm* CurriculumEditor::group() {
  const int row = groups_->currentRow();
  return row >= 0 && row < std::ssize(content_.arms) ? &content_.arms[static_cast<std::size_t>(row)]
                                                     : nullptr;
}

void CurriculumEditor::fillExercises() {
  const int before = std::max(0, exercises_->currentRow());
  filling_ = true;
  exercises_->clear();
  for (const StoredModule& module : content_.modules)
    exercises_->addItem(QStringLiteral("%1  %2").arg(shown(module.code), shown(module.title)));
  filling_ = false;
  exercises_->setCurrentRow(std::min(before, exercises_->count() - 1));
  showExercise();
}

void CurriculumEditor::showExercise() {
  if (filling_) return;
  const StoredModule* module = exercise();
  removeExercise_->setEnabled(module != nullptr);
  if (module == nullptr) return;
  filling_ = true;
  title_->setText(shown(module->title));
  choose(scene_, module->sceneId);
  pattern_->clear();
  try {
    for (const std::string& id : patternIds(assets_, module->sceneId))
      pattern_->addItem(shown(id), shown(id));
  } catch (const Error&) {
    // The scene belongs to another installation: its own pattern is offered alone, the check says the rest.
  }
  choose(pattern_, module->patternId);
  kind_->clear();
  for (const std::string& kind : exerciseKinds()) kind_->addItem(exerciseKindName(kind), shown(kind));
  choose(kind_, module->exerciseKind);
  mode_->setCurrentIndex(mode_->findData(shown(module->mode)));
  target_->setValue(module->targetAngle_rad / kDegree);
  tolerance_->setValue(module->tolerance_rad / kDegree);
  hold_->setValue(static_cast<double>(module->hold_us) / kSecond_us);
  attempts_->setValue(static_cast<int>(module->attemptLimit.value_or(0)));
  after_->clear();
  after_->addItem(tr("nothing"), QString());
  for (const StoredModule& other : content_.modules)
    if (&other != module) after_->addItem(shown(other.title), shown(other.code));
  choose(after_, module->requires_.empty() ? std::string() : module->requires_.front());
  const bool rule = !module->mastery.empty();
  choose(metric_, rule ? module->mastery.front().metric : std::string());
  threshold_->setValue(rule ? module->mastery.front().threshold : 0.0);
  consecutive_->setValue(rule ? static_cast<int>(module->mastery.front().consecutive) : 1);
  threshold_->setEnabled(rule);
  consecutive_->setEnabled(rule);
  filling_ = false;
}

void CurriculumEditor::takeExercise() {
  StoredModule* module = exercise();
  if (filling_ || module == nullptr) return;
  const std::string sceneBefore = module->sceneId;
  module->title = title_->text().trimmed().toStdString();
  module->sceneId = chosenId(scene_);
  module->patternId = chosenId(pattern_);
  module->exerciseKind = chosenId(kind_);
  module->mode = chosenId(mode_);
  module->targetAngle_rad = target_->value() * kDegree;
  module->tolerance_rad = tolerance_->value() * kDegree;
  module->hold_us = static_cast<std::int64_t>(hold_->value() * kSecond_us);
  module->attemptLimit =
      attempts_->value() > 0 ? std::optional<std::int64_t>(attempts_->value()) : std::nullopt;
  const std::string after = chosenId(after_);
  module->requires_ = after.empty() ? std::vector<std::string>{} : std::vector<std::string>{after};
  const std::string metric = chosenId(metric_);
  if (metric.empty()) {
    module->mastery.clear();
  } else {
    if (module->mastery.empty()) module->mastery.emplace_back();
    StoredMasteryRule& rule = module->mastery.front();
    if (rule.metric != metric) {
      rule.comparison = metricBetter(metric);
      rule.unit = metricUnit(metric);
    }
    rule.metric = metric;
    rule.threshold = threshold_->value();
    rule.consecutive = consecutive_->value();
  }
  if (module->sceneId != sceneBefore) {
    const std::vector<std::string> patterns = patternIds(assets_, module->sceneId);
    module->patternId = patterns.empty() ? std::string() : patterns.front();
  }
  exercises_->currentItem()->setText(QStringLiteral("%1  %2").arg(shown(module->code), shown(module->title)));
  showExercise();
  changed();
}

void CurriculumEditor::addExercise() {
  StoredModule module = content_.modules.empty() ? StoredModule{} : content_.modules.back();
  int number = static_cast<int>(content_.modules.size()) + 1;
  const auto taken = [&](const std::string& wanted) {
    return std::any_of(content_.modules.begin(), content_.modules.end(),
                       [&](const StoredModule& known) { return known.code == wanted; });
  };
  const auto code = [&] { return QStringLiteral("V%1").arg(number).toStdString(); };
  while (taken(code())) ++number;
  module.code = code();
  module.id = module.code;
  module.title = tr("New exercise").toStdString();
  module.requires_.clear();
  if (module.sceneId.empty()) {
    module.sceneId = sceneIds(assets_).front();
    module.patternId = patternIds(assets_, module.sceneId).front();
    module.exerciseKind = exerciseKinds().front();
    module.targetAngle_rad = 60.0 * kDegree;
    module.tolerance_rad = 5.0 * kDegree;
  }
  content_.modules.push_back(module);
  fillExercises();
  exercises_->setCurrentRow(exercises_->count() - 1);
  changed();
}

void CurriculumEditor::removeExercise() {
  const int row = exercises_->currentRow();
  if (row < 0) return;
  content_.modules.erase(content_.modules.begin() + row);
  fillExercises();
  changed();
}

void CurriculumEditor::fillGroups() {
  const int before = std::max(0, groups_->currentRow());
  filling_ = true;
  groups_->clear();
  for (const StoredArm& arm : content_.arms)
    groups_->addItem(QStringLiteral("%1  %2").arg(shown(arm.code), shown(arm.label)));
  filling_ = false;
  groups_->setCurrentRow(std::min(before, groups_->count() - 1));
  showGroup();
}

void CurriculumEditor::showGroup() {
  if (filling_) return;
  const StoredArm* arm = group();
  for (QPushButton* button : {addPhase_, removePhase_}) button->setEnabled(arm != nullptr);
  if (arm == nullptr) return;
  filling_ = true;
  groupLabel_->setText(shown(arm->label));
  rest_->setValue(static_cast<double>(arm->restAllowance_us) / kMinute_us);
  splittable_->setChecked(arm->restSplittable);
  for (int row = 0; row < phases_->rowCount(); ++row)
    for (const int column : {0, 3})
      if (QWidget* before = phases_->cellWidget(row, column)) before->hide();  // it goes a moment later
  phases_->setRowCount(static_cast<int>(arm->phases.size()));
  for (int row = 0; row < phases_->rowCount(); ++row) {
    const StoredPhase& phase = arm->phases[static_cast<std::size_t>(row)];
    auto* kind = new QComboBox;
    for (const char* code : {"virtual", "real"})
      kind->addItem(phaseKindName(code), QString::fromLatin1(code));
    kind->setCurrentIndex(phase.kind == "real" ? 1 : 0);
    auto* module = new QComboBox;
    module->addItem(tr("any exercise"), QString());
    for (const StoredModule& known : content_.modules) module->addItem(shown(known.title), shown(known.code));
    choose(module, phase.moduleId);
    phases_->setCellWidget(row, 0, kind);
    phases_->setItem(row, 1, new QTableWidgetItem(shown(phase.label)));
    phases_->setItem(
        row, 2, new QTableWidgetItem(QString::number(static_cast<double>(phase.duration_us) / kMinute_us)));
    phases_->setCellWidget(row, 3, module);
    for (QComboBox* box : {kind, module})
      connect(box, &QComboBox::activated, this, &CurriculumEditor::takeGroup);
  }
  filling_ = false;
}

void CurriculumEditor::takeGroup() {
  StoredArm* arm = group();
  if (filling_ || arm == nullptr) return;
  arm->label = groupLabel_->text().trimmed().toStdString();
  arm->restAllowance_us = static_cast<std::int64_t>(rest_->value() * kMinute_us);
  arm->restSplittable = splittable_->isChecked();
  for (int row = 0; row < phases_->rowCount(); ++row) {
    StoredPhase& phase = arm->phases[static_cast<std::size_t>(row)];
    phase.kind = chosenId(qobject_cast<QComboBox*>(phases_->cellWidget(row, 0)));
    phase.label = phases_->item(row, 1)->text().trimmed().toStdString();
    phase.duration_us = static_cast<std::int64_t>(phases_->item(row, 2)->text().toDouble() * kMinute_us);
    phase.moduleId = chosenId(qobject_cast<QComboBox*>(phases_->cellWidget(row, 3)));
  }
  groups_->currentItem()->setText(QStringLiteral("%1  %2").arg(shown(arm->code), shown(arm->label)));
  changed();
}

void CurriculumEditor::addPhase() {
  StoredArm* arm = group();
  if (arm == nullptr) return;
  StoredPhase phase;
  phase.label = tr("New phase").toStdString();
  phase.duration_us = static_cast<std::int64_t>(20.0 * kMinute_us);
  arm->phases.push_back(phase);
  showGroup();
  changed();
}

void CurriculumEditor::removePhase() {
  StoredArm* arm = group();
  const int row = phases_->currentRow() >= 0 ? phases_->currentRow() : phases_->rowCount() - 1;
  if (arm == nullptr || row < 0) return;
  arm->phases.erase(arm->phases.begin() + row);
  showGroup();
  changed();
}

void CurriculumEditor::fillPoints() {
  filling_ = true;
  points_->setRowCount(static_cast<int>(content_.scoringPoints.size()));
  for (int row = 0; row < points_->rowCount(); ++row) {
    const StoredScoringPoint& point = content_.scoringPoints[static_cast<std::size_t>(row)];
    auto* name = new QTableWidgetItem(scoringPointName(point.code));
    name->setFlags(name->flags() & ~Qt::ItemIsEditable);
    points_->setItem(row, 0, name);
    points_->setItem(
        row, 1,
        new QTableWidgetItem(QString::number(static_cast<double>(point.afterExposure_us) / kMinute_us)));
  }
  filling_ = false;
}

void CurriculumEditor::takePoints() {
  if (filling_) return;
  for (int row = 0; row < points_->rowCount(); ++row)
    content_.scoringPoints[static_cast<std::size_t>(row)].afterExposure_us =
        static_cast<std::int64_t>(points_->item(row, 1)->text().toDouble() * kMinute_us);
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
        tr("%1 %2. %3.").arg(shown(problem.where), shown(problem.what), shown(problem.remedy)));
  if (problems_.empty()) problemList_->addItem(tr("\u2713 Nothing is missing: this can be published."));
  setTabText(3, problems_.empty() ? tr("Check: complete")
                                  : tr("Check: %n to mend", nullptr, static_cast<int>(problems_.size())));
}

void CurriculumEditor::retranslate() {
  setTabText(0, tr("Exercises"));
  setTabText(1, tr("Groups and phases"));
  setTabText(2, tr("Scoring points"));
  const QStringList names = {tr("Title"),
                             tr("Organ"),
                             tr("Twist"),
                             tr("Task"),
                             tr("Counts as"),
                             tr("Target angle"),
                             tr("Tolerance"),
                             tr("Hold for"),
                             tr("Attempts at most"),
                             tr("Only after"),
                             tr("Mastered when"),
                             tr("reaches"),
                             tr("times in a row"),
                             tr("Name of the group"),
                             tr("Rest, minutes"),
                             tr("Phases")};
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    labels_[i]->setText(names.value(static_cast<qsizetype>(i)));
    if (labels_[i]->buddy() != nullptr) labels_[i]->buddy()->setAccessibleName(labels_[i]->text());
  }
  attempts_->setSpecialValueText(tr("no limit"));
  splittable_->setText(tr("The rest may be taken in parts"));
  mode_->clear();
  mode_->addItem(tr("practice"), QStringLiteral("practice"));
  mode_->addItem(tr("graded"), QStringLiteral("graded"));
  metric_->clear();
  metric_->addItem(tr("not judged"), QString());
  for (const auto& [id, name] : masteryMetrics()) metric_->addItem(name, shown(id));
  addExercise_->setText(tr("Add"));
  removeExercise_->setText(tr("Remove"));
  addPhase_->setText(tr("Add phase"));
  removePhase_->setText(tr("Remove phase"));
  phases_->setHorizontalHeaderLabels({tr("Where"), tr("Name"), tr("Minutes"), tr("Exercise")});
  points_->setHorizontalHeaderLabels({tr("Scoring point"), tr("After minutes of training")});
  showExercise();
  showGroup();
  fillPoints();
  judge();
}

}  // namespace torsio::gui
