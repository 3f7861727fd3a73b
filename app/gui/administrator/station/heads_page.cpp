// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/heads_page.h"

#include <initializer_list>

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QTextDocument>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/station/heads_comparison.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

namespace {

constexpr int kHeadLines = 4;

QPushButton* namedButton(QWidget* parent, const char* name) {
  auto* button = new QPushButton(parent);
  button->setObjectName(QString::fromLatin1(name));
  return button;
}

void addRow(Card* card, std::initializer_list<QPushButton*> buttons) {
  QHBoxLayout* row = rowOf();
  for (QPushButton* button : buttons) {
    row->addWidget(button);
  }
  row->addStretch(1);
  card->content()->addLayout(row);
}

}  // namespace

HeadsPage::HeadsPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      back_(new QPushButton(this)),
      station_(new Card(QString(), this)),
      keyText_(named(sentence(this, false), "keyText")),
      makeKey_(namedButton(this, "makeKey")),
      useKey_(namedButton(this, "useKey")),
      witnessText_(named(sentence(this, false), "witnessText")),
      witness_(namedButton(this, "chooseWitness")),
      noWitness_(namedButton(this, "noWitness")),
      stampText_(named(sentence(this, false), "stampText")),
      address_(named(new QLineEdit(this), "stampAddress")),
      stamps_(namedButton(this, "chooseAuthority")),
      noStamps_(namedButton(this, "noAuthority")),
      now_(new Card(QString(), this)),
      nowText_(sentence(this, false)),
      line_(headsField(this, "head", kHeadLines)),
      copy_(namedButton(this, "copyHead")),
      print_(namedButton(this, "printHead")),
      add_(namedButton(this, "addHead")),
      comparison_(new HeadsComparison(shell, this)) {
  line_->setReadOnly(true);
  layOut();
  connect(back_, &QPushButton::clicked, this, [this] { this->shell().open(PageId::kAudit); });
  connect(makeKey_, &QPushButton::clicked, this, &HeadsPage::askKey);
  connect(useKey_, &QPushButton::clicked, this, &HeadsPage::askOtherKey);
  connect(witness_, &QPushButton::clicked, this, &HeadsPage::askWitness);
  connect(noWitness_, &QPushButton::clicked, this, [this] { keepIn({}); });
  connect(stamps_, &QPushButton::clicked, this, &HeadsPage::askCertificate);
  connect(noStamps_, &QPushButton::clicked, this, [this] { stampBy({}, {}); });
  connect(address_, &QLineEdit::textChanged, this, &HeadsPage::showButtons);
  connect(copy_, &QPushButton::clicked, this, &HeadsPage::copyHead);
  connect(print_, &QPushButton::clicked, this, &HeadsPage::printHead);
  connect(add_, &QPushButton::clicked, this, &HeadsPage::addHead);
  connect(comparison_, &HeadsComparison::compared, this, &HeadsPage::read);
  retranslate();
}

void HeadsPage::layOut() {
  heading_->addAction(back_);
  QVBoxLayout* column = scrolledColumn(this);
  column->addWidget(heading_);
  column->addWidget(station_);
  column->addWidget(now_);
  column->addWidget(comparison_);
  column->addStretch(1);

  for (QLabel* text : {keyText_, witnessText_, stampText_}) {
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  }
  station_->content()->addWidget(keyText_);
  addRow(station_, {makeKey_, useKey_});
  station_->content()->addSpacing(kSpace);
  station_->content()->addWidget(witnessText_);
  addRow(station_, {witness_, noWitness_});
  station_->content()->addSpacing(kSpace);
  station_->content()->addWidget(stampText_);
  QHBoxLayout* stamps = rowOf();
  addressLabel_ = addField(stamps, address_);
  stamps->setStretchFactor(address_, 1);
  stamps->addWidget(stamps_);
  stamps->addWidget(noStamps_);
  station_->content()->addLayout(stamps);

  now_->content()->addWidget(nowText_);
  now_->content()->addWidget(line_);
  addRow(now_, {copy_, print_, add_});
}

