// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/reporting/export_dialog.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/job_panel.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/column_widths.h"
#include "app/gui/widgets/data_table_model.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/outputs/wording/joined_sentences.h"
#include "app/outputs/wording/wording.h"

namespace torsio::gui {

namespace {

constexpr int kDialogWidth = 936;
constexpr int kWidestDialog = 1240;
constexpr int kFirstRows = 8;
constexpr int kTableHeight = 130;  // must fit into 768 pixels together with the fields of a data set

}  // namespace

ExportDialog::ExportDialog(ShellContext& shell, const ReportRequest& request,
                           std::shared_ptr<TrialDigests> digests, std::string language, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      digests_(std::move(digests)),
      language_(std::move(language)),
      form_(named(new QComboBox(this), "format")),
      pseudonymised_(named(new QCheckBox(tr("&Pseudonymised"), this), "pseudonymised")),
      freeText_(named(new QCheckBox(tr("Keep what people &wrote"), this), "free-text")),
      reason_(named(new QLineEdit(this), "reason")),
      title_(named(new QLineEdit(this), "title")),
      licence_(named(new QComboBox(this), "licence")),
      citation_(named(new QLineEdit(this), "citation")),
      creator_(new QLineEdit(this)),
      rate_(named(new QComboBox(this), "rate")),
      what_(named(sentence(this, false), "what")),
      table_(named(new QComboBox(this), "table")),
      asInFile_(named(sentence(this), "as-in-file")),
      rows_(named(new QTableWidget(this), "rows")),
      done_(named(sentence(this, false), "done")) {
  request_.cohortId = request.cohortId;
  request_.campaignId = request.campaignId;
  request_.frozenId = request.frozenId;
  build();
  read();
}

void ExportDialog::build() {
  setWindowTitle(tr("Export for other programs"));
  const int room = parentWidget() != nullptr ? parentWidget()->window()->width() - 12 * kSpace : 0;
  setMinimumWidth(std::clamp(room, kDialogWidth, kWidestDialog));
  form_->addItem(tr("Workbook for spreadsheets (.xlsx), with charts"), static_cast<int>(Form::kWorkbook));
  form_->addItem(tr("Tables for SPSS (.sav)"), static_cast<int>(Form::kSpss));
  form_->addItem(tr("Tables for R (.csv and a script)"), static_cast<int>(Form::kR));
  form_->addItem(tr("Tables (.csv)"), static_cast<int>(Form::kCsv));
  form_->addItem(tr("Data set to be published (Frictionless)"), static_cast<int>(Form::kFrictionless));
  form_->addItem(tr("Data set to be published (RO-Crate)"), static_cast<int>(Form::kRoCrate));
  form_->addItem(tr("Data set to be published (Parquet)"), static_cast<int>(Form::kParquet));
  form_->addItem(tr("Data set to be published (BIDS)"), static_cast<int>(Form::kBids));
  form_->addItem(tr("Data set to be published (LeRobot)"), static_cast<int>(Form::kLerobot));
  form_->addItem(tr("Marks and a script that computes the report again (R)"),
                 static_cast<int>(Form::kReplication));
  if (shell_.may(Operation::kReportExportNamed)) {
    form_->addItem(tr("Scores for Moodle (.csv)"), static_cast<int>(Form::kMoodle));
    form_->addItem(tr("Scores for Canvas (.csv)"), static_cast<int>(Form::kCanvas));
    form_->addItem(tr("Scores for ILIAS (status file of an exercise, .csv)"), static_cast<int>(Form::kIlias));
  }
  if (!shell_.may(Operation::kPersonViewIdentity)) {
    pseudonymised_->setChecked(true);
    pseudonymised_->setEnabled(false);
  }
  freeText_->setEnabled(pseudonymised_->isChecked());
  reason_->setPlaceholderText(tr("For whom and what for; kept in the audit trail"));
  rows_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  rows_->setMinimumHeight(kTableHeight);
  rows_->setHorizontalHeader(new ColumnTitles(rows_));
  rows_->horizontalHeader()->setSectionsClickable(false);
  rows_->verticalHeader()->hide();
  rows_->setShowGrid(false);
  rows_->setItemDelegate(new PaddedCells(rows_));
  rows_->setAlternatingRowColors(true);
  rows_->setAccessibleName(tr("First rows"));
  asInFile_->setText(tr(
      "Below the headings, cells are exactly as the file will hold them: words in English, numbers with all "
      "their digits."));

  auto* form = new QFormLayout;
  form->addRow(tr("&Format"), form_);
  form->addRow(QString(), pseudonymised_);
  form->addRow(QString(), freeText_);
  form->addRow(tr("&Reason"), reason_);
  buildDataset(*form);
  form->addRow(tr("What is in it"), what_);
  form->addRow(tr("First rows &of"), table_);
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace});
  column->addLayout(form);
  column->addWidget(asInFile_);
  column->addWidget(rows_, 1);
  column->addWidget(done_);
  followJobs(*column);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  save_ = named(buttons->addButton(tr("&Save\u2026"), QDialogButtonBox::ActionRole), "save");
  column->addWidget(buttons);

  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(save_, &QPushButton::clicked, this, &ExportDialog::askPlace);
  connect(form_, &QComboBox::currentIndexChanged, this, &ExportDialog::showTable);
  connect(table_, &QComboBox::currentIndexChanged, this, &ExportDialog::showTable);
  connect(pseudonymised_, &QCheckBox::toggled, this, [this](bool on) {
    freeText_->setEnabled(on);
    read();
  });
  connect(freeText_, &QCheckBox::toggled, this, &ExportDialog::read);
}

