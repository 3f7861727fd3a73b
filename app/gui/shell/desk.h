// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include <QString>
#include <QVariant>
#include <QWidget>

#include "app/gui/base/language.h"
#include "app/gui/base/page.h"
#include "app/gui/base/shell_context.h"
#include "app/services/access/access_service.h"

class QLabel;
class QMenu;
class QStackedWidget;
class QToolButton;

namespace torsio::gui {

class Background;
class JobPanel;
class ProblemPanel;
class Rail;
class Toast;

/// Pages of one area: training, review, administration.
struct PageGroup {
  std::function<QString()> title;
  std::vector<PageEntry> pages;
};

struct DeskSetup {
  std::filesystem::path assets;
  QString centre;
  Language language = Language::kEnglish;
  ThemeKind theme = ThemeKind::kLight;
  bool kiosk = false;
  /// Creates all pages, anew for each desk; the desk keeps those that its actor may open.
  std::function<std::vector<PageGroup>()> groups = [] { return std::vector<PageGroup>(); };
};

/// The workplace of a signed-in person: navigation, header, and one page at a time. Destroyed on sign-out
/// with everything in it.
class Desk : public QWidget {
  Q_OBJECT

 public:
  /// `session` must outlive the desk.
  Desk(SessionContext& session, const DeskSetup& setup, QWidget* parent = nullptr);
  ~Desk() override;

  [[nodiscard]] ShellContext& context() noexcept { return context_; }
  [[nodiscard]] Page* page() const noexcept { return current_; }
  /// Empty before the first page.
  [[nodiscard]] std::optional<PageId> pageId() const noexcept { return currentId_; }

  /// Opens a page. False: the present page is busy or unfinished (the user has been told), or the actor may
  /// not open it.
  bool open(PageId id, const QVariant& argument = {});
  /// Opens the first page of the actor's own group; for an administrator, the page with this id if it is
  /// available.
  void openHome(const QString& lastPage = {});
  /// True during a scored run: no lock, no sign-out, no closing.
  [[nodiscard]] bool busy() const;
  /// Returns whether an idle desk is not locked: during a scored run, and on a page that waits for calls
  /// while they are going on.
  [[nodiscard]] bool staysOpen() const;
  /// Returns whether the desk may be left now; tells the user why not.
  [[nodiscard]] bool mayLeave();

  /// Called when the database answers after an outage: the present page tries again, and messages about the
  /// outage close.
  void databaseAnswered();

  /// Shows language and theme in the header; sets the colours of all pages.
  void setLanguage(Language language);
  void setThemeKind(ThemeKind kind);
  [[nodiscard]] Rail& rail() noexcept { return *rail_; }

 Q_SIGNALS:
  void signOutWanted();
  void lockWanted();
  void passwordChangeWanted();
  void secondFactorWanted();
  void languageWanted(torsio::gui::Language language);
  void themeWanted(torsio::gui::ThemeKind kind);
  void shortcutsWanted();
  void aboutWanted();
  void simulatedWanted(SimulatedRole role);

 protected:
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] bool allowed(PageId id);
  void createRail(const std::vector<PageGroup>& groups);
  QWidget* createHeader();
  QWidget* createBody();
  void connectContext();
  /// Shows in the navigation how many requests wait; read in the background.
  void readWaiting();
  void choosePin();
  void removeDemonstration();
  void retranslate();
  void applyColours(ThemeKind kind);
  Page* pageFor(PageId id);

  ShellContext context_;
  DeskSetup setup_;
  std::map<PageId, PageEntry> entries_;
  std::vector<PageId> order_;
  std::optional<PageId> home_;
  std::map<PageId, Page*> made_;
  Page* current_ = nullptr;
  std::optional<PageId> currentId_;

  Background* reader_;
  Rail* rail_ = nullptr;
  QLabel* title_ = nullptr;
  QLabel* centre_ = nullptr;
  QLabel* practiceSign_ = nullptr;
  QToolButton* language_ = nullptr;
  QToolButton* theme_ = nullptr;
  QToolButton* help_ = nullptr;
  QToolButton* user_ = nullptr;
  QToolButton* signOut_ = nullptr;
  QMenu* languages_ = nullptr;
  QMenu* userMenu_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  ProblemPanel* problem_ = nullptr;
  JobPanel* job_ = nullptr;
  Toast* toast_ = nullptr;
};

}  // namespace torsio::gui
