// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/person_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kOldestAge = 100;
constexpr int kDialogWidth = 460;

/// The fields of askPerson().
class PersonDialog : public QDialog {
  Q_DECLARE_TR_FUNCTIONS(PersonDialog)

 public:
  PersonDialog(QWidget* parent, const std::optional<PersonEntry>& present,
               const std::vector<SeniorityClass>& classes)
      : QDialog(parent), change_(present.has_value()) {
    setWindowTitle(change_ ? tr("Change a person") : tr("New person"));
    setMinimumWidth(kDialogWidth);
    fill(classes);
    if (present) {
      set(*present);
    }
    layOut();
    check();
  }

  [[nodiscard]] PersonEdit get() const {
    PersonEdit edit;
    edit.entry.fullName = name_->text().trimmed().toStdString();
    edit.entry.externalId = number_->text().trimmed().toStdString();
    edit.entry.email = email_->text().trimmed().toStdString();
    edit.entry.sex = sex_->currentData().toString().toStdString();
    edit.entry.level = level_->text().trimmed().toStdString();
    edit.entry.experience = experience_->text().trimmed().toStdString();
    if (age_->value() > 0) {
      edit.entry.age_years = age_->value();
    }
    edit.entry.trainee = trainee_->isChecked();
    if (edit.entry.trainee) {
      edit.entry.handedness = handedness_->currentData().toString().toStdString();
    }
    edit.entry.raterClass = raterClass_->currentData().toString().toStdString();
    edit.reason = reason_->text().trimmed().toStdString();
    return edit;
  }

 private:
  void fill(const std::vector<SeniorityClass>& classes) {
    for (QComboBox* choice : {sex_, handedness_}) {
      choice->addItem(tr("not known"), QString());
    }
    for (const Term<Sex>& term : kSexes) {
      sex_->addItem(toQString(term.label), toQString(std::string(term.stored)));
    }
    for (const Term<Handedness>& term : kHandednesses) {
      handedness_->addItem(toQString(term.label), toQString(std::string(term.stored)));
    }
    raterClass_->addItem(tr("does not score"), QString());
    for (const SeniorityClass& raterClass : classes) {
      raterClass_->addItem(toQString(Text(raterClass.label)), toQString(raterClass.code));
    }
    age_->setRange(0, kOldestAge);
    age_->setSpecialValueText(tr("not known"));
    trainee_->setText(tr("&Trains"));
    trainee_->setChecked(true);
    for (const auto& [field, object] :
         {std::pair<QWidget*, const char*>{name_, "name"}, {number_, "number"}, {reason_, "reason"}}) {
      field->setObjectName(QLatin1String(object));
    }
  }

  void set(const PersonEntry& entry) {
    name_->setText(toQString(entry.fullName));
    number_->setText(toQString(entry.externalId));
    email_->setText(toQString(entry.email));
    sex_->setCurrentIndex(sex_->findData(toQString(entry.sex)));
    level_->setText(toQString(entry.level));
    experience_->setText(toQString(entry.experience));
    age_->setValue(static_cast<int>(entry.age_years.value_or(0)));
    trainee_->setChecked(entry.trainee);
    trainee_->setEnabled(!entry.trainee);  // roles can be added, but not removed
    handedness_->setCurrentIndex(handedness_->findData(toQString(entry.handedness)));
    raterClass_->setCurrentIndex(raterClass_->findData(toQString(entry.raterClass)));
  }

  void layOut() {
    auto* form = new QFormLayout;
    form->addRow(tr("&Full name"), name_);
    checks_->addNeeded(form, name_, tr("Enter the full name."));
    form->addRow(tr("&Number"), number_);
    form->addRow(tr("&E-mail"), email_);
    form->addRow(tr("Se&x"), sex_);
    form->addRow(tr("&Level"), level_);
    form->addRow(tr("Ex&perience"), experience_);
    form->addRow(tr("&Age"), age_);
    form->addRow(QString(), trainee_);
    form->addRow(tr("&Handedness"), handedness_);
    form->addRow(tr("S&cores as"), raterClass_);
    checks_->add(form, raterClass_, [this] {
      return trainee_->isChecked() || !raterClass_->currentData().toString().isEmpty()
                 ? QString()
                 : tr("Choose a class here, or tick that the person trains.");
    });
    if (change_) {
      form->addRow(tr("&Reason for the change"), reason_);
      checks_->addNeeded(form, reason_, reasonWanted());
    }
    reason_->setVisible(change_);
    auto* buttons = new QDialogButtonBox(this);
    accept_ = buttons->addButton(change_ ? tr("Save") : tr("Add person"), QDialogButtonBox::AcceptRole);
    accept_->setDefault(true);
    buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    checks_->decide(accept_);
    connect(trainee_, &QCheckBox::toggled, this, [this] { check(); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
    column->setSpacing(2 * kSpace);
    column->addLayout(form);
    column->addWidget(buttons);
  }

  void check() {
    handedness_->setEnabled(trainee_->isChecked());
    checks_->check();
  }

  bool change_;
  QLineEdit* name_ = new QLineEdit(this);
  QLineEdit* number_ = new QLineEdit(this);
  QLineEdit* email_ = new QLineEdit(this);
  QComboBox* sex_ = new QComboBox(this);
  QLineEdit* level_ = new QLineEdit(this);
  QLineEdit* experience_ = new QLineEdit(this);
  QSpinBox* age_ = new QSpinBox(this);
  QCheckBox* trainee_ = new QCheckBox(this);
  QComboBox* handedness_ = new QComboBox(this);
  QComboBox* raterClass_ = new QComboBox(this);
  QLineEdit* reason_ = new QLineEdit(this);
  FieldChecks* checks_ = new FieldChecks(this);
  QPushButton* accept_ = nullptr;
};

}  // namespace

std::optional<PersonEdit> askPerson(QWidget* parent, const std::optional<PersonEntry>& present,
                                    const std::vector<SeniorityClass>& classes) {
  PersonDialog dialog(parent, present, classes);
  if (dialog.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  return dialog.get();
}

}  // namespace torsio::gui