/// Adds progress, cancel button and errors to this dialog: it blocks the window behind.
void ExportDialog::followJobs(QVBoxLayout& column) {
  job_ = new JobPanel(this);
  column.addWidget(job_);
  connect(job_, &JobPanel::cancelled, this, [this] { shell_.cancelJobs(); });
  connect(&shell_, &ShellContext::jobStarted, this, [this](const QString& title) {
    busy_ = true;
    setLook(done_, "caution", false);
    done_->clear();
    job_->begin(title);
  });
  connect(&shell_, &ShellContext::jobMoved, job_, &JobPanel::move);
  connect(&shell_, &ShellContext::jobEnded, this, [this] {
    busy_ = false;
    job_->end();
  });
  connect(
      &shell_, &ShellContext::jobEnded, this,
      [this] {
        if (closing_ && !busy_) {  // after the job's continuation
          QDialog::reject();
        }
      },
      Qt::QueuedConnection);
  connect(&shell_, &ShellContext::failed, this, [this](const QString& happened, const QString& remedy) {
    setLook(done_, "caution", true);
    done_->setText(happened + QStringLiteral(". ") + remedy);
  });
  connect(&shell_, &ShellContext::noticed, this, [this](const QString& words) { done_->setText(words); });
}

void ExportDialog::choose(Form form) {
  form_->setCurrentIndex(form_->findData(static_cast<int>(form)));
}

void ExportDialog::reject() {
  if (!busy_) {
    QDialog::reject();
    return;
  }
  closing_ = true;
  shell_.cancelJobs();
}

void ExportDialog::buildDataset(QFormLayout& form) {
  layout_ = &form;
  licence_->setEditable(true);
  licence_->addItems(
      {QStringLiteral("CC-BY-4.0"), QStringLiteral("CC-BY-NC-4.0"), QStringLiteral("CC0-1.0")});
  citation_->setPlaceholderText(tr("How users cite the data; may be empty"));
  creator_->setPlaceholderText(tr("Person or centre that publishes; may be empty"));
  for (const int rate_Hz : {10, 100, 1000}) {
    rate_->addItem(tr("%1 lines a second").arg(rate_Hz), rate_Hz);
  }
  rate_->setCurrentIndex(1);
  form.addRow(tr("&Title"), title_);
  form.addRow(tr("&Licence (SPDX)"), licence_);
  form.addRow(tr("C&itation"), citation_);
  form.addRow(tr("Publis&her"), creator_);
  form.addRow(tr("Tra&jectories"), rate_);
  connect(rate_, &QComboBox::currentIndexChanged, this, &ExportDialog::showTable);
}

ExportDialog::Form ExportDialog::chosen() const {
  return static_cast<Form>(form_->currentData().toInt());
}

bool ExportDialog::isDataset() const {
  return chosen() == Form::kFrictionless || chosen() == Form::kRoCrate || chosen() == Form::kParquet ||
         chosen() == Form::kBids || chosen() == Form::kLerobot;
}

