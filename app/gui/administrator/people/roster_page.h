// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/gui/base/page.h"
#include "app/services/people/people_service.h"

class QCheckBox;
class QPushButton;

namespace torsio::gui {

class DataTable;
class PageHeading;

/// The people of the centre: who trains, who scores, what they agreed to. Names are shown only on request.
class RosterPage : public Page {
  Q_OBJECT

 public:
  explicit RosterPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  /// Writes everything about the chosen person into a new folder; of several into a folder each in it.
  void exportRecords(const std::filesystem::path& folder, const std::string& reason);

 private:
  void read();
  void showContent();
  void showButtons();
  void import();
  void add();
  void edit();
  void switchState();
  void exportList();
  void askExportRecords();
  void askEraseRecords();
  void showRequests();
  [[nodiscard]] std::vector<const NamedPersonRow*> chosen() const;
  [[nodiscard]] static QString codesOf(const std::vector<const NamedPersonRow*>& people);

  std::size_t waiting_ = 0;             // requests of people about their own record
  std::vector<NamedPersonRow> people_;  // identities empty while names are hidden
  PageHeading* heading_;
  QPushButton* import_;
  QPushButton* undo_;
  QPushButton* add_;
  QPushButton* texts_;
  QPushButton* requests_;
  DataTable* table_;
  QCheckBox* names_;
  QPushButton* edit_;
  QPushButton* state_;
  QPushButton* export_;
  QPushButton* consents_;
  QPushButton* package_;
  QPushButton* erase_;
};

}  // namespace torsio::gui
