-- One page of the documents: its blocks run in order, in the folder where this is started, which gets links to the tree.
--
--   fabricsh tests/doc/page.lua <root of the tree> <page.md> [form]     form: runs nothing, looks at links and at what blocks are
--
--   ```lua [name.lua]     saved (as name.lua) and run as a deck
--   ```sh                 run by a shell that finds fabricsh
--   ```sh elsewhere=TEST  only said here: the test of that name does the same
--   ```lua elsewhere=TEST
--   ```fabricsh           a session at the prompt: lines after "> " are typed, the others are what it shows
--   ```python             run by Debian's Python with share/python at hand; left out, and said so, where numpy is missing
--   ```text               what the block before printed, compared; a line "..." stands for any lines
--   ```cpp file=PATH      (and cmake) shown here: the text of that file of the tree, which other tests build and run
-- Anything else that looks like code (indented, or another word behind the fence) is refused, so that no block goes unrun.
local root, page = arg[1], arg[2]
local program = arg[-1]

local function quoted(text) return "'" .. text:gsub("'", "'\\''") .. "'" end

local function write(path, text)
  local file <close> = assert(io.open(path, "w"))
  file:write(text)
end

local function run(command, what)
  local path = os.tmpname()
  local ok, _, code = os.execute(("( %s ) >%s 2>err.txt"):format(command, path))
  local file = assert(io.open(path))
  local out = file:read "a"
  file:close()
  os.remove(path)
  if not ok then
    local err = io.open("err.txt"):read "a"
    error(("%s ended with %s:\n%s%s"):format(what, code, out, err), 0)
  end
  return out
end

