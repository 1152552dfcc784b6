-- What the tests in the folder above share.
local check = {}

-- f(...) ends with an error that contains the words.
function check.fails(words, f, ...)
  local ok, message = pcall(f, ...)
  if ok or not tostring(message):find(words, 1, true) then
    error(('expected an error with "%s", got %s'):format(words, ok and "none" or tostring(message)), 2)
  end
end

-- got is want within `relative` of it.
function check.near(got, want, relative, what)
  if not (math.abs(got - want) <= relative * math.abs(want)) then
    error(("%s: got %.9g, want %.9g within %g"):format(what, got, want, relative), 2)
  end
end

-- The largest height of a run's nodes above or below z = 0, m.
function check.highest(a)
  local most = 0
  for _, z in ipairs(a:field "z") do most = math.max(most, math.abs(z)) end
  return most
end

-- The exit code of a shell's command, and what it printed.
function check.shell(command)
  local pipe = assert(io.popen(command))
  local talk = pipe:read "a"
  local _, _, code = pipe:close()
  return code, talk
end

-- The bytes of a folder's files by name, but for run.json and checkpoints; and how many files these are.
function check.contents(folder)
  local all, count = {}, 0
  for _, name in ipairs(require("fabric").folder(folder)) do
    if not name:find("run.json", 1, true) and not name:find(".ckpt", 1, true) then
      local file = assert(io.open(folder .. "/" .. name, "rb"))
      all[name], count = file:read "a", count + 1
      file:close()
    end
  end
  return all, count
end

-- The same of this program with some words, in which a deck ends itself in the step of the number KILL_AT.
function check.program(words, kill_at, more)
  return check.shell(("%s KILL_AT=%s OMP_NUM_THREADS=1 '%s' --quiet %s 2>&1"):format(more or "", kill_at or "", arg[-1], words))
end

-- The contents of the folder "work" after a deck that writes there, and after it was killed in a step and went on from a
-- checkpoint. more: variables of the shell.
function check.whole(deck, more)
  os.execute "rm -rf work; mkdir work"
  local code, talk = check.program(deck, nil, more)
  assert(code == 0, talk)
  return check.contents "work"
end
function check.restarted(deck, kill_at, checkpoint, more)
  os.execute "rm -rf work; mkdir work"
  local code, talk = check.program(deck, kill_at, more)
  assert(code == 9, talk)
  code, talk = check.program(("--restart work/%s %s"):format(checkpoint, deck), nil, more)
  assert(code == 0, talk)
  return check.contents "work"
end

-- A mesh of quadrilaterals as one of triangles with the same sets.
function check.in_triangles(mesh)
  local fabric = require "fabric"
  local nodes, elements = {}, {}
  for i = 1, #mesh.nodes do nodes[i] = mesh.nodes[i] end
  for e = 1, #mesh.elements do
    local a, b, c, d = table.unpack(mesh.elements[e])
    table.insert(elements, { a, b, c })
    table.insert(elements, { a, c, d })
  end
  local cut = fabric.mesh { nodes = nodes, elements = elements }
  for _, name in ipairs(mesh.sets) do
    if name ~= "all" then cut:set(name, mesh:set(name)) end
  end
  return cut
end

return check
