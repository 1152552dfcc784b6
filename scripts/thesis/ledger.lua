-- Ledger figure of a test in motion: energies over time, what one law makes out of nothing. Run by itself this file does nothing.
local here = (arg[0]:gsub("[^/]*$", ""):gsub("long/thesis/$", "thesis/"))
local chapter = dofile(here .. "chapter.lua")
local ledger = {}

-- kinetic + stored + dissipated + damping lies on external where no energy is made.
function ledger.plot(name, title, curve)
  local curves = {}
  for _, column in ipairs { "kinetic", "stored", "dissipated" } do
    curves[#curves + 1] = chapter.curve(curve, column, "line", "time", column, 1)
  end
  local sum = {}
  for i, r in ipairs(curve) do sum[i] = { time = r.time, sum = r.kinetic + r.stored + r.dissipated + r.damping } end
  curves[4] = chapter.curve(sum, "their sum", "line", "time", "sum", 1)
  curves[5] = chapter.curve(curve, "external work", "dashed", "time", "external", 1)
  chapter.plot(name, "Kinetic, stored and dissipated energy; their sum lies on the external work.",
               { title = title, xlabel = "t, s", ylabel = "energy, J", curves = curves })
end

function ledger.row(what, curve, quoted)
  local last = curve[#curve]
  chapter.row(what .. ": ledger's error over the external work; dissipated warp, weft, shear, J", quoted,
              ("%.1e; %.3g %.3g %.3g"):format(last.error, last.dissipated_warp, last.dissipated_weft, last.dissipated_shear))
end

-- The largest of a column, and the row at a time.
function ledger.largest(curve, column)
  local most = -math.huge
  for _, r in ipairs(curve) do most = math.max(most, r[column]) end
  return most
end

return ledger
