#include "gearwright/job/listing.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/printable.hpp"

namespace gearwright {

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, character_count(text)), ' ');
}

std::string padded_left(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, character_count(text)), ' ') + text;
}

std::string wrapped(std::string_view text) {
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  const std::string indent(first + 2, ' ');
  std::string lines(text.substr(0, first));
  std::size_t column = first;
  for (std::string_view rest = text.substr(first); !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (column > first) {
      const bool fits = column + 1 + character_count(word) <= kLineWidth;
      lines += fits ? " " : "\n" + indent;
      column = fits ? column + 1 : indent.size();
    }
    lines += word;
    column += character_count(word);
  }
  return lines + "\n";
}

namespace {

constexpr std::size_t kHeadWidth = 12;       // width of headings
constexpr std::size_t kDesignHeadWidth = 8;  // width of headings in tables of designs, which have
                                             // many columns

// Breaks words into lines of at most `most` characters. A longer word has a line of its own.
std::vector<std::string> broken(const std::string& words, std::size_t most) {
  std::vector<std::string> lines;
  std::istringstream text(words);
  for (std::string word; text >> word;) {
    if (lines.empty() || character_count(lines.back()) + 1 + character_count(word) > most)
      lines.push_back(word);
    else
      lines.back() += " " + word;
  }
  return lines;
}

// Returns the lines of a column. They are its heading, broken at `head_width` and filled up to
// `heads` lines, then its unit, and then its cells.
std::vector<std::string> lines_of(const ListingColumn& column, std::size_t head_width,
                                  std::size_t heads) {
  std::vector<std::string> lines = broken(column.head, head_width);
  lines.insert(lines.begin(), heads - lines.size(), "");
  lines.push_back(column.unit);
  lines.insert(lines.end(), column.cells.begin(), column.cells.end());
  std::size_t widest = 0;
  for (const std::string& each : lines) widest = std::max(widest, character_count(each));
  for (std::string& each : lines)
    each = "  " + (column.left ? padded(each, widest) : padded_left(each, widest));
  return lines;
}

std::string table_of(const std::vector<const ListingColumn*>& columns, std::size_t head_width) {
  std::size_t heads = 0;
  for (const ListingColumn* c : columns)
    heads = std::max(heads, broken(c->head, head_width).size());
  std::vector<std::string> lines(heads + 1 + columns.front()->cells.size());
  for (const ListingColumn* c : columns) {
    const std::vector<std::string> own = lines_of(*c, head_width, heads);
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] += own[i];
  }
  std::string text;
  for (std::string& each : lines) {
    each.erase(each.find_last_not_of(' ') + 1);
    if (!each.empty()) text += each + "\n";
  }
  return text;
}

bool all_equal(const ListingColumn& column) {
  return std::all_of(column.cells.begin(), column.cells.end(),
                     [&](const std::string& cell) { return cell == column.cells.front(); });
}

// True if every number of `a` is `factor` times the number of `b`, and both have the same unit.
bool proportional(const ListingColumn& a, const ListingColumn& b, double factor) {
  // If two formulas compute the same quantity, the results differ only by rounding errors.
  constexpr double kRounding = 1e-9;
  const auto same = [&](const std::optional<double>& x, const std::optional<double>& y) {
    return x && y && std::abs(*x - factor * *y) <= kRounding * std::abs(*x);
  };
  return a.unit == b.unit && !a.numbers.empty() && !b.numbers.empty() &&
         std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(), same);
}

// Returns "equal to u" if a column u of `columns` has the same numbers as `column`, or
// "opposite to u" if the numbers of u differ only in sign. Otherwise returns none.
std::optional<std::string> relation(const ListingColumn& column,
                                    const std::vector<const ListingColumn*>& columns) {
  for (const ListingColumn* other : columns) {
    if (proportional(column, *other, 1.0)) return "equal to " + other->head;
    if (proportional(column, *other, -1.0)) return "opposite to " + other->head;
  }
  return std::nullopt;
}

// Divides the columns into tables at most kTableWidth characters wide. Every table begins with the
// first column.
std::string tables_of(const std::vector<const ListingColumn*>& columns) {
  const auto width = [](const ListingColumn& c) {
    const std::size_t heads = broken(c.head, kDesignHeadWidth).size();
    return character_count(lines_of(c, kDesignHeadWidth, heads).front());
  };
  const std::size_t first = width(*columns.front());
  std::string text;
  std::vector<const ListingColumn*> table{columns.front()};
  std::size_t used = first;
  for (std::size_t i = 1; i < columns.size(); ++i) {
    if (used + width(*columns[i]) > kTableWidth && table.size() > 1) {
      text += table_of(table, kDesignHeadWidth) + "\n";
      table.resize(1);
      used = first;
    }
    table.push_back(columns[i]);
    used += width(*columns[i]);
  }
  return text + table_of(table, kDesignHeadWidth);
}

}  // namespace

