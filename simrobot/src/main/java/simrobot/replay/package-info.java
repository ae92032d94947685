/**
 * Recorded sessions: {@link simrobot.replay.SessionRecorder} writes one while it happens, {@link simrobot.replay.Recording}
 * is one that was opened, {@link simrobot.replay.ReplayThread} plays it at a pace. Read
 * {@link simrobot.replay.RecordingFormat} first: the file, octet by octet.
 *
 * <p>A recording holds states and not commands: every robot's state at every step, to the last bit, the worlds, and the
 * console's events. It replays the same on any machine, whatever the physics of a later version.
 *
 * <pre>
 *   SessionRecorder -- SessionEncoder -- RecordingFormat -- Recording -- ReplayCursor -- ReplayThread
 * </pre>
 */
package simrobot.replay;
