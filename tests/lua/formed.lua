-- Forming: the capstan's law over a die's edge, the same bits over a restart in mid-stroke, what a
-- support of a body holds, the formed ply for other programs, and form as a case of a study.
local fabric = require "fabric"
local mm = fabric.units.mm

local function near(name, got, want, relative)
  assert(math.abs(got - want) <= relative * math.abs(want), string.format("%s: expected %.9g, got %.9g", name, want, got))
end

-- A strip under a plate with the force N is drawn over the rounded edge of a die: 2 mu N e^(mu pi/2).
do
  local t, r, opening, mu, N = 0.3 * mm, 6 * mm, 40 * mm, 0.25, 10
  local card = fabric.svk { young = 1e8, poisson = 0, density = 900, thickness = t, bending = { warp = 2e-5, weft = 2e-5, twist = 1e-5 } }
  local off = t / 2 + 0.04 * mm -- elements are chords
  local flat, arc, down = 32 * mm, math.pi / 2 * (r + off), 10 * mm
  local mesh = fabric.mesh.rectangle { width = flat + arc + down, height = 8 * mm, nx = 32, ny = 1, origin = { 0, -4 * mm, 0 } }
  mesh:map(function(s, y) -- from the end that is pulled, up the wall, round the edge and along the face
    local x0 = opening / 2 + r
    if s < down then return opening / 2 - off, y, -r - (down - s) end
    if s > down + arc then return x0 + s - down - arc, y, off end
    local a = (s - down) / (r + off)
    return x0 - (r + off) * math.cos(a), y, -r + (r + off) * math.sin(a)
  end)
  local m = fabric.model { mesh = mesh, card = card, warp = { 1, 0, 0.3 } }
  local die = fabric.rigid.die { shape = "box", size = { opening, 60 * mm }, corner = 10 * mm, edge = r, outer = 80 * mm, around = 24 }
  local plate = fabric.rigid.disc { radius = 12 * mm, centre = { 42 * mm, 0, t / 2 + off + 1 * mm }, normal = { 0, 0, 1 }, edge = 1 * mm, mass = 0.01, name = "plate" }
  m:contact { between = { die, "all" }, friction = mu, stiffness = 2e10 }:contact { between = { plate, "all" }, friction = mu, stiffness = 2e10 }
  m:fix(plate, "x y rotation"):force(plate, { z = fabric.ramp(-N, 1e-3) }):damper(plate, { z = 30 })
  m:fix("all", "y"):fix("left", "x"):move("left", { z = fabric.history { { 0, 0 }, { 1e-3, 0 }, { 5e-3, -1.8 * mm } } })
  local a = fabric.dynamic { model = m, duration = 5e-3, damping = { mass = 600 } }
  local sum, count = 0, 0
  a:every(5e-5, function(run)
    if run.time > 3.5e-3 then sum, count = sum - select(3, run:reaction "left"), count + 1 end
  end)
  a:solve()

  near("drag over the edge of a die", sum / count, 2 * mu * N * math.exp(mu * math.pi / 2), 0.04)
end

local function case(more)
  local t = { card = fabric.card("blend", { bending = "estimated" }), blank = 60 * mm, punch = { radius = 12 * mm }, die = { radius = 15 * mm, edge = 5 * mm }, holder = { force = 20 },
              stroke = 4 * mm, cells = 6, speed = 4, rows = 8, quarter = true }
  for k, v in pairs(more or {}) do t[k] = v end
  return t
end

-- A restart in the middle of the stroke ends with the same bits.
do
  local kept
  local first = fabric.lab.form(case { prepare = function(a)
    a:every(3e-4, function(run) kept = kept or run.time > 8e-4 and run:snapshot() end)
  end })
  local function state(a)
    local p = a:node(20)
    local x, y, z = a:reaction(first.punch)
    return table.concat({ p.x, p.y, p.z, p.vx, p.vz, x, y, z, a.energy.friction, a.energy.external }, " ")
  end
  local ended = state(first.analysis)
  first.analysis:restore(kept)
  assert(first.analysis.time > 0)
  first.analysis:solve()
  assert(state(first.analysis) == ended, "a restart in mid-stroke changes bits")
