-- Values at the prompt: objects as physics, long lists by their range, help with values. Each case is what is typed and the
-- whole of what comes; they are typed into one session.
local cases = {
  -- meshes
  { "square = mesh.rectangle{ width=2, height=2, nx=20, ny=20 } return square", "<mesh 20x20, 441 nodes, 2.00 x 2.00 m>" },
  { "mesh.rectangle{ width=25.4*mm, height=76.2*mm, nx=3, ny=9, triangles=true }", "<mesh 3x9 in triangles, 40 nodes, 25.4 x 76.2 mm>" },
  { "mesh.hemisphere{ radius=10, around=4, along=4 }", "<mesh hemisphere 4x4, 90 degrees, 25 nodes, 10.0 x 10.0 x 9.51 m>" },
  { "mesh.read 'disc.msh'", "<mesh disc.msh, 209 nodes, 192 elements, x -100 to 100 mm, y -100 to 100 mm, z 0 mm>" },
  { "square.nodes", "<441 x 3 numbers, 0 to 2.00 m>" },
  { "square.elements", "<400 elements of node numbers 1 to 441>" },
  { "square.nodes[2]", "{0.1, 0, 0}" },
  { "square:set 'left'", "<21 numbers, 1 to 421>" },
  { "square:set 'corners', #square:set 'left'", "{1, 21, 421, 441}\t21" },
  -- cards
  { "denim = card 'denim' return denim:with{ source='' }", [[
<card denim, woven, 350 kg m^-3, 1.12 mm, 392 g m^-2>
           tangent modulus, MPa                    unloading, MPa  poisson  tested to
  warp     7 + 3 E11 - 200 E11^2 + 1810 E11^3      385             0.12     E11 = 0.2969
  weft     15 - 184 E22 + 6240 E22^2 + 3040 E22^3  402             0.22     E22 = 0.1251
  shear    1 - 4 E12 + 33 E12^2 - 53 E12^3         2                        E12 = 0.3
  law      potential
  bending  assumed: not measured, so integrated through the thickness]] },
  { "svk{ name='paper', young=1.2e9, poisson=0.3, density=500, thickness=0.1*mm, transverse={4e8, 3e8} }", [[
<card paper, svk, 500 kg m^-3, 0.1 mm, 50 g m^-2>
              modulus, MPa  poisson
  warp        1200          0.3
  weft        1200          0.3
  shear       461.5
  transverse  400, 300]] },
  { "denim:with{ source='', law='thesis', shear={memory='fading'}, tested={shear=0}, bending={warp=8e-6, weft=6e-6, twist=3.5e-6} }", [[
<card denim, woven, 350 kg m^-3, 1.12 mm, 392 g m^-2>
           tangent modulus, MPa                    unloading, MPa  poisson  tested to
  warp     7 + 3 E11 - 200 E11^2 + 1810 E11^3      385             0.12     E11 = 0.2969
  weft     15 - 184 E22 + 6240 E22^2 + 3040 E22^3  402             0.22     E22 = 0.1251
  shear    1 - 4 E12 + 33 E12^2 - 53 E12^3         2                        not stated
  law      thesis, transverse shear elastic, shear memory fades
  bending  warp 8, weft 6, twist 3.5 uN.m; typed: changed by card:with]] },
  { "{ cloth=denim, of=square }", [[
{
  cloth  <card denim, woven, 350 kg m^-3, 1.12 mm, 392 g m^-2>
  of     <mesh 20x20, 441 nodes, 2.00 x 2.00 m>
}]] },
  -- histories, points, runs
  { "ramp(3, 2), history{ {0, 0}, {1, 2}, {2, -1} }", "<history of 2 points to 2 s, 0 to 3>\t<history of 3 points to 2 s, -1 to 2>" },
  { "p = point(card 'blend') p:strain{ E11=0.1 } return p", "<point, E11 0.1, E22 0, E12 0; S11 5.024, S22 0.3754, S12 0 MPa>" },
  { "strip = mesh.rectangle{ width=25.4*mm, height=76.2*mm, nx=1, ny=3 }" },
  { "m = model{ mesh=strip, card=card 'blend':with{ bending={warp=1e-5, weft=1e-5, twist=5e-6} }, warp=90 }", "warning: m is no longer the unit; fabric.units.m still is" },
  { "m", "<model: rectangle 1x3, 8 nodes, 3 elements; card blend, 0.38 mm, 224.2 g/m2; warp 90 degrees; 1 thickness point; "
    .. "0 supports, 0 motions, no loads>" },
  { "model{ mesh=strip, card=card 'blend':with{ bending={warp=1e-5, weft=1e-5, twist=5e-6} }, warp=90 }:gravity{0, 0, -9.81}:pressure(5):fix('bottom', 'x y z')", "<model: rectangle 1x3, 8 nodes, 3 elements; card blend, 0.38 mm, 224.2 g/m2; warp 90 degrees; 1 thickness point; "
    .. "1 support, 0 motions, 1 pressure, gravity>" },
  { "m:fix('all', 'z rotation'):fix('bottom', 'x y'):fix('top', 'x'):move('top', { y=ramp(18*mm, 1) }) a = static{ model=m, duration=1, step=0.25 }" },
  { "a", "<static run, t = 0 of 1 s, 0 steps, ready>" },
  { "a:advance(0.5)", "<static run, t = 0.5 of 1 s, 2 steps, under way>" },
  { "a:every('step', function(run) if run.time == 0.75 then run:stop 'seen enough' end end) a:solve() return a", "<static run, t = 0.75 of 1 s, 3 steps, stopped: seen enough>" },
  { "a:solve()", "<static run, t = 1 of 1 s, 4 steps, done>" },
  { "a:snapshot()", "<snapshot of t = 1 s>" },
  { "#a:field 'S11', a:field 'S11'[1] > 0", "3\ttrue" },
  { "a.steps", [[
  cuts  iterations  negative_pivots  path         residuals  stable  step  time
  0     5           0                0            {...}      true    0.25  0.25
  0     4           0                "unchecked"  {...}      true    0.25  0.5
  0     4           0                0            {...}      true    0.25  0.75
  0     4           0                "unchecked"  {...}      true    0.25  1]] },
  { "p:state().warp", "virgin" },
  -- tables
  { "{}", "{}" },
  { "{1, 2, a={b='c'}}", '{1, 2, a = {b = "c"}}' },
  { "long = {} for i = 1, 441 do long[i] = i/100 end return long", "<441 numbers, 0.01 to 4.41>" },
  { "long[7] = 0/0 return long", "<441 numbers, 0.01 to 4.41, 1 of them nan>" },
  { "{ E=long, name='a curve' }", '{E = <441 numbers, 0.01 to 4.41, 1 of them nan>, name = "a curve"}' },
  { "{ {0, 0}, {1, 2}, {2, 1}, {3, 5} }", "<4 x 2 numbers, 0 to 5>" },
  { "{ {t=0, x=1}, {t=1, x=1}, {t=2, x=1}, {t=3, x=1} }", "  t  x\n  0  1\n  1  1\n  2  1\n  3  1" },
  { "m:list()", [[
  fix   all     z rotation
  fix   bottom  x y
  fix   top     x
  move  top     y 0 to 0.018 m at 1 s]] },
  { "a.model, a.mesh", "<model: rectangle 1x3, 8 nodes, 3 elements; card blend, 0.38 mm, 224.2 g/m2; warp 90 degrees; 1 thickness point; "
    .. "3 supports, 1 motion, no loads>\t<mesh 1x3, 8 nodes, 25.4 x 76.2 mm>" },
  { "{ 'a\\nb', ('x'):rep(99) }", '{"a b", "' .. ("x"):rep(57) .. '..."}' },
  { "setmetatable({}, { __tostring=function() return'mine' end })", "mine" },
  -- results of the laboratory and files
  { "lab.density{ mass={2.3e-3}, area=0.01, thickness={0.4*mm} }", "<fabric.lab.density> {density = 575, mass_per_area = 0.23, thickness = 0.0004}" },
  { "f = io.open('pull.csv', 'w') f:write 'Weg (mm);Kraft (N)\\n0;0\\n0,5;1,25\\n' f:close() return fabric.table{ file='pull.csv' }", [[
<table pull.csv, 2 columns>
  Weg    mm  {0, 0.5}
  Kraft  N   {0, 1.25}]] },
  { "lab.read{ file='pull.csv' }", [[
<fabric.lab.read> {
  displacement  {0, 0.0005}
  file          "pull.csv"
  force         {0, 1.25}
  lines         {2, 3}
  names         {"Weg", "Kraft"}
  preamble      {"Weg (mm);Kraft (N)"}
  rows          2
}]] },
  -- help
  { "help(ramp)", [[
fabric.ramp(value, duration)
  From 0 to value over the duration, then held.

  value: a number; required
      end value
  duration: a positive number in s; required
      time to reach it

  example
    local h = require 'fabric'.ramp(3, 2); assert(h:value(1) == 1.5 and h:value(9) == 3)]] },
  { "help 'fabric.statik'", "no entry contains 'fabric.statik', did you mean 'fabric.static'?" },
  { "help 'rectangel'", "no entry contains 'rectangel', did you mean 'rectangle'?" },
  { "help 'grips  sag'", "no entry contains 'grips  sag'; help() shows what there is" },
  { "help 'qqqq'", "no entry contains 'qqqq'; help() shows what there is" },
  { "help 'daN'", "daN: a unit, 10 in SI; fabric.units.daN" },
  { "help 'python'", [[
pages of the manual
  share/doc/howto/python.md              to run decks from Python and read their records, series and cards; notebooks]] },
  { "help 'shear angle'", [[
shear_angle: a field of a run, number of every element, degrees
  90 degrees less the angle between warp and weft; has the sign of E12
laboratory: from measurement to card
  fabric.lab.form              Plies are pressed through the opening of a die by a punch, under a blank holder
  fabric.lab.viscous           The part of shear that relaxes (viscous of a card) from tests at several speeds or with holds: viscous {she...
pages of the manual
  share/doc/howto/bias-angle.md          the shear angle of a bias pull at 10 N]] },
  { "help 'undo'", [[
models
  model:remove                 Takes back (undoes) a support or a load: a row of m:list() or its number]] },
  { "help 'kilby'", [[
laboratory: from measurement to card
  fabric.lab.kilby             Kilby's relation G = 1/(4/E45 - 1/E1 - 1/E2 + coupling): returns shear and bias, one of which is given]] },
  { "help 'coupling  kilby'", [[
laboratory: from measurement to card
  fabric.lab.kilby             Kilby's relation G = 1/(4/E45 - 1/E1 - 1/E2 + coupling): returns shear and bias, one of which is given]] },
  { "help(square)", [[
<mesh 20x20, 441 nodes, 2.00 x 2.00 m>
properties
  mesh.elements                Node numbers of each element, counter-clockwise
      = <400 elements of node numbers 1 to 441>
  mesh.nodes                   Reference positions {x, y, z}, m, by node number
      = <441 x 3 numbers, 0 to 2.00 m>
  mesh.sets                    Names of the node sets
      = {"all", "bottom", "boundary", "corners", "left", "right", "top"}
methods
  mesh:check                   Errors of the mesh and remarks on it: a table {ok, text, items, area, shortest, longest, aspect, warping, l...
  mesh:elements                Numbers of the elements all of whose nodes are in the set
  mesh:hole                    Cuts a hole along the grid: leaves out the elements inside and the nodes that no element has any more
  mesh:map                     Moves every node; on an error none is moved
  mesh:orient                  Turns elements around until neighbours agree on the normal, as few as that takes; returns how many
  mesh:pair                    Joins triangles in pairs to quadrilaterals where these have corners of 30 to 150 degrees and are flat; retu...
  mesh:refine                  Cuts every element from its middle to the middles of its sides into quadrilaterals, four of a quadrilateral...
  mesh:set                     Makes or replaces a named set of nodes; with the name alone gives its node numbers
  mesh:slit                    Slits the mesh along a straight line of edges between nodes: the nodes on it are doubled, but for an end in...
  mesh:wrap                    Lays a mesh in the x-y plane around a cylinder or a cone, with lengths, angles and areas kept and the norma...
  mesh:write                   Writes the mesh, lengths in m. With its sets: .vtu and .msh (Gmsh 4.1), which read back equal, .inp (Abaqus...]] },
  { "help 'mesh:map'", [[
mesh:map(f)
  Moves every node; on an error none is moved.

  f: a function; required
      function(x, y, z) that returns the new x, y, z

  example
    local fabric = require 'fabric'
    local mesh = fabric.mesh.rectangle{ width=0.0254, height=0.0762, nx=3, ny=9 }
    mesh:map(function(x, y, z) return x, y, 0.001*y end)
    assert(mesh.nodes[40][3] > 0)]] },
}

local path = os.tmpname()
local input = assert(io.open(path, "w"))
for i, case in ipairs(cases) do
  input:write(case[1]:gsub("^(.-) return (.-)$", "%1\n%2"), "\n", ("print '--- %d'\n"):format(i))
end
input:close()
local pipe = assert(io.popen(("'%s' < '%s' 2>&1"):format(arg[-1], path)))
local talk = pipe:read "a"
pipe:close()
os.remove(path)
os.remove "pull.csv"

local at, missed = 1, 0
for i, case in ipairs(cases) do
  local first, last = talk:find(("--- %d\n"):format(i), at, true)
  if not first then
    io.stderr:write("the session ended before: ", case[1], "\n", talk:sub(at), "\n")
    os.exit(1)
  end
  local got, want = talk:sub(at, first - 1), case[2] and case[2] .. "\n" or ""
  if got ~= want then
    missed = missed + 1
    io.stderr:write("> ", case[1], "\ngot:\n", got, "want:\n", want)
  end
  at = last + 1
end
assert(missed == 0, missed .. " cases missed")

-- Help on every row and on every word in a name: it must not fail, and a row's page names every argument.
local fabric = require "fabric"
local registry = require "fabric.define".registry
local said = {}
local plain = print
function print(text) said[#said + 1] = text end
for _, row in ipairs(registry.rows()) do
  fabric.help(row.name)
  local page = said[#said]
  local function check(arguments)
    for _, argument in ipairs(arguments) do
      assert(page:find(argument.name .. ": " .. argument.expected, 1, true), row.name .. ": help has no " .. argument.name)
      check(argument.rows)
    end
  end
  check(row.arguments)
end
fabric.help()
local overview = said[#said]
for _, row in ipairs(registry.rows()) do
  local short = row.name:match "^fabric%.([%w_.]+)$"
  assert(not short or overview:find(short, 1, true), "the overview has no " .. row.name)
end
-- Words that begin so, not those that only contain it, unless there are no others.
fabric.help "kes"
assert(said[#said]:find("fabric.lab.kes_card", 1, true) and not said[#said]:find("model:force", 1, true), said[#said])
fabric.help "akes"
assert(said[#said]:find("model:force", 1, true), said[#said])
fabric.help(fabric.card "blend")
assert(said[#said]:find("thickness", 1, true) and said[#said]:find("= 0.00038", 1, true))
print = plain
print(#cases .. " cases")
