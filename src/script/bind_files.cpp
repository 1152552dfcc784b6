// What a deck writes by itself: card:write.
#include "files/atomic.hpp"
#include "script/bind.hpp"

namespace fabricsh::script {

namespace {

int write_card(Call& call) {
  if (!call.session().options().check) {
    files::make_folder_for(call.text("path"));
    files::write_file(call.text("path"), card_text(*call.self<card::Card>()));
  }
  return 0;
}

std::vector<Entry> rows() {
  return {
      {"card:write",
       Style::positional,
       {value_("path", text, "of the Lua file")},
       "Writes the card as a Lua file that reads back equal; the old file stays until the new one is whole.",
       "local fabric = require 'fabric'\nlocal path = os.tmpname()..'.lua'\nlocal card = fabric.card 'duck'\n"
       "card:write(path)\nassert(fabric.card(path) == card)\nos.remove(path)",
       write_card},
  };
}

}  // namespace

void bind_files(Session& session) { install(session, rows()); }

}  // namespace fabricsh::script
