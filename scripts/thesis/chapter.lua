-- Shared by the decks of chapter 7: cards and rules, closed forms, rows of the table, figures and pictures. A deck begins with
--   local chapter = dofile((arg[0]:gsub("[^/]*$", "")) .. "chapter.lua")
-- and ends with chapter.expect{...}. Run by itself this file does nothing.
local known = package.loaded["thesis.chapter"]
if known then return known end
local fabric = require "fabric"
local MPa = fabric.units.MPa
local chapter = { rows = {}, figures = {}, figure = "" }
package.loaded["thesis.chapter"] = chapter

-- Each figure has a folder below this one.
chapter.out = "out/thesis"

-- Begins a deck: its figure's number as the thesis prints it, a title, and its folder's name.
function chapter.begin(figure, title, folder)
  chapter.figure, chapter.title = figure, title
  chapter.folder = chapter.out .. "/" .. folder
  print(("\n%s: %s"):format(figure, title))
end

-- The thesis bends its cloth by integration through the thickness, and so do its decks, on purpose: nothing is said of it.
function chapter.card(name) return fabric.card(name, { bending = "thickness" }) end

-- The card with the ratios that the thesis cut to 0.40 (table 7.4), where they are larger.
function chapter.cut(card)
  return card:with { warp = { poisson = math.min(0.40, card.warp.poisson) }, weft = { poisson = math.min(0.40, card.weft.poisson) } }
end

-- The thesis' own rules: its endpoint integration, and for duck and muslin both ratios 0.40.
function chapter.rules(card)
  local own = card:with { law = "thesis" }
  if card.name == "duck" or card.name == "muslin" then own = own:with { warp = { poisson = 0.40 }, weft = { poisson = 0.40 } } end
  return own
end

-- St. Venant-Kirchhoff with the moduli at zero strain.
function chapter.svk(card)
  return fabric.svk { name = card.name .. ", SVK", warp = card.warp.loading[1], weft = card.weft.loading[1], shear = card.shear.loading[1] / 2,
                      poisson = { card.warp.poisson, card.weft.poisson }, density = card.density, thickness = card.thickness }
end

-- P(E) and U(E) of a yarn, Pa and J/m^3; of shear with E12 in place of E.
function chapter.P(yarn, E)
  local sum = 0
  for i, d in ipairs(yarn.loading) do sum = sum + d * E ^ i / i end
  return sum
end
function chapter.U(yarn, E)
  local sum = 0
  for i, d in ipairs(yarn.loading) do sum = sum + d * E ^ (i + 1) / (i * (i + 1)) end
  return sum
end

function chapter.strain(displacement)
  local e = displacement / 0.0762
  return e + e * e / 2
end

-- A run that may fail: the result, or nil and the first line of why.
function chapter.try(test, fields)
  local ok, result = pcall(test, fields)
  if ok then return result end
  local why = tostring(result):gsub("\n.*", ""):gsub("^.-no step beyond time ([%d.]+) s:.*", "no convergence beyond t = %1 of the path")
  return nil, why
end

-- The thesis' rules at one material point along strains {E11, E22, E12}: a curve of rows with S12, E12, time. For uniform fields.
function chapter.point_curve(card, strains)
  local curve = { { time = 0, E12 = 0, S12 = 0, S11 = 0, S22 = 0 } }
  for i, r in ipairs(fabric.point(card):path(strains)) do
    curve[i + 1] = { time = i, E12 = r.E12, S12 = r.S12, S11 = r.S11, S22 = r.S22 }
  end
  return curve
end

-- Fields for a run that may not converge: it gives up soon. 1e-5 of the largest force: the comparison laws jump at their
-- switches, and Newton can't get below the jump there.
function chapter.patient(fields)
  fields.max_cuts, fields.max_iterations, fields.tolerance = 4, 20, 1e-5
  return fields
end

-- Column `name` at the strain E while the strip is loaded for the first time, between steps by a straight line; nil beyond.
function chapter.at(curve, E, name)
  for i = 2, #curve do
    local a, b = curve[i - 1], curve[i]
    if b.E < a.E then return nil end
    if E <= b.E then return a[name] + (b[name] - a[name]) * (E - a.E) / (b.E - a.E) end
  end
end

-- Columns of the curve as a curve for fabric.plot, stress in MPa; factors of y and x.
function chapter.curve(rows, label, style, x, y, factor, x_factor)
  local out = { x = {}, y = {}, label = label, style = style }
  for i, row in ipairs(rows) do
    out.x[i], out.y[i] = row[x or "E"] * (x_factor or 1), row[y or "S"] * (factor or 1 / MPa)
  end
  return out
end

-- f from 0 to `last` as a dashed curve.
function chapter.line(f, last, label, factor)
  local out = { x = {}, y = {}, label = label, style = "dashed" }
  for i = 0, 100 do out.x[i + 1], out.y[i + 1] = last * i / 100, f(last * i / 100) * (factor or 1 / MPa) end
  return out
