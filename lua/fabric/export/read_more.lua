-- Reads *MAT_034 from LS-DYNA decks and LAW19 from those of OpenRadioss, for fabric.import.card.
local define = require "fabric.define"
local laws = require "fabric.export.laws"
local read = require "fabric.export.read_deck"
local lists = require "fabric.lists"
local fail = define.fail
local more = {}

local function trouble(path, line, what) fail(("card: %s:%d: %s"):format(path, line, what)) end

-- A part of a card from its curves; without an unloading curve it is elastic.
local function part_of(loading, unloading)
  local part = { loading = loading, unloading = unloading or loading, elastic = unloading == nil, ended = true }
  part.meet = { loading.x[#loading.x], loading.y[#loading.y] }
  if unloading then part.meet, part.ended = read.crossing(loading, unloading, laws.value) end
  part.slope = loading.y[2] / loading.x[2]
  return part
end

-- --- LS-DYNA ---

-- The fields of a line: as wide as the keyword's, or separated by commas; empty ones are 0.
local function fields(path, entry, width)
  local out, text = {}, entry[1]
  if text:find(",", 1, true) then
    for word in (text .. ","):gmatch "([^,]*)," do out[#out + 1] = word end
  else
    for at = 1, #text, width do out[#out + 1] = text:sub(at, at + width - 1) end
  end
  for i, word in ipairs(out) do
    word = word:match "^%s*(.-)%s*$"
    out[i] = word == "" and 0 or tonumber(word)
    if not out[i] then trouble(path, entry[2], ("expected a number in field %d, got '%s'"):format(i, word)) end
  end
  return setmetatable(out, { __index = function() return 0 end })
end

-- Keywords {key, line, {text, line}...}; a title is taken off the lines.
local function keywords(path)
  local out = read.blocks(path, "*", "^%$")
  for _, here in ipairs(out) do
    here.key = here.key:upper()
    if here.key:find "_TITLE$" and here[1] then here.title = table.remove(here, 1)[1]:match "^%s*(.-)%s*$" end
  end
  return out
end

-- The curve with a number, with its scales and offsets: x = SFA (x + OFFA), y = SFO (y + OFFO).
local function curve(path, all, id, stress)
  if id == 0 then return end
  for _, key in ipairs(all) do
    if key.key:find "^%*DEFINE_CURVE" and key[1] then
      local head = fields(path, key[1], 10)
      if head[1] == id then
        local sx, sy, c = head[3] ~= 0 and head[3] or 1, head[4] ~= 0 and head[4] or 1, { x = {}, y = {}, line = {} }
        for i = 2, #key do
          local f = fields(path, key[i], 20)
          local n, x = #c.x, sx * (f[1] + head[5])
          if n > 0 and x <= c.x[n] then trouble(path, key[i][2], ("expected an abscissa above %g, got %g"):format(c.x[n], x)) end
          c.x[n + 1], c.y[n + 1], c.line[n + 1] = x, sy * (f[2] + head[6]) / stress, key[i][2]
        end
        if #c.x < 2 then trouble(path, key.line, "expected a curve of at least two points") end
        return read.positive(path, c)
      end
    end
  end
  fail(("card: %s: there is no *DEFINE_CURVE %d, which *MAT_034 names"):format(path, id))
end

local function straight(modulus, last) return { x = { 0, last }, y = { 0, modulus * last } } end

-- As read.law58, with a note where the file has what is not read. FORM 14, the formulation that fabric.export writes, and FORM 4: second Piola-Kirchhoff stress over Green-Lagrange strain.
function more.mat_034(path, u)
  local all, mat, thickness = keywords(path), nil, nil
  for _, key in ipairs(all) do
    if key.key:find "^%*MAT_FABRIC" or key.key:find "^%*MAT_034" then mat = mat or key end
    if key.key:find "^%*SECTION_SHELL" and key[2] then thickness = fields(path, key[2], 10)[1] / u.length end
  end
  if not mat then
    local others = {}
    for _, key in ipairs(all) do
      if key.key:find "^%*MAT_" then others[#others + 1] = ("; line %d: %s is there, which is not read"):format(key.line, key.key) end
    end
    fail(("card: %s: there is no *MAT_FABRIC (*MAT_034)%s"):format(path, table.concat(others)))
  end
  if #mat < 5 then trouble(path, mat.line, "expected five lines of *MAT_034 at least") end
  local first, second, form = fields(path, mat[1], 10), fields(path, mat[2], 10), fields(path, mat[3], 10)[6]
  if form ~= 14 and form ~= 4 then
    trouble(path, mat[3][2], ("expected FORM = 14 or 4, whose curves are of second Piola-Kirchhoff stress over Green-Lagrange strain, got %g"):format(form))
  end
  local ids = fields(path, mat[6] or { "", mat.line }, 10)
  local out = { name = mat.title or "mat_034", density = first[2] / u.density, thickness = thickness }
  if first[6] ~= 0 or first[7] ~= 0 then
    out.note = ("poisson: PRBA = %g and PRAB = %g of the file were not taken, since nothing ties warp to weft in the law as it is read here; poisson={nu12, nu21} gives ratios"):format(first[6], first[7])
  end
  local moduli, reach = { first[3], first[4], second[1] }, { 0.1, 0.1, 0.4 }
  for k, part in ipairs { "warp", "weft", "shear" } do
    local loading = curve(path, all, ids[k], u.stress)
    if not loading and moduli[k] <= 0 then trouble(path, mat.line, ("expected a curve or a positive modulus of the %s"):format(part)) end
    out[part] = part_of(loading or straight(moduli[k] / u.stress, reach[k]), loading and curve(path, all, ids[3 + k], u.stress))
  end
  return out
end

-- --- LAW19 ---

-- Its answer to a pull along a yarn, free across, and to shear, as curves of second Piola-Kirchhoff stress over Green-Lagrange strain: up to the strains
-- that the file states as tested, or 0.1 along the yarns and 0.2 in shear.
local function sampled(p, tested)
  local n, out = 40, {}
  local function reach(part, default) return tested and tested[part] > 0 and tested[part] or default end
  local function list(last)
    return lists.of(n, function(i) return last * i / n end)
  end
  for part, angle in pairs { warp = 0, weft = 90 } do
    local x = list(reach(part, 0.1))
    local S = laws.along(laws.law19(p), { drive = "uniaxial", angle = angle, values = x })
    out[part] = { x = table.move(x, 1, n, 2, { 0 }), y = table.move(S, 1, n, 2, { 0 }) }
  end
  local x = list(reach("shear", 0.2))
  local S = laws.along(laws.law19(p), { drive = "shear", values = x })
  out.shear = { x = { 0 }, y = table.move(S, 1, n, 2, { 0 }) }
  for i, E12 in ipairs(x) do out.shear.x[i + 1] = 2 * E12 end
  return out
end

-- As read.law58, with the ratios of the file in `poisson`.
function more.law19(path, mat, u, columns)
  if #mat < 5 then trouble(path, mat.line, "expected a title and four lines of LAW19") end
  local young, shear, last = columns(path, mat[3], { 20, 20, 20 }), columns(path, mat[4], { 20, 20, 20 }), columns(path, mat[5], { 20 })
  local p = { name = mat[1][1], density = columns(path, mat[2], { 20 })[1] / u.density, E11 = young[1] / u.stress, E22 = young[2] / u.stress, NU12 = young[3],
    G12 = shear[1] / u.stress, RE = last[1] ~= 0 and last[1] or 1 }
  if not (p.E11 > 0 and p.E22 > 0 and p.G12 > 0) then trouble(path, mat.line, "expected positive E11, E22 and G12") end
  p.poisson = { p.NU12, p.NU12 * p.E22 / p.E11 }
  for part, c in pairs(sampled(p, (read.tested(path)))) do p[part] = part_of(c) end
  return p
end

return more
