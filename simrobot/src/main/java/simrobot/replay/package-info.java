/**
 * Sessions on disk and back: {@link simrobot.replay.Recorder} writes one while it happens, {@link
 * simrobot.replay.Recording} is one that was opened, {@link simrobot.replay.ReplayThread} plays it at a pace.
 *
 * <p>A recording holds what happened, not how to do it again: every robot's state at every step, to the last bit, the
 * worlds, and the console's events. So it replays the same on any machine and in any later version. Read
 * {@link simrobot.replay.Layout} first for what the file looks like.
 *
 * <pre>
 *   Recorder -- SessionEncoder -- Track      Layout      Track -- ReplayCursor -- Recording -- ReplayThread
 * </pre>
 */
package simrobot.replay;
