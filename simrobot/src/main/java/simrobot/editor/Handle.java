package simrobot.editor;

import simrobot.world.Position;

/**
 * A position at which an item's shape can be changed: an end of a wall, a corner of an area, the heading of a home.
 *
 * @param number among the item's handles, from 0
 */
public record Handle(Item item, int number, Position place) {}
