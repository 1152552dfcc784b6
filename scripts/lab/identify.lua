-- Properties that no formula gives, through simulation: a bending rigidity from cantilevers, the biaxial spring from a cruciform, and which
-- further test would tell what a test leaves open. The measurements are simulated with known parameters and rounded as read.
--
--   fabricsh scripts/lab/identify.lua
local fabric = require "fabric"
local lab, u = fabric.lab, fabric.units
if fabric.checking() then return end
local checks = {}

-- Bending: tips of strips that overhang an edge by 40, 60 and 80 mm, read to 0.1 mm. The measured strips are simulated with
-- twice the elements.
local function tips(B, elements)
  local card = fabric.svk { name = "strip", young = 50 * u.MPa, poisson = 0, density = 500, thickness = 0.4 * u.mm,
    bending = { warp = B, weft = B, twist = B } }
  local out = {}
  for _, length in ipairs { 40, 60, 80 } do
    local mesh = fabric.mesh.rectangle { width = length * u.mm, height = 25 * u.mm, nx = elements, ny = 1 }
    local model = fabric.model { mesh = mesh, card = card }
    model:fix("left", "x y z rotation"):traction("all", { z = fabric.ramp(-0.2 * 9.81, 1) })
    local tip = fabric.static { model = model, duration = 1, step = 0.2 }:solve():node(elements + 1)
    out[#out + 1], out[#out + 2] = tip.x, tip.z
  end
  return out
end
local reference = 15e-6
local read = tips(reference, 24)
for i, x in ipairs(read) do read[i] = math.floor(x / 1e-4 + 0.5) * 1e-4 end
local bending = lab.identify {
  parameters = { { name = "log10 B", start = -4, low = -6, high = -3 } },
  tests = { { name = "cantilever", measured = read, noise = 1e-4, predict = function(p) return tips(10 ^ p["log10 B"], 12) end } },
}
print(bending.text)
checks[#checks + 1] = { "bending rigidity over the true one", 10 ^ bending.parameters["log10 B"] / reference, 1, absolute = 0.01 } -- reading and mesh

-- The biaxial spring of a card: a 1:1 pull tells its loading modulus; its unloading modulus only a pull that comes back.
local spring = { alpha = 1.568, offset = 0.1606, loading = 294 * u.MPa, unloading = 111 * u.MPa }
local function pulled(p, path)
  local card = fabric.card "blend":with { biaxial = { alpha = spring.alpha, offset = spring.offset, loading = 10 ^ p.q, unloading = 10 ^ p.Tu } }
  local curve = lab.biaxial { card = card, cells = 1, steps = 12, path = path, release = 1e-3 }.curve
  local out = {}
  for i = 2, 13 do
    local row = curve[math.min(i, #curve)]
    out[#out + 1], out[#out + 2] = row.force_x, row.force_y
  end
  return out
end
local up, back = { 1 }, { 1, 0.96 }
local real = { q = math.log(spring.loading, 10), Tu = math.log(spring.unloading, 10) }
local loading = pulled(real, up)
for i, P in ipairs(loading) do loading[i] = math.floor(P + 0.5) end -- N
local biaxial = lab.identify {
  parameters = { { name = "q", start = 8.2, low = 7.5, high = 9.5 }, { name = "Tu", start = 8.4, low = 7.8, high = 9 } },
  tests = { { name = "1:1", measured = loading, noise = 1, predict = function(p) return pulled(p, up) end } },
  further = {
    { name = "another pull to the same end", noise = 1, predict = function(p) return pulled(p, up) end },
    { name = "a pull that comes back by 4 %", noise = 1, predict = function(p) return pulled(p, back) end },
  },
}
print(biaxial.text)
checks[#checks + 1] = { "biaxial loading modulus over the true one", 10 ^ (biaxial.parameters.q - real.q), 1, absolute = 0.01 } -- read to 1 N
checks[#checks + 1] = { "unloading reported as unknown", biaxial.text:find "Tu.*not known" and 1 or 0, 1, absolute = 0 }
checks[#checks + 1] = { "the further test is the one that comes back", biaxial.further[1].name:find "back" and 1 or 0, 1, absolute = 0 }
fabric.expect(checks)
