// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/reporting/reports_page.h"

#include <QApplication>
#include <QComboBox>
#include <QGridLayout>
#include <QInputDialog>
#include <QLabel>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/reporting/export_dialog.h"
#include "app/gui/administrator/reporting/report_preview.h"
#include "app/gui/base/language.h"
#include "app/gui/base/placed_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/sign_dialog.h"
#include "app/gui/base/table_choice.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/report/coded_tables.h"
#include "app/outputs/wording/wording.h"
#include "app/services/study/frozen_data.h"
#include "assessment/results/cohort_report.h"
#include "sim/core/file_io.h"

namespace torsio::gui {

namespace {

QLabel* gridField(QGridLayout* grid, int line, int column, QWidget* field) {
  auto* label = new QLabel;
  label->setBuddy(field);
  grid->addWidget(label, 2 * line, column);
  grid->addWidget(field, 2 * line + 1, column);
  return label;
}

}  // namespace

ReportsPage::ReportsPage(ShellContext& shell)
    : Page(shell),
      digests_(std::make_shared<TrialDigests>(shell.assets())),
      heading_(new PageHeading(this)),
      pdf_(primaryButton(this)),
      csv_(new QPushButton(this)),
      tables_(named(new QPushButton(this), "codedTables")),
      other_(named(new QPushButton(this), "export")),
      origin_(named(new QPushButton(this), "origin")),
      cohort_(new QComboBox(this)),
      campaign_(new QComboBox(this)),
      frozen_(named(new QComboBox(this), "dataSet")),
      freeze_(new QPushButton(this)),
      identity_(named(new QComboBox(this), "identity")),
      language_(named(new QComboBox(this), "language")),
      warning_(sentence(this)),
      preview_(named(new ReportPreview(this), "preview")) {
  tables_->setVisible(shell.may(Operation::kTrialViewCoded) || shell.may(Operation::kMarkViewCoded));
  heading_->addAction(origin_);
  heading_->addAction(tables_);
  heading_->addAction(other_);
  heading_->addAction(csv_);
  heading_->addAction(pdf_);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * kSpace);
  grid->setVerticalSpacing(kSpace / 2);
  cohortLabel_ = gridField(grid, 0, 0, cohort_);
  campaignLabel_ = gridField(grid, 0, 1, campaign_);
  frozenLabel_ = gridField(grid, 0, 2, frozen_);
  grid->addWidget(freeze_, 1, 3);
  identityLabel_ = gridField(grid, 1, 0, identity_);
  languageLabel_ = gridField(grid, 1, 1, language_);
  for (const int column : {0, 1, 2}) {
    grid->setColumnStretch(column, 1);  // names of cohorts and campaigns are long
  }
  for (QComboBox* box : {cohort_, campaign_, frozen_, identity_}) {
    box->setMinimumContentsLength(10);
  }
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addLayout(grid);
  column->addWidget(warning_);
  column->addWidget(preview_, 1);

  connect(cohort_, &QComboBox::currentIndexChanged, this, [this] {
    fillFrozen();
    compute();
  });
  for (QComboBox* box : {campaign_, frozen_, identity_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &ReportsPage::compute);
  }
  connect(language_, &QComboBox::currentIndexChanged, this, &ReportsPage::showReport);
  connect(freeze_, &QPushButton::clicked, this, &ReportsPage::askFreeze);
  connect(pdf_, &QPushButton::clicked, this, [this] { askExport(ReportFormat::kPdf); });
  connect(tables_, &QPushButton::clicked, this, &ReportsPage::askTables);
  connect(other_, &QPushButton::clicked, this, &ReportsPage::askOther);
  connect(csv_, &QPushButton::clicked, this, [this] { askExport(ReportFormat::kCsv); });
  connect(origin_, &QPushButton::clicked, this, [this] { askOrigin({}); });
  connect(preview_, &ReportPreview::numberPressed, this, &ReportsPage::askOrigin);
  const QSignalBlocker quietLanguage(language_);
  language_->addItem(QString(), QString());  // the window's language
  for (const Language language : {Language::kEnglish, Language::kSimplifiedChinese}) {
    language_->addItem(languageName(language), languageCode(language));
  }
  const QSignalBlocker quiet(identity_);
  identity_->addItem(QString(), static_cast<int>(ReportIdentity::kCoded));
  identity_->addItem(QString(), static_cast<int>(ReportIdentity::kAggregated));
  if (shell.may(Operation::kReportExportNamed) && shell.may(Operation::kPersonViewIdentity)) {
    identity_->addItem(QString(), static_cast<int>(ReportIdentity::kNamed));
  }
  retranslate();
}

