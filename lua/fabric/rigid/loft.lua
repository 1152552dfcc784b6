-- Closed surfaces through rings of as many points each, one ring after the other, with a point before the first and one after the last.
local fabric = require "fabric"
local loft = {}

local function cross(a, b) return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] } end
local function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
local function unit(a)
  local n = math.sqrt(dot(a, a))
  return { a[1] / n, a[2] / n, a[3] / n }
end

-- {place, e1, e2, e3}: e3 along `axis`, e1 as near to `towards` as is at right angles to it. fail(field, words) refuses directions.
function loft.frame(from, axis, towards, fail)
  for name, v in pairs { from = from, axis = axis, towards = towards } do
    if #v ~= 3 then fail(name, ("expected {x, y, z}, got %d numbers"):format(#v)) end
  end
  if dot(axis, axis) == 0 then fail("axis", "expected a direction, got {0, 0, 0}") end
  local e3 = unit(axis)
  local along = dot(towards, e3)
  local aside = { towards[1] - along * e3[1], towards[2] - along * e3[2], towards[3] - along * e3[3] }
  if dot(aside, aside) <= 1e-12 * dot(towards, towards) then fail("towards", "expected a direction that is not along the axis") end
  local e1 = unit(aside)
  return { from, e1, cross(e3, e1), e3 }
end

-- The point of space with the coordinates a, b, c in a frame.
function loft.point(frame, a, b, c)
  local o, e1, e2, e3 = frame[1], frame[2], frame[3], frame[4]
  return { o[1] + a * e1[1] + b * e2[1] + c * e3[1], o[2] + a * e1[2] + b * e2[2] + c * e3[2], o[3] + a * e1[3] + b * e2[3] + c * e3[3] }
end

-- Facets of a body, in all of its shapes together: more would fill the memory long before a run could use them.
local most = 4000000

-- Refuses, before the first point is made, more facets than that. fail(field, words); `of` says what gives the number of rings.
function loft.check_facets(around, rings, shapes, fail, field)
  if around * rings * shapes <= most then return end
  fail(field, ("expected at most %d facets, got %.10g x %.10g (around, along)%s"):format(most, around, rings, shapes > 1 and (" in %.10g shapes"):format(shapes) or ""))
end

-- rings: lists of points, counter-clockwise as seen from the last ring; first and last: the points that close the surface. Its facets are
-- counter-clockwise from outside. Node 1 is `first`, ring k begins with node 2 + (k - 1) n.
function loft.mesh(first, rings, last)
  local n, nodes, elements = #rings[1], { first }, {}
  for _, ring in ipairs(rings) do table.move(ring, 1, #ring, #nodes + 1, nodes) end
  nodes[#nodes + 1] = last
  local function at(k, i) return 2 + (k - 1) * n + (i - 1) % n end
  for i = 1, n do elements[#elements + 1] = { 1, at(1, i + 1), at(1, i) } end
  for k = 1, #rings - 1 do
    for i = 1, n do elements[#elements + 1] = { at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i) } end
  end
  for i = 1, n do elements[#elements + 1] = { at(#rings, i), at(#rings, i + 1), #nodes } end
  return fabric.mesh { nodes = nodes, elements = elements }
end

-- The nodes of rings k to l that `where(i)`, i = 1 to n, accepts.
function loft.nodes(n, k, l, where)
  local out = {}
  for ring = k, l do
    for i = 1, n do
      if not where or where(i) then out[#out + 1] = 2 + (ring - 1) * n + i - 1 end
    end
  end
  return out
end

return loft
