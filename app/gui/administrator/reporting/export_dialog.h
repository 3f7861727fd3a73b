// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include <QDialog>

#include "app/outputs/dataset/cohort_exchange.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace torsio::gui {

class JobPanel;
class ShellContext;

/// A cohort's data for other programs: which one, how people appear, a look at what will be in it, where it
/// goes. What left is kept in the audit trail. GUI thread.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// Entries of the list of formats, in their order.
  enum class Form { kWorkbook, kSpss, kR, kCsv, kFrictionless, kRoCrate, kBids, kGradebook };

  /// `language`: of the workbook, one of reportLanguages().
  ExportDialog(ShellContext& shell, const ReportRequest& request, std::shared_ptr<TrialDigests> digests,
               std::string language, QWidget* parent);

  /// Writes in the chosen form, beside the window; what went wrong is said. Does nothing while data are read.
  void writeTo(const std::filesystem::path& place);
  /// Shows a format.
  void choose(Form form);
  /// While something is read or written: gives it up first.
  void reject() override;

 private:
  void build();
  void read();
  void showTable();
  void askPlace();
  void followJobs(QVBoxLayout& column);
  void buildDataset(QFormLayout& form);
  [[nodiscard]] Form chosen() const;
  [[nodiscard]] bool isDataset() const;
  [[nodiscard]] DatasetRequest dataset() const;
  /// What the chosen form holds and what it never does, as sentences.
  [[nodiscard]] QStringList contents() const;

  ShellContext& shell_;
  ExchangeRequest request_;
  std::shared_ptr<TrialDigests> digests_;
  std::string language_;
  std::shared_ptr<ExchangeData> data_;  // empty while it is read
  QComboBox* form_;
  QCheckBox* pseudonymised_;
  QCheckBox* freeText_;
  QLineEdit* reason_;
  QLineEdit* title_;
  QComboBox* licence_;
  QLineEdit* citation_;
  QLineEdit* creator_;
  QComboBox* rate_;
  QFormLayout* layout_ = nullptr;
  QLabel* what_;
  QComboBox* table_;
  QLabel* asInFile_;
  QTableWidget* rows_;
  QLabel* done_;
  QPushButton* save_ = nullptr;
  JobPanel* job_ = nullptr;
  bool busy_ = false;
  bool closing_ = false;
};

}  // namespace torsio::gui