local function lines_of(text)
  local lines = {}
  for line in (text:gsub("\n*$", "") .. "\n"):gmatch "(.-)\n" do lines[#lines + 1] = (line:gsub("%s+$", "")) end
  return lines
end

-- Does `got` say what `want` says, "..." standing for any lines?
local function same(got, want, i, j)
  i, j = i or 1, j or 1
  if j > #want then return i > #got end
  if want[j] == "..." then
    for k = i, #got + 1 do
      if same(got, want, k, j + 1) then return true end
    end
    return false
  end
  return got[i] == want[j] and same(got, want, i + 1, j + 1)
end

local function compare(got, want, what)
  if not same(lines_of(got), lines_of(want)) then
    error(("%s\n--- printed:\n%s--- the page says:\n%s"):format(what, got, want), 0)
  end
end

-- A session: the prompt is told apart by a mark after every input.
local function session(text, what)
  local inputs, outputs = {}, {}
  for line in text:gmatch "(.-)\n" do
    local input, more = line:match "^> (.*)$", line:match "^>> (.*)$"
    if input then
      inputs[#inputs + 1], outputs[#outputs + 1] = input, ""
    elseif more then
      inputs[#inputs] = inputs[#inputs] .. "\n" .. more
    else
      outputs[#outputs] = outputs[#outputs] .. line .. "\n"
    end
  end
  local typed = {}
  for _, input in ipairs(inputs) do typed[#typed + 1] = input .. "\ndo io.stdout:write('\\1') end\n" end
  write("session.txt", table.concat(typed))
  local said = run("fabricsh --quiet <session.txt 2>&1 || true", what) -- a slip makes it end with 1
  local place = 1
  for i, input in ipairs(inputs) do
    local stop = said:find("\1", place, true) or error(what .. ": the session ended before: " .. input .. "\n" .. said, 0)
    compare(said:sub(place, stop - 1), outputs[i], what .. ", typed: " .. input)
    place = stop + 1
  end
end

local last, left_out, count = nil, false, 0
local python = "PYTHONDONTWRITEBYTECODE=1 FABRICSH=$PWD/fabricsh PYTHONPATH=share/python $( [ -x /usr/bin/python3 ] && echo /usr/bin/python3 || echo python3 ) "
local run_block = {
  lua = function(name, text, what)
    name = name ~= "" and name or ("block-%d.lua"):format(count)
    write(name, text)
    last = run("fabricsh --quiet " .. quoted(name), what)
  end,
  sh = function(_, text, what)
    write("block.sh", "set -e\n" .. text)
    last = run("sh block.sh", what)
  end,
  fabricsh = function(_, text, what) session(text, what) end,
  python = function(_, text, what)
    left_out = not os.execute(python .. "-c 'import numpy' >/dev/null 2>&1")
    if left_out then
      print(("SKIPPED: %s: no python3 with numpy"):format(what))
      return
    end
    write("block.py", text)
    last = run(python .. "block.py", what)
  end,
  text = function(_, text, what)
    if left_out then return end
    if not last then error(what .. ": no block before it has printed anything", 0) end
    compare(last, text, what)
  end,
}

local function blocks_of(text)
  local blocks, number, block, before = {}, 0, nil, ""
  for line in text:gmatch "(.-)\n" do
    number = number + 1
    local fence = line:match "^```(.*)$"
    if fence and not block then
      local kind, rest = fence:match "^(%w*)%s*(.*)$"
      block = { kind = kind, rest = rest, line = number, text = {} }
    elseif fence then
      block.text = table.concat(block.text, "\n") .. "\n"
      blocks[#blocks + 1], block = block, nil
    elseif block then
      block.text[#block.text + 1] = line
    elseif line:find "^    %S" and before == "" then
      error(("%s:%d: indented code; put it between ``` so that it is run"):format(page, number), 0)
    end
    before = line:match "^%s*$" and "" or line
  end
  assert(not block, page .. ": a block is not closed")
  return blocks
end

-- A test of the name stands in tests/CMakeLists.txt, or is made there from a file of that name.
local function has_test(name)
  local listing = io.open(root .. "/tests/CMakeLists.txt"):read "a" .. io.open(root .. "/tests/lint/CMakeLists.txt"):read "a"
  if listing:find(name, 1, true) then return true end
  local kind, path = name:match "^(%w+)/(.+)$"
  local file = root .. (kind == "deck" and "/scripts/" or "/tests/" .. (kind or "") .. "/") .. (path or "")
  return (io.open(file .. ".lua") or io.open(file .. ".py")) ~= nil
end

-- The blocks find the program and start in an empty folder: this deck again, under another PATH.
local form = arg[3] == "form"
if not form and arg[3] ~= "again" then
  local folder = program:match "^(.*)/[^/]*$" or "."
  local ok = os.execute(("rm -rf page && mkdir page && cd page && PATH=\"$PWD:%s:$PATH\" '%s' '%s' '%s' '%s' again"):format(
    folder, program, arg[0], root, page))
  os.exit(ok and 0 or 1)
end
if not form then
  write("fabricsh", ("#!/bin/sh\nexec '%s' \"$@\"\n"):format(program))
  os.execute "chmod +x fabricsh"
  for _, name in ipairs { "share", "scripts", "meshes", "lua", "src" } do os.execute(("ln -s '%s/%s' %s"):format(root, name, name)) end
end

local file = assert(io.open(page))
local text = file:read "a"
file:close()
for link in text:gsub("```.-```", ""):gmatch "%]%(([^)#]+)[^)]*%)" do
  local target = page:gsub("[^/]*$", "") .. link
  if not link:find "^https?:" and not os.rename(target, target) then error(("%s: the link '%s' leads nowhere"):format(page, link), 0) end
end
local blocks = blocks_of(text)
for _, block in ipairs(blocks) do
  count = count + 1
  local what = ("%s:%d"):format(page, block.line)
  local elsewhere = block.rest:match "^elsewhere=(%S+)$"
  local source = block.rest:match "^file=(%S+)$"
  if source then
    compare(io.open(root .. "/" .. source):read "a", block.text, what .. ", of " .. source)
  elseif elsewhere then
    if not has_test(elsewhere) then error(("%s: no test '%s'"):format(what, elsewhere), 0) end
  else
    if block.kind ~= "text" then left_out = false end
    local act = run_block[block.kind] or error(("%s: a block of '%s' cannot be run"):format(what, block.kind), 0)
    if not form then
      act(block.rest, block.text, what)
    elseif block.kind == "lua" then
      assert(load(block.text, "=" .. what))
    end
  end
end
print(("%s: %d blocks"):format(page, count))
