#include "app/gui/window/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyle>
#include <QStyleFactory>

namespace goniolux::gui {
namespace {

const Theme* shown = &lightTheme();

QPalette paletteOf(const Theme& t) {
  QPalette p;
  p.setColor(QPalette::Window, t.window);
  p.setColor(QPalette::WindowText, t.text);
  p.setColor(QPalette::Base, t.base);
  p.setColor(QPalette::AlternateBase, t.panel);
  p.setColor(QPalette::Text, t.text);
  p.setColor(QPalette::PlaceholderText, t.faintText);
  p.setColor(QPalette::Button, t.panel);
  p.setColor(QPalette::ButtonText, t.text);
  p.setColor(QPalette::BrightText, t.fail);
  p.setColor(QPalette::Highlight, t.accent);
  p.setColor(QPalette::HighlightedText, QColor(255, 255, 255));
  p.setColor(QPalette::Link, t.accent);
  p.setColor(QPalette::ToolTipBase, t.panel);
  p.setColor(QPalette::ToolTipText, t.text);
  p.setColor(QPalette::Mid, t.border);
  p.setColor(QPalette::Dark, t.border);
  p.setColor(QPalette::Light, t.base);
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, t.faintText);
  return p;
}

QString styleSheetOf(const Theme& t) {
  return QString(
             "QMainWindow::separator { background: %1; width: 5px; height: 5px; }"
             "QDockWidget::title { padding: 7px 10px; background: %2; }"
             "QToolBar { spacing: 3px; padding: 4px 6px; border: none; border-bottom: 1px solid %3; }"
             "QToolBar QToolButton { padding: 5px 8px; border-radius: 4px; border: 1px solid transparent; }"
             "QToolBar QToolButton:hover { background: %4; }"
             "QToolBar QToolButton:checked { background: %4; border-color: %3; }"
             "QStatusBar { border-top: 1px solid %3; } QStatusBar::item { border: none; }"
             "QTreeView, QTableView, QPlainTextEdit, QListView { border: 1px solid %3; }"
             "QTreeView::item, QListView::item { padding: 3px 2px; }"
             "QHeaderView::section { padding: 5px 8px; border: none; border-right: 1px solid %3; "
             "border-bottom: 1px solid %3; background: %2; }"
             "QLineEdit { padding: 3px 6px; border: 1px solid %3; "
             "border-radius: 3px; background: %5; min-height: 18px; }"
             "QLineEdit:focus { border-color: %6; }"
             "QComboBox QLineEdit, QAbstractSpinBox QLineEdit { border: none; padding: 0; }"
             "QLineEdit[wrong=\"true\"] { border-color: %7; }"
             "QTabBar::tab { padding: 7px 14px; }"
             "QToolTip { padding: 5px; border: 1px solid %3; background: %2; color: %8; }")
      .arg(t.window.name(), t.panel.name(), t.border.name(), t.isDark ? "#3a424d" : "#dfe6ee", t.base.name(),
           t.accent.name(), t.fail.name(), t.text.name());
}

bool systemIsDark() {
  const QPalette p = QApplication::style()->standardPalette();
  return p.color(QPalette::Window).lightness() < 128;
}

}  // namespace

const Theme& lightTheme() {
  static const Theme theme{false,
                           QColor("#f3f4f6"),
                           QColor("#ffffff"),
                           QColor("#e9ecf0"),
                           QColor("#cfd5dc"),
                           QColor("#1e2329"),
                           QColor("#7b8490"),
                           QColor("#1d6fb8"),
                           QColor("#1a7f4b"),
                           QColor("#c0392b"),
                           QColor("#a8700c"),
                           QColor("#c9d6e3"),
                           QColor("#f4f7fa"),
                           QColor("#39424d"),
                           QColor("#ffe9a8"),
                           QColor("#c98a00"),
                           QColor("#e0531f")};
  return theme;
}

const Theme& darkTheme() {
  static const Theme theme{true,
                           QColor("#23272e"),
                           QColor("#1b1f24"),
                           QColor("#2c313a"),
                           QColor("#414955"),
                           QColor("#e3e7ec"),
                           QColor("#8b95a2"),
                           QColor("#3f8fd6"),
                           QColor("#4cc38a"),
                           QColor("#f0705f"),
                           QColor("#e0b04a"),
                           QColor("#2d3641"),
                           QColor("#15181c"),
                           QColor("#0d0f12"),
                           QColor("#ffe9a8"),
                           QColor("#e0b04a"),
                           QColor("#ff8a4d")};
  return theme;
}

const Theme& theme() {
  return *shown;
}

void applyTheme(const QString& name) {
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  shown = name == "dark" || (name == "system" && systemIsDark()) ? &darkTheme() : &lightTheme();
  QApplication::setPalette(paletteOf(*shown));
  qApp->setStyleSheet(styleSheetOf(*shown));
}

}  // namespace goniolux::gui
