// Quantities of many subjects as one structured array, a column for each quantity of the catalogue.
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

/// Rows of a table, filled value by value.
class StructuredArray {
 public:
  /// Columns of the table, those of its records too; names begin with the prefix.
  void add_columns(const QuantityTable& table, const std::string& prefix = "",
                   bool optional = false);
  /// A column by itself: "f8", "i8", "?", "U7".
  void add_column(const std::string& name, const std::string& format);
  /// So many rows of the columns added.
  void allocate(std::size_t rows);
  /// One row, its values in the order of the tables: null of a record is nothing in all of its columns.
  template <class S>
  void fill(std::size_t row, const Quantities<S>& quantities, const S& subject,
            std::size_t from = 0) {
    for (const Quantity<S>& q : quantities.list()) {
      const bool there = !q.exists || q.exists(subject);
      from = put(row, from, q.info, there ? q.get(subject) : Value());
    }
  }
  /// NaN and false in every column, and a text in the last.
  void nothing(std::size_t row, const std::string& why);
  void set(std::size_t row, std::size_t column, const Value& value) {
    const Column& c = columns_[column];
    put_plain(data_ + row * stride_ + c.offset, c, value);
  }
  py::array take() { return std::move(array_); }

 private:
  struct Column {
    std::string name, format;
    std::vector<py::ssize_t> shape;
    std::size_t offset = 0, count = 1, bytes = 8;
  };
  std::size_t put(std::size_t row, std::size_t column, const QuantityInfo& info,
                  const Value& value);
  void put_plain(char* at, const Column& column, const Value& value);

  std::vector<Column> columns_;
  py::array array_;
  char* data_ = nullptr;
  std::size_t stride_ = 0;
};

/// Numbers of nested lists as an array, null as NaN.   Domain  lists of one length on each level
py::array number_array(const Value& value, double unit);

}  // namespace gearwright::python
