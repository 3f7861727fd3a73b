// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/heads_page.h"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <utility>

#include <QClipboard>
#include <QFontDatabase>
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
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/signing_key.h"

namespace torsio::gui {

namespace {

constexpr int kHeadLines = 4;
constexpr int kCompareLines = 6;
constexpr std::size_t kShownFindings = 10;

/// Returns a field for heads, which are long words.
QPlainTextEdit* lineField(QWidget* parent, const char* name, int lines) {
  auto* field = new QPlainTextEdit(parent);
  field->setObjectName(QString::fromLatin1(name));
  field->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  field->setWordWrapMode(QTextOption::WrapAnywhere);
  field->setTabChangesFocus(true);
  field->setFixedHeight(field->fontMetrics().lineSpacing() * lines + 2 * kSpace);
  return field;
}

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

std::vector<std::string> linesOf(const QString& text) {
  std::vector<std::string> lines;
  for (const QString& line : text.split(QLatin1Char('\n'))) {
    if (const QString words = line.simplified(); !words.isEmpty()) {
      lines.push_back(words.toStdString());
    }
  }
  return lines;
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
      line_(lineField(this, "head", kHeadLines)),
      copy_(namedButton(this, "copyHead")),
      print_(namedButton(this, "printHead")),
      add_(namedButton(this, "addHead")),
      compare_(new Card(QString(), this)),
      compareText_(sentence(this, false)),
      lines_(lineField(this, "keptHeads", kCompareLines)),
      load_(namedButton(this, "loadWitness")),
      public_(named(new QLineEdit(this), "publicKey")),
      verify_(namedButton(this, "verifyHeads")),
      verdict_(named(sentence(this, false), "headsVerdict")),
      checks_(new FieldChecks(this)) {
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
  connect(load_, &QPushButton::clicked, this, &HeadsPage::loadWitness);
  connect(verify_, &QPushButton::clicked, this, &HeadsPage::verify);
  connect(lines_, &QPlainTextEdit::textChanged, this, [this] {
    verdictOfHeads_.reset();
    unreadable_.reset();
    showVerdict();
    showButtons();
  });
  connect(&shell, &ShellContext::jobStarted, this, &HeadsPage::showButtons);
  connect(&shell, &ShellContext::jobEnded, this, &HeadsPage::showButtons);
  addChecks();
  retranslate();
}

void HeadsPage::layOut() {
  heading_->addAction(back_);
  QVBoxLayout* column = scrolledColumn(this);
  column->addWidget(heading_);
  for (Card* card : {station_, now_, compare_}) {
    column->addWidget(card);
  }
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

  verify_->setProperty("primary", true);
  compare_->content()->addWidget(compareText_);
  compare_->content()->addWidget(lines_);
  QHBoxLayout* row = rowOf({load_});
  row->addSpacing(kSpace);
  publicLabel_ = addField(row, public_);
  row->setStretchFactor(public_, 1);
  row->addWidget(verify_);
  compare_->content()->addLayout(row);
  compare_->content()->addWidget(verdict_);
}

/// Called after the page's own connections, so that hints see the updated state.
void HeadsPage::addChecks() {
  QVBoxLayout* column = compare_->content();
  const auto hintBelow = [this, column](int place, QWidget* field, std::function<QString()> wrong) {
    QLabel* hint = fieldHint(compare_);
    column->insertWidget(place, hint);
    checks_->add(hint, field, std::move(wrong));
  };
  const int lines = column->indexOf(lines_) + 1;
  hintBelow(lines, lines_, [this] {
    if (lines_->toPlainText().trimmed().isEmpty()) {
      return tr("Paste at least one head, or read a file.");
    }
    return unreadable_ ? translatedLine(*unreadable_) : QString();
  });
  hintBelow(column->indexOf(verdict_), public_, [this] {
    const std::string key = public_->text().trimmed().toStdString();
    return key.empty() || isPublicKey(key)
               ? QString()
               : tr("A public key has 64 digits, 0 to 9 and a to f; this one has %1 characters.")
                     .arg(public_->text().trimmed().size());
  });
  checks_->decide(verify_, [this] { return !shell().working(); });
}

void HeadsPage::enter(const QVariant&) {
  verdictOfHeads_.reset();
  showVerdict();
  read();
}

void HeadsPage::read() {
  attempt(shell(), [&] {
    heads_ = stationHeads(shell().session());
    head_.clear();
    showStation();
    head_ = headNow(shell().session());
    showStation();
  });
}

void HeadsPage::showStation() {
  QString key;
  if (!heads_.publicKey.empty()) {
    key = tr("Heads are signed with the key in %1\nIts public part, to be kept where heads are checked: %2")
              .arg(toQString(heads_.anchor.key), toQString(heads_.publicKey));
    if (heads_.keyBesideRecord) {
      key += QLatin1Char('\n') +
             tr("\u26A0 The key is stored beside the record: anyone who takes the folder can "
                "sign. Move it elsewhere.");
    }
  } else {
    key = tr(
        "\u26A0 This station has no key, so its heads are not signed: anyone with write access to where they "
        "are kept can replace them.");
  }
  keyText_->setText(key);
  setLook(keyText_, "caution", heads_.publicKey.empty() || heads_.keyBesideRecord);
  makeKey_->setText(heads_.publicKey.empty() ? tr("&Make a key\u2026") : tr("&Replace the key\u2026"));

  QString witness;
  const bool kept = !heads_.anchor.witness.empty();
  if (kept) {
    witness =
        tr("Each sign-out of an administrator adds a head to %1. Lines now: %2")
            .arg(toQString(heads_.anchor.witness), locale().toString(static_cast<qlonglong>(heads_.kept)));
    if (heads_.witnessOnDisk) {
      witness += QLatin1Char('\n') +
                 tr("\u26A0 It is on the same disk as the record: anyone who takes the disk, or puts "
                    "an older one back, has both. Choose a file on another disk.");
    }
  } else {
    witness = tr(
        "\u26A0 This station keeps no heads. A record that was truncated, rewritten or replaced by an older "
        "one would go unnoticed.");
  }
  if (!heads_.trouble.str().empty()) {
    witness += QLatin1Char('\n') + QStringLiteral("\u26A0 ") + toQString(heads_.trouble);
  }
  witnessText_->setText(witness);
  setLook(witnessText_, "caution", !kept || heads_.witnessOnDisk || !heads_.trouble.str().empty());
  stampText_->setText(
      heads_.authority.empty()
          ? tr("No authority confirms when heads were made: only the clocks of the stations say so.")
          : tr("Each head that is kept gets a time stamp (RFC 3161) from %1. Only a hash is sent there.")
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
  checks_->check();
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
  const QString file = askFileToSave(this, tr("Keep heads in a file on another disk"),
                                     QStringLiteral("torsio-heads"), tr("Heads (*)"));
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
      this, tr("Adding the head to the witness file"),
      [](SessionContext& session, const ProgressCallback&) { return keepHeadNow(session); },
      [this](const Text& noStamp) {
        shell().notify(noStamp.empty()
                           ? tr("The head was added to the witness file")
                           : tr("The head was added without a time stamp: %1").arg(toQString(noStamp)));
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
  document.setPlainText(
      tr("Head of the audit trail, printed at %1").arg(shownTime(shell().session().now_us(), locale())) +
      QStringLiteral("\n\n") + line_->toPlainText());
  document.print(&printer);
}

void HeadsPage::loadWitness() {
  const QString file =
      askFileToOpen(this, tr("Saved heads"), tr("Heads (*)"), toQString(heads_.anchor.witness));
  if (file.isEmpty()) {
    return;
  }
  attempt(shell(), [&] {
    QStringList lines;
    for (const std::string& line : headsOf(toPath(file))) {
      lines << toQString(line);
    }
    lines_->setPlainText(lines.join(QLatin1Char('\n')));
  });
}

void HeadsPage::verify() {
  const auto show = [this](std::optional<HeadsVerdict> verdict, std::optional<Error> unreadable) {
    verdictOfHeads_ = std::move(verdict);
    unreadable_ = std::move(unreadable);
    checks_->touch(lines_);
    showVerdict();
    read();
  };
  const std::vector<std::string> lines = linesOf(lines_->toPlainText());
  shell().run(
      this, tr("Comparing the record with saved heads"),
      [lines, key = public_->text().trimmed().toStdString()](
          SessionContext& session, const ProgressCallback&) { return verifyHeads(session, lines, key); },
      [show](HeadsVerdict verdict) { show(std::move(verdict), std::nullopt); },
      [show, lines](const Error& error) {
        const std::string& where = error.where();
        const bool aboutLines =
            !where.empty() && std::any_of(lines.begin(), lines.end(), [&where](const std::string& line) {
              return line.starts_with(where);
            });
        if (aboutLines) {
          show(std::nullopt, error);
        }
        return aboutLines;
      });
}

void HeadsPage::showVerdict() {
  verdict_->setVisible(verdictOfHeads_.has_value());
  if (!verdictOfHeads_) {
    return;
  }
  const std::vector<AuditFinding>& findings = verdictOfHeads_->findings;
  const bool sound = findings.empty();
  QStringList lines{sound ? tr("\u2713 The audit trail matches these heads, and nothing has been removed.")
                          : tr("\u26A0 %n finding(s). Do not report from this record before they are "
                               "explained.",
                               nullptr, static_cast<int>(findings.size()))};
  for (std::size_t i = 0; i < std::min(findings.size(), kShownFindings); ++i) {
    const AuditFinding& finding = findings[i];
    lines << tr("\u2022 entry %1: %2")
                 .arg(locale().toString(static_cast<qlonglong>(finding.sequence)), toQString(finding.what));
  }
  for (const Text& note : verdictOfHeads_->notes) {
    lines << QStringLiteral("\u2022 ") + toQString(note);
  }
  verdict_->setText(lines.join(QLatin1Char('\n')));
  setLook(verdict_, "good", sound);
  setLook(verdict_, "caution", !sound);
}

void HeadsPage::retranslate() {
  heading_->setTexts(tr("Heads of the audit trail"),
                     tr("Heads are kept outside the record and reveal what it cannot show itself: entries "
                        "removed, a trail rewritten, an older file put back."));
  back_->setText(tr("&Back to the audit trail"));
  station_->setTitle(tr("This station"));
  useKey_->setText(tr("&Use another key\u2026"));
  witness_->setText(tr("Choose the &witness file\u2026"));
  noWitness_->setText(tr("Keep &no heads"));
  nameField(addressLabel_, tr("Time stamp authorit&y"));
  stamps_->setText(tr("&Set with its certificate\u2026"));
  noStamps_->setText(tr("No &time stamps"));
  now_->setTitle(tr("Current head"));
  nowText_->setText(
      tr("Length, hash and time of the trail in one line. Keep it where nobody who can change the record can "
         "change it: on paper, in an email, on another disk."));
  line_->setAccessibleName(tr("Current head"));
  copy_->setText(tr("&Copy"));
  print_->setText(tr("&Print\u2026"));
  add_->setText(tr("&Add to the witness file"));
  compare_->setTitle(tr("Compare with saved heads"));
  compareText_->setText(tr(
      "Paste or type heads, one per line, or read a witness file. Without a public key they must be signed "
      "with the key of this station, where it has one."));
  lines_->setAccessibleName(tr("Saved heads"));
  load_->setText(tr("Read a &file\u2026"));
  nameField(publicLabel_, tr("Public &key"));
  public_->setPlaceholderText(tr("that of this station"));
  verify_->setText(tr("&Verify"));
  showStation();
  showVerdict();
}

}  // namespace torsio::gui
