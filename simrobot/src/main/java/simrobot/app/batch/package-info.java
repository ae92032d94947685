/** Ways to run without a window and a centre: runs, replays and the check of a modem. Read {@link simrobot.app.batch.BatchRun}. */
package simrobot.app.batch;
