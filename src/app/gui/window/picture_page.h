// PicturePage: a view of the project rendered while one watches, shown through a device and an exposure chosen beside
// it without tracing again, with a luminance meter under the mouse.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/jobs/latest.h"
#include "app/gui/jobs/rendering.h"
#include "app/gui/picture/image_canvas.h"
#include "image/patch.h"
#include "scene/view.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;
class QSpinBox;

namespace goniolux::gui {

class Paper;

class PicturePage final : public QWidget {
  Q_OBJECT
 public:
  explicit PicturePage(QWidget* parent = nullptr);
  void setViews(const std::vector<scene::View>& views);
  void show(const RenderOutcome& outcome);
  void clear();
  [[nodiscard]] QString chosenView() const;
  [[nodiscard]] ImageCanvas& canvas() { return *canvas_; }
  [[nodiscard]] const RenderOutcome& outcome() const { return outcome_; }
  /// What the meter reads at a pixel, or in the region that is drawn, in words of several lines.
  [[nodiscard]] QString reading(const QPoint& pixel) const;
  void setTool(ImageCanvas::Tool tool);
  /// Renderings carry spectra, too.
  [[nodiscard]] bool wantsSpectra() const;
  [[nodiscard]] DisplayChoice choice() const;
  void setRendering(bool rendering);

 Q_SIGNALS:
  void renderRequested(const QString& view);
  void exportRequested();
  void accuracyChosen(const QString& accuracy);

 private:
  QWidget* buildMeter();
  void redraw();
  void take(const std::shared_ptr<const ShownImage>& shown);
  void point(const QPoint& pixel);
  [[nodiscard]] std::optional<image::PatchReading> measure(const QPoint& pixel) const;
  void showSpectrum(const std::optional<image::PatchReading>& reading);

  RenderOutcome outcome_;
  std::shared_ptr<const image::XyzImage> earlier_;
  ImageCanvas* canvas_;
  QComboBox *views_ = nullptr, *device_ = nullptr, *mapping_ = nullptr, *accuracy_ = nullptr;
  QSlider *stops_ = nullptr, *split_ = nullptr;
  QCheckBox *adapts_ = nullptr, *spectra_ = nullptr;
  QComboBox* tool_ = nullptr;
  Paper* spectrum_ = nullptr;
  QSpinBox* radius_ = nullptr;
  QLabel *meter_ = nullptr, *quality_ = nullptr, *exposure_ = nullptr;
  QAction* render_ = nullptr;
  QPoint pinned_{-1, -1};
  Latest<ShownImage> drawing_;
};

}  // namespace goniolux::gui
