-- Means over a window of time, for what chatters from step to step: friction, contact, reactions of explicit runs.

-- The mean of y(t), straight between its points, over the `width` seconds about each point; at both ends over the part of them that there is.
return function(t, y, width)
  local n, integral, out = #t, { 0 }, {}
  for i = 2, n do integral[i] = integral[i - 1] + (t[i] - t[i - 1]) * (y[i] + y[i - 1]) / 2 end
  local function upto(time, k) -- of y from the first point; t[k] <= time <= t[k + 1]
    if k >= n then return integral[n] end
    local part = time - t[k]
    return integral[k] + part * (y[k] + (y[k + 1] - y[k]) * part / (t[k + 1] - t[k]) / 2)
  end
  local low, high = 1, 1
  for i = 1, n do
    local from, to = math.max(t[1], t[i] - width / 2), math.min(t[n], t[i] + width / 2)
    while low < n and t[low + 1] <= from do low = low + 1 end
    while high < n and t[high + 1] <= to do high = high + 1 end
    out[i] = to > from and (upto(to, high) - upto(from, low)) / (to - from) or y[i]
  end
  return out
end
