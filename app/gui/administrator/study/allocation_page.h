// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/base/page.h"
#include "app/services/study/allocation_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/allocation.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

class Card;
class DataTable;
class PageHeading;

/// Random allocation to groups: design, balance preview, lock, draw, and verification. The real seed is drawn
/// when the design is locked, so that nobody can choose among outcomes.
class AllocationPage : public Page {
  Q_OBJECT

 public:
  explicit AllocationPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  [[nodiscard]] AllocationPlan plan() const;
  bool preview();
  /// Locks the plan; needs a reason if trainees were allocated by an earlier design.
  bool lock(const std::string& supersedeReason = {});
  bool allocateEverybody();
  /// Writes the sealed cards as a PDF.
  bool writeCards(const std::filesystem::path& file);
  bool reveal(const std::string& reason = {});

 private:
  QWidget* designForm();
  void read();
  void showDesign();
  void showBalance();
  void showFields();
  /// Returns the error in the block sizes typed; empty: none, or no blocks used.
  [[nodiscard]] QString flawOfBlocks() const;
  void askLock();
  void askReveal();
  void askCards();
  void askMove();
  void check();

  std::vector<AllocationDesignRow> designs_;
  std::vector<AllocationEntry> drawn_;  // of the design in force
  std::optional<BalancePreview> preview_;
  std::map<BalanceFactor, QCheckBox*> factors_;
  PageHeading* heading_;
  QLabel* cohortLabel_ = nullptr;
  QComboBox* cohort_;
  Card* design_;
  QLabel* methodLabel_;
  QComboBox* method_;
  QLabel* factorsLabel_;
  QLabel* blocksLabel_;
  QLineEdit* blocks_;
  QLabel* blocksHint_ = nullptr;
  std::size_t arms_ = 0;  // number of groups of the cohort
  QPushButton* previewButton_;
  QPushButton* lock_;
  Card* state_;
  QLabel* stateText_;
  QPushButton* allocate_;
  QPushButton* reveal_;
  QPushButton* check_;
  QPushButton* cards_;
  QLabel* balanceTitle_;
  DataTable* balance_;
  QLabel* recordsTitle_;
  DataTable* records_;
  QPushButton* move_;
};

}  // namespace torsio::gui
