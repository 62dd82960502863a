#include "app/gui/plots/values_model.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "plot/number_text.h"

namespace goniolux::gui {

void ValuesModel::show(std::shared_ptr<const PlanView::Content> content) {
  beginResetModel();
  content_ = std::move(content);
  arrange();
  endResetModel();
}

int ValuesModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(order_.size());
}

int ValuesModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : columns;
}

double ValuesModel::number(std::size_t point, int column) const {
  switch (column) {
    case xColumn:
      return content_->map.points[point].x;
    case yColumn:
      return content_->map.points[point].y;
    case valueColumn:
      return content_->map.values[point];
    default:
      return std::isfinite(content_->map.values[point]) ? content_->halfWidths[point] : std::nan("");
  }
}

QVariant ValuesModel::data(const QModelIndex& index, int role) const {
  if (!content_ || !index.isValid()) return {};
  if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const std::size_t point = order_[static_cast<std::size_t>(index.row())];
  const double value = number(point, index.column());
  if (index.column() < valueColumn) return QString::number(value, 'f', 2);
  if (index.column() == halfWidthColumn)
    return std::isfinite(value) ? QString("± %1").arg(value, 0, 'g', 2) : QString();
  if (!std::isfinite(value)) return tr("not counted");
  return QString::fromStdString(plot::pointText(value) + " " + content_->map.unit);
}

QVariant ValuesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Vertical || role != Qt::DisplayRole) return {};
  const QString titles[columns] = {"x / m", "y / m", tr("Value"), tr("Half-width")};
  return section >= 0 && section < columns ? titles[section] : QVariant();
}

void ValuesModel::sort(int column, Qt::SortOrder order) {
  sortedBy_ = column;
  direction_ = order;
  Q_EMIT layoutAboutToBeChanged();
  arrange();
  Q_EMIT layoutChanged();
}

void ValuesModel::arrange() {
  order_.resize(content_ ? content_->map.points.size() : 0);
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  if (sortedBy_ < 0) return;
  std::stable_sort(order_.begin(), order_.end(), [this](std::size_t a, std::size_t b) {
    const double x = number(a, sortedBy_), y = number(b, sortedBy_);
    if (!std::isfinite(x) || !std::isfinite(y)) return std::isfinite(x);
    return direction_ == Qt::AscendingOrder ? x < y : x > y;
  });
}

}  // namespace goniolux::gui
