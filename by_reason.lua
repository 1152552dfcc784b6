local fabric = require "fabric"
local steps, lines = 0, {}
local function strip(stroke, more)
  local mesh = fabric.mesh.rectangle { width = 0.021, height = 0.05, nx = 1, ny = 3 }
  local m = fabric.model { mesh = mesh, card = fabric.card "blend", warp = 90 }
  m:fix("all", "z rotation"):fix("bottom", "x y"):fix("top", "x"):move("top", { y = fabric.history { { 0, 0 }, { 0.7, stroke }, { 1, stroke / 3 } } })
  local options = { model = m, duration = 1, step = 0.05 }
  for name, value in pairs(more or {}) do options[name] = value end
  return fabric.static(options)
end
local function watched(a, name, kept)
  a:every("step", function()
    steps = steps + 1
    if steps == tonumber(os.getenv "KILL_AT") then os.exit(9, false) end
  end)
  a:record("work/" .. name .. ".csv", { columns = { f = function(run) return select(2, run:reaction "top") end } })
  a:vtk("work/" .. name, { every = 0.3 })
  return a:checkpoint("work/run.ckpt", { every = 0.1, keep = kept })
end
local function text(value)
  if type(value) == "number" then return ("%.17g"):format(value) end
  if type(value) ~= "table" then return tostring(value) end
  local keys, words = {}, {}
  for key in pairs(value) do keys[#keys + 1] = key end
  table.sort(keys, function(one, other) return tostring(one) < tostring(other) end)
  for i, key in ipairs(keys) do words[i] = tostring(key) .. "=" .. text(value[key]) end
  return "{" .. table.concat(words, " ") .. "}"
end
local function say(...)
  for _, value in ipairs(table.pack(...)) do lines[#lines + 1] = text(value) end
  fabric.write("work/said.txt", table.concat(lines, "\n"))
end
local a = watched(strip(0.006), "pull")
a:every("step", function(run)
  if run.time > 0.22 and run.time < 0.28 then run:stop "a third" end
  if run.time > 0.52 and run.time < 0.58 then run:stop "half" end
end)
a:solve()
say("first", a.stopped, a.time)
while a.stopped do
  say("goes on", a.stopped, a.stopped == "half" and a:mean "S11")
  a:solve()
end
say("end", a.stopped, a.time, #a.steps)
