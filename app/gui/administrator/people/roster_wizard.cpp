// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/people/roster_wizard.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QUrl>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio::gui {

namespace {

constexpr std::size_t kSampleRows = 5;

/// Settings key of the column choices for files with these headings, which contain no personal data.
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

/// Returns the previous choices for the same headings, or those suggested by the headings.
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
  setButtonText(QWizard::BackButton, tr("< &Back"));
  setButtonText(QWizard::NextButton, tr("&Next >"));
  setButtonText(QWizard::CancelButton, tr("Cancel"));
  setButtonText(QWizard::FinishButton, tr("&Import"));
  setMinimumSize(760, 560);
  addPage(new RosterFilePage(import_, this));
  addPage(new RosterColumnsPage(import_, this));
  preview_ = new RosterPreviewPage(import_, shell, this);
  addPage(preview_);
  // After the job and its continuation.
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
      path_(named(new QLineEdit(this), "path")),
      columns_(sentence(this)),
      problem_(fieldHint(this)),
      templateProblem_(fieldHint(this)),
      checks_(new FieldChecks(this)) {
  setTitle(tr("The file"));
  setSubTitle(
      tr("A table saved as CSV (UTF-8), one person a line, with a header line. People are identified by "
         "their staff or student number, never by an e-mail address alone."));
  trainees_->setChecked(true);
  path_->setPlaceholderText(tr("Path of the CSV file"));
  path_->setAccessibleName(tr("Path of the CSV file"));
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
  column->addWidget(problem_);
  column->addWidget(columns_);
  column->addWidget(blank, 0, Qt::AlignLeft);
  column->addWidget(templateProblem_);
  column->addStretch(1);
  connect(raters_, &QRadioButton::toggled, this, &RosterFilePage::sayColumns);
  connect(choose, &QPushButton::clicked, this, &RosterFilePage::choose);
  connect(blank, &QPushButton::clicked, this, &RosterFilePage::saveTemplate);
  connect(path_, &QLineEdit::textChanged, this, [this] {
    unreadable_.clear();
    Q_EMIT completeChanged();
  });
  checks_->add(problem_, path_,
               [this] { return isComplete() ? unreadable_ : tr("Choose the file, or type its path."); });
}

void RosterFilePage::initializePage() {
  sayColumns();
  path_->setFocus();
}

/// Lists the possible columns of the file, so that nobody needs the guide.
void RosterFilePage::sayColumns() {
  const RosterKind kind = raters_->isChecked() ? RosterKind::kRaters : RosterKind::kTrainees;
  QStringList needed;
  QStringList other;
  for (const RosterField field : rosterFields(kind)) {
    (isRequired(field, kind) ? needed : other) << rosterFieldName(field);
  }
  columns_->setText(tr("Required columns: %1. Optional columns: %2. Their order and headings do not matter; "
                       "the next step asks which is which.")
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
    // A corrected file with the same headings keeps its column choices.
    if (import_.file->header != headerBefore || import_.kind != kindBefore) {
      import_.columns = columnsFor(*import_.file, import_.kind);
    }
    unreadable_.clear();
  } catch (const Error& error) {
    unreadable_ = rosterProblem(error);
  }
  checks_->touch(path_);
  return unreadable_.isEmpty();
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
    sayHint(templateProblem_, {});
  } catch (const Error& error) {
    sayHint(templateProblem_, rosterProblem(error));
  }
}

RosterColumnsPage::RosterColumnsPage(RosterImport& import, QWidget* parent)
    : QWizardPage(parent),
      import_(import),
      form_(new QGridLayout),
      sample_(new DataTable(QString(), this)),
      hint_(named(sentence(this, false), "rosterHint")) {
  setTitle(tr("The columns"));
  setSubTitle(
      tr("Match the columns to the fields. Fields with a star are required; the first lines of the file are "
         "shown below."));
  auto* column = new QVBoxLayout(this);
  column->setSpacing(2 * kSpace);
  form_->setHorizontalSpacing(kSpace);
  form_->setVerticalSpacing(kSpace);
  for (const int side : {1, 3}) {
    form_->setColumnStretch(side, 1);
  }
  sample_->filter().hide();
  setLook(hint_, "caution", true);
  column->addLayout(form_);
  column->addWidget(hint_);
  column->addWidget(sample_, 1);
}

RosterColumnsPage::~RosterColumnsPage() = default;

