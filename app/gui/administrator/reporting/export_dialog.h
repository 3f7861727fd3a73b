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

/// Exports a cohort's data for other programs: cohort, identities, preview of the content, target. Exports
/// are recorded in the audit trail. GUI thread.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// In the order of the list of formats.
  enum class Form {
    kWorkbook,
    kSpss,
    kR,
    kCsv,
    kFrictionless,
    kRoCrate,
    kParquet,
    kBids,
    kLerobot,
    kReplication,
    kMoodle,
    kCanvas,
    kIlias
  };

  /// `language`: of the workbook, one of reportLanguages().
  ExportDialog(ShellContext& shell, const ReportRequest& request, std::shared_ptr<TrialDigests> digests,
               std::string language, QWidget* parent);

  /// Writes in the chosen format in the background; reports errors. No effect while data are being read.
  /// `status`: for ILIAS, the status file that is filled in.
  void writeTo(const std::filesystem::path& place, const std::filesystem::path& status = {});
  /// Selects a format.
  void choose(Form form);
  /// Cancels running work first.
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
  /// Returns the learning system that scores are written for; empty: another format is chosen.
  [[nodiscard]] std::optional<GradebookForm> system() const;
  [[nodiscard]] DatasetRequest dataset() const;
  /// Returns sentences about what the chosen format contains and never contains.
  [[nodiscard]] QStringList contents() const;

  ShellContext& shell_;
  ExchangeRequest request_;
  std::shared_ptr<TrialDigests> digests_;
  std::string language_;
  std::shared_ptr<ExchangeData> data_;  // empty while being read
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
