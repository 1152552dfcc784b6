-- The table of fabric.lab.breaking_strength as text and as CSV.
local rows_of = {}

local function number(value, form) return value and form:format(value) or "" end
local function mm(way) return way and ("%.3g"):format(1e3 * way) or "" end

local quantities = { { "force", 1, "%.4g" }, { "elongation", 100, "%.3f" }, { "elongation_at_break", 100, "%.3f" } }

-- A line of the statistics: the name of the line and the field of each quantity.
local statistics = { { "mean", "mean" }, { "standard deviation", "deviation" }, { "CV, %", "cv" }, { "95 % of the mean from", "low" }, { "to", "high" } }

local function statistic(group, quantity, field)
  local s = group[quantity[1]]
  if not s or not s[field] then return end
  return field == "cv" and 100 * s.cv or quantity[2] * s[field]
end

-- Rows of cells, the heading first.
local function cells(group)
  local out = { { "specimen", "largest force, N", "elongation there, %", "at break, %", "from the jaw, mm", "" } }
  for _, s in ipairs(group.specimens) do
    out[#out + 1] = { s.name, number(s.force, "%.5g"), number(s.elongation and 100 * s.elongation, "%.2f"), number(s.elongation_at_break and 100 * s.elongation_at_break, "%.2f"),
      s.from_jaw == "jaw" and "at it" or mm(s.from_jaw), s.remark }
  end
  for _, line in ipairs(group.force and statistics or {}) do
    local row = { line[1] }
    for k, quantity in ipairs(quantities) do row[k + 1] = number(statistic(group, quantity, line[2]), k == 1 and "%.5g" or "%.2f") end
    out[#out + 1] = row
  end
  return out
end

local function aligned(rows)
  local widths, lines = {}, {}
  for _, row in ipairs(rows) do
    for k = 1, 5 do widths[k] = math.max(widths[k] or 0, utf8.len(row[k] or "") or #row[k]) end
  end
  for i, row in ipairs(rows) do
    local line = { ("%-" .. widths[1] .. "s"):format(row[1]) }
    for k = 2, 5 do line[k] = ("%" .. widths[k] .. "s"):format(row[k] or "") end
    line[6] = row[6] ~= "" and row[6] or nil
    lines[i] = "  " .. table.concat(line, "  "):gsub("%s+$", "")
  end
  return lines
end

-- The rounded result, in the words of the standard; nil if the standard does not round.
local function rounded(standard, group)
  if not standard.rounded_force or not group.force or not group.force.low then return end
  local F, e = group.force, group.elongation
  local force = ("  rounded as the standard says: %g N (%g to %g), CV %.1f %%"):format(standard.rounded_force(F.mean), standard.rounded_force(F.low),
    standard.rounded_force(F.high), 100 * F.cv)
  if not e or not e.low then return force end
  return ("%s; elongation %g %% (%g to %g)"):format(force, standard.rounded_elongation(100 * e.mean), standard.rounded_elongation(100 * e.low), standard.rounded_elongation(100 * e.high))
end

function rows_of.text(standard, result)
  local lines = {}
  for _, name in ipairs(result.names) do
    local group = result.groups[name]
    lines[#lines + 1] = ("%s, %s: %d of %d specimens count"):format(standard.name, name, group.counted, #group.specimens)
    for _, line in ipairs(aligned(cells(group))) do lines[#lines + 1] = line end
    lines[#lines + 1] = rounded(standard, group)
    for _, note in ipairs(group.notes) do lines[#lines + 1] = "  " .. note end
  end
  return table.concat(lines, "\n")
end

local function quoted(words) return words:find '[",]' and '"' .. words:gsub('"', '""') .. '"' or words end

-- A row for each specimen, and below those of a group its statistics, with the name of the statistic in place of the specimen's.
function rows_of.csv(result)
  local lines = { "group,specimen,largest force (N),elongation at largest force (%),elongation at break (%),distance from the jaw (mm),counted,remark" }
  for _, name in ipairs(result.names) do
    local group = result.groups[name]
    for _, s in ipairs(group.specimens) do
      lines[#lines + 1] = table.concat({ quoted(name), quoted(s.name), ("%.10g"):format(s.force), ("%.10g"):format(100 * s.elongation),
        number(s.elongation_at_break and 100 * s.elongation_at_break, "%.10g"), s.from_jaw == "jaw" and "jaw" or number(s.from_jaw and 1e3 * s.from_jaw, "%.10g"),
        s.counted and "yes" or "no", quoted(s.remark) }, ",")
    end
    for _, line in ipairs(group.force and statistics or {}) do
      local row = { quoted(name), quoted(line[1]) }
      for _, quantity in ipairs(quantities) do row[#row + 1] = number(statistic(group, quantity, line[2]), "%.10g") end
      lines[#lines + 1] = table.concat(row, ",") .. ",,,"
    end
  end
  return table.concat(lines, "\n") .. "\n"
end

return rows_of
