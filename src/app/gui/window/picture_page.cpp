#include "app/gui/window/picture_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <QToolBar>
#include <QVBoxLayout>
#include <cmath>

#include "app/gui/plots/paper.h"
#include "app/gui/window/icons.h"
#include "display/device.h"
#include "display/mapping.h"
#include "plot/number_text.h"

namespace goniolux::gui {
namespace {

QString measured(const image::Measured& m, int digits) {
  if (!std::isfinite(m.halfWidth)) return QString::number(m.value, 'f', digits);
  return QString::fromStdString(plot::uncertaintyText(m.value, m.halfWidth));
}

QString row(const QString& name, const QString& value) {
  return QString("<tr><td style='padding-right:10px'>%1</td><td><b>%2</b></td></tr>").arg(name, value);
}

}  // namespace

PicturePage::PicturePage(QWidget* parent)
    : QWidget(parent), drawing_(this, [this](const std::shared_ptr<const ShownImage>& shown) { take(shown); }) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* bar = new QToolBar(this);
  bar->setIconSize({18, 18});
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  layout->addWidget(bar);
  bar->addWidget(new QLabel(tr(" View  "), bar));
  views_ = new QComboBox(bar);
  views_->setObjectName("viewToRender");
  views_->setMinimumContentsLength(10);
  bar->addWidget(views_);
  bar->addWidget(new QLabel(tr("  Accuracy  "), bar));
  accuracy_ = new QComboBox(bar);
  accuracy_->setToolTip(tr("Half-width of the luminance of 95 % of the pixels"));
  for (const char* a : {"30 %", "20 %", "10 %", "5 %", "3 %"}) accuracy_->addItem(QString("± ") + a, a);
  bar->addWidget(accuracy_);
  render_ = bar->addAction(icon("render"), tr("Render"), this, [this] { Q_EMIT renderRequested(chosenView()); });
  render_->setProperty("picture", "render");
  spectra_ = new QCheckBox(tr("with spectra"), bar);
  spectra_->setObjectName("spectra");
  spectra_->setToolTip(
      tr("The picture carries the spectral radiance of every pixel from 400 to 700 nm, for the meter: "
         "takes several times as long"));
  bar->addWidget(spectra_);
  auto* space = new QWidget(bar);
  space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  bar->addWidget(space);
  QAction* exporting = bar->addAction(icon("export"), tr("Export …"), this, &PicturePage::exportRequested);
  exporting->setProperty("picture", "export");
  auto* body = new QHBoxLayout;
  body->setSpacing(0);
  layout->addLayout(body, 1);
  canvas_ = new ImageCanvas(this);
  body->addWidget(canvas_, 1);
  body->addWidget(buildMeter());
  connect(accuracy_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { Q_EMIT accuracyChosen(accuracy_->currentData().toString()); });
  connect(canvas_, &ImageCanvas::pixelPointed, this, [this](const QPoint& pixel) {
    if (tool_->currentIndex() == static_cast<int>(ImageCanvas::Tool::point)) point(pixel);
  });
  connect(canvas_, &ImageCanvas::regionDrawn, this, [this] { point({-1, -1}); });
  connect(canvas_, &ImageCanvas::pixelClicked, this, [this](const QPoint& pixel) {
    pinned_ = pinned_ == pixel ? QPoint(-1, -1) : pixel;
    point(pixel);
  });
  clear();
}

