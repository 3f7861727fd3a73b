// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/curriculum/exercise_editor.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/curriculum/mastery_table.h"
#include "app/gui/base/scene_titles.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/load_decimals.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

namespace {

constexpr double kFirstTarget_deg = 60.0;
constexpr double kFirstTolerance_deg = 5.0;
constexpr int kMaxAttempts = 1'000'000;
constexpr int kMaxTwists = 1'000;

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

}  // namespace

ExerciseEditor::ExerciseEditor(std::filesystem::path assets, CurriculumVersion& content, QWidget* parent)
    : QWidget(parent),
      assets_(std::move(assets)),
      content_(content),
      title_(new QLineEdit),
      scene_(new QComboBox),
      pattern_(new QComboBox),
      mode_(new QComboBox),
      target_(numberField(-3600.0, 3600.0, 1)),
      tolerance_(numberField(0.0, 3600.0, 1)),
      hold_(numberField(0.0, 1e6, 1)),
      twists_(ranged(named(new QSpinBox, "leastTwists"), 1, kMaxTwists)),
      force_(numberField(0.0, 1e6, kForceDecimals)),
      torque_(numberField(0.0, 1e6, kTorqueDecimals)),
      attempts_(ranged(new QSpinBox, 0, kMaxAttempts)),
      after_(named(new QListWidget, "prerequisites")),
      mastery_(new MasteryTable) {
  after_->setProperty("checkable", true);  // style: aligns the check marks with the item's edge
  QVBoxLayout* column = columnOf(this, {});
  list_ = new OrderedList(QStringLiteral("exercises"), form(), this);
  column->addWidget(list_);
  connectFields();
  connectLists();
}

QWidget* ExerciseEditor::form() {
  auto* fields = new QWidget;
  auto* form = new QFormLayout(fields);
  form->setSpacing(kSpace);
  form->setContentsMargins(0, 0, 0, 0);
  texts_.row(form, {{title_, QT_TR_NOOP("Title")}, {code_.field(), QT_TR_NOOP("Code")}});
  form->addRow(QString(), code_.problem());
  hints_.add(form, CurriculumField::kCode);
  hints_.add(form, CurriculumField::kTitle);
  texts_.row(form, {{scene_, QT_TR_NOOP("Organ")}, {pattern_, QT_TR_NOOP("Twist")}});
  hints_.add(form, CurriculumField::kScene);
  texts_.row(form, mode_, QT_TR_NOOP("Counts as"));
  texts_.row(form, {{target_, QT_TR_NOOP("Target angle")},
                    {tolerance_, QT_TR_NOOP("Tolerance")},
                    {hold_, QT_TR_NOOP("Hold for")}});
  hints_.add(form, CurriculumField::kTarget);
  texts_.row(form, twists_, QT_TR_NOOP("Twists at least"));
  texts_.row(form, {{force_, QT_TR_NOOP("Force up to")},
                    {torque_, QT_TR_NOOP("Torque up to")},
                    {attempts_, QT_TR_NOOP("Attempts")}});
  hints_.add(form, CurriculumField::kLimits);
  target_->setSuffix(QStringLiteral("\u00B0"));
  tolerance_->setSuffix(QStringLiteral("\u00B0"));
  hold_->setSuffix(QStringLiteral(" s"));
  force_->setSuffix(QStringLiteral(" N"));
  torque_->setSuffix(QStringLiteral(" N m"));
  for (QSpinBox* count : {twists_, attempts_}) {
    count->setButtonSymbols(QAbstractSpinBox::NoButtons);
    count->setMinimumWidth(tolerance_->minimumWidth());
  }
  for (QComboBox* choice : {scene_, pattern_, mode_}) {
    choice->setMinimumWidth(2 * tolerance_->minimumWidth());
  }
  texts_.title(form, QT_TR_NOOP("Opens only after these are mastered"));
  form->addRow(after_);
  hints_.add(form, CurriculumField::kPrerequisites);
  texts_.title(form, QT_TR_NOOP("Mastered when all of these are reached"), mastery_->buttons());
  form->addRow(mastery_);
  hints_.add(form, CurriculumField::kMastery);
  fields->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);  // groups rows on a high screen
  return fields;
}

