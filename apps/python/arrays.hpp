// Stores quantities of many objects in one structured array, with a field for each column of the
// catalogue (columns.hpp).
//
// The name of a field is the key, such as "transmission_error_arcsec", and its values have the unit
// of the key. For a member of a record, the name combines both keys, for example
// "ellipse_semi_minor_mm". A missing number is NaN, and a missing word is "".
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/python/values.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/catalogue/columns.hpp"

namespace gearwright::python {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Returns the real numbers of an array or of lists. Returns nothing for any other content,
/// such as complex numbers, times, texts, flags or masked arrays, because numpy would convert
/// these without a warning.
std::optional<Numbers> real_numbers(py::handle value);

/// Returns an array that refers to the numbers at `data` without a copy and keeps their owner
/// alive.
template <class T, class Owner>
py::array_t<T> array_of(std::shared_ptr<Owner> owner, const T* data,
                        std::vector<py::ssize_t> shape) {
  auto* keep = new std::shared_ptr<Owner>(std::move(owner));
  const py::capsule base(keep, [](void* p) { delete static_cast<std::shared_ptr<Owner>*>(p); });
  return py::array_t<T>(std::move(shape), data, base);
}
template <class T>
py::array_t<T> array_of(std::vector<T> numbers, std::vector<py::ssize_t> shape) {
  auto owner = std::make_shared<std::vector<T>>(std::move(numbers));
  const T* data = owner->data();
  return array_of<T>(std::move(owner), data, std::move(shape));
}

/// Builds a structured array of NumPy, which take() returns.
class StructuredArray {
 public:
  StructuredArray() = default;
  /// Makes an array with one column for each number, flag and word of the table. Lists of variable
  /// length get no column.
  explicit StructuredArray(const QuantityTable& table);
  /// Adds a column with the given type ("f8", "i8", "?", "U7") and shape. Returns its index.
  std::size_t add(const std::string& name, const std::string& format,
                  const std::vector<py::ssize_t>& shape = {});
  /// Allocates the array with this number of rows. Every column must be added before this call.
  void allocate(std::size_t rows);
  /// Sets the values of one column in one row. The number of values must agree with the shape of
  /// the column. A missing value becomes NaN, 0, false or "".
  void set(std::size_t row, std::size_t column, const std::vector<const Value*>& values);
  /// Sets all columns of the table in one row from a record of this table.
  void fill(std::size_t row, const ValueRecord& record);
  py::array take() { return std::move(array_); }

 private:
  struct Field {
    std::string format;
    std::size_t offset, count, bytes;
  };
  std::vector<RecordColumn> columns_;
  std::vector<Field> fields_;
  py::list types_;
  py::array array_;
  char* data_ = nullptr;
  std::size_t stride_ = 0;
};

py::array table_array(const QuantityTable& table, const ValueList& records);

}  // namespace gearwright::python
