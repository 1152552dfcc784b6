-- The drape of the program's cards: coefficient, folds and amplitude with their scatter over discs, outlines side by side. Minutes to hours.
--
--   fabricsh scripts/long/drape_table.lua                          a disc of every card but wool by relaxation, into out/drape: two minutes
--   fabricsh scripts/long/drape_table.lua 10 6 "worsted broad"     ten discs, six elements over the overhang, these cards ("all": every card)
--   fabricsh scripts/long/drape_table.lua 10 5 "worsted duck:5"    five discs of duck; "worsted nylon:3:8": three of nylon with eight elements
--   fabricsh scripts/long/drape_table.lua 10 5 "all wool:3" write  every card and three discs of wool, and the table and the figure of share/doc/drape.md
--   fabricsh scripts/long/drape_table.lua 3 5 worsted motion       in motion, with contact: seconds to minutes a disc
--
-- Each disc that is finished is kept in out/drape, so a longer list goes on from a shorter one.
-- warns: nine measured cloths in ten have 1 to 70 uN.m
local fabric = require "fabric"
local seeds, cells, which, write = tonumber(arg[1] or 1), tonumber(arg[2] or 5), arg[3] or "all", arg[4] == "write"
local by = arg[4] == "motion" and "motion" or "relaxation"
local root = arg[0]:gsub("[^/]*$", "") .. "../../"
local disc, support = 0.30, 0.18