void HeadsPage::enter(const QVariant&) {
  comparison_->forget();
  read();
}

void HeadsPage::read() {
  attempt(shell(), [&] {
    heads_ = stationHeads(shell().session());
    comparison_->setWitness(heads_.anchor.witness);
    head_.clear();
    showStation();
    head_ = headNow(shell().session());
    showStation();
  });
}

void HeadsPage::showStation() {
  QString key;
  if (!heads_.publicKey.empty()) {
    key = tr("Checkpoints are signed with the key in %1\nIts public part, to be kept where checkpoints are "
             "checked: %2")
              .arg(toQString(heads_.anchor.key), toQString(heads_.publicKey));
    if (heads_.keyBesideRecord) {
      key += QLatin1Char('\n') +
             tr("\u26A0 The key is stored beside the record: anyone who takes the folder can "
                "sign. Move it elsewhere.");
    }
  } else {
    key =
        tr("\u26A0 This station has no key, so its checkpoints are not signed: anyone with write access to "
           "where they "
           "are kept can replace them.");
  }
  keyText_->setText(key);
  setLook(keyText_, "caution", heads_.publicKey.empty() || heads_.keyBesideRecord);
  makeKey_->setText(heads_.publicKey.empty() ? tr("&Make a key\u2026") : tr("&Replace the key\u2026"));

  QString witness;
  const bool kept = !heads_.anchor.witness.empty();
  if (kept) {
    witness =
        tr("Each sign-out of an administrator adds a checkpoint to %1. Lines now: %2")
            .arg(toQString(heads_.anchor.witness), locale().toString(static_cast<qlonglong>(heads_.kept)));
    if (heads_.witnessOnDisk) {
      witness += QLatin1Char('\n') +
                 tr("\u26A0 It is on the same disk as the record: anyone who takes the disk, or puts "
                    "an older one back, has both. Choose a file on another disk.");
    }
  } else {
    witness =
        tr("\u26A0 This station keeps no checkpoints. A record that was truncated, rewritten or replaced by "
           "an older "
           "one would go unnoticed.");
  }
  if (!heads_.trouble.str().empty()) {
    witness += QLatin1Char('\n') + QStringLiteral("\u26A0 ") + toQString(heads_.trouble);
  }
  witnessText_->setText(witness);
  setLook(witnessText_, "caution", !kept || heads_.witnessOnDisk || !heads_.trouble.str().empty());
  stampText_->setText(
      heads_.authority.empty()
          ? tr("No authority confirms when checkpoints were made: only the clocks of the stations say so.")
          : tr("Each checkpoint that is kept gets a time stamp (RFC 3161) from %1. Only a hash is sent "
               "there.")
                .arg(toQString(heads_.authority)));
  line_->setPlainText(toQString(head_));
  showButtons();
}

void HeadsPage::showButtons() {
  const bool settings = shell().may(Operation::kSettingsEdit);
  for (QPushButton* button : {makeKey_, useKey_, witness_}) {
    button->setEnabled(settings);
  }
  address_->setEnabled(settings);
  stamps_->setEnabled(settings && !address_->text().trimmed().isEmpty());
  noStamps_->setEnabled(settings && !heads_.authority.empty());
  noWitness_->setEnabled(settings && !heads_.anchor.witness.empty());
  add_->setEnabled(!heads_.anchor.witness.empty());
  copy_->setEnabled(!head_.empty());
  print_->setEnabled(!head_.empty());
}

void HeadsPage::makeKey(const std::filesystem::path& file) {
  attempt(shell(), [&] {
    makeStationKey(shell().session(), file);
    shell().notify(tr("The key has been created. Note its public part elsewhere"));
  });
  read();
}

