// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/exercise_editor.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/administrator/administrator_parts.h"
#include "app/gui/administrator/study_labels.h"
#include "app/gui/base/asset_names.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/simulator/exercise_panel.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "assessment/study/curriculum.h"
#include "sim/base/angle.h"
#include "sim/base/error.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

namespace {

constexpr double kFirstTarget_deg = 60.0;
constexpr double kFirstTolerance_deg = 5.0;
constexpr int kMostAttempts = 1'000'000;
constexpr int kFewRows = 2;

enum RuleColumn { kMetric, kDirection, kThreshold, kInARow };

std::vector<std::string> codesOf(const CurriculumVersion& content) {
  std::vector<std::string> codes;
  for (const TrainingModule& module : content.modules) {
    codes.push_back(module.code);
  }
  return codes;
}

QString lineOf(const TrainingModule& module) {
  return QStringLiteral("%1  %2").arg(toQString(module.code), toQString(Text(module.title)));
}

/// A scene or a pattern as people call it: "small_bowel" is "small bowel".
QString placeName(const std::string& id) {
  return assetName(ExercisePanel::readable(id));
}

}  // namespace

ExerciseEditor::ExerciseEditor(std::filesystem::path assets, CurriculumVersion& content, QWidget* parent)
    : QWidget(parent),
      assets_(std::move(assets)),
      content_(content),
      title_(new QLineEdit),
      scene_(new QComboBox),
      pattern_(new QComboBox),
      kind_(new QComboBox),
      mode_(new QComboBox),
      target_(numberField(-3600.0, 3600.0, 1)),
      tolerance_(numberField(0.0, 3600.0, 1)),
      hold_(numberField(0.0, 1e6, 1)),
      force_(numberField(0.0, 1e6, 2)),
      torque_(numberField(0.0, 1e6, 3)),
      attempts_(new QSpinBox),
      after_(new QListWidget),
      mastery_(new QTableWidget(0, 4)),
      addRule_(new QPushButton),
      removeRule_(new QPushButton) {
  after_->setObjectName(QStringLiteral("prerequisites"));
  after_->setProperty("checkable", true);  // the look: a check mark stands at the item's very edge
  mastery_->setObjectName(QStringLiteral("mastery"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  list_ = new OrderedList(QStringLiteral("exercises"), form(), this);
  column->addWidget(list_);
  connectFields();
  connectLists();
}

QWidget* ExerciseEditor::form() {
  auto* fields = new QWidget;
  auto* form = new QFormLayout(fields);
  form->setSpacing(kSpace);
  form->setContentsMargins(0, 0, kSpace, 0);
  texts_.row(form, {{title_, QT_TR_NOOP("Title")}, {code_.field(), QT_TR_NOOP("Code")}});
  form->addRow(QString(), code_.problem());
  texts_.row(form, {{scene_, QT_TR_NOOP("Organ")}, {pattern_, QT_TR_NOOP("Twist")}});
  texts_.row(form, {{kind_, QT_TR_NOOP("Task")}, {mode_, QT_TR_NOOP("Counts as")}});
  texts_.row(form, {{target_, QT_TR_NOOP("Target angle")},
                    {tolerance_, QT_TR_NOOP("Tolerance")},
                    {hold_, QT_TR_NOOP("Hold for")}});
  texts_.row(form, {{force_, QT_TR_NOOP("Force up to")},
                    {torque_, QT_TR_NOOP("Torque up to")},
                    {attempts_, QT_TR_NOOP("Attempts")}});
  target_->setSuffix(QStringLiteral("\u00B0"));
  tolerance_->setSuffix(QStringLiteral("\u00B0"));
  hold_->setSuffix(QStringLiteral(" s"));
  force_->setSuffix(QStringLiteral(" N"));
  torque_->setSuffix(QStringLiteral(" N m"));
  attempts_->setRange(0, kMostAttempts);
  attempts_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  texts_.title(form, QT_TR_NOOP("Opens only after these are mastered"));
  form->addRow(after_);
  texts_.title(form, QT_TR_NOOP("Mastered when all of these are reached"));
  prepareFieldTable(mastery_);
  mastery_->horizontalHeader()->setSectionResizeMode(kMetric, QHeaderView::Stretch);
  mastery_->setColumnWidth(kDirection, 15 * kSpace);
  for (const int column : {kThreshold, kInARow}) {
    mastery_->setColumnWidth(column, 10 * kSpace);
  }
  form->addRow(mastery_);
  form->addRow(buttonRow({addRule_, removeRule_}));
  return fields;
}

void ExerciseEditor::connectFields() {
  connect(code_.field(), &QLineEdit::editingFinished, this, &ExerciseEditor::takeCode);
  connect(title_, &QLineEdit::textEdited, this, [this](const QString& text) {
    take([&](TrainingModule& module) { module.title = text.trimmed().toStdString(); });
  });
  connect(scene_, &QComboBox::activated, this, &ExerciseEditor::takeScene);
  const auto choice = [this](QComboBox* box, std::string TrainingModule::*field) {
    connect(box, &QComboBox::activated, this,
            [=, this] { take([=](TrainingModule& module) { module.*field = chosenId(box); }); });
  };
  choice(pattern_, &TrainingModule::patternId);
  choice(kind_, &TrainingModule::exerciseKind);
  connect(mode_, &QComboBox::activated, this, [this] {
    take([this](TrainingModule& module) {
      module.mode = fromStoredText<AttemptMode>(chosenId(mode_)).value_or(module.mode);
    });
  });
  const auto angle = [this](QDoubleSpinBox* box, double TrainingModule::*field) {
    connect(box, &QDoubleSpinBox::valueChanged, this, [=, this](double value) {
      take([=](TrainingModule& module) { module.*field = radians(value); });
    });
  };
  angle(target_, &TrainingModule::targetAngle_rad);
  angle(tolerance_, &TrainingModule::tolerance_rad);
  connect(hold_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    take([=](TrainingModule& module) { module.hold_us = std::llround(value * kMicrosecondsOfSecond); });
  });
  const auto limit = [this](QDoubleSpinBox* box, std::optional<double> TrainingModule::*field) {
    connect(box, &QDoubleSpinBox::valueChanged, this, [=, this](double value) {
      take([=](TrainingModule& module) {
        module.*field = value > 0.0 ? std::optional<double>(value) : std::nullopt;
      });
    });
  };
  limit(force_, &TrainingModule::maxForce_N);
  limit(torque_, &TrainingModule::maxTorque_Nm);
  connect(attempts_, &QSpinBox::valueChanged, this, [this](int value) {
    take([=](TrainingModule& module) {
      module.attemptLimit = value > 0 ? std::optional<std::int64_t>(value) : std::nullopt;
    });
  });
}

void ExerciseEditor::connectLists() {
  connect(list_, &OrderedList::chosen, this, &ExerciseEditor::showContent);
  connect(list_, &OrderedList::addWanted, this, &ExerciseEditor::add);
  connect(list_, &OrderedList::removeWanted, this, &ExerciseEditor::remove);
  connect(list_, &OrderedList::moveWanted, this, &ExerciseEditor::move);
  connect(after_, &QListWidget::itemChanged, this, &ExerciseEditor::takePrerequisite);
  connect(addRule_, &QPushButton::clicked, this, &ExerciseEditor::addRule);
  connect(removeRule_, &QPushButton::clicked, this, &ExerciseEditor::removeRule);
}

TrainingModule* ExerciseEditor::exercise() {
  return list_->chosenOf(content_.modules);
}

QStringList ExerciseEditor::lines() const {
  QStringList lines;
  for (const TrainingModule& module : content_.modules) {
    lines << lineOf(module);
  }
  return lines;
}

void ExerciseEditor::fill() {
  select(std::max(0, list_->row()));
}

void ExerciseEditor::select(int row) {
  list_->setLines(lines(), row);
  showContent();
}

void ExerciseEditor::showContent() {
  if (filling_) {
    return;
  }
  const TrainingModule* module = exercise();
  const bool change = module != nullptr && !readOnly_;
  addRule_->setEnabled(change);
  for (QWidget* field :
       std::initializer_list<QWidget*>{title_, code_.field(), scene_, pattern_, kind_, mode_, target_,
                                       tolerance_, hold_, force_, torque_, attempts_, after_, mastery_}) {
    field->setEnabled(change);
  }
  if (module == nullptr) {
    code_.show({});
    removeRule_->setEnabled(false);
    return;
  }
  filling_ = true;
  code_.show(module->code);
  title_->setText(toQString(module->title));
  showPlaces(*module);
  target_->setValue(degrees(module->targetAngle_rad));
  tolerance_->setValue(degrees(module->tolerance_rad));
  hold_->setValue(static_cast<double>(module->hold_us) / kMicrosecondsOfSecond);
  force_->setValue(module->maxForce_N.value_or(0.0));
  torque_->setValue(module->maxTorque_Nm.value_or(0.0));
  attempts_->setValue(static_cast<int>(module->attemptLimit.value_or(0)));
  showPrerequisites(*module);
  showMastery(*module);
  filling_ = false;
}

void ExerciseEditor::showPlaces(const TrainingModule& module) {
  scene_->clear();
  for (const std::string& id : sceneIds(assets_)) {
    scene_->addItem(placeName(id), toQString(id));
  }
  chooseOrAdd(scene_, module.sceneId);
  pattern_->clear();
  try {
    for (const std::string& id : patternIds(assets_, module.sceneId)) {
      pattern_->addItem(placeName(id), toQString(id));
    }
  } catch (const Error&) {
    // The scene belongs to another installation: its own pattern is offered alone, the check says the rest.
  }
  chooseOrAdd(pattern_, module.patternId);
  kind_->clear();
  for (const std::string& kind : exerciseKinds()) {
    kind_->addItem(exerciseKindName(kind), toQString(kind));
  }
  chooseOrAdd(kind_, module.exerciseKind);
  chooseOrAdd(mode_, std::string(storedText(module.mode)));
}

void ExerciseEditor::showPrerequisites(const TrainingModule& module) {
  after_->clear();
  const auto offer = [this](const QString& text, const std::string& code, bool required) {
    auto* item = new QListWidgetItem(text, after_);
    item->setData(Qt::UserRole, toQString(code));
    item->setFlags((item->flags() | Qt::ItemIsUserCheckable) & ~Qt::ItemIsSelectable);
    item->setCheckState(required ? Qt::Checked : Qt::Unchecked);
  };
  const std::vector<std::string>& required = module.requires_;
  for (const TrainingModule& other : content_.modules) {
    if (&other != &module) {
      offer(lineOf(other), other.code,
            std::find(required.begin(), required.end(), other.code) != required.end());
    }
  }
  // One that was removed meanwhile stays in sight until somebody takes its mark away.
  const std::vector<std::string> known = codesOf(content_);
  for (const std::string& code : required) {
    if (code == module.code || std::find(known.begin(), known.end(), code) == known.end()) {
      offer(tr("%1  (no such exercise any more)").arg(toQString(code)), code, true);
    }
  }
  constexpr int kMostRows = 3;  // in a low window; a high one shows more
  const int rows = std::clamp(after_->count(), 1, kMostRows);
  after_->setMinimumHeight(rows * std::max(after_->sizeHintForRow(0), 3 * kSpace) + 2 * kSpace);
}

void ExerciseEditor::showMastery(const TrainingModule& module) {
  for (int row = 0; row < mastery_->rowCount(); ++row) {
    for (int column = 0; column < mastery_->columnCount(); ++column) {
      if (QWidget* before = mastery_->cellWidget(row, column)) {
        before->hide();  // it goes a moment later
      }
    }
  }
  mastery_->setRowCount(static_cast<int>(module.mastery.size()));
  for (int row = 0; row < mastery_->rowCount(); ++row) {
    addMasteryRow(row, module.mastery[static_cast<std::size_t>(row)]);
  }
  fitRows(mastery_, kFewRows);
  removeRule_->setEnabled(!readOnly_ && !module.mastery.empty());
}

void ExerciseEditor::addMasteryRow(int row, const MasteryCriterion& rule) {
  auto* metric = new QComboBox;
  for (const auto& [id, name] : masteryMetrics()) {
    metric->addItem(name, toQString(id));
  }
  chooseOrAdd(metric, rule.metric);
  auto* direction = new QComboBox;
  direction->addItem(tr("at least"), QStringLiteral("at_least"));
  direction->addItem(tr("at most"), QStringLiteral("at_most"));
  chooseOrAdd(direction, rule.comparison);
  QDoubleSpinBox* threshold = numberField(-1e9, 1e9, 4);
  threshold->setValue(rule.threshold);
  auto* inARow = new QSpinBox;
  inARow->setRange(1, kMostAttempts);
  inARow->setValue(static_cast<int>(rule.consecutive));
  inARow->setButtonSymbols(QAbstractSpinBox::NoButtons);
  mastery_->setCellWidget(row, kMetric, metric);
  mastery_->setCellWidget(row, kDirection, direction);
  mastery_->setCellWidget(row, kThreshold, threshold);
  mastery_->setCellWidget(row, kInARow, inARow);
  metric->setAccessibleName(tr("What rule %1 is about").arg(row + 1));
  direction->setAccessibleName(tr("Direction of rule %1").arg(row + 1));
  threshold->setAccessibleName(tr("Threshold of rule %1").arg(row + 1));
  inARow->setAccessibleName(tr("Attempts in a row of rule %1").arg(row + 1));
  connect(metric, &QComboBox::activated, this, [this, metric] {
    takeRule(metric, [metric](MasteryCriterion& changed) {
      if (changed.metric == chosenId(metric)) {
        return;
      }
      changed.metric = chosenId(metric);
      changed.comparison = metricBetter(changed.metric);
      changed.unit = metricUnit(changed.metric);
    });
    if (const TrainingModule* module = exercise()) {
      filling_ = true;
      showMastery(*module);
      filling_ = false;
    }
  });
  connect(direction, &QComboBox::activated, this, [this, direction] {
    takeRule(direction, [direction](MasteryCriterion& changed) { changed.comparison = chosenId(direction); });
  });
  connect(threshold, &QDoubleSpinBox::valueChanged, this, [this, threshold](double value) {
    takeRule(threshold, [value](MasteryCriterion& changed) { changed.threshold = value; });
  });
  connect(inARow, &QSpinBox::valueChanged, this, [this, inARow](int value) {
    takeRule(inARow, [value](MasteryCriterion& changed) { changed.consecutive = value; });
  });
}

void ExerciseEditor::take(const std::function<void(TrainingModule&)>& change) {
  TrainingModule* module = exercise();
  if (filling_ || module == nullptr) {
    return;
  }
  change(*module);
  list_->setCurrentLine(lineOf(*module));
  Q_EMIT edited();
}

void ExerciseEditor::takeRule(const QWidget* cell, const std::function<void(MasteryCriterion&)>& change) {
  const int row = rowOf(mastery_, cell);
  take([&](TrainingModule& module) {
    if (row >= 0 && row < std::ssize(module.mastery)) {
      change(module.mastery[static_cast<std::size_t>(row)]);
    }
  });
}

void ExerciseEditor::takeCode() {
  const TrainingModule* current = exercise();
  if (filling_ || current == nullptr) {
    return;
  }
  const std::string before = current->code;
  const std::optional<std::string> code = code_.changed(
      before, codesOf(content_), tr("An exercise needs a code; it keeps %1.").arg(toQString(before)),
      tr("Another exercise has this code; this one keeps %1.").arg(toQString(before)));
  if (!code) {
    return;
  }
  for (TrainingModule& module : content_.modules) {
    std::replace(module.requires_.begin(), module.requires_.end(), before, *code);
  }
  for (StudyArm& arm : content_.arms) {
    for (TrainingPhase& phase : arm.phases) {
      if (phase.moduleId == before) {
        phase.moduleId = *code;
      }
    }
  }
  take([&](TrainingModule& module) { module.code = module.id = *code; });
}

void ExerciseEditor::takeScene() {
  take([this](TrainingModule& module) {
    if (module.sceneId == chosenId(scene_)) {
      return;
    }
    module.sceneId = chosenId(scene_);
    const std::vector<std::string> patterns = patternIds(assets_, module.sceneId);
    module.patternId = patterns.empty() ? std::string() : patterns.front();
  });
  showContent();
}

void ExerciseEditor::takePrerequisite(const QListWidgetItem* item) {
  const std::string code = item->data(Qt::UserRole).toString().toStdString();
  const bool wanted = item->checkState() == Qt::Checked;
  take([&](TrainingModule& module) {
    std::erase(module.requires_, code);
    if (wanted) {
      module.requires_.push_back(code);
    }
  });
}

void ExerciseEditor::add() {
  // The next exercise is most often like the one before it, but harder.
  TrainingModule module = exercise() != nullptr ? *exercise() : TrainingModule{};
  module.code = freeCode("V", codesOf(content_));
  module.id = module.code;
  module.title = tr("New exercise").toStdString();
  module.requires_.clear();
  if (module.sceneId.empty()) {
    module.sceneId = sceneIds(assets_).front();
    module.patternId = patternIds(assets_, module.sceneId).front();
    module.exerciseKind = exerciseKinds().front();
    module.targetAngle_rad = radians(kFirstTarget_deg);
    module.tolerance_rad = radians(kFirstTolerance_deg);
  }
  content_.modules.push_back(std::move(module));
  select(static_cast<int>(content_.modules.size()) - 1);
  title_->setFocus();
  title_->selectAll();
  Q_EMIT edited();
}

void ExerciseEditor::remove() {
  const int row = list_->row();
  if (row < 0) {
    return;
  }
  content_.modules.erase(content_.modules.begin() + row);
  select(row);
  Q_EMIT edited();
}

void ExerciseEditor::move(int by) {
  const int row = list_->row();
  const int to = moved(content_.modules, row, by);
  if (to == row) {
    return;
  }
  select(to);
  Q_EMIT edited();
}

void ExerciseEditor::addRule() {
  take([](TrainingModule& module) {
    MasteryCriterion rule;
    for (const auto& metric : masteryMetrics()) {
      const bool used =
          std::any_of(module.mastery.begin(), module.mastery.end(),
                      [&](const MasteryCriterion& known) { return known.metric == metric.first; });
      if (used) {
        continue;
      }
      rule.metric = metric.first;
      break;
    }
    if (rule.metric.empty()) {
      return;  // every metric has its rule
    }
    rule.comparison = metricBetter(rule.metric);
    rule.unit = metricUnit(rule.metric);
    module.mastery.push_back(rule);
  });
  showContent();
  if (mastery_->rowCount() > 0) {
    mastery_->cellWidget(mastery_->rowCount() - 1, kMetric)->setFocus();
  }
}

void ExerciseEditor::removeRule() {
  const int row = mastery_->currentRow() >= 0 ? mastery_->currentRow() : mastery_->rowCount() - 1;
  take([row](TrainingModule& module) {
    if (row >= 0 && row < std::ssize(module.mastery)) {
      module.mastery.erase(module.mastery.begin() + row);
    }
  });
  showContent();
}

void ExerciseEditor::setReadOnly(bool readOnly) {
  readOnly_ = readOnly;
  list_->setReadOnly(readOnly);
  showContent();
}

void ExerciseEditor::retranslate() {
  texts_.retranslate(staticMetaObject.className());
  for (QDoubleSpinBox* box : {force_, torque_}) {
    box->setSpecialValueText(tr("no limit"));
  }
  attempts_->setSpecialValueText(tr("no limit"));
  mode_->clear();
  mode_->addItem(tr("practice"), toQString(std::string(storedText(AttemptMode::kPractice))));
  mode_->addItem(tr("graded"), toQString(std::string(storedText(AttemptMode::kGraded))));
  list_->retranslate();
  list_->setListName(tr("Exercises, in their order"));
  after_->setAccessibleName(tr("Opens only after these are mastered"));
  mastery_->setAccessibleName(tr("Rules of mastery"));
  addRule_->setText(tr("Add rule"));
  removeRule_->setText(tr("Remove rule"));
  mastery_->setHorizontalHeaderLabels({tr("Metric"), tr("is"), tr("Threshold"), tr("In a row")});
  showContent();
}

}  // namespace torsio::gui
