-- Wrong calls and their messages: the drape tester. Read by tests/lua/errors.lua.
wrong("fabric.lab.cusick", "fabric.lab.cusick{ wrong=1 }",
  "deck.lua:1: cusick: unknown field 'wrong' (known: card disc support seeds seed orientation cells around offset edge held side friction contact self "
    .. "by steps lowering damping still window duration processes every out file)")
wrong("fabric.lab.cusick", "fabric.lab.cusick{}",
  "deck.lua:1: cusick: field 'card': expected a card, got nil (missing, or a misspelt variable)")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card='blend' }",
  "deck.lua:1: cusick: field 'card': expected a card, got 'blend'")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, disc='1' }",
  "deck.lua:1: cusick: field 'disc': expected a positive number in m, got '1'")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, disc=-1 }",
  "deck.lua:1: cusick: field 'disc': expected a positive number in m, got -1")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, disc=300 }",
  "deck.lua:1: cusick: field 'disc': expected a diameter in m, 5 m at most (write 300*mm), got 300 m")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, disc=0.18 }",
  "deck.lua:1: cusick: field 'support': expected a diameter below that of the disc, 0.18 m, got 0.18 m")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, disc=0.254, support=0.3 }",
  "deck.lua:1: cusick: field 'support': expected a diameter below that of the disc, 0.254 m, got 0.3 m")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, edge=0.05 }",
  "deck.lua:1: cusick: field 'edge': expected at most a quarter of the support, 0.045 m, got 0.05 m")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, held=0.19 }",
  "deck.lua:1: cusick: field 'held': expected at most the diameter of the support, 0.18 m, got 0.19 m")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, duration=1 }",
  "deck.lua:1: cusick: field 'duration': expected more than the lowering, 1.5 s, got 1 s")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, by='rest' }", "deck.lua:1: cusick: field 'by': expected 'motion' or 'relaxation', got 'rest'")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, seeds=0 }",
  "deck.lua:1: cusick: field 'seeds': expected an integer from 1 to 1000, got 0")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, seeds=1.5 }",
  "deck.lua:1: cusick: field 'seeds': expected an integer from 1 to 1000, got 1.5")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, contact='yes' }",
  "deck.lua:1: cusick: field 'contact': expected true or false, got 'yes'")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, file=7 }",
  "deck.lua:1: cusick: field 'file': expected a string, got 7")
wrong("fabric.lab.cusick", "fabric.lab.cusick{ card=card, file='out/broad.png' }",
  "deck.lua:1: cusick: field 'file': expected a name that ends in .svg, got 'out/broad.png'")
