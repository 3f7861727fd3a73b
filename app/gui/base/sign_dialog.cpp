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

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/signing.h"

namespace torsio::gui {

namespace {

constexpr int kDialogWidth = 440;

/// Asks for the password: the sentence to sign, the password, and the last error.
class SignDialog : public QDialog {
  Q_DECLARE_TR_FUNCTIONS(SignDialog)

 public:
  SignDialog(QWidget* parent, ShellContext& shell, const QString& meaning)
      : QDialog(parent), shell_(shell), password_(secretField(this)), wrong_(sentence(this, false)) {
    setObjectName(QStringLiteral("signDialog"));
    setWindowTitle(tr("Sign"));
    setMinimumWidth(kDialogWidth);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
    column->setSpacing(kSpace);
    QLabel* said = sentence(this, false);
    said->setObjectName(QStringLiteral("meaning"));
    said->setProperty("subheading", true);
    said->setText(tr("\u201C%1\u201D").arg(meaning));
    QLabel* kept = sentence(this);
    kept->setText(tr("You sign this as %1. Your name, the time and this meaning are kept with it for good.")
                      .arg(toQString(shell.session().actor().login)));
    column->addWidget(said);
    column->addWidget(kept);
    column->addSpacing(kSpace);
    password_->setObjectName(QStringLiteral("password"));
    nameField(addField(column, password_), tr("Your &password"));
    wrong_->setObjectName(QStringLiteral("wrong"));
    setLook(wrong_, "caution", true);
    wrong_->hide();
    column->addWidget(wrong_);
    column->addSpacing(kSpace);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    QPushButton* sign = buttons->addButton(tr("&Sign"), QDialogButtonBox::AcceptRole);
    sign->setObjectName(QStringLiteral("sign"));
    sign->setProperty("primary", true);
    sign->setDefault(true);
    const auto whetherTyped = [this, sign] { sign->setEnabled(!password_->text().isEmpty()); };
    connect(password_, &QLineEdit::textChanged, this, whetherTyped);
    whetherTyped();
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
    adjustSize();  // a wrapping sentence requests no height by itself
    password_->clear();
    password_->setFocus();
  }

  ShellContext& shell_;
  QLineEdit* password_;
  QLabel* wrong_;
};

}  // namespace

bool readyToSign(QWidget* parent, ShellContext& shell, SignatureMeaning meaning) {
  bool due = true;
  if (!attempt(shell, [&] { due = passwordIsDue(shell.session()); })) {
    return false;
  }
  return !due || SignDialog(parent, shell, toQString(labelOf(meaning))).exec() == QDialog::Accepted;
}

}  // namespace torsio::gui
