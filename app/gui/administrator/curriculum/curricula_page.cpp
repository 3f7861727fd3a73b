// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/curriculum/curricula_page.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/base/study_labels.h"
#include "app/gui/administrator/curriculum/competence_dialog.h"
#include "app/gui/administrator/curriculum/curriculum_editor.h"
#include "app/gui/administrator/curriculum/curriculum_state.h"
#include "app/gui/administrator/curriculum/standard_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_heading.h"
#include "app/study/occasion_service.h"
#include "assessment/study/curriculum.h"
#include "sim/base/ids.h"

namespace torsio::gui {

namespace {

constexpr int kListWidth = 236;

}  // namespace

CurriculaPage::CurriculaPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      add_(new QPushButton(this)),
      standard_(new QPushButton(this)),
      table_(new DataTable(QStringLiteral("curricula"), this)),
      showing_(new QLabel(this)),
      versions_(new QComboBox(this)),
      state_(sentence(this)),
      take_(new QPushButton(this)),
      save_(new QPushButton(this)),
      publish_(new QPushButton(this)),
      begin_(new QPushButton(this)),
      close_(new QPushButton(this)),
      competence_(new QPushButton(this)),
      editor_(new CurriculumEditor(shell.assets(), this)) {
  state_->setObjectName(QStringLiteral("state"));
  versions_->setObjectName(QStringLiteral("versions"));
  table_->setObjectName(QStringLiteral("curricula"));
  editor_->setObjectName(QStringLiteral("editor"));
  add_->setProperty("primary", true);
  standard_->setObjectName(QStringLiteral("standard"));
  heading_->addAction(standard_);
  heading_->addAction(add_);
  auto* right = editing_ = new QWidget(this);
  auto* rightColumn = new QVBoxLayout(right);
  rightColumn->setContentsMargins(0, 0, 0, 0);
  rightColumn->setSpacing(kSpace);
  auto* acts = new QHBoxLayout;
  acts->setSpacing(kSpace);
  showing_->setBuddy(versions_);
  acts->addWidget(showing_);
  acts->addWidget(versions_, 1);
  for (QPushButton* button : {save_, publish_, take_, begin_, close_, competence_}) {
    acts->addWidget(button);
  }
  rightColumn->addLayout(acts);
  rightColumn->addWidget(state_);
  rightColumn->addWidget(editor_, 1);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(table_);
  splitter->addWidget(right);
  splitter->setStretchFactor(0, 0);
  splitter->setStretchFactor(1, 1);
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(2 * kSpace);
  table_->setMinimumWidth(kListWidth);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addWidget(splitter, 1);

  connect(add_, &QPushButton::clicked, this, &CurriculaPage::askNew);
  connect(standard_, &QPushButton::clicked, this, [this] { StandardDialog(this).exec(); });
  connect(save_, &QPushButton::clicked, this, &CurriculaPage::save);
  connect(publish_, &QPushButton::clicked, this, &CurriculaPage::askPublish);
  connect(take_, &QPushButton::clicked, this, &CurriculaPage::takeAsDraft);
  connect(begin_, &QPushButton::clicked, this, &CurriculaPage::begin);
  connect(close_, &QPushButton::clicked, this, &CurriculaPage::askClose);
  connect(competence_, &QPushButton::clicked, this, &CurriculaPage::showCompetence);
  connect(table_, &DataTable::currentChanged, this, &CurriculaPage::showDraft);
  connect(versions_, &QComboBox::activated, this, &CurriculaPage::showChosenVersion);
  connect(editor_, &CurriculumEditor::edited, this, [this] {
    dirty_ = true;
    showButtons();
  });
  connect(editor_, &CurriculumEditor::occasionWanted, this, &CurriculaPage::askOccasion);
  retranslate();
}

void CurriculaPage::enter(const QVariant& argument) {
  read();
  if (argument.isValid()) {
    table_->select(argument.toString());
  }
  if (table_->currentId().isEmpty() && !rows_.empty()) {
    table_->select(toQString(rows_.front().curriculum.id));
  }
}

bool CurriculaPage::leave() {
  return !dirty_ || save();  // a draft is kept: nothing typed is ever lost
}

void CurriculaPage::read() {
  attempt(shell(), [&] {
    rows_ = torsio::curricula(shell().session());
    editor_->setOccasions(knownOccasions(shell().session()));
    showContent();
  });
}

void CurriculaPage::showContent() {
  std::vector<Row> rows;
  for (const CurriculumRow& row : rows_) {
    const CurriculumVersionRow* newest = row.versions.empty() ? nullptr : &row.versions.back();
    rows.push_back(
        {toQString(row.curriculum.id),
         {{toQString(Text(row.curriculum.name))},
          {newest != nullptr ? tr("%1, %2").arg(newest->number).arg(versionStateName(newest->state))
                             : tr("none yet"),
           static_cast<qlonglong>(newest != nullptr ? newest->number : 0)}}});
  }
  table_->setRows(std::move(rows));
  showDraft();
}

const CurriculumRow* CurriculaPage::current() const {
  const CurriculumId id = table_->currentId().toStdString();
  const auto found = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const CurriculumRow& row) { return row.curriculum.id == id; });
  return found == rows_.end() ? nullptr : &*found;
}

