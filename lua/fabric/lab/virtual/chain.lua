-- fabric.lab.chain: steps of a test that follow each other, each from the state of the one before, and a table of what is left after each.
local define = require "fabric.define"
local curves = require "fabric.columns"
local fabric = require "fabric"
local lists = require "fabric.lists"
local fail = define.fail

local fields = { "name", "scheme", "duration", "loads", "release", "options" }
local schemes = { static = true, explicit = true, implicit = true }

local function shown(value)
  if type(value) == "string" then return "'" .. value .. "'" end
  return (type(value) == "number" or value == nil) and tostring(value) or "a " .. type(value)
end

local function expected(place, what, got) fail(("chain: field '%s': expected %s, got %s"):format(place, what, shown(got))) end

local function check_step(step, place)
  if type(step) ~= "table" then expected(place, "a table {" .. table.concat(fields, ", ") .. "}", step) end
  local known = {}
  for _, field in ipairs(fields) do known[field] = true end
  for field in pairs(step) do
    if not known[field] then
      fail(("chain: field '%s': unknown field %s (known: %s)"):format(place, shown(field), table.concat(fields, " ")))
    end
  end
  if type(step.name) ~= "string" then expected(place .. ".name", "a string", step.name) end
  if step.scheme ~= nil and not schemes[step.scheme] then expected(place .. ".scheme", "'static' or 'explicit' or 'implicit'", step.scheme) end
  if type(step.duration) ~= "number" or not (step.duration > 0) then expected(place .. ".duration", "a positive number in s", step.duration) end
  if step.loads ~= nil and type(step.loads) ~= "function" then
    expected(place .. ".loads", "a function(model, begins, before) that adds to the model", step.loads)
  end
  if step.release ~= nil and (type(step.release) ~= "number" or not (step.release > 0)) then
    expected(place .. ".release", "a positive number in s", step.release)
  end
  if step.options ~= nil and type(step.options) ~= "table" then
    expected(place .. ".options", "a table of further fields of fabric.static or fabric.dynamic", step.options)
  end
end

local function check(t)
  if #t.steps == 0 then fail "chain: field 'steps': expected a list of steps { {name=, duration=, ...}, ... }, got no step" end
  for i = 1, #t.steps do check_step(t.steps[i], ("steps[%d]"):format(i)) end
  if t.steps[1].release then fail "chain: field 'steps[1].release': expected none: nothing holds the cloth before the first step" end
  for name, column in pairs(t.columns or {}) do
    if type(name) ~= "string" or type(column) ~= "function" then
      fail(("chain: field 'columns': expected { name=function(analysis) ... end, ... }, got %s for %s"):format(shown(column), shown(name)))
    end
  end
end

local function begin(t, step, before)
  local model = t.model:copy()
  if step.loads then step.loads(model, before and before.time or 0, before) end
  local given = lists.copy(step.options or {})
  given.model, given.from, given.duration, given.release = model, before, step.duration, step.release
  if (step.scheme or "static") == "static" then return fabric.static(given) end
  given.scheme = step.scheme
  return fabric.dynamic(given)
end

local function run(t)
  check(t)
  local rows, names, before = curves.made(), lists.keys(t.columns or {}), nil
  for cycle = 1, t.cycles do
    for _, step in ipairs(t.steps) do
      local a = begin(t, step, before)
      if t.checkpoint then a:checkpoint(t.checkpoint, { every = step.duration / 8 }) end
      if t.watch then t.watch(a, step.name, cycle) end
      a:solve()
      local energy = a.energy
      local row = { cycle = cycle, name = step.name, time = a.time, stored = energy.stored, dissipated = energy.dissipated, work = energy.external }
      for _, name in ipairs(names) do
        row[name] = t.columns[name](a)
        if type(row[name]) ~= "number" then expected("columns." .. name, "the function to return a number", row[name]) end
      end
      rows[#rows + 1], before = row, a
    end
  end
  return { rows = rows, analysis = before, model = before.model }
end

define {
  name = "fabric.lab.chain",
  arguments = {
    { name = "model", of = "model", sentence = "the cloth with what holds it in all steps, without loads" },
    { name = "steps", kind = "table", sentence = "{ {name=, duration=, scheme=?, loads=?, release=?, options=?}, ... }: duration and release in s; "
      .. "scheme 'static', 'explicit' or 'implicit'; loads=function(model, begins, before) adds to a copy of the model what holds, moves and loads it in "
      .. "this step, which begins at the time `begins` from the analysis `before`; options are further fields of fabric.static or fabric.dynamic" },
    { name = "cycles", kind = "integer", low = 1, default = 1, sentence = "how often the list of steps is gone through" },
    { name = "columns", kind = "table", optional = true, sentence = "{ name=function(analysis) ... end, ... }: numbers that are read at the end of each step" },
    { name = "watch", kind = "function", optional = true, sentence = "function(analysis, name, cycle) before a step is solved: its outputs and hooks" },
    { name = "checkpoint", kind = "text", optional = true, sentence = "file of checkpoints, eight in each step, from which --restart goes on with the step under way" },
  },
  sentence = "Steps of a test that follow each other, such as loading, relaxation, unloading, and cycles of them: each begins from the state of the one before. "
    .. "Returns rows (one a step: cycle, name, time (s), stored, dissipated, work (J), and the columns), the last analysis, and its model.",
  example = "local mesh = fabric.mesh.rectangle{ width=0.02, height=0.05, nx=1, ny=2 }\n"
    .. "local m = fabric.model{ mesh=mesh, card=fabric.card 'blend', warp=90 }:fix('all', 'z rotation'):fix('bottom', 'x y')\n"
    .. "local chain = fabric.lab.chain{ model=m, steps={\n"
    .. "  { name='pull', duration=1, loads=function(m, t) m:move('top', { y=fabric.history{ {t, 0}, {t+1, 0.004} } }) end },\n"
    .. "  { name='let go', duration=1, release=1 } }, columns={ left=function(a) return a:mean('E22') end } }\n"
    .. "assert(#chain.rows == 2 and chain.rows[2].time == 2 and chain.rows[2].stored < chain.rows[1].stored)",
  run = run,
}
