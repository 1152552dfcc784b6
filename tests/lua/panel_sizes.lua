-- Pieces of a pattern that a file holds in several sizes, or that cannot be read, beside the others.
local fabric = require "fabric"
local fails = dofile((arg[0]:gsub("[^/]*$", "common/check.lua"))).fails
local said = {}
fabric.warn = function(words) said[#said + 1] = words end

local function block(name, texts, width, height, open)
  local out = { ("0\nBLOCK\n8\n0\n2\n%s\n70\n0\n10\n0\n20\n0\n3\n%s\n"):format(name, name) }
  for _, words in ipairs(texts) do out[#out + 1] = ("0\nTEXT\n8\n1\n10\n0\n20\n0\n40\n1\n1\n%s\n"):format(words) end
  -- two open lines, the second backward
  local lines = { { { 0, 0 }, { width, 0 }, { width, height } }, { { 0, open or 0 }, { 0, height }, { width, height } } }
  for _, points in ipairs(lines) do
    out[#out + 1] = "0\nPOLYLINE\n8\n1\n66\n1\n70\n0\n"
    for _, p in ipairs(points) do out[#out + 1] = ("0\nVERTEX\n8\n1\n10\n%g\n20\n%g\n"):format(p[1], p[2]) end
    out[#out + 1] = "0\nSEQEND\n8\n1\n"
  end
  return table.concat(out) .. "0\nENDBLK\n8\n0\n"
end
local function file(blocks, texts)
  local out = { "0\nSECTION\n2\nBLOCKS\n", table.concat(blocks), "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" }
  for _, words in ipairs(texts) do out[#out + 1] = ("0\nTEXT\n8\n1\n10\n0\n20\n0\n40\n1\n1\n%s\n"):format(words) end
  local path = os.tmpname() .. ".dxf"
  fabric.write(path, table.concat(out) .. "0\nENDSEC\n0\nEOF\n")
  return path
end
local path = file({ block("S1", { "Piece Name: SLEEVE", "Size: 36" }, 300, 420), block("S2", { "Piece Name: SLEEVE", "Size: 44" }, 340, 460), block("YOKE_36", { "Piece Name: YOKE" }, 380, 90),
  block("YOKE_44", { "Piece Name: YOKE" }, 410, 95), block("C", { "Piece Name: COLLAR" }, 400, 60, 30) }, { "Units: METRIC" })
local function panel(t)
  t.file, t.size, t.grain = path, 0.03, 0
  return fabric.mesh.panel(t)
end
local all = "'SLEEVE' (sizes '36', '44'), 'YOKE' (sizes '36', '44'), 'COLLAR' (cannot be read)"
fails("field 'piece': the file has 3 pieces: expected one of " .. all, panel, {})
fails("field 'piece': expected one of " .. all .. ", got 'CUFF'", panel, { piece = "CUFF" })
fails("field 'size_name': piece 'YOKE' is there in 2 sizes: expected one of '36', '44'", panel, { piece = "YOKE" })
fails("field 'size_name': piece 'YOKE': expected one of the sizes '36', '44', got '38'", panel, { piece = "YOKE", size_name = "38" })
fails("piece 'COLLAR': open: 2 lines on layer 1 make no closed boundary", panel, { piece = "COLLAR" })
local function close(mesh, area) assert(math.abs(mesh:check().area / area - 1) < 1e-9, mesh:check().area) end
close(panel { piece = "SLEEVE", size_name = "44" }, 0.34 * 0.46)
close(panel { piece = "S1" }, 0.3 * 0.42)
close(panel { piece = "YOKE", size_name = "36" }, 0.38 * 0.09)
assert(#said == 0, said[1])
fails("field 'size_name': expected with file= only", fabric.mesh.panel, { outline = { { 0, 0 }, { 1, 0 }, { 1, 1 } }, size = 0.1, size_name = "38" })
os.remove(path)
-- one piece in two sizes needs no name; metric lengths that may be centimetres
path = file({ block("A", { "Piece Name: FLY", "Size: L" }, 7, 26), block("B", { "Piece Name: FLY", "Size: M" }, 6.5, 25) }, { "Units: METRIC" })
fails("field 'size_name': piece 'FLY' is there in 2 sizes: expected one of 'L', 'M'", fabric.mesh.panel, { file = path, size = 0.001, grain = 0 })
fabric.mesh.panel { file = path, size = 0.001, grain = 0, size_name = "L" }
os.remove(path)