void ReportsPage::enter(const QVariant& argument) {
  attempt(shell(), [&] {
    SessionContext& session = shell().session();
    fillCohorts(cohort_, session, CohortFirst::kStudy);
    {
      const QSignalBlocker quiet(cohort_);
      chooseId(cohort_, argument.toString().toStdString());
    }
    fillCampaigns(campaign_, session, tr("none"));
    fillFrozen();
    compute();
  });
}

void ReportsPage::fillFrozen() {
  attempt(shell(), [&] {
    const std::string before = chosenId(frozen_);
    const QSignalBlocker quiet(frozen_);
    frozen_->clear();
    frozen_->addItem(tr("live data"), QString());
    const std::string cohort = chosenId(cohort_);
    if (cohort.empty()) {
      return;
    }
    for (const FrozenRow& row : frozenData(shell().session(), cohort)) {
      frozen_->addItem(
          QStringLiteral("%1 (%2)").arg(toQString(row.name), shownTime(row.createdUtc_us, locale())),
          toQString(row.id));
    }
    if (!before.empty()) {
      chooseId(frozen_, before);
    }
  });
}

ReportRequest ReportsPage::request() const {
  ReportRequest request{.cohortId = chosenId(cohort_),
                        .campaignId = chosenId(campaign_),
                        .frozenId = chosenId(frozen_),
                        .identity = static_cast<ReportIdentity>(identity_->currentData().toInt())};
  return request;
}

void ReportsPage::compute() {
  inputs_.reset();
  model_.reset();
  showButtons();
  const ReportRequest wanted = request();
  if (wanted.cohortId.empty()) {
    preview_->clear();
    return;
  }
  shell().run(
      this, tr("Preparing the report"),
      [wanted, digests = digests_](SessionContext& session, const ProgressCallback& progress) {
        auto inputs = std::make_shared<CohortInputs>(reportInputs(session, wanted, *digests, progress));
        auto model = std::make_shared<ReportModel>(cohortReport(*inputs));
        return std::pair(std::move(inputs), std::move(model));
      },
      [this](auto report) {
        std::tie(inputs_, model_) = std::move(report);
        showReport();
        showButtons();
      });
}

std::string ReportsPage::reportLanguage() const {
  const QString chosen = language_->currentData().toString();
  return (chosen.isEmpty() ? languageCode(presentLanguage()) : chosen).toStdString();
}

void ReportsPage::showReport() {
  if (!model_) {
    return;
  }
  shownLanguage_ = reportLanguage();
  preview_->setReport(*model_, wordingIn(shownLanguage_));
}

void ReportsPage::settle() {
  shell().waitForJobs();
}

void ReportsPage::showButtons() {
  const bool ready = inputs_ != nullptr;
  pdf_->setEnabled(ready);
  csv_->setEnabled(ready);
  other_->setEnabled(ready);
  origin_->setEnabled(ready);
  freeze_->setEnabled(cohort_->count() > 0);
  tables_->setEnabled(cohort_->count() > 0);
  QString words;
  if (ready && inputs_->identity == ReportIdentity::kNamed) {
    words = tr("This report will name the trainees. The audit trail records that you saved it.");
  } else if (ready && inputs_->freeze && !inputs_->freeze->unchanged) {
    words = tr("The record has changed since this data set was frozen; the report says so.");
  } else if (ready && !inputs_->freeze) {
    words =
        tr("For a report that others rely on, freeze the data first: then anybody can check later that "
           "nothing changed.");
  }
  warning_->setText(words);
  warning_->setVisible(!words.isEmpty());
}

