// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/audit_page.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QDateEdit>
#include <QDateTime>
#include <QJsonDocument>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/report/coded_tables.h"
#include "sim/core/time_units.h"

namespace torsio::gui {

namespace {

constexpr std::int64_t kFirstEntries = 1'000;  // initially shown, however long the record is
constexpr int kBetween = -1;                   // value of the choice of days: between two dates
constexpr int kCode = 7;                       // column: initially hidden, always searched

QDateTime timeOf(const AuditEntry& entry) {
  return QDateTime::fromMSecsSinceEpoch(entry.atUtc_us / 1000);
}

QString indented(const std::string& json) {
  const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(json));
  if (document.isNull()) {
    return toQString(json);
  }
  return QString::fromUtf8(document.toJson(QJsonDocument::Indented)).trimmed();
}

}  // namespace

AuditPage::AuditPage(ShellContext& shell)
    : Page(shell),
      most_(kFirstEntries),
      heading_(new PageHeading(this)),
      verify_(primaryButton(this)),
      heads_(named(new QPushButton(this), "heads")),
      verdict_(new QLabel(this)),
      days_(named(new QComboBox(this), "span")),
      from_(named(new QDateEdit(this), "from")),
      to_(named(new QDateEdit(this), "to")),
      more_(named(new QToolButton(this), "more")),
      table_(new DataTable(QStringLiteral("audit"), this)),
      entry_(new QPlainTextEdit(this)) {
  heading_->addAction(heads_);
  heading_->addAction(verify_);
  verdict_->setWordWrap(true);
  verdict_->hide();
  more_->hide();
  table_->addTool(more_);
  table_->addTool(days_);
  for (QDateEdit* day : {from_, to_}) {
    day->setCalendarPopup(true);
    day->setDate(QDate::currentDate());
    day->hide();
    table_->addTool(day);
    connect(day, &QDateEdit::dateChanged, this, [this] {
      most_ = kFirstEntries;
      read();
    });
  }
  export_ = listButton(table_);
  entry_->setReadOnly(true);
  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->addWidget(table_);
  splitter->addWidget(entry_);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 1);
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(2 * kSpace);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addWidget(verdict_);
  column->addWidget(splitter, 1);

  for (const int days : {1, 7, 30, 0, kBetween}) {
    days_->addItem(QString(), days);
  }
  days_->setCurrentIndex(1);
  connect(verify_, &QPushButton::clicked, this, &AuditPage::verify);
  connect(heads_, &QPushButton::clicked, this, [this] { this->shell().open(PageId::kHeads); });
  connect(export_, &QPushButton::clicked, this, &AuditPage::askExport);
  connect(days_, &QComboBox::currentIndexChanged, this, [this] {
    most_ = kFirstEntries;
    from_->setVisible(days_->currentData().toInt() == kBetween);
    to_->setVisible(days_->currentData().toInt() == kBetween);
    read();
  });
  connect(more_, &QToolButton::clicked, this, &AuditPage::readMore);
  connect(table_, &DataTable::currentChanged, this, &AuditPage::showEntry);
  retranslate();
  table_->hideAtFirst(kCode);
}

void AuditPage::enter(const QVariant&) {
  most_ = kFirstEntries;
  read();
}

/// Rereads from the newest entry: stations' clocks differ, so the oldest time shown is not a safe boundary.
void AuditPage::readMore() {
  most_ *= 2;
  read();
}

void AuditPage::retranslate() {
  heading_->setTexts(tr("Audit trail"), tr("Who did what, when, where and why. Entries are chained, so none "
                                           "can be changed or removed unnoticed. Numbers that are not "
                                           "listed are seals, which the record sets by itself."));
  for (QDateEdit* day : {from_, to_}) {
    showAsDate(day);
  }
  verify_->setText(tr("&Verify"));
  verify_->setToolTip(tr("Checks every entry, every sealed mark and every recorded run"));
  heads_->setText(tr("&Checkpoints\u2026"));
  heads_->setToolTip(
      tr("The key of this station, its witness file, and the check against saved checkpoints"));
  const QStringList spans{tr("Last day"), tr("Last week"), tr("Last month"), tr("Everything"),
                          tr("Between two dates")};
  for (int index = 0; index < spans.size(); ++index) {
    days_->setItemText(index, spans[index]);
  }
  more_->setToolTip(tr("Only the newest entries of this period are shown; press to show twice as many"));
  days_->setAccessibleName(tr("Time span"));
  from_->setAccessibleName(tr("From"));
  to_->setAccessibleName(tr("Until"));
  export_->setText(tr("&Export\u2026"));
  export_->setToolTip(tr("All entries of this period as a table (CSV)"));
  entry_->setAccessibleName(tr("Selected entry"));
  entry_->setPlaceholderText(tr("Select an entry to see what was changed."));
  table_->setColumns({{tr("No."), true},
                      {tr("When")},
                      {tr("Who")},
                      {tr("Station")},
                      {tr("What")},
                      {tr("Object")},
                      {tr("Why")},
                      {tr("Code")}});
  table_->setEmptyText(tr("There are no entries in this period."));
  showContent();
  showVerdict();
}

AuditFilter AuditPage::chosenTime() const {
  const int days = days_->currentData().toInt();
  if (days == kBetween) {
    return {.fromUtc_us = from_->date().startOfDay().toMSecsSinceEpoch() * 1000,
            .toUtc_us = to_->date().endOfDay().toMSecsSinceEpoch() * 1000 + 999};
  }
  return {.fromUtc_us = days > 0 ? shell().session().now_us() - days * kDay_us : 0};
}

