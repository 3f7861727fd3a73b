// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/gui/base/page.h"
#include "app/services/training/transcript.h"

class QPushButton;
class QTextBrowser;

namespace torsio::gui {

class PageHeading;

/// A trainee's transcript: modules, all attempts, time spent; as PDF or printed.
class TranscriptPage : public Page {
  Q_OBJECT

 public:
  explicit TranscriptPage(ShellContext& shell, QWidget* parent = nullptr);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  /// Writes the PDF, completely or not at all. Throws Error{kFileUnwritable}.
  void writePdf(const std::filesystem::path& file) const;

 private:
  [[nodiscard]] QString html(bool paper) const;
  void choosePdf();
  void print();

  Transcript transcript_;
  bool read_ = false;
  PageHeading* heading_;
  QTextBrowser* text_;
  QPushButton* pdf_;
  QPushButton* print_;
};

}  // namespace torsio::gui
