// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/lock_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kLockWidth = 420;

}  // namespace

LockPanel::LockPanel(QWidget* parent) : QWidget(parent) {
  QVBoxLayout* column = centredCard(this, kLockWidth);
  heading_ = new QLabel(this);
  heading_->setProperty("heading", true);
  why_ = sentence(this);
  secret_ = secretField(this);
  answer_ = sentence(this, false);
  setLook(answer_, "caution", true);
  unlock_ = primaryButton(this);
  signOut_ = linkButton(this);
  column->addWidget(heading_);
  column->addWidget(why_);
  column->addSpacing(kSpace);
  label_ = addField(column, secret_);
  column->addWidget(answer_);
  auto* row = new QHBoxLayout;
  row->addWidget(signOut_);
  row->addStretch(1);
  row->addWidget(unlock_);
  column->addLayout(row);
  const auto give = [this] {
    if (secret_->text().isEmpty() || !unlock_->isEnabled()) {
      return;
    }
    const QString password = secret_->text();
    secret_->clear();
    Q_EMIT passwordGiven(password);
  };
  connect(unlock_, &QPushButton::clicked, this, give);
  connect(secret_, &QLineEdit::returnPressed, this, give);
  connect(signOut_, &QPushButton::clicked, this, &LockPanel::signOutWanted);
  retranslate();
}

void LockPanel::begin(const QString& login) {
  login_ = login;
  secret_->clear();
  say({});
  setWorking(false);
  retranslate();
}

void LockPanel::say(const QString& text) {
  answer_->setText(text);
}

void LockPanel::setWorking(bool working) {
  unlock_->setEnabled(!working);
  secret_->setEnabled(!working);
  signOut_->setEnabled(!working);
  if (!working && isVisible()) {
    secret_->setFocus();  // when hidden, it would take the focus from the sign-in
  }
}

void LockPanel::retranslate() {
  heading_->setText(tr("Locked"));
  why_->setText(tr("%1 is signed in here. Nothing was lost; work continues where it was left.").arg(login_));
  nameField(label_, tr("&Password"));
  unlock_->setText(tr("Unlock"));
  signOut_->setText(tr("Sign out"));
}

void LockPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
  }
  QWidget::changeEvent(event);
}

void LockPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  secret_->setFocus();
}

}  // namespace torsio::gui
