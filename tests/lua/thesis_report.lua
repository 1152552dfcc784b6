-- The command that runs chapter 7, on two of its decks: a report that stands alone, and a failing deck that fails the command.
local here = arg[0]:gsub("tests/lua/[^/]*$", "scripts/thesis/")
local own = arg
arg = { [0] = here .. "all.lua", [-1] = own[-1], "table_7_5_kilby", "fig_7_28_shear_reload" }
dofile(arg[0])
local file = assert(io.open "out/thesis/report.html")
local html = file:read "a"
file:close()
assert(html:find("<h2>Table 7.5: initial shear moduli</h2>", 1, true) and html:find("<h2>7-28: ", 1, true))
assert(html:find("<td>blend: G12 at zero strain, MPa</td><td>present 1.09</td>", 1, true))
assert(html:find("not public", 1, true))
-- Nothing outside is asked for: every source is inside.
local inside = 0
for source in html:gmatch 'src="([^"]*)"' do
  assert(source:find "^data:image/[a-z+]+;base64,[%w+/]+=*$", source:sub(1, 60))
  inside = inside + 1
end
assert(not html:find "href=" and not html:find "<script")
print(inside .. " images")

-- Base 64 of RFC 4648, section 10.
local report = dofile(here .. "report.lua")
for plain, coded in pairs { [""] = "", f = "Zg==", fo = "Zm8=", foo = "Zm9v", foob = "Zm9vYg==", fooba = "Zm9vYmE=", foobar = "Zm9vYmFy" } do
  assert(report.base64(plain) == coded)
end

arg = { [0] = here .. "all.lua", "fig_9_99" }
local ok, message = pcall(dofile, arg[0])
assert(not ok and tostring(message):find("no deck 'fig_9_99'", 1, true))