void CurriculaPage::showDraft() {
  const CurriculumRow* row = current();
  editing_->setVisible(row != nullptr);
  if (row == nullptr) {
    versions_->clear();
    shownId_ = {};
    showButtons();
    return;
  }
  if (row->curriculum.id == shownId_ && dirty_) {
    fillVersions();
    showButtons();
    return;
  }
  if (dirty_ && !save()) {
    table_->select(toQString(shownId_));  // what was typed is not lost to a look at another one
    return;
  }
  CurriculumDraft draft;
  const bool found = attempt(shell(), [&] {
    if (shell().may(Operation::kCurriculumEdit)) {
      draft = curriculumDraft(shell().session(), row->curriculum.id);
    } else if (!row->versions.empty()) {
      draft.content = publishedContent(shell().session(), row->versions.back().id);
    }
  });
  if (!found) {
    return;
  }
  const bool sameAsShown = shownId_ == row->curriculum.id && shownVersion() == nullptr &&
                           curriculumJson(draft.content) == curriculumJson(editor_->content());
  draft_ = std::move(draft);
  shownId_ = row->curriculum.id;
  dirty_ = false;
  if (sameAsShown) {  // just saved: the place where somebody works stays
    fillVersions();
    showButtons();
    return;
  }
  fillVersions();
  showChosenVersion();
}

void CurriculaPage::fillVersions() {
  const CurriculumRow* row = current();
  const QString before = row != nullptr && !versions_->currentData().toString().isEmpty() &&
                                 toQString(row->curriculum.id) == versions_->property("of").toString()
                             ? versions_->currentData().toString()
                             : QString();
  versions_->clear();
  if (row == nullptr) {
    return;
  }
  versions_->setProperty("of", toQString(row->curriculum.id));
  versions_->addItem(tr("Draft"), QString());
  for (auto version = row->versions.rbegin(); version != row->versions.rend(); ++version) {
    versions_->addItem(tr("Version %1 (%2)").arg(version->number).arg(versionStateName(version->state)),
                       toQString(version->id));
  }
  versions_->setCurrentIndex(std::max(0, versions_->findData(before)));
}

void CurriculaPage::showVersion(const CurriculumVersionId& versionId) {
  versions_->setCurrentIndex(std::max(0, versions_->findData(toQString(versionId))));
  showChosenVersion();
}

void CurriculaPage::showChosenVersion() {
  const CurriculumVersionRow* version = shownVersion();
  if (version != nullptr && dirty_ && !save()) {
    versions_->setCurrentIndex(0);
    return;
  }
  attempt(shell(), [&] {
    editor_->setContent(version == nullptr ? draft_.content
                                           : publishedContent(shell().session(), version->id));
  });
  editor_->setReadOnly(version != nullptr || !shell().may(Operation::kCurriculumEdit));
  showButtons();
}

