-- Implicit motion in steps of 1, 5 and 10 ms: scenes drawn at random. Cloth of the shipped cards or elastic, quadrilaterals, triangles or a distorted
-- mesh, one or two layers, a folded strip or a tube, falls on, is pressed by, is drawn over or hit by balls, rods, boxes, trunks and walls that stand,
-- are driven or fly. Each scene runs in a process of its own, so that one that ends without a word is told, too.
--
--   fabricsh scripts/contact/scenes.lua                  seven short ones
--   fabricsh scripts/contact/scenes.lua 101 25 60        25 scenes from number 101 on, each for 60 s of processor time at most
--   fabricsh scripts/contact/scenes.lua scene 17 60      one of them here, with all that its run says
--
-- After every step all edges of the cloth are held against all facets of cloth and bodies, and the edges of bodies against those of the cloth. The facets
-- are those of contact, which cuts quadrilaterals along their shorter reference diagonals; what shares a node or is sewn does not count. Cloth must not be
-- in balls, rods and closed surfaces nor behind walls. A driven body leaves several times the thickness of all layers to what stands opposite. Told is
-- what was done, went through, stopped with words, was cut by the clock, or ended with more than 5 % in the ledger.
local fabric = require "fabric"
local brute = dofile((arg[0]:gsub("[^/]*$", "brute.lua")))
local sub, dot, box, cuts, each_near = brute.sub, brute.dot, brute.box, brute.cuts, brute.each_near
local mm = fabric.units.mm
local longest = tonumber(arg[3] or 60) -- s, of processor time that a scene may take

