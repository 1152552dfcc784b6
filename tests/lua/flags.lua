-- Oddities of single records stand in the result of a folder and in its report: slip, a zero that drifts, an extensometer that was taken off, two tests in one file.
local fabric = require "fabric"
local folder, report = require "fabric.lab.folder", require "fabric.lab.report"
local draw = require "fabric.lab.random"(41)
fabric.warn = function() end

local place = os.tmpname()
os.remove(place)
assert(os.execute("mkdir '" .. place .. "'"))
local function write(name, text)
  local f <close> = assert(io.open(place .. "/" .. name, "w"))
  f:write(text)
end

-- Rows {u, F} of a pull by 9 mm, stiffening to about 90 N, each factor times as strong as the other.
local function pull(factor)
  local rows = {}
  for k = 0, 90 do
    local u = 0.1 * k
    rows[#rows + 1] = { u, factor * (4 * u + 0.65 * u * u) + 0.02 * draw.normal() }
  end
  return rows
end
local function text_of(rows)
  local lines = { "Time (s),Extension (mm),Load (N)" }
  for k, r in ipairs(rows) do lines[#lines + 1] = ("%.2f,%.4f,%.4f"):format(0.25 * (k - 1), r[1], r[2]) end
  return table.concat(lines, "\n") .. "\n"
end

local plain = pull(1)
local slipped = pull(1.03)
for k = 60, 68 do slipped[k][2] = slipped[k][2] * (1 - 0.12 * (69 - k) / 9) end -- falls by a tenth, and recovers
local drifting = pull(0.98)
for k = 1, 12 do drifting[#drifting + 1] = { 9 - 0.75 * k, 92 * (1 - k / 8) ^ 3 - 0.1 * k } end -- comes back to a force below zero
local taken_off = pull(1.01)
for k = 1, 25 do taken_off[#taken_off + 1] = { 9, 89 + 1.6 * k } end
local merged = pull(0.99)
for _, r in ipairs(pull(1.02)) do merged[#merged + 1] = r end

write("laboratory.lua", "return { name = 'odd', source = 'made', gauge_length = 0.2, width = 0.05, thickness = 4e-4, plies = 1, density = 500 }\n")
for i, rows in ipairs { plain, slipped, drifting } do write(("warp-%d.csv"):format(i), text_of(rows)) end
for i, rows in ipairs { plain, taken_off, merged } do write(("weft-%d.csv"):format(i), text_of(rows)) end
local result = folder.reduce(place)
local figures = report.write(result, place .. "/out")
assert(figures.warp and figures.weft)
local f <close> = assert(io.open(place .. "/out/report.html"))
local html = f:read "a"

local wanted = {
  { "warp", 2, "slip", "the force falls suddenly 1 time and recovers" },
  { "warp", 3, "drift", "the zero of the load cell drifts" },
  { "weft", 2, "extensometer", "was the extensometer taken off?" },
  { "weft", 3, "restart", "does another specimen begin here?" },
}
for _, w in ipairs(wanted) do
  local name, i, code, words = table.unpack(w)
  local kept
  for _, sign in ipairs(result[name].tests[i].warnings or {}) do kept = kept or sign.code == code and sign.row > 1 end
  assert(kept, name .. " " .. i .. ": " .. code)
  local line
  for _, text in ipairs(result.seen) do
    if text:find(("^%s: specimen %d %%(%s%%-%d.csv%%): "):format(name, i, name, i)) and text:find(words, 1, true) then line = text end
  end
  assert(line, table.concat(result.seen, "\n"))
  assert(html:find(line:gsub("&", "&amp;"):gsub("<", "&lt;"), 1, true), line)
end
assert(not result.warp.tests[1].warnings and not result.weft.tests[1].warnings)
-- a test that is merged with another is still one specimen, and its file may be read as two
write("laboratory.lua", "return { name = 'odd', source = 'made', gauge_length = 0.2, width = 0.05, thickness = 4e-4, plies = 1, density = 500, restarts = 'specimens' }\n")
local apart = folder.reduce(place)
assert(#apart.weft.tests == 4 and #result.weft.tests == 3)
assert(result.warp.fit.text:find("not in the band: slip in the jaws", 1, true), result.warp.fit.text)
