// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/background.h"

#include <utility>

#include <QCoreApplication>

namespace torsio::gui {

Background::Background(QObject* parent) : QObject(parent) {
  worker_.setMaxThreadCount(1);
}

Background::~Background() {
  worker_.waitForDone();
}

void Background::setWorking(bool working) {
  working_ = working;
  Q_EMIT workingChanged(working);
}

void Background::run(std::function<Finish()> work, std::function<void(const std::exception_ptr&)> failed) {
  if (working_) {
    return;
  }
  setWorking(true);
  worker_.start([this, work = std::move(work), failed = std::move(failed)] {
    Finish finish;
    try {
      finish = work();
    } catch (...) {
      finish = [failed, problem = std::current_exception()] { failed(problem); };
    }
    QMetaObject::invokeMethod(this, [this, finish = std::move(finish)] {
      setWorking(false);
      if (finish) {
        finish();
      }
    });
  });
}

}  // namespace torsio::gui
