-- An identification in words: first whether the data contradict it; then values with deviations, bounds that were reached, correlations,
-- residuals, and the benefit of further tests.

local function list_parameters(lines, t, out)
  for i, parameter in ipairs(t.parameters) do
    local bound = out.on_bound[parameter.name]
    local words = ("+- %.3g"):format(out.deviation[i])
    if bound then
      words = "   no error bar"
    elseif not out.known[parameter.name] then
      words = "   not known: the data leave it within its bounds"
    end
    lines[#lines + 1] = ("%-16s %12.6g %s"):format(parameter.name, out.x[i], words)
  end
  for _, parameter in ipairs(t.parameters) do
    local bound = out.on_bound[parameter.name]
    if bound then lines[#lines + 1] = ("%s lies on its bound %g: no error bar"):format(parameter.name, bound) end
  end
end

local function list_pairs(lines, t, out)
  local n = #t.parameters
  for i = 1, n do
    for j = i + 1, n do
      local a, b, c = t.parameters[i].name, t.parameters[j].name, out.correlation[(i - 1) * n + j]
      if math.abs(c) > 0.95 and not out.on_bound[a] and not out.on_bound[b] then
        local how = not out.known[a] and not out.known[b] and "cannot be told apart" or "are correlated"
        lines[#lines + 1] = ("%s and %s %s (correlation %.3f)"):format(a, b, how, c)
      end
    end
  end
end

local function list_misses(lines, t, out)
  for _, test in ipairs(t.tests) do
    local miss = out.misses[test.name]
    local size = miss.worst < math.huge and ("%.3g %% of the largest value"):format(100 * miss.worst) or "of values that are all zero"
    lines[#lines + 1] = ("%s: largest miss %s, %.3g deviations"):format(test.name, size, miss.deviations)
  end
  lines[#lines + 1] = ("chi^2 per degree of freedom %.4g"):format(out.chi2)
end

return function(t, out)
  local lines = {}
  local missed = out.discrepancy
  if missed and missed.told then
    lines[1] = ("The data contradict the model: they differ by more than the noise, smoothly, by about %.2g times as much (by chance in fewer than one case of a hundred); the error bars hold such differences"):format(
      missed.deviation)
  elseif out.chi2 > 4 then
    lines[1] = ("The data contradict the model: they differ by more than the noise; the error bars are widened by %.3g, and may mean little"):format(
      math.sqrt(out.chi2))
  end
  list_parameters(lines, t, out)
  list_pairs(lines, t, out)
  list_misses(lines, t, out)
  for _, test in ipairs(out.further) do
    lines[#lines + 1] = ("with %s the weakest combination would be known to %.3g instead of %.3g of the bounds' width"):format(
      test.name, test.weakest_deviation, out.weakest_deviation)
  end
  lines[#lines + 1] = ("%s after %d iterations and %d simulations"):format(out.reason, out.iterations, out.simulations)
  return table.concat(lines, "\n")
end
