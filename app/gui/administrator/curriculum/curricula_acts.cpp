// SPDX-License-Identifier: GPL-3.0-or-later
// Actions of CurriculaPage on a curriculum and its versions.
#include <optional>

#include <QComboBox>
#include <QFormLayout>
#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/base/study_labels.h"
#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/curriculum/curriculum_editor.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/access/all_or_none.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"

namespace torsio::gui {

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
                      tr("%n version(s): no further cohort can begin it; those who follow it go on.", nullptr,
                         count));
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
