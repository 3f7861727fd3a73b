// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/heads_comparison.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/signing_key.h"

namespace torsio::gui {

namespace {

constexpr int kCompareLines = 6;
constexpr std::size_t kShownFindings = 10;

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

QPlainTextEdit* headsField(QWidget* parent, const char* name, int lines) {
  auto* field = new QPlainTextEdit(parent);
  field->setObjectName(QString::fromLatin1(name));
  field->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  field->setWordWrapMode(QTextOption::WrapAnywhere);
  field->setTabChangesFocus(true);
  field->setFixedHeight(field->fontMetrics().lineSpacing() * lines + 2 * kSpace);
  return field;
}

HeadsComparison::HeadsComparison(ShellContext& shell, QWidget* parent)
    : Card(QString(), parent),
      shell_(shell),
      text_(sentence(this, false)),
      lines_(headsField(this, "keptHeads", kCompareLines)),
      load_(named(new QPushButton(this), "loadWitness")),
      public_(named(new QLineEdit(this), "publicKey")),
      verify_(named(new QPushButton(this), "verifyHeads")),
      verdict_(named(sentence(this, false), "headsVerdict")),
      checks_(new FieldChecks(this)) {
  verify_->setProperty("primary", true);
  content()->addWidget(text_);
  content()->addWidget(lines_);
  QHBoxLayout* row = rowOf({load_});
  row->addSpacing(kSpace);
  publicLabel_ = addField(row, public_);
  row->setStretchFactor(public_, 1);
  row->addWidget(verify_);
  content()->addLayout(row);
  content()->addWidget(verdict_);
  connect(load_, &QPushButton::clicked, this, &HeadsComparison::loadWitness);
  connect(verify_, &QPushButton::clicked, this, &HeadsComparison::verify);
  connect(lines_, &QPlainTextEdit::textChanged, this, &HeadsComparison::forget);
  connect(&shell, &ShellContext::jobStarted, checks_, &FieldChecks::check);
  connect(&shell, &ShellContext::jobEnded, checks_, &FieldChecks::check);
  addChecks();
}

/// Called after the card's own connections, so that hints see the updated state.
void HeadsComparison::addChecks() {
  QVBoxLayout* column = content();
  const auto hintBelow = [this, column](int place, QWidget* field, std::function<QString()> wrong) {
    QLabel* hint = fieldHint(this);
    column->insertWidget(place, hint);
    checks_->add(hint, field, std::move(wrong));
  };
  const int lines = column->indexOf(lines_) + 1;
  hintBelow(lines, lines_, [this] {
    if (lines_->toPlainText().trimmed().isEmpty()) {
      return tr("Paste at least one checkpoint, or read a file.");
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
  checks_->decide(verify_, [this] { return !shell_.working(); });
}

void HeadsComparison::forget() {
  found_.reset();
  unreadable_.reset();
  showVerdict();
  checks_->check();
}

void HeadsComparison::loadWitness() {
  const QString file =
      askFileToOpen(this, tr("Saved checkpoints"), tr("Checkpoints (*)"), toQString(witness_));
  if (file.isEmpty()) {
    return;
  }
  attempt(shell_, [&] {
    QStringList lines;
    for (const std::string& line : headsOf(toPath(file))) {
      lines << toQString(line);
    }
    lines_->setPlainText(lines.join(QLatin1Char('\n')));
  });
}

void HeadsComparison::verify() {
  const auto show = [this](std::optional<HeadsVerdict> verdict, std::optional<Error> unreadable) {
    found_ = std::move(verdict);
    unreadable_ = std::move(unreadable);
    checks_->touch(lines_);
    showVerdict();
    Q_EMIT compared();
  };
  const std::vector<std::string> lines = linesOf(lines_->toPlainText());
  shell_.run(
      this, tr("Comparing the record with saved checkpoints"),
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

void HeadsComparison::showVerdict() {
  verdict_->setVisible(found_.has_value());
  if (!found_) {
    return;
  }
  const std::vector<AuditFinding>& findings = found_->findings;
  const bool sound = findings.empty();
  QStringList lines{
      sound ? tr("\u2713 The audit trail matches these checkpoints, and nothing has been removed.")
            : tr("\u26A0 %n finding(s). Do not report from this record before they are "
                 "explained.",
                 nullptr, static_cast<int>(findings.size()))};
  for (std::size_t i = 0; i < std::min(findings.size(), kShownFindings); ++i) {
    const AuditFinding& finding = findings[i];
    lines << tr("\u2022 entry %1: %2")
                 .arg(locale().toString(static_cast<qlonglong>(finding.sequence)), toQString(finding.what));
  }
  for (const Text& note : found_->notes) {
    lines << QStringLiteral("\u2022 ") + toQString(note);
  }
  verdict_->setText(lines.join(QLatin1Char('\n')));
  setLook(verdict_, "good", sound);
  setLook(verdict_, "caution", !sound);
}

void HeadsComparison::retranslate() {
  setTitle(tr("Compare with saved checkpoints"));
  text_->setText(
      tr("Paste or type checkpoints, one per line, or read a witness file. Without a public key they must be "
         "signed "
         "with the key of this station, where it has one."));
  lines_->setAccessibleName(tr("Saved checkpoints"));
  load_->setText(tr("Read a &file\u2026"));
  nameField(publicLabel_, tr("Public &key"));
  public_->setPlaceholderText(tr("that of this station"));
  verify_->setText(tr("&Verify"));
  showVerdict();
}

}  // namespace torsio::gui
