/**
 * The world and its robots as a picture, on any {@link simgsm.draw.Canvas}: the window, exported files and the web
 * page's map share the painters. Read first {@link simrobot.drawing.WorldPainter}. World coordinates are metres and
 * radians, y up; {@link simrobot.drawing.Viewport} converts them to pixels, y down.
 */
package simrobot.drawing;
