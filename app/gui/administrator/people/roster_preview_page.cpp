// SPDX-License-Identifier: GPL-3.0-or-later
// The last step of the roster wizard: preview and import.
#include <algorithm>
#include <utility>

#include <QLabel>
#include <QProgressBar>
#include <QVBoxLayout>

#include "app/gui/administrator/people/roster_wizard.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/outputs/wording/joined_sentences.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr int kWhole = 1000;   // of the progress bar
constexpr int kNoteLines = 3;  // of an error and its remedy in the narrowest window

}  // namespace

RosterPreviewPage::RosterPreviewPage(RosterImport& import, ShellContext& shell, QWidget* parent)
    : QWizardPage(parent),
      import_(import),
      shell_(shell),
      summary_(new QLabel(this)),
      progress_(ranged(new QProgressBar(this), 0, kWhole)),
      lines_(new DataTable(QStringLiteral("roster-preview"), this)),
      note_(named(sentence(this, false), "rosterNote")) {
  setTitle(tr("Preview of the import"));
  setSubTitle(
      tr("Nothing has been saved yet. If any line has an error, nothing is imported: correct the file and "
         "choose it again."));
  setFinalPage(true);
  summary_->setWordWrap(true);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("Progress"));
  keepPlace(progress_, progress_->sizeHint().height());
  progress_->hide();
  keepPlace(note_, kNoteLines * note_->fontMetrics().lineSpacing());
  note_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  note_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(2 * kSpace);
  column->addWidget(summary_);
  column->addWidget(progress_);
  column->addWidget(lines_, 1);
  column->addWidget(note_);
  connect(lines_, &DataTable::currentChanged, this, &RosterPreviewPage::showNote);
  connect(&shell, &ShellContext::jobMoved, this, [this](const QString& step, double fraction) {
    if (busy_) {
      showProgress(step, fraction);
    }
  });
  connect(&shell, &ShellContext::jobEnded, this, [this] {
    busy_ = false;
    progress_->hide();
    Q_EMIT completeChanged();
  });
}

void RosterPreviewPage::begin(const QString& what) {
  busy_ = true;
  progress_->setValue(0);
  progress_->show();
  summary_->setText(what);
  Q_EMIT completeChanged();
}

void RosterPreviewPage::showProgress(const QString& step, double fraction) {
  progress_->setValue(static_cast<int>(fraction * kWhole));
  summary_->setText(tr("%1: %2 %").arg(step).arg(static_cast<int>(fraction * 100.0)));
}

void RosterPreviewPage::initializePage() {
  import_.preview.reset();
  lines_->filter().clear();  // it was typed for another file
  lines_->setRows({});
  note_->clear();
  begin(
      tr("Comparing %n line(s) with the record\u2026", nullptr, static_cast<int>(import_.file->rows.size())));
  shell_.run(
      this, tr("Reading the roster"),
      [file = *import_.file, kind = import_.kind, columns = import_.columns](
          SessionContext& session, const ProgressCallback& progress) {
        RosterPreview preview = previewRoster(session, file, kind, columns, progress);
        // Ensures, before the last button is enabled, that the database would accept the import.
        if (preview.importable()) {
          static_cast<void>(
              importRoster(session, file, kind, columns, preview.fingerprint, RosterMode::kDryRun, progress));
        }
        return preview;
      },
      [this](RosterPreview preview) {
        import_.preview = std::move(preview);
        showPreview();
      },
      [this](const Error& error) { showProblem(rosterProblem(error)); });
}

void RosterPreviewPage::showProblem(const QString& words) {
  import_.preview.reset();
  summary_->setText(words);
  Q_EMIT completeChanged();
}

void RosterPreviewPage::showPreview() {
  const RosterPreview& preview = *import_.preview;
  QString summary = tr("%1 new, %2 with changes, %3 as they are, %4 with errors.")
                        .arg(preview.added)
                        .arg(preview.changed)
                        .arg(preview.same)
                        .arg(preview.errors);
  if (import_.file->encoding != "UTF-8") {
    summary = joinedSentences(
        {summary,
         tr("The file was read as %1: check letters with accents.").arg(toQString(import_.file->encoding))});
  }
  summary_->setText(summary);
  // All columns that the file fills, so that the data can be checked before the import.
  std::vector<RosterField> fields;
  std::vector<Column> columns{{tr("Line"), true}, {tr("Status")}, {tr("Note")}};
  for (const RosterField field : rosterFields(preview.kind)) {
    if (import_.columns[static_cast<std::size_t>(field)]) {
      fields.push_back(field);
      columns.push_back({rosterFieldName(field)});
    }
  }
  lines_->setColumns(columns);
  std::vector<Row> rows;
  for (const RosterRow& row : preview.rows) {
    const auto line = static_cast<qulonglong>(row.line);
    const QString note = rosterNote(row);
    Row shown{QString::number(line),
              {{QString::number(line), line},
               {rosterStatusName(row.status), static_cast<int>(row.status)},
               {note, {}, note}}};
    for (const RosterField field : fields) {
      shown.cells.push_back({toQString(row.values[static_cast<std::size_t>(field)])});
    }
    rows.push_back(std::move(shown));
  }
  lines_->setRows(std::move(rows));
  const auto wrong = std::find_if(preview.rows.begin(), preview.rows.end(),
                                  [](const RosterRow& row) { return !row.problem.empty(); });
  if (wrong != preview.rows.end()) {
    showNote(QString::number(static_cast<qulonglong>(wrong->line)));
  }
  Q_EMIT completeChanged();
}

void RosterPreviewPage::showNote(const QString& line) {
  note_->clear();
  if (!import_.preview) {
    return;
  }
  for (const RosterRow& row : import_.preview->rows) {
    if (QString::number(static_cast<qulonglong>(row.line)) == line) {
      const QString note = rosterNote(row);
      note_->setText(note.isEmpty() ? QString() : tr("Line %1: %2").arg(line, note));
      return;
    }
  }
}

void RosterPreviewPage::commit(std::function<void()> done) {
  begin(tr("Importing\u2026"));
  shell_.run(
      this, tr("Importing the roster"),
      [file = *import_.file, kind = import_.kind, columns = import_.columns,
       fingerprint = import_.preview->fingerprint](SessionContext& session,
                                                   const ProgressCallback& progress) {
        return importRoster(session, file, kind, columns, fingerprint, RosterMode::kCommit, progress);
      },
      [this, done = std::move(done)](RosterOutcome outcome) {
        import_.outcome = std::move(outcome);
        done();
      },
      [this](const Error& error) { showProblem(rosterProblem(error)); });
}

bool RosterPreviewPage::isComplete() const {
  return !busy_ && import_.preview && import_.preview->importable();
}

}  // namespace torsio::gui
