-- Cloth that bends under its own weight: cantilever and heart loop against the elastica, twist, the KES curve of a card that softens and
-- rubs, cards whose bending nobody measured.
local fabric = require "fabric"
local lab = fabric.lab
local gf, cm = 9.80665e-3, 1e-2
local checks = {}
local function check(name, got, want, relative) checks[#checks + 1] = { name, got, want, relative = relative } end
local function says(act, words)
  local ok, message = pcall(act)
  assert(not ok and tostring(message):find(words, 1, true), tostring(message))
end

-- --- the elastica, B k' = w (l - s) cos(phi) + H sin(phi), phi' = k, in 400 steps of Runge and Kutta: the end's angle, curvature, x, z
local function elastica(l, phi, k, w, H, B)
  local n = 400
  local h, x, z = l / n, 0, 0
  local function rate(s, p, c) return c, (w * (l - s) * math.cos(p) + H * math.sin(p)) / B, math.cos(p), math.sin(p) end
  for i = 0, n - 1 do
    local s = i * h
    local a1, b1, c1, d1 = rate(s, phi, k)
    local a2, b2, c2, d2 = rate(s + h / 2, phi + h / 2 * a1, k + h / 2 * b1)
    local a3, b3, c3, d3 = rate(s + h / 2, phi + h / 2 * a2, k + h / 2 * b2)
    local a4, b4, c4, d4 = rate(s + h, phi + h * a3, k + h * b3)
    phi, k = phi + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), k + h / 6 * (b1 + 2 * b2 + 2 * b3 + b4)
    x, z = x + h / 6 * (c1 + 2 * c2 + 2 * c3 + c4), z + h / 6 * (d1 + 2 * d2 + 2 * d3 + d4)
  end
  return phi, k, x, z
end

-- Overhang whose chord hangs at 41.5 degrees. The curvature at the edge, k0 < 0, leaves none at the end.
local function overhang(w, B)
  local function chord(l)
    local low, high = -w * l * l / B, 0
    for _ = 1, 60 do
      local middle = (low + high) / 2
      if select(2, elastica(l, 0, middle, w, 0, B)) > 0 then high = middle else low = middle end
    end
    local _, _, x, z = elastica(l, 0, low, w, 0, B)
    return math.deg(math.atan(-z, x))
  end
  local c = (B / w) ^ (1 / 3)
  local low, high = 1.8 * c, 2.2 * c
  for _ = 1, 40 do
    local middle = (low + high) / 2
    if chord(middle) < 41.5 then low = middle else high = middle end
  end
  return low
end

-- Height of a heart loop: root upright, end face down under it. Newton on the root's curvature and the pull across, weight by weight.
local function heart(L, w, B)
  local l = L / 2
  local k0, H = -1.5 * math.pi / l, 0
  local function off(a, b, share)
    local phi, _, x, z = elastica(l, math.pi / 2, a, share * w, b, B)
    return phi + math.pi, x, z
  end
  for share = 0, 20 do
    share = share / 20
    for _ = 1, 60 do
      local p, x = off(k0, H, share)
      if math.abs(p) + math.abs(x) / l < 1e-11 then break end
      local dk, dH = 1e-6 / l, 1e-6 * B / l ^ 2
      local p1, x1 = off(k0 + dk, H, share)
      local p2, x2 = off(k0, H + dH, share)
      local a, b, c, d = (p1 - p) / dk, (p2 - p) / dH, (x1 - x) / dk, (x2 - x) / dH
      local det = a * d - b * c
      local s0, s1 = -(d * p - b * x) / det, -(a * x - c * p) / det
      local f = math.min(1, 0.2 * math.abs(k0) / math.abs(s0))
      k0, H = k0 + f * s0, H + f * s1
    end
  end
  local p, x, z = off(k0, H, 1)
  assert(math.abs(p) + math.abs(x) / l < 1e-9)
  return -z
end

