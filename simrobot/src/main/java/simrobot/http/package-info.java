/**
 * The robots for a browser or any other program that reads the web, and only reads: a page with the map and the cameras,
 * status as JSON, pictures and streams. Read first {@link simrobot.http.WebServer}. Requests are answered on a pool of
 * threads from snapshots; only a new snapshot is asked of the simulation, at most twenty times a second for all together.
 *
 * <pre>
 *   WebServer - Router - Page, StatusJson, CameraRoom
 *                      - Streams - Stream
 * </pre>
 *
 * Arrows: http -&gt; camera -&gt; simulation.
 */
package simrobot.http;
