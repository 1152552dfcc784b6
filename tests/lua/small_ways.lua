-- Short ways in: a mesh from lists, names of sets of bodies, a card's estimate where there is none to make, words that help knows.
local fabric = require "fabric"

-- Two bodies of one model: their sets stand in the list and can be used.
local a = fabric.mesh{ nodes={ {0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1} }, elements={ {1, 2, 3, 4} } }
a:set("foot", { 1, 2 })
local b = fabric.mesh.rectangle{ width=0.1, height=0.1, nx=1, ny=1, origin={0, 0, 0.1} }
local model = fabric.model{ bodies={ { name="low", mesh=a, card=fabric.card "blend", warp={1, 0, 0} }, { name="high", mesh=b, card=fabric.card "blend" } } }
local names = " " .. table.concat(model.mesh.sets, " ") .. " "
for _, name in ipairs { "low.foot", "low.all", "high.left", "all" } do assert(names:find(" " .. name .. " ", 1, true), names) end
model:fix("low.foot", "x y z")

-- A module that is no function says so.
local ok, why = pcall(function() return fabric.rigid{} end)
assert(not ok and tostring(why):find("fabric.rigid: it is no function; it holds functions, as fabric.rigid.", 1, true), why)

-- A card with a rigidity of its own keeps it.
local measured
for _, name in ipairs(fabric.cards()) do
  local card = fabric.card(name)
  if card.bending and not card.estimate then measured = name end
end
assert(measured and fabric.card(measured, { bending="estimated" }) == fabric.card(measured))
assert(fabric.card("denim", {}).name == "denim")

local heard, old = {}, print
print = function(text) heard[#heard + 1] = tostring(text) end
for word, wanted in pairs { movie="ffmpeg", mp4="ffmpeg", wind="model:pressure", sew="model:tie", cut="annulus" } do
  heard = {}
  fabric.help(word)
  assert(table.concat(heard, "\n"):find(wanted, 1, true), word)
end
print = old

-- Columns of a file in its order.
local file = os.tmpname()
local out = assert(io.open(file, "w"))
out:write "time (s),force (N),angle\n0,1,2\n1,2,3\n"
out:close()
assert(table.concat(fabric.columns(fabric.table{ file=file }):names(), " ") == "time force angle")
os.remove(file)
