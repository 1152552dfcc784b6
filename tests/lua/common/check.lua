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

return check
