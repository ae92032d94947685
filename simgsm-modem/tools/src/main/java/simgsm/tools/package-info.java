/**
 * The command-line tools of {@code simgsm-modem.jar}: tones into a file, tones out of files, speech and short-message
 * codecs, load and spoilt frames for a centre.
 *
 * <p>Read first: {@link simgsm.tools.Tool}.
 */
package simgsm.tools;
