// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/office/curricula_page.h"

#include <algorithm>
#include <optional>

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/gui/look/data_table.h"
#include "app/gui/look/page_heading.h"
#include "app/gui/office/curriculum_editor.h"
#include "app/gui/office/office_parts.h"
#include "app/gui/office/study_words.h"
#include "app/gui/office/user_dialogs.h"
#include "app/gui/shell/shell_context.h"

namespace torsio::gui {

namespace {

constexpr int kListWidth = 330;

}  // namespace

CurriculaPage::CurriculaPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      add_(new QPushButton(this)),
      table_(new DataTable(QStringLiteral("curricula"), this)),
      state_(new QLabel(this)),
      save_(new QPushButton(this)),
      publish_(new QPushButton(this)),
      begin_(new QPushButton(this)),
      close_(new QPushButton(this)),
      editor_(new CurriculumEditor(shell.assets(), this)) {
  add_->setProperty("primary", true);
  heading_->addAction(add_);
  auto* right = new QWidget(this);
  auto* rightColumn = new QVBoxLayout(right);
  rightColumn->setContentsMargins(0, 0, 0, 0);
  rightColumn->setSpacing(kSpace);
  auto* acts = new QHBoxLayout;
  acts->setSpacing(kSpace);
  state_->setObjectName(QStringLiteral("cardTitle"));
  acts->addWidget(state_, 1);
  for (QPushButton* button : {save_, publish_, begin_, close_}) acts->addWidget(button);
  rightColumn->addLayout(acts);
  rightColumn->addWidget(editor_, 1);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(table_);
  splitter->addWidget(right);
  splitter->setStretchFactor(0, 2);
  splitter->setStretchFactor(1, 3);
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(2 * kSpace);
  splitter->setStyleSheet(QStringLiteral("QSplitter::handle { background: transparent; }"));
  table_->setMinimumWidth(kListWidth);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addWidget(splitter, 1);

  connect(add_, &QPushButton::clicked, this, &CurriculaPage::askNew);
  connect(save_, &QPushButton::clicked, this, &CurriculaPage::save);
  connect(publish_, &QPushButton::clicked, this, &CurriculaPage::askPublish);
  connect(begin_, &QPushButton::clicked, this, &CurriculaPage::begin);
  connect(close_, &QPushButton::clicked, this, &CurriculaPage::askClose);
  connect(table_, &DataTable::currentChanged, this, &CurriculaPage::showDraft);
  connect(editor_, &CurriculumEditor::edited, this, [this] {
    dirty_ = true;
    showButtons();
  });
  retranslate();
}

void CurriculaPage::enter(const QVariant& argument) {
  read();
  if (argument.isValid()) table_->select(argument.toString());
  if (table_->currentId().isEmpty() && !rows_.empty()) table_->select(shown(rows_.front().curriculum.id));
}

bool CurriculaPage::leave() {
  return !dirty_ || save();  // a draft is kept: nothing typed is ever lost
}

void CurriculaPage::read() {
  attempt(shell(), [&] {
    rows_ = torsio::curricula(shell().workplace());
    show();
  });
}

void CurriculaPage::show() {
  std::vector<Row> rows;
  for (const CurriculumRow& row : rows_) {
    const CurriculumVersionRow* newest = row.versions.empty() ? nullptr : &row.versions.back();
    rows.push_back(
        {shown(row.curriculum.id),
         {{shown(row.curriculum.name)},
          {newest != nullptr ? tr("%1, %2").arg(newest->number).arg(versionStateName(newest->state))
                             : tr("none yet"),
           static_cast<qlonglong>(newest != nullptr ? newest->number : 0)},
          {row.hasDraft ? shownTime(row.draftChangedUtc_us, locale()) : QStringLiteral("\u2013"),
           static_cast<qlonglong>(row.draftChangedUtc_us)}}});
  }
  table_->setRows(std::move(rows));
  showDraft();
}

const CurriculumRow* CurriculaPage::current() const {
  const std::string id = table_->currentId().toStdString();
  const auto found = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const CurriculumRow& row) { return row.curriculum.id == id; });
  return found == rows_.end() ? nullptr : &*found;
}

void CurriculaPage::showDraft() {
  const CurriculumRow* row = current();
  editor_->setEnabled(row != nullptr);
  if (row == nullptr) {
    state_->clear();
    shownId_.clear();
    showButtons();
    return;
  }
  if (row->curriculum.id == shownId_ && dirty_) return;
  attempt(shell(), [&] {
    draft_ = curriculumDraft(shell().workplace(), row->curriculum.id);
    shownId_ = row->curriculum.id;
    dirty_ = false;
    editor_->setContent(draft_.content);
  });
  editor_->setReadOnly(!shell().workplace().may(Operation::kCurriculumEdit));
  showButtons();
}

