// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/password_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "assessment/domain/people/password_rule.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr int kPasswordWidth = 460;

}  // namespace

PasswordPanel::PasswordPanel(QWidget* parent) : QWidget(parent) {
  QVBoxLayout* column = centredCard(this, kPasswordWidth);
  heading_ = new QLabel(this);
  heading_->setProperty("heading", true);
  why_ = sentence(this);
  old_ = secretField(this);
  new_ = secretField(this);
  again_ = secretField(this);
  code_ = named(new QLineEdit(this), "code");
  column->addWidget(heading_);
  column->addWidget(why_);
  column->addSpacing(kSpace);
  oldLabel_ = addField(column, old_);
  newLabel_ = addField(column, new_);
  againLabel_ = addField(column, again_);
  codeLabel_ = addField(column, code_);
  answer_ = sentence(this, false);
  column->addWidget(answer_);
  column->addSpacing(kSpace);
  back_ = linkButton(this);
  save_ = primaryButton(this);
  auto* row = new QHBoxLayout;
  row->addWidget(back_);
  row->addStretch(1);
  row->addWidget(save_);
  column->addLayout(row);
  for (QLineEdit* field : {old_, new_, again_, code_}) {
    connect(field, &QLineEdit::textChanged, this, &PasswordPanel::check);
    connect(field, &QLineEdit::returnPressed, this, &PasswordPanel::goOn);
  }
  connect(save_, &QPushButton::clicked, this, &PasswordPanel::submit);
  connect(back_, &QPushButton::clicked, this, &PasswordPanel::givenUp);
  retranslate();
}

void PasswordPanel::begin(const QString& login, const QString& oldPassword, bool forced, bool asksCode) {
  login_ = login;
  known_ = oldPassword;
  forced_ = forced;
  for (QLineEdit* field : {old_, new_, again_, code_}) {
    field->clear();
  }
  codeLabel_->setVisible(asksCode);
  code_->setVisible(asksCode);
  oldLabel_->setVisible(known_.isEmpty());
  old_->setVisible(known_.isEmpty());
  retranslate();
  check();
  (known_.isEmpty() ? old_ : new_)->setFocus();
}

void PasswordPanel::say(const QString& text) {
  setLook(answer_, "caution", !text.isEmpty());
  answer_->setText(text);
}

void PasswordPanel::setWorking(bool working) {
  working_ = working;
  check();
}

void PasswordPanel::check() {
  QString problem;
  bool sound = false;
  const QString password = new_->text();
  if (!password.isEmpty()) {
    try {
      checkPassword(password.toStdString(), login_.toStdString());
      sound = again_->text() == password;
      if (!again_->text().isEmpty() && !sound) {
        problem = tr("The two are not the same yet");
      }
    } catch (const Error& error) {
      problem = translatedLine(error);
    }
  }
  say(problem);
  const bool proven = (!known_.isEmpty() || !old_->text().isEmpty()) &&
                      (code_->isHidden() || !code_->text().trimmed().isEmpty());
  save_->setEnabled(sound && !working_ && proven);
}

void PasswordPanel::goOn() {
  for (QLineEdit* field : {old_, new_, again_, code_}) {
    if (field->isVisibleTo(this) && field->text().isEmpty()) {
      field->setFocus();
      return;
    }
  }
  submit();
}

void PasswordPanel::submit() {
  if (!save_->isEnabled()) {
    return;
  }
  const QString old = known_.isEmpty() ? old_->text() : known_;
  Q_EMIT chosen({.login = login_.toStdString(),
                 .oldPassword = old.toStdString(),
                 .newPassword = new_->text().toStdString(),
                 .code = code_->text().trimmed().toStdString()});
}

void PasswordPanel::retranslate() {
  heading_->setText(tr("Choose a new password"));
  why_->setText(
      forced_ ? tr("An administrator set your password. Choose your own: at least fifteen characters, a "
                   "short sentence for example.")
              : tr("At least fifteen characters, a short sentence for example. Nothing else is asked for."));
  nameField(oldLabel_, tr("&Present password"));
  nameField(newLabel_, tr("&New password"));
  nameField(againLabel_, tr("Repeat p&assword"));
  nameField(codeLabel_, tr("&Code from your app, or a recovery code"));
  back_->setText(forced_ ? tr("Back to sign-in") : tr("Cancel"));
  save_->setText(tr("Save password"));
}

void PasswordPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    check();
  }
  QWidget::changeEvent(event);
}

}  // namespace torsio::gui
