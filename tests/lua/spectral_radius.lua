-- Implicit motion with a chosen spectral radius: what of a vibration much faster than the steps is left, where the rest goes, and the direct solver's choice.
local fabric = require "fabric"
local card = fabric.svk { name = "stiff", warp = 1e8, weft = 1e8, shear = 4e7, poisson = { 0, 0 }, density = 500, thickness = 1e-3 }

local function strip(options)
  local mesh = fabric.mesh.rectangle { width = 0.02, height = 0.01, nx = 1, ny = 1 }
  local m = fabric.model { mesh = mesh, card = card, warp = 0 }
  m:fix("left", "x y z rotation"):fix("right", "y z rotation"):velocity("right", { x = 1e-4 })
  local o = { model = m, duration = 0.3, scheme = "implicit", step = 0.01 } -- a period takes 0.2 ms
  for k, v in pairs(options) do o[k] = v end
  local a = fabric.dynamic(o)
  local sizes = {}
  a:every("step", function(run)
    local e = run.energy
    sizes[#sizes + 1] = math.sqrt(e.kinetic + e.stored)
  end)
  a:solve()
  return sizes, a
end

for _, radius in ipairs { 1, 0.9, 0.6, 0.3, 0 } do
  local sizes, a = strip { spectral_radius = radius }
  local e = a.energy
  -- From step to step, in the mean of the last ones; of alpha two equal modes are left, so that it comes near it slowly.
  local left = radius > 0 and (sizes[31] / sizes[21]) ^ 0.1 or sizes[4] / sizes[1]
  fabric.expect {
    { ("radius %g: what is left of the amplitude"):format(radius), left, radius, absolute = radius < 0.5 and 1e-3 or radius < 1 and 0.05 or 1e-6 },
    { ("radius %g: the loss, J"):format(radius), e.damping + e.kinetic + e.stored, sizes[1] ^ 2, relative = 1e-6 },
  }
end

local radius = strip { spectral_radius = 0 }
local slow = strip { slow = true, linear = "unsymmetric" }
assert(math.abs(radius[2] - slow[2]) < 1e-9 * radius[1])

local function says(words, chunk)
  local ok, e = pcall(chunk)
  assert(not ok and tostring(e):find(words, 1, true), tostring(e))
end
says("dynamic: field 'spectral_radius': expected without 'gamma', 'beta' and 'hht', which choose the scheme in another way", function() strip { spectral_radius = 0.5, hht = -0.1 } end)
says("dynamic: field 'spectral_radius': unknown for scheme=\"explicit\", which damps nothing", function() strip { spectral_radius = 0.5, scheme = "explicit", step = "auto" } end)
says("field 'linear': unknown for scheme=\"explicit\", which solves no equations", function() strip { linear = "symmetric", scheme = "explicit", step = "auto" } end)
says("expected with scheme=\"implicit\": explicit steps follow every wave", function() strip { slow = true, scheme = "explicit", step = "auto" } end)