QWidget* PicturePage::buildMeter() {
  auto* scroll = new QScrollArea(this);  // of a low window
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidgetResizable(true);
  scroll->setFixedWidth(306);
  auto* side = new QWidget(scroll);
  scroll->setWidget(side);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(12, 12, 12, 12);
  column->setSpacing(12);
  auto* display = new QGroupBox(tr("Display"), side);
  auto* form = new QFormLayout(display);
  form->setVerticalSpacing(8);
  device_ = new QComboBox(display);
  device_->setObjectName("device");
  for (const std::string& name : display::presetNames()) device_->addItem(QString::fromStdString(name));
  device_->setCurrentText("srgb");
  form->addRow(tr("Device"), device_);
  mapping_ = new QComboBox(display);
  mapping_->setObjectName("mapping");
  for (const display::MappingType& type : display::mappingTypes()) {
    mapping_->addItem(QString::fromStdString(type.name));
    mapping_->setItemData(mapping_->count() - 1, QString::fromStdString(type.title + "\n" + type.source),
                          Qt::ToolTipRole);
  }
  mapping_->setCurrentText("linear");
  mapping_->setToolTip(tr("How the luminances of the room become those of the display"));
  form->addRow(tr("Luminance"), mapping_);
  stops_ = new QSlider(Qt::Horizontal, display);
  stops_->setRange(-12, 12);
  stops_->setToolTip(tr("Brighter or darker than the automatic exposure, in thirds of a stop"));
  form->addRow(tr("Exposure"), stops_);
  exposure_ = new QLabel(display);
  exposure_->setEnabled(false);
  exposure_->setWordWrap(true);
  form->addRow(exposure_);
  adapts_ = new QCheckBox(tr("Adapted to the room's light"), display);
  adapts_->setChecked(true);
  adapts_->setToolTip(tr("The white of the room's light is shown as the display's white (CAT16), as the eye sees it."));
  form->addRow(adapts_);
  column->addWidget(display);
  auto* meterBox = new QGroupBox(tr("Luminance meter"), side);
  auto* meterLayout = new QVBoxLayout(meterBox);
  radius_ = new QSpinBox(meterBox);
  radius_->setRange(0, 50);
  radius_->setSuffix(tr(" px radius"));
  meter_ = new QLabel(meterBox);
  meter_->setObjectName("meter");
  meter_->setTextFormat(Qt::RichText);
  meter_->setWordWrap(true);
  meter_->setMinimumHeight(128);
  meter_->setAlignment(Qt::AlignTop);
  meter_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  tool_ = new QComboBox(meterBox);
  tool_->setObjectName("meterTool");
  tool_->addItems({tr("Circle"), tr("Rectangle"), tr("Polygon")});
  tool_->setItemData(0, tr("Point at the picture; a click stays there."), Qt::ToolTipRole);
  tool_->setItemData(1, tr("Drag over the picture."), Qt::ToolTipRole);
  tool_->setItemData(2, tr("Click the corners; a double click closes it, Escape takes it back."), Qt::ToolTipRole);
  tool_->setToolTip(tr("What is measured: the mean of the pixels inside"));
  meter_->setToolTip(
      tr("Luminance L_v: luminous flux per projected area and solid angle (CIE S 017, 17-21-050). x, y: "
         "CIE 1931 chromaticity. CCT: temperature of the Planckian radiator whose chromaticity is the "
         "nearest (CIE S 017, 17-23-068)."));
  auto* toolRow = new QHBoxLayout;
  toolRow->addWidget(tool_, 1);
  toolRow->addWidget(radius_, 1);
  meterLayout->addLayout(toolRow);
  meterLayout->addWidget(meter_);
  spectrum_ = new Paper(tr("No spectrum here."), meterBox);
  spectrum_->setObjectName("meterSpectrum");
  spectrum_->setMinimumSize(220, 150);
  spectrum_->setVisible(false);
  meterLayout->addWidget(spectrum_);
  column->addWidget(meterBox);
  quality_ = new QLabel(side);
  quality_->setWordWrap(true);
  column->addWidget(quality_);
  auto* compare = new QGroupBox(tr("Before and after"), side);
  auto* compareLayout = new QVBoxLayout(compare);
  split_ = new QSlider(Qt::Horizontal, compare);
  split_->setRange(0, 100);
  split_->setToolTip(tr("Moves the line between the earlier picture (left) and this one"));
  compareLayout->addWidget(split_);
  column->addWidget(compare);
  column->addStretch(1);
  connect(device_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PicturePage::redraw);
  connect(mapping_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    stops_->setEnabled(mapping_->currentText() == "linear");
    redraw();
  });
  connect(stops_, &QSlider::valueChanged, this, &PicturePage::redraw);
  connect(adapts_, &QCheckBox::toggled, this, &PicturePage::redraw);
  connect(split_, &QSlider::valueChanged, this, [this](int value) { canvas_->setSplit(value / 100.0); });
  connect(radius_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this] { point(pinned_); });
  connect(tool_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this](int index) { setTool(static_cast<ImageCanvas::Tool>(index)); });
  return scroll;
}

void PicturePage::setViews(const std::vector<scene::View>& views) {
  QStringList names;
  for (const scene::View& view : views) names << QString::fromStdString(view.name);
  QStringList known;
  for (int i = 0; i < views_->count(); ++i) known << views_->itemText(i);
  if (names != known) {
    const QString chosen = chosenView();
    views_->clear();
    views_->addItems(names);
    if (names.contains(chosen)) views_->setCurrentText(chosen);
  }
  render_->setEnabled(!names.isEmpty());
}

QString PicturePage::chosenView() const {
  return views_->currentText();
}

DisplayChoice PicturePage::choice() const {
  return {device_->currentText().toStdString(), mapping_->currentText().toStdString(), stops_->value() / 3.0,
          adapts_->isChecked()};
}

void PicturePage::show(const RenderOutcome& outcome) {
  // A new picture of the same view begins: the finished one becomes the earlier one.
  if (outcome_.isFinal && !canvas_->picture().isNull() && outcome_.view == outcome.view)
    canvas_->setEarlier(canvas_->picture());
  outcome_ = outcome;
  quality_->setText(tr("%1: %2 % of the pixels within ± %3 %%4")
                        .arg(QString::fromStdString(outcome.view))
                        .arg(100 * outcome.shareWithin, 0, 'f', 0)
                        .arg(100 * outcome.accuracy)
                        .arg(outcome.isFinal ? QString() : tr(", being refined")));
  const int index = accuracy_->findData(QString("%1 %").arg(100 * outcome.accuracy));
  if (index >= 0) accuracy_->setCurrentIndex(index);
  redraw();
  if (pinned_.x() >= 0) point(pinned_);
}

