// fabric.model's ties between nodes.
#include <algorithm>

#include "model/model.hpp"
#include "model/rigid.hpp"
#include "script/bind/model.hpp"
#include "script/bind/run.hpp"

namespace fabricsh::script {

using model::TieKind;

namespace {

TieKind read_kind(const Call& call) {
  const std::string kind = call.text("kind");
  const auto& words = model::tie_words;
  const auto at = std::find(words.begin(), words.end(), kind) - words.begin();
  if (at < std::ssize(words)) return static_cast<TieKind>(at);
  call.refuse("kind", "expected \"equal\", \"straight\", \"rigid\" or \"periodic\", got \"" + kind + "\"");
}

// The body is known by its name, as sets are.
int tie_to_body(Call& call, model::Tie tie) {
  const auto body = call.object<const model::Rigid>("second");
  if (tie.kind != TieKind::rigid)
    call.refuse("second", "expected a text: a body is tied to by kind 'rigid' alone");
  if (body->name().empty())
    call.refuse("second", "expected a body with a name, as fabric.rigid.disc{ name='plate', ... }");
  tie.partner = body->name();
  return declare(call, std::move(tie));
}

int tie(Call& call) {
  model::Tie tie{read_kind(call), call.text("set"), {}, {}};
  const bool periodic = tie.kind == TieKind::periodic;
  if (periodic) {
    if (!call.has("second") || !call.is("second", LUA_TSTRING))
      call.refuse("second", "expected the name of the set that follows, got nil");
    tie.partner = call.text("second");
  }
  const char* const place = periodic ? "freedoms" : "second";
  if (tie.kind == TieKind::equal && !call.has(place)) call.refuse(place, "expected some of x y z, got nil");
  if (call.has("second") && !call.is("second", LUA_TSTRING)) return tie_to_body(call, std::move(tie));
  const std::string words = call.has(place) ? call.text(place) : periodic ? "x y z rotation" : "x y z";
  if (tie.kind != TieKind::rigid)
    tie.freedoms = model::parse_freedoms(words, "tie");
  else if (call.has("second"))
    call.refuse("second", "a rigid set ties every freedom: expected nothing, got \"" + words + "\"");
  if (!periodic && call.has("freedoms"))
    call.refuse("freedoms", "only a periodic tie has a second set: name the freedoms in its place");
  return declare(call, std::move(tie));
}

std::vector<Entry> ties_entries() {
  return {
      {"model:tie()",
       {value_("kind", text,
               "\"equal\": the set's nodes share displacements; \"straight\": they stay on the line between "
               "its ends; \"rigid\": nodes and directors move as one body; \"periodic\": two sets whose "
               "pairs of nodes keep one common relative displacement; the second follows the first"),
        value_("set", text, "name of a node set"),
        object_("second?", "body",
                "periodic: the set that follows; rigid: nothing, or a rigid body with a name, along with "
                "which the nodes go; else freedoms, some of x y z",
                text),
        value_("freedoms?", text, "periodic: some of x y z rotation; default all")},
       "Ties nodes to each other exactly, by elimination. To a rigid body they are tied by springs that are "
       "stiff beside the cloth, and turn freely there.",
       "local mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=2, ny=3 }\n"
       "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 }\n"
       "m:tie('straight', 'top', 'y')\n"
       "m:tie('rigid', 'bottom')",
       tie},
  };
}

}  // namespace

void bind_ties(Session& session) { install(session, ties_entries()); }

}  // namespace fabricsh::script
