// NewRoomDialog: a room from a template: size, reflectances, luminaire, target; what `goniolux new room` is asked.
#pragma once

#include <QDialog>

#include "pipeline/stage.h"

class QComboBox;
class QDoubleSpinBox;
class QLineEdit;

namespace goniolux::gui {

class NewRoomDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit NewRoomDialog(QWidget* parent = nullptr);
  /// What the stage `new` is to do.
  [[nodiscard]] pipeline::StageRequest request() const;
  [[nodiscard]] QString folder() const;

 private:
  QDoubleSpinBox *length_, *width_, *height_, *ceiling_, *walls_, *floor_, *target_, *maintenance_, *workPlane_;
  QComboBox* luminaire_;
  QLineEdit* folder_;
};

}  // namespace goniolux::gui
