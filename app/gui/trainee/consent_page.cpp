// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/consent_page.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/widgets/card.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_heading.h"
#include "app/people/consent_service.h"
#include "app/training/run_session.h"

namespace torsio::gui {

namespace {

constexpr int kWidest = 860;
constexpr const char* kPurpose = "training_record";

}  // namespace

ConsentPage::ConsentPage(ShellContext& context, QWidget* parent) : Page(context, parent) {
  const PageColumn page = pageColumn(this, kWidest);
  heading_ = page.heading;
  card_ = new Card(QString(), this);
  text_ = plainLabel(card_);
  card_->content()->addWidget(text_);
  page.column->addWidget(card_);
  state_ = plainLabel(this, "quiet");
  page.column->addWidget(state_);
  understood_ = new QCheckBox(this);
  page.column->addWidget(understood_);
  agree_ = primaryButton(this);
  agree_->setObjectName(QStringLiteral("agree"));
  decline_ = new QPushButton(this);
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  row->addWidget(decline_);
  row->addWidget(agree_);
  page.column->addLayout(row);
  page.column->addStretch(1);
  connect(understood_, &QCheckBox::toggled, agree_, &QPushButton::setEnabled);
  connect(agree_, &QPushButton::clicked, this, [this] { decide(true); });
  connect(decline_, &QPushButton::clicked, this, [this] { decide(false); });
}

void ConsentPage::enter(const QVariant& argument) {
  then_ = argument.canConvert<PageId>() ? argument.value<PageId>() : PageId::kNextStep;
  understood_->setChecked(false);
  agree_->setEnabled(false);
  retranslate();
  understood_->setFocus();  // never a button that decides: Enter may still be on its way
}

void ConsentPage::readText() {
  const bool chinese = QLocale().language() == QLocale::Chinese;
  for (const ConsentText& text : consentTexts(shell().assets(), chinese ? "zh_CN" : "en")) {
    if (text.purpose != kPurpose) {
      continue;
    }
    version_ = text.version;
    card_->setTitle(toQString(text.title));
    text_->setText(toQString(text.text));
  }
}

void ConsentPage::retranslate() {
  heading_->setTexts(tr("Consent to the training record"),
                     tr("Nothing is recorded before you agree. You can withdraw later at any time."));
  understood_->setText(tr("I have &read and understood this"));
  agree_->setText(tr("I &agree"));
  decline_->setText(tr("&Not now"));
  attempt(shell(), [&] {
    readText();
    const bool given = hasOwnConsent(shell().session(), kPurpose);
    state_->setText(given ? tr("You have agreed before.") : tr("You have not agreed so far."));
    decline_->setText(given ? tr("&Withdraw") : tr("&Not now"));
  });
}

void ConsentPage::decide(bool granted) {
  attempt(shell(), [&] {
    decideOwnConsent(shell().session(), kPurpose, granted, version_);
    if (!granted) {
      shell().notify(tr("Nothing will be recorded. Free practice stays open."));
    }
    shell().open(granted ? then_ : PageId::kNextStep);
  });
}

}  // namespace torsio::gui
