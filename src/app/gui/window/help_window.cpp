#include "app/gui/window/help_window.h"

#include <QAction>
#include <QDesktopServices>
#include <QFileInfo>
#include <QImage>
#include <QTextBrowser>
#include <QToolBar>
#include <QUrl>
#include <algorithm>

#include "project/reading.h"

namespace goniolux::gui {
namespace {

/// Pages are Markdown; pictures are made to fit.
class Pages final : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;

 protected:
  QVariant loadResource(int type, const QUrl& name) override {
    QVariant found = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return found;
    QImage picture = found.canConvert<QImage>() ? found.value<QImage>() : QImage();
    if (picture.isNull()) picture.loadFromData(found.toByteArray());
    const int most = std::max(320, viewport()->width() - 60);
    return picture.width() > most ? picture.scaledToWidth(most, Qt::SmoothTransformation) : picture;
  }
};

}  // namespace

HelpWindow::HelpWindow(QWidget* parent) : QMainWindow(parent) {
  setObjectName("helpWindow");
  setWindowTitle(tr("Documentation of Goniolux"));
  resize(900, 760);
  browser_ = new Pages(this);
  browser_->setObjectName("help");
  browser_->setOpenLinks(false);
  browser_->setFrameShape(QFrame::NoFrame);
  browser_->document()->setDocumentMargin(18);
  setCentralWidget(browser_);
  auto* bar = addToolBar(tr("Pages"));
  bar->setMovable(false);
  QAction* back = bar->addAction(tr("Back"), browser_, &QTextBrowser::backward);
  QAction* forward = bar->addAction(tr("Forward"), browser_, &QTextBrowser::forward);
  bar->addSeparator();
  const std::pair<QString, const char*> pages[] = {{tr("This program"), "studio/README.md"},
                                                   {tr("Getting started"), "getting-started.md"},
                                                   {tr("The project file"), "project-format.md"}};
  for (const auto& [title, page] : pages) bar->addAction(title, this, [this, wanted = QString(page)] { open(wanted); });
  back->setShortcut(QKeySequence::Back);
  forward->setShortcut(QKeySequence::Forward);
  back->setEnabled(false);
  forward->setEnabled(false);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
  connect(browser_, &QTextBrowser::forwardAvailable, forward, &QAction::setEnabled);
  connect(browser_, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
    const QUrl target = browser_->source().resolved(link);
    if (target.isLocalFile() && target.path().endsWith(".md")) {
      browser_->setSource(target, QTextDocument::MarkdownResource);
    } else {
      QDesktopServices::openUrl(target);
    }
  });
}

QString HelpWindow::fileOf(const QString& page) {
  for (const auto& folder : project::programDataFolders())
    for (const char* place : {"../doc/goniolux/docs/", "docs/"}) {
      const QFileInfo file(QString::fromStdString((folder / place).string()) + page);
      if (file.exists()) return file.canonicalFilePath();
    }
  return {};
}

bool HelpWindow::open(const QString& page) {
  const QString file = fileOf(page);
  if (file.isEmpty()) return false;
  browser_->setSource(QUrl::fromLocalFile(file), QTextDocument::MarkdownResource);
  show();
  raise();
  activateWindow();
  return true;
}

QString HelpWindow::shown() const {
  return browser_->source().toLocalFile();
}

}  // namespace goniolux::gui
