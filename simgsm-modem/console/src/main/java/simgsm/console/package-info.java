/**
 * What the programs share towards the person or the test that starts them: command-line options, exit statuses, and the
 * headless console that reads commands from standard input and prints events to standard output, a line each.
 *
 * <p>Read first: {@link simgsm.console.Program}, then {@link simgsm.console.Options} and {@link simgsm.console.Console}.
 */
package simgsm.console;
