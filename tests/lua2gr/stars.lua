-- Flat stars of any number of points, as vertices and one face.
local stars = {}

-- To a thousandth: sines may differ in their last digit from one machine to the next.
function stars.rounded(x)
    return math.floor(1000 * x + 0.5) / 1000
end

function stars.outline(points)
    local vertices, face = {}, {}
    for i = 0, 2 * points - 1 do
        local angle = math.pi * i / points
        local radius = i % 2 == 0 and 1 or 0.45
        table.insert(vertices, {stars.rounded(radius * math.sin(angle)), stars.rounded(radius * math.cos(angle)), 0})
        table.insert(face, i)
    end
    return vertices, {face}
end

return stars
