// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/gui/base/page.h"
#include "app/services/maintenance/station_anchor.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace torsio::gui {

class Card;
class HeadsComparison;
class PageHeading;

/// Audit heads stored externally: this station's signing key and target folder, the present head to copy or
/// print, and the comparison of stored heads with the record.
class HeadsPage : public Page {
  Q_OBJECT

 public:
  explicit HeadsPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  void makeKey(const std::filesystem::path& file);
  void useKey(const std::filesystem::path& file);
  void keepIn(const std::filesystem::path& witness);
  /// Names the time stamp authority of the centre, with the file of its root; an empty address: none.
  void stampBy(const QString& address, const std::filesystem::path& certificate);

 private:
  void layOut();
  void read();
  void showStation();
  void showButtons();
  void askKey();
  void askOtherKey();
  void askWitness();
  void askCertificate();
  void addHead();
  void copyHead();
  void printHead();

  StationHeads heads_;
  std::string head_;
  PageHeading* heading_;
  QPushButton* back_;
  Card* station_;
  QLabel* keyText_;
  QPushButton* makeKey_;
  QPushButton* useKey_;
  QLabel* witnessText_;
  QPushButton* witness_;
  QPushButton* noWitness_;
  QLabel* stampText_;
  QLabel* addressLabel_ = nullptr;
  QLineEdit* address_;  ///< of the time stamp authority
  QPushButton* stamps_;
  QPushButton* noStamps_;
  Card* now_;
  QLabel* nowText_;
  QPlainTextEdit* line_;
  QPushButton* copy_;
  QPushButton* print_;
  QPushButton* add_;
  HeadsComparison* comparison_;
};

}  // namespace torsio::gui
