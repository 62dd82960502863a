#include "app/gui/window/problems_panel.h"

#include <QFileInfo>
#include <QHeaderView>

#include "app/gui/window/icons.h"

namespace goniolux::gui {

ProblemsPanel::ProblemsPanel(QWidget* parent) : QTreeWidget(parent) {
  setObjectName("problems");
  setAccessibleName(tr("Problems"));
  setHeaderLabels({tr("What is wrong, and what to do"), tr("Place")});
  setRootIsDecorated(false);
  setFrameShape(QFrame::NoFrame);
  setWordWrap(true);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(0, QHeaderView::Stretch);
  header()->resizeSection(1, 190);
  const auto choose = [this](QTreeWidgetItem* item) {
    const int line = item->data(1, Qt::UserRole).toInt();
    if (line > 0) Q_EMIT placeChosen(line, item->data(1, Qt::UserRole + 1).toInt());
  };
  connect(this, &QTreeWidget::itemActivated, this, choose);
  connect(this, &QTreeWidget::itemClicked, this, choose);
}

void ProblemsPanel::show(const core::Diagnostics& diagnostics) {
  clear();
  errors_ = warnings_ = 0;
  for (const core::Diagnostic& d : diagnostics.all()) {
    const bool isError = d.severity == core::Severity::error;
    ++(isError ? errors_ : warnings_);
    auto* item = new QTreeWidgetItem(this);
    item->setIcon(0, icon(isError ? "error" : "warning"));
    item->setText(0, QString::fromStdString(d.message));
    item->setToolTip(0, QString::fromStdString(d.message));
    QString place = QFileInfo(QString::fromStdString(d.position.file)).fileName();
    if (d.position.line > 0) place += QString(":%1:%2").arg(d.position.line).arg(d.position.column);
    item->setText(1, place);
    const bool inProject = place.startsWith("project.json");
    item->setData(1, Qt::UserRole, inProject ? d.position.line : 0);
    item->setData(1, Qt::UserRole + 1, d.position.column);
  }
}

}  // namespace goniolux::gui
