# Reads src/LAYERS, then every source of src/, all given relative to the root of the tree. Prints one line per
# fault and exits 1 if there is any.
#   - a room of LAYERS needs only rooms that stand above it, and includes something of each room that it needs
#   - a file includes only its own room and the rooms that LAYERS names for it; never itself in a circle
#   - where LAYERS names the folders of a room, a file is in one of them and includes none of a later one
#   - a third-party library is included only in its rooms
#   - only app and repl print; only app ends the program
#   - what a deck can name is opened and asked for in system/gate.cpp and what uses its places, nowhere else
#   - no file is longer than 800 lines

function fault(place, text) {
  print place ": " text
  faults++
}

function owner(pattern, rooms) {
  patterns[++owners] = pattern
  owner_rooms[owners] = " " rooms " "
}

BEGIN {
  owner("^(suitesparse/)?(umfpack|cholmod|amd|colamd|klu|SuiteSparse)[A-Za-z_]*\\.h$", "linear")
  owner("^(openblas/)?(cblas|lapacke|openblas_config)[A-Za-z_0-9]*\\.h$", "linear")
  owner("^zlib\\.h$", "format")
  owner("^vtk[A-Za-z0-9]*\\.h$", "format render")
  owner("^(png|jpeglib|jerror|tiffio)\\.h$", "photograph")
  owner("^(lua5\\.4/)?(lua|lauxlib|lualib|luaconf)\\.(h|hpp)$", "script repl")
  owner("^(histedit\\.h|editline/.*)$", "repl")
}

function close_file() {
  if (file != "" && lines > 800) fault(file, "is " lines " lines long, 800 is the most")
}

FNR == 1 {
  close_file()
  file = FILENAME
  lines = 0
  split(file, parts, "/")
  room = parts[2]
  if (file != "src/LAYERS" && !(room in rank)) fault(file, "room '" room "' is not in src/LAYERS")
}

{ lines = FNR }

file == "src/LAYERS" {
  if ($0 ~ /^[a-z]+:/) read_layer()
  else if ($0 ~ /^[a-z]+\/:/) read_folders()
  else if ($0 !~ /^#/ && $0 !~ /^[ \t]*$/) fault(file ":" FNR, "expected 'room: rooms it needs', got '" $0 "'")
  next
}

function read_layer(    name, need, n, i) {
  name = $0
  sub(/:.*/, "", name)
  n = split(substr($0, length(name) + 2), needed, " ")
  for (i = 1; i <= n; i++) {
    need = needed[i]
    if (!(need in rank)) fault(file ":" FNR, "room '" name "' needs '" need "', which does not stand above it")
    allowed[name, need] = FNR
  }
  if (name in rank) fault(file ":" FNR, "room '" name "' stands there twice")
  rank[name] = ++ranks
}

function read_folders(    name, n, i) {
  name = $0
  sub(/\/:.*/, "", name)
  n = split(substr($0, index($0, ":") + 1), needed, " ")
  for (i = 1; i <= n; i++) folder_rank[name, needed[i]] = i
  has_folders[name] = 1
}

/^[ \t]*#[ \t]*include[ \t]*"/ {
  match($0, /"[^"]*"/)
  check_own(substr($0, RSTART + 1, RLENGTH - 2))
  next
}

/^[ \t]*#[ \t]*include[ \t]*</ {
  match($0, /<[^>]*>/)
  check_library(substr($0, RSTART + 1, RLENGTH - 2))
  next
}

room != "app" && room != "repl" && prints($0) { fault(file ":" FNR, "room '" room "' prints; only app and repl do") }

asks_for_file($0) { fault(file ":" FNR, "asks for a file past the gate of room system (system/gate.hpp)") }

opens_file($0) { fault(file ":" FNR, "opens or moves a file past the gate of room system (system/gate.hpp)") }

room != "app" && code($0) ~ /(^|[^A-Za-z_.>])(std::)?(_?exit|quick_exit|abort)[ ]*\(/ {
  fault(file ":" FNR, "room '" room "' ends the program; only app does")
}

# The line without its strings and without what a // starts.
function code(line) {
  gsub(/"([^"\\]|\\.)*"/, "\"\"", line)
  sub(/\/\/.*/, "", line)
  return line
}

