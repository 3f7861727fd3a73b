// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/curriculum/curricula_page.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/curriculum/competence_dialog.h"
#include "app/gui/administrator/curriculum/curriculum_editor.h"
#include "app/gui/administrator/curriculum/curriculum_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/services/access/all_or_none.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"

namespace torsio::gui {

namespace {

constexpr int kListWidth = 236;
constexpr int kEditorWidth = 920;  // its forms fit without scrolling

}  // namespace

CurriculaPage::CurriculaPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      add_(primaryButton(this)),
      standard_(named(new QPushButton(this), "standard")),
      table_(named(new DataTable(QStringLiteral("curricula"), this), "curricula")),
      showing_(new QLabel(this)),
      versions_(named(new QComboBox(this), "versions")),
      state_(named(sentence(this), "state")),
      take_(new QPushButton(this)),
      save_(new QPushButton(this)),
      publish_(new QPushButton(this)),
      begin_(new QPushButton(this)),
      close_(new QPushButton(this)),
      competence_(new QPushButton(this)),
      editor_(named(new CurriculumEditor(shell.assets(), this), "editor")) {
  heading_->addAction(standard_);
  heading_->addAction(add_);
  auto* right = editing_ = new QWidget(this);
  QVBoxLayout* rightColumn = columnOf(right, {}, kSpace);
  QHBoxLayout* acts = rowOf();
  showing_->setBuddy(versions_);
  acts->addWidget(showing_);
  acts->addWidget(versions_, 1);
  for (QPushButton* button : {save_, publish_, take_, begin_, close_, competence_}) {
    acts->addWidget(button);
  }
  rightColumn->addLayout(acts);
  rightColumn->addWidget(state_);
  rightColumn->addWidget(editor_, 1);
  halves_ = new QSplitter(this);
  halves_->addWidget(table_);
  halves_->addWidget(right);
  halves_->setStretchFactor(0, 0);
  halves_->setStretchFactor(1, 1);
  halves_->setChildrenCollapsible(false);
  halves_->setHandleWidth(2 * kSpace);
  table_->setMinimumWidth(kListWidth);
  table_->wrapWhatIsCut();
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addWidget(halves_, 1);

  connect(add_, &QPushButton::clicked, this, &CurriculaPage::askNew);
  connect(standard_, &QPushButton::clicked, this, [this] { StandardDialog(this).exec(); });
  connect(save_, &QPushButton::clicked, this, &CurriculaPage::save);
  connect(publish_, &QPushButton::clicked, this, &CurriculaPage::askPublish);
  connect(take_, &QPushButton::clicked, this, &CurriculaPage::takeAsDraft);
  connect(begin_, &QPushButton::clicked, this, &CurriculaPage::begin);
  connect(close_, &QPushButton::clicked, this, &CurriculaPage::askClose);
  connect(competence_, &QPushButton::clicked, this, &CurriculaPage::showCompetence);
  connect(table_, &DataTable::currentChanged, this, &CurriculaPage::showDraft);
  connect(halves_, &QSplitter::splitterMoved, this, [this] { moved_ = true; });
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
  return !dirty_ || save();  // saving a draft first, so that no input is lost
}

void CurriculaPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  shareWidth();
}

