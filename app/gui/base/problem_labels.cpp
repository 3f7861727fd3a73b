// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/problem_labels.h"

#include "app/gui/base/translated_text.h"
#include "sim/core/error.h"

namespace torsio::gui {

QString problemSentence(const std::exception_ptr& problem) {
  try {
    std::rethrow_exception(problem);
  } catch (const Error& error) {
    return translatedLine(error);
  } catch (const std::exception& error) {
    return QString::fromUtf8(error.what());
  }
}

}  // namespace torsio::gui
