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

return check
