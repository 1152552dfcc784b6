// The known name nearest to a mistyped one, for error messages.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace fabricsh {

// Edits (insert, delete, replace, swap neighbours) that turn a into b; letters compare without case.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The name nearest to `wrong` (the first one of a tie); empty if none is near (one edit per three letters).
std::string nearest(std::string_view wrong, std::span<const std::string> names);

// ", did you mean 'left'?" or an empty text, to be appended to "unknown set 'lft'".
std::string did_you_mean(std::string_view wrong, std::span<const std::string> names);

}  // namespace fabricsh