/// Shares the width: the list shows its names on one line if a third of the page suffices and the editor
/// keeps its width, otherwise on several.
void CurriculaPage::shareWidth() {
  if (moved_) {
    return;
  }
  const int all = width();
  const int list = std::clamp(table_->wholeWidth(), kListWidth,
                              std::max(kListWidth, std::min(all / 3, all - kEditorWidth)));
  halves_->setSizes({list, all - list});
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
          {newest != nullptr ? tr("%1, %2").arg(newest->number).arg(toQString(labelOf(newest->state)))
                             : tr("none yet"),
           static_cast<qlonglong>(newest != nullptr ? newest->number : 0)}}});
  }
  table_->setRows(std::move(rows));
  shareWidth();
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
    table_->select(toQString(shownId_));  // keeps unsaved input when another one is selected
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
  if (sameAsShown) {  // just saved: keeps the user's place
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
    versions_->addItem(tr("Version %1 (%2)").arg(version->number).arg(toQString(labelOf(version->state))),
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

std::vector<const CurriculumVersionRow*> CurriculaPage::versionsAtHand(CurriculumState state) const {
  std::vector<const CurriculumVersionRow*> versions;
  const auto chosen = chosenRows(*table_, rows_, [](const CurriculumRow& row) { return row.curriculum.id; });
  for (const CurriculumRow* row : chosen) {
    const CurriculumVersionRow* version = chosen.size() == 1      ? versionAtHand()
                                          : row->versions.empty() ? nullptr
                                                                  : &row->versions.back();
    if (version != nullptr && version->state == state) {
      versions.push_back(version);
    }
  }
  return versions;
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
  begin_->setEnabled(may && !versionsAtHand(CurriculumState::kDraft).empty());
  // Closes the running versions; if none is running, the same button reopens closed ones.
  const bool running = !versionsAtHand(CurriculumState::kRunning).empty();
  const bool again = !running && !versionsAtHand(CurriculumState::kClosed).empty();
  close_->setEnabled(may && (running || again));
  close_->setText(again ? tr("Run a&gain\u2026") : tr("&Close\u2026"));
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

void CurriculaPage::retranslate() {
  heading_->setTexts(
      tr("Curricula"),
      tr("What each group does: exercises, phases, rest and occasions. Published versions never change."));
  add_->setText(tr("&New curriculum\u2026"));
  showing_->setText(tr("S&howing"));
  take_->setText(tr("&Edit as draft"));
  save_->setText(tr("&Save draft"));
  publish_->setText(tr("&Publish\u2026"));
  begin_->setText(tr("&Begin"));
  competence_->setText(tr("Co&mpetence\u2026"));
  standard_->setText(tr("Pass mar&k\u2026"));
  table_->setColumns({{tr("Name")}, {tr("Version")}});
  table_->setEmptyText(tr("No curriculum yet. Begin with the template of the paper's three arms."));
  editor_->retranslate();
  showContent();
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
    // A curriculum without a saved draft is published from the editor's content.
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
  const std::vector<const CurriculumVersionRow*> drafts = versionsAtHand(CurriculumState::kDraft);
  if (drafts.empty()) {
    return false;
  }
  return attempt(shell(), [&] {
    allOrNone(shell().session(), drafts,
              [&](const CurriculumVersionRow* one) { runCurriculum(shell().session(), one->id); });
    read();
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
                            tr("It comes after all others, is available to every curriculum from now on, and "
                               "cannot be removed. What is it called?"),
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
  const QString note = QInputDialog::getText(
      this, tr("Publish a version"), tr("A published version never changes. Briefly, what is new in it:"),
      QLineEdit::Normal, QString(), &given);
  if (given) {
    publish(note.trimmed().toStdString());
  }
}

void CurriculaPage::askClose() {
  std::vector<CurriculumVersionId> ids;
  const std::vector<const CurriculumVersionRow*> running = versionsAtHand(CurriculumState::kRunning);
  const bool again = running.empty();
  for (const CurriculumVersionRow* one : again ? versionsAtHand(CurriculumState::kClosed) : running) {
    ids.push_back(one->id);
  }
  if (ids.empty()) {
    return;
  }
  const auto count = static_cast<int>(ids.size());
  const std::optional<std::string> reason =
      again
          ? askReason(this, tr("Run again"), tr("%n version(s): cohorts can begin it again.", nullptr, count))
          : askReason(this, tr("Close"),
                      tr("%n version(s): no new cohort can choose it; cohorts that follow it continue.",
                         nullptr, count));
  if (!reason) {
    return;
  }
  attempt(shell(), [&] {
    allOrNone(shell().session(), ids, [&](const CurriculumVersionId& id) {
      if (again) {
        runCurriculum(shell().session(), id, *reason);
      } else {
        closeCurriculum(shell().session(), id, *reason);
      }
    });
    read();
  });
}

}  // namespace torsio::gui
