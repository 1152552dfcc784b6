-- Normal random numbers from a seed, the same on every machine and independent of math.random [steele2014].
local function random(seed)
  local state, spare = seed, nil
  local function uniform() -- in (0, 1)
    state = state + 0x9E3779B97F4A7C15
    local z = state
    z = (z ~ (z >> 30)) * 0xBF58476D1CE4E5B9
    z = (z ~ (z >> 27)) * 0x94D049BB133111EB
    return (((z ~ (z >> 31)) >> 11) + 0.5) * 2.0 ^ -53
  end
  local function normal() -- [box1958]
    if spare then
      local value = spare
      spare = nil
      return value
    end
    local radius, angle = math.sqrt(-2 * math.log(uniform())), 2 * math.pi * uniform()
    spare = radius * math.sin(angle)
    return radius * math.cos(angle)
  end
  return { uniform = uniform, normal = normal }
end

return random
