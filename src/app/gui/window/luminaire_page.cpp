#include "app/gui/window/luminaire_page.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSplitter>
#include <QTabWidget>
#include <QToolBar>
#include <QVBoxLayout>

#include "app/gui/plots/paper.h"
#include "app/gui/window/icons.h"
#include "photometry/photometric_file.h"
#include "pipeline/luminaire_figures.h"
#include "pipeline/luminaire_sheet.h"
#include "pipeline/polar.h"
#include "project/reading.h"

namespace goniolux::gui {

LuminairePage::LuminairePage(QWidget* parent)
    : QWidget(parent), loading_(this, [this](const std::shared_ptr<const Loaded>& loaded) { take(*loaded); }) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* bar = new QToolBar(this);
  bar->setIconSize({18, 18});
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  layout->addWidget(bar);
  files_ = new QComboBox(bar);
  files_->setObjectName("photometricFiles");
  files_->setMinimumContentsLength(26);
  bar->addWidget(new QLabel(tr(" File  "), bar));
  bar->addWidget(files_);
  const auto add = [&](const char* picture, const QString& title, const QString& tip, auto signal) {
    QAction* action = bar->addAction(icon(picture), title, this, signal);
    action->setProperty("picture", picture);
    action->setToolTip(tip);
  };
  add("import", tr("Import …"), tr("Copies a photometric file into the project; or drop it on the window"),
      [this] { Q_EMIT importRequested(); });
  bar->addSeparator();
  add("luminaire", tr("Use for selection"), tr("The selected luminaires get this photometry"),
      [this] { Q_EMIT useRequested(shown_); });
  add("", tr("Replace everywhere"), tr("All luminaires with the selected one's photometry get this one"),
      [this] { Q_EMIT replaceRequested(shown_); });
  auto* split = new QSplitter(Qt::Horizontal, this);
  layout->addWidget(split, 1);
  auto* tabs = new QTabWidget(split);
  tabs->setDocumentMode(true);
  polar_ = new Paper(tr("Choose a photometric file."), tabs);
  solid_ = new Paper(tr("Choose a photometric file."), tabs);
  cartesian_ = new Paper(tr("Choose a photometric file."), tabs);
  tabs->addTab(polar_, tr("Polar"));
  tabs->addTab(solid_, tr("Photometric solid"));
  tabs->addTab(cartesian_, tr("Cartesian"));
  sheet_ = new QPlainTextEdit(split);
  sheet_->setObjectName("sheet");
  sheet_->setReadOnly(true);
  sheet_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  sheet_->setLineWrapMode(QPlainTextEdit::NoWrap);
  sheet_->setFrameShape(QFrame::NoFrame);
  split->setSizes({560, 480});
  connect(files_, QOverload<int>::of(&QComboBox::activated), this, [this] { showFile(files_->currentText()); });
}

void LuminairePage::setFiles(const QStringList& ofProject, const QString& projectFolder) {
  folder_ = projectFolder;
  QStringList names = ofProject;
  for (const auto& place : project::programDataFolders()) {
    const QDir dir(QString::fromStdString((place / "luminaires").string()));
    names << dir.entryList({"*.ies", "*.ldt", "*.xml"}, QDir::Files, QDir::Name);
  }
  names.removeDuplicates();
  QStringList known;
  for (int i = 0; i < files_->count(); ++i) known << files_->itemText(i);
  if (names == known) return;
  files_->clear();
  files_->addItems(names);
  if (!ofProject.isEmpty() && !names.contains(shown_)) {
    showFile(ofProject.front());
  } else {
    files_->setCurrentText(shown_);
  }
}

QString LuminairePage::pathOf(const QString& name) const {
  if (QFileInfo(name).isAbsolute()) return name;
  if (const QString inProject = QDir(folder_).filePath(name); QFileInfo::exists(inProject)) return inProject;
  for (const auto& place : project::programDataFolders())
    if (const QString own = QString::fromStdString((place / "luminaires").string()) + "/" + name;
        QFileInfo::exists(own))
      return own;
  return name;
}

void LuminairePage::showFile(const QString& file) {
  shown_ = file;
  files_->setCurrentText(file);
  sheet_->clear();
  loading_.ask([name = file, path = pathOf(file).toStdString()] {
    auto loaded = std::make_shared<Loaded>();
    loaded->name = name;
    try {
      const auto read = std::make_shared<const photometry::PhotometricFile>(photometry::readPhotometricFile(path));
      loaded->text = QString::fromStdString(pipeline::luminaireText(*read));
      loaded->file = read;
    } catch (const std::exception& error) {
      loaded->text = QString::fromUtf8(error.what());
    }
    return loaded;
  });
}

void LuminairePage::take(const Loaded& loaded) {
  if (loaded.name != shown_) return;
  sheet_->setPlainText(loaded.text);
  if (!loaded.file) {
    for (Paper* paper : {polar_, solid_, cartesian_}) paper->clear();
    return;
  }
  polar_->show([read = loaded.file] { return sheetOf(pipeline::polarDiagramOf(*read)); });
  solid_->show([read = loaded.file] { return sheetOf(pipeline::photometricSolidOf(*read)); });
  cartesian_->show([read = loaded.file] { return sheetOf(pipeline::cartesianDiagramOf(*read)); });
}

QString LuminairePage::sheetText() const {
  return sheet_->toPlainText();
}

}  // namespace goniolux::gui
