-- Shared by the tests in the folder above.
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

-- Writes a file of the deck's folder, a script for instance.
function check.write(path, text)
  local f <close> = assert(io.open(path, "w"))
  f:write(text)
end

-- From the present state to a time and, restored, once more: places and velocities of the nodes, and the numbers
-- that read() returns, have the same bits.
function check.same_after_restore(a, nodes, to, read)
  local began, kept = a.time, a:snapshot()
  local function state()
    a:advance(to)
    local list = { read() }
    for i = 1, nodes do
      local p = a:node(i)
      table.move({ p.x, p.y, p.z, p.vx, p.vz }, 1, 5, #list + 1, list)
    end
    return table.concat(list, " ")
  end
  local ended = state()
  a:restore(kept)
  assert(a.time == began and state() == ended, "a restart changes bits")
end

-- The complete elliptic integrals of the first and the second kind, of the modulus k.
function check.elliptic(k)
  local K, E, n = 0, 0, 2000
  for i = 1, n do
    local s = math.sin(math.pi / 2 * (i - 0.5) / n)
    local root = math.sqrt(1 - k * k * s * s)
    K, E = K + math.pi / 2 / n / root, E + math.pi / 2 / n * root
  end
  return K, E
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

-- The output of the running deck as a child with these options, whose argument is `what`.
function check.child(options, what)
  local pipe = assert(io.popen(("'%s' --quiet %s '%s' %s 2>/dev/null"):format(arg[-1], options, arg[0], what)))
  local text = pipe:read "a"
  assert(pipe:close(), options .. " " .. what)
  return text
end

-- A deck prints the same bytes for each scheme, of which there are more than `least`: on 1 and 2 threads, and where it ends itself on the way
-- ("dies", exit code 9) and goes on from its checkpoint. The short form has both at once: it dies and goes on with 2 threads.
function check.same_bits(deck, checkpoint, schemes, least)
  local long = os.getenv "FABRICSH_TEST_LONG"
  local function program(words) return check.shell(("'%s' --quiet %s 2>%s.log"):format(arg[-1], words, deck)) end
  for _, scheme in ipairs(schemes) do
    os.remove(checkpoint)
    local code, first = program(("--threads 1 %s %s"):format(deck, scheme))
    assert(code == 0 and #first > least, scheme .. ": " .. code)
    if long then
      local _, two = program(("--threads 2 %s %s"):format(deck, scheme))
      assert(two == first, scheme .. ", 2 threads")
      os.remove(checkpoint)
    end
    code = program(("--threads 2 %s %s dies"):format(deck, scheme))
    assert(code == 9, scheme .. ": " .. code)
    local _, again = program(("--threads %d --restart %s %s %s"):format(long and 1 or 2, checkpoint, deck, scheme))
    assert(again == first, scheme .. ", after a restart")
    print(("%s: the same %d bytes with 1 and 2 threads and after a restart"):format(scheme, #first))
  end
end

-- The mesh with other nodes, f(x, y, z) in the place of x, y, z.
function check.moved(mesh, f)
  local fabric = require "fabric"
  local places, elements = {}, {}
  for i = 1, #mesh.nodes do places[i] = { f(table.unpack(mesh.nodes[i])) } end
  for i = 1, #mesh.elements do elements[i] = mesh.elements[i] end
  local copy = fabric.mesh { nodes = places, elements = elements }
  for _, name in ipairs(mesh.sets) do copy:set(name, mesh:set(name)) end
  return copy
end

-- A quarter of a pillow of two membranes, n elements a side, sewn within `over`; start: where its nodes begin, nil: flat.
function check.pillow(p)
  local fabric, n = require "fabric", p.n
  local function body(name, z)
    local cut = fabric.mesh.rectangle { width = p.side / 2, height = p.side / 2, nx = n, ny = n, triangles = p.triangles }
    cut:map(function(x, y) return x, y, z end)
    return { name = name, mesh = p.start and check.moved(cut, p.start) or cut, reference = p.start and cut or nil, card = p.card, warp = 0 }
  end
  local m = fabric.model { membrane = true, bodies = { body("up", p.gap / 2), body("down", -p.gap / 2) } }
  for _, edge in ipairs { "right", "top" } do m:seam { "up." .. edge, "down." .. edge, over = p.over, hinge = true } end
  for _, name in ipairs { "up", "down" } do m:symmetry(name .. ".left", "x"):symmetry(name .. ".bottom", "y") end
  m.mesh:set("below", { 1 + (n + 1) * (n + 1) })
  return m:fix("below", "z")
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
