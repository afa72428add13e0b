#include "specs/spec_unit.hpp"

#include <utility>
#include <vector>

namespace kempe {
namespace {

/// A number in the place of another value, on its line: toml++ gives lines to what it has parsed alone.
class NumberInPlace : public toml::value<double> {
 public:
  NumberInPlace(double number, toml::node&& place) : toml::value<double>(number) {
    toml::node::operator=(std::move(place));
  }
};

toml::value<double> enlarged(toml::node&& number) {
  const double inches = finite_number(number).value_or(0);
  return NumberInPlace(in_mm(SpecUnit::inch) * inches, std::move(number));
}

void enlarge_inside(toml::node& value);

void enlarge_inside(toml::array& list) {
  for (auto element = list.begin(); element != list.end(); ++element) {
    if (element->is_integer())
      list.replace(element, enlarged(std::move(*element)));
    else
      enlarge_inside(*element);
  }
}

void enlarge_inside(toml::table& table) {
  for (auto&& [key, value] : table) {
    if (value.is_integer())
      table.insert_or_assign(key, enlarged(std::move(value)));
    else
      enlarge_inside(value);
  }
}

void enlarge_inside(toml::node& value) {
  if (auto* number = value.as_floating_point()) *number = in_mm(SpecUnit::inch) * number->get();
  if (auto* list = value.as_array()) enlarge_inside(*list);
  if (auto* table = value.as_table()) enlarge_inside(*table);
}

/// The value under the key's name in millimetres; the old key goes.
void rename(toml::table& table, const toml::key& inches) {
  toml::node& value = *table.get(inches);
  const toml::key millimetres(name_in_mm(inches, SpecUnit::inch), inches.source());
  if (value.is_integer())
    table.insert_or_assign(millimetres, enlarged(std::move(value)));
  else {
    enlarge_inside(value);
    table.insert_or_assign(millimetres, std::move(value));
  }
  table.erase(inches);
}

void convert_keys(toml::table& table);

void convert_tables(toml::node& value) {
  if (auto* table = value.as_table()) convert_keys(*table);
  if (auto* list = value.as_array())
    for (toml::node& element : *list) convert_tables(element);
}

void convert_keys(toml::table& table) {
  std::vector<toml::key> lengths;
  for (auto&& [key, value] : table) {
    if (key.str().ends_with("_in"))
      lengths.push_back(key);
    else
      convert_tables(value);
  }
  for (const toml::key& key : lengths) rename(table, key);
}

}  // namespace

SpecUnit spec_unit_of(const toml::table& spec) {
  return spec["units"].value_or(std::string()) == "in" ? SpecUnit::inch : SpecUnit::mm;
}

std::string name_in_mm(std::string_view name, SpecUnit unit) {
  if (unit == SpecUnit::mm || !name.ends_with("_in")) return std::string(name);
  return std::string(name.substr(0, name.size() - 2)) + "mm";
}

void to_millimetres(toml::table& spec) { convert_keys(spec); }

}  // namespace kempe
