-- Opens files below a folder that somebody swaps for a link all the time: it may fail or give what is the deck's, no more.
local here = arg[0]:gsub("[^/]*$", "")
local root = here:gsub("deck/$", "")
local fabric = require "fabric"
local got, missed, i = 0, 0, 0
-- Until both have happened: on a busy machine the one who swaps may begin late.
while i < 20000 or i < 5e6 and (got <= 100 or missed <= 100) do
  i = i + 1
  local file = io.open(here .. "swap/key.csv")
  if file then
    got = got + 1
    assert(file:read "l" == "mine", "read a secret")
    file:close()
  else
    missed = missed + 1
  end
  local made = io.open(root .. "out/swap/made.csv", "w")
  if made then made:close() end
  if i % 20 == 0 then pcall(fabric.mesh.rectangle { width = 1, height = 1, nx = 1, ny = 1 }.write, fabric.mesh.rectangle { width = 1, height = 1, nx = 1, ny = 1 }, root .. "out/swap/mesh.msh") end
  os.remove(root .. "out/swap/key.csv")
end
assert(got > 100 and missed > 100, "nobody swapped")
print(("never came through: %d read, %d refused"):format(got, missed))
