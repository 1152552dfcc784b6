-- Lines of text as comments of a deck, each behind the solver's mark.
return function(mark)
  return function(lines)
    local out = {}
    for _, l in ipairs(lines) do out[#out + 1] = mark .. " " .. l end
    return table.concat(out, "\n")
  end
end
