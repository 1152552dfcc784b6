-- Concatenates lists of argument rows that several functions of the laboratory share.
return function(...)
  local out = {}
  for _, list in ipairs { ... } do table.move(list, 1, #list, #out + 1, out) end
  return out
end
