-- Small scenes thrown together at random: sheets and strips, quadrilaterals and triangles, balls, a floor; up to 30 m/s, friction from 0 to
-- 1, contact thinner than an element and thicker. Whether anything has passed is looked at by brute force at every committed step: in every
-- other scene from a hook, which ends the block of steps that a run goes back to when it was pressed too hard; in the others from outside, so
-- that blocks have their 64 steps.
--
--   fabricsh scripts/contact/random.lua                  30 scenes
--   fabricsh scripts/contact/random.lua 1000 501         1000, from seed 501 on (scripts/long/contact/random.lua: 10,000)
--   fabricsh scripts/contact/random.lua 1 77             one of them again
--   fabricsh scripts/contact/random.lua 100 1 implicit   100 with implicit steps, 50 for the way of each scene
--   fabricsh scripts/contact/random.lua 40 1 tears       pieces of quadrilaterals that tear, held at two edges in half of the scenes (scripts/long/contact/tears.lua)
-- warns: is turned over: it is more than 90 degrees
-- warns: turned inside out
-- warns: the guard of the directors has
local fabric = require "fabric"
local brute = dofile((arg[0]:gsub("[^/]*$", "brute.lua")))
local count, first = tonumber(arg[1] or 30), tonumber(arg[2] or 1)
local tears = arg[3] == "tears"
local scheme = not tears and arg[3] or "explicit"
if fabric.checking() then count = 1 end

local function between(low, high) return low + (high - low) * math.random() end

-- A sheet or a strip, turned, tilted and lifted; its mesh and the direction of its warp.
local function piece(cell, z)
  local strip = math.random() < 0.4
  local nx, ny = strip and math.random(6, 12) or math.random(3, 6), strip and math.random(1, 2) or math.random(3, 6)
  local turn, tilt = math.rad(between(-180, 180)), math.rad(between(-25, 25))
  local width, height = nx * cell, ny * cell
  local cx, cy = between(-2, 2) * cell, between(-2, 2) * cell
  local mesh = fabric.mesh.rectangle { width = width, height = height, nx = nx, ny = ny, triangles = math.random() < 0.4 and not tears, origin = { -width / 2, -height / 2, 0 } }
  local function rotated(x, y) -- about x, then about z
    local y1, z1 = y * math.cos(tilt), y * math.sin(tilt)
    return x * math.cos(turn) - y1 * math.sin(turn), x * math.sin(turn) + y1 * math.cos(turn), z1
  end
  mesh:map(function(x, y)
    local u, v, w = rotated(x, y)
    return u + cx, v + cy, w + z
  end)
  return mesh, { rotated(1, 0) }, math.abs(height / 2 * math.sin(tilt))
end

-- The card with yarns that break at a strain of 1 to 10 %, and tear on elements of the cell from fine to far too coarse.
local function breaks(card, cell)
  local rupture = {}
  for _, yarn in ipairs { "warp", "weft" } do
    local stiffness = fabric.point(card):uniaxial(yarn, 1e-3).S / 1e-3 * card.thickness
    local strength = 10 ^ between(-2, -1) * stiffness
    rupture[yarn] = { strength = strength, energy = strength ^ 2 / stiffness * cell * 10 ^ between(-0.5, 1),
                      scatter = math.random() < 0.5 and { modulus = between(3, 30) } or nil }
  end
  return card:with { rupture = rupture }
end

