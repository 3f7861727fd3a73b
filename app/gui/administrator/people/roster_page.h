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

/// The people of the centre: trainees, raters and their consents. Names are shown only on request.
class RosterPage : public Page {
  Q_OBJECT

 public:
  explicit RosterPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  /// Exports all data of the selected people into a new folder, with a subfolder each if there are several.
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

  std::size_t waiting_ = 0;             // open requests of people about their own records
  std::vector<NamedPersonRow> people_;  // without identities while names are hidden
  PageHeading* heading_;
  QPushButton* import_;
  QPushButton* undo_;
  QPushButton* add_;
  QPushButton* texts_;
  QPushButton* requests_;
  DataTable* table_;
  QCheckBox* names_;
  QPushButton* edit_ = nullptr;
  QPushButton* state_ = nullptr;
  QPushButton* export_ = nullptr;
  QPushButton* consents_ = nullptr;
  QPushButton* package_ = nullptr;
  QPushButton* erase_;
};

}  // namespace torsio::gui