bool AuditPage::exportTo(const std::filesystem::path& file, const CsvStyle& look) {
  return attempt(shell(), [&] {
    const std::size_t count = exportAuditTrail(shell().session(), chosenTime(), file, look);
    shell().notify(tr("%Ln entries saved", nullptr, static_cast<int>(count)));
  });
}

void AuditPage::askExport() {
  const TableChoice choice =
      askTableToSave(this, tr("Export the audit trail"), QStringLiteral("audit-trail"));
  if (!choice.file.isEmpty()) {
    exportTo(toPath(choice.file), choice.look);
  }
}

void AuditPage::read() {
  attempt(shell(), [&] {
    AuditFilter filter = chosenTime();
    filter.limit = most_ + 1;  // one more shows whether there are older entries
    entries_ = auditEntries(shell().session(), filter);
    const bool older = std::ssize(entries_) > most_;
    if (older) {
      entries_.pop_back();
    }
    all_ =
        older ? auditEntryCount(shell().session(), filter.fromUtc_us, filter.toUtc_us) : std::ssize(entries_);
    more_->setVisible(older);
    logins_ = auditActors(shell().session());
    subjects_ = auditSubjectCodes(shell().session(), entries_.empty() ? 0 : entries_.back().sequence);
    showContent();
  });
}

QString AuditPage::objectText(const AuditEntry& entry) const {
  const QString kind = toQString(labelOfStored<AuditObject>(entry.objectKind));
  const auto subject = subjects_.find(entry.objectId);
  return subject == subjects_.end() ? kind : tr("%1 %2").arg(kind, toQString(subject->second));
}

void AuditPage::showContent() {
  std::vector<Row> rows;
  rows.reserve(entries_.size());
  for (const AuditEntry& entry : entries_) {
    const auto login = logins_.find(entry.actor);
    const QString actor = toQString(login == logins_.end() ? entry.actor : login->second);
    const auto sequence = static_cast<qlonglong>(entry.sequence);
    rows.push_back({QString::number(sequence),
                    {{locale().toString(sequence), sequence},
                     timeCell(entry.atUtc_us),
                     {actor},
                     {toQString(entry.station)},
                     {toQString(labelOfStored<AuditAction>(entry.action)), {}, toQString(entry.action)},
                     {objectText(entry), {}, toQString(entry.objectId)},
                     {toQString(entry.reason)},
                     {toQString(entry.action)}}});
  }
  more_->setText(tr("Show &more of %1").arg(locale().toString(static_cast<qlonglong>(all_))));
  table_->setRows(std::move(rows));
}

void AuditPage::showEntry(const QString& id) {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&id](const AuditEntry& entry) {
    return QString::number(static_cast<qlonglong>(entry.sequence)) == id;
  });
  if (found == entries_.end()) {
    entry_->clear();
    return;
  }
  QStringList lines;
  const auto add = [&lines](const QString& name, const QString& value) {
    if (!value.isEmpty()) {
      lines << QStringLiteral("%1: %2").arg(name, value);
    }
  };
  add(tr("When (UTC)"), timeOf(*found).toUTC().toString(Qt::ISODateWithMs));
  const auto withCode = [](const Text& words, const std::string& code) {
    const QString spelt = toQString(code);
    return toQString(words) == spelt ? spelt : QStringLiteral("%1 (%2)").arg(toQString(words), spelt);
  };
  add(tr("What"), withCode(labelOfStored<AuditAction>(found->action), found->action));
  add(tr("Object"),
      QStringLiteral("%1 %2").arg(withCode(labelOfStored<AuditObject>(found->objectKind), found->objectKind),
                                  toQString(found->objectId)));
  const auto told = [this](const std::string& json) {  // user ids mean nothing to readers
    QString text = indented(json);
    for (const auto& [user, login] : logins_) {
      text.replace(toQString(user), QStringLiteral("%1 (%2)").arg(toQString(login), toQString(user)));
    }
    return text;
  };
  add(tr("Before"), told(found->oldJson));
  add(tr("After"), told(found->newJson));
  add(tr("Why"), toQString(found->reason));
  add(tr("Seal"), toQString(found->entryHash));
  entry_->setPlainText(lines.join(QLatin1Char('\n')));
}

void AuditPage::verify() {
  shell().run(
      this, tr("Verifying the audit trail"),
      [](SessionContext& session, const ProgressCallback&) { return verifyAudit(session); },
      [this](std::vector<AuditFinding> findings) {
        findings_ = std::move(findings);
        showVerdict();
        read();
      });
}

void AuditPage::showVerdict() {
  verdict_->setVisible(findings_.has_value());
  if (!findings_) {
    return;
  }
  const bool sound = findings_->empty();
  verdict_->setProperty("good", sound);
  verdict_->setProperty("caution", !sound);
  if (sound) {
    verdict_->setText(tr("\u2713 Entries, marks and runs are exactly as they were recorded."));
  } else {
    QStringList lines{tr("\u26A0 %n finding(s). Do not report from this record before they are explained.",
                         nullptr, static_cast<int>(findings_->size()))};
    constexpr std::size_t kShown = 10;
    for (std::size_t i = 0; i < std::min(findings_->size(), kShown); ++i) {
      const AuditFinding& finding = (*findings_)[i];
      lines << QStringLiteral("\u2022 %1 %2: %3")
                   .arg(toQString(labelOfStored<AuditObject>(finding.objectKind)),
                        toQString(finding.objectId), toQString(finding.what));
    }
    verdict_->setText(lines.join(QLatin1Char('\n')));
  }
  verdict_->style()->unpolish(verdict_);
  verdict_->style()->polish(verdict_);
}

}  // namespace torsio::gui
