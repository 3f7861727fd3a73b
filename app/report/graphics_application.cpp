// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/graphics_application.h"

#include <QApplication>

namespace torsio {

std::unique_ptr<QCoreApplication> makeHeadlessGraphicsApplication(int& argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  return std::make_unique<QApplication>(argc, argv);
}

}  // namespace torsio
