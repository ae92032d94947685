/**
 * Worlds: what the files describe ({@link simrobot.world.World}), how they are read
 * ({@link simrobot.world.WorldReader}), and the grid that answers "how far" and "how near"
 * ({@link simrobot.world.ObstacleGrid}). Read {@code World} first. Metres and radians, headings
 * anticlockwise from +X; the files' millimetres and degrees end at the readers. Needs nothing but the JDK's base.
 */
package simrobot.world;
