-- A stress-free shape other than the start, where cloth is free of moments, and prestress: closed forms in statics and motion,
-- quadrilaterals and triangles.
local fabric = require "fabric"
local checks = {}
local function check(what, got, want, relative) checks[#checks + 1] = { what, got, want, relative = relative } end
local pi = math.pi

local B = 3e-5
local card = fabric.svk { density = 600, thickness = 0.4e-3, warp = 30e6, weft = 20e6, shear = 4e6, poisson = { 0.2, 0.2 * 2 / 3 },
  bending = { warp = B, weft = B, twist = B / 2 } }
local function sheet(tri, nx, ny, width, height)
  return fabric.mesh.rectangle { width = width or 0.2, height = height or 0.12, nx = nx or 5, ny = ny or 3, triangles = tri }
end
-- A mesh of the same elements with other nodes.
local function moved(mesh, f)
  local nodes, elements = {}, {}
  for i = 1, #mesh.nodes do
    local x, y, z = table.unpack(mesh.nodes[i])
    nodes[i] = { f(x, y, z) }
  end
  for i = 1, #mesh.elements do elements[i] = mesh.elements[i] end
  return fabric.mesh { nodes = nodes, elements = elements }
end
local function stored(m)
  local a = fabric.static { model = m, duration = 1, step = 1 }
  return a, a.energy.stored
end
-- With nodes held and directors free.
local function settled(m) return fabric.static { model = m:fix("all", "x y z"), duration = 1, step = 1 }:solve().energy.stored end

for _, tri in ipairs { false, true } do
  local of = tri and ", triangles" or ", quadrilaterals"
  -- A rigid motion of the start, whatever its turn, has no stress: of a flat sheet, and of one that is curved where it is free.
  local flat = sheet(tri)
  local function turned(x, y, z)  -- by 163 degrees about z, then by 71 degrees about x
    local c, s, d, t = math.cos(2.845), math.sin(2.845), math.cos(1.239), math.sin(1.239)
    x, y = c * x - s * y, s * x + c * y
    return x + 0.3, d * y - t * z - 0.1, t * y + d * z
  end
  local bent = moved(flat, function(x, y) return 0.07 * math.sin(x / 0.07), y, 0.07 * math.cos(x / 0.07) end)
  for name, free in pairs { flat = flat, bent = bent } do
    local start = moved(free, turned)
    local m = fabric.model { mesh = start, card = card, reference = free, warp = 25 }
    local a, energy = stored(m)
    check("energy of a rigid motion, " .. name .. of, 1 + 1e6 * energy, 1, 1e-12)
    check("stress, " .. name .. of, 1 + a:element(4).S11 / 30e6, 1, 1e-12)
    check("mass, " .. name .. of, 1 + a:node(1).ux, 1, 1e-12)
  end

  -- A strip that is 5 % too short for its place has the force of the card, and is free across.
  local free = sheet(tri, 4, 2, 0.19, 0.03)
  local place = moved(free, function(x, y) return x / 0.95, y, 0 end)
  place:set("left", function(x) return x < 1e-9 end)
  place:set("right", function(x) return x > 0.2 - 1e-9 end)
  place:set("corner", { 1 })
  for name, c in pairs { blend = fabric.card "blend", muslin = fabric.card "muslin" } do
    local m = fabric.model { mesh = place, card = c, reference = free }
    m:fix("all", "z rotation"):fix("left", "x"):fix("right", "x"):fix("corner", "y")
    local a = fabric.static { model = m, duration = 1, step = 1 }:solve()
    local E = (1 / 0.95 ^ 2 - 1) / 2
    local point = fabric.point(c):uniaxial("warp", E)
    check("force of a short strip, " .. name .. of, (a:reaction "right"), point.S / 0.95 * 0.03 * c.thickness, 2e-3)
    check("its strain, " .. name .. of, a:element(1).E11, E, 1e-9)
  end

  -- Prestress: the forces of the edges, the stresses and the strains of the law; the frequencies of a taut membrane; no force at all
  -- on a node inside. It is as large with the yarns oblique to the mesh.
  local warp, weft, a, b = 900, 500, 0.3, 0.2
  local square = sheet(tri, 10, 10, a, b)
  local taut = fabric.model { mesh = square, card = card, membrane = true, prestress = { warp = warp, weft = weft } }
  taut:fix("boundary", "x y z")
  local r = fabric.static { model = taut, duration = 1, step = 1 }:solve()
  check("force of the right edge" .. of, (r:reaction "right") / b, warp, 1e-9)
  local lambda1, lambda2 = math.sqrt(1 + 2 * r:element(5).E11), math.sqrt(1 + 2 * r:element(5).E22)
  check("tension" .. of, r:element(5).S11 * card.thickness * lambda1 / lambda2, warp, 1e-9)
  check("tension across" .. of, r:element(7).S22 * card.thickness * lambda2 / lambda1, weft, 1e-9)
  local mass = card.density * card.thickness / lambda1 / lambda2
  local f = fabric.modes { from = r, count = 1 }[1].frequency
  check("frequency" .. of, f, 0.5 * math.sqrt((warp / a ^ 2 + weft / b ^ 2) / mass), 0.01)
  for name, c in pairs { blend = fabric.card "blend", card = card } do
    local oblique = fabric.model { mesh = sheet(tri), card = c, warp = 33, prestress = { warp = 350, weft = 120 } }
    oblique:fix("boundary", "x y z rotation")
    local o = fabric.static { model = oblique, duration = 1, step = 1 }:solve()
    local e = o:element(3)
    check("oblique tension, " .. name .. of, e.S11 * c.thickness * math.sqrt((1 + 2 * e.E11) / (1 + 2 * e.E22)), 350, 1e-8)
    check("oblique shear, " .. name .. of, 1 + e.S12 / 1e6, 1, 1e-9)
  end

  -- A flat sheet placed as a quarter of a cylinder: free of moments where it is placed, or flat with the energy B k^2 / 2.
  local R = 0.08
  local function rolled(n)
    local long = sheet(tri, n, 3, R * pi / 2, 0.04)
    return moved(long, function(x, y)  -- with the lengths of the chords
      local k = 2 * R * math.sin(pi / 4 / n) / (R * pi / 2 / n)
      return R / k * math.sin(x / R), y, R / k * math.cos(x / R)
    end), long
  end
  local roll, long = rolled(20)
  local plain = card:with { poisson = 0 }
  local _, placed = stored(fabric.model { mesh = roll, card = plain, reference = long, rest = "as placed", warp = 0 })
  check("rolled, at rest as placed" .. of, 1 + 1e4 * placed, 1, 1e-9)
  local length = R * pi / 2
  local own = settled(fabric.model { mesh = roll, card = plain, reference = long, warp = 0 })
  -- Without moments at its ends the sheet is unbent there, in quadrilaterals over a part of an element: an error of first order, which is taken out.
  local all = own
  if not tri then
    local finer, flat_of = rolled(40)
    all = 2 * settled(fabric.model { mesh = finer, card = plain, reference = flat_of, warp = 0 }) - own
  end
  check("rolled, at rest flat" .. of, all, B / R ^ 2 / 2 * length * 0.04, tri and 0.04 or 0.005)
  local flattened = settled(fabric.model { mesh = roll, card = plain, rest = "flat", warp = { 1, 0, -0.001 } })
  check("cut as a roll, at rest flat" .. of, flattened, own, 0.01)
end

-- A copy has the same shape; a deck of another solver names what it leaves out, and so does the mesh of one.
do
  local mesh = sheet(false)
  local m = fabric.model { mesh = mesh, card = card, prestress = { warp = 200 } }:fix("boundary", "x y z rotation")
  local a = fabric.static { model = m, duration = 1, step = 1 }:solve()
  local _, again = stored(m:copy())
  check("energy of a copy", again, a.energy.stored, 1e-12)
  check("goes on from itself", fabric.static { from = a, model = m:copy(), duration = 1, step = 1 }:solve().energy.stored, again, 1e-9)
  local note = fabric.export.model { model = m, to = "abaqus" }.notes[1]
  assert(note == "the stress-free shape is left out (prestress 200 N/m in warp, 0 N/m in weft): the deck begins without stress in the shape of the mesh")
  a:write "reference.k"
  assert(a.model:declared()[1].rest:find "prestress 200")
  os.remove "reference.k"
end

-- A square folded flat four times, and opened: nothing is left; nor of one that is unfolded as a sheet that bends.
do
  local n, side = 16, 0.2
  local flat = fabric.mesh.rectangle { width = side, height = side, nx = n, ny = n }
  local function fold(u, half)  -- of the line from 0 to 4 half, in halves and again
    if u > 2 * half then u = 4 * half - u end
    return u > half and 2 * half - u or u
  end
  local folded = moved(flat, function(x, y) return fold(x, side / 4), fold(y, side / 4), 0 end)
  for i = 1, #flat.nodes do folded:set("n" .. i, { i }) end
  local m = fabric.model { mesh = folded, card = card, reference = flat, membrane = true }
  for i = 1, #flat.nodes do
    local X, x = flat.nodes[i], folded.nodes[i]
    m:move("n" .. i, { x = fabric.ramp(X[1] - x[1], 1), y = fabric.ramp(X[2] - x[2], 1), z = 0 })
  end
  local a = fabric.static { model = m, duration = 1, step = 0.025 }
  check("energy folded", 1 + 1e6 * a.energy.stored, 1, 1e-12)
  a:advance(0.5)
  local half = a.energy.stored
  a:solve()
  check("energy half opened is not zero", half > 1 and 1 or 0, 1, 0)
  check("energy opened", 1 + 1e6 * a.energy.stored, 1, 1e-9)
  check("work of opening", 1 + a.energy.external, 1, 1e-6)
end
-- A band along an edge has its length in the stress-free shape.
local cut = fabric.mesh.rectangle { width = 0.19, height = 0.03, nx = 4, ny = 2 }
local place = fabric.mesh.rectangle { width = 0.20, height = 0.03, nx = 4, ny = 2 }
local function stored(band)
  local m = fabric.model { mesh = place, reference = cut, card = fabric.card "muslin" }:fix("all", "x y z rotation")
  if band then m:band { set = "bottom", stiffness = 40, ease = 0.01 } end
  return fabric.static { model = m, duration = 1 }.energy.stored
end
local short = 0.19 * 0.99
check("band of a strip that is stretched at the start", stored(true) - stored(false), 40 * short * (0.20 / short - 1) ^ 2 / 2, 1e-9)
fabric.expect(checks)