const CurriculumVersionRow* CurriculaPage::shownVersion() const {
  const CurriculumRow* row = current();
  const CurriculumVersionId id = versions_->currentData().toString().toStdString();
  if (row == nullptr || id.empty()) {
    return nullptr;
  }
  const auto found = std::find_if(row->versions.begin(), row->versions.end(),
                                  [&](const CurriculumVersionRow& version) { return version.id == id; });
  return found == row->versions.end() ? nullptr : &*found;
}

const CurriculumVersionRow* CurriculaPage::versionAtHand() const {
  if (const CurriculumVersionRow* version = shownVersion()) {
    return version;
  }
  const CurriculumRow* row = current();
  return row == nullptr || row->versions.empty() ? nullptr : &row->versions.back();
}

void CurriculaPage::showButtons() {
  const CurriculumRow* row = current();
  const bool may = row != nullptr && shell().may(Operation::kCurriculumEdit);
  const CurriculumVersionRow* version = versionAtHand();
  const bool draftShown = shownVersion() == nullptr;
  add_->setEnabled(shell().may(Operation::kCurriculumEdit));
  save_->setVisible(draftShown);
  publish_->setVisible(draftShown);
  take_->setVisible(!draftShown);
  save_->setEnabled(may && dirty_);
  publish_->setEnabled(may && editor_->problems().empty());
  take_->setEnabled(may);
  begin_->setEnabled(may && version != nullptr && version->state == CurriculumState::kDraft);
  close_->setEnabled(may && version != nullptr && version->state == CurriculumState::kRunning);
  competence_->setEnabled(version != nullptr);
  sayState();
}

void CurriculaPage::showCompetence() {
  const CurriculumVersionRow* version = versionAtHand();
  if (version == nullptr) {
    return;
  }
  attempt(shell(), [&] { CompetenceDialog(shell(), version->id, this).exec(); });
}

void CurriculaPage::sayState() {
  const CurriculumRow* row = current();
  if (row == nullptr) {
    state_->clear();
    return;
  }
  const CurriculumVersionRow* version = shownVersion();
  state_->setText(version == nullptr ? draftText(*row, dirty_, locale())
                                     : versionText(*row, *version, locale()));
}

bool CurriculaPage::add(const std::string& name, const std::string& templateId) {
  return attempt(shell(), [&] {
    std::optional<CurriculumVersion> content;
    std::string description;
    for (const CurriculumTemplate& known : curriculumTemplates(shell().assets())) {
      if (known.id == templateId) {
        content = known.content;
        description = known.description;
      }
    }
    const CurriculumId id = addCurriculum(shell().session(), name, description, content);
    read();
    table_->select(toQString(id));
  });
}

bool CurriculaPage::save() {
  if (shownId_.empty() || shownVersion() != nullptr) {
    return true;
  }
  return attempt(shell(), [&] {
    draft_.content = editor_->content();
    draft_.revision = saveCurriculumDraft(shell().session(), shownId_, draft_);
    dirty_ = false;
    read();
    shell().notify(tr("The draft is saved."));
  });
}

bool CurriculaPage::publish(const std::string& note) {
  if (dirty_ && !save()) {
    return false;
  }
  return attempt(shell(), [&] {
    const CurriculumId id = shownId_;
    // A curriculum that was never saved as a draft is published from what stands in the editor.
    if (draft_.revision == 0) {
      draft_.content = editor_->content();
      draft_.revision = saveCurriculumDraft(shell().session(), id, draft_);
    }
    publishCurriculum(shell().session(), id, note, shell().assets());
    read();
    table_->select(toQString(id));
    shell().notify(tr("Published. Begin it, so that cohorts can follow it."));
  });
}

bool CurriculaPage::begin() {
  const CurriculumVersionRow* version = versionAtHand();
  if (version == nullptr) {
    return false;
  }
  return attempt(shell(), [&] {
    const CurriculumId id = shownId_;
    runCurriculum(shell().session(), version->id);
    read();
    table_->select(toQString(id));
    shell().notify(tr("It runs: cohorts can follow it now."));
  });
}

