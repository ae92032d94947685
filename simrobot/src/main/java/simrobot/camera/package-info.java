/**
 * The robot's camera: renders walls, furniture and the other robots from 35 cm above the floor. Read first {@link
 * simrobot.camera.Camera}. An image is drawn from an immutable snapshot, on any thread: first sky and floor, then the
 * nearest wall of every column, then all lower objects with a depth test for each pixel.
 *
 * <pre>
 *   Camera - BackgroundPainter, WallPainter, ObjectPainter - PinholeView, PixelBuffer, Shading
 * </pre>
 *
 * Arrows: camera -&gt; simulation -&gt; robot -&gt; world. It uses {@code java.awt.image} and ImageIO, but no window.
 */
package simrobot.camera;