void HeadsPage::useKey(const std::filesystem::path& file) {
  attempt(shell(), [&] { chooseStationKey(shell().session(), file); });
  read();
}

void HeadsPage::keepIn(const std::filesystem::path& witness) {
  attempt(shell(), [&] { chooseWitness(shell().session(), witness); });
  read();
}

void HeadsPage::askKey() {
  const QString file =
      askFileToSave(this, tr("Make a key in a new file"), QStringLiteral("torsio-key"), tr("Key (*)"));
  if (!file.isEmpty()) {
    makeKey(toPath(file));
  }
}

void HeadsPage::askOtherKey() {
  const QString file = askFileToOpen(this, tr("Choose the file of a key"), tr("Key (*)"));
  if (!file.isEmpty()) {
    useKey(toPath(file));
  }
}

void HeadsPage::askWitness() {
  const QString file = askFileToSave(this, tr("Keep checkpoints in a file on another disk"),
                                     QStringLiteral("torsio-heads"), tr("Checkpoints (*)"));
  if (!file.isEmpty()) {
    keepIn(toPath(file));
  }
}

void HeadsPage::stampBy(const QString& address, const std::filesystem::path& certificate) {
  attempt(shell(), [&] {
    setStampAuthority(shell().session(), {address.toStdString(),
                                          address.isEmpty() ? std::string() : certificatesOf(certificate)});
    address_->clear();
  });
  read();
}

void HeadsPage::askCertificate() {
  const QString file = askFileToOpen(this, tr("Certificate of the authority\u2019s root"),
                                     tr("Certificates (*.pem *.crt *.cer)"));
  if (!file.isEmpty()) {
    stampBy(address_->text().trimmed(), toPath(file));
  }
}

void HeadsPage::addHead() {
  shell().run(
      this, tr("Adding the checkpoint to the witness file"),
      [](SessionContext& session, const ProgressCallback&) { return keepHeadNow(session); },
      [this](const Text& noStamp) {
        shell().notify(noStamp.empty()
                           ? tr("The checkpoint was added to the witness file")
                           : tr("The checkpoint was added without a time stamp: %1").arg(toQString(noStamp)));
        read();
      });
}

void HeadsPage::copyHead() {
  QGuiApplication::clipboard()->setText(line_->toPlainText());
  shell().notify(tr("Copied"));
}

void HeadsPage::printHead() {
  QPrinter printer;
  QPrintDialog dialog(&printer, this);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  QTextDocument document;
  document.setPlainText(tr("Checkpoint of the audit trail, printed at %1")
                            .arg(shownTime(shell().session().now_us(), locale())) +
                        QStringLiteral("\n\n") + line_->toPlainText());
  document.print(&printer);
}

void HeadsPage::retranslate() {
  heading_->setTexts(
      tr("Checkpoints of the audit trail"),
      tr("Checkpoints are kept outside the record and reveal what it cannot show itself: entries "
         "removed, a trail rewritten, an older file put back."));
  back_->setText(tr("&Back to the audit trail"));
  station_->setTitle(tr("This station"));
  useKey_->setText(tr("&Use another key\u2026"));
  witness_->setText(tr("Choose the &witness file\u2026"));
  noWitness_->setText(tr("Stop saving c&heckpoints"));
  nameField(addressLabel_, tr("Time stamp authorit&y"));
  stamps_->setText(tr("&Set with its certificate\u2026"));
  noStamps_->setText(tr("No &time stamps"));
  now_->setTitle(tr("Current checkpoint"));
  nowText_->setText(
      tr("Length, hash and time of the trail in one line. Keep it where nobody who can change the record can "
         "change it: on paper, in an email, on another disk."));
  line_->setAccessibleName(tr("Current checkpoint"));
  copy_->setText(tr("&Copy"));
  print_->setText(tr("&Print\u2026"));
  add_->setText(tr("&Add to the witness file"));
  comparison_->retranslate();
  showStation();
}

}  // namespace torsio::gui
