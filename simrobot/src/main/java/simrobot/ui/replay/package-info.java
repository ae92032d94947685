/** The timeline of a recording. Read first {@link simrobot.ui.replay.TimelinePanel}. */
package simrobot.ui.replay;
