// SpectrumPage: the spectra of the project's materials and luminaires, with the colour of a material's patch under a
// chosen light.
#pragma once

#include <QWidget>
#include <memory>

#include "project/project.h"

class QComboBox;
class QLabel;
class QListWidget;

namespace goniolux::gui {

class Paper;

class SpectrumPage final : public QWidget {
  Q_OBJECT
 public:
  explicit SpectrumPage(QWidget* parent = nullptr);
  void showProject(std::shared_ptr<const project::Project> project);
  void choose(const QString& name);

 private:
  void draw();
  void drawMaterial(const material::Material& material);
  void drawSource(const scene::Luminaire& luminaire);

  std::shared_ptr<const project::Project> project_;
  QListWidget* list_;
  QComboBox* light_;
  QLabel *patch_, *facts_;
  Paper* paper_;
};

}  // namespace goniolux::gui
