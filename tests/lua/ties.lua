-- Ties from the side of a deck: words taken and refused.
local fabric = require 'fabric'
local function fails(f, words)
  local ok, why = pcall(f)
  assert(not ok and tostring(why):find(words, 1, true), 'expected "' .. words .. '", got ' .. tostring(why))
end
local function model()
  local mesh = fabric.mesh.rectangle{ width=0.1, height=0.1, nx=2, ny=2 }
  return fabric.model{ mesh=mesh, card=fabric.card 'blend' }
end
model():tie('equal', 'top', 'x y'):tie('straight', 'bottom'):tie('periodic', 'left', 'right', 'z')
fails(function() model():tie('stiff', 'top') end, 'expected "equal", "straight", "rigid" or "periodic", got "stiff"')
fails(function() model():tie('equal', 'top') end, 'expected some of x y z')
fails(function() model():tie('equal', 'top', 'x rx') end, 'tie: expected some of x y z')
fails(function() model():tie('periodic', 'left') end, 'name of the set that follows')
fails(function() model():tie('rigid', 'top', 'x') end, 'ties every freedom')