DatasetRequest ExportDialog::dataset() const {
  DatasetRequest request;
  request.about.title = title_->text().trimmed().toStdString();
  request.about.licence = licence_->currentText().trimmed().toStdString();
  request.about.citation = citation_->text().trimmed().toStdString();
  request.about.creator = creator_->text().trimmed().toStdString();
  request.layout = chosen() == Form::kBids      ? DatasetLayout::kBids
                   : chosen() == Form::kLerobot ? DatasetLayout::kLerobot
                   : chosen() == Form::kRoCrate ? DatasetLayout::kRoCrate
                   : chosen() == Form::kParquet ? DatasetLayout::kParquet
                                                : DatasetLayout::kFrictionless;
  request.rate_Hz = rate_->currentData().toInt();
  return request;
}

std::optional<GradebookForm> ExportDialog::system() const {
  switch (chosen()) {
    case Form::kMoodle:
      return GradebookForm::kMoodle;
    case Form::kCanvas:
      return GradebookForm::kCanvas;
    case Form::kIlias:
      return GradebookForm::kIlias;
    default:
      return std::nullopt;
  }
}

QStringList ExportDialog::contents() const {
  QStringList words;
  if (chosen() == Form::kIlias) {
    words << tr(
        "The status file of an exercise, which you download from ILIAS first, with each trainee's score of "
        "the last occasion as the mark. Trainees are found by their login: the staff number or the mail "
        "address. It names people.");
    return words;
  }
  if (system()) {
    words << tr(
        "A line for each trainee, identified by staff number and mail address, and a score for each "
        "occasion. It names people.");
    return words;
  }
  words << tr("Nobody is named. Marks and means that may not be shown yet are left out, as in the report.");
  for (const Text& sentence : pseudonymSentences(*data_)) {
    words << toQString(sentence);
  }
  if (chosen() == Form::kReplication) {
    words << tr(
        "Every mark, the measures of each run, the numbers of the report, and a script for R that computes "
        "them again, in a new folder. Anybody can run it: Rscript analysis.R.");
  }
  if (isDataset()) {
    words << tr(
        "The tables below, the paths and forces of %n recordings, parameters of the tissue models, "
        "curriculum and definitions of metrics, in a new folder. No recordings that Torsio could "
        "replay.",
        nullptr, static_cast<int>(data_->inputs.trials.size()));
    if (chosen() == Form::kLerobot) {
      words << tr(
          "Each recording of the simulator is an episode; recordings of other equipment have another rate "
          "and "
          "are left out.");
    }
    words << tr("Paths reveal how a person moves: publish them only with consent for that.");
  }
  return words;
}

void ExportDialog::read() {
  data_.reset();
  save_->setEnabled(false);
  request_.pseudonymised = pseudonymised_->isChecked();
  request_.withFreeText = freeText_->isChecked();
  shell_.run(
      this, tr("Reading what will be exported"),
      [wanted = request_, digests = digests_](SessionContext& session, const ProgressCallback& progress) {
        return std::make_shared<ExchangeData>(exchangeData(session, wanted, *digests, progress));
      },
      [this](std::shared_ptr<ExchangeData> fresh) {
        data_ = std::move(fresh);
        save_->setEnabled(true);
        if (!title_->isModified()) {  // without names the cohort has a different title
          title_->setText(toQString(data_->inputs.title));
        }
        const QSignalBlocker quiet(table_);
        const int before = std::max(0, table_->currentIndex());
        table_->clear();
        for (const ExportTable* table : tablesOf(data_->set)) {
          table_->addItem(
              tr("%1 (%n rows)", nullptr, static_cast<int>(table->rows.size())).arg(toQString(table->title)));
        }
        table_->setCurrentIndex(before);
        showTable();
      });
}

