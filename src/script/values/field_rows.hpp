// The rows of fields (base/field.hpp) as rows of arguments, and structs read from Lua tables by them.
#pragma once
#include <string>
#include <vector>

#include "base/field.hpp"
#include "script/call/call.hpp"

namespace fabricsh::script {

Argument argument_of(const field::FieldRow& row);
// The value that the table gives, which has been checked. path: "warp." inside the table warp.
field::Value read_value(const Fields& fields, const field::FieldRow& row, const std::string& path);

template <class Owner>
std::vector<Argument> arguments_of(const std::vector<field::FieldOf<Owner>>& rows) {
  std::vector<Argument> out;
  for (const auto& row : rows) {
    out.push_back(argument_of(row));
    out.back().rows = arguments_of(row.rows);
  }
  return out;
}

template <class Owner>
void read_rows(const Fields& fields, const std::vector<field::FieldOf<Owner>>& rows, Owner& owner,
               const std::string& path = {}) {
  for (const auto& row : rows) {
    if (!fields.has(row.name)) {
      if (!std::holds_alternative<std::monostate>(row.fallback)) row.set(owner, row.fallback);
    } else if (row.holds == field::FieldType::group) {
      row.make(owner);
      read_rows(fields.fields(row.name), row.rows, owner, path + row.name + ".");
      lua_pop(fields.L(), 1);
    } else {
      row.set(owner, read_value(fields, row, path));
    }
  }
}

}  // namespace fabricsh::script
