// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QDialog>

#include "assessment/people/consent.h"
#include "sim/base/ids.h"

class QComboBox;
class QDateEdit;
class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Every decision of one person about what may be kept and used, what was signed on paper since, and the form
/// to sign.
class ConsentDialog : public QDialog {
  Q_OBJECT

 public:
  /// `code`: pseudonym of the person, for the title and the form.
  ConsentDialog(ShellContext& shell, PersonId personId, const QString& code, QWidget* parent = nullptr);

 private:
  void readVersions();
  void showPurposes();
  void read();
  void record(bool granted);
  void print();
  [[nodiscard]] const ConsentVersion* chosen() const;
  [[nodiscard]] QString titleOf(const std::string& purpose, const std::string& version) const;

  ShellContext& shell_;
  PersonId personId_;
  QString code_;
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
