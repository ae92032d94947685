/**
 * Worlds from pictures of a floor: {@link simrobot.bitmap.BitmapWorld} reads a ROS {@code map.yaml} or a PNG and traces
 * the dark areas to walls. It decodes PNG and PGM without a desktop.
 */
package simrobot.bitmap;
