#include "app/gui/forms/field.h"

#include <QComboBox>
#include <QCompleter>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QStyle>
#include <QToolButton>

#include "app/gui/forms/sections.h"
#include "app/gui/forms/value_text.h"

namespace goniolux::gui {

using core::Value;
using project::Form;

namespace {

/// "default 1" of "factor; default 1".
QString defaultIn(const std::string& help) {
  const std::size_t at = help.find("default ");
  if (at == std::string::npos) return {};
  return QString::fromStdString(help.substr(at + 8, help.find(';', at) - at - 8));
}

bool isChoice(const project::Key& key) {
  return key.form == Form::choice || key.form == Form::boolean;
}

bool mayBeFile(Form form) {
  return form == Form::file || form == Form::photometry;
}

}  // namespace

Field::Field(const project::Key& key, const QStringList& suggestions, QWidget* parent)
    : QWidget(parent), key_(key), help_(QString::fromStdString(explanationOf(key))) {
  setObjectName("field " + QString::fromStdString(key.name));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  if (isChoice(key_)) {
    buildChoice();
  } else {
    buildLines(suggestions);
    if (mayBeFile(key_.form)) buildBrowse();
  }
  setToolTip(help_);
}

void Field::buildChoice() {
  choice_ = new QComboBox(this);
  choice_->setAccessibleName(translatedLabelOf(key_.name));
  if (!key_.required) {
    const QString standard = defaultIn(key_.help);
    choice_->addItem(standard.isEmpty() ? tr("as usual") : tr("%1 (as usual)").arg(standard), QString());
  }
  if (key_.form == Form::boolean) {
    choice_->addItem(tr("yes"), "true");
    choice_->addItem(tr("no"), "false");
  }
  for (const std::string& name : key_.choices)
    choice_->addItem(QString::fromStdString(name), QString::fromStdString(name));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(10);
  choice_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  layout()->addWidget(choice_);
  connect(choice_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    const QString picked = choice_->currentData().toString();
    if (picked == shown_) return;
    shown_ = picked;
    if (picked.isEmpty()) return Q_EMIT entered(std::nullopt);
    Q_EMIT entered(key_.form == Form::boolean ? Value(picked == "true") : Value(picked.toStdString()));
  });
}

void Field::buildLines(const QStringList& suggestions) {
  const int parts = partsOf(key_.form);
  for (int i = 0; i < parts; ++i) {
    auto* line = new QLineEdit(this);
    line->setObjectName(QString::fromStdString(key_.name) + (parts > 1 ? QString(" %1").arg(i) : QString()));
    line->setAccessibleName(translatedLabelOf(key_.name));
    line->setMinimumWidth(parts > 1 ? 44 : 80);
    if (parts == 1) line->setPlaceholderText(defaultIn(key_.help));
    if (parts == 3) line->setPlaceholderText(QString("xyz").mid(i, 1));
    if (!suggestions.isEmpty()) {
      auto* completer = new QCompleter(suggestions, line);
      completer->setFilterMode(Qt::MatchContains);
      completer->setCaseSensitivity(Qt::CaseInsensitive);
      line->setCompleter(completer);
    }
    layout()->addWidget(line);
    lines_.push_back(line);
    connect(line, &QLineEdit::textEdited, this, &Field::check);
    connect(line, &QLineEdit::editingFinished, this, &Field::commit);
  }
}

void Field::buildBrowse() {
  auto* browse = new QToolButton(this);
  browse->setText("…");
  browse->setToolTip(tr("Choose a file"));
  layout()->addWidget(browse);
  connect(browse, &QToolButton::clicked, this, [this] {
    const QString filter = key_.form == Form::photometry
                               ? tr("Photometric files (*.ies *.IES *.ldt *.LDT *.xml);;All files (*)")
                               : tr("All files (*)");
    const QString file = QFileDialog::getOpenFileName(this, tr("Choose a file"), QString(), filter);
    if (file.isEmpty()) return;
    lines_.front()->setText(file);
    check();
    commit();
  });
}

void Field::show(const Value* value, bool differs) {
  if (choice_ != nullptr) {
    shown_ = value == nullptr     ? QString()
             : value->isBoolean() ? QString(value->boolean() ? "true" : "false")
                                  : textOf(*value, key_.form);
    int index = choice_->findData(shown_);
    if (index < 0) {  // a value that the format does not know: shown as it is, and complained about by the reader
      choice_->addItem(shown_, shown_);
      index = choice_->count() - 1;
    }
    choice_->setCurrentIndex(index);
    return;
  }
  if (lines_.size() > 1) {
    const bool isList = value != nullptr && value->isArray() && value->array().size() == lines_.size();
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (!lines_[i]->isModified() || !lines_[i]->hasFocus())
        lines_[i]->setText(isList ? textOf(value->array()[i], Form::number) : QString());
  } else if (!lines_.front()->isModified() || !lines_.front()->hasFocus()) {
    lines_.front()->setText(value != nullptr && !differs ? textOf(*value, key_.form) : QString());
    if (differs) lines_.front()->setPlaceholderText(tr("different values"));
  }
  shown_ = typed();
  mark(!problem_.isEmpty(), problem_);
}

void Field::setProblem(const QString& message) {
  problem_ = message;
  mark(!message.isEmpty(), message);
}

QString Field::typed() const {
  if (lines_.size() == 1) return lines_.front()->text();
  QStringList parts;
  bool isEmpty = true;
  for (const QLineEdit* line : lines_) {
    parts << line->text().trimmed().replace(',', '.');
    isEmpty = isEmpty && parts.back().isEmpty();
  }
  return isEmpty ? QString() : "[" + parts.join(", ") + "]";
}

void Field::check() {
  const Typed now = valueOf(typed(), key_);
  mark(!now.complaint.isEmpty(), now.complaint);
}

void Field::commit() {
  const QString text = typed();
  for (QLineEdit* line : lines_) line->setModified(false);
  if (text == shown_) return;
  const Typed now = valueOf(text, key_);
  mark(!now.complaint.isEmpty(), now.complaint);
  if (!now.complaint.isEmpty()) return;
  shown_ = text;
  Q_EMIT entered(now.value);
}

void Field::mark(bool wrong, const QString& why) {
  isWrong_ = wrong;
  setToolTip(wrong ? why + "\n\n" + help_ : help_);
  for (QLineEdit* line : lines_) {
    if (line->property("wrong").toBool() == wrong) continue;
    line->setProperty("wrong", wrong);
    line->style()->unpolish(line);
    line->style()->polish(line);
  }
}

}  // namespace goniolux::gui
