-- fabric.lab.chain: steps of a test that follow each other, each from the state of the one before, and a table of what is left after each.
local define = require "fabric.define"
local curves = require "fabric.columns"
local fabric = require "fabric"
local lists = require "fabric.lists"
local fail = define.fail

local step_rows = {
  { name = "name", kind = "text" },
  { name = "scheme", kind = "text", choices = { "static", "explicit", "implicit" }, optional = true },
  { name = "duration", kind = "number", unit = "s", above = 0 },
  { name = "loads", kind = "function", optional = true }, -- of model, the time at which the step begins, the run before; adds to the model
  { name = "release", kind = "number", unit = "s", above = 0, optional = true },
  { name = "options", kind = "table", optional = true }, -- further fields of fabric.static or fabric.dynamic
}

local function shown(value) return type(value) == "string" and "'" .. value .. "'" or define.registry.show(value) end

local function check(t)
  if #t.steps == 0 then fail "chain: field 'steps': expected a list of steps { {name=, duration=, ...}, ... }, got no step" end
  for i = 1, #t.steps do define.check("chain", ("steps[%d]"):format(i), t.steps[i], step_rows) end
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
        if type(row[name]) ~= "number" then
          fail(("chain: field 'columns.%s': expected the function to return a number, got %s"):format(name, shown(row[name])))
        end
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
