#include "app/gui/window/new_room_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardPaths>
#include <QToolButton>
#include <QVBoxLayout>

#include "project/reading.h"

namespace goniolux::gui {
namespace {

QDoubleSpinBox* number(double value, double low, double high, double step, int digits, const QString& unit) {
  auto* box = new QDoubleSpinBox;
  box->setRange(low, high);
  box->setDecimals(digits);
  box->setSingleStep(step);
  box->setValue(value);
  if (!unit.isEmpty()) box->setSuffix(" " + unit);
  box->setMinimumWidth(96);
  return box;
}

QHBoxLayout* row(const std::vector<QWidget*>& widgets, const QString& between) {
  auto* layout = new QHBoxLayout;
  layout->setSpacing(8);
  for (std::size_t i = 0; i < widgets.size(); ++i) {
    if (i > 0 && !between.isEmpty()) layout->addWidget(new QLabel(between));
    layout->addWidget(widgets[i]);
  }
  layout->addStretch(1);
  return layout;
}

QStringList ownLuminaires() {
  for (const auto& data : project::programDataFolders()) {
    const QDir dir(QString::fromStdString((data / "luminaires").string()));
    const QStringList names = dir.entryList({"*.ies", "*.ldt"}, QDir::Files, QDir::Name);
    if (!names.isEmpty()) return names;
  }
  return {};
}

std::string plain(double value) {
  return QString::number(value, 'g', 8).toStdString();
}

}  // namespace

NewRoomDialog::NewRoomDialog(QWidget* parent) : QDialog(parent) {
  setObjectName("newRoomDialog");
  setWindowTitle(tr("New room"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(20, 18, 20, 16);
  layout->setSpacing(14);
  auto* intro =
      new QLabel(tr("A rectangular room with luminaires in rows. Their number follows from the lumen method: a "
                    "start that the calculation then checks."));
  intro->setWordWrap(true);
  layout->addWidget(intro);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(18);
  form->setVerticalSpacing(10);
  layout->addLayout(form);
  length_ = number(6, 0.5, 500, 0.5, 2, "m");
  width_ = number(4, 0.5, 500, 0.5, 2, "m");
  height_ = number(3, 1, 100, 0.1, 2, "m");
  form->addRow(tr("Length × width × height"), row({length_, width_, height_}, "×"));
  ceiling_ = number(0.7, 0, 0.99, 0.05, 2, "");
  walls_ = number(0.5, 0, 0.99, 0.05, 2, "");
  floor_ = number(0.2, 0, 0.99, 0.05, 2, "");
  form->addRow(tr("Reflectance of ceiling, walls, floor"), row({ceiling_, walls_, floor_}, ""));
  luminaire_ = new QComboBox;
  luminaire_->setObjectName("luminaire");
  luminaire_->setEditable(true);
  luminaire_->addItems(ownLuminaires());
  luminaire_->setCurrentText("panel-600.ies");
  luminaire_->setMinimumWidth(260);
  auto* browse = new QToolButton;
  browse->setText("…");
  connect(browse, &QToolButton::clicked, this, [this] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Photometric file"), QString(),
                                                      tr("Photometric files (*.ies *.IES *.ldt *.LDT *.xml)"));
    if (!file.isEmpty()) luminaire_->setCurrentText(file);
  });
  form->addRow(tr("Luminaire"), row({luminaire_, browse}, ""));
  target_ = number(500, 1, 100000, 50, 0, "lx");
  maintenance_ = number(0.8, 0.1, 1, 0.05, 2, "");
  workPlane_ = number(0.8, 0, 20, 0.05, 2, "m");
  form->addRow(tr("Mean illuminance, maintained"), row({target_}, ""));
  form->addRow(tr("Maintenance factor"), row({maintenance_}, ""));
  form->addRow(tr("Height of the work plane"), row({workPlane_}, ""));
  folder_ = new QLineEdit;
  folder_->setObjectName("folder");
  folder_->setMinimumWidth(300);
  const QString home = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  QString free = home + "/room";
  for (int k = 2; QFileInfo::exists(free + "/project.json"); ++k) free = home + QString("/room-%1").arg(k);
  folder_->setText(free);
  auto* choose = new QToolButton;
  choose->setText("…");
  connect(choose, &QToolButton::clicked, this, [this] {
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Folder of the project"), folder_->text());
    if (!chosen.isEmpty()) folder_->setText(chosen);
  });
  form->addRow(tr("Folder"), row({folder_, choose}, ""));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Make the room"));
  for (QAbstractButton* button : buttons->buttons()) button->setIcon({});
  layout->addSpacing(6);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

QString NewRoomDialog::folder() const {
  return folder_->text();
}

pipeline::StageRequest NewRoomDialog::request() const {
  pipeline::StageRequest request;
  request.inputs = {"room"};
  request.common.output = folder().toStdString();
  request.options["size"] = plain(length_->value()) + "x" + plain(width_->value()) + "x" + plain(height_->value());
  request.options["reflectances"] =
      plain(ceiling_->value()) + "/" + plain(walls_->value()) + "/" + plain(floor_->value());
  request.options["luminaire"] = luminaire_->currentText().toStdString();
  request.options["target"] = plain(target_->value());
  request.options["maintenance"] = plain(maintenance_->value());
  request.options["work-plane"] = plain(workPlane_->value());
  return request;
}

}  // namespace goniolux::gui