void PicturePage::clear() {
  outcome_ = {};
  pinned_ = {-1, -1};
  canvas_->show({});
  canvas_->setEarlier({});
  canvas_->setMark({-1, -1}, 0);
  quality_->clear();
  exposure_->clear();
  point({-1, -1});
}

void PicturePage::setRendering(bool rendering) {
  render_->setEnabled(!rendering && views_->count() > 0);
}

void PicturePage::redraw() {
  if (!outcome_.image) return;
  drawing_.ask([image = outcome_.image, choice = choice()] { return shownImage(*image, choice); });
}

void PicturePage::take(const std::shared_ptr<const ShownImage>& shown) {
  if (!outcome_.image) return;
  if (!shown->failure.isEmpty()) {
    exposure_->setText(shown->failure);
    return;
  }
  canvas_->show(shown->picture);
  const double all = std::max(1, shown->picture.width() * shown->picture.height());
  QString words;
  if (shown->white_cd_m2 > 0) words = tr("White is %1 cd/m². ").arg(shown->white_cd_m2, 0, 'g', 4);
  exposure_->setText(words + tr("Too bright: %1 %, too pure: %2 % of the pixels.")
                                 .arg(100 * static_cast<double>(shown->tooBright) / all, 0, 'f', 1)
                                 .arg(100 * static_cast<double>(shown->outOfGamut) / all, 0, 'f', 1));
  exposure_->setToolTip(shown->method);
}

bool PicturePage::wantsSpectra() const {
  return spectra_->isChecked();
}

void PicturePage::setTool(ImageCanvas::Tool tool) {
  const QSignalBlocker quiet(tool_);
  tool_->setCurrentIndex(static_cast<int>(tool));
  radius_->setVisible(tool == ImageCanvas::Tool::point);
  pinned_ = {-1, -1};
  canvas_->setTool(tool);
  point({-1, -1});
}

std::optional<image::PatchReading> PicturePage::measure(const QPoint& pixel) const {
  const auto& image = outcome_.image;
  if (!image) return std::nullopt;
  if (tool_->currentIndex() != static_cast<int>(ImageCanvas::Tool::point)) {
    std::vector<core::Vec2> corners;
    for (const QPointF& corner : canvas_->region()) corners.emplace_back(corner.x(), corner.y());
    const auto reading = image::readPolygon(*image, corners);
    return reading.pixels > 0 ? std::optional(reading) : std::nullopt;
  }
  if (pixel.x() < 0 || pixel.x() >= image->width || pixel.y() < 0 || pixel.y() >= image->height) return std::nullopt;
  return image::readPatch(*image, pixel.x(), pixel.y(), radius_->value());
}

QString PicturePage::reading(const QPoint& pixel) const {
  const auto measuredThere = measure(pixel);
  if (!measuredThere) return tool_->itemData(tool_->currentIndex(), Qt::ToolTipRole).toString();
  const image::PatchReading& r = *measuredThere;
  QString words = "<table>";
  if (tool_->currentIndex() == 0) words += row(tr("Pixel"), QString("%1, %2").arg(pixel.x()).arg(pixel.y()));
  words += row(tr("Luminance"), measured(r.luminance, 1) + " cd/m²");
  words += row("x", measured(r.x, 4)) + row("y", measured(r.y, 4));
  if (r.colourTemperature) words += row(tr("CCT"), measured(*r.colourTemperature, 0) + " K");
  if (r.pixels > 1) {
    words += row(tr("Lowest, highest"), QString("%1, %2 cd/m²").arg(r.least, 0, 'g', 4).arg(r.most, 0, 'g', 4));
    if (r.most > 0) words += row(tr("Uniformity"), QString::number(r.least / r.luminance.value, 'f', 3));
    words += row(tr("Pixels"), QString::number(r.pixels));
  }
  return words + "</table>";
}

void PicturePage::showSpectrum(const std::optional<image::PatchReading>& reading) {
  const bool has = reading && !reading->spectrum.empty();
  spectrum_->setVisible(has);
  if (!has) return;
  plot::LineChart chart;
  chart.title = tr("Spectral radiance").toStdString();
  chart.x.title = tr("wavelength / nm").toStdString();
  chart.y.title = "L_e / mW/(m² sr nm)";
  plot::ChartCurve curve{tr("where the meter points").toStdString(), {}};
  for (const auto& [nm, radiance] : reading->spectrum) curve.points.emplace_back(nm, 1e3 * radiance);
  chart.curves.push_back(curve);
  spectrum_->show([chart] { return smallSheetOf(chart); });
}

void PicturePage::point(const QPoint& pixel) {
  const QPoint at = pinned_.x() >= 0 ? pinned_ : pixel;
  meter_->setText(reading(at));
  showSpectrum(measure(at));
  canvas_->setMark(pinned_, radius_->value());
}

}  // namespace goniolux::gui
