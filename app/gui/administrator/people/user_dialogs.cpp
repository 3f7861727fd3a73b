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
#include <QFormLayout>
#include <QGroupBox>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
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
    return UserDialogs::tr("Physician who scores");
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
  auto* login = new QLineEdit(&dialog);
  login->setObjectName(QStringLiteral("login"));
  auto* person = new QComboBox(&dialog);
  person->addItem(UserDialogs::tr("Nobody of the record"), QString());
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
               ? UserDialogs::tr("Choose a person: whoever trains or scores is one of the record.")
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
  checks.decide(dialog.finish(UserDialogs::tr("Add user")));
  login->setFocus();
  if (dialog.exec() != QDialog::Accepted) {
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
  auto* reason = new QLineEdit(&dialog);
  reason->setObjectName(QStringLiteral("reason"));
  auto* form = new QFormLayout;
  form->addRow(UserDialogs::tr("&Reason"), reason);
  FieldChecks checks(&dialog);
  checks.add(dialog.column(), boxes, [boxes, roles] {
    return boxes->get() == roles ? UserDialogs::tr("These are the present roles.") : QString();
  });
  checks.addNeeded(form, reason, reasonWanted());
  dialog.column()->addLayout(form);
  checks.decide(dialog.finish(UserDialogs::tr("Change roles")));
  reason->setFocus();
  if (dialog.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  return RolesChange{boxes->get(), reason->text().trimmed().toStdString()};
}

}  // namespace torsio::gui
