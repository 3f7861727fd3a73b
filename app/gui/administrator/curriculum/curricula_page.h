// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/gui/base/page.h"
#include "app/services/study/curriculum_service.h"
#include "assessment/domain/ids.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSplitter;

namespace torsio::gui {

class CurriculumEditor;
class DataTable;
class PageHeading;

/// Curricula, from a template to a published, immutable version that cohorts can follow.
class CurriculaPage : public Page {
  Q_OBJECT

 public:
  explicit CurriculaPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  void retranslate() override;

  /// Adds a curriculum under the centre's own name from a template of the assets; empty `templateId`: without
  /// content.
  bool add(const std::string& name, const std::string& templateId);
  bool save();
  bool publish(const std::string& note);
  /// Starts the shown version (for a draft, the newest one; for several curricula, the newest of each), so
  /// that cohorts can follow it.
  bool begin();
  /// Selects what is shown of the chosen curriculum: a published version, or the draft for an empty id.
  void showVersion(const CurriculumVersionId& versionId);
  /// Copies the shown version into the draft; asks first if the draft differs.
  bool takeAsDraft();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void read();
  void shareWidth();
  void showContent();
  void showDraft();
  void showChosenVersion();
  void fillVersions();
  void showButtons();
  void sayState();
  void askNew();
  void askOccasion();
  void askPublish();
  void askClose();
  void showCompetence();
  [[nodiscard]] const CurriculumRow* current() const;
  /// Returns the published version shown; null: the draft is shown.
  [[nodiscard]] const CurriculumVersionRow* shownVersion() const;
  /// Returns the target of Begin and Close: the shown version, or the newest.
  [[nodiscard]] const CurriculumVersionRow* versionAtHand() const;
  /// Returns the targets of Begin and Close for several curricula: the newest version of each in this state.
  [[nodiscard]] std::vector<const CurriculumVersionRow*> versionsAtHand(CurriculumState state) const;

  std::vector<CurriculumRow> rows_;
  CurriculumDraft draft_;
  CurriculumId shownId_;  // curriculum whose draft is in the editor
  bool dirty_ = false;
  PageHeading* heading_;
  QPushButton* add_;
  QPushButton* standard_;
  DataTable* table_;
  QSplitter* halves_ = nullptr;
  bool moved_ = false;  // the user has moved the splitter
  QLabel* showing_;
  QComboBox* versions_;
  QLabel* state_;
  QPushButton* take_;
  QPushButton* save_;
  QPushButton* publish_;
  QPushButton* begin_;
  QPushButton* close_;
  QPushButton* competence_;
  QWidget* editing_ = nullptr;
  CurriculumEditor* editor_;
};

}  // namespace torsio::gui
