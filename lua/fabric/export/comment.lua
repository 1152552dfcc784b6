-- Writes lines of text as comments of a deck, each after the solver's comment mark.
return function(mark)
  return function(lines)
    local out = {}
    for _, l in ipairs(lines) do out[#out + 1] = mark .. " " .. l end
    return table.concat(out, "\n")
  end
end
