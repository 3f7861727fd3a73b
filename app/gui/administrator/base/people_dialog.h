// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QDialog>

#include "app/services/people/people_service.h"

namespace torsio::gui {

class DataTable;

/// Chooses people out of a list; all of them are chosen to begin with.
class PeopleDialog : public QDialog {
  Q_OBJECT

 public:
  PeopleDialog(const QString& title, const QString& question, const std::vector<PersonRow>& people,
               QWidget* parent);

  [[nodiscard]] std::vector<PersonId> chosen() const;

 private:
  DataTable* table_;
};

}  // namespace torsio::gui
