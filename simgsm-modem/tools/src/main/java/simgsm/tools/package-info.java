/**
 * The command-line tools of {@code simgsm-modem.jar}: DTMF tones to and from files, speech and short-message codecs, and
 * load for a centre.
 *
 * <p>Read first: {@link simgsm.tools.Tool}.
 */
package simgsm.tools;
