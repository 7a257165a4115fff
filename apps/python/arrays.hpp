// Quantities of many subjects as one structured array, a column for each column of the catalogue (columns.hpp).
//
// Columns are called by key, "transmission_error_arcsec", and have the key's unit; those of records by both keys,
// "ellipse_semi_minor_mm". What is not there is NaN, of a word "".
#pragma once

#include <pybind11/numpy.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/python/values.hpp"
#include "gearwright/catalogue/columns.hpp"

namespace gearwright::python {

inline constexpr double kNothing =
    std::numeric_limits<double>::quiet_NaN();  ///< of what is not there

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The real numbers of an array or of lists; none where they are something else, which numpy would
/// turn into numbers without a word: complex ones, times, texts, flags, arrays with masked places.
std::optional<Numbers> real_numbers(py::handle value);

/// An array that owns the vector: no number is copied.
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

/// A structured array in the making.
class StructuredArray {
 public:
  StructuredArray() = default;
  /// With the columns of a table that have a fixed number of values.
  explicit StructuredArray(const QuantityTable& table);
  /// The place of one more column: "f8", "i8", "?", "U7", of a shape.
  std::size_t add(const std::string& name, const std::string& format,
                  const std::vector<py::ssize_t>& shape = {});
  /// So many rows of the columns added.
  void allocate(std::size_t rows);
  /// The values of a row in one column, as many as its shape has; nothing is NaN, false, "".
  void set(std::size_t row, std::size_t column, const std::vector<const Value*>& values);
  /// The columns of the table from a record of it.
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

/// A row for each record of a list.
py::array table_array(const QuantityTable& table, const ValueList& records);

}  // namespace gearwright::python
