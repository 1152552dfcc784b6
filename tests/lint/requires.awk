# Reads lua/LAYERS, then every module of lua/fabric, all given relative to the root of the tree. Prints one line per
# fault and exits 1 if there is any.
#   - a room of LAYERS needs only rooms that stand above it, and requires something of each room that it needs
#   - a module requires only modules of its own room and of the rooms that LAYERS names for it

function fault(place, text) {
  print place ": " text
  faults++
}

# The room of a module: itself where it stands apart or is the whole of a folder, else its folder.
function room_of(module,    folder) {
  sub(/\/init$/, "", module)
  if (module in rank) return module
  folder = module
  if (!sub(/\/[^\/]*$/, "", folder)) folder = "."
  return folder
}

FNR == 1 && FILENAME != "lua/LAYERS" {
  own = FILENAME
  sub(/^lua\/fabric\//, "", own)
  sub(/\.lua$/, "", own)
  own = room_of(own)
  if (!(own in rank)) fault(FILENAME, "room '" own "' is not in lua/LAYERS")
}

FILENAME == "lua/LAYERS" {
  if ($0 ~ /^#/ || $0 ~ /^[ \t]*$/) next
  if ($0 !~ /^[a-z_\/.]+:/) {
    fault(FILENAME ":" FNR, "expected 'room: rooms it needs', got '" $0 "'")
    next
  }
  name = $1
  sub(/:$/, "", name)
  if (name in rank) fault(FILENAME ":" FNR, "room '" name "' stands there twice")
  for (i = 2; i <= NF; i++) {
    if (!($i in rank)) fault(FILENAME ":" FNR, "room '" name "' needs '" $i "', which does not stand above it")
    allowed[name, $i] = FNR
  }
  rank[name] = FNR
  next
}

{
  rest = $0
  while (match(rest, /(require|later) *\(?"fabric\.[a-z_.]+"/)) {
    module = substr(rest, RSTART, RLENGTH - 1)
    rest = substr(rest, RSTART + RLENGTH)
    sub(/^[^"]*"fabric\./, "", module)
    gsub(/\./, "/", module)
    if (module == "define" || module == "kernels") continue
    other = room_of(module)
    if (!(other in rank)) fault(FILENAME ":" FNR, "requires '" module "', which is in no room of lua/LAYERS")
    else if (other != own && !((own, other) in allowed))
      fault(FILENAME ":" FNR, "room '" own "' requires '" module "', and lua/LAYERS does not name '" other "' for it")
    required[own, other] = 1
  }
}

END {
  for (pair in allowed)
    if (!(pair in required)) {
      split(pair, parts, SUBSEP)
      fault("lua/LAYERS:" allowed[pair], "room '" parts[1] "' requires nothing of room '" parts[2] "'")
    }
  exit faults > 0
}
