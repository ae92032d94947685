/**
 * Worlds: their contents ({@link simrobot.world.World}, read it first), the readers and the writer of world files
 * ({@link simrobot.world.WorldReader}, {@link simrobot.world.MapWriter}), and the grid that computes distances and
 * contacts ({@link simrobot.world.ObstacleGrid}). Metres and radians, headings anticlockwise from +X; only readers and
 * writer use the files' millimetres and degrees. Needs nothing but java.base.
 */
package simrobot.world;
