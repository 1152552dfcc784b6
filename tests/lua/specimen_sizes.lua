-- Specimens and records that are not those of the standards: their arguments against closed forms.
local fabric = require "fabric"
local mm = fabric.units.mm
local function near(what, got, want, share) assert(math.abs(got / want - 1) < share, ("%s: got %.5g, want %.5g"):format(what, got, want)) end
local function svk(strength, more)
  local yarn = { strength = strength, energy = 20 }
  for key, value in pairs(more or {}) do yarn[key] = value end
  return fabric.svk { young = 1e8, poisson = 0, density = 500, thickness = 5e-4, through_thickness = true, rupture = { warp = yarn, weft = yarn } }
end

-- A ball of half the size, in a ring of half the size: in a membrane strains are the same, and forces and ways half as large.
local ways = {}
for i, size in ipairs { 1, 0.5 } do
  ways[i] = fabric.lab.ball_burst { card = svk(8e3, { energy = 20 * size }), ball = 24 * mm * size, ring = 44 * mm * size, h = 6 * mm * size, coarse = "keep", speed = 8, rows = 120 } -- ways to a row
end
assert(tostring(ways[2].ball):find "radius 0.006 m")
near("peak of the smaller ball", ways[2].peak, ways[1].peak / 2, 0.03)
near("its way", ways[2].elongation, ways[1].elongation / 2, 0.03)
local too_large, words_of_ball = pcall(fabric.lab.ball_burst, { card = svk(8e3), ball = 44 * mm, ring = 44 * mm })
assert(not too_large and tostring(words_of_ball):find("ball_burst: field 'ball': expected at most 0.043 m, the ring less the cloth on both sides, got 0.044", 1, true), words_of_ball)

-- A trapezoid of other sides; and sides that are none.
local sides = { card = svk(4e3), method = "trapezoid", h = 3 * mm, width = 30 * mm, short = 20 * mm, long = 46 * mm, cut = 6 * mm, tear = 9 * mm, speed = 3 }
local trapezoid = fabric.lab.tear(sides)
assert(trapezoid.curve[#trapezoid.curve].torn >= 9 * mm * (1 - 1e-9) and trapezoid.fracture > 0)
for name, value in pairs { short = 13 * mm, long = 20 * mm, cut = 30 * mm, tear = 25 * mm } do
  local wrong = {}
  for key, given in pairs(sides) do wrong[key] = given end
  wrong[name] = value
  local ok, words = pcall(fabric.lab.tear, wrong)
  assert(not ok and tostring(words):find("tear: field '" .. name .. "': expected ", 1, true), words)
end
for name, value in pairs { width = 4 * mm, leg = 2 * mm } do
  local ok, words = pcall(fabric.lab.tear, { card = svk(4e3), h = 3 * mm, tear = 9 * mm, [name] = value })
  assert(not ok and tostring(words):find("tear: field '" .. name .. "': expected ", 1, true), words)
end

-- Strength goes with length^-exponent. Without scatter to speak of, tests of 40 mm say what elements of 2.5 mm carry.
local strip = fabric.lab.strip_rupture { card = svk(4e3, { scatter = { modulus = 1e6, length = 40 * mm, exponent = 0.1 } }), width = 10 * mm, length = 20 * mm, h = 2.5 * mm }
near("strength of yarns as long as an element", strip.strength, 4e3 * (40 / 2.5) ^ 0.1, 0.01)

-- A seam in a specimen of another width and length, faster: its strength is that of the stitches.
local seam = fabric.lab.seam_strength { card = svk(40e3), yarn = "weft", strength = 4e3, energy = 20, width = 10 * mm, length = 20 * mm, h = 2.5 * mm, speed = 0.2, damping = 5,
  ledger_limit = 0.02 }
near("strength of a seam", seam.strength, 4e3, 0.02)

-- Assumptions where an instrument measures nothing.
local function fast(ratio)
  return fabric.lab.fast_card { name = "suit", thickness = 5e-4, density = 400, warp = { E20 = 0.9, E100 = 2.5, B = 8 }, weft = { E20 = 1.2, E100 = 4, B = 6 }, EB5 = 4,
    poisson = { warp = 0.2, weft = 0.2 }, unloading_ratio = ratio }
end
near("unloading of a FAST card", fast(3).warp.unloading, 1.5 * fast(2).warp.unloading, 1e-12)
local kes = fabric.lab.kes_card { name = "shirt", thickness = 4e-4, density = 400, warp = { EMT = 4, WT = 9, RT = 55 }, weft = { EMT = 6, WT = 13, RT = 50 },
  shear = { G = 0.8, ["2HG"] = 1.5 }, poisson = { warp = 0.2, weft = 0.2 },
  bending = { warp = { B = 0.1, ["2HB"] = 0.05 }, weft = { B = 0.08, ["2HB"] = 0.04 }, build_up = 20 } }
assert(kes.bending.friction_warp.curvature == 20)

-- Five pulls to rupture, with a comma between thousands; after the peak the force falls to 85 % of it.
local folder = os.tmpname()
os.remove(folder)
local files = {}
for k, last in ipairs { 4, 5, 6, 5, 5 } do
  local lines = { "Extension (mm),Load (N)" }
  local function add(mm_, N) lines[#lines + 1] = ('%d,"%s"'):format(mm_, N < 1000 and N or ("%d,%03d"):format(N // 1000, N % 1000)) end
  for i = 0, 10 * last do add(i, 40 * i) end
  for i = 1, 5 do add(10 * last + i, 340 * last) end
  files[k] = ("%s/warp-%d.csv"):format(folder, k)
  fabric.write(files[k], table.concat(lines, "\n") .. "\n")
end
local function broken(more)
  local t = { folder = folder, gauge_length = 0.2, width = 0.05, breaks = {}, thousands = ",", kept = 0.9 }
  for key, value in pairs(more) do t[key] = value end
  return fabric.lab.breaking_strength(t).groups.warp
end
local usual, surer = broken {}.force, broken { level = 0.99 }.force
near("mean of the forces", usual.mean, 2000, 1e-12)
near("interval at 99 %", (surer.high - surer.mean) / (usual.high - usual.mean), 4.6041 / 2.7764, 1e-4)
assert(broken { kept = 0.8 }.counted == 0) -- a fall to 85 % is no break then
for _, file in ipairs(files) do os.remove(file) end
os.remove(folder)

-- Faint dots, of 8 % of the contrast of black on white.
local name = os.tmpname()
for i = 1, 2 do
  fabric.lab.photograph { file = name .. i .. ".png", rows = 3, columns = 2, pitch = 40, radius = 6, width = 160, height = 200, F = { 1, 0, 0, 1 + 0.1 * (i - 1) },
    ground = 0.5, ink = 0.42, noise = 0.002 }
end
local dots = { files = { name .. "1.png", name .. "2.png" }, rows = 3, columns = 2 }
local ok, words = pcall(fabric.lab.track, dots)
assert(not ok and tostring(words):find "contrast", words)
dots.contrast = 0.04
local t = fabric.lab.track(dots)
assert(#t.doubtful == 0)
near("stretch of faint dots", (t.y[11] - t.y[9]) / 40, 1.1, 0.01)
for i = 1, 2 do os.remove(name .. i .. ".png") end
os.remove(name)

-- The seed of a bootstrap.
local specimens = { { 1.0 }, { 1.3 }, { 0.9 }, { 1.1 }, { 1.2 } }
local function low(seed) return fabric.lab.band { specimens = specimens, seed = seed, draws = 500 }.low[1] end
assert(low(2) == low(2) and low(2) ~= low(3))