void ReportsPage::askFreeze() {
  bool given = false;
  const QString name = QInputDialog::getText(
      this, tr("Freeze data"),
      tr("Name of the data set. It keeps a list of everything the report is made of, with hashes."),
      QLineEdit::Normal, QString(), &given);
  if (given && !name.trimmed().isEmpty()) {
    attempt(shell(), [&] {
      if (const std::optional<std::string> why = askWhyIncomplete()) {
        freeze(name.trimmed().toStdString(), *why);
      }
    });
  }
}

std::optional<std::string> ReportsPage::askWhyIncomplete() {
  const SheetCount sheets = sheetCount(shell().session(), chosenId(cohort_));
  if (sheets.complete()) {
    return std::string();
  }
  bool given = false;
  const QString why = QInputDialog::getText(this, tr("Freeze an interim state"),
                                            tr("%1.\nLooking at results before the end of a study makes "
                                               "false findings more likely; every report of "
                                               "this data set will say that it is interim, and why:")
                                                .arg(toQString(sentenceOf(sheets))),
                                            QLineEdit::Normal, QString(), &given);
  if (!given || why.trimmed().isEmpty()) {
    return std::nullopt;
  }
  return why.trimmed().toStdString();
}

bool ReportsPage::freeze(const std::string& name, const std::string& whyIncomplete) {
  const DutyWish look{.act = DutyAct::kFreezeInterim,
                      .subject = chosenId(cohort_),
                      .shown = cohort_->currentText().toStdString(),
                      .reason = whyIncomplete};
  bool now = whyIncomplete.empty();
  const bool known = attempt(shell(), [&] {
    now = now || mayFreezeNow(shell().session(), look.subject);
    if (!now) {  // before the password: whoever asks signs nothing
      (void)offerToAsk(this, shell(), look);
    }
  });
  if (!known || !now) {
    return false;
  }
  if (!readyToSign(this, shell(), SignatureMeaning::kFroze)) {
    return false;
  }
  return attempt(shell(), [&] {
    std::vector<CampaignId> campaigns;
    if (const CampaignId campaign = chosenId(campaign_); !campaign.empty()) {
      campaigns.push_back(campaign);
    }
    const FrozenRow row = freezeData(shell().session(), chosenId(cohort_), name, campaigns, whyIncomplete);
    fillFrozen();
    chooseId(frozen_, row.id);
    shell().notify(tr("Frozen as \u201C%1\u201D").arg(toQString(row.name)));
  });
}

void ReportsPage::askExport(ReportFormat format) {
  if (!inputs_) {
    return;
  }
  if (format == ReportFormat::kCsv) {
    const TableChoice choice = askTableToSave(this, tr("Save table of numbers"), cohort_->currentText());
    if (!choice.file.isEmpty()) {
      exportTo(format, toPath(choice.file), choice.look);
    }
    return;
  }
  const QString file = askFileToSave(this, tr("Save report"), cohort_->currentText() + QStringLiteral(".pdf"),
                                     tr("PDF (*.pdf)"));
  if (!file.isEmpty()) {
    exportTo(format, toPath(file));
  }
}

void ReportsPage::askOther() {
  attempt(shell(), [&] { ExportDialog(shell(), request(), digests_, reportLanguage(), this).exec(); });
}

ExportDialog& ReportsPage::placeExport() {
  auto* dialog = new ExportDialog(shell(), request(), digests_, reportLanguage(), window());
  shell().waitForJobs();
  placeDialog(*dialog);
  return *dialog;
}

void ReportsPage::askOrigin(const QString& address) {
  if (!inputs_) {
    return;
  }
  attempt(shell(), [&] {
    TraceDialog dialog(shell(), chosenId(cohort_), inputs_, this);
    if (!address.isEmpty()) {
      dialog.follow(address);
    }
    dialog.exec();
  });
}

