// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/people/user_dialogs.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/first_run.h"

namespace torsio::gui {

namespace {

constexpr std::array kRoles = {"trainee", "rater", "administrator", "allocator", "statistician"};

struct UserDialogs {
  Q_DECLARE_TR_FUNCTIONS(UserDialogs)
};

/// One check box per role.
class RoleBoxes : public QGroupBox {
 public:
  explicit RoleBoxes(QWidget* parent) : QGroupBox(UserDialogs::tr("May work as"), parent) {
    auto* column = new QVBoxLayout(this);
    for (const char* role : kRoles) {
      auto* box = new QCheckBox(roleName(role), this);
      box->setObjectName(QLatin1String(role));
      column->addWidget(box);
      boxes_.emplace_back(role, box);
    }
  }

  void set(const std::vector<std::string>& roles) {
    for (const auto& [role, box] : boxes_) {
      box->setChecked(std::find(roles.begin(), roles.end(), role) != roles.end());
    }
  }
  [[nodiscard]] std::vector<std::string> get() const {
    std::vector<std::string> roles;
    for (const auto& [role, box] : boxes_) {
      if (box->isChecked()) {
        roles.push_back(role);
      }
    }
    return roles;
  }
  /// Returns whether a chosen role needs a person of the record.
  [[nodiscard]] bool needPerson() const {
    const std::vector<std::string> roles = get();
    return std::any_of(roles.begin(), roles.end(),
                       [](const std::string& role) { return role == "trainee" || role == "rater"; });
  }

 private:
  std::vector<std::pair<std::string, QCheckBox*>> boxes_;
};

}  // namespace

QString roleName(const std::string& code) {
  if (code == "trainee") {
    return UserDialogs::tr("Trainee");
  }
  if (code == "rater") {
    return UserDialogs::tr("Rater");
  }
  if (code == "administrator") {
    return UserDialogs::tr("Administrator");
  }
  if (code == "allocator") {
    return UserDialogs::tr("Allocator");
  }
  if (code == "statistician") {
    return UserDialogs::tr("Statistician");
  }
  return toQString(code);
}

std::optional<NewUser> askNewUser(QWidget* parent, const std::vector<PersonChoice>& people) {
  QuestionDialog dialog(parent, UserDialogs::tr("New user"));
  auto* login = named(new QLineEdit(&dialog), "login");
  auto* person = new QComboBox(&dialog);
  person->addItem(UserDialogs::tr("Not in the record"), QString());
  for (const PersonChoice& choice : people) {
    person->addItem(choice.label, toQString(choice.personId));
  }
  auto* form = new QFormLayout;
  auto* roles = new RoleBoxes(&dialog);
  FieldChecks checks(&dialog);
  form->addRow(UserDialogs::tr("&Sign-in name"), login);
  checks.addNeeded(form, login, UserDialogs::tr("Enter the name to sign in with."));
  form->addRow(UserDialogs::tr("&Person"), person);
  checks.add(form, person, [person, roles] {
    return roles->needPerson() && person->currentData().toString().isEmpty()
               ? UserDialogs::tr("Choose a person: everybody who trains or scores must be in the roster.")
               : QString();
  });
  dialog.column()->addLayout(form);
  dialog.column()->addWidget(roles);
  checks.add(dialog.column(), roles, [roles] {
    return roles->get().empty() ? UserDialogs::tr("Choose at least one role.") : QString();
  });
  dialog.addNote(
      UserDialogs::tr("Trainees and physicians need a person of the record. The "
                      "start password is shown once, and must be changed at the "
                      "first sign-in."));
  login->setFocus();
  if (!dialog.ask(UserDialogs::tr("Add user"), &checks)) {
    return std::nullopt;
  }
  return NewUser{.login = login->text().trimmed().toStdString(),
                 .personId = person->currentData().toString().toStdString(),
                 .roles = roles->get(),
                 .startPassword = randomStartPassword()};
}

std::optional<RolesChange> askRoles(QWidget* parent, const QString& login,
                                    const std::vector<std::string>& roles) {
  QuestionDialog dialog(parent, UserDialogs::tr("Roles of %1").arg(login));
  auto* boxes = new RoleBoxes(&dialog);
  boxes->set(roles);
  dialog.column()->addWidget(boxes);
  auto* reason = named(new QLineEdit(&dialog), "reason");
  auto* form = new QFormLayout;
  form->addRow(UserDialogs::tr("&Reason"), reason);
  FieldChecks checks(&dialog);
  checks.add(dialog.column(), boxes, [boxes, roles] {
    return boxes->get() == roles ? UserDialogs::tr("These are the present roles.") : QString();
  });
  checks.addNeeded(form, reason, reasonWanted());
  dialog.column()->addLayout(form);
  reason->setFocus();
  if (!dialog.ask(UserDialogs::tr("Change roles"), &checks)) {
    return std::nullopt;
  }
  return RolesChange{boxes->get(), reason->text().trimmed().toStdString()};
}

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
    QVBoxLayout* column = columnOf(this, {3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace}, 2 * kSpace);
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