void CurriculaPage::showButtons() {
  const CurriculumRow* row = current();
  const bool may = row != nullptr && shell().workplace().may(Operation::kCurriculumEdit);
  const CurriculumVersionRow* newest =
      row == nullptr || row->versions.empty() ? nullptr : &row->versions.back();
  add_->setEnabled(shell().workplace().may(Operation::kCurriculumEdit));
  save_->setEnabled(may && dirty_);
  publish_->setEnabled(may && editor_->problems().empty());
  begin_->setEnabled(may && newest != nullptr && newest->state == "draft");
  close_->setEnabled(may && newest != nullptr && newest->state == "running");
  if (row != nullptr)
    state_->setText(dirty_ ? tr("%1: changed, not saved").arg(shown(row->curriculum.name))
                           : shown(row->curriculum.name));
}

bool CurriculaPage::add(const std::string& name, const std::string& templateId) {
  return attempt(shell(), [&] {
    std::optional<StoredCurriculumVersion> content;
    std::string description;
    for (const CurriculumTemplate& known : curriculumTemplates(shell().assets()))
      if (known.id == templateId) {
        content = known.content;
        description = known.description;
      }
    const std::string id = addCurriculum(shell().workplace(), name, description, content);
    read();
    table_->select(shown(id));
  });
}

bool CurriculaPage::save() {
  if (shownId_.empty()) return true;
  return attempt(shell(), [&] {
    draft_.content = editor_->content();
    draft_.revision = saveCurriculumDraft(shell().workplace(), shownId_, draft_);
    dirty_ = false;
    showButtons();
  });
}

bool CurriculaPage::publish(const std::string& note) {
  if (dirty_ && !save()) return false;
  return attempt(shell(), [&] {
    const std::string id = shownId_;
    // A curriculum that was never saved as a draft is published from what stands in the editor.
    if (draft_.revision == 0) {
      draft_.content = editor_->content();
      draft_.revision = saveCurriculumDraft(shell().workplace(), id, draft_);
    }
    publishCurriculum(shell().workplace(), id, note, shell().assets());
    read();
    table_->select(shown(id));
    shell().notify(tr("Published. Begin it, so that cohorts can follow it."));
  });
}

bool CurriculaPage::begin() {
  const CurriculumRow* row = current();
  if (row == nullptr || row->versions.empty()) return false;
  return attempt(shell(), [&] {
    const std::string id = row->curriculum.id;
    runCurriculum(shell().workplace(), row->versions.back().id);
    read();
    table_->select(shown(id));
  });
}

void CurriculaPage::askNew() {
  attempt(shell(), [&] {
    QDialog dialog(this);
    dialog.setWindowTitle(tr("New curriculum"));
    auto* name = new QLineEdit(&dialog);
    auto* from = new QComboBox(&dialog);
    for (const CurriculumTemplate& known : curriculumTemplates(shell().assets()))
      from->addItem(shown(known.title), shown(known.id));
    from->addItem(tr("nothing in it yet"), QString());
    chooseId(from, "paper-three-arms");
    auto* form = new QFormLayout(&dialog);
    form->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
    form->addRow(tr("&Name"), name);
    form->addRow(tr("&Begin with"), from);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    form->addRow(buttons);
    name->setMinimumWidth(340);
    connect(name, &QLineEdit::textChanged, &dialog, [buttons](const QString& text) {
      buttons->button(QDialogButtonBox::Ok)->setEnabled(!text.trimmed().isEmpty());
    });
    connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    if (dialog.exec() == QDialog::Accepted) add(name->text().trimmed().toStdString(), chosenId(from));
  });
}

void CurriculaPage::askPublish() {
  bool given = false;
  const QString note =
      QInputDialog::getText(this, tr("Publish a version"),
                            tr("A published version never changes. What is new in it, in a few words:"),
                            QLineEdit::Normal, QString(), &given);
  if (given) publish(note.trimmed().toStdString());
}

void CurriculaPage::askClose() {
  const CurriculumRow* row = current();
  if (row == nullptr || row->versions.empty()) return;
  const std::optional<std::string> reason = askReason(
      this, tr("Close a version"), tr("No further cohort can begin it; those who follow it go on."));
  if (!reason) return;
  attempt(shell(), [&] {
    closeCurriculum(shell().workplace(), row->versions.back().id, *reason);
    read();
  });
}

void CurriculaPage::retranslate() {
  heading_->setTexts(tr("Curricula"), tr("What the groups go through: exercises, phases, rest and scoring "
                                         "points. Published versions never change."));
  add_->setText(tr("&New curriculum\u2026"));
  save_->setText(tr("&Save draft"));
  publish_->setText(tr("&Publish\u2026"));
  begin_->setText(tr("&Begin"));
  close_->setText(tr("&Close\u2026"));
  table_->setColumns({{tr("Name")}, {tr("Newest version")}, {tr("Draft of")}});
  table_->setEmptyText(tr("No curriculum yet. Begin with the template of the paper's three arms."));
  editor_->retranslate();
  show();
}

}  // namespace torsio::gui