void ExportDialog::showTable() {
  if (!data_) {
    return;
  }
  const bool grades = system().has_value();
  pseudonymised_->setVisible(!grades);
  freeText_->setVisible(!grades);
  table_->setEnabled(!grades);
  rows_->setVisible(!grades);
  asInFile_->setVisible(!grades);
  for (QWidget* field : std::initializer_list<QWidget*>{title_, licence_, citation_, creator_, rate_}) {
    layout_->setRowVisible(field, isDataset());
  }
  what_->setText(joinedSentences(contents()));
  const std::vector<const ExportTable*> tables = tablesOf(data_->set);
  const ExportTable& shown = *tables.at(static_cast<std::size_t>(std::max(0, table_->currentIndex())));
  const int count = std::min(kFirstRows, static_cast<int>(shown.rows.size()));
  rows_->clear();
  rows_->setColumnCount(static_cast<int>(shown.columns.size()));
  rows_->setRowCount(count);
  QStringList heads;
  for (const ExportColumn& column : shown.columns) {
    heads << toQString(column.title) +
                 (column.unit.empty() ? QString() : QStringLiteral(", ") + toQString(column.unit));
  }
  rows_->setHorizontalHeaderLabels(heads);
  for (int c = 0; c < heads.size(); ++c) {  // aligns headings with their values
    const bool number =
        count > 0 && !std::holds_alternative<std::string>(shown.rows[0][static_cast<std::size_t>(c)]);
    rows_->horizontalHeaderItem(c)->setTextAlignment((number ? Qt::AlignRight : Qt::AlignLeft) |
                                                     Qt::AlignVCenter);
  }
  for (int r = 0; r < count; ++r) {
    const auto& cells = shown.rows[static_cast<std::size_t>(r)];
    for (std::size_t c = 0; c < cells.size(); ++c) {
      auto* item = new QTableWidgetItem(toQString(cellText(cells[c])));
      if (!std::holds_alternative<std::string>(cells[c])) {
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      }
      rows_->setItem(r, static_cast<int>(c), item);
    }
  }
  rows_->resizeColumnsToContents();
}

void ExportDialog::askPlace() {
  const bool book = chosen() == Form::kWorkbook;
  const bool grades = system().has_value();
  QString status;
  if (chosen() == Form::kIlias) {
    status = askFileToOpen(this, tr("Status file from ILIAS"), tr("Table (*.csv)"));
    if (status.isEmpty()) {
      return;
    }
  }
  const QString name = data_ ? toQString(data_->inputs.title) : QString();
  const QString place =
      book ? askFileToSave(this, tr("Save workbook"), name + QStringLiteral(".xlsx"), tr("Workbook (*.xlsx)"))
      : grades ? askFileToSave(this, tr("Save scores"), name + QStringLiteral(".csv"), tr("Table (*.csv)"))
      : chosen() == Form::kReplication
          ? askFileToSave(this, tr("New folder"), tr("replication-%1").arg(name), tr("Folder (*)"))
      : isDataset()
          ? askFileToSave(this, tr("New folder for the data set"), tr("dataset-%1").arg(name),
                          tr("Folder (*)"))
          : askFileToSave(this, tr("New folder for the tables"), tr("tables-%1").arg(name), tr("Folder (*)"));
  if (!place.isEmpty()) {
    writeTo(toPath(place), toPath(status));
  }
}

void ExportDialog::writeTo(const std::filesystem::path& place, const std::filesystem::path& status) {
  if (!data_) {
    return;
  }
  request_.reason = reason_->text().trimmed().toStdString();
  data_->request.reason = request_.reason;
  if (isDataset() && !attempt(shell_, [this] { requireWhole(dataset().about); })) {
    return;
  }
  shell_.run(
      this, tr("Writing the export"),
      [place, given = data_, request = request_, digests = digests_, form = chosen(), wanted = dataset(),
       grades = GradebookRequest{system().value_or(GradebookForm::kMoodle), status, {}},
       wording = wordingIn(language_, Signs::kOfFiles)](SessionContext& session,
                                                        const ProgressCallback& progress) {
        switch (form) {
          case Form::kWorkbook:
            return exportWorkbook(
                session, *given, [&](const Text& text) { return wording(text).toStdString(); }, place,
                progress);
          case Form::kSpss:
            return exportTables(session, *given, TableFormat::kSpss, place, progress);
          case Form::kR:
            return exportTables(session, *given, TableFormat::kR, place, progress);
          case Form::kCsv:
            return exportTables(session, *given, TableFormat::kCsv, place, progress);
          case Form::kReplication:
            return exportReplication(session, *given, place);
          case Form::kMoodle:
          case Form::kCanvas:
          case Form::kIlias:
            return exportGradebook(session, request, *digests, grades, place);
          case Form::kFrictionless:
          case Form::kRoCrate:
          case Form::kParquet:
          case Form::kBids:
          case Form::kLerobot:
            break;
        }
        return exportDataset(session, *given, wanted, place, progress);
      },
      [this, place](const ExchangeFiles& written) {
        done_->setText(tr("Written: %1 (%n files). Hash: %2", nullptr, static_cast<int>(written.files.size()))
                           .arg(toQString(place.string()), toQString(written.contentHash)));
        setLook(done_, "caution", !written.notes.empty());
        if (!written.notes.empty()) {
          done_->setText(done_->text() + QLatin1Char('\n') + translatedLines(written.notes));
        }
      });
}

}  // namespace torsio::gui
