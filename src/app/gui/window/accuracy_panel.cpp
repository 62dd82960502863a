#include "app/gui/window/accuracy_panel.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTabWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "app/gui/document/document.h"
#include "app/gui/plots/paper.h"
#include "app/gui/window/jobs_panel.h"

namespace goniolux::gui {
namespace {

constexpr int wordsRole = Qt::UserRole;

/// The project's text without the accuracy that it asks of grids; as it is where it cannot be read.
std::string withoutAccuracy(const Source& source) {
  try {
    project::ProjectText text(source.text, source.file);
    removeIn(text, "/settings/accuracy/grid");
    return text.text();
  } catch (const core::InputError&) {
    return source.text;
  }
}

QString textOf(const core::Value* value) {
  return value != nullptr && value->isString() ? QString::fromStdString(value->string()) : QString();
}

}  // namespace

const QStringList& AccuracyPanel::choices() {
  static const QStringList list{"10 %", "5 %", "3 %", "2 %", "1 %", "0.5 %"};
  return list;
}

AccuracyPanel::AccuracyPanel(JobQueue& jobs, QWidget* parent) : QWidget(parent), jobs_(jobs) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(10, 10, 10, 10);
  layout->setSpacing(14);
  auto* left = new QVBoxLayout;
  table_ = new QTreeWidget(this);
  table_->setObjectName("accuracyTable");
  table_->setHeaderLabels({tr("Accuracy"), tr("Predicted time"), tr("Solver"), tr("Wavelengths")});
  table_->setRootIsDecorated(false);
  table_->setAlternatingRowColors(true);
  for (const QString& accuracy : choices()) new QTreeWidgetItem(table_, {"± " + accuracy, "–", "–", "–"});
  table_->setToolTip(tr("Double click: calculate with this accuracy from now on"));
  left->addWidget(table_, 1);
  ask_ = new QPushButton(tr("Predict the times"), this);
  ask_->setToolTip(tr("Tries each accuracy coarsely; takes some seconds"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(ask_);
  draw_ = new QPushButton(tr("Work–precision chart"), this);
  draw_->setToolTip(
      tr("Calculates the project by every solver at several accuracies, against a long reference: what accuracy costs "
         "here. Again, it goes on where it ended."));
  seconds_ = new QSpinBox(this);
  seconds_->setRange(10, 3600);
  seconds_->setValue(60);
  seconds_->setSuffix(" s");
  seconds_->setToolTip(tr("Time for the chart"));
  buttons->addWidget(draw_);
  buttons->addWidget(seconds_);
  buttons->addStretch(1);
  left->addLayout(buttons);
  layout->addLayout(left, 3);
  tabs_ = new QTabWidget(this);
  tabs_->setDocumentMode(true);
  layout->addWidget(tabs_, 4);
  auto* scroll = new QScrollArea(tabs_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  words_ = new QLabel(this);
  words_->setWordWrap(true);
  words_->setAlignment(Qt::AlignTop);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  scroll->setWidget(words_);
  chart_ = new Paper(tr("What accuracy costs in this project appears here."), tabs_);
  tabs_->addTab(scroll, tr("Left out, and why"));
  tabs_->addTab(chart_, tr("Work–precision"));
  showWords();
  connect(ask_, &QPushButton::clicked, this, &AccuracyPanel::estimate);
  connect(draw_, &QPushButton::clicked, this, [this] { study(seconds_->value()); });
  connect(table_, &QTreeWidget::itemDoubleClicked, this,
          [this](QTreeWidgetItem* item) { Q_EMIT accuracyChosen(choices().at(table_->indexOfTopLevelItem(item))); });
  connect(table_, &QTreeWidget::currentItemChanged, this, &AccuracyPanel::showWords);
}

void AccuracyPanel::setSource(const Source& source) {
  if (source.text == source_.text) return;
  source_ = source;
  std::string asked = withoutAccuracy(source);
  if (asked == asked_) return;
  asked_ = std::move(asked);
  known_ = 0;
  chart_->clear();
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    for (int c = 1; c < 4; ++c) table_->topLevelItem(i)->setText(c, "–");
    table_->topLevelItem(i)->setData(0, wordsRole, QString());
    Q_EMIT predicted(choices().at(i), QString());
  }
  showWords();
}

void AccuracyPanel::estimate() {
  if (source_.file.empty()) return;
  for (int row = 0; row < table_->topLevelItemCount(); ++row) {
    pipeline::StageRequest request;
    request.inputs = {source_.file};
    request.projectText = source_.text;
    request.common.accuracy = choices().at(row).toStdString();
    table_->topLevelItem(row)->setText(1, tr("being predicted"));
    Job* job = jobs_.start(tr("Predict the time for %1").arg(choices().at(row)),
                           stageWork("plan", request, [this, row, asked = asked_](const auto& report) {
                             if (asked == asked_) take(row, report);
                           }));
    job->setCommandLine(commandLine("plan", request));
  }
}

void AccuracyPanel::study(int seconds) {
  if (source_.file.empty()) return;
  pipeline::StageRequest request;
  request.inputs = {source_.file};
  request.projectText = source_.text;
  request.common.output = (studies_.path() + "/study").toStdString();
  request.common.timeLimit_s = seconds;
  tabs_->setCurrentWidget(chart_);
  const std::string figure = *request.common.output + "/work-precision.figure.json";
  Job* job = jobs_.start(tr("Work–precision chart"), stageWork("study", request, [this, figure](const auto&) {
                           chart_->show([figure] {
                             core::Diagnostics trouble;
                             const core::Value read = core::parseJson(core::readFile(figure), figure, trouble);
                             if (trouble.hasErrors()) throw core::InputError(trouble);
                             return sheetOf(plot::lineChartFromJson(read));
                           });
                         }));
  request.inputs = {QFileInfo(QString::fromStdString(source_.file)).path().toStdString()};
  request.common.output.reset();
  job->setCommandLine(commandLine("study", request));
}

void AccuracyPanel::take(int row, const pipeline::StageReport& report) {
  ++known_;
  QTreeWidgetItem* item = table_->topLevelItem(row);
  const core::Value* time = report.json.find("predicted_time_s");
  if (time != nullptr && time->isNumber()) {
    item->setText(1, tr("about %1").arg(secondsText(time->number())));
    Q_EMIT predicted(choices().at(row), item->text(1));
  }
  item->setText(2, textOf(report.json.find("solver")));
  if (const core::Value* samples = report.json.find("spectral_samples"); samples != nullptr && samples->isNumber())
    item->setText(3, QString::number(samples->number()));
  QString words = "<b>" + tr("At ± %1").arg(choices().at(row)) + "</b>";
  const auto list = [&](const char* key, const QString& title, auto line) {
    const core::Value* entries = report.json.find(key);
    if (entries == nullptr || !entries->isArray() || entries->array().empty()) return;
    words += "<p>" + title + "<ul>";
    for (const core::Value& entry : entries->array()) words += "<li>" + line(entry).toHtmlEscaped() + "</li>";
    words += "</ul>";
  };
  list("left_out", tr("Left out:"), [](const core::Value& entry) {
    QString text = textOf(entry.find("what"));
    const core::Value* bound = entry.find("bound");
    if (bound != nullptr && bound->isNumber())
      text += tr(": at most %1 %2").arg(bound->number(), 0, 'g', 2).arg(textOf(entry.find("unit")));
    return text;
  });
  list("reasons", tr("Because:"), [](const core::Value& entry) { return textOf(&entry); });
  item->setData(0, wordsRole, words);
  if (table_->currentItem() == nullptr) table_->setCurrentItem(item);
  tabs_->setCurrentIndex(0);
  showWords();
}

void AccuracyPanel::showWords() {
  const QTreeWidgetItem* item = table_->currentItem();
  const QString words = item != nullptr ? item->data(0, wordsRole).toString() : QString();
  words_->setText(words.isEmpty() ? tr("What the planner would leave out, and why it chooses as it does, appears here.")
                                  : words);
}

}  // namespace goniolux::gui
