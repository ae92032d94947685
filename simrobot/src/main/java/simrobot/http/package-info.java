/**
 * A web server: a page with the map and the cameras, status as JSON, camera pictures and streams; orders of programs with a
 * key. Read first {@link simrobot.http.WebServer}. A thread pool answers requests from snapshots of the simulation, taken at most 20 times a second
 * for all clients together.
 *
 * <pre>
 *   WebServer - Router - Page, StatusJson
 *                      - CameraStreams - CameraStream
 *                      - OrderPages - OperatorRequests
 * </pre>
 *
 * Arrows: http -&gt; camera, drawing -&gt; simulation.
 */
package simrobot.http;
