-- The loading curve of a card's part, or of a fit: {d0, d1, ...}, moduli, or points {strain, stress}.
local loading = {}

-- Its stress at a strain; points are joined by lines, of which the last goes on.
function loading.stress(curve, E)
  if type(curve[1]) ~= "table" then
    local S = 0
    for k, d in ipairs(curve) do S = S + d * E ^ k / k end
    return S
  end
  local k = 2
  while k < #curve and curve[k][1] < E do k = k + 1 end
  local a, b = curve[k - 1], curve[k]
  return a[2] + (E - a[1]) * (b[2] - a[2]) / (b[1] - a[1])
end

-- The tangent of moduli at a strain, Pa.
function loading.tangent(moduli, E)
  local D = 0
  for k, d in ipairs(moduli) do D = D + d * E ^ (k - 1) end
  return D
end

-- Largest and smallest tangent up to a strain and the one at zero, Pa: of points between all of them, of moduli at so many places and zero.
function loading.tangents(curve, tested, places)
  local steepest, least, first = 0, math.huge, nil
  local function see(D) steepest, least, first = math.max(steepest, D), math.min(least, D), first or D end
  if type(curve[1]) ~= "table" then
    for i = 0, places do see(loading.tangent(curve, tested * i / places)) end
    return steepest, least, curve[1]
  end
  for i = 2, #curve do see((curve[i][2] - curve[i - 1][2]) / (curve[i][1] - curve[i - 1][1])) end
  return steepest, least, first
end

return loading
