/**
 * Command line and console of all programs: options, exit statuses, log settings, and the headless console, which reads
 * commands from standard input and prints events to standard output, a line each.
 *
 * <p>Read first: {@link simgsm.console.Program}, then {@link simgsm.console.Options}, {@link simgsm.console.Console}
 * and {@link simgsm.console.CommandTable}.
 */
package simgsm.console;
