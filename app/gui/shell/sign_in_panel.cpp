// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/sign_in_panel.h"

#include <QClipboard>
#include <QDateTime>
#include <QEvent>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/gui/widgets/window_events.h"
#include "app/services/maintenance/anchor.h"
#include "sim/core/time_units.h"

namespace torsio::gui {

HeadNotice::HeadNotice(QWidget* parent)
    : QWidget(parent),
      heading_(new QLabel(this)),
      facts_(sentence(this, false)),
      hash_(new QLabel(this)),
      where_(sentence(this)),
      copy_(linkButton(this)) {
  setObjectName(QStringLiteral("headNotice"));
  heading_->setProperty("subheading", true);
  hash_->setObjectName(QStringLiteral("headHash"));
  hash_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  hash_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  where_->setProperty("small", true);
  copy_->setObjectName(QStringLiteral("copyHead"));
  auto* column = bareLayout<QVBoxLayout>(this, kSpace / 2);
  auto* top = new QHBoxLayout;
  top->addWidget(heading_);
  top->addStretch(1);
  top->addWidget(copy_);
  column->addLayout(top);
  for (QLabel* label : {facts_, hash_, where_}) {
    column->addWidget(label);
  }
  connect(copy_, &QPushButton::clicked, this, [this] {
    QGuiApplication::clipboard()->setText(toQString(head_.line));
    copy_->setText(tr("Copied"));
  });
  hide();
}

void HeadNotice::tell(const LeftHead& head) {
  head_ = head;
  retranslate();
  show();
}

void HeadNotice::forget() {
  head_ = {};
  hide();
}

void HeadNotice::retranslate() {
  if (head_.line.empty()) {
    return;
  }
  const AnchoredHead head = readHead(head_.line);
  const QDateTime time = QDateTime::fromMSecsSinceEpoch(head.utc_us / 1000, Qt::UTC);
  heading_->setText(tr("Checkpoint of the audit trail"));
  facts_->setText(tr("%Ln entry(s), %1 UTC, %2", nullptr, static_cast<int>(head.length))
                      .arg(QStringLiteral("%1 %2").arg(dateText(time.date()),
                                                       time.time().toString(QStringLiteral("HH:mm:ss"))),
                           head.isSigned() ? tr("signed") : tr("not signed")));
  const QString hash = toQString(head.hash);
  hash_->setText(hash.left(hash.size() / 2) + QLatin1Char('\n') + hash.mid(hash.size() / 2));
  hash_->setAccessibleName(tr("Hash of the newest entry: %1").arg(hash));
  if (!head_.trouble.str().empty()) {
    where_->setText(tr("The checkpoint was not saved. %1").arg(toQString(head_.trouble)));
  } else if (!head_.witness.empty()) {
    where_->setText(
        tr("It was added to the witness file of this station: %1").arg(toQString(head_.witness.string())));
  } else {
    where_->setText(
        tr("This station keeps no checkpoints. Copy the checkpoint or write it down and keep it away from "
           "the record: it "
           "shows later whether the trail was truncated or rewritten."));
  }
  if (!head_.noStamp.empty()) {
    where_->setText(where_->text() + QLatin1Char('\n') +
                    tr("It has no time stamp. %1").arg(toQString(head_.noStamp)));
  }
  setLook(where_, "caution", !head_.trouble.str().empty() || !head_.noStamp.empty());
  copy_->setText(tr("&Copy the checkpoint"));
}

void HeadNotice::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
  }
  QWidget::changeEvent(event);
}

namespace {

constexpr int kSignInWidth = 420;
constexpr int kSecond_ms = 1000;

}  // namespace

SignInPanel::SignInPanel(QWidget* parent) : QWidget(parent) {
  QVBoxLayout* column = centredCard(this, kSignInWidth);
  auto* name = new QLabel(QStringLiteral("Torsio"), this);
  name->setProperty("figure", true);
  centre_ = sentence(this);
  heading_ = new QLabel(this);
  heading_->setProperty("subheading", true);
  code_ = secretField(this);
  code_->setObjectName(QStringLiteral("cardCode"));
  login_ = new QLineEdit(this);
  secret_ = secretField(this);
  column->addWidget(name);
  column->addWidget(centre_);
  column->addSpacing(2 * kSpace);
  column->addWidget(heading_);
  column->addSpacing(kSpace);
  codeLabel_ = addField(column, code_);
  column->addSpacing(4);
  loginLabel_ = addField(column, login_);
  column->addSpacing(4);
  secretLabel_ = addField(column, secret_);
  column->addSpacing(kSpace);
  enter_ = primaryButton(this);
  answer_ = sentence(this, false);
  column->addWidget(enter_);
  column->addWidget(answer_);
  head_ = new HeadNotice(this);
  column->addWidget(head_);
  column->addSpacing(kSpace);
  mode_ = linkButton(this);
  guest_ = linkButton(this);
  guestNote_ = sentence(this);
  guestNote_->setProperty("small", true);
  tool_ = sentence(this);
  tool_->setProperty("small", true);
  auto* ways = new QVBoxLayout;
  ways->setSpacing(0);
  ways->addWidget(mode_, 0, Qt::AlignLeft);
  ways->addWidget(guest_, 0, Qt::AlignLeft);
  column->addLayout(ways);
  column->addWidget(guestNote_);
  column->addSpacing(2 * kSpace);
  column->addWidget(tool_);
  language_ = linkButton(this);
  leaveKiosk_ = linkButton(this);
  leaveKiosk_->hide();
  auto* lowest = new QHBoxLayout;
  lowest->addWidget(language_);
  lowest->addStretch(1);
  lowest->addWidget(leaveKiosk_);
  column->addLayout(lowest);
  connect(language_, &QPushButton::clicked, this, [this] { Q_EMIT languageWanted(otherLanguage()); });
  connect(leaveKiosk_, &QPushButton::clicked, this, &SignInPanel::leaveKioskWanted);

  setCards(false);
  connect(code_, &QLineEdit::returnPressed, this, [this] {
    const QString code = code_->text().trimmed();
    code_->clear();
    if (!code.isEmpty() && !working_ && wait_s_ == 0) {
      say(tr("Checking\u2026"), false);
      Q_EMIT codeGiven(code);
    }
  });
  connect(enter_, &QPushButton::clicked, this, &SignInPanel::submit);
  connect(login_, &QLineEdit::returnPressed, this, [this] { secret_->setFocus(); });
  connect(secret_, &QLineEdit::returnPressed, this, &SignInPanel::submit);
  connect(mode_, &QPushButton::clicked, this, [this] { setPinMode(!pinMode_); });
  connect(guest_, &QPushButton::clicked, this, &SignInPanel::guestChosen);
  for (QLineEdit* field : {login_, secret_}) {
    connect(field, &QLineEdit::textChanged, this, &SignInPanel::enableForm);
  }
  second_.setInterval(kSecond_ms);
  connect(&second_, &QTimer::timeout, this, &SignInPanel::countDown);
  followLanguage(this, [this] {
    say({}, false);
    retranslate();
  });
  enableForm();
}

