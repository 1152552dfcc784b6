-- fabric.lab.synthetic: simulated measurements of a card's cloth, with scatter between specimens, slack, slip, compliance,
-- and noise of load, displacement and marker positions; for testing the evaluation with a known result.
local fabric = require "fabric"
local define = require "fabric.define"
local fail = define.fail
local random = require "fabric.lab.random"

-- Standard deviations: of a reading of the force, N, and of the displacement, m; of the load cell, relative, one for all specimens; of a
-- marker coordinate, m.
local force_noise, displacement_noise, load_cell_error, position_noise = 0.02, 2e-6, 0.003, 1e-5
local scatter, slackest = 0.03, 0.5e-3 -- of the moduli between specimens, relative; largest displacement before first contact, m
local pitch = 5e-3 -- m, between markers
local angles = { warp = 0, weft = 90, bias = 45 }

-- The card of a specimen: each curve and each ratio multiplied by a random factor of mean one.
local function scattered(t, draw)
  local function factor() return 1 + scatter * draw.normal() end
  local function part(p)
    local f, out = factor(), { loading = {}, unloading = p.unloading * factor() }
    for i, d in ipairs(p.loading) do out.loading[i] = d * f end
    out.poisson = p.poisson and p.poisson * factor()
    return out
  end
  local card = t.card
  return card:with { warp = part(card.warp), weft = part(card.weft), shear = part(card.shear) }
end

