// The reader of tables on any bytes: columns of one length, or an Error. The first byte chooses the form.
#include <cstdint>
#include <cstdlib>

#include "base/error.hpp"
#include "format/table.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fabricsh;
  if (size == 0) return 0;
  constexpr char separators[] = {0, ',', ';', '\t', ' '}, decimals[] = {0, '.', ','};
  const format::TableForm form{separators[data[0] % 5], decimals[data[0] / 5 % 3]};
  try {
    const format::Table table =
        format::parse_table("fuzz", {reinterpret_cast<const char*>(data) + 1, size - 1}, form);
    for (const auto& column : table.columns)
      if (column.values.size() != table.columns.front().values.size()) std::abort();
  } catch (const Error&) {
  }
  return 0;
}