end

-- The formed ply for other programs: the yarns of each element are unit vectors whose angle is the shear angle.
do
  local folder = os.tmpname()
  os.remove(folder)
  local r = fabric.lab.form(case { out = folder, stack = { 90 }, stroke = 3 * mm })
  assert(#r.files == 2 and r.files[1] == folder .. "/ply1.inp" and r.files[2] == folder .. "/ply1.rad")
  for _, row in ipairs(r.angles) do
    local dot = row.warp[1] * row.weft[1] + row.warp[2] * row.weft[2] + row.warp[3] * row.weft[3]
    assert(math.abs(math.deg(math.asin(dot))) - math.abs(row.angle) < 0.05, row.angle)
  end
  local inp, rad = io.open(r.files[1]):read "a", io.open(r.files[2]):read "a"
  local element, wx, wy = inp:match "LOCATION=ELEMENT, TABLE=axes_ply1\n, 1, 0, 0, 0, 1, 0\n(%d+), ([^,]+), ([^,]+),"
  assert(element == "1" and math.abs(tonumber(wy)) > 0.95 and math.abs(tonumber(wx)) < 0.01, ("warp at 90 degrees: %s %s %s"):format(element, wx, wy))
  assert(select(2, inp:gsub("\n%d+, [^\n]*", "")) > 36 and rad:find "/INISHE/ORTHO\n         1         1        16", rad:sub(1, 200))
  if os.execute "command -v ccx >/dev/null 2>&1" then
    fabric.write(folder .. "/job.inp", "*INCLUDE, INPUT=ply1.inp\n*MATERIAL, NAME=m\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1e9, 1e8, 1e8, 0.2, 0.2, 0.2, 1e7, 1e7\n1e7\n"
      .. "*SHELL SECTION, ELSET=ply1, MATERIAL=m, ORIENTATION=yarns_ply1\n4e-4\n*BOUNDARY\n1, 1, 6\n2, 1, 6\n8, 1, 6\n*STEP\n*STATIC\n*CLOAD\n49, 3, 1\n*END STEP\n")
    assert(os.execute(("cd %s && OMP_NUM_THREADS=1 ccx job >ccx.txt 2>&1"):format(folder)) and not io.open(folder .. "/ccx.txt"):read("a"):find "ERROR", "ccx does not read the formed ply")
  else
    print "skipped: ccx (calculix-ccx)"
  end
  os.execute("rm -r " .. folder)
end

-- Forming as a case of a study, and of a budget.
do
  local folder = os.tmpname()
  os.remove(folder)
  local cases = fabric.study { parameters = { friction = { 0.1, 0.3 } }, folder = folder, workers = 1, run = function(p)
    local r = fabric.lab.form(case { friction = p.friction, stroke = 2 * mm })
    return { work = r.curve[#r.curve].external, drawn = r.draw_in.mean }
  end }
  assert(#cases == 2 and cases[2].values.work > cases[1].values.work and cases[2].values.drawn < cases[1].values.drawn)
  os.execute("rm -r " .. folder)
end
-- Hot plies: a film takes work, and friction across the warp draws less along the weft.
do
  local dry = fabric.lab.form(case { stroke = 2 * mm, stack = { 0, 90 } })
  local hot = fabric.lab.form(case { stroke = 2 * mm, stack = { 0, 90 }, film = { viscosity = 0.05, thickness = 1e-4 } })
  local by_direction = fabric.lab.form(case { stroke = 5 * mm, weft_friction = 0.6 })
  local function friction(r) return r.curve[#r.curve].friction end
  assert(friction(hot) > friction(dry) and not hot.trouble)
  assert(by_direction.draw_in.right > by_direction.draw_in.top)
end
print "formed ok"
