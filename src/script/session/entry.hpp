// The registry: one row per Lua function and property. Argument checks, help, completion and the reference
// page use it; a test fails for a row without a sentence or without an example that runs.
#pragma once
#include <deque>
#include <lua.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/range.hpp"

namespace fabricsh::script {

class Call;

// The permitted types of a value; several are joined by |.
enum ValueKind : unsigned {
  number = 1,
  integer = 2,
  text = 4,
  boolean = 8,
  function = 16,
  numbers = 32,  // a table of numbers
  fields = 64,   // a table with named fields, given by the rows
  table = 128,   // a table that the function examines itself
  object = 256,  // a fabricsh object of class Argument::of
  any = 512,
};

inline constexpr std::pair<const char*, ValueKind> kind_names[] = {
    {"number", number},     {"integer", integer}, {"text", text},     {"boolean", boolean},
    {"function", function}, {"numbers", numbers}, {"fields", fields}, {"table", table},
    {"object", object},     {"any", any}};

struct Argument {
  std::string name;
  unsigned kinds = any;
  std::string unit = {};  // "m"; empty: none
  Range range = {};       // for a number, and for every number of a list
  std::string sentence = {};
  bool required = true;
  std::variant<std::monostate, double, std::string, bool> fallback = {};
  std::vector<std::string> choices = {};  // for a text; empty: any text
  bool with_owner = false;                // a choice may stand behind the name of what it is of: "ply2.E11"
  std::string of = {};                    // class, for an object
  std::vector<Argument> rows = {};        // of Kind::fields
  Range usual = {};                       // outside it a warning questions the unit
  std::string hint = {};                  // the question of that warning

  Argument optional() const {
    Argument copy = *this;
    copy.required = false;
    return copy;
  }
  template <class T>
  Argument or_else(T value) const {
    Argument copy = optional();
    if constexpr (std::is_same_v<T, bool>)
      copy.fallback = value;
    else if constexpr (std::is_arithmetic_v<T>)
      copy.fallback = static_cast<double>(value);
    else
      copy.fallback = std::string(value);
    return copy;
  }
  Argument usually(double low, double high, std::string question) const {
    Argument copy = *this;
    copy.usual = Range{low, high};
    copy.hint = std::move(question);
    return copy;
  }
  Argument one_of(std::vector<std::string> words) const {
    Argument copy = *this;
    copy.choices = std::move(words);
    return copy;
  }
  Argument owned() const {
    Argument copy = *this;
    copy.with_owner = true;
    return copy;
  }
};

// A row reads, for example: number_("width", "m", positive, "size along x"). A name that ends in ? is that of
// an argument which may be left out.
inline Argument argument_(std::string name, unsigned kinds, std::string unit, Range range,
                          std::string sentence) {
  const bool optional = name.ends_with('?');
  if (optional) name.pop_back();
  return {std::move(name), kinds, std::move(unit), range, std::move(sentence), !optional};
}
inline Argument number_(std::string name, std::string unit, Range range, std::string sentence) {
  return argument_(std::move(name), number, std::move(unit), range, std::move(sentence));
}
inline Argument integer_(std::string name, Range range, std::string sentence) {
  return argument_(std::move(name), integer, "", range, std::move(sentence));
}
inline Argument value_(std::string name, unsigned kinds, std::string sentence, std::string unit = "") {
  return argument_(std::move(name), kinds, std::move(unit), {}, std::move(sentence));
}
// True or false, which is what it is where it is left out.
inline Argument flag_(std::string name, std::string sentence) {
  return value_(std::move(name), boolean, std::move(sentence)).or_else(false);
}
inline Argument object_(std::string name, std::string of, std::string sentence, unsigned others = 0) {
  Argument row = argument_(std::move(name), object | others, "", {}, std::move(sentence));
  row.of = std::move(of);
  return row;
}
inline Argument fields_(std::string name, std::vector<Argument> rows, std::string sentence) {
  Argument row = argument_(std::move(name), fields, "", {}, std::move(sentence));
  row.rows = std::move(rows);
  return row;
}

enum class Style {
  fields,      // f{ name = value, ... }
  positional,  // f(a, b)
  property,    // object.name
};

// Results that a call touches and a restarted deck has to repeat (script/runs/drive.hpp).
enum class Touches {
  nothing,    // no results of a run, or a call that deals with restarts itself
  results,    // a method or property that returns results of its run
  whole_run,  // a function that takes a run as an argument
};

struct Entry {
  // fabric.mesh.rectangle (function), mesh:set (method), mesh.nodes (property). In the rows of bindings it
  // says how it is called, "fabric.mesh.rectangle{}", "mesh:set()", which install() takes off.
  std::string name;
  std::vector<Argument> arguments = {};
  std::string sentence = {};
  // A chunk that runs without anything else; the registry begins it with a variable `fabric` unless it
  // requires the library itself.
  std::string example = {};
  int (*run)(Call&) = nullptr;
  std::vector<std::string> retired = {};  // named arguments of earlier releases: a warning, and no effect
  // Set by install():
  Style style = Style::positional;
  Touches touches = Touches::nothing;
  bool weighs = false;  // makes an object of the core that may take much memory

  // Of the module fabric.kernels, which the Lua library uses: neither in help nor in the reference.
  bool is_private() const { return name.starts_with("kernels."); }

  bool method() const { return name.find(':') != std::string::npos; }
  // The class of a method or property; empty for a function.
  std::string owner() const {
    if (style != Style::property && !method()) return {};
    return name.substr(0, name.find_first_of(":."));
  }
};

// The entry of a property, mesh.nodes, or of a method that takes nothing, model:list.
inline Entry without_arguments(const std::string& name, std::string sentence, std::string example,
                               int (*run)(Call&)) {
  return {name, {}, std::move(sentence), std::move(example), run};
}

// The entry of a function that only the Lua library calls, in the module fabric.kernels.
inline Entry kernel(const std::string& name, std::vector<Argument> arguments, int (*run)(Call&)) {
  return {"kernels." + name, std::move(arguments), {}, {}, run};
}

class Registry {
 public:
  const Entry& add(Entry entry) {
    constexpr const char* library = "require 'fabric'";
    if (!entry.example.empty() && entry.example.find(library) == std::string::npos)
      entry.example = std::string("local fabric = ") + library + "\n" + entry.example;
    return (entry.is_private() ? kernels_ : entries_).emplace_back(std::move(entry));
  }
  const std::deque<Entry>& entries() const { return entries_; }
  const Entry* find(std::string_view name) const {
    for (const Entry& entry : entries_)
      if (entry.name == name) return &entry;
    return nullptr;
  }

 private:
  std::deque<Entry> entries_, kernels_;  // deques, because closures hold the addresses of rows
};

// "a positive number in m", "one of 'static', 'dynamic'".
std::string expected(const Argument& argument);

}  // namespace fabricsh::script
