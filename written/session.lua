-- A session of fabricsh 0.1.0, saved as a deck: it does again what was typed.
local fabric = require "fabric"; fabric.globals()
local function _show(...) if select("#", ...) > 0 then print(...) end end

_show(1 + 1)
x = { 1, 2, 3 }
_show(#x, 'three')
for i = 1, 2 do
  print(i)
end
_show(1 +
2)
_show(x[3])
-- y = = 2
--   failed: prompt:1: unexpected symbol near '='
do
local z = 1
end
for i = 1, 2 do
  print(i)
end
sheet = mesh.rectangle{ width=25.4*mm, height=76.2*mm, nx=1, ny=3 }
m = model{ mesh=sheet, card=card 'blend', warp=90 }
_show(m:fix("top", "z rotation"):fix("bottom", "x y z"):move("top", { y=ramp(10*mm, 1) }))
_show(sheet)
_show(card 'denim')
a = static{ model=m, duration=1, step=0.1 }
_show(a)
_show(a:advance(0.5).time)
_show(a:field 'S11')
_show(help "shear")
-- mesh.rectangel
--   failed: prompt:1: fabric.mesh: unknown field 'rectangel', did you mean 'rectangle'?
-- m:fix('botom', 'x')
--   failed: prompt:1: fix: the model is in use by an analysis and can't be changed any more
loose = model{ mesh=sheet, card=card 'blend' }
_show(loose:fix("bottom", "x y z"):force("top", { z=ramp(1e9, 1) }))
blown = static{ model=loose, duration=1, max_cuts=2, max_iterations=5 }
-- blown:solve()
--   failed: prompt:1: solve: static: no step beyond time 0 s: the tangent is singular (a part can move freely, or has buckled) in a step of 0.0125 s (the largest is 0.05 s; 3 tries).
_show(why())
_show(who())
long = dynamic{ model=model{ mesh=sheet, card=card 'blend' }, duration=1e6 }
_show(long:every("step", function(run) if not busy then busy = true print "busy" end end))
-- long:solve()
--   failed: prompt:1: solve: interrupted at 0.006434460094874588 s; the run is alive, solve() goes on
t = long.time
_show(t > 0 and t < 1e6)
_show(long:every("step", function(run) if run.time > t then run:stop "enough" end end))
_show(long:solve().stopped)
_show(long.time > t)
-- io.write 'round\n' while true do end
--   failed: interrupted
_show('alive')
_show(a:solve().time)
_show(transcript())