function prints(line) {
  line = code(line)
  return line ~ /std::(cout|cerr|clog)/ || line ~ /(^|[^A-Za-z_])(printf|puts|putchar|perror)[ ]*\(/ ||
         line ~ /(^|[^A-Za-z_])(stdout|stderr)([^A-Za-z_]|$)/
}

function check_own(header,    bits, n, other) {
  n = split(header, bits, "/")
  if (n == 1) {
    if (header == "fabricsh_config.hpp" && (room == "base" || room == "system")) return
    fault(file ":" FNR, "includes '" header "' without its room")
    return
  }
  other = bits[1]
  if (!(other in rank)) fault(file ":" FNR, "includes '" header "', and '" other "' is no room of src/LAYERS")
  else if (other != room && rank[other] > rank[room])
    fault(file ":" FNR, "room '" room "' includes '" header "' of a room below it in src/LAYERS")
  else if (other != room && !((room, other) in allowed))
    fault(file ":" FNR, "room '" room "' includes '" header "', and src/LAYERS does not name '" other "' for it")
  if (other == room && (room in has_folders)) check_folder(parts[3], bits[2], header)
  included[room, other] = 1
  edges[file] = edges[file] " src/" header
}

function check_folder(own, folder, header) {
  if (!((room, own) in folder_rank)) fault(file ":" FNR, "'" own "' is no folder of room '" room "' in src/LAYERS")
  else if (!((room, folder) in folder_rank) || folder_rank[room, folder] > folder_rank[room, own])
    fault(file ":" FNR, "folder '" own "' of room '" room "' includes '" header "' of a later folder in src/LAYERS")
}

function check_library(header,    i) {
  for (i = 1; i <= owners; i++)
    if (header ~ patterns[i] && index(owner_rooms[i], " " room " ") == 0)
      fault(file ":" FNR, "room '" room "' includes <" header ">, which belongs to:" owner_rooms[i])
}

# render is a program of its own; base, repl and app know only paths that the user or the program gives.
function behind_gate() {
  return !(room == "render" || room == "base" || room == "app" || room == "repl" || file ~ /^src\/system\/(gate|paths|computing_time)\.[ch]pp$/)
}

# Whether a file is there is told by Gate::exists; these two ask where the gate is open.
function asks_for_file(line) {
  if (!behind_gate() || file ~ /^src\/(system\/atomic|format\/csv)\.cpp$/) return 0
  line = code(line)
  return line ~ /(fs|filesystem)::(exists|is_[a-z_]+|status|symlink_status|file_size|last_write_time|canonical|weakly_canonical|equivalent|read_symlink|space)\(/ ||
    line ~ /(^|[^A-Za-z_.>])(stat|lstat|access|readlink|realpath)\(/
}

function opens_file(line) {
  if (!behind_gate()) return 0
  line = code(line)
  if (line ~ /luaL_loadfilex\(L, nullptr/) return 0  # standard input
  return line ~ /(^|[^A-Za-z_.])(fopen|freopen|ifstream|ofstream|fstream|luaL_loadfilex?|luaL_dofile|directory_iterator|opendir|remove_all|tmpfile)([^A-Za-z_]|$)/ ||
    line ~ /(^|[^:A-Za-z_])::(open|rename|unlink|creat|mkdir)\(/ || line ~ /(^|[^A-Za-z_.>:])(rename|unlink|mkdir)\(/ || line ~ /fs::(rename|remove)\(|filesystem::(rename|remove)\(/
}

# Depth first; a file met again on the way down closes a circle.
function visit(name, trail,    headers, n, i) {
  if (!(name in edges)) return
  if (state[name] == "done") return
  if (state[name] == "open") {
    fault(name, "includes itself in a circle:" trail " " name)
    return
  }
  state[name] = "open"
  n = split(edges[name], headers, " ")
  for (i = 1; i <= n; i++) visit(headers[i], trail " " name)
  state[name] = "done"
}

END {
  close_file()
  if (ranks == 0) fault("src/LAYERS", "names no room")
  for (pair in allowed)
    if (!(pair in included)) {
      split(pair, parts, SUBSEP)
      fault("src/LAYERS:" allowed[pair], "room '" parts[1] "' includes nothing of room '" parts[2] "'")
    }
  for (name in edges) visit(name, "")
  exit faults > 0
}
