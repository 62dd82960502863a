// ValuesModel: the points of a grid with their values and half-widths as a table of any length: what is seen is worded,
// the rest is not. Sorted by any column.
#pragma once

#include <QAbstractTableModel>
#include <memory>
#include <vector>

#include "app/gui/plots/plan_view.h"

namespace goniolux::gui {

class ValuesModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { xColumn, yColumn, valueColumn, halfWidthColumn, columns };

  using QAbstractTableModel::QAbstractTableModel;
  /// Null: nothing.
  void show(std::shared_ptr<const PlanView::Content> content);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  /// Points that are not counted stand at the end.
  void sort(int column, Qt::SortOrder order) override;

 private:
  [[nodiscard]] double number(std::size_t point, int column) const;
  void arrange();

  std::shared_ptr<const PlanView::Content> content_;
  std::vector<std::size_t> order_;  ///< the point of each row
  int sortedBy_ = -1;
  Qt::SortOrder direction_ = Qt::AscendingOrder;
};

}  // namespace goniolux::gui