local names, discs, elements = {}, {}, {}
local function take(name, count, fine)
  if not discs[name] then names[#names + 1] = name end
  discs[name], elements[name] = tonumber(count) or seeds, tonumber(fine) or cells
end
for word in which:gmatch "%S+" do
  if word == "all" then
    -- The warp of 'wool' unloads 165 times as stiffly as it loads: a disc takes minutes, so it is named or left out.
    for _, name in ipairs(fabric.cards()) do
      if name ~= "wool" then take(name) end
    end
  else
    take(word:match "^([^:]+):?(%d*):?(%d*)$")
  end
end

-- The thesis' four have no bending of their own but an estimate.
local function card_of(name)
  local card = fabric.card(name)
  return card.bending and card or fabric.card(name, { bending = "estimated" })
end

local outline_points = 120
local function drape(p)
  local r = fabric.lab.cusick { card = card_of(p.card), disc = disc, support = support, cells = p.cells, seed = p.seed, by = p.by, contact = p.by == "motion" }
  local one, radii = r.runs[1], {}
  for k = 1, #one.outline, #one.outline // outline_points do radii[#radii + 1] = ("%.1f"):format(1e3 * one.outline[k]) end
  return { coefficient = one.coefficient, nodes = one.nodes, amplitude = one.amplitude, at_rest = one.at_rest, time = one.time, ledger = one.error,
    orientation = one.orientation, outline = table.concat(radii, " ") }
end

-- A disc of every card first, then the second of each.
local cases = {}
for seed = 1, seeds do
  for _, name in ipairs(names) do
    if seed <= discs[name] then cases[#cases + 1] = { card = name, seed = seed, cells = elements[name], by = by } end
  end
end
local study = fabric.study { parameters = cases, run = drape, folder = "out/drape", workers = tonumber(os.getenv "FABRICSH_WORKERS") }
if fabric.checking() then return end

local function statistics(list, name)
  local sum, squares = 0, 0
  for _, v in ipairs(list) do sum = sum + v[name] / #list end
  for _, v in ipairs(list) do squares = squares + (v[name] - sum) ^ 2 end
  return sum, #list > 1 and math.sqrt(squares / (#list - 1)) or nil
end

local function told(list, name, factor, form)
  local mean, deviation = statistics(list, name)
  if not deviation then return form:format(factor * mean) end
  return (form .. " +- " .. form):format(factor * mean, factor * deviation)
end

local rows, by_card, expected = {}, {}, {}
for i, row in ipairs(study) do
  local name = cases[i].card
  if row.trouble then print(("%s, disc %d: %s"):format(name, cases[i].seed, row.trouble)) end
  if row.values then
    by_card[name] = by_card[name] or {}
    table.insert(by_card[name], row.values)
    expected[#expected + 1] = { ("%s, disc %d: at rest"):format(name, cases[i].seed), row.values.at_rest and 1 or 0, 1, absolute = 0 }
    expected[#expected + 1] = { ("%s, disc %d: ledger"):format(name, cases[i].seed), row.values.ledger, 0, absolute = by == "motion" and 1e-3 or 0.1 }
    expected[#expected + 1] = { ("%s, disc %d: between hanging straight and level"):format(name, cases[i].seed), row.values.coefficient, 0.5, absolute = 0.5 }
  end
end
local function stiffness(card) -- mean bending length, mm
  local function B(v) return type(v) == "table" and (type(v[1]) == "table" and v[2][2] / v[2][1] or v[1]) or v end
  local b, mass = card.bending, card.density * card.thickness * 9.80665
  return 1e3 * ((B(b.warp) / mass) ^ (1 / 3) + (B(b.weft) / mass) ^ (1 / 3)) / 2
end
local sorted = {}
for _, name in ipairs(names) do
  if by_card[name] then sorted[#sorted + 1] = name end
end
table.sort(sorted, function(a, b) return statistics(by_card[a], "coefficient") < statistics(by_card[b], "coefficient") end)
rows[1] = "| card | W g/m2 | bending length mm | coefficient % | folds | amplitude mm |"
rows[2] = "|---|---|---|---|---|---|"
for _, name in ipairs(sorted) do
  local card, list = card_of(name), by_card[name]
  rows[#rows + 1] = ("| %s | %.0f | %.1f | %s | %s | %s |"):format(name, 1e3 * card.density * card.thickness, stiffness(card),
    told(list, "coefficient", 100, "%.1f"), told(list, "nodes", 1, "%.1f"), told(list, "amplitude", 1e3, "%.1f"))
end
local text = table.concat(rows, "\n")
print(text)

-- The outlines of all discs of a card over one another; the level disc and the pedestal dashed.
local function figure()
  local width, columns, out = 180, 4, {}
  local scale = width * 0.9 / disc
  local lines = math.ceil(#sorted / columns)
  local function add(form, ...) out[#out + 1] = form:format(...) end
  add('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" font-family="sans-serif" font-size="12">', columns * width, lines * (width + 24))
  add '<rect width="100%%" height="100%%" fill="white"/>'
  for i, name in ipairs(sorted) do
    local x, y = ((i - 1) % columns + 0.5) * width, ((i - 1) // columns) * (width + 24) + 20 + width / 2
    add('<text x="%g" y="%g" text-anchor="middle">%s: %s %%</text>', x, y - width / 2 - 4, name, told(by_card[name], "coefficient", 100, "%.0f"):gsub("%+%-", "±"))
    for _, d in ipairs { disc, support } do
      add('<circle cx="%g" cy="%g" r="%.1f" fill="none" stroke="#999" stroke-dasharray="3 3"/>', x, y, scale * d / 2)
    end
    local path = {}
    for _, one in ipairs(by_card[name]) do
      local points, k, turn, px, py = {}, 0, -math.rad(one.orientation), 0, 0 -- every second point, for a smaller file
      for r in one.outline:gmatch "%S+" do -- turned so that the warp goes to the right; in tenths, each from the last, which is short
        local angle = 2 * math.pi * k / outline_points + turn
        local drawn = k % 2 == 0
        local qx, qy = math.floor(10 * (x + scale * r * 1e-3 * math.cos(angle)) + 0.5), math.floor(10 * (y - scale * r * 1e-3 * math.sin(angle)) + 0.5)
        if drawn then
          points[#points + 1] = ((k == 0 and "M%d %d" or k == 2 and "l%d %d" or "%d %d"):format(qx - px, qy - py):gsub(" %-", "-"))
          px, py = qx, qy
        end
        k = k + 1
      end
      path[#path + 1] = table.concat(points, " "):gsub(" %-", "-"):gsub(" l", "l") .. "z"
    end
    add('<path d="%s" transform="scale(.1)" fill="none" stroke="#1f5fa8" stroke-width="10"/>', table.concat(path))
  end
  add "</svg>"
  return table.concat(out, "\n") .. "\n"
end

fabric.write("out/drape/outlines.svg", figure())
if write then
  fabric.write(root .. "share/doc/figures/drape_outlines.svg", figure())
  local path = root .. "share/doc/drape.md"
  local file = assert(io.open(path))
  local page = file:read "a"
  file:close()
  local before, after = page:match "^(.*\n<!%-%- written by scripts/long/drape_table.lua %-%->\n).-(\n<!%-%- end %-%->.*)$"
  fabric.write(path, before .. "\n" .. text .. "\n" .. after)
  local r = fabric.lab.cusick { card = fabric.card "worsted", by = "relaxation" }
  fabric.render { file = root .. "share/doc/figures/drape_disc.png", run = r.analysis, field = "uz", view = { 30, 35 }, size = { 0.085, 0.06 }, dpi = 200 }
end
if by_card.cloth440 and by_card.cloth097 then -- the stiffest and the limpest of them
  expected[#expected + 1] = { "the stiff cloth shades more than the limp one (1: yes)",
    statistics(by_card.cloth440, "coefficient") > statistics(by_card.cloth097, "coefficient") and 1 or 0, 1, absolute = 0 }
end
fabric.expect(expected)
