// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/credentials_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QVBoxLayout>

#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

CredentialsDialog::CredentialsDialog(const QString& title, const QString& why, QWidget* parent)
    : QDialog(parent), login_(new QLineEdit(this)), password_(secretField(this)) {
  setWindowTitle(title);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  QLabel* reason = sentence(this);
  reason->setText(why);
  column->addWidget(reason);
  nameField(addField(column, login_), tr("Sign-in &name"));
  nameField(addField(column, password_), tr("&Password"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
}

QString CredentialsDialog::login() const {
  return login_->text().trimmed();
}

QString CredentialsDialog::password() const {
  return password_->text();
}

}  // namespace torsio::gui