-- Strains along the pull: up to the tested one in equal steps of stretch and down again, to zero force.
local function history(t, reach)
  local E = {}
  local top = math.sqrt(1 + 2 * reach) - 1
  local function add(e) E[#E + 1] = e + e * e / 2 end
  for i = 1, t.rows do add(top * i / t.rows) end
  for i = 1, t.rows do add(top * (1 - i / t.rows)) end
  return E
end

-- E along a bias pull at which the shear reaches the tested one.
local function bias_reach(t)
  local point, E = fabric.point(t.card), 0
  repeat
    E = E + 0.01
    local s = point:uniaxial(45, E)
  until s.E12 >= t.card.tested.shear
  return E
end

local function response(t, card, reach)
  local columns = { "E11", "E22", "E12", "S", "E" }
  local r = fabric.point(card):uniaxial(t.direction == "bias" and 45 or t.direction, history(t, reach), columns)
  local rows = #r.S
  for i = t.rows + 1, #r.S do
    if r.S[i] <= 0 then
      rows = i - 1
      break
    end
  end
  return r, rows
end

-- Crosshead displacement and force in every row, beginning with the slack; and the index of the true row (0: not yet taut).
local function frame_record(t, r, rows, calibration, draw)
  local slack, slip = slackest * draw.uniform(), t.slip
  local length, area = t.gauge_length + slack, t.width * t.thickness * t.plies
  local record, largest = { displacement = {}, force = {}, row = {} }, 0
  local function add(u, P, row)
    local n = #record.force + 1
    record.displacement[n] = u + displacement_noise * draw.normal()
    record.force[n] = P * calibration + force_noise * draw.normal()
    record.row[n] = row
  end
  local step = length * (math.sqrt(1 + 2 * r.E[1]) - 1)
  for i = 0, slack // step do add(i * step, 0, 0) end
  for i = 1, rows do
    local stretch = math.sqrt(1 + 2 * r.E[i])
    local P = r.S[i] * area * stretch
    largest = math.max(largest, P)
    add(slack + length * (stretch - 1) + t.compliance * P + slip * largest, P, i)
  end
  record.slack = slack
  return record
end

-- The stretch tensor of the cloth in the photograph's axes (pull along y): the square root of C = 1 + 2E.
local function stretch_of(t, r, row)
  local c11, c22, c12 = 1, 1, 0
  if row > 0 then c11, c22, c12 = 1 + 2 * r.E11[row], 1 + 2 * r.E22[row], 2 * r.E12[row] end
  local det = math.sqrt(c11 * c22 - c12 * c12)
  local trace = math.sqrt(c11 + c22 + 2 * det)
  local u11, u22, u12 = (c11 + det) / trace, (c22 + det) / trace, c12 / trace
  local w = math.rad(90 - angles[t.direction]) -- angle of the warp to x
  local c, s = math.cos(w), math.sin(w)
  return c * c * u11 + s * s * u22 - 2 * c * s * u12, s * s * u11 + c * c * u22 + 2 * c * s * u12,
    c * s * (u11 - u22) + (c * c - s * s) * u12
end

-- Photographs at equal intervals of the record, the first one without load; and the machine's readings at these times.
local function photographs(t, r, record, draw)
  local grid = { rows = t.markers[1], columns = t.markers[2], x = {}, y = {} }
  local photo = { markers = grid, displacement = {}, force = {}, warp = 90 - angles[t.direction] }
  local pictures = {}
  for k = 0, t.photographs - 1 do pictures[#pictures + 1] = 1 + (k * (#record.row - 1)) // (t.photographs - 1) end
  for _, at in ipairs(pictures) do
    local xx, yy, xy = stretch_of(t, r, record.row[at])
    photo.displacement[#photo.displacement + 1], photo.force[#photo.force + 1] = record.displacement[at], record.force[at]
    for m = 0, grid.rows * grid.columns - 1 do
      local X, Y = (m % grid.columns) * pitch, (m // grid.columns) * pitch
      grid.x[#grid.x + 1] = xx * X + xy * Y + position_noise * draw.normal()
      grid.y[#grid.y + 1] = xy * X + yy * Y + position_noise * draw.normal()
    end
  end
  grid.frames = t.photographs
  return photo
end

local most_rows, most_markers = 10000000, 10000

local function synthetic(t)
  t.thickness = t.thickness or t.card.thickness
  t.markers = t.markers or { 5, 4 }
  if t.specimens * t.rows > most_rows then
    fail(("synthetic: field 'rows': expected at most %d for %d specimens (%d rows in all), got %d"):format(most_rows // t.specimens, t.specimens, most_rows, t.rows))
  end
  if t.markers[1] * (t.markers[2] or 1) > most_markers then
    fail(("synthetic: field 'markers': expected at most %d markers, got %g x %g"):format(most_markers, t.markers[1], t.markers[2] or 1))
  end
  local draw, out = random(t.seed), {}
  local calibration = 1 + load_cell_error * draw.normal() -- one load cell for all specimens
  local reach = t.reach or (t.direction == "bias" and bias_reach(t) or t.card.tested[t.direction])
  for i = 1, t.specimens do
    local r, rows = response(t, scattered(t, draw), reach)
    local record = frame_record(t, r, rows, calibration, draw)
    out[i] = { record = record, photographs = photographs(t, r, record, draw) }
  end
  return out
end

define {
  name = "fabric.lab.synthetic",
  arguments = {
    { name = "card", of = "card", sentence = "the card whose tests are made" },
    { name = "direction", kind = "text", choices = { "warp", "weft", "bias" }, default = "warp", sentence = "of the pull" },
    { name = "specimens", kind = "integer", low = 1, high = 10000, default = 5, sentence = "replicates" },
    { name = "seed", kind = "integer", low = 0, default = 1, sentence = "of all that is random" },
    { name = "rows", kind = "integer", low = 10, high = 1000000, default = 300, sentence = "of the record on the way up" },
    { name = "reach", kind = "number", above = 0, optional = true, sentence = "largest strain; default: as tested" },
    { name = "slip", kind = "number", unit = "m/N", low = 0, default = 0, sentence = "in the grips" },
    { name = "compliance", kind = "number", unit = "m/N", low = 0, default = 0, sentence = "of the frame" },
    { name = "markers", kind = "numbers", low = 2, optional = true, sentence = "{rows, columns}; default {5, 4}" },
    { name = "photographs", kind = "integer", low = 2, default = 60, sentence = "over the whole test" },
    { name = "gauge_length", kind = "number", unit = "m", above = 0, default = 76.2e-3, sentence = "between the grips" },
    { name = "width", kind = "number", unit = "m", above = 0, default = 25.4e-3, sentence = "of the specimen" },
    { name = "thickness", kind = "number", unit = "m", above = 0, optional = true, sentence = "default: the card's" },
    { name = "plies", kind = "integer", low = 1, default = 2, sentence = "layers that bear load" },
  },
  retired = { "force_noise", "calibration", "displacement_noise", "position_noise", "scatter", "slack", "pitch" },
  sentence = "Pulls of a card's cloth as a laboratory would have recorded them: a list of specimens {record={displacement, force}, "
    .. "photographs={markers, force, displacement, warp}}.",
  example = "local s = fabric.lab.synthetic{ card=fabric.card 'blend', specimens=1, rows=20 }\n"
    .. "assert(#s[1].record.force > 20 and s[1].photographs.markers.frames == 60)",
  run = synthetic,
}