void ExerciseEditor::connectFields() {
  connect(code_.field(), &QLineEdit::editingFinished, this, &ExerciseEditor::takeCode);
  connect(title_, &QLineEdit::textEdited, this, [this](const QString& text) {
    take([&](TrainingModule& module) { module.title = text.trimmed().toStdString(); });
  });
  connect(scene_, &QComboBox::activated, this, &ExerciseEditor::takeScene);
  const auto choice = [this](QComboBox* box, auto TrainingModule::*field) {
    connect(box, &QComboBox::activated, this,
            [=, this] { take([=](TrainingModule& module) { module.*field = chosenId(box); }); });
  };
  choice(pattern_, &TrainingModule::patternId);
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
  connect(twists_, &QSpinBox::valueChanged, this,
          [this](int value) { take([=](TrainingModule& module) { module.leastTwists = value; }); });
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
  connect(mastery_, &MasteryTable::edited, this,
          [this] { take([this](TrainingModule& module) { module.mastery = mastery_->rules(); }); });
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

void ExerciseEditor::select(int row) {
  list_->setLines(lines(), row);
  showContent();
}

void ExerciseEditor::showContent() {
  if (filling_) {
    return;
  }
  showHints();
  const TrainingModule* module = exercise();
  const bool change = module != nullptr && !readOnly_;
  mastery_->setEditable(change);
  for (QWidget* field :
       std::initializer_list<QWidget*>{title_, code_.field(), scene_, pattern_, mode_, target_, tolerance_,
                                       hold_, twists_, force_, torque_, attempts_, after_}) {
    field->setEnabled(change);
  }
  if (module == nullptr) {
    code_.show({});
    mastery_->setRules({});
    return;
  }
  filling_ = true;
  code_.show(module->code);
  title_->setText(toQString(Text(module->title)));  // stored unchanged until edited
  showPlaces(*module);
  target_->setValue(degrees(module->targetAngle_rad));
  tolerance_->setValue(degrees(module->tolerance_rad));
  hold_->setValue(static_cast<double>(module->hold_us) / kMicrosecondsOfSecond);
  twists_->setValue(static_cast<int>(module->leastTwists));
  force_->setValue(module->maxForce_N.value_or(0.0));
  torque_->setValue(module->maxTorque_Nm.value_or(0.0));
  attempts_->setValue(static_cast<int>(module->attemptLimit.value_or(0)));
  showPrerequisites(*module);
  mastery_->setRules(module->mastery);
  filling_ = false;
}

void ExerciseEditor::showProblems(const std::vector<CurriculumProblem>& problems) {
  problems_ = problems;
  showHints();
}

void ExerciseEditor::showHints() {
  hints_.show(problems_, CurriculumSpot::Part::kModule, static_cast<std::size_t>(std::max(0, list_->row())));
}

void ExerciseEditor::showPlaces(const TrainingModule& module) {
  SceneTitles titles(assets_);
  scene_->clear();
  for (const std::string& id : sceneIds(assets_)) {
    scene_->addItem(titles.scene(id), toQString(id));
  }
  chooseOrAdd(scene_, module.sceneId);
  pattern_->clear();
  try {
    for (const std::string& id : patternIds(assets_, module.sceneId)) {
      pattern_->addItem(titles.pattern(module.sceneId, id), toQString(id));
    }
  } catch (const Error&) {
    // The scene is from another installation: offers only its own pattern; validation explains the rest.
  }
  chooseOrAdd(pattern_, module.patternId);
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
  const std::vector<ModuleId>& required = module.requires_;
  for (const TrainingModule& other : content_.modules) {
    if (&other != &module) {
      offer(lineOf(other), other.code,
            std::find(required.begin(), required.end(), other.code) != required.end());
    }
  }
  // A requirement that has been removed stays listed until it is unchecked.
  const std::vector<std::string> known = codesOf(content_);
  for (const std::string& code : required) {
    if (code == module.code || std::find(known.begin(), known.end(), code) == known.end()) {
      offer(tr("%1  (no such exercise any more)").arg(toQString(code)), code, true);
    }
  }
  constexpr int kMaxRows = 3;  // in a low window; a high one shows more rows, but no empty ones
  const int high = std::max(after_->sizeHintForRow(0), 3 * kSpace);
  const int frames = 2 * after_->frameWidth();
  after_->setMinimumHeight(std::clamp(after_->count(), 1, kMaxRows) * high + frames);
  after_->setMaximumHeight(std::max(after_->count(), 1) * high + frames);
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
  // The next exercise is usually a harder version of the previous one.
  TrainingModule module = exercise() != nullptr ? *exercise() : TrainingModule{};
  module.code = freeCode("V", codesOf(content_));
  module.id = module.code;
  module.title = tr("New exercise").toStdString();
  module.requires_.clear();
  if (module.sceneId.empty()) {
    module.sceneId = sceneIds(assets_).front();
    module.patternId = patternIds(assets_, module.sceneId).front();
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
  showOrder(list_->removeChosen(content_.modules));
}

void ExerciseEditor::move(int by) {
  showOrder(list_->moveChosen(content_.modules, by));
}

void ExerciseEditor::showOrder(std::optional<int> row) {
  if (row) {
    select(*row);
    Q_EMIT edited();
  }
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
  mastery_->retranslate();
  showContent();
}

}  // namespace torsio::gui
