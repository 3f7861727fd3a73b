// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <QDialog>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/consent.h"

class QComboBox;
class QDateEdit;
class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// All consent decisions of the chosen people, entry of what they have signed on paper, and forms to sign.
class ConsentDialog : public QDialog {
  Q_OBJECT

 public:
  /// Ids and pseudonyms, at least one. Entries apply to all of them.
  using People = std::vector<std::pair<PersonId, QString>>;
  ConsentDialog(ShellContext& shell, People people, QWidget* parent = nullptr);

 private:
  void readVersions();
  void showPurposes();
  void read();
  void record(bool granted);
  void print();
  [[nodiscard]] QString codes() const;
  [[nodiscard]] const ConsentVersion* chosen() const;
  [[nodiscard]] QString titleOf(const std::string& purpose, const std::string& version) const;

  ShellContext& shell_;
  People people_;
  std::vector<ConsentVersion> versions_;
  QComboBox* version_;
  QComboBox* purpose_;
  QDateEdit* signed_;
  QPushButton* granted_;
  QPushButton* withdrawn_;
  QPushButton* print_;
  DataTable* decisions_;
};

}  // namespace torsio::gui
