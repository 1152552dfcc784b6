-- Swaps deck/swap and out/swap for links to the secret folder and back until it is stopped. Runs without --safe.
local root = arg[1]
while true do
  for _, place in ipairs { "/deck/", "/out/" } do
    local folder, link, away = root .. place .. "swap", root .. place .. "swap-link", root .. place .. "swap-away"
    os.rename(folder, away)
    os.rename(link, folder)
    os.rename(folder, link)
    os.rename(away, folder)
  end
end