void RosterColumnsPage::initializePage() {
  checks_.reset();  // destroyed before its fields
  while (QLayoutItem* item = form_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  choices_.clear();
  checks_ = std::make_unique<FieldChecks>(this);
  for (const RosterField field : rosterFields(import_.kind)) {
    addChoice(field);
  }
  showSample();
  showHint();
}

/// Adds a choice, two per row, with its hint below.
void RosterColumnsPage::addChoice(RosterField field) {
  auto* choice = new QComboBox(this);
  choice->setObjectName(QString::fromLatin1(rosterFieldCode(field).data()));
  choice->addItem(tr("not in this file"), -1);
  for (std::size_t i = 0; i < import_.file->header.size(); ++i) {
    choice->addItem(toQString(import_.file->header[i]), static_cast<int>(i));
  }
  const auto& suggested = import_.columns[static_cast<std::size_t>(field)];
  choice->setCurrentIndex(suggested ? static_cast<int>(*suggested) + 1 : 0);
  const QString name = rosterFieldName(field);
  const bool needed = isRequired(field, import_.kind);
  auto* label = new QLabel(needed ? tr("%1 *").arg(name) : name, this);
  label->setBuddy(choice);
  choice->setAccessibleName(name);
  const auto place = static_cast<int>(choices_.size());
  const int row = place / 2 * 2;
  const int side = place % 2 * 2;
  form_->addWidget(label, row, side);
  form_->addWidget(choice, row, side + 1);
  choices_[field] = choice;
  connect(choice, &QComboBox::currentIndexChanged, this, &QWizardPage::completeChanged);
  if (needed) {
    QLabel* missing = fieldHint(this);
    keepPlace(missing, missing->fontMetrics().height());
    form_->addWidget(missing, row + 1, side + 1);
    checks_->add(missing, choice, [choice] {
      return choice->currentData().toInt() < 0 ? tr("Required: choose its column, or add one to the file.")
                                               : QString();
    });
    checks_->touch(choice);  // not inferred from the headings: marked as needing an answer
  }
}

/// Warns of a file of raters before they become trainees.
void RosterColumnsPage::showHint() {
  const std::optional<std::size_t> raterClass =
      import_.kind == RosterKind::kTrainees
          ? suggestColumns(*import_.file,
                           RosterKind::kRaters)[static_cast<std::size_t>(RosterField::kRaterClass)]
          : std::nullopt;
  hint_->setVisible(raterClass.has_value());
  if (raterClass) {
    hint_->setText(
        tr("! The column %1 looks like the class of raters. If this file lists raters, go back and "
           "choose Raters.")
            .arg(toQString(import_.file->header[*raterClass])));
  }
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

namespace {

struct RosterTexts {
  Q_DECLARE_TR_FUNCTIONS(RosterTexts)
};

}  // namespace

void keepPlace(QWidget* widget, int height_px) {
  QSizePolicy kept = widget->sizePolicy();
  kept.setRetainSizeWhenHidden(true);
  widget->setSizePolicy(kept);
  widget->setMinimumHeight(height_px);
}

QString rosterFieldName(RosterField field) {
  return toQString(Text(rosterFieldLabel(field)));
}

QString rosterStatusName(RosterStatus status) {
  switch (status) {
    case RosterStatus::kNew:
      return RosterTexts::tr("+ new");
    case RosterStatus::kSame:
      return RosterTexts::tr("= as it is");
    case RosterStatus::kChanges:
      return RosterTexts::tr("\u2192 changes");
    case RosterStatus::kError:
      return RosterTexts::tr("! error");
  }
  return {};
}

QString rosterNote(const RosterRow& row) {
  QStringList parts;
  if (!row.problem.empty()) {
    parts << RosterTexts::tr("%1. %2.").arg(toQString(row.problem), toQString(row.remedy));
  }
  for (const RosterChange& change : row.changes) {
    parts << RosterTexts::tr("%1: %2 \u2192 %3")
                 .arg(rosterFieldName(change.field),
                      change.from.empty() ? QStringLiteral("\u2013") : toQString(change.from),
                      toQString(change.to));
  }
  if (!row.hint.empty()) {
    parts << toQString(row.hint);
  }
  return parts.join(QStringLiteral("; "));
}

QString rosterProblem(const Error& error) {
  const TranslatedError said = translated(error);
  const QString what =
      said.details.isEmpty() ? said.happened : RosterTexts::tr("%1 (%2)").arg(said.happened, said.details);
  return (said.remedy.isEmpty() ? RosterTexts::tr("%1.").arg(what)
                                : RosterTexts::tr("%1. %2.").arg(what, said.remedy));
}

}  // namespace torsio::gui
