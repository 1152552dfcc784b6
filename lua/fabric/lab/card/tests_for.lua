-- The tests that would determine what a card assumes, by its fields, with the files of a folder of measurements (fabric.lab.folder) that hold them.
return {
  ["warp.loading"] = "pulls along the warp (warp-1.csv, ...)", ["weft.loading"] = "pulls along the weft (weft-1.csv, ...)",
  ["warp.unloading"] = "a pull along the warp that comes back before it breaks", ["weft.unloading"] = "a pull along the weft that comes back before it breaks",
  ["warp.poisson"] = "markers on a pull along the warp, four pins will do (warp-1-markers.csv)",
  ["weft.poisson"] = "markers on a pull along the weft, four pins will do (weft-1-markers.csv)",
  ["shear.loading"] = "a bias pull, with markers or without (bias-1-frames.csv and bias-1-markers.csv, or bias-1.csv)",
  ["shear.unloading"] = "a bias pull with markers that comes back",
  bending = "cantilevers of five strips each along warp, weft and at 45 degrees (cantilevers={ warp={...}, weft={...}, bias={...} }, bending lengths in m)",
  ["bending.twist"] = "cantilevers of strips at 45 degrees (cantilevers={ bias={...} } in laboratory.lua)",
}
