-- Photographs from the side of a deck: a region of interest, and speckles correlated into displacements, strains, a ratio and a shear.
local fabric = require "fabric"
local lab = fabric.lab
local here = os.tmpname()
os.remove(here)
assert(os.execute("mkdir '" .. here .. "'"))
local function close(got, want, absolute, what)
  assert(math.abs(got - want) <= absolute, ("%s: %g, want %g within %g"):format(what or "value", got, want, absolute))
end
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails
local function file(name) return here .. "/" .. name .. ".png" end

-- Four dots in a region, where the whole picture holds six: they are found at the same places, and the rest is not looked at.
for i, stretch in ipairs { 1, 1.05 } do
  lab.photograph { file = file("dots" .. i), rows = 3, columns = 2, pitch = 40, radius = 6, width = 160, height = 200, F = { 1, 0, 0, stretch } }
end
local files = { file "dots1", file "dots2" }
local whole = lab.track { files = files, rows = 3, columns = 2 }
fails("expected 4 dots on the first photograph, found 6", lab.track, { files = files, rows = 2, columns = 2 })
local lower = lab.track { files = files, rows = 2, columns = 2, region = { top = 80 } }
local seen = 2e-3 -- pixels: another threshold takes other pixels around a dot, whose noise moves its middle by 0.005
for i = 1, 4 do
  close(lower.x[i], whole.x[i], seen, "x of dot " .. i)
  close(lower.y[i], whole.y[i], seen, "y of dot " .. i)
  close(lower.y[4 + i], whole.y[6 + i], seen, "y of dot " .. i .. " later")
end
fails("track: field 'region.right': expected a pixel of the photograph, 160 at most, got 161", lab.track, { files = files, rows = 2, columns = 2, region = { right = 161 } })
fails("track: field 'region.bottom': expected more than top, 90, got 80", lab.track, { files = files, rows = 2, columns = 2, region = { top = 90, bottom = 80 } })

-- Speckles that are pulled along y and turn a little: strains of every subset, the ratio as from markers, and shear off the axes.
local size = { width = 260, height = 240 }
local function speckled(name, F, shift, noise)
  local t = { file = file(name), F = F, shift = shift, noise = noise, seed = #name }
  for k, v in pairs(size) do t[k] = v end
  lab.speckles(t)
  return t.file
end
local series, maps = { speckled("s", nil, nil, 0.01) }, {}
for i = 1, 4 do
  local along, across, turn = 1 + 0.03 * i, 1 - 0.01 * i, 0.02 * i
  local c, s = math.cos(turn), math.sin(turn)
  maps[i] = { along = (along ^ 2 - 1) / 2, across = (across ^ 2 - 1) / 2 }
  series[i + 1] = speckled("s" .. ("x"):rep(i), { c * across, -s * along, s * across, c * along }, { 2.3 * i, 1.1 * i }, 0.01)
end
local t = lab.correlate { files = series, region = { left = 40, right = 220, top = 40, bottom = 200 }, scale = 1e-4 }
local n = t.rows * t.columns
assert(t.frames == 5 and #t.x == 5 * n and #t.E22 == 5 * n and t.found[1] == 1, n)
for f = 1, 4 do
  assert(t.found[f + 1] > 0.95, t.found[f + 1])
  local sum = { E11 = 0, E22 = 0, E12 = 0 }
  local seen = 0
  for k = f * n + 1, (f + 1) * n do
    if t.E11[k] == t.E11[k] then
      seen = seen + 1
      for name in pairs(sum) do sum[name] = sum[name] + t[name][k] end
      close(t.E22[k], maps[f].along, 2e-3, "E22 of a subset")
    end
  end
  close(sum.E22 / seen, maps[f].along, 1e-4, "mean E22")
  close(sum.E11 / seen, maps[f].across, 1e-4, "mean E11")
  close(sum.E12 / seen, 0, 1e-4, "mean E12")
end
close(t.y[n] - t.y[1], (t.rows - 1) * 12e-4, 1e-12, "y goes upwards")
assert(t.deviation[2 * n] > 2e-7 and t.deviation[2 * n] < 3e-6, t.deviation[2 * n])
local ratio = lab.poisson { specimens = { t } }
close(ratio.value, -maps[4].across / maps[4].along, 0.01, "the ratio from speckles")
local g = 0.1
local shear = lab.correlate { files = { series[1], speckled("g", { 1, g, 0, 1 }, nil, 0.01) }, region = { left = 40, right = 220, top = 40, bottom = 200 } }
local middle = n + (t.rows // 2) * t.columns + t.columns // 2
close(shear.E12[middle], g / 2, 1e-3, "E12, y upwards")
close(shear.E22[middle], g ^ 2 / 2, 1e-3, "E22 beside it")
-- A shift beyond the search is lost, in steps it is followed.
fails("no subset is found again on any photograph", lab.correlate, { files = { series[1], speckled("far", nil, { 60, 0 }) }, search = 10 })
local far = lab.correlate { files = { series[1], speckled("f1", nil, { 15, 0 }), speckled("f2", nil, { 30, 0 }), speckled("f3", nil, { 45, 0 }) },
  region = { left = 20, right = 180 } }
close(far.x[#far.x] - far.x[far.rows * far.columns], 45, 0.01, "followed in steps")
fails("field 'subset': expected an odd number of pixels, which has a middle, got 24", lab.correlate, { files = series, subset = 24 })
fails("expected a region of at least 25 x 25 pixels, one subset, got 21 x 232", lab.correlate, { files = series, region = { right = 25 } })
fails("expected at least two photographs", lab.correlate, { files = { series[1] } })
for i, stretch in ipairs { 1, 1.05 } do
  lab.photograph { file = file("still" .. i), rows = 3, columns = 2, pitch = 40, radius = 6, width = 160, height = 200, F = { 1, 0, 0, stretch }, noise = 0 }
end
fails("has a texture that determines a displacement", lab.correlate, { files = { file "still1", file "still2" }, region = { left = 0, right = 30, top = 0, bottom = 30 } })
fails("correlate: expected photographs of 260 x 240 pixels as the first, got one of 160 x 200", lab.correlate, { files = { series[1], files[1] } })
fails("expected a name ending in .png, got 'x.jpg'", lab.speckles, { file = "x.jpg", width = 10, height = 10 })
assert(os.execute("rm -r '" .. here .. "'"))
