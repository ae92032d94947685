/**
 * The timeline of a recording that is played. Read {@link simrobot.ui.replay.TimelinePanel}.
 */
package simrobot.ui.replay;
