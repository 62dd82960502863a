#include "app/gui/forms/value_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace goniolux::gui {
namespace {

using core::Value;
using project::Form;
using project::Key;

QString tr(const char* text) {
  return QCoreApplication::translate("ValueText", text);
}

bool isPlainText(Form form) {
  return form == Form::text || form == Form::choice || form == Form::file || form == Form::photometry ||
         form == Form::opening || form == Form::spectral || form == Form::percentage || form == Form::source ||
         form == Form::reflectance || form == Form::quantity || form == Form::index;
}

QString json(const Value& value) {
  return QString::fromStdString(core::toJson(value)).simplified();
}

/// A number as people type it: 0.5, .5, 1e3; a comma is a decimal point.
std::optional<double> numberIn(QString text) {
  text = text.trimmed();
  text.replace(',', '.');
  bool ok = false;
  const double value = QLocale::c().toDouble(text, &ok);
  return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

QString rangeComplaint(double value, const Key& key) {
  if (value < key.minimum || (value == key.minimum && !key.minimumIsAllowed))
    return (key.minimumIsAllowed ? tr("must be at least %1") : tr("must be above %1")).arg(key.minimum);
  if (value > key.maximum) return tr("must be at most %1").arg(key.maximum);
  return {};
}

Typed numberOf(const QString& text, const Key& key, bool whole) {
  const auto number = numberIn(text);
  if (!number) return {std::nullopt, tr("is no number")};
  if (whole && *number != std::round(*number)) return {std::nullopt, tr("must be a whole number")};
  return {Value(*number), rangeComplaint(*number, key)};
}

}  // namespace

int partsOf(Form form) {
  switch (form) {
    case Form::point:
    case Form::direction:
      return 3;
    case Form::counts:
      return 2;
    default:
      return 1;
  }
}

QString textOf(const Value& value, Form form) {
  if (value.isNumber()) return QString::fromStdString(core::toJson(value)).trimmed();
  if (value.isString() && isPlainText(form)) return QString::fromStdString(value.string());
  if (value.isNull() && form == Form::numberOrNull) return "null";
  return json(value);
}

Typed valueOf(const QString& given, const Key& key) {
  const QString text = given.trimmed();
  if (text.isEmpty()) return {std::nullopt, key.required ? tr("is needed") : QString()};
  switch (key.form) {
    case Form::integer:
      return numberOf(text, key, true);
    case Form::number:
    case Form::length:
      return numberOf(text, key, false);
    case Form::numberOrNull:
      if (text == "null") return {Value(), {}};
      return numberOf(text, key, false);
    case Form::text:
    case Form::choice:
    case Form::file:
      return {Value(text.toStdString()), {}};
    default:
      break;
  }
  // A number, a list or object in JSON, else a name: files, percentages, illuminants.
  if (const auto number = numberIn(text)) return {Value(*number), rangeComplaint(*number, key)};
  if (text.startsWith('[') || text.startsWith('{') || text.startsWith('"')) {
    core::Diagnostics diagnostics;
    Value value = core::parseJson(text.toStdString(), "", diagnostics);
    if (diagnostics.hasErrors()) return {std::nullopt, QString::fromStdString(diagnostics.all().front().message)};
    return {std::move(value), {}};
  }
  if (isPlainText(key.form)) return {Value(text.toStdString()), {}};
  if (text == "true" || text == "false") return {Value(text == "true"), {}};
  return {std::nullopt, tr("is no value of this kind; lists are written [1, 2, 3]")};
}

}  // namespace goniolux::gui
