// TextPanel: the project as text, for what forms do not reach, and for mending a text that is no JSON.
#pragma once

#include <QPlainTextEdit>
#include <QTimer>

#include "app/gui/document/document.h"

namespace goniolux::gui {

class TextPanel final : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit TextPanel(Document& document, QWidget* parent = nullptr);
  void goTo(int line, int column);
  /// Takes over what was typed at once instead of in a moment.
  void commit();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();

  Document& document_;
  QTimer wait_;
  quint64 shown_ = 0;
  bool isRefreshing_ = false;
};

}  // namespace goniolux::gui
