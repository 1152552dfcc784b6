-- The report of chapter 7 as one HTML file that needs nothing else: pictures and curves stand inside it.
-- all.lua calls report.write(path, chapter, runs); run by itself this file does nothing.
local report = {}

local letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"
local digit = {}
for i = 0, 63 do digit[i] = letters:sub(i + 1, i + 1) end

-- Base 64 [RFC 4648].
function report.base64(bytes)
  local out = {}
  for i = 1, #bytes, 3 do
    local a, b, c = bytes:byte(i, i + 2)
    local n = a << 16 | (b or 0) << 8 | (c or 0)
    out[#out + 1] = digit[n >> 18] .. digit[n >> 12 & 63] .. (b and digit[n >> 6 & 63] or "=") .. (c and digit[n & 63] or "=")
  end
  return table.concat(out)
end

local function escape(text) return (tostring(text):gsub("[&<>\"]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" })) end

local function image(figure)
  local file = assert(io.open(figure.file, "rb"))
  local bytes = file:read "a"
  file:close()
  local kind = figure.file:match "%.svg$" and "image/svg+xml" or "image/png"
  return ('<figure><img alt="%s" src="data:%s;base64,%s"><figcaption>%s</figcaption></figure>\n'):format(
    escape(figure.sentence), kind, report.base64(bytes), escape(figure.sentence))
end

local head = [[
<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Chapter 7, figure by figure</title>
<style>
body { font: 15px/1.45 sans-serif; max-width: 75em; margin: 2em auto; padding: 0 1em; color: #111 }
table { border-collapse: collapse; width: 100%; margin: 0.5em 0 1.5em } td, th { border-bottom: 1px solid #ccc; padding: 0.25em 0.6em; text-align: left; vertical-align: top }
th { border-bottom: 2px solid #555 } figure { display: inline-block; margin: 0.5em; width: 46%; vertical-align: top } img { max-width: 100% }
figcaption { font-size: 90%; color: #333 } .failed { color: #a00; font-weight: bold }
</style></head><body>
<h1>Chapter 7, figure by figure</h1>
<p>R. W. Williams, <i>Measuring and modeling the anisotropic, nonlinear and hysteretic behavior of woven fabrics</i>, University of Iowa, 2010.</p>
<p><b>Which comparison is which.</b> The column <i>thesis</i> holds what its text states. Its measured curves are not public, so those
numbers are quoted and never scored. <i>Ours</i> is the default law with the measured ratios unless the line says otherwise. <i>Its rules</i> is this
program with the thesis' endpoint integration, and for duck and muslin with both ratios cut to 0.40 where the line doesn't name them. The checks,
which fail the run when missed, are closed forms of the cards (P(E), the unloading line, the energy lost, simple shear, equal biaxial strain,
the elastica) and facts that follow from them (mirror images, energy balances, no checkerboard). Errors are against P(E), the curve that the
card is made of, not against a measurement. Three numbers and an arrow are three meshes and their limit after Richardson, with the error of the first.</p>
<p>Where the text gives several percentages of one measurement, the lines show what each of them implies; some can't hold together.</p>
]]

local function rows_of(chapter, figure)
  local out = { "<table><tr><th>quantity</th><th>thesis (quoted)</th><th>ours</th><th>its rules</th></tr>\n" }
  for _, row in ipairs(chapter.rows) do
    if row.figure == figure then
      out[#out + 1] = ("<tr><td>%s</td><td>%s</td><td>%s</td><td>%s</td></tr>\n"):format(escape(row.quantity), escape(row.thesis), escape(row.ours), escape(row.rules))
    end
  end
  return #out > 1 and table.concat(out) .. "</table>\n" or ""
end

-- runs: a list of { figure=, title=, deck=, seconds=, trouble= or nil }.
function report.write(path, chapter, runs)
  local file = assert(io.open(path, "w"))
  file:write(head)
  for _, run in ipairs(runs) do
    file:write(("<h2>%s: %s</h2>\n"):format(escape(run.figure), escape(run.title)))
    if run.trouble then file:write(('<p class="failed">%s</p>\n'):format(escape(run.trouble))) end
    file:write(rows_of(chapter, run.figure))
    for _, figure in ipairs(chapter.figures) do
      if figure.figure == run.figure then file:write(image(figure)) end
    end
    file:write(("<p>scripts/thesis/%s.lua, %.1f s</p>\n"):format(escape(run.deck), run.seconds))
  end
  file:write("</body></html>\n")
  assert(file:close())
end

return report
