-- Cards of other solvers' decks that change a material and are not read are named in the report.
local fabric = require "fabric"
local said = {}
fabric.warn = function(words) said[#said + 1] = words end
for _, case in ipairs {
  { "openradioss", "rad", "/LEAK/MAT/1\n         2\n/FAIL/TAB1/1\n", "/LEAK/MAT, /FAIL/TAB1 of the file (lines %d, %d) are not read, and what they do to the material is lost", 2 },
  { "ls-dyna", "k", "*MAT_ADD_EROSION\n         1\n", "*MAT_ADD_EROSION of the file (line %d) is not read, and what it does to the material is lost", 0 },
  { "abaqus", "inp", "*DAMPING, ALPHA=3\n", "*DAMPING of the file (line %d) is not read, and what it does to the material is lost", 0 },
} do
  local path = os.tmpname() .. "." .. case[2]
  fabric.export.card { card = fabric.card "denim", to = case[1], file = path }
  local text = assert(io.open(path)):read "a"
  local whole = fabric.import.card { file = path, thickness = 4e-4, misfit = 500 }
  for _, note in ipairs(whole.notes) do assert(not note:find "^cards:", note) end
  local kept = text:gsub("%*END%s*$", ""):gsub("/END%s*$", "")
  local _, line = kept:gsub("\n", "\n")
  fabric.write(path, kept .. case[3])
  said = {}
  local more = fabric.import.card { file = path, thickness = 4e-4, misfit = 500 }
  local want, found = case[4]:format(line + 1, line + 1 + case[5]), false
  for _, note in ipairs(more.notes) do found = found or note == "cards: " .. want end
  assert(found, want .. "\n" .. table.concat(more.notes, "\n"))
  found = false
  for _, words in ipairs(said) do found = found or words:find(want, 1, true) ~= nil end
  assert(found and more.report:find(want, 1, true), "not told: " .. want)
  os.remove(path)
end
