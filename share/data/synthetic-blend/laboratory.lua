-- synthetic: made by scripts/lab/sample_data.lua from share/cards/blend.lua, not measured
return {
  name = "synthetic blend", source = "synthetic sample data (scripts/lab/sample_data.lua)",
  gauge_length = 76.2e-3, width = 25.4e-3, thickness = 0.38e-3, plies = 2, -- a sewn loop on two pins
  mass_per_area = 0.2242, markers = { 4, 3 }, compliance = 2e-7, slip = 1e-6, shared = 0.005,
}
