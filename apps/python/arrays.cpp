#include "apps/python/arrays.hpp"

#include <algorithm>
#include <cstring>

#include "gearwright/base/contract.hpp"

namespace gearwright::python {

namespace {

// Writes a text in the form of numpy, which uses four bytes per character. Characters outside ASCII
// are omitted.
void put_word(char* at, std::size_t bytes, const std::string& word) {
  std::memset(at, 0, bytes);
  for (const char letter : word) {
    if (bytes == 0) return;
    if (static_cast<unsigned char>(letter) > 127) continue;
    *at = letter;
    at += 4;
    bytes -= 4;
  }
}

}  // namespace

std::optional<Numbers> real_numbers(py::handle value) {
  if (py::isinstance(value, py::module_::import("numpy.ma").attr("MaskedArray")))
    return std::nullopt;
  const py::array any = py::array::ensure(value);
  PyErr_Clear();
  if (!any || std::string_view("fiu").find(any.dtype().kind()) == std::string_view::npos)
    return std::nullopt;
  return Numbers::ensure(any);
}

StructuredArray::StructuredArray(const QuantityTable& table) {
  for (const RecordColumn& c : columns_of(table)) {
    const QuantityInfo& info = c.info();
    if (info.of || info.type == Type::map || info.type == Type::text || c.width() == 0) continue;
    std::string format = "f8";
    if (info.type == Type::word) {
      std::size_t longest = 1;
      for (const std::string& word : info.one_of) longest = std::max(longest, word.size());
      format = "U" + std::to_string(longest);
    } else if (info.type != Type::number && !c.optional) {
      format = info.type == Type::flag ? "?" : "i8";
    }
    columns_.push_back(c);
    add(c.name("_"), format, {info.list.begin(), info.list.end()});
  }
}

std::size_t StructuredArray::add(const std::string& name, const std::string& format,
                                 const std::vector<py::ssize_t>& shape) {
  Field field{format, stride_, 1, 8};
  if (format == "?") field.bytes = 1;
  if (format[0] == 'U') field.bytes = 4 * std::stoul(format.substr(1));
  for (const py::ssize_t n : shape) field.count *= static_cast<std::size_t>(n);
  stride_ += field.count * field.bytes;
  fields_.push_back(field);
  types_.append(py::make_tuple(name, format, py::tuple(py::cast(shape))));
  return fields_.size() - 1;
}

void StructuredArray::allocate(std::size_t rows) {
  array_ = py::array(py::dtype::from_args(types_),
                     std::vector<py::ssize_t>{static_cast<py::ssize_t>(rows)});
  GW_ENSURES(static_cast<std::size_t>(array_.itemsize()) == stride_);
  data_ = static_cast<char*>(array_.mutable_data());
  std::memset(data_, 0, rows * stride_);
}

void StructuredArray::set(std::size_t row, std::size_t column,
                          const std::vector<const Value*>& values) {
  const Field& field = fields_[column];
  GW_EXPECTS(values.size() == field.count);
  char* at = data_ + row * stride_ + field.offset;
  for (const Value* value : values) {
    const auto* const flag = std::get_if<bool>(&value->variant());
    const std::optional<double> number = flag ? (*flag ? 1.0 : 0.0) : value->number();
    if (field.format[0] == 'U') {
      const auto* word = std::get_if<std::string>(&value->variant());
      put_word(at, field.bytes, word ? *word : std::string());
    } else if (field.format == "?") {
      *at = number.value_or(0.0) != 0.0 ? 1 : 0;
    } else if (field.format == "i8") {
      const auto* const n = std::get_if<long long>(&value->variant());
      const long long whole = n ? *n : static_cast<long long>(number.value_or(0.0));
      std::memcpy(at, &whole, sizeof whole);
    } else {
      const double x = number.value_or(kNoNumber);
      std::memcpy(at, &x, sizeof x);
    }
    at += field.bytes;
  }
}

void StructuredArray::fill(std::size_t row, const ValueRecord& record) {
  for (std::size_t i = 0; i < columns_.size(); ++i) set(row, i, columns_[i].values(record));
}

py::array table_array(const QuantityTable& table, const ValueList& records) {
  StructuredArray array(table);
  array.allocate(records.size());
  for (std::size_t r = 0; r < records.size(); ++r) array.fill(r, *records[r].record());
  return array.take();
}

}  // namespace gearwright::python
