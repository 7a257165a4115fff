#include "apps/python/arrays.hpp"

#include <algorithm>
#include <cstring>

#include "gearwright/base/contract.hpp"

namespace gearwright::python {

namespace {

void collect(const Value& value, double unit, std::vector<double>& numbers) {
  if (const ValueList* list = value.list()) {
    for (const Value& v : *list) collect(v, unit, numbers);
  } else {
    const auto x = value.number();
    numbers.push_back(x ? *x * unit : kNothing);
  }
}

// A text as numpy keeps it, four bytes a letter; what is no ASCII is left out.
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

py::array number_array(const Value& value, double unit) {
  std::vector<py::ssize_t> shape;
  for (const Value* v = &value; v->list(); v = &v->list()->front()) {
    shape.push_back(static_cast<py::ssize_t>(v->list()->size()));
    if (v->list()->empty()) break;
  }
  std::vector<double> numbers;
  collect(value, unit, numbers);
  return array_of(std::move(numbers), std::move(shape));
}

void StructuredArray::add_column(const std::string& name, const std::string& format) {
  const std::size_t bytes = format[0] == 'U' ? 4 * std::stoul(format.substr(1))
                            : format == "?"  ? 1
                                             : 8;
  columns_.push_back({name, format, {}, 0, 1, bytes});
}

void StructuredArray::add_columns(const QuantityTable& table, const std::string& prefix,
                                  bool optional) {
  for (const QuantityInfo* info : table.list) {
    const bool there = info->always && !info->optional_key && !optional;
    if (info->of && info->list.empty()) {
      add_columns(info->of(), prefix + info->key + "_", optional || !there);
      continue;
    }
    add_column(prefix + info->key, "f8");
    Column& c = columns_.back();
    const bool any_length = std::find(info->list.begin(), info->list.end(), 0) != info->list.end();
    if (info->of || info->type == Type::map || info->type == Type::text || any_length) {
      c.count = 0;  // no column: its value is passed over
    } else if (info->type == Type::word) {
      std::size_t longest = 1;
      for (const std::string& word : info->one_of) longest = std::max(longest, word.size());
      c.format = "U" + std::to_string(longest);
      c.bytes = 4 * longest;
    } else if (info->type == Type::flag && there) {
      c.format = "?";
      c.bytes = 1;
    } else if (info->type != Type::number && there) {
      c.format = "i8";
    }
    for (const int n : info->list) {
      c.shape.push_back(n);
      c.count *= static_cast<std::size_t>(n);
    }
  }
}

void StructuredArray::allocate(std::size_t rows) {
  py::list fields;
  for (Column& c : columns_) {
    if (c.count == 0) continue;
    c.offset = stride_;
    stride_ += c.count * c.bytes;
    fields.append(py::make_tuple(c.name, c.format, py::tuple(py::cast(c.shape))));
  }
  array_ = py::array(py::dtype::from_args(fields),
                     std::vector<py::ssize_t>{static_cast<py::ssize_t>(rows)});
  GW_ENSURES(static_cast<std::size_t>(array_.itemsize()) == stride_);
  data_ = static_cast<char*>(array_.mutable_data());
  std::memset(data_, 0, rows * stride_);
}

void StructuredArray::put_plain(char* at, const Column& column, const Value& value) {
  if (column.format[0] == 'U') {
    const auto* word = std::get_if<std::string>(&value.variant());
    put_word(at, column.bytes, word ? *word : std::string());
  } else if (column.format == "?") {
    *at = std::get<bool>(value.variant()) ? 1 : 0;
  } else if (column.format == "i8") {
    const auto* flag = std::get_if<bool>(&value.variant());
    const long long whole = flag ? (*flag ? 1 : 0) : std::get<long long>(value.variant());
    std::memcpy(at, &whole, sizeof whole);
  } else {
    const auto* flag = std::get_if<bool>(&value.variant());
    const double x = flag ? (*flag ? 1.0 : 0.0) : value.number().value_or(kNothing);
    std::memcpy(at, &x, sizeof x);
  }
}

void StructuredArray::nothing(std::size_t row, const std::string& why) {
  for (const Column& c : columns_) {
    for (std::size_t i = 0; i < c.count; ++i) {
      char* const at = data_ + row * stride_ + c.offset + i * c.bytes;
      if (c.format == "f8") {
        put_plain(at, c, Value());
      } else {
        std::memset(at, 0, c.bytes);
      }
    }
  }
  put_word(data_ + row * stride_ + columns_.back().offset, columns_.back().bytes, why);
}

std::size_t StructuredArray::put(std::size_t row, std::size_t column, const QuantityInfo& info,
                                 const Value& value) {
  if (info.of && info.list.empty()) {
    const ValueRecord* record = value.record();
    std::size_t i = 0;
    for (const QuantityInfo* inner : info.of().list) {
      // A record leaves out what does not exist in it.
      const bool there = record && i < record->size() && (*record)[i].info == inner;
      column = put(row, column, *inner, there ? (*record)[i].value : Value());
      if (there) ++i;
    }
    return column;
  }
  const Column& c = columns_[column];
  if (c.count > 0) {
    char* at = data_ + row * stride_ + c.offset;
    std::vector<const Value*> plain{&value};
    for (std::size_t level = 0; level < c.shape.size(); ++level) {
      std::vector<const Value*> inner;
      for (const Value* v : plain) {
        const ValueList* list = v->list();
        for (py::ssize_t i = 0; i < c.shape[level]; ++i)
          inner.push_back(list ? &(*list)[static_cast<std::size_t>(i)] : v);
      }
      plain = std::move(inner);
    }
    for (std::size_t i = 0; i < c.count; ++i) put_plain(at + i * c.bytes, c, *plain[i]);
  }
  return column + 1;
}

}  // namespace gearwright::python
