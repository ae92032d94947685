package simrobot.editor;

/**
 * A place by which a selected item is changed: an end of a wall, a corner of an area, the heading of a home.
 *
 * @param number of the item's handles, from 0
 */
public record Handle(Item item, int number, double xMeters, double yMeters) {}
