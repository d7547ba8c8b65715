return [[
Runs a scene of the ray tracer of the University of Waterloo's course CS488/688 with lua5.4 and writes what it renders
as a scene script, scene.gr in the current folder unless told otherwise.

    --force         replaces a script that is there already
    --order first   of a node's transforms the one that the scene calls first acts first, as in the course since 2015;
                    so it is unless told otherwise
    --order last    the one that it calls last acts first, as in the course before that

The scene is a program, and is run with all rights that you have: run only what you trust. It is run in its own folder,
where require(), dofile() and io.open() find what it reads. What it prints is seen.

It may use, with points and colours as {x, y, z} and {r, g, b}:

]]