local sqrt, sin, cos, pi, min, max, floor, abs = math.sqrt, math.sin, math.cos, math.pi, math.min, math.max, math.floor, math.abs
local function between(low, high) return low + (high - low) * math.random() end
local function chance(share) return math.random() < share end
local function pick(list) return list[math.random(#list)] end

-- --- what is drawn

local function cloth_card()
  local which = pick { "blend", "duck", "muslin", "denim", "elastic" }
  if which ~= "elastic" then
    local bending = chance(0.65) and "estimated" or "thickness"
    return fabric.card(which, { bending = bending }), which .. (bending == "estimated" and "" or " integrated")
  end
  local stiff, bending = 10 ^ between(6, 8), nil
  if chance(0.6) then
    local B = 10 ^ between(-6, -4.3)
    bending = { warp = B, weft = B * between(0.3, 1), twist = B * between(0.2, 0.5) }
  end
  return fabric.svk { young = stiff, poisson = between(0, 0.4), density = between(300, 900), thickness = between(0.25, 1) * mm, name = "elastic", bending = bending,
                      through_thickness = not bending or nil }, ("elastic %.1e"):format(stiff)
end

-- A flat panel about the origin; of a distorted one the inner nodes are moved by `shifts`.
local function panel(c)
  local w, h, i = c.nx * c.cell, c.ny * c.cell, 0
  local mesh = fabric.mesh.rectangle { width = w, height = h, nx = c.nx, ny = c.ny, triangles = c.elements == "triangles", origin = { -w / 2, -h / 2, 0 } }
  if c.shifts then
    mesh:map(function(x, y, z)
      i = i + 1
      if abs(x) > w / 2 - 1e-9 or abs(y) > h / 2 - 1e-9 then return x, y, z end
      return x + c.shifts[2 * i - 1] * c.cell, y + c.shifts[2 * i] * c.cell, z
    end)
  end
  return mesh
end

-- Straight, `turns` sides that turn by half a circle in all, and straight back: x and z at the length s.
local function fold(c)
  local sides, lower = 3, c.nx // 2 - 1
  return function(s)
    local x, z, left = 0, 0, s / c.cell
    local k = 0
    while left > 0 do
      local angle = k < lower and 0 or k < lower + sides and (k - lower + 0.5) * pi / sides or pi
      local part = min(1, left)
      x, z, left, k = x + part * c.cell * cos(angle), z + part * c.cell * sin(angle), left - part, k + 1
    end
    return x - lower * c.cell / 2, z
  end
end

-- The cloth of a scene: bodies for a model, what they are called, the room they take (z from 0 to top), and how thick all layers are.
local function cloth(kind, cell, most)
  local card, words = cloth_card()
  local out = { card = card, cell = cell, kind = kind, thick = card.thickness }
  local function counts(low, high)
    local nx, ny = math.random(low, high), math.random(low, high)
    while nx * ny > most and max(nx, ny) > low do nx, ny = max(low, nx - 1), max(low, ny - 1) end
    return nx, ny
  end
  local c = { cell = cell, elements = pick { "quadrilaterals", "triangles", "distorted" } }
  most = most / (c.elements == "triangles" and 2 or 1) / (kind == "layers" and 1.7 or 1)
  c.nx, c.ny = counts(4, 14)
  if kind == "folded" then c.nx = max(8, c.nx) end
  if kind == "tube" then c.ny = max(8, c.ny) end
  if c.elements == "distorted" then
    c.shifts = {}
    for i = 1, 2 * (c.nx + 1) * (c.ny + 1) do c.shifts[i] = between(-0.2, 0.2) end
  end
  out.words = ("%s, %s %d x %d %s of %.0f mm"):format(words, kind, c.nx, c.ny, c.elements, cell / mm)
  out.wide, out.deep = c.nx * cell, c.ny * cell
  local mesh = panel(c)
  local warp = pick { 0, 0, 90, 45, 20 }
  local body = { name = "low", mesh = mesh, card = card, warp = warp, points = pick { 1, 2, 3 } }
  out.bodies, out.layers, out.top = { body }, 1, 0
  if kind == "layers" then
    local d = { cell = cell * between(0.8, 1.25), elements = c.elements == "distorted" and "quadrilaterals" or c.elements }
    d.nx, d.ny = max(3, floor(c.nx * between(0.6, 1))), max(3, floor(c.ny * between(0.6, 1)))
    local other, also = card, ""
    if chance(0.3) then other, also = cloth_card() end
    local above, turn = (card.thickness + other.thickness) / 2 * 1.02 + (chance(0.5) and between(0, 3) * mm or 0), math.rad(between(-30, 30))
    if chance(0.3) then turn = 0 end
    local second = panel(d)
    second:map(function(x, y) return x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn), above end)
    out.bodies[2] = { name = "high", mesh = second, card = other, warp = pick { 0, 90, 45 }, points = 2 }
    out.layers, out.top, out.thick = 2, above, max(card.thickness, other.thickness)
    if also ~= "" then out.words = out.words .. " under " .. also end
  elseif kind == "folded" then
    local place = fold(c)
    local flat = chance(0.5) and not c.shifts
    if flat then body.reference = panel(c) else body.warp = { 0, 1, 0 } end
    mesh:map(function(x, y)
      local u, z = place(x + c.nx * cell / 2)
      return u, y, z
    end)
    out.layers, out.top, out.wide = 2, 2 * cell, out.wide / 2
    if flat then out.words = out.words .. ", flat at rest" end
  elseif kind == "tube" then
    local radius = cell / (2 * sin(pi / c.ny))
    body.warp = { 1, 0, 0 }
    local h = c.ny * cell
    mesh:map(function(x, y)
      local angle = 2 * pi * (y / h)
      return x, radius * sin(angle), radius * (1 - cos(angle))
    end)
    out.sewn, out.radius = true, radius
    out.layers, out.top, out.deep = 2, 2 * radius, 2 * radius
  end
  return out
end

-- Lying with its lowest point at z = 0; hung by its left edge at z = 0; or upright, a little tilted, above z = 0. Adds the box of where it is.
local function pose(c, scene)
  local hung, tilt = scene == "sweep", scene == "pile" and math.rad(between(-15, 15)) or nil
  local function turned(x, y, z)
    if hung or tilt then x, z = z, -x end
    if tilt then x, z = x * cos(tilt) - z * sin(tilt), x * sin(tilt) + z * cos(tilt) end
    return x, y, z
  end
  local all = {}
  for _, b in ipairs(c.bodies) do
    b.mesh:map(turned)
    if not b.reference and (hung or tilt) then
      local w = type(b.warp) == "table" and b.warp or { cos(math.rad(b.warp)), sin(math.rad(b.warp)), 0 }
      b.warp = { turned(w[1], w[2], w[3]) }
    end
    table.move(b.mesh.nodes, 1, #b.mesh.nodes, #all + 1, all)
  end
  local low, high = box(all)
  local up = hung and -high[3] or -low[3]
  for _, b in ipairs(c.bodies) do
    b.mesh:map(function(x, y, z) return x, y, z + up end)
  end
  c.low, c.high = { low[1], low[2], low[3] + up }, { high[1], high[2], high[3] + up }
  c.top = c.high[3]
end

-- A rigid shape of the half height `s`: its centre at {0, 0, 0}, how far it reaches up or down and aside, and the function that makes it there or elsewhere.
local function box_mesh(a, b, c, n, at)
  local nodes, elements, known = {}, {}, {}
  local function node(x, y, z)
    local key = ("%.4f %.4f %.4f"):format(x, y, z)
    if not known[key] then
      nodes[#nodes + 1] = { at[1] + a * x, at[2] + b * y, at[3] + c * z }
      known[key] = #nodes
    end
    return known[key]
  end
  local function side(place)
    for i = 0, n - 1 do
      for k = 0, n - 1 do
        local quad = {}
        for j, p in ipairs { { i, k }, { i + 1, k }, { i + 1, k + 1 }, { i, k + 1 } } do quad[j] = node(place(2 * p[1] / n - 1, 2 * p[2] / n - 1)) end
        elements[#elements + 1] = quad
      end
    end
  end
  side(function(u, v) return u, v, 1 end)
  side(function(u, v) return v, u, -1 end)
  side(function(u, v) return 1, u, v end)
  side(function(u, v) return -1, v, u end)
  side(function(u, v) return v, 1, u end)
  side(function(u, v) return u, -1, v end)
  return fabric.mesh { nodes = nodes, elements = elements }
end

local function shape(kind, s, across)
  local d = { kind = kind, half = s, aside = s }
  local turn = between(0, 2 * pi)
  if kind == "rod" then
    local long = across * between(0.5, 1)
    local ux, uy = cos(turn) * long, sin(turn) * long
    d.aside = long + s
    d.ends = { { -ux, -uy, 0 }, { ux, uy, 0 } }
  elseif kind == "punch" then
    local long = s * between(1, 3)
    d.half, d.aside = s + long, s
    d.ends = { { 0, 0, -long }, { 0, 0, long } }
  elseif kind == "box" then
    local a, b, n = s * between(0.7, 2), s * between(0.7, 2), math.random(1, 3)
    d.aside, d.closed = sqrt(a * a + b * b), true
    d.facets = function(at)
      local mesh = box_mesh(a, b, s, n, { 0, 0, 0 })
      mesh:map(function(x, y, z) return at[1] + x * cos(turn) - y * sin(turn), at[2] + x * sin(turn) + y * cos(turn), at[3] + z end)
      return mesh
    end
  end
  d.radius = s
  function d.make(at, name, mass)
    d.at, d.name = at, name
    if kind == "ball" then
      d.body = fabric.rigid.sphere { radius = s, centre = at, mass = mass, name = name }
    elseif d.ends then
      local function moved(p) return { at[1] + p[1], at[2] + p[2], at[3] + p[3] } end
      d.body = fabric.rigid.cylinder { radius = s, from = moved(d.ends[1]), to = moved(d.ends[2]), mass = mass, name = name }
    elseif kind == "egg" then
      local sections = { { -0.6 * s, 0.8 * s, 0.6 * s }, { 0, s, 0.8 * s }, { 0.6 * s, 0.7 * s, 0.7 * s } }
      d.closed = true
      d.body, d.mesh = fabric.rigid.torso { sections = sections, from = at, around = 12, name = name }
    else
      d.mesh = d.facets(at)
      d.body = fabric.rigid.surface { mesh = d.mesh, closed = true, mass = mass, name = name }
    end
    return d
  end
  if kind == "egg" then d.half = 1.5 * s end
  return d
end

-- From 0 to 1 between two times, with the speed of a sine.
local function smooth(t, from, to) return (1 - cos(pi * max(0, min(1, (t - from) / (to - from))))) / 2 end

-- --- scenes: each places bodies about the cloth, and holds and moves it. s.add(body) takes a body into the scene.

local scenes = {}
local function wall_at(z, name) return { kind = "wall", name = name, at = { 0, 0, z }, normal = { 0, 0, 1 }, body = fabric.rigid.plane { point = { 0, 0, z }, normal = { 0, 0, 1 }, name = name } } end
local solid = { "ball", "rod", "box", "punch", "egg" }

-- Clear of the cloth that starts at z = 0 and above: the gap of contact and something.
local function clear(c) return c.thick / 2 + 0.06 * c.cell + between(0.3, 12) * mm end

local function stand_below(s, c, count, room)
  local top = -clear(c)
  for i = 1, count do
    local size = c.cell * between(0.5, 4)
    local d = shape(pick(solid), size, c.wide / 2)
    s.add(d.make({ between(-0.5, 0.5) * c.wide, between(-0.5, 0.5) * c.deep, top - d.half - (i > 1 and between(0, room) or 0) }, "below " .. i))
  end
end

function scenes.fall(s, c)
  if chance(0.8) then stand_below(s, c, math.random(1, 3), 2 * c.cell) else s.floor_needed = true end
  if s.floor_needed or chance(0.5) then s.add(wall_at(-clear(c) - (s.floor_needed and 0 or between(2, 15) * c.cell), "floor")) end
  s.speed, s.gravity = between(0, 2), true
end

function scenes.press(s, c)
  local under, top = pick { "wall", "ball", "rod", "box" }, -clear(c)
  if under == "wall" then
    s.add(wall_at(top, "floor"))
  else
    local d = shape(under, c.cell * between(1.5, 4), c.wide / 2)
    s.add(d.make({ 0, 0, top - d.half }, "anvil"))
    if chance(0.5) then s.add(wall_at(top - between(1, 2) * d.half, "floor")) end
  end
  local tool = shape(pick(solid), c.cell * between(1, 4), c.wide / 2)
  local start = c.top + clear(c) + tool.half
  s.add(tool.make({ between(-0.3, 0.3) * c.wide, between(-0.3, 0.3) * c.deep, start }, "tool"))
  local left = top + c.layers * c.thick * between(5, 9) + 2 * mm + (c.radius and between(0.4, 1) * c.radius or c.kind == "folded" and c.cell or 0)
  local way, T = start - tool.half - left, s.duration
  local ends, back, aside = T * between(0.4, 0.9), chance(0.4), chance(0.4) and between(-0.3, 0.3) * c.wide or 0
  s.drive(tool, { z = function(t) return -way * smooth(t, 0.02 * T, back and ends / 2 or ends) + (back and way * smooth(t, ends / 2, T) or 0) end,
                  x = aside ~= 0 and function(t) return aside * smooth(t, ends / 2, T) end or nil })
end

function scenes.pull(s, c)
  stand_below(s, c, math.random(1, 3), c.cell)
  if chance(0.4) then s.add(wall_at(-between(5, 15) * c.cell, "floor")) end
  if chance(0.4) then
    local ball = shape("ball", c.cell * between(0.7, 2))
    s.add(ball.make({ between(-0.3, 0.3) * c.wide, between(-0.3, 0.3) * c.deep, c.top + clear(c) + ball.half }, "ball", 10 ^ between(-3, -1.5)))
  end
  local far, up, T = between(0.2, 0.8) * c.wide, between(0, 0.2) * c.wide, s.duration
  s.model_of = function(m)
    m:move("low.right", { x = function(t) return far * smooth(t, 0.1 * T, 0.95 * T) end, y = 0, z = function(t) return up * smooth(t, 0.1 * T, 0.6 * T) end })
  end
  s.gravity = true
end

function scenes.throw(s, c)
  local held = pick { "left", "corners", "ends", "none" }
  if c.kind == "tube" then held = pick { "left", "ends", "none" } end
  s.model_of = function(m)
    if held == "left" then m:fix("low.left", "x y z") end
    if held == "corners" then m:fix("low.corners", "x y z") end
    if held == "ends" then m:fix("low.left", "x y z"):fix("low.right", "x y z") end
  end
  local boxes = chance(0.4)
  if not boxes and chance(0.6) then s.add(wall_at(-clear(c) - between(0, 10) * c.cell, "floor")) end
  local z = c.top + clear(c)
  for i = 1, math.random(1, 3) do
    local kind = boxes and i == 1 and "box" or "ball"
    local d = shape(kind, c.cell * between(0.7, 2.5), c.wide / 2)
    z = z + max(d.half, d.aside)
    -- Away from what is held: nodes that give no way would have to stop the body by contact alone.
    local off = held == "none" and 1 or 0.3
    s.add(d.make({ off * between(-0.4, 0.4) * c.wide, off * between(-0.4, 0.4) * c.deep, z }, kind .. " " .. i, 10 ^ between(-3.3, -1.5)))
    z = z + max(d.half, d.aside) + 1 * mm
    local turning = chance(0.5) and between(-720, 720) or 0
    s.fly[#s.fly + 1] = { d, { x = between(-0.5, 0.5), y = between(-0.5, 0.5), z = -between(0.2, 3), spin = { turning, 0, turning } } }
  end
  s.words = "held " .. held
end

-- Hung by an edge; what is driven comes from the side, and goes back.
function scenes.sweep(s, c)
  s.hung, s.gravity = true, true
  local d, wide = shape(pick(solid), c.cell * between(1, 3.5), c.deep / 3), -c.low[3]
  local off = c.high[1] + clear(c) + d.aside
  s.add(d.make({ off, between(-0.3, 0.3) * c.deep, min(-wide * between(0.4, 0.9), -d.half - 2.5 * c.cell) }, "arm"))
  local way, T, turning = off + between(-0.1, 0.35) * wide, s.duration, chance(0.4) and between(-180, 180) or nil
  local aside, back = chance(0.3) and between(-0.4, 0.4) * c.deep or nil, chance(0.5)
  s.drive(d, { x = function(t) return -way * smooth(t, 0, 0.5 * T) + (back and way * smooth(t, 0.5 * T, T) or 0) end,
               y = aside and function(t) return aside * smooth(t, 0.3 * T, T) end or nil,
               turn = turning and { axis = { 0, 0, 1 }, angle = function(t) return turning * smooth(t, 0, T) end } or nil })
end

-- Held at two ends, one of which turns; a tube around a rod.
function scenes.twist(s, c)
  local high = c.radius or 0
  local lever, T = max(c.deep / 2, high), s.duration
  local angle = min(120, math.deg(2 * math.asin(min(0.95, 0.13 * c.wide / lever))) * between(0.5, 1.5))
  s.model_of = function(m)
    m:fix("low.left", "x y z")
    m:turn("low.right", { axis = { 1, 0, 0 }, angle = function(t) return angle * smooth(t, 0, 0.9 * T) end, centre = { 0, 0, high } })
  end
  if c.radius then
    local rod = shape("rod", c.radius * between(0.3, 0.75), c.wide)
    rod.ends = { { -0.4 * c.wide, 0, 0 }, { 0.4 * c.wide, 0, 0 } }
    s.add(rod.make({ 0, 0, c.radius }, "core"))
  else
    s.add(wall_at(-lever * 1.05 - clear(c), "floor"))
  end
end

-- On a floor, pushed together from an edge, so that it buckles and folds.
function scenes.gather(s, c)
  s.add(wall_at(-clear(c), "floor"))
  local far, T = between(0.2, 0.6) * c.wide, s.duration
  s.model_of = function(m)
    m:fix("low.left", "x y z")
    m:move("low.right", { x = function(t) return -far * smooth(t, 0.05 * T, 0.95 * T) end, y = 0, z = 0 })
  end
  if chance(0.5) then
    local ball = shape("ball", c.cell * between(0.7, 2))
    s.add(ball.make({ 0, between(-0.3, 0.3) * c.deep, c.top + clear(c) + ball.half }, "ball", 10 ^ between(-3, -2)))
  end
  s.gravity = true
end

-- Upright, dropped on a floor, perhaps beside something that stands there: crumples.
function scenes.pile(s, c)
  s.gravity, s.speed = true, between(0, 1.5)
  local low = -clear(c)
  s.add(wall_at(low, "floor"))
  if chance(0.5) then
    local d = shape(pick { "ball", "rod", "box", "egg" }, c.cell * between(0.7, 2), c.deep / 2)
    s.add(d.make({ c.high[1] + clear(c) + d.aside, between(-0.2, 0.2) * c.deep, low + d.half }, "beside"))
  end
end

local kinds_of_scenes = { "fall", "press", "pull", "throw", "sweep", "twist", "gather", "pile" }

-- The scene of a number: a run, and what has to be looked at.
local function drawn(number)
  math.randomseed(number)
  for _ = 1, 8 do math.random() end
  local s = { parts = {}, fly = {}, driven = {}, number = number }
  s.step = ({ 1, 5, 10 })[number % 3 + 1] * 1e-3
  s.scene = kinds_of_scenes[(number // 3) % #kinds_of_scenes + 1]
  s.duration = s.step * math.random(({ 60, 40, 30 })[number % 3 + 1], ({ 160, 100, 80 })[number % 3 + 1])
  local form = pick { "sheet", "sheet", "layers", "folded", "tube" }
  if s.scene == "twist" and form == "folded" then form = "sheet" end
  local c = cloth(form, between(5, 22) * mm, chance(0.1) and 400 or 110)
  s.cloth = c
  function s.add(d)
    s.parts[#s.parts + 1] = d
    return d
  end
  function s.drive(d, motion) s.driven[#s.driven + 1], d.motion = { d, motion }, motion end
  s.gravity = chance(0.85)
  pose(c, s.scene)
  scenes[s.scene](s, c)
  local m = fabric.model { bodies = c.bodies }
  if c.sewn then m:seam { "low.top", "low.bottom" } end
  local rub, own = chance(0.2) and 0 or between(0, 0.6), chance(0.3) and 0 or between(0, 0.6)
  s.friction = rub
  m:contact { self = "all", friction = own }
  for i, d in ipairs(s.parts) do
    m:contact { between = { d.body, "all" }, friction = rub }
    for k = 1, i - 1 do
      local e = s.parts[k]
      local function flies(p)
        for _, f in ipairs(s.fly) do if f[1] == p then return true end end
        return p.name == "ball"
      end
      if (d.kind == "ball" and flies(d) or e.kind == "ball" and flies(e)) then m:contact { between = { e.body, d.body } } end
    end
  end
  for _, f in ipairs(s.fly) do m:velocity(f[1].body, f[2]) end
  for _, f in ipairs(s.driven) do m:move(f[1].body, f[2]) end
  if s.hung then m:fix("low.left", "x y z") end
  if s.model_of then s.model_of(m) end
  if s.gravity then m:gravity { 0, 0, -9.81 } end
  local held = s.hung or s.scene == "twist" or s.scene == "gather" or s.scene == "pull" or (s.words and s.words ~= "held none")
  if not held or chance(0.3) then
    local speed, ripple, wave, sway = s.speed or between(0, 0.5), chance(0.5) and between(0, 0.6) or 0, between(10, 80), between(-0.4, 0.4)
    local function velocity(x, y, z) return { x = sway, y = ripple * sin(wave * x), z = -speed + ripple * cos(wave * y + 20 * z) } end
    for _, b in ipairs(c.bodies) do
      if not held then m:velocity(b.name .. ".all", velocity)
      elseif b.name == "high" then m:velocity("high.all", { z = -0.1 }) end
    end
  end
  local damping = chance(0.3) and 0 or between(1, 30)
  s.text = ("%s, %s"):format(s.scene, c.words)
  for _, d in ipairs(s.parts) do s.text = s.text .. ", " .. d.kind .. (d.motion and " driven" or "") end
  s.text = s.text .. (s.words and ", " .. s.words or "") .. (", friction %.2f, damping %.0f"):format(rub, damping)
  s.model = m
  s.run = fabric.dynamic { model = m, duration = s.duration, scheme = "implicit", step = s.step, damping = damping > 0 and { mass = damping } or nil }
  return s
end

-- --- what has passed

-- Facets as contact cuts them. Sheets of one kind of cloth are a surface: those that are as thick and heavy, also of two cards.
local function facets_of_cloth(run, bodies)
  local mesh, at = run.mesh, run:field "reference"
  local centre, surfaces, first, facets = brute.middle(at), {}, 0, {}
  for i, b in ipairs(bodies) do
    if not (i > 1 and b.card.thickness == bodies[1].card.thickness) then surfaces[#surfaces + 1] = { nodes = at, elements = {} } end
    table.move(mesh.elements, first + 1, first + #b.mesh.elements, #surfaces[#surfaces].elements + 1, surfaces[#surfaces].elements)
    first = first + #b.mesh.elements
  end
  for _, surface in ipairs(surfaces) do
    for _, t in ipairs(brute.triangles(surface, centre)) do facets[#facets + 1] = t end
  end
  return facets
end

local function number_at(motion, name, t)
  local f = motion and motion[name]
  return type(f) == "function" and f(t) or f or 0
end

local function watch(s)
  local run, c = s.run, s.cloth
  local facets = facets_of_cloth(run, c.bodies)
  local edges, place = brute.edges(facets), {}
  for i = 1, #run.mesh.nodes do place[i] = i end
  if c.sewn then
    local one, two = run.mesh:set "low.bottom", run.mesh:set "low.top"
    for i = 1, #one do place[two[i]] = one[i] end
  end
  for _, d in ipairs(s.parts) do
    if d.mesh then
      d.facets_ = brute.triangles(d.mesh)
      d.edges_ = brute.edges(d.facets_)
    end
  end
  local function shares(e, f)
    for i = 1, 2 do
      for k = 1, 3 do
        if place[edges[e][i]] == place[facets[f][k]] then return true end
      end
    end
  end
  return function()
    local x, found = run:field "position", {}
    local function tell(...) found[#found + 1] = string.format(...) end
    each_near(x, edges, x, facets, c.cell, function(e, f)
      local t = facets[f]
      if not shares(e, f) and cuts(x[edges[e][1]], x[edges[e][2]], x[t[1]], x[t[2]], x[t[3]]) then
        tell("the edge of nodes %d, %d goes through the facet of nodes %d, %d, %d", edges[e][1], edges[e][2], t[1], t[2], t[3])
      end
    end)
    for _, d in ipairs(s.parts) do
      if d.kind == "wall" then
        for i, p in ipairs(x) do
          if not (dot(sub(p, d.at), d.normal) > 0) then tell("node %d is behind the %s", i, d.name) end
        end
      elseif d.mesh then
        local on = run:on_body(d.body)
        local y = {}
        for i = 1, #on.x do y[i] = { on.x[i], on.y[i], on.z[i] } end
        each_near(x, edges, y, d.facets_, c.cell, function(e, f)
          local t = d.facets_[f]
          if cuts(x[edges[e][1]], x[edges[e][2]], y[t[1]], y[t[2]], y[t[3]]) then tell("the edge of nodes %d, %d goes through the %s", edges[e][1], edges[e][2], d.name) end
        end)
        each_near(y, d.edges_, x, facets, c.cell, function(e, f)
          local t = facets[f]
          if cuts(y[d.edges_[e][1]], y[d.edges_[e][2]], x[t[1]], x[t[2]], x[t[3]]) then tell("an edge of the %s goes through the facet of nodes %d, %d, %d", d.name, t[1], t[2], t[3]) end
        end)
        local low, high = box(y)
        for i, p in ipairs(x) do
          if p[1] > low[1] and p[1] < high[1] and p[2] > low[2] and p[2] < high[2] and p[3] > low[3] and p[3] < high[3] and brute.encloses(y, d.facets_, p) then
            tell("node %d is inside the %s", i, d.name)
          end
        end
      else
        local ox, oy, oz = run:body(d.body)
        local p, q = { ox, oy, oz }, nil
        if d.ends then
          local turn = d.motion and d.motion.turn
          local angle = turn and math.rad(turn.angle(run.time)) or 0 -- about z
          local function at(v)
            return { d.at[1] + v[1] * cos(angle) - v[2] * sin(angle) + number_at(d.motion, "x", run.time), d.at[2] + v[1] * sin(angle) + v[2] * cos(angle) + number_at(d.motion, "y", run.time),
                     d.at[3] + v[3] + number_at(d.motion, "z", run.time) }
          end
          p, q = at(d.ends[1]), at(d.ends[2])
        end
        for _, t in ipairs(facets) do
          local a, b, e = x[t[1]], x[t[2]], x[t[3]]
          local away = false
          for k = 1, 3 do
            local l, h = min(p[k], (q or p)[k]) - d.radius, max(p[k], (q or p)[k]) + d.radius
            away = away or max(a[k], b[k], e[k]) < l or min(a[k], b[k], e[k]) > h
          end
          if not away then
            local distance = q and brute.of_rod(p, q, a, b, e) or brute.of_point(p, a, b, e)
            if not (distance > d.radius) then tell("the facet of nodes %d, %d, %d is %g m inside the %s", t[1], t[2], t[3], d.radius - distance, d.name) end
          end
        end
      end
    end
    return found
  end
end

-- --- one scene, here

local function first_line(trouble) return (tostring(trouble):match "^[^\n]*" or ""):sub(1, 300) end

local function played(number)
  local r = { number = number, outcome = "done", words = "" }
  local ok, s = pcall(drawn, number)
  if not ok then
    r.outcome, r.words = "refused", first_line(s)
    return r
  end
  r.text, r.step, r.duration, r.scene = s.text, s.step, s.duration, s.scene
  local look, found = watch(s), {}
  local run = s.run
  local fine, trouble = pcall(function()
    found = look()
    while run.time < s.duration and #found == 0 do
      run:step()
      found = look()
      if os.clock() > longest then
        r.outcome, r.words = "cut", ("at %g s"):format(run.time)
        break
      end
    end
  end)
  if #found > 0 then
    r.outcome, r.words = "through", ("at %g s: %s, %d in all"):format(run.time, found[1], #found)
  elseif not fine and type(trouble) == "table" and trouble.kind == "numerical" then
    r.outcome, r.words = "stopped", first_line(trouble)
  elseif not fine then
    r.outcome, r.words = "crashed", first_line(trouble)
  end
  local iterations, cut = 0, 0
  for _, t in ipairs(run.steps) do iterations, cut = iterations + t.iterations, cut + t.cuts end
  local e = run.energy
  if r.outcome == "done" and not (e.error <= 0.05) then r.outcome, r.words = "ledger", ("%.2g"):format(e.error) end
  local codes = {}
  for _, w in ipairs(run.warnings) do codes[w.code] = (codes[w.code] or 0) + 1 end
  local said = {}
  for code in pairs(codes) do said[#said + 1] = code end
  table.sort(said)
  r.time, r.steps, r.iterations, r.cuts, r.error, r.clock, r.codes = run.time, #run.steps, iterations, cut, e.error, os.clock(), table.concat(said, " ")
  r.touched = e.contact > 0 or e.friction > 0 or e.impact > 0
  return r
end

if arg[1] == "scene" then
  local r, parts = played(tonumber(arg[2])), {}
  for name, value in pairs(r) do parts[#parts + 1] = ("%s = %s"):format(name, type(value) == "string" and ("%q"):format(value):gsub("\n", "n") or tostring(value)) end
  table.sort(parts)
  print("scene{ " .. table.concat(parts, ", ") .. " }")
  return
end

-- --- a list of them

local first, count = tonumber(arg[1]), tonumber(arg[2] or 1)
local numbers = { 5, 6, 17, 25, 82, 95, 106, 445 } -- a few seconds each
if first then
  numbers = {}
  for k = first, first + count - 1 do numbers[#numbers + 1] = k end
end
if fabric.checking() then
  drawn(numbers[1])
  return
end

local function line(r)
  local head = ("%4d %-8s"):format(r.number, r.outcome)
  if not r.steps then return head .. r.words .. (r.text and " (" .. r.text .. ")" or "") end
  return ("%s %2.0f ms, %.2f of %.2f s, %d steps of %.1f iterations, %d cut, ledger %.1e, %.1f s%s: %s%s"):format(head, 1e3 * r.step, r.time, r.duration, r.steps,
    r.iterations / max(1, r.steps), r.cuts, r.error, r.clock, r.codes ~= "" and " (" .. r.codes .. ")" or "", r.text, r.words ~= "" and ": " .. r.words or "")
end

local program = 0
while arg[program - 1] do program = program - 1 end
local tally, by_step, touched, clock = {}, {}, 0, 0
for _, k in ipairs(numbers) do
  local pipe = assert(io.popen(("'%s' --quiet --threads 1 '%s' scene %d %g 2>/dev/null"):format(arg[program], arg[0], k, longest)))
  local text = pipe:read "a"
  local _, how, code = pipe:close()
  local r
  local told = text:match "scene(%b{})"
  if told then r = load("return " .. told, "scene", "t", { inf = math.huge, nan = 0 / 0 })() else r = { number = k, outcome = "crashed", words = ("%s %s"):format(how, code) } end
  if told and not (how == "exit" and code == 0) then r.outcome, r.words = "crashed", ("%s %s after its end"):format(how, code) end
  print(line(r))
  io.stdout:flush()
  tally[r.outcome] = (tally[r.outcome] or 0) + 1
  local key = r.step and ("%.0f ms"):format(1e3 * r.step) or "?"
  by_step[key] = by_step[key] or { n = 0, steps = 0, iterations = 0, cuts = 0, clock = 0 }
  local row = by_step[key]
  row.n, row[r.outcome] = row.n + 1, (row[r.outcome] or 0) + 1
  for _, name in ipairs { "steps", "iterations", "cuts", "clock" } do row[name] = row[name] + (r[name] or 0) end
  if r.touched then touched = touched + 1 end
  clock = clock + (r.clock or 0)
end

local outcomes = { "done", "through", "stopped", "cut", "ledger", "refused", "crashed" }
print(("\n| step | scenes | %s | iterations a step | steps cut | processor time, s |"):format(table.concat(outcomes, " | ")))
local keys = {}
for key in pairs(by_step) do keys[#keys + 1] = key end
table.sort(keys)
for _, key in ipairs(keys) do
  local row, cells = by_step[key], {}
  for i, o in ipairs(outcomes) do cells[i] = row[o] or 0 end
  print(("| %s | %d | %s | %.1f | %d | %.0f |"):format(key, row.n, table.concat(cells, " | "), row.iterations / max(1, row.steps), row.cuts, row.clock))
end
print(("%d scenes, in %d something touched; %.0f s"):format(#numbers, touched, clock))
local n = #numbers
fabric.expect {
  { "through", tally.through or 0, 0, absolute = 0 },
  { "refused or crashed", (tally.refused or 0) + (tally.crashed or 0), 0, absolute = 0 },
  { "ledger beyond its limit without a stop, share of the scenes", (tally.ledger or 0) / n, 0, absolute = 0.02 },
  { "stopped, share of the scenes", (tally.stopped or 0) / n, 0, absolute = 0.02 },
}
