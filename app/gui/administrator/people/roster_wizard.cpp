// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/roster_wizard.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QUrl>
#include <QVBoxLayout>

#include "app/gui/administrator/people/roster_labels.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"

namespace torsio::gui {

namespace {

constexpr std::size_t kSampleRows = 5;
constexpr int kWhole = 1000;  // of the progress bar

/// Where this station keeps the choices for files with these headings: headings are no data of anybody.
QString columnsKey(const RosterFile& file, RosterKind kind) {
  QStringList headings;
  for (const std::string& name : file.header) {
    headings << QString::fromLatin1(QUrl::toPercentEncoding(toQString(name)));
  }
  return QStringLiteral("roster/%1/%2").arg(static_cast<int>(kind)).arg(headings.join(QLatin1Char('|')));
}

void keepColumns(const RosterFile& file, RosterKind kind, const RosterColumns& columns) {
  QStringList chosen;
  for (const std::optional<std::size_t>& column : columns) {
    chosen << (column ? QString::number(*column) : QString());
  }
  QSettings().setValue(columnsKey(file, kind), chosen);
}

/// Those that were chosen before for the same headings, else what the headings suggest.
RosterColumns columnsFor(const RosterFile& file, RosterKind kind) {
  RosterColumns columns = suggestColumns(file, kind);
  const QStringList kept = QSettings().value(columnsKey(file, kind)).toStringList();
  if (kept.size() != static_cast<qsizetype>(columns.size())) {
    return columns;
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    bool isNumber = false;
    const std::size_t column = kept[static_cast<qsizetype>(i)].toULongLong(&isNumber);
    columns[i] = isNumber && column < file.header.size() ? std::optional(column) : std::nullopt;
  }
  return columns;
}

}  // namespace

RosterWizard::RosterWizard(ShellContext& shell, QWidget* parent) : QWizard(parent), shell_(shell) {
  setWindowTitle(tr("Import a roster"));
  setWizardStyle(QWizard::ModernStyle);
  setOption(QWizard::NoBackButtonOnStartPage);
  setButtonText(QWizard::FinishButton, tr("&Import"));
  setMinimumSize(760, 560);
  addPage(new RosterFilePage(import_, this));
  addPage(new RosterColumnsPage(import_, this));
  preview_ = new RosterPreviewPage(import_, shell, this);
  addPage(preview_);
  // After the job and whatever followed it.
  connect(
      &shell, &ShellContext::jobEnded, this,
      [this] {
        if (closing_) {
          QWizard::reject();
        }
      },
      Qt::QueuedConnection);
}

void RosterWizard::accept() {
  if (preview_->busy() || !preview_->isComplete()) {
    return;
  }
  preview_->commit([this] { QWizard::accept(); });
}

void RosterWizard::reject() {
  if (!preview_->busy()) {
    QWizard::reject();
    return;
  }
  closing_ = true;
  shell_.cancelJobs();
}

RosterFilePage::RosterFilePage(RosterImport& import, QWidget* parent)
    : QWizardPage(parent),
      import_(import),
      trainees_(new QRadioButton(tr("&Trainees"), this)),
      raters_(new QRadioButton(tr("&Raters"), this)),
      path_(new QLineEdit(this)),
      columns_(sentence(this)),
      problem_(new QLabel(this)) {
  setTitle(tr("The file"));
  setSubTitle(
      tr("A table saved as CSV (UTF-8), one person a line, with a header line. The staff or student number "
         "tells who somebody is; an e-mail address alone never does."));
  trainees_->setChecked(true);
  path_->setObjectName(QStringLiteral("path"));
  path_->setPlaceholderText(tr("Path of the CSV file"));
  path_->setAccessibleName(tr("Path of the CSV file"));
  problem_->setWordWrap(true);
  problem_->setProperty("caution", true);
  auto* choose = new QPushButton(tr("&Choose\u2026"), this);
  auto* blank = new QPushButton(tr("&Save an empty template\u2026"), this);
  blank->setProperty("link", true);
  auto* kinds = new QHBoxLayout;
  kinds->addWidget(trainees_);
  kinds->addWidget(raters_);
  kinds->addStretch(1);
  auto* file = new QHBoxLayout;
  file->addWidget(path_, 1);
  file->addWidget(choose);
  auto* column = new QVBoxLayout(this);
  column->setSpacing(2 * kSpace);
  column->addLayout(kinds);
  column->addLayout(file);
  column->addWidget(columns_);
  column->addWidget(blank, 0, Qt::AlignLeft);
  column->addWidget(problem_);
  column->addStretch(1);
  connect(raters_, &QRadioButton::toggled, this, &RosterFilePage::sayColumns);
  connect(choose, &QPushButton::clicked, this, &RosterFilePage::choose);
  connect(blank, &QPushButton::clicked, this, &RosterFilePage::saveTemplate);
  connect(path_, &QLineEdit::textChanged, this, [this] {
    problem_->clear();
    Q_EMIT completeChanged();
  });
}

void RosterFilePage::initializePage() {
  sayColumns();
  path_->setFocus();
}

/// Which columns the file may have, so that nobody needs the guide for it.
void RosterFilePage::sayColumns() {
  const RosterKind kind = raters_->isChecked() ? RosterKind::kRaters : RosterKind::kTrainees;
  QStringList needed;
  QStringList other;
  for (const RosterField field : rosterFields(kind)) {
    (isRequired(field, kind) ? needed : other) << rosterFieldName(field);
  }
  columns_->setText(
      tr("Needed columns: %1. Further columns, as far as you have them: %2. Their order and their "
         "headings do not matter; the next step asks which is which.")
          .arg(needed.join(tr(", ")), other.join(tr(", "))));
}

bool RosterFilePage::isComplete() const {
  return !path_->text().trimmed().isEmpty();
}

bool RosterFilePage::validatePage() {
  try {
    const std::vector<std::string> headerBefore =
        import_.file ? import_.file->header : std::vector<std::string>{};
    const RosterKind kindBefore = import_.kind;
    import_.kind = raters_->isChecked() ? RosterKind::kRaters : RosterKind::kTrainees;
    import_.file = readRoster(toPath(path_->text().trimmed()));
    // A mended file with the same headings keeps the choices that were made for it.
    if (import_.file->header != headerBefore || import_.kind != kindBefore) {
      import_.columns = columnsFor(*import_.file, import_.kind);
    }
    return true;
  } catch (const Error& error) {
    problem_->setText(rosterProblem(error));
    return false;
  }
}

void RosterFilePage::choose() {
  const QString file = askFileToOpen(this, tr("Roster"), tr("Tables (*.csv *.txt *.tsv);;All files (*)"));
  if (!file.isEmpty()) {
    path_->setText(file);
  }
}

void RosterFilePage::saveTemplate() {
  const QString file =
      askFileToSave(this, tr("Empty template"), QStringLiteral("roster.csv"), tr("Tables (*.csv)"));
  if (file.isEmpty()) {
    return;
  }
  try {
    writeFileAtomically(toPath(file),
                        rosterTemplate(raters_->isChecked() ? RosterKind::kRaters : RosterKind::kTrainees));
    problem_->clear();
  } catch (const Error& error) {
    problem_->setText(rosterProblem(error));
  }
}

RosterColumnsPage::RosterColumnsPage(RosterImport& import, QWidget* parent)
    : QWizardPage(parent), import_(import), form_(new QGridLayout), sample_(new DataTable(QString(), this)) {
  setTitle(tr("The columns"));
  setSubTitle(
      tr("Which column holds what. Fields with a star are needed; the first lines of the file stand below."));
  auto* column = new QVBoxLayout(this);
  column->setSpacing(2 * kSpace);
  form_->setHorizontalSpacing(kSpace);
  form_->setVerticalSpacing(kSpace);
  for (const int side : {1, 3}) {
    form_->setColumnStretch(side, 1);
  }
  sample_->filter().hide();
  column->addLayout(form_);
  column->addWidget(sample_, 1);
}

void RosterColumnsPage::initializePage() {
  while (QLayoutItem* item = form_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  choices_.clear();
  for (const RosterField field : rosterFields(import_.kind)) {
    auto* choice = new QComboBox(this);
    choice->setObjectName(QString::fromLatin1(rosterFieldCode(field).data()));
    choice->addItem(tr("not in this file"), -1);
    for (std::size_t i = 0; i < import_.file->header.size(); ++i) {
      choice->addItem(toQString(import_.file->header[i]), static_cast<int>(i));
    }
    const auto& suggested = import_.columns[static_cast<std::size_t>(field)];
    choice->setCurrentIndex(suggested ? static_cast<int>(*suggested) + 1 : 0);
    const QString name = rosterFieldName(field);
    auto* label = new QLabel(isRequired(field, import_.kind) ? tr("%1 *").arg(name) : name, this);
    label->setBuddy(choice);
    choice->setAccessibleName(name);
    const auto place = static_cast<int>(choices_.size());
    form_->addWidget(label, place / 2, 2 * (place % 2));
    form_->addWidget(choice, place / 2, 2 * (place % 2) + 1);
    choices_[field] = choice;
    connect(choice, &QComboBox::currentIndexChanged, this, &QWizardPage::completeChanged);
  }
  showSample();
}

void RosterColumnsPage::showSample() {
  std::vector<Column> columns;
  for (const std::string& name : import_.file->header) {
    columns.push_back({toQString(name)});
  }
  sample_->setColumns(columns);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < std::min(kSampleRows, import_.file->rows.size()); ++i) {
    Row row{QString::number(i), {}};
    for (const std::string& value : import_.file->rows[i].values) {
      row.cells.push_back({toQString(value)});
    }
    rows.push_back(std::move(row));
  }
  sample_->setRows(std::move(rows));
}

bool RosterColumnsPage::isComplete() const {
  return std::all_of(choices_.begin(), choices_.end(), [this](const auto& choice) {
    return !isRequired(choice.first, import_.kind) || choice.second->currentData().toInt() >= 0;
  });
}

bool RosterColumnsPage::validatePage() {
  for (const auto& [field, choice] : choices_) {
    const int column = choice->currentData().toInt();
    auto& chosen = import_.columns[static_cast<std::size_t>(field)];
    chosen = column < 0 ? std::nullopt : std::optional<std::size_t>(static_cast<std::size_t>(column));
  }
  keepColumns(*import_.file, import_.kind, import_.columns);
  return true;
}

RosterPreviewPage::RosterPreviewPage(RosterImport& import, ShellContext& shell, QWidget* parent)
    : QWizardPage(parent),
      import_(import),
      shell_(shell),
      summary_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      lines_(new DataTable(QStringLiteral("roster-preview"), this)) {
  setTitle(tr("What would happen"));
  setSubTitle(
      tr("Nothing is stored yet. With an error in any line nothing at all is imported: mend the file and "
         "choose it again."));
  setFinalPage(true);
  summary_->setWordWrap(true);
  progress_->setRange(0, kWhole);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("How far it has come"));
  progress_->hide();
  auto* column = new QVBoxLayout(this);
  column->setSpacing(2 * kSpace);
  column->addWidget(summary_);
  column->addWidget(progress_);
  column->addWidget(lines_, 1);
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
  lines_->setRows({});
  begin(
      tr("Comparing %n line(s) with the record\u2026", nullptr, static_cast<int>(import_.file->rows.size())));
  struct Found {
    std::optional<RosterPreview> preview;
    std::optional<Error> problem;
  };
  const auto found = std::make_shared<Found>();
  shell_.run(
      tr("Looking at the roster"),
      [found, file = *import_.file, kind = import_.kind, columns = import_.columns](
          SessionContext& session, const ProgressCallback& progress) {
        try {
          RosterPreview preview = previewRoster(session, file, kind, columns, progress);
          // Proves before the last button that the database would take it.
          if (preview.importable()) {
            static_cast<void>(importRoster(session, file, kind, columns, preview.fingerprint,
                                           RosterMode::kDryRun, progress));
          }
          found->preview = std::move(preview);
        } catch (const Error& error) {
          found->problem = error;
        }
      },
      [page = QPointer<RosterPreviewPage>(this), found] {
        if (page.isNull()) {
          return;
        }
        if (found->problem) {
          page->showProblem(rosterProblem(*found->problem));
          return;
        }
        page->import_.preview = std::move(found->preview);
        page->showPreview();
      });
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
    summary +=
        QLatin1Char(' ') +
        tr("The file was read as %1: look at letters with accents.").arg(toQString(import_.file->encoding));
  }
  summary_->setText(summary);
  // Every column that the file fills, so that what is taken can be read before it is.
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
  Q_EMIT completeChanged();
}

void RosterPreviewPage::commit(std::function<void()> done) {
  begin(tr("Importing\u2026"));
  const auto outcome = std::make_shared<RosterOutcome>();
  const auto problem = std::make_shared<std::optional<Error>>();
  shell_.run(
      tr("Importing the roster"),
      [outcome, problem, file = *import_.file, kind = import_.kind, columns = import_.columns,
       fingerprint = import_.preview->fingerprint](SessionContext& session,
                                                   const ProgressCallback& progress) {
        try {
          *outcome = importRoster(session, file, kind, columns, fingerprint, RosterMode::kCommit, progress);
        } catch (const Error& error) {
          *problem = error;
        }
      },
      [page = QPointer<RosterPreviewPage>(this), outcome, problem, done = std::move(done)] {
        if (page.isNull()) {
          return;
        }
        if (*problem) {
          page->showProblem(rosterProblem(**problem));
          return;
        }
        page->import_.outcome = std::move(*outcome);
        done();
      });
}

bool RosterPreviewPage::isComplete() const {
  return !busy_ && import_.preview && import_.preview->importable();
}

}  // namespace torsio::gui
