/**
 * The path to a goal: {@link simrobot.route.ClearanceGrid} holds each place's distance from the nearest obstacle,
 * {@link simrobot.route.RoutePlanner} finds the shortest path at a distance from them, and {@link simrobot.route.GoTo}
 * drives it.
 *
 * <p>Metres, radians anticlockwise.
 */
package simrobot.route;