end

-- Draws curves; says what is to be seen. Without gnuplot there is a warning in its place.
function chapter.plot(name, sentence, fields)
  fields.file = ("%s/%s.svg"):format(chapter.folder, name)
  if fabric.plot(fields) then chapter.keep(fields.file, sentence) end
end

-- File of the frame of a row of a test's curve (nil: the last); stem: folder and name of its series. A frame a row.
function chapter.frame(stem, test, row)
  local place = #test.curve
  for i, r in ipairs(test.curve) do
    if r == row then place = i end
  end
  return ("%s_%05d.vtu"):format(stem, place - 1)
end

-- Row of a curve at a time, or the nearest before.
function chapter.at_time(curve, time)
  local found = curve[1]
  for _, row in ipairs(curve) do
    if row.time <= time + 1e-9 then found = row end
  end
  return found
end

-- The value of the row of a run's curve at a time.
function chapter.value_at(run, time, name)
  for _, row in ipairs(run.curve) do
    if math.abs(row.time - time) < 1e-9 then return row[name] end
  end
end

-- The square in simple shear of figs. 7-27 and 7-28, to E12 = 0.25 at most; fields: more for fabric.lab.shear.
function chapter.square(card, path, fields)
  fields = fields or {}
  fields.card, fields.E12, fields.path, fields.steps = card, 0.25, path, 150
  return chapter.try(fabric.lab.shear, fields)
end

-- Its field is uniform, so the thesis' rules are run at a material point along the strains of the square.
function chapter.square_by_rules(card, test)
  local strains = {}
  for i = 2, #test.curve do
    local E12 = test.curve[i].E12
    strains[i - 1] = { 0, 2 * E12 ^ 2, E12 }
  end
  local curve = chapter.point_curve(chapter.rules(card), strains)
  for i, row in ipairs(curve) do row.time = test.curve[i].time end
  return { curve = curve }
end

-- Draws a sheet, or several on the width of two columns of a journal; without a display a warning. fields.height: mm.
function chapter.render(name, sentence, fields)
  fields.file = ("%s/%s.png"):format(chapter.folder, name)
  local several = type(fields.vtu) == "table"
  fields.size = { (several and 170 or 85) * 1e-3, (fields.height or (several and 100 or 80)) * 1e-3 }
  fields.dpi, fields.height = several and 150 or 200, nil
  local ok, drawn = pcall(fabric.render, fields)
  if not ok then
    assert(tostring(drawn):find("no display", 1, true), drawn)
    return fabric.warn("no picture: " .. tostring(drawn))
  end
  if drawn then chapter.keep(fields.file, sentence) end
end

function chapter.keep(file, sentence)
  chapter.figures[#chapter.figures + 1] = { figure = chapter.figure, title = chapter.title, file = file, sentence = sentence }
  print(("  %s: %s"):format(file, sentence))
end

local function words(value)
  if type(value) == "number" then return ("%.4g"):format(value) end
  return value or ""
end

-- A row of the table. thesis: its own words or numbers, quoted and not scored; ours; rules: ours with the thesis' rules.
function chapter.row(quantity, thesis, ours, rules)
  local row = { figure = chapter.figure, quantity = quantity, thesis = words(thesis), ours = words(ours), rules = words(rules) }
  chapter.rows[#chapter.rows + 1] = row
  print(("  %-62s | thesis: %-24s | ours: %-18s | its rules: %s"):format(row.quantity, row.thesis, row.ours, row.rules))
end

function chapter.percent(value, digits) return ("%+." .. (digits or 1) .. "f %%"):format(100 * value) end

-- Rows of a test's mesh error for the quantities named, and the estimates.
function chapter.mesh_rows(what, test, names)
  local found = test:mesh_error { print = false }
  for _, name in ipairs(names) do
    local r = found[name]
    local unit = name:sub(1, 1) == "S" and 1 / MPa or 1
    chapter.row(("%s: %s on three meshes"):format(what, name), nil,
                ("%.4g %.4g %.4g -> %.4g, first +- %.2g %%"):format(r[1] * unit, r[2] * unit, r[3] * unit, r.limit * unit, 100 * r.error))
  end
  return found
end

-- How much of a field on elements in rows of nx is a checkerboard: its part along (-1)^(i+j), over its largest value. Without
-- the two rows at either end, where clamps and corners make peaks of one element.
function chapter.checkerboard(values, nx)
  local sum, largest, count = 0, 0, 0
  for k = 2 * nx + 1, #values - 2 * nx do
    local i, j = (k - 1) % nx, (k - 1) // nx
    sum = sum + ((i + j) % 2 == 0 and values[k] or -values[k])
    largest = math.max(largest, math.abs(values[k]))
    count = count + 1
  end
  return math.abs(sum) / count / largest
end

function chapter.expect(rows)
  fabric.expect(rows)
  return chapter
end

return chapter
