// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/problem.h"

#include "sim/core/error.h"

namespace torsio::gui {

Problem problemOf(const std::exception_ptr& thrown, const Surprise& surprise) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Error& error) {
    return [error] { return translated(error); };
  } catch (const std::exception& error) {
    return [surprise, details = QString::fromUtf8(error.what())] {
      return TranslatedError{surprise.happened(), surprise.remedy(), details};
    };
  }
}

}  // namespace torsio::gui
