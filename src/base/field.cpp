#include "base/field.hpp"

namespace fabricsh::field {

std::string expected_number(const FieldRow& row) {
  std::string words =
      number_words(row.range, row.unit, row.holds == FieldType::integer ? "integer" : "number");
  if (!row.word.empty()) words += " or '" + row.word + "'";
  if (row.on) words += " or true or false";
  return words;
}

}  // namespace fabricsh::field
