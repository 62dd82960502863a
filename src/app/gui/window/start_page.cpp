#include "app/gui/window/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/window/icons.h"
#include "project/reading.h"

namespace goniolux::gui {
namespace {

QLabel* heading(const QString& text, int points, bool bold) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setPointSize(points);
  font.setBold(bold);
  label->setFont(font);
  return label;
}

QListWidget* projectList(const QString& name) {
  auto* list = new QListWidget;
  list->setObjectName(name);
  list->setIconSize({22, 22});
  list->setSpacing(2);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setTextElideMode(Qt::ElideMiddle);
  return list;
}

void addProject(QListWidget* list, const QString& path) {
  const QFileInfo info(path);
  const QString name = info.fileName() == "project.json" ? info.dir().dirName() : info.fileName();
  auto* item = new QListWidgetItem(icon("project"), name, list);
  item->setData(Qt::UserRole, path);
  item->setToolTip(QDir::toNativeSeparators(path));
}

}  // namespace

QStringList sampleProjects() {
  QStringList found;
  for (const auto& folder : project::programDataFolders()) {
    const QDir projects(QString::fromStdString((folder / "projects").string()));
    for (const QFileInfo& entry : projects.entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
      if (QFileInfo::exists(entry.filePath() + "/project.json")) found << entry.filePath();
    if (!found.isEmpty()) break;
  }
  return found;
}

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  setObjectName("startPage");
  auto* outer = new QHBoxLayout(this);
  outer->addStretch(1);
  auto* page = new QVBoxLayout;
  outer->addLayout(page, 6);
  outer->addStretch(1);
  page->addStretch(1);
  auto* titleRow = new QHBoxLayout;
  auto* picture = new QLabel;
  picture->setPixmap(programIcon().pixmap(64, 64));
  titleRow->addWidget(picture);
  auto* words = new QVBoxLayout;
  words->addWidget(heading("Goniolux Studio", 22, true));
  auto* claim = heading(tr("Calculates the light in a room. Every number comes with its interval."), 11, false);
  claim->setEnabled(false);
  words->addWidget(claim);
  titleRow->addSpacing(16);
  titleRow->addLayout(words, 1);
  page->addLayout(titleRow);
  page->addSpacing(26);
  auto* buttons = new QHBoxLayout;
  auto* newRoom = new QPushButton(icon("new"), tr("New room …"));
  auto* open = new QPushButton(icon("open"), tr("Open a project …"));
  newRoom->setObjectName("newRoom");
  for (QPushButton* button : {newRoom, open}) {
    button->setIconSize({24, 24});
    button->setMinimumHeight(44);
    button->setMinimumWidth(190);
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  page->addLayout(buttons);
  page->addSpacing(22);
  auto* lists = new QHBoxLayout;
  lists->setSpacing(26);
  const auto column = [&](const QString& title, QListWidget* list) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(8);
    layout->addWidget(heading(title, 11, true));
    layout->addWidget(list);
    lists->addLayout(layout, 1);
    const auto choose = [this](QListWidgetItem* item) { Q_EMIT projectChosen(item->data(Qt::UserRole).toString()); };
    connect(list, &QListWidget::itemActivated, this, choose);
    connect(list, &QListWidget::itemClicked, this, choose);
  };
  recent_ = projectList("recent");
  samples_ = projectList("samples");
  column(tr("Recent projects"), recent_);
  column(tr("Sample projects"), samples_);
  page->addLayout(lists, 5);
  page->addStretch(1);
  for (const QString& path : sampleProjects()) addProject(samples_, path);
  connect(open, &QPushButton::clicked, this, &StartPage::openRequested);
  connect(newRoom, &QPushButton::clicked, this, &StartPage::newRequested);
}

void StartPage::setRecent(const QStringList& projects) {
  recent_->clear();
  for (const QString& path : projects) addProject(recent_, path);
  if (projects.isEmpty()) {
    auto* none = new QListWidgetItem(tr("None yet."), recent_);
    none->setFlags(Qt::NoItemFlags);
  }
}

}  // namespace goniolux::gui
