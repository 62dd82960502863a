#include "app/gui/window/spectrum_page.h"

#include <fmt/format.h>

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/jobs/material_preview.h"
#include "app/gui/plots/paper.h"
#include "app/gui/room/room_scene.h"
#include "app/gui/window/icons.h"
#include "spectrum/cie_data.h"
#include "spectrum/colorimetry.h"

namespace goniolux::gui {
namespace {

using spectrum::SpectralDistribution;

constexpr int indexRole = Qt::UserRole, isSourceRole = Qt::UserRole + 1;

/// What is drawn of a curve from 380 to 780 nm; lines stand as needles of the continuum's scale.
plot::ChartCurve curveOf(const std::string& name, const SpectralDistribution& curve) {
  plot::ChartCurve drawn{name, {}};
  for (int nm = 380; nm <= 780; nm += 2) drawn.points.emplace_back(nm, curve.continuum(nm));
  return drawn;
}

QString row(const QString& name, const QString& value) {
  return QString("<tr><td style='padding-right:16px'>%1</td><td><b>%2</b></td></tr>").arg(name, value);
}

}  // namespace

SpectrumPage::SpectrumPage(QWidget* parent)
    : QWidget(parent), balls_(this, [this](const std::shared_ptr<const ShownImage>& shown) {
        hasPreview_ = shown->failure.isEmpty();
        if (hasPreview_) ball_->setPixmap(QPixmap::fromImage(shown->picture));
        ball_->setToolTip(hasPreview_ ? tr("A ball of this finish in the chosen light, rendered") : shown->failure);
      }) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* scroll = new QScrollArea(this);  // of a low window
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidgetResizable(true);
  scroll->setFixedWidth(282);
  auto* side = new QWidget(scroll);
  scroll->setWidget(side);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(12, 12, 12, 12);
  column->setSpacing(10);
  list_ = new QListWidget(side);
  list_->setObjectName("spectra");
  list_->setMinimumHeight(96);
  column->addWidget(list_, 1);
  auto* form = new QFormLayout;
  light_ = new QComboBox(side);
  for (const std::string& name : spectrum::illuminantNames()) light_->addItem(QString::fromStdString(name));
  light_->setCurrentText("CIE D65");
  form->addRow(tr("Light on the patch"), light_);
  column->addLayout(form);
  patch_ = new QLabel(side);
  patch_->setObjectName("patch");
  patch_->setFixedHeight(72);
  column->addWidget(patch_);
  ball_ = new QLabel(side);
  ball_->setObjectName("ball");
  ball_->setAccessibleName(tr("Ball of the finish"));
  ball_->setFixedHeight(172);
  ball_->setAlignment(Qt::AlignCenter);
  column->addWidget(ball_);
  // Not while one looks through the list.
  wait_.setSingleShot(true);
  wait_.setInterval(350);
  connect(&wait_, &QTimer::timeout, this, &SpectrumPage::preview);
  facts_ = new QLabel(side);
  facts_->setTextFormat(Qt::RichText);
  facts_->setWordWrap(true);
  column->addWidget(facts_);
  layout->addWidget(scroll);
  paper_ = new Paper(tr("Choose a material or a luminaire."), this);
  layout->addWidget(paper_, 1);
  connect(list_, &QListWidget::currentRowChanged, this, &SpectrumPage::draw);
  connect(light_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &SpectrumPage::draw);
}

SpectrumPage::~SpectrumPage() {
  if (rendering_) rendering_->cancel();
}

void SpectrumPage::preview() {
  const QListWidgetItem* item = list_->currentItem();
  if (!project_ || text_.empty() || item == nullptr || item->data(isSourceRole).toBool() || !isVisible()) return;
  if (rendering_) rendering_->cancel();
  rendering_ = std::make_shared<core::SilentProgress>();
  balls_.ask([source = Source{text_, project_->file}, name = item->text().toStdString(),
              light = light_->currentText().toStdString(),
              progress = rendering_] { return materialPreview(source, name, light, *progress); });
}

void SpectrumPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  wait_.start();
}