bool CurriculaPage::takeAsDraft() {
  const CurriculumVersionRow* version = shownVersion();
  if (version == nullptr) {
    return false;
  }
  const CurriculumVersion content = editor_->content();
  if (curriculumJson(content) != curriculumJson(draft_.content) &&
      QMessageBox::question(this, tr("Edit as draft"),
                            tr("The draft differs from version %1. Put this version in its place? Published "
                               "versions stay as they are.")
                                .arg(version->number)) != QMessageBox::Yes) {
    return false;
  }
  return attempt(shell(), [&] {
    draft_.content = content;
    draft_.revision = saveCurriculumDraft(shell().session(), shownId_, draft_);
    dirty_ = false;
    versions_->setCurrentIndex(0);
    read();
    showVersion({});
  });
}

void CurriculaPage::askNew() {
  attempt(shell(), [&] {
    QuestionDialog dialog(this, tr("New curriculum"));
    auto* name = new QLineEdit(&dialog);
    auto* from = new QComboBox(&dialog);
    for (const CurriculumTemplate& known : curriculumTemplates(shell().assets())) {
      from->addItem(toQString(Text(known.title)), toQString(known.id));
    }
    from->addItem(tr("nothing in it yet"), QString());
    chooseId(from, "paper-three-arms");
    auto* form = new QFormLayout;
    form->addRow(tr("&Name"), name);
    form->addRow(tr("&Begin with"), from);
    dialog.column()->addLayout(form);
    QPushButton* create = dialog.finish(tr("Create"));
    create->setEnabled(false);
    connect(name, &QLineEdit::textChanged, create,
            [create](const QString& text) { create->setEnabled(!text.trimmed().isEmpty()); });
    if (dialog.exec() == QDialog::Accepted) {
      add(name->text().trimmed().toStdString(), chosenId(from));
    }
  });
}

void CurriculaPage::askOccasion() {
  bool given = false;
  const QString label =
      QInputDialog::getText(this, tr("Add an occasion"),
                            tr("It comes after all others, for every curriculum from now on, and is never "
                               "taken away. What is it called?"),
                            QLineEdit::Normal, QString(), &given);
  if (!given) {
    return;
  }
  attempt(shell(), [&] {
    const Occasion added = addOccasion(shell().session(), label.trimmed().toStdString());
    editor_->setOccasions(knownOccasions(shell().session()));
    shell().notify(tr("Occasion added: %1").arg(occasionName(added)));
  });
}

void CurriculaPage::askPublish() {
  bool given = false;
  const QString note =
      QInputDialog::getText(this, tr("Publish a version"),
                            tr("A published version never changes. What is new in it, in a few words:"),
                            QLineEdit::Normal, QString(), &given);
  if (given) {
    publish(note.trimmed().toStdString());
  }
}

void CurriculaPage::askClose() {
  const CurriculumVersionRow* version = versionAtHand();
  if (version == nullptr) {
    return;
  }
  const std::optional<std::string> reason = askReason(
      this, tr("Close a version"), tr("No further cohort can begin it; those who follow it go on."));
  if (!reason) {
    return;
  }
  attempt(shell(), [&] {
    closeCurriculum(shell().session(), version->id, *reason);
    read();
  });
}

void CurriculaPage::retranslate() {
  heading_->setTexts(tr("Curricula"), tr("What the groups go through: exercises, phases, rest and occasions. "
                                         "Published versions never change."));
  add_->setText(tr("&New curriculum\u2026"));
  showing_->setText(tr("S&howing"));
  take_->setText(tr("&Edit as draft"));
  save_->setText(tr("&Save draft"));
  publish_->setText(tr("&Publish\u2026"));
  begin_->setText(tr("&Begin"));
  close_->setText(tr("&Close\u2026"));
  competence_->setText(tr("Co&mpetence\u2026"));
  standard_->setText(tr("Where to draw the &line\u2026"));
  table_->setColumns({{tr("Name")}, {tr("Newest version")}});
  table_->setEmptyText(tr("No curriculum yet. Begin with the template of the paper's three arms."));
  editor_->retranslate();
  showContent();
}

}  // namespace torsio::gui
