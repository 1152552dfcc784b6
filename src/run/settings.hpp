// The rows of a run's options (base/field.hpp), and the settings: those options that may change during a run.
#pragma once
#include "base/archive.hpp"
#include "base/error.hpp"
#include "base/field.hpp"
#include "base/number.hpp"
#include "run/run.hpp"

namespace fabricsh::run {

// Rows that several kinds of run have.
template <class Options>
field::FieldOf<Options> limit_row() {
  return field::word("limit", &Options::limit, {"tell", "stop"},
                     "tell: warns once when the cloth is strained beyond what the card was tested to (2 % "
                     "are let pass); stop: ends the run there, on the strain, however long the steps");
}
template <class Options>
field::FieldOf<Options> linear_row(const std::string& which) {
  return field::word(
      "linear", &Options::linear, {"auto", "symmetric", "unsymmetric"},
      which + "direct solver: auto (symmetric where law and loads are), symmetric, unsymmetric");
}

// now: the present value; given: that at creation. Reading keeps the present value if `given` differs.
// Not inlined, since GCC 12 then warns of an empty optional's number as uninitialised.
template <class T>
[[gnu::noinline]] void keep_setting(Archive& archive, const T& given, T& now) {
  T given_then = given, then = now;
  archive(given_then, then);
  if (archive.reading() && given_then == given) now = then;
}

// The rows of the settings in the order in which a checkpoint has them.
template <class Options>
std::vector<const field::FieldOf<Options>*> settings_of(const std::vector<field::FieldOf<Options>>& rows) {
  std::vector<const field::FieldOf<Options>*> out;
  for (const auto& row : rows)
    if (row.place > 0) out.push_back(&row);
  std::sort(out.begin(), out.end(), [](const auto* a, const auto* b) { return a->place < b->place; });
  return out;
}

template <class Options>
void keep_settings(Archive& archive, const std::vector<field::FieldOf<Options>>& rows, const Options& given,
                   Options& now) {
  const auto number_of = [](const field::Value& value) {
    const auto* x = std::get_if<double>(&value);
    return x == nullptr ? std::nullopt : std::optional<double>(*x);
  };
  for (const auto* row : settings_of(rows)) {
    const std::optional<double> first = number_of(row->get(given));
    std::optional<double> x = number_of(row->get(now));
    if (row->holds == field::FieldType::integer) {
      int n = static_cast<int>(*x);
      keep_setting(archive, static_cast<int>(*first), n);
      x = n;
    } else if (row->required || !std::holds_alternative<std::monostate>(row->fallback)) {
      keep_setting(archive, *first, *x);
    } else {
      keep_setting(archive, first, x);
    }
    if (archive.reading() && x) row->set(now, *x);
  }
}

// ", error 0.001": of the options on which results depend those that are not as they are at first.
template <class Options>
std::string decided_text(const std::vector<field::FieldOf<Options>>& rows, const Options& options) {
  std::string text;
  for (const auto& row : rows) {
    const field::Value value = row.get ? row.get(options) : field::Value();
    if (!row.decides || value == row.get(Options{})) continue;
    text += ", " + row.name + " ";
    if (const auto* x = std::get_if<double>(&value)) text += number(*x);
    if (const auto* flag = std::get_if<bool>(&value)) text += *flag ? "true" : "false";
    if (const auto* word = std::get_if<std::string>(&value)) text += *word;
  }
  return text;
}

// Error: with this step the run would not end.
inline void check_step(const char* call, double step, double duration) {
  if (!(duration / step <= most_steps))
    throw Error(std::string(call) + ": field 'step': expected at least " + number(duration / most_steps) +
                " s (" + number(most_steps) + " steps to the duration of " + number(duration) + " s), got " +
                number(step) + " s");
}

// The options with the given changes. Error: no setting of that name.
template <class Options>
Options with_settings(Options options, const std::vector<field::FieldOf<Options>>& rows,
                      const Run::Settings& wanted) {
  const auto settings = settings_of(rows);
  for (const auto& [name, value] : wanted) {
    const auto row =
        std::find_if(settings.begin(), settings.end(), [&](const auto* r) { return r->name == name; });
    if (row == settings.end())
      throw Error("set: field '" + name + "': expected a setting that may change during a run");
    (*row)->set(options, value);
  }
  return options;
}

}  // namespace fabricsh::run
