-- fabric.lab.mesh_error: the discretisation error of a number, from three meshes and Richardson's extrapolation.
--
-- With f1, f2, f3 on meshes of size h, h/2, h/4: order p = log2 |(f1 - f2) / (f2 - f3)|, limit f3 + (f3 - f2) / (2^p - 1);
-- the error of each is its distance from the limit. If the three do not converge with an order (p below 1/2, or differences
-- of opposite sign), the limit is f3, and the error the spread of the three.
local define = require "fabric.define"
local lists = require "fabric.lists"

local function judge(f)
  local first, second = f[1] - f[2], f[2] - f[3]
  local spread = math.max(f[1], f[2], f[3]) - math.min(f[1], f[2], f[3])
  local size = math.max(math.abs(f[1]), math.abs(f[3]))
  local row = { f[1], f[2], f[3] }
  if spread <= 1e-7 * size then -- the mesh has no influence
    row.limit, row.error = f[3], size > 0 and spread / size or 0
    return row
  end
  local p = first * second > 0 and math.log(first / second, 2) or 0
  if p < 0.5 then
    row.limit, row.error = f[3], spread / size
    return row
  end
  row.order = p
  row.limit = f[3] - second / (2 ^ p - 1)
  row.error = math.abs(f[1] - row.limit) / math.abs(row.limit)
  return row
end

local function show(name, row)
  print(("  %-14s %14.6g %14.6g %14.6g %14.6g %6s %8.2g %%"):format(
    name, row[1], row[2], row[3], row.limit, row.order and ("%.1f"):format(row.order) or "-", 100 * row.error))
end

local function run(t)
  local found = {}
  for level, factor in ipairs { 1, 2, 4 } do
    for name, value in pairs(t.run(factor)) do
      found[name] = found[name] or {}
      found[name][level] = value
    end
  end
  if t.print then
    print(("  %-14s %14s %14s %14s %14s %6s %10s"):format("mesh", "1", "2", "4", "limit", "order", "+-"))
  end
  for _, name in ipairs(lists.keys(found)) do
    found[name] = judge(found[name])
    if t.print then show(name, found[name]) end
  end
  return found
end

define {
  name = "fabric.lab.mesh_error",
  arguments = {
    { name = "run", kind = "function", sentence = "function(n) that returns {name=number, ...} on a mesh refined n = 1, 2, 4 times" },
    { name = "print", kind = "boolean", default = true, sentence = "a table" },
  },
  sentence = "Richardson's estimate from three meshes. Returns, by name, {f1, f2, f3, limit=, order=, error=}: error is that of the "
    .. "first mesh, a fraction of the limit; no order where the three do not approach one, and then error is their spread.",
  example = "local r = require 'fabric'.lab.mesh_error{ run=function(n) return { area=3.14 + 0.5 / n^2 } end }\n"
    .. "assert(math.abs(r.area.limit - 3.14) < 1e-12 and math.abs(r.area.order - 2) < 1e-9)",
  run = run,
}

-- For the tests: the method mesh_error of a result. numbers(result) returns {name=number}; run(t) repeats the test with its
-- fields t, with n times as many cells (a number, or one for each direction; default: `cells`), without files.
return function(first, t, run, numbers, cells)
  local function again(n)
    local fields = lists.copy(t)
    fields.out, cells = nil, t.cells or cells
    fields.cells = type(cells) == "table" and { cells[1] * n, cells[2] * n } or cells * n
    return run(fields)
  end
  return function(_, options)
    local fabric = require "fabric"
    return fabric.lab.mesh_error {
      print = not options or options.print ~= false,
      run = function(n) return numbers(n == 1 and first or again(n)) end,
    }
  end
end
