-- With --quiet a run says what it warns of, and nothing of what it chose: contact, seams, tearable zones.
local fabric = require "fabric"

if arg[1] then -- as a child
  local sheet = fabric.svk { young = 1e8, poisson = 0, density = 500, thickness = 5e-4, rupture = { warp = { strength = 4e3, energy = 20 }, weft = { strength = 4e3, energy = 20 } } }
  local left = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 4, ny = 4 }
  local right = fabric.mesh.rectangle { width = 0.02, height = 0.02, nx = 4, ny = 4, origin = { 0.02, 0 } }
  left:set("zone", function(x) return x < 0.011 end)
  local m = fabric.model { membrane = true, bodies = { { name = "left", mesh = left, card = sheet, warp = 0 }, { name = "right", mesh = right, card = sheet, warp = 0 } } }
  m:seam { "left.right", "right.left" }:tearable("left.zone", { coarse = "keep" })
  m:contact { between = { fabric.rigid.plane { point = { 0, 0, -1e-3 }, normal = { 0, 0, 1 }, name = "floor" }, "all" }, friction = 0.2 }
  m:gravity { 0, 0, -9.81 }
  fabric.dynamic { model = m, duration = 1e-4 }:solve()
  return fabric.warn "something to know"
end

local function said(option)
  local pipe = assert(io.popen(("'%s' %s '%s' child 2>&1"):format(arg[-1], option, arg[0])))
  local text = pipe:read "a"
  assert(pipe:close(), text)
  return text
end
local loud, quiet = said "", said "--quiet"
for _, words in ipairs { "contact: floor on the cloth", "seam of 'left.right' and 'right.left'", "tearable zone" } do
  assert(loud:find(words, 1, true), loud)
  assert(not quiet:find(words, 1, true), quiet)
end
assert(quiet:find("^warning: [^\n]*something to know\n$"), quiet)
