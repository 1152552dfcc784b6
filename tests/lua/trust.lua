-- Warnings of a run reach a batch: in Lua, run.json, the results of virtual tests, the table of a study; and as an exit code.
local fabric = require "fabric"
local define = require "fabric.define"

local function text_of(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read "a"
  file:close()
  return text
end
local function has(text, part) assert(text:find(part, 1, true), text .. "\nis without: " .. part) end
local folder = os.tmpname()
os.remove(folder)

-- A strip that cannot narrow, its card tested to the strain at 2 mm.
local length = 0.08
local function strain(u) return u / length + (u / length) ^ 2 / 2 end
local card = fabric.card("denim"):with { tested = { warp = strain(0.002) } }
local function pulled(u)
  local mesh = fabric.mesh.rectangle { width = 0.02, height = length, nx = 1, ny = 2 }
  local model = fabric.model { mesh = mesh, card = card, warp = 90 }
  model:fix("all", "x z rotation"):fix("bottom", "y"):move("top", { y = fabric.ramp(u, 1) })
  return fabric.static { model = model, duration = 1, step = 0.125 }
end

-- --- of a run, and in run.json ---
local a = pulled(0.008)
a:record(folder .. "/pull.csv", { columns = { stretch = function(run) return run:node(5).uy end } })
a:advance(0.25)
assert(#a.warnings == 0)
a:solve()
local w = a.warnings
assert(#w == 1 and w[1].code == "beyond" and w[1].time == 0.375 and w[1].serious == false)
assert(math.type(w[1].element) == "integer" and (w[1].element == 1 or w[1].element == 2))
has(w[1].text, "static: at time 0.375 s the warp of element " .. w[1].element .. " is strained to E11 = ")
local json = text_of(folder .. "/run.json")
has(json, '"code": "beyond"')
has(json, ('"element": %d'):format(w[1].element))
has(json, '"time": 0.375')

-- --- of a virtual test: of all its runs ---
local denim = fabric.card "denim"
local r = fabric.lab.uniaxial { card = denim:with { tested = { warp = 0.02 } }, displacement = 0.01, cells = { 1, 2 }, steps = 5, grips = "free" }
assert(#r.warnings == 1 and r.warnings[1].code == "beyond")
r = fabric.lab.uniaxial { card = denim:with { tested = { warp = 0.2 } }, displacement = 0.001, cells = { 1, 2 }, steps = 2, grips = "free" }
assert(#r.warnings == 0)

-- --- of runs in other processes, in the order of the items ---
local from = define.log_end()
fabric.lab.parallel { count = 3, processes = 3, isolated = true, work = function(i)
  pulled(0.001 * (i == 2 and 1 or 4 + i)):solve()
  if i == 3 then fabric.warn "the third" end
  return {}
end }
local heard = define.warnings(from)
assert(#heard == 3 and heard[1].code == "beyond" and heard[2].code == "beyond" and heard[3].code == "deck")
has(heard[3].text, "the third")
assert(heard[1].text ~= heard[2].text)

-- --- of a study: by case, in its table and when it is taken up again ---
local function study()
  return fabric.study { parameters = { u = { 0.001, 0.006 } }, folder = folder .. "/study", workers = 2, run = function(p)
    local run = pulled(p.u):solve()
    if p.u > 0.005 then fabric.warn "far,\tsaid the deck" end
    return { e = run:mean "E11" }
  end }
end
for _ = 1, 2 do
  local s = study()
  assert(s.complete and s.failed == 0 and #s[1].warnings == 0 and #s[2].warnings == 2)
  local first = s[2].warnings[1]
  assert(first.code == "beyond" and first.time == 0.375 and first.element and first.serious == false)
  assert(s[2].warnings[2].code == "deck" and s[2].warnings[2].element == nil)
  has(s[2].warnings[2].text, "far,\tsaid the deck")
  local table_ = text_of(s.file)
  assert(table_:match "^case,u,e,warnings,trouble\n1,0.001,[%d.e-]+,,\n2,0.006,[%d.e-]+,beyond deck,\n$", table_)
end
local good, why = pcall(fabric.study, { parameters = { warnings = { 1 } }, folder = folder .. "/no", run = function() return {} end })
assert(not good)
has(tostring(why), "no parameter can be named 'warnings'")

-- --- as an error ---
local head = [[
local fabric = require "fabric"
local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.01, nx = 1, ny = 1 }
local card = fabric.card("denim"):with { tested = { warp = 0.05 } }
local m = fabric.model { mesh = mesh, card = card, warp = 90 }
m:fix("all", "x z rotation"):fix("bottom", "y")
]]
local function outcome(deck, options)
  local file = assert(io.open(folder .. "/deck.lua", "w"))
  file:write(head .. deck)
  file:close()
  local pipe = assert(io.popen(("cd %s && '%s' --quiet %s deck.lua 2>&1"):format(folder, arg[-1], options)))
  local talk = pipe:read "a"
  local _, _, code = pipe:close()
  return code, talk
end
local stops = 'm:move("top", { y = fabric.ramp(0.001, 1) })\nlocal a = fabric.static { model = m, duration = 1, limit = "stop" }\n'
local turns = 'm:move("top", { y = fabric.ramp(-0.012, 1e-3) })\nlocal a = fabric.dynamic { model = m, duration = 1e-3, ledger_limit = 1e9 }\n'
for _, deck in ipairs { stops, turns } do
  local plain, said = outcome(deck .. "a:solve()", "")
  assert(plain == 0, said)
  local code, talk = outcome(deck .. "a:solve()", "--strict")
  assert(code == 3, talk)
  assert(talk:find "deck.lua:%d+: solve: ", talk)
  has(talk, "(an error under --strict)")
  code, talk = outcome(deck .. "local good, e = pcall(a.solve, a) assert(not good and e.kind == 'numerical' and e.element == 1 or #a.warnings > 1) print(a:why())", "--strict")
  assert(code == 0, talk)
end
local code, talk = outcome(stops:gsub(', limit = "stop"', "") .. "a:solve()", "--strict")
assert(code == 0, talk)
-- a case of a study fails with it, not the study
code, talk = outcome([[
local s = fabric.study { parameters = { u = { 1e-5, 0.001 } }, folder = "strict", run = function(p)
  m:move("top", { y = fabric.ramp(p.u, 1) })
  fabric.static { model = m, duration = 1, limit = "stop" }:solve()
  return { u = p.u }
end }
assert(s.complete and s.failed == 1 and s[2].trouble:find("--strict", 1, true) and s[2].warnings[1].code == "beyond" and s[2].warnings[1].serious)]], "--strict")
assert(code == 0, talk)

-- --- after a restart: as if it had never ended ---
local kept = [[
m:move("top", { y = fabric.ramp(0.001, 1) })
local a = fabric.static { model = m, duration = 1, step = 0.125 }
a:checkpoint("run.ckpt", { every = 0.125 })
if not io.open "again" then a:every("step", function(run) if run.time > 0.8 then os.exit(0) end end) end
a:solve()
for _, w in ipairs(a.warnings) do print(w.code, w.time, w.element, w.serious, w.text) end]]
code, talk = outcome(kept, "")
assert(code == 0 and not talk:find("beyond\t", 1, true), talk)
fabric.write(folder .. "/again", "")
code, talk = outcome(kept, "--restart run.ckpt")
assert(code == 0, talk)
has(talk, "from 'run.ckpt' at time 0.75 s\nbeyond\t0.5\t1\tfalse\tstatic: at time 0.5 s the warp of element 1 is strained to E11 = ")

-- --- the page has every code ---
local here = debug.getinfo(1, "S").source:match "^@(.*)/tests/lua/"
local page = text_of(here .. "/share/doc/warnings.md")
local count = 0
for _, row in ipairs(define.registry.rows()) do
  if row.name == "analysis.warnings" then
    for word in row.sentence:match "The codes: (.*)":gmatch "(%a+) %(" do
      has(page, "| `" .. word .. "` | ")
      count = count + 1
    end
  end
end
assert(count == select(2, page:gsub("\n| `", "")), count)
os.execute("rm -rf " .. folder)
