/**
 * What a robot's camera sees: walls, furniture and the other robots from 35 cm above the floor. Read first
 * {@link simrobot.camera.Camera}. A picture is drawn from an immutable snapshot, on whatever thread wants it: first sky and
 * floor, then the nearest wall of every column, then all lower things with a depth for each pixel.
 *
 * <pre>
 *   Camera - Backdrop, Walls, Bodies - Eye, Canvas, Light
 * </pre>
 *
 * Arrows: camera -&gt; simulation -&gt; robot -&gt; world. It uses {@code java.awt.image} and ImageIO, but no window.
 */
package simrobot.camera;
