// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/sign_dialog.h"

#include <QApplication>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/access/signing.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"

namespace torsio::gui {

namespace {

/// The sentence that is signed, the password, and what was wrong with the last one.
class SignDialog : public QDialog {
  Q_DECLARE_TR_FUNCTIONS(SignDialog)

 public:
  SignDialog(QWidget* parent, ShellContext& shell, const QString& meaning)
      : QDialog(parent), shell_(shell), password_(secretField(this)), wrong_(sentence(this, false)) {
    setObjectName(QStringLiteral("signDialog"));
    setWindowTitle(tr("Sign"));
    auto* column = new QVBoxLayout(this);
    QLabel* said = sentence(this, false);
    said->setTextFormat(Qt::PlainText);
    said->setText(
        tr("You sign as %1: \u201C%2\u201D").arg(toQString(shell.session().actor().login), meaning));
    column->addWidget(said);
    password_->setObjectName(QStringLiteral("password"));
    nameField(addField(column, password_), tr("Your &password"));
    wrong_->setObjectName(QStringLiteral("wrong"));
    setLook(wrong_, "caution", true);
    wrong_->hide();
    column->addWidget(wrong_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    QPushButton* sign = buttons->addButton(tr("&Sign"), QDialogButtonBox::AcceptRole);
    sign->setObjectName(QStringLiteral("sign"));
    sign->setProperty("primary", true);
    sign->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &SignDialog::check);
    connect(buttons, &QDialogButtonBox::rejected, this, &SignDialog::reject);
    column->addWidget(buttons);
    password_->setFocus();
  }

 private:
  void check() {
    QApplication::setOverrideCursor(Qt::WaitCursor);
    try {
      showPassword(shell_.session(), password_->text().toStdString());
      QApplication::restoreOverrideCursor();
      accept();
      return;
    } catch (const Error& error) {
      QApplication::restoreOverrideCursor();
      wrong_->setText(translatedLine(error));
    }
    wrong_->show();
    password_->selectAll();
    password_->setFocus();
  }

  ShellContext& shell_;
  QLineEdit* password_;
  QLabel* wrong_;
};

}  // namespace

QString labelOf(SignatureMeaning meaning) {
  return toQString(Text(termsOf(meaning)[static_cast<std::size_t>(meaning)].label));
}

bool readyToSign(QWidget* parent, ShellContext& shell, const QString& meaning) {
  bool due = true;
  if (!attempt(shell, [&] { due = passwordIsDue(shell.session()); })) {
    return false;
  }
  return !due || SignDialog(parent, shell, meaning).exec() == QDialog::Accepted;
}

}  // namespace torsio::gui