std::string row_listing(UnitSystem units, const std::vector<std::string>& names,
                        const std::vector<ValueRecord>& records,
                        std::initializer_list<std::string_view> keys) {
  return table_listing(record_table(units, "", names, records, keys));
}

std::string table_listing(const TextTable& table) {
  const auto starts_with_letter = [](const std::string& cell) {
    return cell.empty() || cell == kAbsent || std::isalpha(static_cast<unsigned char>(cell[0]));
  };
  std::vector<ListingColumn> columns{{"", "", "", {}, true}};
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    columns.push_back(
        {"", table.columns[i], i < table.units.size() ? table.units[i] : std::string(), {}});
  const auto add = [&](std::string words, const std::vector<std::string>& cells) {
    columns[0].cells.push_back(std::move(words));
    for (std::size_t i = 0; i < cells.size(); ++i) columns[i + 1].cells.push_back(cells[i]);
  };
  std::string zeros;
  for (const TextTable::Row& row : table.rows) {
    std::string digits;
    for (const std::string& cell : row.cells) digits += cell;
    if (table.omit_zeros && digits.find('0') != digits.npos &&
        digits.find_first_not_of("-.0") == digits.npos) {
      zeros += (zeros.empty() ? "  zero to these digits: " : ", ") + row.words;
      continue;
    }
    add(row.words + (row.unit.empty() ? "" : "  ") + row.unit, row.cells);
    if (!row.errors.empty()) add("    standard error", row.errors);
  }
  std::vector<const ListingColumn*> all;
  for (ListingColumn& column : columns) {
    column.left =
        column.left || std::all_of(column.cells.begin(), column.cells.end(), starts_with_letter);
    all.push_back(&column);
  }
  std::string text = table.title.empty() ? "" : "\n" + wrapped(table.title);
  if (!columns[0].cells.empty()) text += table_of(all, kHeadWidth);
  if (!zeros.empty()) text += wrapped(zeros);
  for (const std::string& note : table.notes) text += wrapped("  " + note);
  return text;
}

std::string design_listing(const std::vector<ListingColumn>& columns) {
  std::vector<const ListingColumn*> table{&columns.front()};
  struct Common {
    const ListingColumn* column;
    std::string value;
  };
  std::vector<Common> common;
  for (std::size_t i = 1; i < columns.size(); ++i) {
    const ListingColumn& c = columns[i];
    const bool several = c.cells.size() > 1;
    if (several && all_equal(c))
      common.push_back({&c, c.cells.front() + (c.unit.empty() ? "" : " ") + c.unit});
    else if (const auto twin = several ? relation(c, table) : std::nullopt)
      common.push_back({&c, *twin});
    else
      table.push_back(&c);
  }
  const auto head = [](const ListingColumn& c) { return c.head == c.words ? "" : c.head; };
  std::size_t words = 0;
  std::size_t heads = 0;
  for (const Common& each : common) {
    words = std::max(words, character_count(each.column->words));
    heads = std::max(heads, character_count(head(*each.column)));
  }
  std::string text = common.empty() ? "" : "Common to all designs\n";
  for (const Common& each : common) {
    text += "  " + padded(each.column->words, words + 2) +
            (heads > 0 ? padded(head(*each.column), heads + 2) : "") + each.value + "\n";
  }
  return text + (common.empty() ? "" : "\n") + tables_of(table);
}

std::string ranked_listing(UnitSystem units, const std::vector<std::size_t>& pareto,
                           ListingColumn second, const std::vector<ValueRecord>& records,
                           std::initializer_list<std::string_view> keys) {
  std::vector<ListingColumn> columns{{}, std::move(second)};
  for (std::size_t i = 0; i < records.size(); ++i)
    columns[0].cells.push_back(fmt::format("{}{}", is_in(i, pareto) ? "*" : "", i + 1));
  for (ListingColumn& column : listing_columns(units, records, keys))
    columns.push_back(std::move(column));
  return "\n" + design_listing(columns) +
         (pareto.empty() ? "" : "  * marks designs on the Pareto front of the objectives\n");
}

}  // namespace gearwright