void SpectrumPage::showProject(std::shared_ptr<const project::Project> project, const std::string& text) {
  text_ = text;
  const QString chosen = list_->currentItem() != nullptr ? list_->currentItem()->text() : QString();
  project_ = std::move(project);
  const QSignalBlocker quiet(list_);
  list_->clear();
  if (!project_) return paper_->clear();
  const auto& environment = project_->environment;
  const auto add = [&](const std::string& name, std::size_t index, bool isSource) {
    auto* item = new QListWidgetItem(icon(isSource ? "luminaire" : "material"), QString::fromStdString(name), list_);
    item->setData(indexRole, static_cast<qulonglong>(index));
    item->setData(isSourceRole, isSource);
  };
  for (std::size_t i = 0; i < environment.materials.size(); ++i) add(environment.materials[i].name, i, false);
  std::string last;
  for (std::size_t i = 0; i < environment.luminaires.size(); ++i) {
    if (environment.luminaires[i].type == last) continue;
    last = environment.luminaires[i].type;
    add(last, i, true);
  }
  if (!chosen.isEmpty()) choose(chosen);
  draw();
}

void SpectrumPage::choose(const QString& name) {
  for (int i = 0; i < list_->count(); ++i)
    if (list_->item(i)->text() == name) list_->setCurrentRow(i);
}

void SpectrumPage::draw() {
  const QListWidgetItem* item = list_->currentItem();
  if (!project_ || item == nullptr) return;
  const auto index = static_cast<std::size_t>(item->data(indexRole).toULongLong());
  if (item->data(isSourceRole).toBool()) {
    drawSource(project_->environment.luminaires.at(index));
  } else {
    drawMaterial(project_->environment.materials.at(index));
  }
}

void SpectrumPage::drawMaterial(const material::Material& material) {
  const SpectralDistribution light = *spectrum::illuminant(light_->currentText().toStdString());
  plot::LineChart chart;
  chart.title = material.name;
  chart.subtitle = "Spectral curves of the finish, model " + material.model;
  chart.x.title = "wavelength / nm";
  chart.y.title = "reflectance, transmittance";
  QString facts = "<table>" + row(tr("Model"), QString::fromStdString(material.model));
  for (const auto& [key, curve] : material.spectra) {
    if (chart.curves.size() < 6) chart.curves.push_back(curveOf(key, curve));
    if (curve.range().second > 1) continue;
    const spectrum::Xyz seen = spectrum::tristimulus(curve, light);
    facts += row(QString::fromStdString(key) + ", ρ_v", QString::number(seen.Y, 'f', 3));
    const auto [x, y] = spectrum::chromaticity(seen);
    facts += row("x, y", QString("%1, %2").arg(x, 0, 'f', 4).arg(y, 0, 'f', 4));
  }
  for (const auto& [key, number] : material.numbers)
    facts += row(QString::fromStdString(key), QString::number(number, 'g', 4));
  facts_->setText(facts + "</table>");
  const plot::Rgb rgb = colourOf(material, light);
  patch_->setStyleSheet(
      QString("background: rgb(%1, %2, %3); border-radius: 4px;").arg(rgb[0]).arg(rgb[1]).arg(rgb[2]));
  patch_->setVisible(true);
  ball_->setVisible(true);
  ball_->clear();
  hasPreview_ = false;
  wait_.start();
  if (chart.curves.empty()) return paper_->clear();
  paper_->show([chart] { return sheetOf(chart); });
}

void SpectrumPage::drawSource(const scene::Luminaire& luminaire) {
  const SpectralDistribution& source = project_->environment.sourceSpectra.at(luminaire.spectrum);
  plot::LineChart chart;
  chart.title = luminaire.type;
  chart.subtitle = source.lines().empty() ? "Relative spectral power" : "Relative spectral power of the continuum";
  chart.x.title = "wavelength / nm";
  chart.y.title = "relative spectral power";
  chart.curves.push_back(curveOf("lamp", source));
  const spectrum::Xyz colour = spectrum::tristimulus(source);
  const auto [x, y] = spectrum::chromaticity(colour);
  const spectrum::ColourTemperature t = spectrum::colourTemperature(colour);
  QString facts = "<table>" + row("x, y", QString("%1, %2").arg(x, 0, 'f', 4).arg(y, 0, 'f', 4));
  facts += row(tr("CCT"), QString("%1 K").arg(t.kelvin, 0, 'f', 0)) + row("Duv", QString::number(t.duv, 'f', 4));
  facts += row(tr("Melanopic DER"), QString::number(spectrum::melanopicDer(source), 'f', 3));
  facts += row(tr("S/P ratio"), QString::number(spectrum::scotopicPhotopicRatio(source), 'f', 2));
  if (!source.lines().empty()) facts += row(tr("Lines"), QString::number(source.lines().size()));
  facts_->setText(facts + "</table>");
  patch_->setVisible(false);
  ball_->setVisible(false);
  paper_->show([chart] { return sheetOf(chart); });
}

}  // namespace goniolux::gui
