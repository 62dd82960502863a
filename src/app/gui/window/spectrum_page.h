// SpectrumPage: the spectra of the project's materials and luminaires, with the colour of a material's patch under a
// chosen light, and a ball of it rendered in that light.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

#include "app/gui/jobs/latest.h"
#include "app/gui/jobs/rendering.h"
#include "core/progress.h"
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
  ~SpectrumPage() override;
  /// `text`: what the project was read from.
  void showProject(std::shared_ptr<const project::Project> project, const std::string& text = {});
  void choose(const QString& name);
  [[nodiscard]] bool hasPreview() const { return hasPreview_; }

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void preview();
  void draw();
  void drawMaterial(const material::Material& material);
  void drawSource(const scene::Luminaire& luminaire);

  std::shared_ptr<const project::Project> project_;
  QListWidget* list_;
  QComboBox* light_;
  QLabel *patch_, *ball_, *facts_;
  Paper* paper_;
  std::string text_;
  QTimer wait_;
  bool hasPreview_ = false;
  std::shared_ptr<core::SilentProgress> rendering_;
  Latest<ShownImage> balls_;
};

}  // namespace goniolux::gui
