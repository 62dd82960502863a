#include "app/gui/document/recovery.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <exception>

#include "core/document.h"

namespace goniolux::gui {
namespace {

constexpr int everyMilliseconds = 1500;

bool isRunning(qint64 process) {
  return QFileInfo::exists(QString("/proc/%1").arg(process));
}

}  // namespace

QString Recovery::folder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery";
}

Recovery::Recovery(Document& document, QObject* parent)
    : QObject(parent), document_(document), worker_(std::make_unique<Worker>("recovery")) {
  // Not restarted by every change: someone who types without a pause is saved, too.
  wait_.setSingleShot(true);
  wait_.setInterval(everyMilliseconds);
  connect(&wait_, &QTimer::timeout, this, &Recovery::keep);
  connect(&document_, &Document::changed, this, [this] {
    if (!wait_.isActive()) wait_.start();
  });
  connect(&document_, &Document::modifiedChanged, this, [this] {
    if (!document_.isModified()) forget();
  });
  connect(&document_, &Document::opened, this, &Recovery::forget);
}

Recovery::~Recovery() {
  worker_.reset();  // nothing is written after what follows
  if (!keptIn_.isEmpty()) QFile::remove(keptIn_);
}

void Recovery::keep() {
  if (!document_.isOpen() || !document_.isModified()) return;
  const qint64 process = QCoreApplication::applicationPid();
  const QByteArray place =
      QCryptographicHash::hash(document_.file().toUtf8(), QCryptographicHash::Sha1).toHex().left(12);
  keptIn_ = folder() + QString("/%1-%2.json").arg(process).arg(QString::fromLatin1(place));
  core::Value kept;
  kept.set("format", "goniolux-recovery");
  kept.set("process", static_cast<double>(process));
  kept.set("file", document_.file().toStdString());
  kept.set("text", document_.text());
  worker_->run([this, kept, to = keptIn_] {
    QDir().mkpath(folder());
    try {
      core::writeFile(to.toStdString(), core::toJson(kept));
      post(this, [this] { Q_EMIT this->kept(); });
    } catch (const std::exception&) {
      // A full disk must not stop the work; saving will say so.
    }
  });
}

void Recovery::forget() {
  wait_.stop();
  if (keptIn_.isEmpty()) return;
  worker_->run([from = keptIn_] { QFile::remove(from); });
  keptIn_.clear();
}

std::vector<Recovered> Recovery::found() {
  std::vector<Recovered> list;
  const QDir dir(folder());
  for (const QString& name : dir.entryList({"*.json"}, QDir::Files, QDir::Time)) {
    const QString path = dir.filePath(name);
    try {
      core::Diagnostics diagnostics;
      const core::Value kept = core::parseJson(core::readFile(path.toStdString()), path.toStdString(), diagnostics);
      const core::Value *process = kept.find("process"), *file = kept.find("file"), *text = kept.find("text");
      if (process == nullptr || file == nullptr || text == nullptr || !process->isNumber() || !file->isString() ||
          !text->isString() || isRunning(static_cast<qint64>(process->number())))
        continue;
      list.push_back({path, QString::fromStdString(file->string()), text->string()});
    } catch (const std::exception&) {
      continue;  // half a file of a process that died while writing: an earlier one is still whole
    }
  }
  return list;
}

void Recovery::discard(const Recovered& recovered) {
  QFile::remove(recovered.keptIn);
}

}  // namespace goniolux::gui
