// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/trainee/consent_page.h"

#include <algorithm>
#include <map>

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/language.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/people/consent_service.h"
#include "app/services/training/run_session.h"

namespace torsio::gui {

namespace {

constexpr int kWidest = 860;

const ConsentDecision* decisionAbout(const std::vector<ConsentDecision>& own, const std::string& purpose) {
  const auto found = std::find_if(own.begin(), own.end(),
                                  [&](const ConsentDecision& one) { return one.purpose == purpose; });
  return found == own.end() ? nullptr : &*found;
}

bool isGranted(const std::vector<ConsentDecision>& own, const std::string& purpose) {
  const ConsentDecision* decision = decisionAbout(own, purpose);
  return decision != nullptr && decision->granted;
}

}  // namespace

ConsentPage::ConsentPage(ShellContext& context, QWidget* parent) : Page(context, parent) {
  const PageColumn page = pageColumn(this, kWidest);
  heading_ = page.heading;
  card_ = new Card(QString(), this);
  text_ = plainLabel(card_);
  card_->content()->addWidget(text_);
  page.column->addWidget(card_);
  othersCard_ = new Card(QString(), this);
  othersText_ = plainLabel(othersCard_, "quiet");
  othersCard_->content()->addWidget(othersText_);
  othersColumn_ = new QVBoxLayout;
  othersColumn_->setSpacing(kSpace);
  othersCard_->content()->addLayout(othersColumn_);
  page.column->addWidget(othersCard_);
  state_ = plainLabel(this, "quiet");
  page.column->addWidget(state_);
  understood_ = named(new QCheckBox(this), "understood");
  page.column->addWidget(understood_);
  agree_ = named(primaryButton(this), "agree");
  decline_ = named(new QPushButton(this), "decline");
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  row->addWidget(decline_);
  row->addWidget(agree_);
  page.column->addLayout(row);
  ownRecord_ = new OwnRecordCard(context, this);
  page.column->addWidget(ownRecord_);
  page.column->addStretch(1);
  connect(understood_, &QCheckBox::toggled, agree_, &QPushButton::setEnabled);
  connect(agree_, &QPushButton::clicked, this, [this] { decide(true); });
  connect(decline_, &QPushButton::clicked, this, [this] { decide(false); });
}

void ConsentPage::enter(const QVariant& argument) {
  then_ = argument.canConvert<PageId>() ? argument.value<PageId>() : PageId::kNextStep;
  understood_->setChecked(false);
  agree_->setEnabled(false);
  others_.clear();
  retranslate();
  ownRecord_->read();
  understood_->setFocus();  // never a deciding button, because a late Enter would press it
}

void ConsentPage::readTexts() {
  asked_ = askedConsent(shell().session(), shell().assets());
  own_ = ownConsents(shell().session());
  const ConsentWords& words = wordsIn(asked_, languageCode(presentLanguage()).toStdString());
  for (const ConsentText& text : words.texts) {
    if (text.purpose == kTrainingRecord) {
      card_->setTitle(toQString(text.title));
      text_->setText(toQString(text.text));
    }
  }
  showOthers(words);
}

void ConsentPage::showOthers(const ConsentWords& words) {
  std::map<std::string, bool> chosen;  // keeps the ticks when the language changes
  for (const Choice& other : others_) {
    chosen[other.purpose] = other.agreed->isChecked();
  }
  others_.clear();
  emptyLayout(othersColumn_);
  for (const ConsentText& text : words.texts) {
    if (text.purpose == kTrainingRecord) {
      continue;
    }
    auto* box =
        new QCheckBox(toQString(text.title).replace(QLatin1Char('&'), QStringLiteral("&&")), othersCard_);
    box->setObjectName(toQString(text.purpose));
    box->setAccessibleDescription(toQString(text.text));
    const auto before = chosen.find(text.purpose);
    box->setChecked(before == chosen.end() ? isGranted(own_, text.purpose) : before->second);
    QLabel* label = plainLabel(othersCard_);
    label->setText(toQString(text.text));
    label->setContentsMargins(3 * kSpace, 0, 0, kSpace);
    othersColumn_->addWidget(box);
    othersColumn_->addWidget(label);
    others_.push_back({text.purpose, box});
  }
  othersCard_->setVisible(!others_.empty());
}

void ConsentPage::retranslate() {
  heading_->setTexts(tr("Consent"), tr("Nothing is recorded until you agree. You can withdraw at any time."));
  othersCard_->setTitle(tr("Optional consents"));
  othersText_->setText(tr("Tick what you agree to. Your choices do not affect your training."));
  understood_->setText(tr("I have &read and understood this"));
  agree_->setText(tr("I &agree to the training record"));
  decline_->setText(tr("&Not now"));
  ownRecord_->retranslate();
  attempt(shell(), [&] {
    readTexts();
    showState();
  });
}

void ConsentPage::showState() {
  const ConsentDecision* record = decisionAbout(own_, kTrainingRecord);
  const bool given = record != nullptr && record->granted;
  if (!given) {
    state_->setText(tr("You have not agreed yet."));
  } else if (record->textVersion != asked_.id) {
    state_->setText(tr("You agreed to an earlier text (%1). This is %2: please read it.")
                        .arg(toQString(Text(record->textVersion)), toQString(asked_.id)));
  } else {
    state_->setText(tr("You have already agreed."));
  }
  agree_->setText(given ? tr("&Save these decisions") : tr("I &agree to the training record"));
  decline_->setText(given ? tr("&Withdraw") : tr("&Not now"));
}

void ConsentPage::decideOne(const std::string& purpose, bool granted) {
  const ConsentDecision* before = decisionAbout(own_, purpose);
  const bool news = before == nullptr || before->granted != granted || before->textVersion != asked_.id;
  if (news) {
    decideOwnConsent(shell().session(), purpose, granted, asked_.id);
  }
}

void ConsentPage::decide(bool granted) {
  attempt(shell(), [&] {
    decideOne(kTrainingRecord, granted);
    if (granted) {
      for (const Choice& other : others_) {
        decideOne(other.purpose, other.agreed->isChecked());
      }
    } else {
      shell().notify(tr("Nothing will be recorded. Free practice remains available."));
    }
    shell().open(granted ? then_ : PageId::kNextStep);
  });
}

OwnRecordCard::OwnRecordCard(ShellContext& shell, QWidget* parent)
    : Card(QString(), parent),
      shell_(shell),
      words_(plainLabel(this, "quiet")),
      state_(plainLabel(this)),
      copy_(named(new QPushButton(this), "askCopy")),
      erase_(named(new QPushButton(this), "askErase")),
      takeBack_(named(new QPushButton(this), "takeBackRequest")) {
  state_->setObjectName(QStringLiteral("ownRequests"));
  content()->addWidget(words_);
  content()->addWidget(state_);
  QHBoxLayout* row = rowOf({copy_, erase_});
  row->addStretch(1);
  row->addWidget(takeBack_);
  content()->addLayout(row);
  connect(copy_, &QPushButton::clicked, this, [this] { ask(PersonRequestKind::kExport); });
  connect(erase_, &QPushButton::clicked, this, [this] { ask(PersonRequestKind::kErase); });
  connect(takeBack_, &QPushButton::clicked, this, &OwnRecordCard::takeBack);
}

void OwnRecordCard::read() {
  attempt(shell_, [&] {
    own_ = ownRequests(shell_.session());
    showState();
  });
}

const PersonRequest* OwnRecordCard::waiting(PersonRequestKind kind) const {
  const auto found = std::find_if(own_.begin(), own_.end(),
                                  [&](const PersonRequest& one) { return one.kind == kind && !one.answer; });
  return found == own_.end() ? nullptr : &*found;
}

void OwnRecordCard::showState() {
  QStringList lines;
  for (const PersonRequest& one : own_) {
    const QString what = toQString(labelOf(one.kind));
    const QString asked = dayText(one.askedUtc_us, locale());
    if (!one.answer) {
      lines << tr("You asked for %1 on %2; the centre has not answered yet.").arg(what, asked);
    } else if (*one.answer != PersonRequestAnswer::kTakenBack) {
      const QString answer = toQString(labelOf(*one.answer));
      lines << tr("You asked for %1 on %2: %3. %4").arg(what, asked, answer, toQString(one.reason)).trimmed();
    }
  }
  state_->setText(lines.join(QLatin1Char('\n')));
  state_->setVisible(!lines.isEmpty());
  copy_->setEnabled(waiting(PersonRequestKind::kExport) == nullptr);
  erase_->setEnabled(waiting(PersonRequestKind::kErase) == nullptr);
  takeBack_->setVisible(waiting(PersonRequestKind::kExport) != nullptr ||
                        waiting(PersonRequestKind::kErase) != nullptr);
}

void OwnRecordCard::ask(PersonRequestKind kind) {
  if (kind == PersonRequestKind::kErase &&
      QMessageBox::question(this, tr("Ask for erasure"),
                            tr("Your name and your recordings are removed, and nobody can bring them back; "
                               "marks stay without a person. Ask for it?")) != QMessageBox::Yes) {
    return;
  }
  attempt(shell_, [&] {
    requestAboutOwnRecord(shell_.session(), kind);
    shell_.notify(tr("The centre finds your request in its list."));
  });
  read();
}

void OwnRecordCard::takeBack() {
  attempt(shell_, [&] {
    for (const PersonRequest& one : own_) {
      if (!one.answer) {
        takeBackOwnRequest(shell_.session(), one.id);
      }
    }
  });
  read();
}

void OwnRecordCard::retranslate() {
  setTitle(tr("Your record"));
  words_->setText(
      tr("You may ask for a copy of everything that is kept about you, or that it be erased. The centre "
         "answers here."));
  copy_->setText(tr("Ask for a &copy\u2026"));
  erase_->setText(tr("Ask for &erasure\u2026"));
  takeBack_->setText(tr("Withdraw the re&quest"));
  showState();
}

}  // namespace torsio::gui