-- The run of one scene and the look at it.
local function throw(seed)
  math.randomseed(seed)
  local cell = between(1.5e-3, 4e-3)
  local thickness = cell * (seed % 3 == 0 and between(1, 1.8) or between(0.08, 0.9)) -- as contact sees it
  local friction = seed % 4 == 1 and 0 or between(0, 1)
  local card = fabric.svk { young = 10 ^ between(5, 7.5) * (tears and 30 or 1), poisson = between(0, 0.4), density = between(300, 1000), thickness = between(0.2e-3, 0.6e-3),
                            through_thickness = true, name = "sheet" }
  local fastest = between(1, 30)
  if tears then card, fastest = breaks(card, cell), between(5, 60) end
  local bodies, z = {}, 0
  for i = 1, math.random(1, 3) do
    local mesh, warp, half = piece(cell, 0)
    z = z + half + 1.05 * thickness
    local middle = z
    mesh:map(function(x, y, w) return x, y, w + middle end)
    z = z + half
    bodies[i] = { name = "piece" .. i, mesh = mesh, card = card, warp = warp, points = 2 }
  end
  local m = fabric.model { bodies = bodies, membrane = tears and math.random() < 0.5 or nil }
  local held = tears and math.random() < 0.5
  for i, body in ipairs(tears and bodies or {}) do
    m:tearable(body.name .. ".all", { coarse = math.random() < 0.5 and "lower" or "keep", seed = seed })
    if held and i == 1 then m:fix(body.name .. ".left", "x y z"):fix(body.name .. ".right", "x y z") end
  end
  m:contact { self = "all", friction = friction, thickness = thickness }
  local balls, planes, rigid = {}, {}, {}
  for _ = 1, math.random(0, 2) do
    local r = between(1, 3) * cell
    z = z + r + 0.6 * thickness
    local ball = fabric.rigid.sphere { radius = r, centre = { between(-3, 3) * cell, between(-3, 3) * cell, z }, mass = 10 ^ between(-4.5, -2.5), name = "ball " .. #balls + 1 }
    z = z + r
    m:velocity(ball, { x = between(-0.2, 0.2) * fastest, y = between(-0.2, 0.2) * fastest, z = -between(0.2, 1) * fastest, spin = { between(-9e4, 9e4), 0, between(-9e4, 9e4) } })
    balls[#balls + 1], rigid[#rigid + 1] = { body = ball, radius = r }, ball
  end
  if math.random() < 0.6 then
    local floor_ = { point = { 0, 0, -0.01 * cell }, normal = { 0, 0, 1 } }
    planes[1], rigid[#rigid + 1] = floor_, fabric.rigid.plane { point = floor_.point, normal = floor_.normal, name = "floor" }
  end
  for _, body in ipairs(rigid) do m:contact { between = { body, "all" }, friction = friction, thickness = thickness } end
  -- The lowest piece flies up where there is no floor, the others down; all of them flutter.
  for i, body in ipairs(bodies) do
    local down = (i == 1 and #planes == 0) and -0.5 or 1
    local speed, wave, flutter = down * between(0.3, 1) * fastest, between(200, 1500), between(0, 0.5) * fastest
    local sway = between(-0.3, 0.3) * fastest
    m:velocity(body.name .. ".all", function(x, y) return { x = sway, y = flutter * math.sin(wave * x), z = -speed + flutter * math.cos(wave * y) } end)
  end
  -- A run looks at its ledger by shares of its duration, so that is what is to be run.
  local duration = 3 * (z + 2 * cell) / fastest
  if scheme == "explicit" then duration = math.min(duration, 160 * fabric.dynamic { model = m, duration = 1 }.step_size) end
  local run = fabric.dynamic { model = m, duration = duration, scheme = scheme, step = scheme == "implicit" and duration / 50 or nil }
  return run, brute.watch(tears and brute.apart(m.mesh) or m.mesh, balls, planes), duration
end

local sum = { looks = 0, steps = 0, passed = 0, stopped = 0, crashed = 0, touched = 0, guarded = 0, thick = 0, torn = 0, silent = 0 }
local words, worst = {}, { error = 0, seed = 0 }
local most = 400 -- looks at one scene
local function said(a, code)
  for _, warning in ipairs(a.warnings) do
    if warning.code == code then return true end
  end
end
local function run(seed)
  local ok, a, look, duration = pcall(throw, seed)
  if not ok then
    sum.crashed = sum.crashed + 1
    print("seed " .. seed .. ": " .. tostring(a))
    return true
  end
  local touched, guarded, looks, passed = false, false, 0, false
  local function see(r)
    sum.looks, looks = sum.looks + 1, looks + 1
    local found = look(r)
    if looks % 8 == 0 then
      local e = r.energy
      touched, guarded = touched or e.contact > 0 or e.friction > 0, guarded or e.guard > 0
    end
    if #found == 0 then return end
    sum.passed, passed = sum.passed + 1, true
    print(string.format("seed %d at %g s: %s (%d in all)", seed, r.time, found[1], #found))
  end
  local hooked = seed % 2 == 1
  if hooked then
    a:every("step", function(r)
      see(r)
      if looks >= most or passed then r:stop "long enough" end -- what is pressed hard goes on in small steps
    end)
  end
  local fine, trouble = pcall(function()
    if hooked then return a:advance(duration) end
    while a.time < duration and looks < most and not passed do see(a:step()) end
  end)
  if not fine then
    if tostring(trouble):find("ended by SIG", 1, true) or tostring(trouble):find("interrupted", 1, true) then
      return false -- told to end: what was done so far is told
    elseif type(trouble) == "table" and trouble.kind == "numerical" then
      sum.stopped = sum.stopped + 1
      local said = tostring(trouble):match "stopped at time [^:]*: ([^\n]*)" or tostring(trouble)
      local kind = said:gsub("%-?%d[%d%.e%-]*", "#"):gsub(", element #", "")
      words[kind] = (words[kind] or 0) + 1
    else
      sum.crashed = sum.crashed + 1
      print("seed " .. seed .. ": " .. tostring(trouble))
    end
  elseif a.time >= duration and a.energy.error > 1e-2 and not said(a, "ledger") then
    sum.silent = sum.silent + 1
    print(string.format("seed %d: the ledger is %.2g off, and nothing was said", seed, a.energy.error))
  end
  if tears and a.energy.fracture > 0 then sum.torn = sum.torn + 1 end
  if fine and a.time >= duration and a.energy.error > worst.error then -- those that were long enough before are under way
    worst = { error = a.energy.error, seed = seed }
  end
  if touched then sum.touched = sum.touched + 1 end
  if guarded then sum.guarded = sum.guarded + 1 end
  if seed % 3 == 0 then sum.thick = sum.thick + 1 end
  sum.steps = sum.steps + #a.steps
  return true
end
for seed = first, first + count - 1 do
  if not run(seed) then
    count = seed - first
    break
  end
  if count > 100 and (seed - first + 1) % 100 == 0 then
    io.stderr:write(string.format("%d scenes, %d looks, %d passed, %d stopped by themselves, %d crashed\n", seed - first + 1, sum.looks, sum.passed, sum.stopped, sum.crashed))
  end
end

print(string.format("%d scenes (%d thicker than an element), %d in which something touched, %d with the guard; %d steps, %d looks", count, sum.thick, sum.touched, sum.guarded,
  sum.steps, sum.looks))
print(string.format("%d passed, %d crashed, %d stopped by themselves; worst ledger of those that came to their end %.1e (seed %d)", sum.passed, sum.crashed, sum.stopped, worst.error, worst.seed))
if tears then print(sum.torn .. " tore; " .. sum.silent .. " with a ledger beyond 1e-2 and no word") end
for kind, n in pairs(words) do print(n .. " x " .. kind) end
fabric.expect {
  -- Crack faces that were hardly apart may overlap; nothing else passes.
  { "something has passed, share of the scenes", sum.passed / count, 0, absolute = tears and 0.02 or 0 },
  { "crashed", sum.crashed, 0, absolute = 0 },
  { "worst ledger", worst.error, 0, absolute = 0.05 }, -- beyond it a run stops by itself and says so
}
