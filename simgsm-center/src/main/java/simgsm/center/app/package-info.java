/**
 * The running centre: settings, data directory, console commands, window. Read {@link simgsm.center.app.Center}.
 */
package simgsm.center.app;
