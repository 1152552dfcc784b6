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

return loading
