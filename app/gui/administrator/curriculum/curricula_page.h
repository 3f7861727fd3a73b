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

/// Curricula: from a template to a version that never changes, which cohorts can follow.
class CurriculaPage : public Page {
  Q_OBJECT

 public:
  explicit CurriculaPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  [[nodiscard]] bool leave() override;
  void retranslate() override;

  /// From a template of the assets, under a name of the centre's own. Empty `templateId`: nothing in it yet.
  bool add(const std::string& name, const std::string& templateId);
  bool save();
  bool publish(const std::string& note);
  /// Begins the version that is shown (with the draft shown: the newest; of several curricula the newest of
  /// each), so that cohorts can follow it.
  bool begin();
  /// What is shown of the chosen curriculum: a published version, or with an empty id the draft.
  void showVersion(const CurriculumVersionId& versionId);
  /// What the shown version contains becomes the draft; the draft before is asked for first when it differs.
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
  /// The published version that is shown; null: the draft is.
  [[nodiscard]] const CurriculumVersionRow* shownVersion() const;
  /// The one that Begin and Close are about: the shown one, or the newest.
  [[nodiscard]] const CurriculumVersionRow* versionAtHand() const;
  /// Those that Begin and Close are about when several curricula are chosen: the newest version of each that
  /// is in this state.
  [[nodiscard]] std::vector<const CurriculumVersionRow*> versionsAtHand(CurriculumState state) const;

  std::vector<CurriculumRow> rows_;
  CurriculumDraft draft_;
  CurriculumId shownId_;  // whose draft stands in the editor
  bool dirty_ = false;
  PageHeading* heading_;
  QPushButton* add_;
  QPushButton* standard_;
  DataTable* table_;
  QSplitter* halves_ = nullptr;
  bool moved_ = false;  // the border between the halves, by hand
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
