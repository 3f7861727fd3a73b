// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/problem_words.h"

#include "app/gui/shell/shell_window.h"
#include "sim/base/error.h"

namespace torsio::gui {

QString problemSentence(const std::exception_ptr& problem) {
  try {
    std::rethrow_exception(problem);
  } catch (const Error& error) {
    QString text = QString::fromStdString(error.happened());
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return error.remedy().empty()
               ? text
               : ShellWindow::tr("%1. %2").arg(text, QString::fromStdString(error.remedy()));
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
}

}  // namespace torsio::gui