void ReportsPage::askTables() {
  const QString folder = askFileToSave(this, tr("New folder for the tables"),
                                       tr("tables-%1").arg(cohort_->currentText()), tr("Folder (*)"));
  if (!folder.isEmpty()) {
    exportTables(toPath(folder));
  }
}

bool ReportsPage::exportTables(const std::filesystem::path& folder) {
  return attempt(shell(), [&] {
    ensureFolder(folder);
    SessionContext& session = shell().session();
    const std::string cohort = chosenId(cohort_);
    std::size_t recordings = 0;
    std::size_t marks = 0;
    if (shell().may(Operation::kTrialViewCoded)) {
      recordings = exportRecordings(session, cohort, folder / "recordings.csv", usualTableLook());
    }
    if (shell().may(Operation::kMarkViewCoded)) {
      marks = exportMarks(session, cohort, folder / "marks.csv", usualTableLook());
      exportCriteria(session, cohort, folder / "criteria.csv", usualTableLook());
      exportRubrics(session, cohort, folder / "rubrics.csv", usualTableLook());
    }
    shell().notify(tr("Recordings (%1) and marks (%2) written to %3")
                       .arg(recordings)
                       .arg(marks)
                       .arg(toQString(folder.string())));
  });
}

bool ReportsPage::exportTo(ReportFormat format, const std::filesystem::path& file, const CsvStyle& look) {
  if (!inputs_) {
    return false;
  }
  QProgressDialog wait(tr("Writing the report\u2026"), tr("Cancel"), 0, 0, this);
  wait.setWindowModality(Qt::WindowModal);
  wait.setMinimumDuration(400);
  // Charts must be drawn in the GUI thread, so the window processes events between pages.
  const auto oneMore = [&wait](std::size_t page, std::size_t pages) {
    wait.setMaximum(static_cast<int>(pages));
    wait.setValue(static_cast<int>(page));
    QApplication::processEvents();
    if (wait.wasCanceled()) {
      throw Cancelled{};
    }
  };
  return attempt(
      shell(),
      [&] {
        const ReportExport done = exportReport(shell().session(), request(), *inputs_, format, file,
                                               reportLanguage(), oneMore, look);
        shell().notify(tr("Written: %1").arg(toQString(done.file)));
      },
      tr("Cancelled; no file was written"));
}

void ReportsPage::retranslate() {
  heading_->setTexts(tr("Reports"),
                     tr("Choose a cohort, freeze its data, look through the report, and write it."));
  pdf_->setText(tr("Save &PDF\u2026"));
  other_->setText(tr("E&xport\u2026"));
  other_->setToolTip(tr(
      "Workbook, tables for SPSS and R, data sets, scores for a learning system; pseudonymised if wanted"));
  csv_->setText(tr("Save &numbers (CSV)\u2026"));
  origin_->setText(tr("Follow a numbe&r\u2026"));
  origin_->setToolTip(
      tr("Every number back to its marks, criteria, scoring sheet, recording and program. In the preview, "
         "press a number itself."));
  tables_->setText(tr("Coded &tables\u2026"));
  tables_->setToolTip(tr("Recordings and single marks under their codes, as far as you may see them"));
  cohortLabel_->setText(tr("&Cohort"));
  campaignLabel_->setText(tr("&Evaluation of models"));
  frozenLabel_->setText(tr("&Data"));
  freeze_->setText(tr("&Freeze\u2026"));
  identityLabel_->setText(tr("People are &shown"));
  identity_->setItemText(0, tr("by code"));
  identity_->setItemText(1, tr("aggregated only"));
  if (identity_->count() > 2) {
    identity_->setItemText(2, tr("trainees with names"));
  }
  if (campaign_->count() > 0) {
    campaign_->setItemText(0, tr("none"));
  }
  if (frozen_->count() > 0) {
    frozen_->setItemText(0, tr("live data"));
  }
  languageLabel_->setText(tr("&Language of the report"));
  language_->setItemText(0, tr("as the window"));
  if (shownLanguage_ != reportLanguage()) {
    showReport();
  }
  preview_->setAccessibleName(tr("Preview of the report"));
  showButtons();
}

}  // namespace torsio::gui