local B, w = 15e-6, 0.2 * 9.80665
local plain = fabric.svk { name = "strip", young = 50e6, poisson = 0, density = 500, thickness = 0.4e-3, bending = { warp = B, weft = B / 2, twist = 7e-6 } }
local strip = lab.cantilever { card = plain }
check("cantilever: overhang", strip.overhang, overhang(w, B), 1e-3)
check("cantilever: rigidity by the standard", strip.rigidity, B, 2e-3)
check("cantilever along the weft", lab.cantilever { card = plain, direction = "weft" }.overhang, overhang(w, B / 2), 1e-3)
check("the angle", strip.angle, 41.5, 1e-4)
assert(#strip.shape == 41 and strip.shape[1][1] == 0)
for _, L in ipairs { 0.1, 0.15 } do check(("heart loop of %g m: height"):format(L), lab.heart_loop { card = plain, length = L }.height, heart(L, w, B), 1e-3) end
local light = plain:with { density = 20 }
check("a loop that hardly weighs anything", lab.heart_loop { card = light, length = 0.05 }.height, heart(0.05, w / 25, B), 1e-3)
says(function() lab.heart_loop { card = plain, direction = 45 } end, "heart_loop: field 'direction'")

-- --- twist: a sheet bent to a cylinder, a simulated strip, what no twist can do
local t = lab.twist { warp = 15e-6, weft = 9e-6, bias = 10e-6 }
assert(t.reached)
check("twist of a cylinder", t.bending.twist, 4e-6, 1e-12)
t = lab.twist { warp = 20e-6, weft = 5e-6, bias = 6.3e-6 } -- any positive twist is one
assert(t.reached and math.abs(t.bending.twist - 0.05e-6) < 1e-15 and math.abs(t.bias - 6.3e-6) < 1e-15)
t = lab.twist { warp = 20e-6, weft = 5e-6, bias = 5e-6 }
assert(not t.reached and t.words:find("a positive twist cannot", 1, true) and t.bending.twist > 0 and t.bias > 5e-6)
t = lab.twist { warp = 15e-6, weft = 9e-6, bias = 10e-6, simulate = true, width = 0.01 }
check("twist by simulation: what it shows", t.bias, 10e-6, 2e-3)
t = lab.twist { warp = 0.02, weft = 0.016, bias = 0.018, areal_mass = 0.2 }
check("lengths make rigidities", t.bending.warp, w * 0.02 ^ 3, 1e-12)

-- --- a card that softens and rubs: its KES curve
for _, memory in ipairs { "slip", "fading" } do
  local card = plain:with { bending = { warp = { 15e-6, -0.04e-6 }, tested = 100, friction_warp = { moment = 0.2e-3, curvature = 8, memory = memory } } }
  local k = lab.kes_bending { card = card }
  -- Up from 50 to 150 /m: the integral of B, straight beyond 100.
  local up = (15e-6 * 50 - 0.02e-6 * (100 ^ 2 - 50 ^ 2) + 50 * 11e-6) / 100
  check(memory .. ": B", k.B * gf * cm, up, memory == "slip" and 1e-9 or 1e-2) -- the rest of the fading
  check(memory .. ": 2HB", k["2HB"] * gf, 0.4e-3, memory == "slip" and 1e-9 or 2e-3)
  local p = fabric.point(card)
  local there = p:bend { k11 = 100 }
  check(memory .. ": moment", there.M11, (15e-6 - 0.02e-6 * 100) * 100 + 0.2e-3 * (memory == "slip" and 1 or 1 - math.exp(-100 / 8)), 1e-12)
  assert(p:bend { k11 = 0 }.dissipated > there.dissipated)
  local points = { { 0, 0 }, { 50, 0.7e-3 }, { 150, 1.5e-3 } }
  local measured = card:with { bending = { warp = points } }
  assert(measured.bending.warp[3][2] == 1.5e-3 and card.bending.warp[2] == -0.04e-6 and plain.bending.warp == B)
  assert(tostring(card):find("warp 15 - 0.04 k", 1, true) and tostring(measured):find("warp 3 points to 1.5 mN at 150 1/m", 1, true), tostring(card))
  -- In a sheet: a card of points hangs as its moments do
  assert(lab.cantilever { card = card }.overhang < lab.cantilever { card = plain }.overhang * 1.2)
end
says(function() lab.kes_bending { card = fabric.card "blend" } end, "expected the card's own bending")
says(function() plain:with { bending = { warp = { { 0, 0 }, { 10, 1 }, { 5, 2 } } } } end, "expected curvature and moment to increase, at point 3")
says(function() fabric.model { mesh = fabric.mesh.rectangle { width = 1, height = 1, nx = 1, ny = 1 },
  card = plain:with { bending = { warp = { 15e-6, -1e-6 }, tested = 100 } } } end, "field 'bending.warp': expected a positive rigidity up to the tested 100 1/m")

-- --- the thesis' cards say that nobody measured their bending, and have an estimate
for _, name in ipairs { "blend", "duck", "muslin", "denim" } do
  local card = fabric.card(name)
  assert(card.bending == nil and card.provenance.bending:find("^assumed: not measured"))
  local estimated = fabric.card(name, { bending = "estimated" })
  assert(estimated.bending.warp[1] == card.estimate.bending.warp[1] and estimated.provenance.bending:find("^assumed: estimated, X. Feng"))
  assert(estimated.warp.poisson == card.warp.poisson)
  assert(fabric.card(name, { bending = "thickness" }).through_thickness and not card.through_thickness)
end
says(function() fabric.card("blend", { bending = "guessed" }) end, "'guessed'")
fabric.expect(checks)
