-- A budget of a number that nothing changes has no interval, and its table says so instead of stating one of zero width.
local fabric = require "fabric"
local none = fabric.budget { print = false, run = function() return { y = 3.25 } end }
local some = fabric.budget { print = false, samples = 16, assumed = { a = { 1, 2 }, b = { 0, 1 } }, run = function(p) return { x = p.assumed.a, y = 7, z = p.assumed.b } end }

local function says(text, words) return text:find(words, 1, true) and 1 or 0 end
fabric.expect {
  { "nothing was varied", says(none.text, "y = 3.25, without an interval: nothing was varied\n"), 1, absolute = 0 },
  { "nothing that was varied changes it", says(some.text, "y = 7, without an interval: nothing that was varied changes it"), 1, absolute = 0 },
  { "what was varied has one", says(some.text, "x = 1.5, 95 % between"), 1, absolute = 0 },
  { "none of zero width is stated", says(none.text .. some.text, "between 7 and 7") + says(none.text, "between 3.25"), 0, absolute = 0 },
}
