/**
 * The floor as a component: view, mouse, placing of robots, export of pictures. Read first {@link
 * simrobot.ui.floor.WorldView}.
 */
package simrobot.ui.floor;
