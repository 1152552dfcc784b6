-- Runs a deck as a user does, and looks at what it shows and says on the way:
--   no warning, and no word of the solver that results are not valid, but those that the deck announces, a line "-- warns: words of it" each, and each of those is said;
--   no file named that is not there;
--   every figure asked for is drawn, and an SVG is one that viewers open, with all its curves and the labels asked for.
--
--   fabricsh run.lua <fabricsh> <root of the tree> <deck.lua>      in a folder of the test's own, whose out/ is made anew
local program, root, deck = arg[1], arg[2], arg[3]
local here = arg[0]:gsub("[^/]*$", "")
local svg = dofile(here .. "svg.lua")
local endings = { csv = true, html = true, json = true, lua = true, pdf = true, png = true, pvd = true, svg = true, vtu = true }
-- Warnings that the machine answers for, and the program that would have to be there.
local machine = { ["plot: no figure"] = "gnuplot", ["no display to draw on"] = "Xvfb" }

local function quoted(word) return "'" .. word:gsub("'", "'\\''") .. "'" end

local function content(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read "a"
  file:close()
  return text
end

local function there(path)
  local file = io.open(path, "rb")
  if file then file:close() end
  return file ~= nil
end

local lacking = {}
local function lacks(name)
  if lacking[name] == nil then lacking[name] = not os.execute("command -v " .. name .. " >/dev/null 2>&1") end
  return lacking[name]
end

local faults = {}
local function fault(...) faults[#faults + 1] = string.format(...) end

-- The warning is one of those announced (which are marked), or one of a machine that lacks a program.
local function awaited(line, announced)
  for words, name in pairs(machine) do
    if line:find(words, 1, true) and lacks(name) then return true end
  end
  local found = false
  for _, one in ipairs(announced) do
    if line:find(one.words, 1, true) then one.said, found = true, true end
  end
  return found
end

-- A page whose preformatted lines and figures do not give way is as wide as the longest of them.
local function check_page(path)
  local page = content(path)
  if page:find "<pre" and not page:find "pre{[^}]*white%-space:pre%-wrap" then fault("'%s': lines of <pre> make it wider than a screen", path) end
  if page:find "<svg" and not page:find "svg{[^}]*max%-width:100%%" then fault("'%s': figures make it wider than a small screen", path) end
end

local function check_paths(line)
  for path in line:gmatch "[%w_%-./]+" do
    local ending = path:match "^.*/.*%.(%w+)$"
    if ending and endings[ending] and not there(path) and not there(root .. "/" .. path) then
      fault("it names '%s', which is not there: %s", path, line)
    elseif ending == "html" and there(path) then
      check_page(path)
    end
  end
end

local function check_said(text, announced)
  for line in text:gmatch "[^\r\n]+" do
    if not line:find("warning:", 1, true) and not line:find("are not valid", 1, true) then
      check_paths(line)
    elseif not awaited(line, announced) then
      fault("a warning that the deck does not announce: %s", line)
    end
  end
  if text:find("SKIPPED:", 1, true) then return end
  for _, one in ipairs(announced) do
    if not one.said then fault("announced and not said: '%s'", one.words) end
  end
end

local function check_figure(asked)
  if not there(asked.file) then
    if not lacks "gnuplot" then fault("figure '%s' was asked for and is not there", asked.file) end
  elseif asked.file:find "%.svg$" then
    local good, texts, curves = pcall(svg.read, content(asked.file))
    if not good then return fault("figure '%s' is no SVG: %s", asked.file, texts) end
    local word = svg.missing(texts, asked.words)
    if word then fault("figure '%s' lacks the label '%s'; it holds: %s", asked.file, word, table.concat(texts, " | ")) end
    if curves < asked.curves then fault("figure '%s' has %d curves of %d", asked.file, curves, asked.curves) end
  end
end

local announced = {}
for words in content(deck):gmatch "%f[^\n\0]%-%- warns: ([^\n]+)" do announced[#announced + 1] = { words = words } end
os.execute "rm -rf out figures.lua"
local ended, how, code = os.execute(("FABRICSH_TEST_FIGURES=figures.lua LUA_PATH=%s %s -l watch %s >stdout 2>stderr"):format(
  quoted(here .. "?.lua;;"), quoted(program), quoted(deck)))
local out, err = content "stdout", content "stderr"
io.write(out, err)
if not ended then fault("it ended with %s %d", how, code) end
check_said(out .. err, announced)
if there "figures.lua" then
  local last = {} -- a figure drawn twice is the one drawn last
  load(content "figures.lua", "figures.lua", "t", { figure = function(asked) last[asked.file] = asked end })()
  for _, asked in pairs(last) do check_figure(asked) end
end
if #faults > 0 then error(deck .. "\n  " .. table.concat(faults, "\n  "), 0) end
