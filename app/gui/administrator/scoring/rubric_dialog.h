// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include <QDialog>

#include "app/services/study/rubric_service.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace torsio::gui {

class RubricForm;
class SheetEditorPanel;
class ShellContext;

/// The scoring sheet: all revisions; the newest can be edited with a preview of the rater's sheet, published
/// as the next revision, imported and exported.
class RubricDialog : public QDialog {
  Q_OBJECT

 public:
  explicit RubricDialog(ShellContext& shell, QWidget* parent = nullptr);

  /// Replaces the edited sheet by a file. False: refused, with the reason shown.
  bool importFrom(const std::filesystem::path& file);
  /// Writes the revision shown.
  bool exportTo(const std::filesystem::path& file);

  void reject() override;

 private:
  void build();
  void read();
  void showRevision();
  void changed();
  void publish();
  [[nodiscard]] bool newest() const;
  [[nodiscard]] bool edited() const;

  ShellContext& shell_;
  RubricRow rubric_;
  QComboBox* revision_;
  RubricForm* form_;
  SheetEditorPanel* preview_;
  QLabel* problem_;
  QPushButton* import_;
  QPushButton* export_;
  QPushButton* publish_;
};

}  // namespace torsio::gui
