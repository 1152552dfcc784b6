-- fabric.lab.tracks, poisson, shear_from_bias: evaluation of marker grids on the cloth.
local fabric = require "fabric"
local define = require "fabric.define"
local kernels = require "fabric.kernels"
local check = require "fabric.lab.common.check"
local origin = require "fabric.lab.card.origin"
local fail = define.fail

local nan = 0 / 0

local function column_named(file, path, name)
  for _, column in ipairs(file) do
    if column.name:lower() == name then return column.values end
  end
  fail(("tracks: %s:1: expected columns frame, marker, x, y; there is no '%s'"):format(path, name))
end

-- Frames in the order of their numbers, whatever the order of the rows.
local function places_of(frame)
  local numbers, place = {}, {}
  for _, f in ipairs(frame) do
    if f == f and not place[f] then numbers[#numbers + 1], place[f] = f, 0 end
  end
  table.sort(numbers)
  for i, f in ipairs(numbers) do place[f] = i - 1 end
  return numbers, place
end

local function tracks(t)
  local file = fabric.table { file = t.file, lenient = true } -- an invalid position is that of a lost marker
  local frame, marker = column_named(file, t.file, "frame"), column_named(file, t.file, "marker")
  local x, y = column_named(file, t.file, "x"), column_named(file, t.file, "y")
  local numbers, place = places_of(frame)
  local markers = t.rows * t.columns
  local out = { rows = t.rows, columns = t.columns, x = {}, y = {}, file = t.file, frames = #numbers, numbers = numbers }
  for i = 1, #numbers * markers do out.x[i], out.y[i] = nan, nan end
  for i = 1, #frame do
    if frame[i] ~= frame[i] or not (marker[i] >= 1 and marker[i] <= markers and marker[i] % 1 == 0) then
      fail(("tracks: %s: expected frames and markers 1 to %d in every row, got frame %g, marker %g in row %d"):format(t.file, markers, frame[i],
        marker[i], i))
    end
    local at = place[frame[i]] * markers + marker[i]
    out.x[at // 1 | 0], out.y[at // 1 | 0] = x[i], y[i]
  end
  return out
end

define {
  name = "fabric.lab.tracks",
  arguments = {
    { name = "file", kind = "text", sentence = "a table with columns frame, marker (from 1, row by row), x, y" },
    { name = "rows", kind = "integer", low = 2, sentence = "of markers, following each other along the pull" },
    { name = "columns", kind = "integer", low = 2, sentence = "of markers, across the pull" },
  },
  sentence = "Positions of a marker grid in a series of photographs: rows, columns, frames, their numbers in order, x, y; a marker without a row is lost (nan).",
  example = "local path = os.tmpname()\nlocal f = io.open(path, 'w') f:write 'frame,marker,x,y\\n1,1,0,0\\n1,2,1,0\\n1,3,0,1\\n1,4,1,1\\n2,1,0,0\\n' f:close()\n"
    .. "local t = require 'fabric'.lab.tracks{ file=path, rows=2, columns=2 }\nos.remove(path)\n"
    .. "assert(t.frames == 2 and t.x[2] == 1 and t.x[6] ~= t.x[6])",
  run = tracks,
}

define {
  name = "fabric.lab.poisson",
  arguments = {
    { name = "specimens", kind = "table", sentence = "marker grids: { {rows=, columns=, x=, y=}, ... } as of fabric.lab.tracks" },
    { name = "noise", kind = "number", low = 0, optional = true, sentence = "of a coordinate; default: from the scatter of each specimen" },
    { name = "seed", kind = "integer", low = 0, default = 1, sentence = "of the bootstrap" },
    { name = "common", kind = "number", low = 0, default = 0, sentence = "relative standard uncertainty that all share" },
  },
  retired = { "least", "level" },
  sentence = "The contraction ratio (eq. 3.3): one line through the origin per specimen with its boxes pooled, then the mean: value, "
    .. "low, high, variance, specimens { {value, plain, noise, uncertainty}, ... }.",
  example = "local s = { rows=2, columns=2, x={0,1,0,1, 0,0.95,0,0.95}, y={0,0,1,1, 0,0,1.2,1.2} }\n"
    .. "local p = require 'fabric'.lab.poisson{ specimens={s}, noise=0 }\nassert(math.abs(p.value - 0.04875/0.22) < 1e-12)",
  run = function(t)
    local out, values = { specimens = {} }, {}
    if #t.specimens == 0 then fail "poisson: field 'specimens': expected at least one marker grid, got none" end
    for i = 1, #t.specimens do
      local s = t.specimens[i]
      check.grid("poisson", ("specimens[%d]"):format(i), s)
      out.specimens[i] = fabric.lab.ratio { rows = s.rows, columns = s.columns, x = s.x, y = s.y, noise = t.noise, least = 0.01 }
      values[i] = { out.specimens[i].value }
    end
    local band = fabric.lab.band { specimens = values, level = 0.95, seed = t.seed, common = { t.common } }
    out.value = band.value[1]
    if band.low then out.low, out.high, out.variance = band.low[1], band.high[1], band.covariance[1] end
    origin.remember(out, { value = ("fitted to the markers of %d specimen%s"):format(#t.specimens, #t.specimens == 1 and "" or "s") })
    return out
  end,
}

-- Mean of a quantity over the boxes of zone 3, per frame.
local function zone_mean(boxes, name)
  local out = {}
  for f = 0, boxes.frames - 1 do
    local sum, n = 0, 0
    for b = 1, boxes.boxes do
      local value = boxes[name][f * boxes.boxes + b]
      if boxes.zones[b] == 3 and value == value then sum, n = sum + value, n + 1 end
    end
    out[f + 1] = n > 0 and sum / n or nan
  end
  return out
end

-- The frames of a list that are kept.
local function chosen(values, frames)
  local out = {}
  for i, f in ipairs(frames) do out[i] = values[f] end
  return out
end

local function shear_from_bias(t)
  local grid = t.markers
  local boxes = kernels.boxes { rows = grid.rows, columns = grid.columns, x = grid.x, y = grid.y, warp = t.warp }
  if #t.force ~= boxes.frames or #t.displacement ~= boxes.frames then
    fail(("shear_from_bias: %sfield 'force': expected a force and a displacement for each of %d frames, got %d and %d"):format(
      grid.file and grid.file .. ": " or "", boxes.frames, #t.force, #t.displacement))
  end
  local E, frames = zone_mean(boxes, "E12"), {}
  for f, value in ipairs(E) do
    if value == value then frames[#frames + 1] = f end -- a frame without the markers of the middle zone is skipped
  end
  if #frames < 2 then
    fail(("shear_from_bias: %sno box of the markers is seen sheared in two frames"):format(grid.file and grid.file .. ": " or ""))
  end
  local pull = fabric.lab.reduce {
    displacement = t.displacement, force = t.force, gauge_length = t.gauge_length, width = t.width, thickness = t.thickness,
    plies = t.plies, compliance = t.compliance, slip = t.slip,
  }
  for _, name in ipairs { "displacement", "E", "S" } do pull[name] = chosen(pull[name], frames) end
  local out = { E = chosen(E, frames), S = {}, zones = boxes.zones, frames = frames, pull = pull, file = grid.file,
                warp_stretch = chosen(zone_mean(boxes, "warp_stretch"), frames), weft_stretch = chosen(zone_mean(boxes, "weft_stretch"), frames) }
  for i = 1, #frames do out.E[i], out.S[i] = math.abs(out.E[i]), pull.S[i] / 2 end
  local displacement = chosen(t.displacement, frames)
  out.branches = fabric.lab.branches { displacement = displacement, tolerance = 0.01 * math.max(table.unpack(displacement)) }
  return out
end

define {
  name = "fabric.lab.shear_from_bias",
  arguments = {
    { name = "markers", kind = "table", sentence = "a marker grid, as of fabric.lab.tracks" },
    { name = "warp", kind = "number", unit = "degrees", default = 45, sentence = "from the x of the markers to the warp" },
    { name = "force", kind = "numbers", unit = "N", sentence = "at each frame" },
    { name = "displacement", kind = "numbers", unit = "m", sentence = "of the crosshead at each frame" },
    { name = "gauge_length", kind = "number", unit = "m", above = 0, sentence = "between the grips" },
    { name = "width", kind = "number", unit = "m", above = 0, sentence = "of the specimen" },
    { name = "thickness", kind = "number", unit = "m", above = 0, sentence = "of one ply" },
    { name = "plies", kind = "integer", low = 1, sentence = "layers that bear load" },
    { name = "compliance", kind = "number", unit = "m/N", low = 0, default = 0, sentence = "of the frame" },
    { name = "slip", kind = "number", unit = "m/N", low = 0, default = 0, sentence = "in the grips" },
  },
  sentence = "Shear from a bias pull: E (tensor E12 = lambda1 lambda2 cos(phi)/2 over the boxes of zone 3, eq. 3.16) and S (S12 = P/(2 "
    .. "A0 lambda), eq. 3.15) per frame in which that zone is seen (frames), zones of the boxes, warp_stretch, weft_stretch, branches: a test for fabric.lab.fit.",
  example = "local t = require 'fabric'.lab.shear_from_bias{ markers={ rows=2, columns=2, x={0,1,0,1, 0,0.9,0,0.9}, y={0,0,1,1, 0,0,1.1,1.1} },\n"
    .. "  force={0, 1}, displacement={0, 0.01}, gauge_length=0.1, width=0.02, thickness=5e-4, plies=1 }\n"
    .. "assert(math.abs(t.E[2] - (1.21 - 0.81)/4) < 1e-12 and t.zones[1] == 3)",
  run = shear_from_bias,
}
