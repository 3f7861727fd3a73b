// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/cohort_dialogs.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

CohortDialog::CohortDialog(const std::vector<CurriculumRow>& curricula, QWidget* parent)
    : QDialog(parent),
      name_(new QLineEdit(this)),
      description_(new QLineEdit(this)),
      curriculum_(new QComboBox(this)),
      groups_(new QLineEdit(this)),
      groupsLabel_(new QLabel(tr("&Groups"), this)),
      margin_(new QDoubleSpinBox(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)),
      checks_(new FieldChecks(this)) {
  name_->setObjectName(QStringLiteral("name"));
  setWindowTitle(tr("New cohort"));
  curriculum_->addItem(tr("none yet"), QString());
  for (const auto& [id, title] : runningVersions(curricula)) {
    curriculum_->addItem(title, toQString(id));
  }
  curriculum_->setCurrentIndex(curriculum_->count() > 1 ? 1 : 0);
  groups_->setPlaceholderText(tr("Group 1, Group 2, Group 3"));
  groupsLabel_->setBuddy(groups_);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  form->setSpacing(kSpace);
  form->addRow(tr("&Name"), name_);
  checks_->addNeeded(form, name_, tr("Enter a name for the cohort."));
  form->addRow(tr("&Description"), description_);
  form->addRow(tr("&Curriculum"), curriculum_);
  form->addRow(groupsLabel_, groups_);
  checks_->add(form, groups_, [this] {
    return chosenId(curriculum_).empty() && cohort().groups.empty()
               ? tr("Name the groups, with commas between, or choose a curriculum.")
               : QString();
  });
  margin_->setObjectName(QStringLiteral("margin"));
  margin_->setDecimals(2);
  margin_->setSingleStep(0.25);
  margin_->setRange(0.0, kLargestMargin);
  margin_->setSpecialValueText(tr("none planned"));
  margin_->setSuffix(tr(" points"));
  form->addRow(tr("Differences that do not &matter, up to"), margin_);
  auto* why = sentence(this);
  why->setText(
      tr("The report then tests whether groups are equal within it. It belongs to the plan: it cannot be "
         "changed later."));
  form->addRow(QString(), why);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("Create"));
  form->addRow(buttons_);
  name_->setMinimumWidth(360);
  checks_->decide(buttons_->button(QDialogButtonBox::Ok));
  connect(curriculum_, &QComboBox::currentIndexChanged, this, &CohortDialog::check);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  check();
}

void CohortDialog::check() {
  const bool byName = chosenId(curriculum_).empty();
  groups_->setVisible(byName);
  groupsLabel_->setVisible(byName);
  checks_->check();
}

NewCohort CohortDialog::cohort() const {
  NewCohort out;
  out.name = name_->text().trimmed().toStdString();
  out.description = description_->text().trimmed().toStdString();
  if (margin_->value() > 0.0) {
    out.equivalenceMargin = margin_->value();
  }
  out.curriculumVersionId = chosenId(curriculum_);
  if (!out.curriculumVersionId.empty()) {
    return out;
  }
  int number = 0;
  for (const QString& label : groups_->text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
    out.groups.push_back({QStringLiteral("G%1").arg(++number).toStdString(), label.trimmed().toStdString()});
  }
  return out;
}

std::vector<std::pair<std::string, QString>> runningVersions(const std::vector<CurriculumRow>& curricula) {
  std::vector<std::pair<std::string, QString>> out;
  for (const CurriculumRow& row : curricula) {
    for (auto version = row.versions.rbegin(); version != row.versions.rend(); ++version) {
      if (version->state == CurriculumState::kRunning) {
        out.emplace_back(version->id, CohortDialog::tr("%1, version %2")
                                          .arg(toQString(Text(row.curriculum.name)))
                                          .arg(version->number));
      }
    }
  }
  return out;
}

std::optional<std::string> askCohortName(QWidget* parent, const std::string& name) {
  QuestionDialog dialog(parent, CohortDialog::tr("Rename the cohort"),
                        CohortDialog::tr("Earlier reports keep the previous name."));
  auto* field = new QLineEdit(toQString(name), &dialog);
  field->setObjectName(QStringLiteral("name"));
  nameField(addField(dialog.column(), field), CohortDialog::tr("&Name"));
  FieldChecks checks(&dialog);
  checks.add(dialog.column(), field, [field, &name] {
    const std::string typed = field->text().trimmed().toStdString();
    return typed.empty()   ? CohortDialog::tr("Enter a name for the cohort.")
           : typed == name ? CohortDialog::tr("This is the present name.")
                           : QString();
  });
  checks.decide(dialog.finish(CohortDialog::tr("Rename")));
  if (dialog.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  return field->text().trimmed().toStdString();
}

std::optional<CohortStateChange> askCohortState(QWidget* parent, const QString& names, CohortState state) {
  QuestionDialog dialog(parent, CohortDialog::tr("Close or archive"), names);
  auto* step = new QComboBox(&dialog);
  step->setObjectName(QStringLiteral("step"));
  const auto offer = [step](CohortState next, const QString& text) {
    step->addItem(text, static_cast<int>(next));
  };
  if (state == CohortState::kRunning) {
    offer(CohortState::kClosed, CohortDialog::tr("close: no more training, enrolment, calls or new sheets"));
  } else {
    if (state == CohortState::kClosed) {
      offer(CohortState::kArchived, CohortDialog::tr("archive: closed and hidden from lists"));
    }
    offer(CohortState::kRunning, CohortDialog::tr("reopen: training and scoring as before"));
  }
  nameField(addField(dialog.column(), step), CohortDialog::tr("&Step"));
  auto* reason = new QLineEdit(&dialog);
  reason->setObjectName(QStringLiteral("reason"));
  nameField(addField(dialog.column(), reason), CohortDialog::tr("&Reason"));
  FieldChecks checks(&dialog);
  checks.add(dialog.column(), reason,
             [reason] { return reason->text().trimmed().isEmpty() ? reasonWanted() : QString(); });
  checks.decide(dialog.finish(CohortDialog::tr("Apply")));
  if (dialog.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  return CohortStateChange{static_cast<CohortState>(step->currentData().toInt()),
                           reason->text().trimmed().toStdString()};
}

std::optional<std::string> askCurriculum(QWidget* parent, const QString& names,
                                         const std::vector<CurriculumRow>& curricula) {
  const auto running = runningVersions(curricula);
  QStringList titles;
  for (const auto& [id, title] : running) {
    titles << title;
  }
  bool given = false;
  const QString title = QInputDialog::getItem(
      parent, CohortDialog::tr("Follow a curriculum"),
      CohortDialog::tr("The groups of %1 follow its arms in order.").arg(names), titles, 0, false, &given);
  if (!given) {
    return std::nullopt;
  }
  for (const auto& [id, known] : running) {
    if (known == title) {
      return id;
    }
  }
  return std::nullopt;
}

}  // namespace torsio::gui
