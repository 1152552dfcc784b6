#!/bin/sh
# Attempts to get out of --safe. Usage: run.sh <fabricsh> <folder with attempts.lua> [sanitized]
# With FABRICSH_TEST_LONG set more ways to spend computing time, each of which takes a second of it.
set -u
program=$1 here=$2
root=$(mktemp -d) || exit 1
trap 'rm -rf "$root"' EXIT
cd "$root" || exit 1
status=0

mkdir -p deck/folder out secret
cp "$here/attempts.lua" "$here/race.lua" deck/
echo 'a,b' >secret/key.csv && echo 1,2 >>secret/key.csv
cp secret/key.csv secret/key.msh && cp secret/key.csv secret/key.png && echo 'return 1' >secret/module.lua
printf '\033Lua\124\000' >deck/chunk.luac
ln -s ../secret deck/way && ln -s ../secret/key.csv deck/link.csv && ln -s ../secret/key.msh deck/link.msh
ln -s ../secret out/way && ln -s ../secret/key.csv out/link.csv && ln -s ../secret/key.csv out/link.vtu
ln secret/key.csv out/hard.csv && mkfifo deck/pipe out/pipe
secret_sum() { cat secret/* | cksum && ls secret; }
before=$(secret_sum)

# expect <exit code> <words> <arguments...>
expect() {
  code=$1 words=$2
  shift 2
  said=$(SECRET_KEY=1 SLURM_ARRAY_TASK_ID=7 timeout 120 $program --quiet --safe "$@" 2>&1 </dev/null)
  got=$?
  case $said in *"$words"*) [ $got -eq "$code" ] && return ;; esac
  echo "FAILED: $*: expected code $code and '$words', got $got:" && echo "$said" | tail -n 5
  status=1
}

expect 0 'all refused' "$root/deck/attempts.lua"

# Endings by a limit that cannot be caught, in whatever coroutine, handler or closing variable.
limit='limit of 1000000 instructions'
few='--limit-instructions 1e6'
for chunk in 'while true do end' 'while true do pcall(function() while true do end end) end' \
  'while true do pcall(pcall, error) end' 'repeat until false' 'local function f() return f() end f()' \
  'while true do coroutine.wrap(function() while true do end end)() end' \
  'while true do coroutine.wrap(function() end)() end' \
  'while true do local c = coroutine.create(function() while true do end end) coroutine.resume(c) end' \
  'local function deep(n) return coroutine.wrap(function() if n > 0 then return deep(n - 1) end while true do end end)() end while true do pcall(deep, 50) end' \
  'xpcall(function() while true do end end, function() while true do end end)' \
  'do local x <close> = setmetatable({}, {__close=function() while true do end end}) while true do end end' \
  'error(setmetatable({}, {__tostring=function() while true do end end}))' \
  '("x"):rep(1e5):gsub(".", function() for i = 1, 1e5 do end end)' \
  'table.sort({3,1,2}, function() while true do end end)' \
  'load(function() while true do end end)' \
  'fabric.mesh.rectangle{ width=1, height=1, nx=2, ny=2 }:set("s", function() while true do end end)'; do
  # shellcheck disable=SC2086  # an option and its value
  expect 1 "$limit" $few -e "$chunk"
done

memory='memory limit of 100 MB'
for chunk in 'x = ("x"):rep(1e9)' 'x = ("x"):rep(1e4, ("y"):rep(1e5))' 'x = {} for i = 1, 1e9 do x[i] = {} end' \
  'x = "x" while true do x = x .. x end' 'x = table.concat({("x"):rep(6e7), ("y"):rep(6e7)})' \
  'x = {} while true do x[#x + 1] = coroutine.create(function() end) end' \
  'x = ("x"):rep(4e7):gsub("x", "yyyy")' 'collectgarbage "stop" x = {} for i = 1, 1e9 do x[i] = ("x"):rep(1e6) .. i end'; do
  expect 1 "$memory" --limit-memory 100 -e "$chunk"
done
# The address sanitizer has the process' memory for itself: it sets no limit, and ends the program where there is none.
[ "${3:-}" = sanitized ] ||
  expect 1 'memory limit of' --limit-memory 4 -e 'fabric.mesh.rectangle{ width=1, height=1, nx=30000, ny=30000 }'

# C that never comes back to Lua: the last resort.
slow() { expect 1 'limit of computing time' --limit-seconds 1 -e "$1"; }
slow 'while true do pcall(string.find, ("a"):rep(3e4), (".-"):rep(12) .. "b") end'
slow 'table.insert(setmetatable({}, {__len=function() return 1 << 60 end}), 1, 1)'
if [ -n "${FABRICSH_TEST_LONG:-}" ]; then
  slow 'print(("a"):rep(3e4):find((".-"):rep(12) .. "b"))'
  slow 'for k in ("a"):rep(3e4):gmatch((".-"):rep(12) .. "b") do end'
  slow 'print((("a"):rep(3e4):gsub((".-"):rep(12) .. "b", "")))'
fi
# Processes have one allowance of time and of instructions together, and none of their own.
endless='fabric.lab.parallel{ count=1, processes=1, isolated=true, work=function() io.stderr:write "begun\n" while true do end end }'
expect 1 'limit of computing time' --limit-seconds 1 --limit-instructions 1e13 -e "for i = 1, 30 do $endless end"
[ "$(echo "$said" | grep -c begun)" -eq 1 ] || { echo "FAILED: more than one of 30 processes had a second" && status=1; }
expect 1 'limit of computing time' --limit-seconds 1 --limit-instructions 1e13 \
  -e 'fabric.lab.parallel{ count=2, processes=2, isolated=true, work=function() while true do end end }'
expect 1 "$limit" --limit-instructions 1e6 -e "$endless for i = 1, 2000 do local x = i end"
expect 0 'one starts no others' -e 'local deep = { count=1, isolated=true, work=function() return { 1 } end }
  local told = fabric.lab.parallel{ count=1, isolated=true, work=function() fabric.lab.parallel(deep) return { 1 } end }[1].trouble
  assert(told:find("a process of fabric.lab.parallel or fabric.study starts no others", 1, true), told)
  print "one starts no others"'
expect 0 'one at a time' --threads 1 -e 'local names = {}
  fabric.lab.parallel{ count=3, processes=64, isolated=true, done=function() names[#names + 1] = #fabric.folder "out/busy" end,
    work=function(i) fabric.write("out/busy/" .. i, "") return { i } end }
  assert(table.concat(names) == "123", table.concat(names))
  print "one at a time"'
expect 1 "invalid conversion specification: '%99999d'" -e 'string.format("%99999d", 1)'

# A folder that becomes a link and a folder again, as fast as it goes, while the deck opens files in it.
mkdir -p deck/swap out/swap && echo mine >deck/swap/key.csv && ln -s ../secret deck/swap-link && ln -s ../secret out/swap-link
"$program" "$here/swap.lua" "$root" >/dev/null 2>&1 &
swapper=$!
expect 0 'never came through' "$root/deck/race.lua"
kill $swapper 2>/dev/null
wait $swapper 2>/dev/null

mkdir home && cp deck/race.lua home/deck.lua
HOME=$root/home expect 1 'all of which it could read' "$root/home/deck.lua"
mkdir -p home/people/me && cp deck/race.lua home/people/deck.lua
HOME=$root/home/people/me expect 1 'all of which it could read' "$root/home/people/deck.lua"
HOME=$root/home/people/me/ expect 1 'all of which it could read' "$root/home/people/../people/deck.lua"
HOME=$root/home/people/me expect 1 'all of which the deck could change' --output "$root/home" -e 'x = 1'
expect 1 'all of which the deck could change' --output / -e 'x = 1'
# Without HOME the system's own record of it counts.
own=$(getent passwd "$(id -u)" | cut -d: -f6)
if [ -d "$own" ]; then
  program="env -u HOME $program"
  expect 1 'all of which the deck could change' --output "$own" -e 'x = 1'
  program=${program#env -u HOME }
fi
HOME=$root/home expect 1 'all of which the deck could change' --output "$root/home" -e 'x = 1'
# The output folder is no link and lies behind none, by default and by --output: whoever packed the folder may
# have laid it.
mkdir -p inbox/plain && ln -s ../secret inbox/out && ln -s ../secret inbox/plain/results && ln -s plain inbox/way
echo 'local fabric = require "fabric" print(pcall(fabric.write, "out/keys", "x")) print(pcall(os.remove, "out/key.csv"))' >inbox/deck.lua
cd inbox || exit 1
link='is a symbolic link, which --safe does not follow'
expect 1 "'out' $link" deck.lua
expect 1 "--output names a folder that is none" deck.lua
for place in out out/ plain/results ./plain/results/ plain/results/below way/made "$root/inbox/out" "$root/inbox/way/made"; do
  expect 1 "$link" --output "$place" deck.lua
done
expect 0 '' --output made/here deck.lua
[ -d made/here ] || { echo 'FAILED: made/here is missing' && status=1; }
# A folder that becomes a link after the start: what is written goes to the folder that was there.
rm out && mkdir out
(while [ ! -e out/begun ]; do sleep 0.05; done && mv out away && ln -s ../secret out && touch away/swapped) &
expect 0 'and went on' -e 'fabric.write("out/begun", "") local until_ = os.time() + 20
  repeat local swapped = pcall(fabric.write, "out/mine.csv", "1") until io.open "out/swapped" or os.time() > until_
  for i = 1, 50 do pcall(fabric.write, "out/key.csv", "no") pcall(os.remove, "out/module.lua") end print "and went on"'
wait
[ -e away/mine.csv ] && [ -e away/swapped ] || { echo 'FAILED: nothing was written before the swap' && status=1; }
cd "$root" || exit 1
expect 2 'a number from 4 to 1e+09' --limit-memory 1e18 -e 'x = 1'
expect 2 "unknown option '--safe=no'" --safe=no
[ "$before" = "$(secret_sum)" ] || { echo "FAILED: the secret folder has changed" && secret_sum && status=1; }
exit $status
