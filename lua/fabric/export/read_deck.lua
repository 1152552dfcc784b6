-- Reads materials from other solvers' decks: the numbers of LAW58 and of *FABRIC as written, curves scaled to SI.
local define = require "fabric.define"
local units = require "fabric.export.units"
local fail = define.fail
local read = {}

local function lines_of(path)
  local file, why = io.open(path, "r")
  local text
  if file then
    text, why = file:read "a" -- a folder opens, and fails here
    file:close()
  end
  if not text then fail("card: cannot read '" .. path .. "': " .. why:gsub("^.-: ", "")) end
  local out = {}
  for l in (text:find "\n$" and text or text .. "\n"):gmatch "(.-)\r?\n" do out[#out + 1] = l end
  return out
end
read.lines_of = lines_of

local function trouble(path, line, what) fail(("card: %s:%d: %s"):format(path, line, what)) end

-- The system of units in words such as "kg, mm, ms" or "mm-kg-ms", in any order; others (N, MPa) are passed over; nil where one of the three
-- is missing or there twice.
local function system_of(words)
  local found = {}
  for word in words:gmatch "[%w]+" do
    local quantity = units.quantity_of(word)
    if quantity and found[quantity] and found[quantity] ~= word then return end
    if quantity then found[quantity] = word end
  end
  if found.mass and found.length and found.time then return units.of_words(found.mass, found.length, found.time) end
end

-- The system in a comment "Units: mm, t, s, N, MPa (mm-t-s)": by the name in brackets and by the words before it, which have to agree.
local function commented(path, line, text)
  local words, name = text:match "^(.-)%(([^()]*)%)%s*$"
  local by_name = name and (name == "SI" and units.of "SI" or system_of(name))
  local by_words = system_of(words or text)
  if by_name and by_words and not units.same(by_name, by_words) then
    trouble(path, line, ("expected units and a name in brackets that agree, got 'Units: %s'"):format(text))
  end
  return by_name or by_words
end

-- The system in a line of Radioss' words for mass, length and time, and how to name that line; or nil and the same.
local function radioss_system(l, i, what)
  local words = {}
  for word in l:gmatch "%S+" do words[#words + 1] = word end
  local got = #words == 3 and units.of_words(table.unpack(words)) or nil
  return got, ("line %d: %s with %s"):format(i, what, got and table.concat(words, ", ") or "'" .. l .. "'")
end

-- Units that a starter deck states: the system of /BEGIN, and those of its /UNIT/n by their number {system, words}; the first key of a material LAW58 and of
-- its section, with their lines: they may name a /UNIT/n.
local function radioss_units(path)
  local begin, blocks, unit, below, material, section = nil, {}, nil, nil, nil, nil
  for i, l in ipairs(lines_of(path)) do
    if l:sub(1, 1) == "/" then
      unit, below = l:match "^/UNIT/(%d+)" or (l:find "^/BEGIN" and "begin") or nil, 0
      local key = { key = l:match "^%S+", line = i }
      if l:find "^/MAT/LAW58/" or l:find "^/MAT/FABR_A/" or l:find "^/MAT/LAW19/" or l:find "^/MAT/FABRI/" then material = material or key end
      if l:find "^/PROP/TYPE16/" or l:find "^/PROP/SH_FABR/" then section = key end
    elseif unit and l:sub(1, 1) ~= "#" then
      below = below + 1
      if unit == "begin" and below == 3 then
        begin = { radioss_system(l, i, "/BEGIN") }
      elseif unit ~= "begin" and below == 2 then
        blocks[tonumber(unit)] = { radioss_system(l, i, "/UNIT/" .. unit) }
      end
    end
  end
  -- The system of a block: that of the /UNIT that it names, else that of /BEGIN.
  local function of(key)
    local id = tonumber(key and key.key:match "^/%a+/[%w_]+/%d+/(%d+)$" or 0)
    if id == 0 then return begin end
    return blocks[id] or { nil, ("line %d: %s names /UNIT/%d, which is not there"):format(key.line, key.key, id) }
  end
  return of(material), of(section)
end

-- The units that a deck states: in a comment "Units: ... (mm-t-s)", which fabric.export writes, or in Radioss' /BEGIN (the third line below it: mass,
-- length, time) or in the /UNIT/n that the material names. Returns the system and the words found, or nil; then the words that were not understood,
-- if any; then the system of Radioss' section, where it is stated.
function read.units(path)
  local system, where, unclear
  local function take(found, words)
    if not found then
      unclear = unclear or words
    elseif system and not units.same(system, found) then
      fail(("card: %s states units twice that do not agree: %s, and %s"):format(path, where, words))
    elseif not system then
      system, where = found, words
    end
  end
  for i, l in ipairs(lines_of(path)) do
    local text = l:match "^[#$*]+ *Units: *(.-)%s*$"
    if text then take(commented(path, i, text), ("line %d: Units: %s"):format(i, text)) end
  end
  local material, section = radioss_units(path)
  if material then take(material[1], material[2]) end
  if section and not section[1] then unclear = unclear or section[2] end
  return system, where, unclear, section and section[1]
end

-- The tested strains {warp, weft, shear} that the first comment "Tested up to E11 = ..." of a deck states, as fabric.export writes it, and its
-- line; or nil.
function read.tested(path)
  for i, l in ipairs(lines_of(path)) do
    local warp, weft, shear = l:match "^[#$*]+ Tested up to E11 = ([^%s,]+), E22 = ([^%s,]+), E12 = ([^%s,;]+)"
    if warp then
      local out = { warp = tonumber(warp), weft = tonumber(weft), shear = tonumber(shear) }
      for _, name in ipairs { "warp", "weft", "shear" } do
        local most = name == "shear" and 0.5 or 10
        if not (out[name] and out[name] >= 0 and out[name] < most) then trouble(path, i, ("expected a tested strain of the %s from 0 to below %g, got '%s'"):format(name, most, l)) end
      end
      return out, i
    end
  end
end

-- --- Radioss ---

-- Blocks {key, line, {text, line}...} of a deck whose keys begin with a sign, comments with one of others: of a starter deck by default.
function read.blocks(path, sign, comment)
  local out = {}
  for i, l in ipairs(lines_of(path)) do
    if l:sub(1, 1) == (sign or "/") then
      out[#out + 1] = { key = l:match "^(%S+)", line = i }
    elseif not l:find(comment or "^[#$]") and #out > 0 then
      table.insert(out[#out], { l, i })
    end
  end
  return out
end

-- The numbers of a line of fields of the given widths; empty ones are 0.
local function columns(path, entry, widths)
  local out, at = {}, 1
  for k, width in ipairs(widths) do
    local field, beyond = entry[1]:sub(at, at + width - 1), entry[1]:sub(at + width, at + 2 * width - 1)
    local text = field:match "^%s*(.-)%s*$"
    at = at + width
    -- a number that goes on beyond its columns, and ends before those of the next are full, would be read as another one
    if field:find "%S$" and beyond:find "^%S" and not (#beyond == width and beyond:find "%S$") then
      trouble(path, entry[2], ("'%s' reaches beyond columns %d to %d"):format(text .. beyond:match "^%S+", at - width, at - 1))
    end
    out[k] = text == "" and 0 or tonumber(text)
    if not out[k] then trouble(path, entry[2], ("expected a number in columns %d to %d, got '%s'"):format(at - width, at - 1, text)) end
  end
  return out
end

local function funct(path, blocks, id, scale, stress)
  for _, b in ipairs(blocks) do
    if b.key == "/FUNCT/" .. id then
      local c = { x = {}, y = {}, line = {} }
      for i = 2, #b do
        local f = columns(path, b[i], { 20, 20 })
        local n = #c.x
        if n > 0 and f[1] <= c.x[n] then trouble(path, b[i][2], ("expected an abscissa above %g, got %g"):format(c.x[n], f[1])) end
        c.x[n + 1], c.y[n + 1], c.line[n + 1] = f[1], f[2] * scale / stress, b[i][2]
      end
      if #c.x < 2 then trouble(path, b.line, "expected a function of at least two points") end
      return c
    end
  end
  fail(("card: %s: there is no /FUNCT/%d, which LAW58 names"):format(path, id))
end

read.columns = columns

-- The half of a curve for x >= 0, on which the stress has to rise.
local function positive(path, c)
  local out = { x = { 0 }, y = { 0 } }
  for i = 1, #c.x do
    if c.x[i] > 0 then
      local n = #out.x
      if c.y[i] <= out.y[n] then trouble(path, c.line[i], ("expected a stress that rises with the strain: above %g MPa, got %g MPa"):format(out.y[n] / 1e6, c.y[i] / 1e6)) end
      out.x[n + 1], out.y[n + 1] = c.x[i], c.y[i]
    end
  end
  if #out.x < 2 then fail(("card: %s: a curve has no points above 0"):format(path)) end
  return out
end

read.positive = positive

-- The intersection {x, y} of two curves beyond 0; without one, the end of the first, and true.
local function crossing(a, b, value)
  for i = 2, #a.x do
    local d0, d1 = a.y[i - 1] - value(b, a.x[i - 1]), a.y[i] - value(b, a.x[i])
    if i > 2 and d0 > 0 and d1 <= 0 then
      local x = a.x[i - 1] + (a.x[i] - a.x[i - 1]) * d0 / (d0 - d1)
      return { x, value(a, x) }
    end
  end
  return { a.x[#a.x], a.y[#a.y] }, true
end

read.crossing = crossing

-- Without functions: E1 x - B1 x^2 / 2 up to its maximum, and shear as two straight lines in tan(angle).
local function analytic(E, B)
  local c = { x = {}, y = {} }
  local last = B > 0 and math.min(0.2, 0.99 * E / B) or 0.2
  for i = 0, 40 do
    local x = last * i / 40
    c.x[i + 1], c.y[i + 1] = x, (E - B * x / 2) * x
  end
  return c
end

local function analytic_shear(G0, GT, angle)
  local lock = math.tan(math.rad(angle))
  local G = GT / (1 + lock * lock)
  if G0 == 0 then G0 = G end
  local c = { x = {}, y = {} }
  for i = 0, 40 do
    local degrees = i
    local t = math.tan(math.rad(degrees))
    c.x[i + 1], c.y[i + 1] = degrees, t <= lock and G0 * t or G * t + lock * (G0 - G)
  end
  return c
end

-- The first material LAW19 of a deck; nil if there is none, or if LAW58 is there too.
function read.law19_block(path)
  local found
  for _, b in ipairs(read.blocks(path)) do
    if b.key:find "^/MAT/LAW58/" or b.key:find "^/MAT/FABR_A/" then return end
    if b.key:find "^/MAT/LAW19/" or b.key:find "^/MAT/FABRI/" then found = found or b end
  end
  return found
end

-- {density, name, warp, weft, shear: {loading, unloading, meet, ended: true where `meet` is but the end of the curve, slope, elastic}, E1, E2, S1, S2, FLEX, thickness?}
function read.law58(path, u, value)
  local blocks, mat, thickness = read.blocks(path), nil, nil
  for _, b in ipairs(blocks) do
    if b.key:find "^/MAT/LAW58/" or b.key:find "^/MAT/FABR_A/" then mat = mat or b end
    if (b.key:find "^/PROP/TYPE16/" or b.key:find "^/PROP/SH_FABR/") and b[4] then thickness = columns(path, b[4], { 10, 10, 20 })[3] / (select(4, read.units(path)) or u).length end
  end
  if not mat then
    local others = {}
    for _, b in ipairs(blocks) do
      if b.key:find "^/MAT/" then others[#others + 1] = ("line %d: %s is there, which is not read"):format(b.line, b.key:match "^/MAT/[^/]*") end
    end
    fail(("card: %s: there is no /MAT/LAW58 (or /MAT/FABR_A), and no /MAT/LAW19%s"):format(path, #others > 0 and "; " .. table.concat(others, "; ") or ""))
  end
  if #mat < 6 then trouble(path, mat.line, "expected a title and at least five lines of LAW58") end
  local young = columns(path, mat[3], { 20, 20, 20, 20, 20 })
  local shear = columns(path, mat[4], { 20, 20, 20, 20 })
  local crimp = columns(path, mat[6], { 10, 10, 20, 20, 20, 20 })
  local ids, scales = {}, {}
  for k = 1, 3 do
    local f = mat[6 + k] and columns(path, mat[6 + k], { 10, 10, 20 }) or { 0, 0, 0 }
    ids[k], scales[k] = f[1], f[3] ~= 0 and f[3] or 1
  end
  local f = mat[10] and columns(path, mat[10], { 10, 10, 20, 20, 10, 20 }) or { 0, 0, 0, 0, 0, 0 }
  ids[4], ids[5], ids[6], scales[4], scales[5], scales[6] = f[1], f[2], f[5], f[3] ~= 0 and f[3] or 1, f[4] ~= 0 and f[4] or 1, f[6] ~= 0 and f[6] or 1
  local out = { name = mat[1][1], density = columns(path, mat[2], { 20 })[1] / u.density, thickness = thickness,
    E1 = young[1] / u.stress, E2 = young[3] / u.stress, FLEX = young[5] ~= 0 and young[5] or 1e-3,
    S1 = crimp[3] ~= 0 and crimp[3] or 0.1, S2 = crimp[4] ~= 0 and crimp[4] or 0.1 }
  local plain = { function() return analytic(young[1] / u.stress, young[2] / u.stress) end, function() return analytic(young[3] / u.stress, young[4] / u.stress) end,
    function() return analytic_shear(shear[1] / u.stress, shear[2] / u.stress, shear[3]) end }
  for k, part in ipairs { "warp", "weft", "shear" } do
    local loading = ids[k] ~= 0 and positive(path, funct(path, blocks, ids[k], scales[k], u.stress)) or plain[k]()
    local elastic = ids[3 + k] == 0
    local unloading = elastic and loading or positive(path, funct(path, blocks, ids[3 + k], scales[3 + k], u.stress))
    local meet, ended = { loading.x[#loading.x], loading.y[#loading.y] }, true
    if not elastic then meet, ended = crossing(loading, unloading, value) end
    out[part] = { loading = loading, unloading = unloading, elastic = elastic, slope = loading.y[2] / loading.x[2], meet = meet, ended = ended }
  end
  return out
end

-- --- Abaqus ---

local components = { ["1"] = "warp", ["2"] = "weft", SHEAR = "shear" }

function read.fabric(path, u)
  local out, here, part, direction, target = {}, nil, nil, nil, nil
  local function parameter(line, name) return line:upper():gsub("%s*=%s*", "="):match("," .. "%s*" .. name .. "=([^,]+)") end
  for i, l in ipairs(lines_of(path)) do
    local keyword = l:upper():match "^%*([^*,][^,]*)"
    if keyword then
      keyword = keyword:match "^%s*(.-)%s*$"
      target = nil
      if keyword == "MATERIAL" then
        if out.warp then here = nil else here, out.name = true, l:match "[Nn][Aa][Mm][Ee]%s*=%s*\"?([^,\"]*[^,\"%s])" end
      elseif keyword == "DENSITY" and here then target = "density"
      elseif keyword == "FABRIC" and here then out.fabric = true
      elseif keyword == "UNIAXIAL" and here then
        part = components[(parameter(l, "COMPONENT") or ""):match "%S*"]
        if not part then trouble(path, i, "expected COMPONENT=1, 2 or SHEAR") end
      elseif keyword == "LOADING DATA" and part then
        direction = (parameter(l, "DIRECTION") or "TENSION"):match "%S+"
        if direction == "TENSION" then
          out[part] = { loading = { x = {}, y = {}, line = {} }, elastic = true }
          target = out[part].loading
        end
      elseif keyword == "UNLOADING DATA" and part then
        local definition = parameter(l, "DEFINITION") or ""
        if not definition:find "^SHIFTED CURVE" then trouble(path, i, ("expected DEFINITION=SHIFTED CURVE, got '%s'"):format(definition)) end
        if direction == "TENSION" then
          out[part].unloading, out[part].elastic = { x = {}, y = {}, line = {} }, false
          target = out[part].unloading
        end
      elseif keyword:find "SECTION$" then target = "thickness"
      end
    elseif target and l:sub(1, 2) ~= "**" and l:find "%S" then
      local a, b = l:match "^%s*([^,]+),?%s*([^,]*)"
      local y, x = tonumber(a), tonumber(b)
      if target == "density" or target == "thickness" then
        if not y then trouble(path, i, "expected a number, got '" .. l .. "'") end
        out[target], target = y / (target == "density" and u.density or u.length), nil
      else
        if not (x and y) then trouble(path, i, "expected a stress and a strain, got '" .. l .. "'") end
        local n = #target.x
        if n > 0 and x <= target.x[n] then trouble(path, i, ("expected a strain above %g, got %g"):format(target.x[n], x)) end
        target.x[n + 1], target.y[n + 1], target.line[n + 1] = x, y / u.stress, i
      end
    end
  end
  if not out.fabric then fail(("card: %s: there is no *FABRIC"):format(path)) end
  for _, name in ipairs { "warp", "weft", "shear" } do
    local p = out[name]
    if not p or #p.loading.x < 2 then fail(("card: %s: *FABRIC has no *LOADING DATA in tension for the %s"):format(path, name)) end
    p.loading = positive(path, p.loading)
    p.unloading = p.unloading and positive(path, p.unloading) or p.loading
    p.ended = true
    p.meet, p.slope = { p.loading.x[#p.loading.x], p.loading.y[#p.loading.y] }, p.loading.y[2] / p.loading.x[2]
  end
  return out
end

return read