void SignInPanel::setCentre(const QString& name) {
  centre_->setText(name);
  centre_->setVisible(!name.isEmpty());
}

void SignInPanel::say(const QString& text, bool caution) {
  setLook(answer_, "caution", caution);
  answer_->setText(text);
}

void SignInPanel::tellHead(const std::optional<LeftHead>& head) {
  if (!head) {
    return;
  }
  if (head->line.empty()) {
    say(tr("The checkpoint of the audit trail was not kept: %1").arg(toQString(head->trouble)), true);
    return;
  }
  head_->tell(*head);
}

void SignInPanel::waitUntil(std::int64_t utc_us, std::int64_t now_us) {
  wait_s_ = static_cast<int>((utc_us - now_us + kSecond_us - 1) / kSecond_us) + 1;
  second_.start();
  countDown();
}

void SignInPanel::countDown() {
  if (--wait_s_ > 0) {
    say(tr("Too many wrong tries. Please wait %1").arg(clockTime(wait_s_ * kSecond_us)), true);
  } else {
    second_.stop();
    wait_s_ = 0;
    say(tr("You may try again now"), false);
  }
  enableForm();
}

void SignInPanel::setWorking(bool working) {
  working_ = working;
  enableForm();
  // Focus left the fields while they were disabled.
  if (!working && isVisible()) {
    chooseField();
  }
}

Language SignInPanel::otherLanguage() {
  return QLocale().language() == QLocale::Chinese ? Language::kEnglish : Language::kSimplifiedChinese;
}

void SignInPanel::setKiosk(bool kiosk) {
  leaveKiosk_->setVisible(kiosk);
}

void SignInPanel::setCards(bool cards) {
  code_->setVisible(cards);
  codeLabel_->setVisible(cards);
}

void SignInPanel::clear() {
  code_->clear();
  second_.stop();
  wait_s_ = 0;
  login_->clear();
  secret_->clear();
  say({}, false);
  head_->forget();
  setPinMode(false);
}

void SignInPanel::setPinMode(bool pin) {
  pinMode_ = pin;
  secret_->clear();
  retranslate();
  chooseField();
}

void SignInPanel::chooseField() {
  if (!code_->isHidden() && !pinMode_ && login_->text().isEmpty()) {
    code_->setFocus();
    return;
  }
  (login_->text().isEmpty() ? login_ : secret_)->setFocus();
}

void SignInPanel::submit() {
  if (!enter_->isEnabled()) {
    return;
  }
  const QString login = login_->text().trimmed();
  const QString secret = secret_->text();
  secret_->clear();
  say(tr("Checking\u2026"), false);
  if (pinMode_) {
    Q_EMIT pinGiven(login, secret);
  } else {
    Q_EMIT passwordGiven(login, secret);
  }
}

void SignInPanel::enableForm() {
  const bool open = !working_ && wait_s_ == 0;
  for (QLineEdit* field : {login_, secret_, code_}) {
    field->setEnabled(!working_);
  }
  enter_->setEnabled(open && !login_->text().trimmed().isEmpty() && !secret_->text().isEmpty());
  mode_->setEnabled(!working_);
  guest_->setEnabled(!working_);
  language_->setEnabled(!working_);  // a hasty key press would end up there
}

void SignInPanel::retranslate() {
  heading_->setText(pinMode_ ? tr("Practice with your PIN") : tr("Sign in"));
  nameField(codeLabel_, tr("Hold your &card to the scanner, or type its code"));
  nameField(loginLabel_, tr("Sign-in &name"));
  nameField(secretLabel_, pinMode_ ? tr("Station &PIN") : tr("&Password"));
  enter_->setText(pinMode_ ? tr("Practise") : tr("Sign in"));
  mode_->setText(pinMode_ ? tr("Sign in with the password") : tr("Practise with a PIN"));
  guest_->setText(tr("Practise as a guest"));
  guestNote_->setText(tr("With a PIN or as a guest nothing is recorded and nothing is scored."));
  language_->setText(languageName(otherLanguage()));
  leaveKiosk_->setText(tr("Leave kiosk mode\u2026"));
  tool_->setText(tr("A training tool, not a medical device. No patient data."));
}

void SignInPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  chooseField();
}

}  // namespace torsio::gui
