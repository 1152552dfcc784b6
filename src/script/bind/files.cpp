// Files that a deck writes itself: card:write, fabric.write.
#include "card/fields.hpp"
#include "script/bind/rooms.hpp"
#include "system/atomic.hpp"

namespace fabricsh::script {

namespace {

int write_card(Call& call) {
  if (!call.session().options().check) {
    system::make_folder_for(call.text("path"));
    system::write_file(call.text("path"), card::lua_text(*call.self<card::Card>()));
  }
  return 0;
}

int write_text(Call& call) {
  if (!call.session().options().check) system::write_file(call.text("path"), call.text("content"));
  return 0;
}

std::vector<Entry> files_entries() {
  return {
      {"fabric.write()",
       {value_("path", text, "of the file"), value_("content", text, "all of it")},
       "Writes a file as a whole and makes its folders: a reader sees the old file or the new one, never a "
       "part.",
       "local path = os.tmpname()\nrequire 'fabric'.write(path, 'a,b\\n1,2\\n')\n"
       "assert(io.open(path):read 'a' == 'a,b\\n1,2\\n')\nos.remove(path)",
       write_text},
      {"card:write()",
       {value_("path", text, "of the Lua file")},
       "Writes the card as a Lua file that reads back equal; the old file stays until the new one is whole.",
       "local path = os.tmpname()..'.lua'\nlocal card = fabric.card 'duck'\n"
       "card:write(path)\nassert(fabric.card(path) == card)\nos.remove(path)",
       write_card},
  };
}

}  // namespace

void bind_files(Session& session) { install(session, files_entries()); }

}  // namespace fabricsh::script
