// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>
#include <memory>

#include <QObject>
#include <QThreadPool>

namespace torsio::gui {

/// Short work off the GUI thread while nobody is signed in: checking a password, trying a database. One at a
/// time.
class Background : public QObject {
  Q_OBJECT

 public:
  explicit Background(QObject* parent = nullptr);
  ~Background() override;

  /// `work` runs in a worker thread and returns what then runs in the GUI thread; `failed` runs there instead
  /// when it throws. Does nothing while other work runs.
  using Finish = std::function<void()>;
  void run(std::function<Finish()> work, std::function<void(const std::exception_ptr&)> failed);
  [[nodiscard]] bool working() const noexcept { return working_; }

 Q_SIGNALS:
  void workingChanged(bool working);

 private:
  void setWorking(bool working);
  QThreadPool worker_;
  bool working_ = false;
};

}  // namespace torsio::gui
