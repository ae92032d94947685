/**
 * The world and its robots as a picture: view, painters, mouse and keyboard, export. Read {@link simrobot.ui.floor.WorldPainter}.
 */
package simrobot.ui.floor;
