// Recovery: what is edited is kept beside the settings every moment, so that a killed program loses no more than that.
// A file per open project and process; removed when the project is saved or closed.
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <memory>
#include <string>
#include <vector>

#include "app/gui/document/document.h"
#include "app/gui/jobs/worker.h"

namespace goniolux::gui {

struct Recovered {
  QString keptIn;  ///< the recovery file
  QString file;    ///< the project.json that it belongs to
  std::string text;
};

class Recovery final : public QObject {
  Q_OBJECT
 public:
  explicit Recovery(Document& document, QObject* parent = nullptr);
  ~Recovery() override;

  /// Left by processes that are no longer there.
  static std::vector<Recovered> found();
  static void discard(const Recovered& recovered);
  static QString folder();
  /// The file in which this process keeps the project that is open; "" when nothing needs keeping.
  [[nodiscard]] const QString& keptIn() const { return keptIn_; }

 Q_SIGNALS:
  void kept();

 private:
  void keep();
  void forget();

  Document& document_;
  QTimer wait_;
  QString keptIn_;
  std::unique_ptr<Worker> worker_;
};

}  // namespace goniolux::gui
