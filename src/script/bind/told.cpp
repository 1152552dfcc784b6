// The calls of a model that follow from the structs of model/declarations.hpp: arguments, and what a call
// declares, from the members that a struct tells. loads.cpp and others have those that ask for more.
#include <algorithm>

#include "script/bind/model.hpp"
#include "script/bind/rooms.hpp"
#include "script/call/words.hpp"

namespace fabricsh::script {

namespace {

using model::NumberRow;

// The arguments, in the order of the members. One that may be left out has a member with a default.
class ToldArguments : public model::DeclarationVisitor {
 public:
  explicit ToldArguments(bool of_body) : of_body_(of_body) {}
  std::vector<Argument> all;
  void set(const std::string& name, const char* sentence = "name of a node set") {
    if (of_body_) return all.push_back(set_or_body_row());
    const Argument row = value_("set", script::text, sentence);
    all.push_back(name.empty() ? row : row.or_else(name));
  }
  void components(const model::Components&, const char* unit, const char* sentence) {
    all.push_back(components_row(unit, sentence));
  }
  void history(const char* name, const model::History&, const char* unit, const char*, const char* sentence) {
    all.push_back(history_(name, unit, sentence));
    all.back().required = true;
  }
  void number(const char* name, double value, const char*, double, const NumberRow& row) {
    const Argument made = number_(name, row.unit, row.range, row.sentence);
    all.push_back(row.range.holds(value) ? made.or_else(value) : made);
  }
  void time(const char* name, const std::optional<double>&, const char*, const char*, const NumberRow& row) {
    all.push_back(number_(name, row.unit, row.range, row.sentence).optional());
  }
  void vector(const char* name, const auto& value, const char*, const NumberRow& row) {
    all.push_back(value_(name, numbers, row.sentence, row.unit));
    all.back().required = std::is_same_v<decltype(value), const Vec3&>;
  }
  void frame(const Mat3&) { all.push_back(frame_row()); }

 private:
  bool of_body_;
};

// Sets the members from a call.
class ToldReader : public model::DeclarationVisitor {
 public:
  explicit ToldReader(Call& call) : call_(call), field_(call.entry().style == Style::fields) {}
  void set(std::string& name, auto...) { name = call_.text("set"); }
  void components(model::Components& value, auto...) { value = read_components(call_); }
  void history(const char* name, model::History& value, auto...) {
    call_.push(name);
    value = read_history(call_.session(), call_.L(), -1,
                         last_word(call_.entry().name) + " '" + call_.text("set") +
                             "': " + (field_ ? "field '" : "argument '") + name + "'");
    lua_pop(call_.L(), 1);
  }
  void number(const char* name, auto& value, auto&&...) {
    if (call_.has(name)) value = call_.number(name);
  }
  void time(const char* name, std::optional<double>& value, auto&&...) { number(name, value); }
  void vector(const char* name, auto& value, auto&&...) {
    if (call_.has(name)) value = read_vector(call_.numbers(name), std::string("field '") + name + "'");
  }
  void frame(Mat3& value) { value = read_frame(call_); }

 private:
  Call& call_;
  bool field_;
};

template <class D>
constexpr bool of_body = requires {
  D::of_body;
};

template <class D>
int declare_told(Call& call) {
  ToldReader reader(call);
  if constexpr (of_body<D>)
    if (auto body = call.object<const model::Rigid>("set")) {
      if (call.has("options"))
        call.refuse("options", "a rigid body is loaded along global axes: expected nothing");
      auto load = D::of_body(std::move(body));
      load.tell(load, reader);
      return declare(call, std::move(load));
    }
  D made;
  D::tell(made, reader);
  return declare(call, std::move(made));
}

template <class D>
Entry told_entry() {
  ToldArguments told(of_body<D>);
  const D initial;
  D::tell(initial, told);
  const auto required = [](const Argument& row) { return row.required; };
  std::stable_partition(told.all.begin(), told.all.end(), required);
  return {std::string("model:") + D::call() + (requires { D::by_name; } ? "{}" : "()"), told.all, D::sentence,
          sample_model() + D::example, declare_told<D>};
}

}  // namespace

void bind_told(Session& session) {
  std::vector<Entry> entries;
  model::Declarations().each_kind([&entries]<class D>(const std::vector<D>&) {
    if constexpr (requires { D::sentence; }) entries.push_back(told_entry<D>());
  });
  install(session, std::move(entries));
}

}  // namespace fabricsh::script
