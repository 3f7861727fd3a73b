// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/gui/shell/page.h"
#include "app/session/study/curriculum_service.h"

class QLabel;
class QPushButton;

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
  /// Begins the newest version, so that cohorts can follow it.
  bool begin();

  [[nodiscard]] CurriculumEditor& editor() const noexcept { return *editor_; }
  [[nodiscard]] DataTable& curricula() const noexcept { return *table_; }

 private:
  void read();
  void show();
  void showDraft();
  void showButtons();
  void askNew();
  void askPublish();
  void askClose();
  [[nodiscard]] const CurriculumRow* current() const;

  std::vector<CurriculumRow> rows_;
  CurriculumDraft draft_;
  std::string shownId_;  // whose draft stands in the editor
  bool dirty_ = false;
  PageHeading* heading_;
  QPushButton* add_;
  DataTable* table_;
  QLabel* state_;
  QPushButton* save_;
  QPushButton* publish_;
  QPushButton* begin_;
  QPushButton* close_;
  CurriculumEditor* editor_;
};

}  // namespace torsio::gui
