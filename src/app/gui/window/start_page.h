// StartPage: what one sees before a project is open: recent projects, samples, and a new room.
#pragma once

#include <QWidget>

class QListWidget;

namespace goniolux::gui {

class StartPage final : public QWidget {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);
  void setRecent(const QStringList& projects);

 Q_SIGNALS:
  void openRequested();
  void newRequested();
  void projectChosen(const QString& path);

 private:
  QListWidget* recent_;
  QListWidget* samples_;
};

/// The sample projects that came with the program: folders with a project.json.
QStringList sampleProjects();

}  // namespace goniolux::gui
