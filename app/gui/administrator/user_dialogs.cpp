// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/user_dialogs.h"

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
#include <QVBoxLayout>

#include "app/access/first_run.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr std::array kRoles = {"trainee", "rater", "administrator", "allocator", "statistician"};
constexpr int kDialogWidth = 440;

struct UserDialogs {
  Q_DECLARE_TR_FUNCTIONS(UserDialogs)
};

/// One box a role.
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
  [[nodiscard]] const std::vector<std::pair<std::string, QCheckBox*>>& boxes() const { return boxes_; }

 private:
  std::vector<std::pair<std::string, QCheckBox*>> boxes_;
};

/// A dialog with a column for its content and the two buttons below.
struct Frame {
  explicit Frame(QWidget* parent, const QString& title, const QString& accept)
      : dialog(parent), column(new QVBoxLayout(&dialog)) {
    dialog.setWindowTitle(title);
    dialog.setMinimumWidth(kDialogWidth);
    column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
    column->setSpacing(2 * kSpace);
    buttons = new QDialogButtonBox(&dialog);
    ok = buttons->addButton(accept, QDialogButtonBox::AcceptRole);
    ok->setDefault(true);
    cancel = buttons->addButton(UserDialogs::tr("Cancel"), QDialogButtonBox::RejectRole);
    cancel->setAutoDefault(false);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  }
  [[nodiscard]] bool run() {
    column->addWidget(buttons);
    if (first != nullptr) {
      first->setFocus();
    }
    return dialog.exec() == QDialog::Accepted;
  }

  QDialog dialog;
  QVBoxLayout* column;
  QDialogButtonBox* buttons = nullptr;
  QPushButton* ok = nullptr;
  QPushButton* cancel = nullptr;
  QWidget* first = nullptr;  ///< where typing begins
};

QLabel* sentence(QWidget* parent, const QString& text) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  label->setProperty("quiet", true);
  return label;
}

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
  Frame frame(parent, UserDialogs::tr("New user"), UserDialogs::tr("Add user"));
  auto* login = new QLineEdit(&frame.dialog);
  login->setObjectName(QStringLiteral("login"));
  frame.first = login;
  auto* person = new QComboBox(&frame.dialog);
  person->addItem(UserDialogs::tr("Nobody of the record"), QString());
  for (const PersonChoice& choice : people) {
    person->addItem(choice.label, toQString(choice.personId));
  }
  auto* form = new QFormLayout;
  form->addRow(UserDialogs::tr("&Sign-in name"), login);
  form->addRow(UserDialogs::tr("&Person"), person);
  frame.column->addLayout(form);
  auto* roles = new RoleBoxes(&frame.dialog);
  frame.column->addWidget(roles);
  frame.column->addWidget(
      sentence(&frame.dialog, UserDialogs::tr("Trainees and physicians need a person of the record. The "
                                              "start password is shown once, and must be changed at the "
                                              "first sign-in.")));
  const auto check = [&] {
    const std::vector<std::string> chosen = roles->get();
    const bool needsPerson = std::any_of(chosen.begin(), chosen.end(), [](const std::string& role) {
      return role == "trainee" || role == "rater";
    });
    frame.ok->setEnabled(!login->text().trimmed().isEmpty() && !chosen.empty() &&
                         (!needsPerson || !person->currentData().toString().isEmpty()));
  };
  QObject::connect(login, &QLineEdit::textChanged, &frame.dialog, check);
  QObject::connect(person, &QComboBox::currentIndexChanged, &frame.dialog, check);
  for (const auto& [role, box] : roles->boxes()) {
    QObject::connect(box, &QCheckBox::toggled, &frame.dialog, check);
  }
  check();
  if (!frame.run()) {
    return std::nullopt;
  }
  return NewUser{.login = login->text().trimmed().toStdString(),
                 .personId = person->currentData().toString().toStdString(),
                 .roles = roles->get(),
                 .startPassword = randomStartPassword()};
}

std::optional<RolesChange> askRoles(QWidget* parent, const QString& login,
                                    const std::vector<std::string>& roles) {
  Frame frame(parent, UserDialogs::tr("Roles of %1").arg(login), UserDialogs::tr("Change roles"));
  auto* boxes = new RoleBoxes(&frame.dialog);
  boxes->set(roles);
  frame.column->addWidget(boxes);
  auto* reason = new QLineEdit(&frame.dialog);
  reason->setObjectName(QStringLiteral("reason"));
  frame.first = reason;
  auto* form = new QFormLayout;
  form->addRow(UserDialogs::tr("&Reason"), reason);
  frame.column->addLayout(form);
  const auto check = [&] {
    frame.ok->setEnabled(!reason->text().trimmed().isEmpty() && boxes->get() != roles);
  };
  QObject::connect(reason, &QLineEdit::textChanged, &frame.dialog, check);
  for (const auto& [role, box] : boxes->boxes()) {
    QObject::connect(box, &QCheckBox::toggled, &frame.dialog, check);
  }
  check();
  if (!frame.run()) {
    return std::nullopt;
  }
  return RolesChange{boxes->get(), reason->text().trimmed().toStdString()};
}

void showStartPassword(QWidget* parent, const QString& login, const QString& password) {
  Frame frame(parent, UserDialogs::tr("Start password"), UserDialogs::tr("Done"));
  frame.column->addWidget(sentence(
      &frame.dialog,
      UserDialogs::tr(
          "Hand this start password to %1. It is shown only now, and must be changed at the first sign-in.")
          .arg(login)));
  auto* shown = new QLineEdit(password, &frame.dialog);
  shown->setObjectName(QStringLiteral("password"));
  shown->setReadOnly(true);
  shown->setAccessibleName(UserDialogs::tr("Start password"));
  frame.column->addWidget(shown);
  auto* copy = new QPushButton(UserDialogs::tr("&Copy"), &frame.dialog);
  QObject::connect(copy, &QPushButton::clicked, shown, [shown, copy] {
    QApplication::clipboard()->setText(shown->text());
    copy->setText(UserDialogs::tr("Copied"));
  });
  frame.column->addWidget(copy, 0, Qt::AlignLeft);
  // Another Enter, typed in haste, must not close what is shown only once.
  copy->setDefault(true);
  frame.ok->setAutoDefault(false);
  frame.cancel->hide();  // the password holds already
  frame.first = copy;
  static_cast<void>(frame.run());
}

std::optional<std::string> askReason(QWidget* parent, const QString& title, const QString& question) {
  Frame frame(parent, title, title);
  frame.column->addWidget(sentence(&frame.dialog, question));
  auto* reason = new QLineEdit(&frame.dialog);
  reason->setObjectName(QStringLiteral("reason"));
  frame.first = reason;
  auto* form = new QFormLayout;
  form->addRow(UserDialogs::tr("&Reason"), reason);
  frame.column->addLayout(form);
  const auto check = [&] { frame.ok->setEnabled(!reason->text().trimmed().isEmpty()); };
  QObject::connect(reason, &QLineEdit::textChanged, &frame.dialog, check);
  check();
  if (!frame.run()) {
    return std::nullopt;
  }
  return reason->text().trimmed().toStdString();
}

}  // namespace torsio::gui
