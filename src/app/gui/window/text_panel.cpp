#include "app/gui/window/text_panel.h"

#include <QFontDatabase>
#include <QScrollBar>
#include <QTextBlock>

namespace goniolux::gui {

TextPanel::TextPanel(Document& document, QWidget* parent) : QPlainTextEdit(parent), document_(document) {
  setObjectName("text");
  setAccessibleName(tr("Text of the project"));
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setUndoRedoEnabled(false);  // undo is the document's
  setFrameShape(QFrame::NoFrame);
  wait_.setSingleShot(true);
  wait_.setInterval(500);
  connect(&wait_, &QTimer::timeout, this, &TextPanel::commit);
  connect(this, &QPlainTextEdit::textChanged, this, [this] {
    if (!isRefreshing_) wait_.start();
  });
  connect(&document_, &Document::changed, this, &TextPanel::refresh);
  connect(&document_, &Document::opened, this, &TextPanel::refresh);
}

void TextPanel::refresh() {
  if (!isVisible() || shown_ == document_.revision()) return;
  shown_ = document_.revision();
  const QString text = QString::fromStdString(document_.text());
  if (toPlainText() == text) return;
  isRefreshing_ = true;
  const int place = textCursor().position(), scrolled = verticalScrollBar()->value();
  setPlainText(text);
  QTextCursor cursor = textCursor();
  cursor.setPosition(std::min(place, static_cast<int>(text.size())));
  setTextCursor(cursor);
  verticalScrollBar()->setValue(scrolled);
  isRefreshing_ = false;
}

void TextPanel::commit() {
  wait_.stop();
  if (document_.isOpen()) document_.setText(toPlainText().toStdString(), tr("Typing"), true);
}

void TextPanel::goTo(int line, int column) {
  refresh();
  const QTextBlock block = document()->findBlockByNumber(line - 1);
  if (!block.isValid()) return;
  QTextCursor cursor(block);
  cursor.setPosition(block.position() + std::min(column - 1, std::max(block.length() - 1, 0)));
  setTextCursor(cursor);
  centerCursor();
  setFocus();
}

void TextPanel::showEvent(QShowEvent* event) {
  QPlainTextEdit::showEvent(event);
  refresh();
}

}  // namespace goniolux::gui
